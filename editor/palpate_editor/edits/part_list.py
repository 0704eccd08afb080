# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a mesh file, to choose by: how large each is and how it lies to the others."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.appearance import Colour
from palpate_editor.document import Surface
from palpate_editor.edits.place_parts import place_surfaces


@dataclass(frozen=True, eq=False)
class Part:
    """One part of a file, in metres and z up, as the whole file is understood; not welded."""

    name: str
    surface: Surface
    groups: tuple[str, ...]
    """It stands under in the file, outermost first; a part may be one too."""
    size: np.ndarray
    """[m] (3,) of its box."""
    volume: float | None
    """[m³] None where it is open."""
    inside: str | None
    """The smallest part it lies inside of."""
    crosses: tuple[str, ...]
    """Parts whose triangles cross its own."""
    closed: bool
    crossing_faces: int | None
    """Of its triangles that cross each other; None where counting would take too long."""
    colour: Colour | None
    """sRGB, 0 to 1; None where the file says none."""


def list_parts(scene: authoring.ImportedScene, unit: str, up: str) -> tuple[Part, ...]:
    """All parts of a file: a second for a large one, on any thread."""
    places = authoring.find_places(scene)
    names = [part.name for part in scene.parts]
    found = []
    for part, place, (name, surface) in zip(
        scene.parts, places, place_surfaces(scene, unit, up), strict=True
    ):
        x = surface.vertices
        found.append(
            Part(
                name=name,
                surface=surface,
                groups=tuple(part.groups),
                size=np.ptp(x, axis=0) if len(x) else np.zeros(3),
                volume=measure_volume(surface) if place.closed else None,
                inside=None if place.inside < 0 else names[place.inside],
                crosses=tuple(names[other] for other in place.crosses),
                closed=place.closed,
                crossing_faces=None if place.crossing_faces < 0 else place.crossing_faces,
                colour=None if part.colour is None else tuple(part.colour),
            )
        )
    return tuple(found)


def measure_volume(surface: Surface) -> float:
    """[m³] inside a closed surface, whichever way its triangles face."""
    mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)
    return abs(float(palpate.compute_volume(mesh)))


def find_outermost(parts: tuple[Part, ...]) -> tuple[str, ...]:
    """Names of the parts that lie inside no other, where some do; empty where none does."""
    if all(part.inside is None for part in parts):
        return ()
    return tuple(part.name for part in parts if part.inside is None)


def sort_rows(parts: tuple[Part, ...]) -> list[tuple[Part, int]]:
    """Each part below the one it lies inside of, and how deep it lies; in the order of the file."""
    within: dict[str | None, list[Part]] = {}
    for part in parts:
        within.setdefault(part.inside, []).append(part)
    rows: list[tuple[Part, int]] = []

    def add(inside: str | None, depth: int) -> None:
        for part in within.get(inside, []):
            rows.append((part, depth))
            add(part.name, depth + 1)

    add(None, 0)
    return rows
