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
        f"  {p['severity']:7} {p['where']}: got {p['got']}, expected {p['expected']}" + hint(p)
        for p in problems
    ]
    return lines or ["  no problems"]


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
    """To which depth each place is validated, and what that comes from."""
    places = report["places"]
    if not places:
        return []
    if places[0]["validated_by"] == "tip":
        least, most = (f"{1e3 * radius:g}" for radius in VALIDATED_TIPS)
        return [f"  no depth is validated: only tips of {least} to {most} mm are"]
    return lay_out(
        [["place [mm]", "thickness [mm]", "validated to [mm]"], *map(list_cells, places)]
    )


def list_cells(place: Report) -> list[str]:
    """Of one row, as text."""
    return [
        ", ".join(str(round(1e3 * c)) for c in place["point_m"]),
        "-" if place["thickness_m"] is None else f"{1e3 * place['thickness_m']:.1f}",
        f"{1e3 * place['validated_depth_m']:.1f}  {BOUNDS[place['validated_by']]}",
    ]


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
