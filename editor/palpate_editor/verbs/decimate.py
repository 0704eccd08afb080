# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that makes a surface coarse enough for a thousand ticks a second: decimate."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall, quantity

from palpate_editor.check import describe_problem
from palpate_editor.doctor import list_decimated
from palpate_editor.document import Decimation, Organ
from palpate_editor.edits import (
    Decimate,
    EditError,
    UseImported,
    decimate_organ,
    decimate_within,
)
from palpate_editor.felt_change import FeltChange, measure_felt_change
from palpate_editor.verbs.check import describe_problems
from palpate_editor.verbs.files import (
    OUTPUTS,
    EditRefusal,
    ReadFile,
    apply,
    open_any,
    write_any,
)


def decimate_to(organ: Organ, vertices: int, file: Path) -> tuple[Organ, Report]:
    """With what a designer wants kept: ridges, thin parts, borders of what is painted."""
    return run_edit(lambda: decimate_organ(organ, vertices, True), organ, file, "--vertices")


def run_edit(
    make: Callable[[], Decimate], organ: Organ, file: Path, option: str
) -> tuple[Organ, Report]:
    try:
        edit = make()
    except EditError as refused:
        raise EditRefusal(file, option, str(refused)) from None
    made = edit(organ)
    kept = {
        "kept_lines_mm": 1e3 * edit.kept_length,
        "lines_left_out_mm": 1e3 * edit.left_out_length,
    }
    found = [describe_problem(p, made.surface) for p in list_decimated(made)]
    far = say_far_field(made, organ)
    return made, {**report_decimation(edit.decimation), **kept, "far_field": far, "problems": found}


def say_far_field(organ: Organ, before: Organ) -> str | None:
    """None where there was none."""
    if before.far_field is None:
        return None
    if organ.far_field is None:
        return "that of its own mesh (palpate material --far-field fine solves it)"
    return "carried over from the finer surface"


def report_decimation(decimation: Decimation) -> Report:
    report = asdict(decimation)
    for name in ("mean_distance", "max_distance"):
        report[f"{name}_mm"] = 1e3 * report.pop(name)
    return report


def add_decimate(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, or OBJ written by `palpate import`")
    target = parser.add_mutually_exclusive_group(required=True)
    target.add_argument("--vertices", type=int, help="exactly this many")
    target.add_argument(
        "--error",
        type=quantity("m"),
        metavar="M",
        help="as few as keep every point of both surfaces within this of the other: 0.5mm",
    )
    target.add_argument(
        "--imported", action="store_true", help="use the imported surface of an .organ as it is"
    )
    parser.add_argument(
        "--no-felt",
        action="store_true",
        help="do not press it before and after to compare what is felt, which takes some seconds",
    )
    add_output(parser, "--out", "-o", writes=OUTPUTS, required=True, help=".organ or mesh file")


def run_decimate(call: argparse.Namespace) -> Report:
    read = ReadFile.of(call.file)
    if call.imported and call.no_felt:
        raise WrongCall("--no-felt has no effect beside --imported, which presses nothing")
    if call.imported:
        organ = apply(UseImported(), open_any(call.file), call.file, "--imported")
        read.check(call.out)
        write_any(call.out, organ)
        return {"out": str(call.out), "vertices": organ.vertex_count}
    before = open_any(call.file)
    if call.error is not None:
        organ, report = run_edit(
            lambda: decimate_within(before, call.error, True), before, call.file, "--error"
        )
    else:
        organ, report = decimate_to(before, call.vertices, call.file)
    felt = None if call.no_felt else report_felt(measure_felt_change(before, organ))
    read.check(call.out)
    write_any(call.out, organ)
    return {"out": str(call.out), **report, "felt": felt}


def report_felt(felt: FeltChange) -> Report:
    return {
        "depth_m": felt.depth,
        "mean_change": felt.mean,
        "largest_change": felt.largest,
        "untold": str(felt.untold) or None,
        "places": [
            {
                "point_m": list(place.point),
                "before_N": place.before,
                "after_N": place.after,
                "change": place.change,
                "single_changes": None if place.single is None else list(place.single),
            }
            for place in felt.places
        ],
    }


def describe_felt(felt: Report) -> list[str]:
    """The same presses before and after, as rows."""
    if felt["untold"]:
        return [f"what is felt was not compared: {felt['untold']}"]

    def say(value: float | None, form: str, scale: float = 1.0) -> str:
        return "-" if value is None else format(scale * value, form)

    deep = f"{1e3 * felt['depth_m']:g} mm"
    lines = [
        f"felt {deep} deep, before and after, mean over a spot (and the change at single points "
        "of it):"
    ]
    for place in felt["places"]:
        x, y, z = (f"{1e3 * c:.0f}" for c in place["point_m"])
        before, after = (say(place[name], ".1f", 1e3) for name in ("before_N", "after_N"))
        change = say(place["change"], "+.1%")
        single = [say(each, "+.1%") for each in place["single_changes"] or ()]
        span = f"  ({' to '.join(single)})" if single else ""
        lines.append(f"  at ({x}, {y}, {z}) mm  {before} -> {after} mN  {change}{span}")
    largest = say(felt["largest_change"], "+.1%")
    return [
        *lines,
        f"  together {say(felt['mean_change'], '+.1%')}, at one place {largest} at most",
    ]


def describe_decimate(report: Report) -> str:
    if "vertices_before" not in report:
        return f"the imported surface of {report['vertices']} vertices is used as it is"
    done = (
        f"decimated {report['vertices_before']} / {report['triangles_before']} to "
        f"{report['vertices']} / {report['triangles']}; smallest angle "
        f"{report['smallest_angle_deg']:.1f} degrees; {report['mean_distance_mm']:.3f} mm from the "
        f"source on average, {report['max_distance_mm']:.3f} mm at most"
    )
    found = describe_problems(report["problems"]) if report["problems"] else []
    felt = describe_felt(report["felt"]) if report.get("felt") else []
    return "\n".join([done, *describe_kept(report), *found, *felt])


def describe_kept(report: Report) -> list[str]:
    """What beside the shape was kept, where there was something to keep."""
    kept, left = report["kept_lines_mm"], report["lines_left_out_mm"]
    lines = []
    if kept or left:
        lines.append(f"ridges and borders of what is painted: {kept:.0f} mm stay on their lines")
    if left:
        lines[-1] += f", {left:.0f} mm do not, for want of vertices or of good triangles"
    if report["far_field"] is not None:
        lines.append(f"far field: {report['far_field']}")
    return lines


VERBS = [
    Verb(
        "decimate",
        "reduce a surface to an exact vertex count with well-shaped triangles",
        "palpate decimate spleen.organ --vertices 600 -o spleen.organ",
        add_decimate,
        run_decimate,
        describe_decimate,
    ),
]
