# SPDX-License-Identifier: BSD-3-Clause
"""The verbs that need no authoring: doctor, press, play, replay, render, bench."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import palpate
from palpate.bench.verb import BENCH
from palpate.device import DEVICE
from palpate.doctor import DOCTOR
from palpate.file_kind import PICTURE, RECORD, SCRIPT
from palpate.mesh_file import read_mesh_file
from palpate.output import add_output
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
from palpate.script_file import write_script_file
from palpate.study.verb import STUDY
from palpate.verb import Refusal, Report, Verb, WrongCall, quantity

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
    add_output(word, "--record", writes=RECORD, help="write the run as a .prec record")
    add_output(word, "--plot", writes=PICTURE, help="write the force plot as PNG")
    add_output(
        word,
        "--script",
        writes=SCRIPT,
        help="write the way of the hand as a script for `palpate play`",
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


def describe_stiffness(stiffness: float | None) -> str:
    if stiffness is None:
        return "not at rest at the end of the hold (--hold): no stiffness"
    return f"{stiffness:.3g} N/m, force over depth at rest"


def describe_press(report: Report) -> str:
    stiffness = report["patch_stiffness_N_per_m"]
    pull = report["pull_force_N"]
    return "\n".join(
        [
            f"peak force   {report['peak_force_N']:.3f} N",
            f"patch        {describe_stiffness(stiffness)}",
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
        cut = "" if report["complete"] else "; the record ends before the run did"
        return f"{report['ticks']} ticks, the same bits{cut}"
    return (
        f"{report['ticks']} ticks, NOT equal from tick {report['first_difference']}: forces differ "
        f"by up to {report['largest_force_difference_N']:g} N, the tool by up to "
        f"{1e3 * report['largest_position_difference_m']:g} mm\n{explain_difference(report)}"
    )


ARITHMETIC = {
    "palpate": "version of palpate",
    "kernel": "kernel",
    "vector_target": "vector target",
}
"""What a record's header says of how its ticks were rounded, in words."""


def explain_difference(report: Report) -> str:
    """Why a replay may differ from its record."""
    changed = [
        f"{ARITHMETIC[name]} {found['record']!r} (here {found['here']!r})"
        for name, found in report["changed"].items()
    ]
    if not changed:
        return (
            "version, kernel and vector target are those of the record, so the program or the "
            "record has been changed"
        )
    return (
        f"the record was made with {', '.join(changed)}: another one rounds otherwise, so the same "
        "bits cannot be expected here"
    )


# ---------------------------------------------------------------- render


def add_render(word: argparse.ArgumentParser) -> None:
    word.add_argument(
        "file", type=Path, help="scene, published file, record, or OBJ of `palpate import`"
    )
    add_output(word, "--out", "-o", writes=PICTURE, required=True, help="PNG to write")
    word.add_argument(
        "--scene", type=Path, help="of a record, where its scene was moved; default: as it says"
    )
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
        moment = picture_of_record(call.out, call.file, call.time, look, scene_path=call.scene)
        return {"picture": str(call.out), "time_s": moment}
    if call.time is not None:
        raise WrongCall(f"--time: {call.file} is no record (.prec), so it has only its rest")
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
    DOCTOR,
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
