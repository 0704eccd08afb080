# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that fills an organ with tetrahedra and says how good they are, and where not: fill."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
import palpate
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall
from palpate.files.file_kind import ORGAN
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import FILLED

from palpate_editor.argument_text import NONE
from palpate_editor.check import assess, describe_problem, split_refusal
from palpate_editor.document import Organ
from palpate_editor.document.files import write_organ
from palpate_editor.edits import CapHoles, Edit, SetChoice, SetConstant, SetFineRegion
from palpate_editor.filling_quality import measure_filling
from palpate_editor.verbs.check import describe_problems
from palpate_editor.verbs.files import ReadFile, apply, describe_loops, open_any

OWN = ("flat_tetrahedra", "filling", "own_filling", "fine_region")
"""Problems that are of the filling."""


def add_fill(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate, or OBJ of `palpate import`")
    parser.add_argument("--tetrahedra", type=int, metavar="COUNT", help="about so many, to a tenth")
    parser.add_argument("--fine", metavar="REGION", help=f"where it is filled finer ('{NONE}')")
    parser.add_argument(
        "--fine-ratio", type=float, metavar="RATIO", help="of the cells there to those far away"
    )
    parser.add_argument(
        "--close",
        action="store_true",
        help="close what is open first; each cap stays known as a region: cap, cap 2 ...",
    )
    add_output(
        parser,
        "--out",
        "-o",
        writes=ORGAN,
        help=".organ to write, a solid from now on; without one, the filling is only measured",
    )


def list_edits(call: argparse.Namespace, organ: Organ) -> list[tuple[str, Edit]]:
    """What the call asks for, by its options."""
    edits: list[tuple[str, Edit]] = []
    if call.close:
        edits.append(("--close", CapHoles(even=True, bent=True)))
    if organ.model.kind not in FILLED:
        edits.append(("FILE", SetChoice("kind", "solid")))
    if call.tetrahedra is not None:
        edits.append(("--tetrahedra", SetConstant("fill", "tetrahedra", call.tetrahedra)))
    if call.fine is not None:
        edits.append(("--fine", SetFineRegion("" if call.fine == NONE else call.fine)))
    if call.fine_ratio is not None:
        edits.append(("--fine-ratio", SetConstant("fill", "fine_ratio", call.fine_ratio)))
    return edits


def run_fill(call: argparse.Namespace) -> Report:
    read, organ = ReadFile.of(call.file), open_any(call.file)
    if organ.surface is None:
        raise Refusal(call.file, "", "no surface", "an organ that has one")
    sizes = [len(loop) for loop in palpate.find_border_loops(organ.surface.triangles)]
    if sizes and not call.close:
        expected = "a closed one: --close closes it, and keeps each cap as a region"
        raise Refusal(call.file, "surface", f"an open one, {describe_loops(sizes)}", expected)
    if call.fine_ratio is not None and not organ.fill.fine_region and call.fine in (None, NONE):
        raise WrongCall("--fine-ratio has no effect without --fine REGION")
    for option, edit in list_edits(call, organ):
        organ = apply(edit, organ, call.file, option)
    try:
        quality = measure_filling(organ)
    except ValueError as refused:
        where, found, expected = split_refusal(str(refused))
        raise Refusal(call.file, where, found, expected) from None
    assessed = assess(organ)
    facts = assessed.facts.surface
    # what is filled hollow though it faces outwards
    shown = {*OWN, "inner"} if facts is not None and facts.doubled_shells else {*OWN}
    problems = [p for p in assessed.problems if p.key in shown]
    if call.out is not None:
        read.check(call.out)
        write_organ(call.out, organ)
    return {
        "file": str(call.file),
        "kind": organ.model.kind,
        **quality.as_dict(),
        "problems": [describe_problem(p, organ.surface) for p in problems],
        "out": None if call.out is None else str(call.out),
    }


def describe_fill(report: Report) -> str:
    least, median, most = report["edges_mm"]
    lines = [
        f"{report['tetrahedra']} tetrahedra of {report['asked']} asked for, {report['vertices']} "
        f"vertices, {report['volume_share']:.1%} of the volume; their outside within "
        f"{report['outside_distance_mm']:.2f} mm of the surface",
        f"edges {least:.2f} to {most:.2f} mm, {median:.2f} in the middle"
        + say_fine(report["fine_edge_mm"]),
        f"smallest angle between two faces {report['smallest_angle_deg']:.1f} degrees; "
        + say_histogram(report["angles_deg"]),
    ]
    if report["caps"]:
        lines.append(f"closed by: {', '.join(report['caps'])}")
    lines.append("the flattest:")
    for place in report["places"]:
        x, y, z = (f"{1e3 * c:.1f}" for c in place["point_m"])
        lines.append(
            f"  at ({x}, {y}, {z}) mm  {place['angle_deg']:.1f} degrees, edges of "
            f"{place['edge_mm']:.2f} mm"
        )
    if report["problems"]:
        lines += describe_problems(report["problems"])
    if report["out"]:
        lines.append(f"wrote {report['out']}")
    return "\n".join(lines)


def say_fine(edge: float | None) -> str:
    return "" if edge is None else f", {edge:.2f} at the finer region"


def say_histogram(angles: Report) -> str:
    """How many of the flattest there are."""
    below = np.cumsum(angles["counts"])[:3]
    rows = zip(below, angles["limits"][1:4], strict=True)
    return ", ".join(f"{count} under {limit:g}" for count, limit in rows)


VERBS = [
    Verb(
        "fill",
        "fill an organ with tetrahedra, and say how good they are and where not",
        "palpate fill liver.organ --tetrahedra 4000 --fine 'left lobe' -o liver.organ",
        add_fill,
        run_fill,
        describe_fill,
    ),
]
