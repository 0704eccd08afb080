# SPDX-License-Identifier: BSD-3-Clause
"""The verb `press`: a scripted press and pull through the live loop."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import numpy as np

import palpate
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, quantity
from palpate.files.file_kind import PICTURE, RECORD, SCRIPT
from palpate.files.refusal import Refusal
from palpate.layout.gaps import Surface
from palpate.runs.pictures import plot_runs
from palpate.runs.press import (
    CLEARANCE,
    Place,
    PressScript,
    find_nearest_place,
    find_top,
    has_jaws,
    take_surface,
    write_script,
)
from palpate.runs.run import (
    read_scene,
    require_one_instrument,
    run_script,
    say_link,
    say_missed,
)
from palpate.runs.script_file import write_script_file


def add_press(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", type=Path, help="scene file, or published .palpate file")
    parser.add_argument("--depth", type=quantity("m"), default=6e-3, help="of the press (6mm)")
    parser.add_argument("--pull", type=quantity("m"), default=0.0, help="beyond the surface (0mm)")
    parser.add_argument("--speed", type=quantity("m/s"), default=0.03, help="mean (30mm/s)")
    parser.add_argument("--hold", type=quantity("s"), default=0.3, help="at depth (300ms)")
    parser.add_argument(
        "--at",
        type=read_point,
        metavar="X,Y,Z",
        help="press the surface point nearest to this [mm]; default: from above",
    )
    add_output(parser, "--record", writes=RECORD, help="write the run as a .prec record")
    add_output(parser, "--plot", writes=PICTURE, help="write the force plot as PNG")
    add_output(
        parser,
        "--script",
        writes=SCRIPT,
        help="write the way of the hand as a script for `palpate play`",
    )


def read_point(text: str) -> np.ndarray:
    try:
        point = np.array([float(parser) for parser in text.split(",")])
    except ValueError:
        point = np.array([])
    if point.shape != (3,) or not np.isfinite(point).all():
        raise argparse.ArgumentTypeError(f"got {text!r}, expected X,Y,Z in mm")
    return 1e-3 * point


def run_press(call: argparse.Namespace) -> Report:
    scene = read_scene(call.scene)
    require_one_instrument(call.scene, scene)
    place: Place = find_top(scene) if call.at is None else find_nearest_place(scene, call.at)
    require_reachable(call.scene, scene, place)
    script = PressScript(call.depth, call.pull, call.speed, call.hold)
    if call.script:
        write_script_file(
            call.script,
            write_script(place, scene.instruments[0].tool.radius, script, has_jaws(scene))[0],
        )
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


def require_reachable(path: Path, scene: palpate.Scene, place: Place) -> None:
    """Raises Refusal where the tip would begin inside of a body."""
    radius = scene.instruments[0].tool.radius
    begin = place.point + place.outward * (radius + CLEARANCE)
    for index in range(len(scene.bodies)):
        gap = Surface(*take_surface(scene, index)).find_near(begin, 0.0, np.zeros(3))
        if gap is not None and gap.size < 0.0:
            x, y, z = 1e3 * place.point
            raise Refusal(
                path,
                "--at",
                f"({x:.1f}, {y:.1f}, {z:.1f}) mm, where the tip would begin inside of body {index}",
                "a place that can be reached from outside",
            )


def describe_stiffness(stiffness: float | None) -> str:
    if stiffness is None:
        return "not at rest at the end of the hold (--hold): no stiffness"
    return f"{stiffness:.3g} N/m, force over depth at rest"


def describe_pull(pull: float | None, slipped: float | None) -> str:
    if pull is None:
        return "none"
    if slipped is None:
        return f"{pull:.3f} N"
    return (
        f"{pull:.3f} N: it came out of the tissue with nothing in its grip, after {slipped:.3f} N; "
        "press deeper (--depth) or elsewhere (--at)"
    )


def describe_press(report: Report) -> str:
    stiffness = report["patch_stiffness_N_per_m"]
    pull = describe_pull(report["pull_force_N"], report["slipped_at_N"])
    return "\n".join(
        [
            f"peak force   {report['peak_force_N']:.3f} N",
            f"patch        {describe_stiffness(stiffness)}",
            f"pull         {pull}",
            f"tick         {report['tick_median_us']:.0f} us median, "
            f"{report['tick_p99_us']:.0f} us p99, {report['substeps']} substeps",
            f"lateness     {report['lateness_p99_us']:.0f} us p99; "
            f"ticks {say_missed(report)}; {report['realtime']}",
            *([f"safeguards   {report['averted']}"] if "averted" in report else []),
            *say_link(report),
        ]
    )


PRESS = Verb(
    "press",
    "press and pull an organ with a scripted tip through the live 1 kHz loop",
    "palpate press spleen.scene.json --depth 6mm --pull 5mm --record press.prec",
    add_press,
    run_press,
    describe_press,
)
