# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `check`: what is wrong or doubtful about an organ, and what a press of it comes to."""

from __future__ import annotations

import argparse
from pathlib import Path

from palpate.command.verb import Report, Verb, quantity
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import VALIDATED_PART, VALIDATED_RADII, VALIDATED_TIPS

from palpate_editor.check_file import check_file

BOUNDS = {
    "thickness": f"{VALIDATED_PART:g} of the thickness",
    "radius": f"{VALIDATED_RADII:g} radii of the tip",
    "wall": "the thickness of its wall",
    "tip": "",
}
"""What a validated depth comes from."""


def add_check(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate or .scene.json")
    parser.add_argument(
        "--depth",
        type=quantity("m"),
        metavar="M",
        help="of a press that is meant: warn where it is deeper than what is validated",
    )
    parser.add_argument(
        "--script", type=Path, metavar="FILE.json", help="the same for a way of the hand"
    )


def run_check(call: argparse.Namespace) -> Report:
    if call.depth is not None and not call.depth > 0.0:
        raise Refusal(None, "--depth", f"{1e3 * call.depth:g} mm", "more than 0 mm")
    return check_file(call.file, call.depth, call.script)


def describe_problems(problems: list[Report]) -> list[str]:
    lines = [
        f"  {p['severity']:7} {p['where']}: got {p['got']}, expected {p['expected']}"
        + say_place(p)
        + hint(p)
        for p in problems
    ]
    return lines or ["  no problems"]


def say_place(problem: Report) -> str:
    """Where on the surface it is, and how much of it."""
    if problem["place_m"] is None:
        return ""
    x, y, z = (f"{1e3 * c:.1f}" for c in problem["place_m"])
    return f" [{problem['triangles']} triangles, one at ({x}, {y}, {z}) mm]"


def hint(problem: Report) -> str:
    """Which call repairs it."""
    if problem["problem"] in ("no_title", "no_task"):
        return f" (palpate publish --{problem['where']})"
    return f" (palpate repair --problem {problem['problem']})" if problem["fix"] else ""


def describe_check(report: Report) -> str:
    heading = f"{report['file']}: {report['description']}"
    lines = [heading, *describe_press(report), *describe_problems(report["problems"])]
    return "\n".join(lines)


def describe_press(report: Report) -> list[str]:
    """What a press of it comes to."""
    lines: list[str] = []
    shares = [p["home_share"] for p in report["places"] if p["home_share"] is not None]
    if report["tick_share_in_touch"] is not None:
        lines.append(
            f"  in touch: {report['substeps_in_touch']} substeps, about "
            f"{report['tick_share_in_touch']:.0%} of a tick on the reference machine"
        )
    if shares:
        lines.append(
            f"  home springs: {say_span(shares)} of the felt force at {len(shares)} "
            f"{'places' if len(shares) > 1 else 'place'} pressed "
            f"{1e3 * report['press_depth_m']:g} mm"
        )
    return [*lines, *describe_places(report)]


def describe_places(report: Report) -> list[str]:
    """To which depth each place is validated, and under a law of contact that another could
    replace, what is felt there by both."""
    places = report["places"]
    lines = []
    if places and places[0]["validated_by"] == "tip":
        least, most = (f"{1e3 * radius:g}" for radius in VALIDATED_TIPS)
        lines.append(f"  no depth is validated: only balls of {least} to {most} mm are")
    offered = any(place["hard_force_N"] is not None for place in places)
    if offered:
        lines.append(
            f"  the hard law of contact; pressed {1e3 * report['press_depth_m']:g} mm a hand feels "
            "by it, and by the near field:"
        )
    if not lines or offered:
        lines += lay_out([name_columns(offered), *(list_cells(p, offered) for p in places)])
    return lines if places else []


def name_columns(offered: bool) -> list[str]:
    forces = ["hard [mN]", "near field [mN]"] if offered else []
    return ["place [mm]", "thickness [mm]", *forces, "validated to [mm]"]


def list_cells(place: Report, offered: bool) -> list[str]:
    """Of one row, as text."""
    forces = [place["hard_force_N"], place["near_field_force_N"]] if offered else []
    depth = f"{1e3 * place['validated_depth_m']:.1f}  {BOUNDS[place['validated_by']]}"
    return [
        ", ".join(str(round(1e3 * c)) for c in place["point_m"]),
        say_or_dash(place["thickness_m"], ".1f"),
        *(say_or_dash(force, ".0f") for force in forces),
        depth if place["validated_depth_m"] else "-",
    ]


def say_or_dash(value: float | None, form: str) -> str:
    """In thousandths."""
    return "-" if value is None else format(1e3 * value, form)


def lay_out(rows: list[list[str]]) -> list[str]:
    """Columns under each other, the last as long as it is."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)][:-1]
    return [
        "  " + "  ".join([*(f"{c:{w}}" for c, w in zip(row, widths, strict=False)), row[-1]])
        for row in rows
    ]


def say_span(shares: list[float]) -> str:
    """52% to 99%; one number where both are the same."""
    least, most = (f"{round(100.0 * share) + 0:d}%" for share in (min(shares), max(shares)))
    return least if least == most else f"{least} to {most}"


def has_errors(report: Report) -> bool:
    return any(p["severity"] == "error" for p in report["problems"])


VERBS = [
    Verb(
        "check",
        "list every problem of an organ",
        "palpate check spleen.organ",
        add_check,
        run_check,
        describe_check,
        failed=has_errors,
    ),
]
