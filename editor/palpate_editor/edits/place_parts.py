# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a mesh file where they lie in an organ: in metres, z up."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from palpate_editor import authoring
from palpate_editor.document import Surface
from palpate_editor.edits.orient import METRES, TURNS


def place(points: np.ndarray, unit: str, up: str) -> np.ndarray:
    """[m] (n, 3) Points of a file, z up; the very numbers that reading the surface gives."""
    return (METRES[unit] * points) @ np.column_stack(TURNS[up]).T


def place_surfaces(
    scene: authoring.ImportedScene,
    unit: str,
    up: str,
    names: Iterable[str] | None = None,
    ratio: float = 1.0,
) -> list[tuple[str, Surface]]:
    """Name and surface of each part, or of those that are named; not welded. `ratio` [-] is that of
    the unit it is in the end to this one."""
    wanted = None if names is None else set(names)
    found = []
    for part in scene.parts:
        if wanted is None or part.name in wanted:
            x, triangles = np.asarray(part.mesh.vertices), np.asarray(part.mesh.triangles)
            found.append((part.name, Surface(ratio * place(x, unit, up), triangles)))
    return found


def find_colour(scene: authoring.ImportedScene, names: Sequence[str]) -> tuple[float, ...] | None:
    """sRGB, 0 to 1: the mean by area of the parts that have a colour."""
    colours, areas = [], []
    for part in scene.parts:
        if part.name in names and part.colour is not None:
            x = np.asarray(part.mesh.vertices)[np.asarray(part.mesh.triangles)]
            sides = np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
            areas.append(float(np.linalg.norm(sides, axis=1).sum()))
            colours.append(part.colour)
    if not colours or not sum(areas) > 0.0:
        return None
    mean = np.average(np.array(colours), axis=0, weights=areas)
    return tuple(np.clip(mean, 0.0, 1.0).tolist())
