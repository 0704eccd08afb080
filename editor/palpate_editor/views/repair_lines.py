# SPDX-License-Identifier: GPL-3.0-or-later
"""The command lines of the steps that repair a surface."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from palpate_editor.document import Organ
from palpate_editor.edits import (
    CleanUp,
    DropDoubled,
    DropFins,
    DropPieces,
    Remesh,
    RemoveCrossings,
    RepairAll,
    Smooth,
    StitchBorders,
    Wrap,
)

Arguments = list[object]


def step_arguments(*options: object) -> Callable[[Any, Organ, Path | str], Arguments]:
    """Of a repair without numbers."""

    def find(edit: Any, organ: Organ, document: Path | str) -> Arguments:
        del edit, organ
        return ["palpate", "repair", document, *options, "-o", document]

    return find


def number_arguments(
    option: str, field: str, unit: str = ""
) -> Callable[[Any, Organ, Path | str], Arguments]:
    """Of a repair with one number, or none for the usual one."""

    def find(edit: Any, organ: Organ, document: Path | str) -> Arguments:
        del organ
        value = getattr(edit, field)
        written = option if value is None else f"{option}={value:.12g}{unit}"
        return ["palpate", "repair", document, written, "-o", document]

    return find


def remesh_arguments(edit: Remesh, organ: Organ, document: Path | str) -> Arguments:
    del organ
    arguments: Arguments = [
        "palpate",
        "remesh",
        document,
        f"--edge-length={edit.edge_length:.12g}m",
    ]
    if edit.region:
        arguments += [f"--region={edit.region}"]
        arguments += [f"--region-edge-length={edit.region_edge_length:.12g}m"]
    return [*arguments, "-o", document]


REPAIRS: dict[type, Callable[[Any, Organ, Path | str], Arguments | None]] = {
    CleanUp: step_arguments("--clean"),
    StitchBorders: number_arguments("--stitch", "tolerance", "m"),
    DropFins: step_arguments("--drop-fins"),
    DropPieces: number_arguments("--drop-pieces", "share"),
    DropDoubled: step_arguments("--drop-doubled"),
    RemoveCrossings: number_arguments("--crossings", "seconds"),
    Smooth: number_arguments("--smooth", "steps"),
    Wrap: number_arguments("--wrap", "alpha", "m"),
    RepairAll: step_arguments("--all"),
    Remesh: remesh_arguments,
}
