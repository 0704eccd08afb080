# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a foreign surface is used, for `palpate import`: all in one line, in this order."""

from __future__ import annotations

import argparse

import palpate
from palpate.command.verb import Report
from palpate.files.refusal import Refusal

from palpate_editor.document import Organ
from palpate_editor.edits import FillHoles, KeepLargestShell
from palpate_editor.edits.repair import keep_largest
from palpate_editor.verbs.files import apply, describe_loops

EVERY_HOLE = 2**31 - 1
"""[edges] More than any hole has."""


def add_cleaning(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--largest", action="store_true", help="keep its largest piece alone")
    parser.add_argument(
        "--fill-holes",
        type=int,
        nargs="?",
        const=EVERY_HOLE,
        metavar="EDGES",
        help="close every hole, or those of at most so many edges",
    )


def clean(call: argparse.Namespace, organ: Organ) -> tuple[Organ, Report]:
    """The organ with what was asked for done, and what that was. Raises Refusal."""
    report: Report = {}
    if call.largest:
        assert organ.surface is not None
        if keep_largest(organ.surface) is not organ.surface:
            organ = apply(KeepLargestShell(), organ, call.file, "--largest")
    if call.fill_holes is not None:
        organ, report["filled_holes"] = fill_small(call, organ)
    return organ, report


def fill_small(call: argparse.Namespace, organ: Organ) -> tuple[Organ, list[int]]:
    """The organ without those holes, and how many edges each had; a closed one as it is."""
    assert organ.surface is not None
    if call.fill_holes < 3:
        raise Refusal(call.file, "--fill-holes", f"{call.fill_holes} edges", "3 or more")
    sizes = [len(loop) for loop in palpate.find_border_loops(organ.surface.triangles)]
    holes = tuple(i for i, size in enumerate(sizes) if size <= call.fill_holes)
    if sizes and not holes:
        found = f"{describe_loops(sizes)}, none of at most {call.fill_holes} edges"
        raise Refusal(call.file, "--fill-holes", found, "holes to fill")
    if not holes:
        return organ, []
    filled = apply(FillHoles(holes), organ, call.file, "--fill-holes")
    return filled, [sizes[i] for i in holes]


def describe_cleaning(report: Report) -> list[str]:
    """Which holes were filled."""
    if "filled_holes" not in report:
        return []
    return [f"filled: {describe_loops(report['filled_holes'])}"]
