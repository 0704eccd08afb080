# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a foreign surface is used, for `palpate import`: all in one line, in this order."""

from __future__ import annotations

import argparse

from palpate.command.verb import Report
from palpate.files.refusal import Refusal

from palpate_editor.document import Organ
from palpate_editor.edits import FillHoles, KeepLargestShell
from palpate_editor.edits.keep_outer import KeepOuter, keep_outer
from palpate_editor.edits.repair import keep_largest
from palpate_editor.verbs.files import apply, describe_loops
from palpate_editor.verbs.holes import add_fill_holes, find_holes
from palpate_editor.verbs.wrapping import add_wrap, describe_wrap, report_piece, wrap


def add_cleaning(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--visible",
        action="store_true",
        help="drop the pieces that are not seen from outside, such as the parts within an atlas's "
        "organ, and list them",
    )
    parser.add_argument("--largest", action="store_true", help="keep its largest piece alone")
    add_fill_holes(parser)
    add_wrap(parser)


def clean(call: argparse.Namespace, organ: Organ) -> tuple[Organ, Report]:
    """The organ with what was asked for done, and what that was. Raises Refusal."""
    report: Report = {}
    if call.visible:
        organ, report["dropped"] = drop_inner(organ)
    if call.largest:
        assert organ.surface is not None
        if keep_largest(organ.surface) is not organ.surface:
            organ = apply(KeepLargestShell(), organ, call.file, "--largest")
    if call.fill_holes is not None:
        organ, report["filled_holes"] = fill_small(call, organ)
    if call.wrap is not None:
        organ, report["wrapped"] = wrap(organ, call.wrap, call.file)
    return organ, report


def drop_inner(organ: Organ) -> tuple[Organ, list[Report]]:
    """The organ without the pieces that lie within it, and what these were."""
    assert organ.surface is not None
    dropped = keep_outer(organ.surface).dropped
    rows = [{**report_piece(piece), "seen_share": piece.exposed} for piece in dropped]
    return KeepOuter()(organ) if dropped else organ, rows


def fill_small(call: argparse.Namespace, organ: Organ) -> tuple[Organ, list[int]]:
    """The organ without those holes, and how many edges each had; a closed one as it is."""
    if call.fill_holes < 3:
        raise Refusal(call.file, "--fill-holes", f"{call.fill_holes} edges", "3 or more")
    holes = find_holes(call, organ)
    if not holes:
        return organ, []
    # decimation remeshes the patches, and reaches better triangles from flat ones
    fill = FillHoles(tuple(holes), even=True, bent=getattr(call, "vertices", None) is None)
    filled = apply(fill, organ, call.file, "--fill-holes")
    return filled, list(holes.values())


def describe_cleaning(report: Report) -> list[str]:
    """Which holes were filled, and what a wrap has cost; what was dropped stands in the notes."""
    lines = []
    if "filled_holes" in report:
        lines.append(f"filled: {describe_loops(report['filled_holes'])}")
    if "wrapped" in report:
        lines.append(describe_wrap(report["wrapped"]))
    return lines
