# SPDX-License-Identifier: GPL-3.0-or-later
"""--wrap, of `palpate import` and `palpate repair`, and steps that may go without their number."""

from __future__ import annotations

import argparse
from pathlib import Path

from palpate.command.verb import Report, quantity

from palpate_editor.document import Organ
from palpate_editor.edits import EditError, Wrap
from palpate_editor.edits.history import note
from palpate_editor.edits.wrap import Wrapped
from palpate_editor.verbs.files import EditRefusal

AS_USUAL = -1.0
"""A step that is asked for without its number."""


def find_number(asked: float) -> float | None:
    return None if asked == AS_USUAL else asked


def add_wrap(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--wrap",
        type=quantity("m"),
        nargs="?",
        const=AS_USUAL,
        metavar="M",
        help="the last resort: a new surface around all of it, into which a ball of this radius "
        "rolls; what lies inside goes; default: a hundredth of the diagonal",
    )


def wrap(organ: Organ, asked: float, file: Path) -> tuple[Organ, Report]:
    """The organ wrapped, and the price of it. Raises Refusal."""
    edit = Wrap(find_number(asked))
    try:
        found = edit.find(organ)
    except EditError as refused:
        raise EditRefusal(file, "--wrap", str(refused)) from None
    return note(edit, organ, edit.put(organ, found)), report_wrap(found)


def report_wrap(found: Wrapped) -> Report:
    return {
        "volume_ml": 1e6 * found.volume,
        "max_distance_mm": 1e3 * found.to_source,
        "max_seen_distance_mm": 1e3 * found.from_source,
        "dropped": [
            {
                "triangles": piece.triangles,
                "size_mm": 1e3 * piece.size,
                "place_m": list(piece.middle),
            }
            for piece in found.dropped
        ],
    }


def describe_wrap(report: Report) -> str:
    """The pieces inside stand in the notes."""
    return (
        f"wrapped: {report['volume_ml']:.4g} ml, no point further than "
        f"{report['max_distance_mm']:.3g} mm from what was read, and nothing that is seen of that "
        f"from outside further than {report['max_seen_distance_mm']:.3g} mm from the wrap; "
        f"pieces inside that were dropped: {len(report['dropped'])}"
    )
