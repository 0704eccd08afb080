# SPDX-License-Identifier: GPL-3.0-or-later
"""How a foreign mesh file is to be understood: options that several verbs have."""

from __future__ import annotations

import argparse

from palpate_editor.verbs.parts import add_assembling

UNITS = ("m", "cm", "mm", "um", "in", "ft")
UPS = ("x", "y", "z", "-x", "-y", "-z")


def add_source(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--part",
        action="append",
        default=[],
        metavar="NAME",
        help="part of the file to use, or a group of parts, may be repeated; default: all",
    )
    parser.add_argument("--unit", choices=UNITS, help="of the file; default: stated or guessed")
    parser.add_argument("--up", choices=UPS, help="axis of the file; default: stated or z")
    add_assembling(parser)
