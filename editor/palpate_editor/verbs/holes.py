# SPDX-License-Identifier: GPL-3.0-or-later
"""--fill-holes, of `palpate import` and `palpate repair`."""

from __future__ import annotations

import argparse

import palpate
from palpate.files.refusal import Refusal

from palpate_editor.document import Organ
from palpate_editor.verbs.files import describe_loops

EVERY_HOLE = 2**31 - 1
"""[edges] More than any hole has."""


def add_fill_holes(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--fill-holes",
        type=int,
        nargs="?",
        const=EVERY_HOLE,
        metavar="EDGES",
        help="close every hole, or those of at most so many edges",
    )


def find_holes(call: argparse.Namespace, organ: Organ) -> dict[int, int]:
    """Number -> edges of the holes that the call wants closed; none of a closed surface. Raises
    Refusal where there are holes, and none so small."""
    assert organ.surface is not None
    sizes = [len(loop) for loop in palpate.find_border_loops(organ.surface.triangles)]
    holes = {i: size for i, size in enumerate(sizes) if size <= call.fill_holes}
    if sizes and not holes:
        found = f"{describe_loops(sizes)}, none of at most {call.fill_holes} edges"
        raise Refusal(call.file, "--fill-holes", found, "holes to fill")
    return holes
