# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `truth`: what linear tissue gives to a ball on an organ, by finite elements."""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

from palpate.cli.press import read_point
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, quantity
from palpate.files.file_kind import TRUTH
from palpate.files.refusal import Refusal
from palpate.runs.script_file import read_script_file
from palpate.study.truth import Truth
from palpate.study.truth_file import write_truth

from palpate_editor.truth import (
    Drag,
    Press,
    Progress,
    Pull,
    Script,
    TruthError,
    solve_truth,
)
from palpate_editor.truth.wanted import Path as Way
from palpate_editor.verbs.files import open_any

PATHS = {"press": Press, "pull": Pull, "drag": Drag}
OFTEN, RARELY = 2.0, 20.0
"""[s] between two lines of progress, on a terminal and elsewhere."""


def add_truth(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate or .scene.json")
    parser.add_argument(
        "--place",
        type=read_point,
        metavar="X,Y,Z",
        help="begin at the surface point nearest to this [mm]; default: where a check presses "
        "first",
    )
    parser.add_argument(
        "--path",
        default="press",
        metavar="PATH",
        help="press; pull, by the hold of the organ's hand; drag, along the surface; or a script "
        "of the hand, FILE.json, as `palpate press --script` writes one (press)",
    )
    parser.add_argument(
        "--depth",
        type=quantity("m"),
        action="append",
        metavar="M",
        help="of the ball beyond its first touch, of a pull how high over it; may be repeated; "
        "default: four, the most the smaller of 10%% of the thickness and 1.5 radii",
    )
    parser.add_argument(
        "--radius", type=quantity("m"), metavar="M", help="of the ball (the tool's)"
    )
    add_output(parser, "--output", writes=TRUTH, metavar="FILE.truth", help="write what was found")


def run_truth(call: argparse.Namespace) -> Report:
    organ, path = open_any(call.file), choose_path(call)
    start = time.monotonic()
    try:
        truth = solve_truth(organ, path, radius=call.radius, depths=call.depth, progress=Teller())
    except TruthError as refused:
        raise TruthRefusal(call.file, str(refused)) from None
    if call.output:
        write_truth(call.output, truth)
    return {
        "file": str(call.file),
        "output": None if call.output is None else str(call.output),
        "seconds": round(time.monotonic() - start, 1),
        **report_truth(truth),
    }


def choose_path(call: argparse.Namespace) -> Way:
    """Raises Refusal, or FileError for a script that cannot be read."""
    near = None if call.place is None else tuple(map(float, call.place))
    if call.path in PATHS:
        return PATHS[call.path](near)
    if not call.path.endswith(".json"):
        raise Refusal(None, "--path", repr(call.path), f"{', '.join(PATHS)}, or FILE.json")
    if near is not None:
        raise Refusal(None, "--place", "a place beside a script", "none: a script has its own")
    return Script(read_script_file(Path(call.path)))


class TruthRefusal(Refusal):
    """A truth that cannot be solved, in the solver's own words."""

    def __init__(self, file: Path, sentence: str):
        super().__init__(file, "truth", sentence, "a body that can be solved")
        self.args = (f"{file}: {sentence}",)


class Teller:
    """Says on standard error how far the work is; into a file or a pipe less often."""

    def __init__(self) -> None:
        self.said = time.monotonic()

    def __call__(self, progress: Progress) -> None:
        now = time.monotonic()
        if now < self.said + (OFTEN if sys.stderr.isatty() else RARELY):
            return
        self.said = now
        left = "" if progress.left is None else f", at most {progress.left:.0f} s left"
        text = f"mesh {progress.level + 1}, {progress.stage}: {progress.fraction:.0%}{left}"
        print(text, file=sys.stderr, flush=True)


def report_truth(truth: Truth) -> Report:
    return {
        "key": truth.key,
        "path": truth.path,
        "law": truth.law,
        "radius_m": truth.radius,
        "freedoms": truth.freedoms,
        "tetrahedra": truth.tetrahedra,
        "remarks": list(truth.remarks),
        "stations": [
            {
                "point_m": truth.point[s].tolist(),
                "direction": truth.direction[s].tolist(),
                "thickness_m": float(truth.thickness[s]),
                "results": [
                    {
                        "depth_m": float(truth.depth[k]),
                        "force_N": float(truth.force[s, k]),
                        "force_error": float(truth.force_error[s, k]),
                        "contact_radius_m": float(truth.contact_radius[s, k]),
                        "displacement_error": float(truth.displacement_error[s, k]),
                    }
                    for k in range(len(truth.depth))
                ],
            }
            for s in range(len(truth.point))
        ],
    }


def describe_truth(report: Report) -> str:
    lines = [
        f"{report['file']}: {report['path']} of a ball of {1e3 * report['radius_m']:g} mm, linear, "
        f"{report['freedoms']} freedoms, {report['seconds']:g} s"
    ]
    for station in report["stations"]:
        at = ", ".join(f"{1e3 * value:.1f}" for value in station["point_m"])
        lines.append(f"  at {at} mm, {1e3 * station['thickness_m']:.1f} mm thick")
        for row in station["results"]:
            lines.append(
                f"    {1e3 * row['depth_m']:6.2f} mm  {1e3 * row['force_N']:8.2f} mN "
                f"+- {row['force_error']:.1%}, contact radius "
                f"{1e3 * row['contact_radius_m']:.2f} mm"
            )
    lines += [f"  {remark}" for remark in report["remarks"]]
    if report["output"]:
        lines.append(f"  wrote {report['output']}")
    return "\n".join(lines)


VERBS = [
    Verb(
        "truth",
        "solve by finite elements what a ball feels of an organ: the truth of its models",
        "palpate truth spleen.organ --radius 3mm --output spleen.truth",
        add_truth,
        run_truth,
        describe_truth,
    )
]
