# SPDX-License-Identifier: BSD-3-Clause
"""The verbs that need no authoring: doctor, press, play, replay, render, bench."""

from __future__ import annotations

import argparse
import os
import platform
import sys
import tempfile
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import numpy as np

import palpate
from palpate.bench.verb import BENCH
from palpate.device import DEVICE
from palpate.device_link import describe_low_latency
from palpate.mesh_file import read_mesh_file
from palpate.play import PLAY
from palpate.press import Place, PressScript, find_place, find_top, write_script
from palpate.run import (
    is_published,
    picture_of_record,
    picture_of_rest,
    plot_runs,
    read_scene,
    run_replay,
    run_script,
)
from palpate.scene_file import compile_scene
from palpate.scene_parts import SceneFile
from palpate.script_file import write_script_file
from palpate.study.verb import STUDY
from palpate.verb import Refusal, Report, Verb, quantity

# ---------------------------------------------------------------- doctor


def add_doctor(word: argparse.ArgumentParser) -> None:
    del word


def run_doctor(call: argparse.Namespace) -> Report:
    checks = [check_python(), check_editor(), check_graphics(), check_realtime()]
    checks += [check_serial(), check_data()]
    return {
        "palpate": version("palpate"),
        "platform": platform.platform(),
        "cores": os.cpu_count(),
        "checks": checks,
    }


def check_python() -> Report:
    ok = sys.version_info[:2] >= (3, 11)
    return {
        "name": "python",
        "ok": ok,
        "needed": True,
        "detail": f"{platform.python_version()}, 3.11 is the reference",
    }


def check_editor() -> Report:
    try:
        detail, ok = f"palpate-editor {version('palpate-editor')}", True
    except PackageNotFoundError:
        detail, ok = "palpate-editor is not installed: import, decimate and demo need it", False
    return {"name": "editor", "ok": ok, "needed": False, "detail": detail}


def check_graphics() -> Report:
    from palpate.render import describe_gl

    try:
        return {"name": "graphics", "ok": True, "needed": False, "detail": describe_gl()}
    except RuntimeError as problem:
        return {"name": "graphics", "ok": False, "needed": False, "detail": str(problem)}


def check_realtime() -> Report:
    """Runs the real loop for 0.2 s on four particles and reports what it was granted."""
    corners = np.array([[0.0, 0.0, 0.0], [0.01, 0.0, 0.0], [0.0, 0.01, 0.0], [0.0, 0.0, 0.01]])
    mesh = palpate.SurfaceMesh(
        corners, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], dtype=np.int32)
    )
    scene = compile_scene(SceneFile(organ=None), mesh)
    frame = palpate.KeyFrame()
    frame.position = [0.0, 0.0, 0.1]
    options = palpate.LoopOptions()
    options.duration = 0.2
    loop = palpate.Loop(scene, palpate.ScriptedDevice([frame]), options)
    loop.start()
    loop.wait(5.0)
    report = loop.report()
    priority = "real-time priority granted" if report.realtime else report.realtime_note
    return {
        "name": "realtime",
        "ok": report.realtime,
        "needed": False,
        "detail": f"{priority}; lateness p99 {1e6 * report.lateness.p99:.0f} us, "
        f"{report.missed_ticks} of {report.ticks} ticks missed",
    }


def check_serial() -> Report:
    good, detail = describe_low_latency()
    return {"name": "serial ports", "ok": good, "needed": False, "detail": detail}


def check_data() -> Report:
    folder = Path(os.environ.get("PALPATE_DATA", "../shared/data"))
    ok = folder.is_dir()
    return {
        "name": "shared data",
        "ok": ok,
        "needed": False,
        "detail": f"{folder} {'found' if ok else 'is not there; set PALPATE_DATA'}",
    }


def describe_doctor(report: Report) -> str:
    lines = [f"palpate {report['palpate']} on {report['platform']}, {report['cores']} cores"]
    for check in report["checks"]:
        mark = "ok" if check["ok"] else "MISSING" if check["needed"] else "no"
        lines.append(f"  {check['name']:12} {mark:8} {check['detail']}")
    return "\n".join(lines)


# ---------------------------------------------------------------- press


def add_press(word: argparse.ArgumentParser) -> None:
    word.add_argument("scene", type=Path, help="scene file, or published .palpate file")
    word.add_argument("--depth", type=quantity("m"), default=6e-3, help="of the press (6mm)")
    word.add_argument("--pull", type=quantity("m"), default=0.0, help="beyond the surface (0mm)")
    word.add_argument("--speed", type=quantity("m/s"), default=0.03, help="mean (30mm/s)")
    word.add_argument("--hold", type=quantity("s"), default=0.3, help="at depth (300ms)")
    word.add_argument(
        "--at",
        type=read_point,
        metavar="X,Y,Z",
        help="press the surface point nearest to this [mm]; default: from above",
    )
    word.add_argument("--record", type=Path, help="write the run as a .prec record")
    word.add_argument("--plot", type=Path, help="write the force plot as PNG")
    word.add_argument(
        "--script", type=Path, help="write the way of the hand as a script for `palpate play`"
    )


def read_point(text: str) -> np.ndarray:
    try:
        point = np.array([float(word) for word in text.split(",")])
    except ValueError:
        point = np.array([])
    if point.shape != (3,) or not np.isfinite(point).all():
        raise argparse.ArgumentTypeError(f"got {text!r}, expected X,Y,Z in mm")
    return 1e-3 * point


def run_press(call: argparse.Namespace) -> Report:
    scene = read_scene(call.scene)
    place: Place = find_top(scene) if call.at is None else find_place(scene, call.at)
    script = PressScript(call.depth, call.pull, call.speed, call.hold)
    if call.script:
        write_script_file(call.script, write_script(place, scene.tool.radius, script)[0])
    with tempfile.TemporaryDirectory() as folder:
        path = call.record or Path(folder) / "press.prec"
        run = run_script(scene, place, script, path, call.scene)
        if call.plot:
            plot_runs(call.plot, {call.scene.stem: run}, title=call.scene.stem)
    report = {"scene": str(call.scene), **run.report}
    report["record"] = str(call.record) if call.record else None
    report["plot"] = str(call.plot) if call.plot else None
    report["script"] = str(call.script) if call.script else None
    return report


def describe_press(report: Report) -> str:
    stiffness = report["patch_stiffness_N_per_m"]
    pull = report["pull_force_N"]
    return "\n".join(
        [
            f"peak force   {report['peak_force_N']:.3f} N",
            f"patch        {'never settled' if stiffness is None else f'{stiffness:.0f} N/m'}",
            f"pull         {'none' if pull is None else f'{pull:.3f} N'}",
            f"tick         {report['tick_median_us']:.0f} us median, "
            f"{report['tick_p99_us']:.0f} us p99, {report['substeps']} substeps",
            f"lateness     {report['lateness_p99_us']:.0f} us p99; "
            f"{report['missed_ticks']} ticks missed; {report['realtime']}",
        ]
    )


# ---------------------------------------------------------------- replay


def add_replay(word: argparse.ArgumentParser) -> None:
    word.add_argument("record", type=Path, help=".prec record")
    word.add_argument(
        "--scene", type=Path, help="scene file or published file; default: the one the record names"
    )


def run_replay_verb(call: argparse.Namespace) -> Report:
    return run_replay(call.record, call.scene)


def describe_replay(report: Report) -> str:
    if report["equal"]:
        return f"{report['ticks']} ticks, the same bits"
    return (
        f"{report['ticks']} ticks, NOT equal from tick {report['first_difference']}: forces differ "
        f"by up to {report['largest_force_difference_N']:g} N, the tool by up to "
        f"{1e3 * report['largest_position_difference_m']:g} mm"
    )


# ---------------------------------------------------------------- render


def add_render(word: argparse.ArgumentParser) -> None:
    word.add_argument(
        "file", type=Path, help="scene, published file, record, or OBJ of `palpate import`"
    )
    word.add_argument("--out", "-o", type=Path, required=True, help="PNG to write")
    word.add_argument("--time", type=quantity("s"), help="of a record; default: at its peak force")
    word.add_argument("--size", type=read_size, default=(1280, 720), metavar="WxH")
    word.add_argument("--theme", choices=("dark", "light"), default="dark")
    word.add_argument("--azimuth", type=float, default=-60.0, help="[degree] of the camera (-60)")
    word.add_argument("--elevation", type=float, default=25.0, help="[degree] (25)")
    word.add_argument("--no-wireframe", action="store_true")


def read_size(text: str) -> tuple[int, int]:
    width, _, height = text.partition("x")
    if not (
        width.isdigit()
        and height.isdigit()
        and 64 <= int(width) <= 8192
        and 64 <= int(height) <= 8192
    ):
        raise argparse.ArgumentTypeError(f"got {text!r}, expected WIDTHxHEIGHT, each 64 to 8192")
    return int(width), int(height)


def run_render(call: argparse.Namespace) -> Report:
    look: dict[str, Any] = {
        "size": call.size,
        "theme": call.theme,
        "azimuth": call.azimuth,
        "elevation": call.elevation,
        "wireframe": not call.no_wireframe,
    }
    if call.file.suffix == ".prec":
        moment = picture_of_record(call.out, call.file, call.time, look)
        return {"picture": str(call.out), "time_s": moment}
    if call.file.suffix == ".obj":
        mesh = read_mesh_file(call.file)
    elif is_published(call.file):
        # loads the renderer, which other verbs do without
        from palpate.authored import find_look

        made = palpate.scenario.read(call.file)
        mesh, look["look"] = made.scene.tissue, find_look(made)
    elif call.file.suffix == ".json":
        mesh = read_scene(call.file).tissue
    else:
        raise Refusal(
            call.file,
            "",
            f"a name ending in {call.file.suffix!r}",
            ".palpate (published), .json (scene), .prec (record) or .obj",
        )
    picture_of_rest(call.out, mesh, call.file.stem, look)
    return {"picture": str(call.out), "time_s": None}


def describe_render(report: Report) -> str:
    moment = report["time_s"]
    return report["picture"] + ("" if moment is None else f" (at {moment:.3f} s)")


VERBS = [
    Verb(
        "doctor",
        "say what this machine can do for palpate",
        "palpate doctor",
        add_doctor,
        run_doctor,
        describe_doctor,
        failed=lambda report: any(c["needed"] and not c["ok"] for c in report["checks"]),
    ),
    Verb(
        "press",
        "press and pull an organ with a scripted tip through the live 1 kHz loop",
        "palpate press spleen.scene.json --depth 6mm --pull 5mm --record press.prec",
        add_press,
        run_press,
        describe_press,
    ),
    PLAY,
    DEVICE,
    Verb(
        "replay",
        "run a record again and compare it bit by bit",
        "palpate replay press.prec",
        add_replay,
        run_replay_verb,
        describe_replay,
        failed=lambda report: not report["equal"],
    ),
    Verb(
        "render",
        "draw an organ, at rest or as a record left it, with no display",
        "palpate render press.prec -o press.png",
        add_render,
        run_render,
        describe_render,
    ),
    BENCH,
    STUDY,
]
