# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a mesh file on the command line: which are there, and how they become an organ."""

from __future__ import annotations

import argparse

from palpate.command.verb import Report, WrongCall, quantity

from palpate_editor import authoring
from palpate_editor.appearance import write_colour
from palpate_editor.edits.import_mesh import Assembling
from palpate_editor.edits.part_list import Part, find_outermost, list_parts, sort_rows

MOST_NAMED = 3
"""Parts that are named where one crosses many."""


def add_assembling(parser: argparse.ArgumentParser) -> None:
    """How parts become one surface."""
    parser.add_argument(
        "--weld",
        type=quantity("m"),
        metavar="LENGTH",
        help="make vertices of different parts one that are closer than this, such as 0.1mm; "
        "default: those at the same point",
    )
    parser.add_argument(
        "--unite", action="store_true", help="make the parts, which are solids, one solid"
    )
    parser.add_argument(
        "--subtract",
        action="append",
        default=[],
        metavar="NAME",
        help="take the inside of this part away from the others, may be repeated; they are united",
    )


def read_assembling(call: argparse.Namespace, *, regions: bool = False) -> Assembling:
    """Raises WrongCall for options that have no effect together."""
    if call.weld is not None and call.weld < 0.0:
        raise WrongCall("--weld: got a negative length, expected one of 0 or more")
    if call.weld is not None and (call.unite or call.subtract):
        raise WrongCall("--weld has no effect on solids that are united: give one of them")
    return Assembling(call.weld, call.unite, tuple(call.subtract), regions)


def choose_outer(call: argparse.Namespace, scene: authoring.ImportedScene) -> list[str]:
    """The parts that lie inside no other. Raises WrongCall where that is no choice."""
    if call.part:
        raise WrongCall("--outer and --part both say which parts: give one of them")
    outer = find_outermost(list_parts(scene, "m", "z"))
    if not outer:
        raise WrongCall("--outer has no effect: no part of the file lies inside another")
    return list(outer)


def report_parts(scene: authoring.ImportedScene, unit: str, up: str) -> list[Report]:
    """Every part, each below the one it lies inside of."""
    return [report_part(part, depth) for part, depth in sort_rows(list_parts(scene, unit, up))]


def report_part(part: Part, depth: int) -> Report:
    return {
        "name": part.name,
        "groups": list(part.groups),
        "vertices": len(part.surface.vertices),
        "triangles": len(part.surface.triangles),
        "size_mm": (1e3 * part.size).tolist(),
        "volume_ml": None if part.volume is None else 1e6 * part.volume,
        "closed": part.closed,
        "inside": part.inside,
        "depth": depth,
        "crosses": list(part.crosses),
        "self_intersecting_faces": part.crossing_faces,
        "colour": None if part.colour is None else write_colour(part.colour),
    }


def shorten(names: list[str]) -> str:
    shown = ", ".join(names[:MOST_NAMED])
    return shown if len(names) <= MOST_NAMED else f"{shown} and {len(names) - MOST_NAMED} more"


def describe_parts(parts: list[Report]) -> list[str]:
    """A line for each, indented as far as it lies inside others."""
    if len(parts) == 1:
        return [f"one part: {parts[0]['name']}"]
    lines = [f"{len(parts)} parts:"]
    for part in parts:
        size = " x ".join(f"{length:.1f}" for length in part["size_mm"])
        words = [f"{part['triangles']} triangles", f"{size} mm"]
        if part["volume_ml"] is not None:
            words.append(f"{part['volume_ml']:.4g} ml")
        else:
            words.append("open")
        if part["inside"] is not None:
            words.append(f"inside {part['inside']}")
        if part["crosses"]:
            words.append(f"crosses {shorten(part['crosses'])}")
        if part["self_intersecting_faces"]:
            words.append(f"{part['self_intersecting_faces']} triangles cross others of its own")
        if part["groups"]:
            words.append(f"of {' / '.join(part['groups'])}")
        lines.append(f"  {'  ' * part['depth']}{part['name']}: {', '.join(words)}")
    return lines
