# SPDX-License-Identifier: BSD-3-Clause
"""`palpate scenario tool`: the instruments of a task, with trocar, friction and grip."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from palpate.assessment import author_tools
from palpate.assessment.author import Json
from palpate.command.verb import WrongCall, plain_number, quantity
from palpate.scene.instrument_kinds import KINDS

NUMBERS = (
    *("radius_m", "length_m", "friction", "jaw_opening_rad", "grip_force_N"),
    *("trocar_height_m", "trocar_side_m", "trocar_m", "force_max_N", "fulcrum_m"),
)


def add_tool(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="assessment, .json")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--set", metavar="NAME", help="a new instrument, or another one of this name")
    what.add_argument("--remove", metavar="NAME")
    parser.add_argument("--kind", choices=tuple(KINDS), help="with its usual numbers")
    for option, name, read, text in (
        ("--radius", "radius_m", quantity("m"), "of the tip and the shaft"),
        ("--length", "length_m", quantity("m"), "of what touches; 0mm: a ball"),
        ("--friction", "friction", plain_number(), "Coulomb's coefficient; 0: it slides"),
        ("--jaw-opening", "jaw_opening_rad", plain_number("rad"),
         "[rad] of each jaw; 0: it has none"),
        ("--grip-force", "grip_force_N", quantity("N"), "with which jaws close at most"),
        ("--trocar-height", "trocar_height_m", quantity("m"),
         "over the organ, where the shaft passes the abdominal wall; 0mm: the device turns it"),
        ("--trocar-side", "trocar_side_m", quantity("m"), "along x from the organ's middle"),
        ("--trocar", "trocar_m", read_point, "X,Y,Z [m] of it, instead of both"),
        ("--force-max", "force_max_N", quantity("N"), "more the hand's spring never pulls with"),
        ("--fulcrum", "fulcrum_m", quantity("m"),
         "from tip to handle, which a device shall be; 0mm: a device is the tip"),
    ):  # fmt: skip
        parser.add_argument(option, dest=name, type=read, help=text)


def read_point(text: str) -> list[float]:
    try:
        point = [float(part) for part in text.split(",")]
    except ValueError:
        point = []
    if len(point) != 3:
        raise argparse.ArgumentTypeError(f"got {text!r}, expected X,Y,Z")
    return point


def change_tool(made: Json, call: argparse.Namespace) -> Json:
    if call.remove:
        return author_tools.remove_tool(made, call.remove)
    values: dict[str, Any] = {
        name: getattr(call, name) for name in NUMBERS if getattr(call, name) is not None
    }
    if call.kind is None and call.set not in made.get("tools", {}):
        raise WrongCall(f"--kind: got none, expected what the new instrument {call.set} is")
    if call.kind is not None:
        made = author_tools.set_kind(made, call.set, call.kind)
    if "trocar_m" in values:
        values |= dict.fromkeys(("trocar_height_m", "trocar_side_m"))
    elif {"trocar_height_m", "trocar_side_m"} & set(values):
        values["trocar_m"] = None
    return author_tools.set_tool(made, call.set, values)
