# SPDX-License-Identifier: GPL-3.0-or-later
"""--wrap, of `palpate import` and `palpate repair`, and steps that may go without their number."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path

from palpate.command.verb import Report, quantity

from palpate_editor.document import Organ
from palpate_editor.edits import EditError, Wrap
from palpate_editor.edits.dropped import Dropped
from palpate_editor.edits.history import note
from palpate_editor.edits.wrap import Wrapped
from palpate_editor.verbs.files import EditRefusal

AS_USUAL = -1.0
"""A step that is asked for without its number."""


def find_number(asked: float) -> float | None:
    return None if asked == AS_USUAL else asked


def add_step(
    parser: argparse.ArgumentParser,
    flag: str,
    metavar: str,
    told: str,
    *,
    read: Callable[[str], float] = float,
    usual: float = AS_USUAL,
) -> None:
    """A step that may go without its number, which is `usual` then."""
    parser.add_argument(flag, type=read, nargs="?", const=usual, metavar=metavar, help=told)


def add_wrap(parser: argparse.ArgumentParser) -> None:
    told = (
        "the last resort: a new surface around all of it, into which a ball of this radius "
        "rolls; what lies inside goes; default: a hundredth of the diagonal, or more than small "
        "holes are wide"
    )
    add_step(parser, "--wrap", "M", told, read=quantity("m"))


def wrap(organ: Organ, asked: float, file: Path) -> tuple[Organ, Report]:
    """The organ wrapped, and the price of it. Raises Refusal."""
    edit = Wrap(find_number(asked), past_holes=True)
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
        "dropped": [report_piece(piece) for piece in found.dropped],
    }


def report_piece(piece: Dropped) -> Report:
    return {
        "triangles": piece.triangles,
        "size_mm": 1e3 * piece.size,
        "place_m": list(piece.middle),
    }


def describe_wrap(report: Report) -> str:
    """The pieces inside stand in the notes."""
    return (
        f"wrapped: {report['volume_ml']:.4g} ml, no point further than "
        f"{report['max_distance_mm']:.3g} mm from what was read, and nothing that is seen of that "
        f"from outside further than {report['max_seen_distance_mm']:.3g} mm from the wrap; "
        f"pieces inside that were dropped: {len(report['dropped'])}"
    )
