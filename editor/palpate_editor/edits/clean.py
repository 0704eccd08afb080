# SPDX-License-Identifier: GPL-3.0-or-later
"""Repairs that take nothing away that anybody could feel: cleaning, stitching, dropping debris."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.inspected import mesh_of
from palpate_editor.edits.repair import list_sides, put_in_place

NEAR = 0.05
"""[-] of the mean edge of the borders: how near they lie that are stitched together."""
SMALL = 0.01
"""[-] of all the area: a piece that has less is debris."""
DEBRIS = 0.25
"""[-] of all the area, of an open piece beside a closed one, such as a fin that was cut off."""


def surface_of(mesh: palpate.SurfaceMesh) -> Surface:
    return Surface(np.asarray(mesh.vertices), np.asarray(mesh.triangles))


def is_same(mesh: palpate.SurfaceMesh, surface: Surface) -> bool:
    return np.array_equal(mesh.triangles, surface.triangles) and np.array_equal(
        mesh.vertices, surface.vertices
    )


@dataclass(frozen=True)
class CleanUp:
    """Drop doubled and empty triangles and specks, part what only touches, turn it outwards."""

    title: ClassVar[str] = "Clean up"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if clean_up(surface) is surface:
            raise EditError(phrase("The surface is clean already."))
        return put_in_place(organ, clean_up)


def clean_up(surface: Surface) -> Surface:
    """The very same surface where there is nothing to do."""
    found = authoring.repair_mesh(mesh_of(surface)).mesh
    if is_same(found, surface):
        return surface
    if not len(found.triangles):
        raise EditError(phrase("Nothing of the surface would be left."))
    return surface_of(found)


@dataclass(frozen=True)
class StitchBorders:
    """Join borders that lie on each other, and close cracks where a corner meets an edge."""

    title: ClassVar[str] = "Stitch borders"

    tolerance: float | None = None
    """[m] How near they lie; None for a twentieth of their mean edge."""

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if self.tolerance is not None and not self.tolerance > 0.0:
            raise EditError(
                phrase(
                    "Borders are stitched that are more than 0 mm apart at most, got {got:g} mm.",
                    got=1e3 * self.tolerance,
                )
            )
        if self.stitch(surface) is surface:
            raise EditError(phrase("No two borders lie on each other."))
        return put_in_place(organ, self.stitch)

    def stitch(self, surface: Surface) -> Surface:
        """The very same surface where nothing is joined, or more would be wrong than before."""
        tolerance = self.tolerance
        if tolerance is None:
            tolerance = NEAR * measure_borders(surface)
        if tolerance == 0.0:
            return surface
        found = authoring.stitch_borders(mesh_of(surface), tolerance)
        if not found.split_edges and not found.joined_vertices:
            return surface
        whole = surface_of(authoring.repair_mesh(found.mesh).mesh)
        crowded = count_crowded(whole) > count_crowded(surface)
        return surface if crowded or not len(whole.triangles) else whole


def measure_borders(surface: Surface) -> float:
    """[m] The mean edge of the borders; 0 of a closed surface."""
    times = list_sides(surface.triangles)[1]
    sides = np.stack([surface.triangles, np.roll(surface.triangles, -1, axis=1)], axis=2)
    x = surface.vertices[sides.reshape(-1, 2)[times == 1]]
    return float(np.linalg.norm(x[:, 1] - x[:, 0], axis=1).mean()) if len(x) else 0.0


def count_crowded(surface: Surface) -> int:
    """Edges of more than two triangles."""
    edge, times, _ = list_sides(surface.triangles)
    return len(np.unique(edge[times > 2]))


@dataclass(frozen=True)
class DropPieces:
    """Drop the small pieces of a surface, and open ones beside one that is closed."""

    title: ClassVar[str] = "Drop small pieces"

    share: float = SMALL
    """[-] of all the area; pieces that have less go. Open ones go below a quarter."""

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if not 0.0 < self.share < 1.0:
            raise EditError(
                phrase(
                    "The share of the area must be between 0 and 1, got {got:g}.", got=self.share
                )
            )
        if self.drop(surface) is surface:
            raise EditError(phrase("No piece of it is so small."))
        return put_in_place(organ, self.drop)

    def drop(self, surface: Surface) -> Surface:
        pieces = measure_pieces(surface)
        whole = pieces.areas.sum()
        largest = int(pieces.areas.argmax())
        small = pieces.areas < self.share * whole
        if pieces.closed[largest]:
            small |= ~pieces.closed & (pieces.areas < max(self.share, DEBRIS) * whole)
        small[largest] = False
        if not small.any():
            return surface
        return take(surface, ~small[pieces.of_triangle])


@dataclass(frozen=True, eq=False)
class Pieces:
    """The pieces of a surface, which nothing holds together."""

    of_triangle: np.ndarray
    """(t,) the piece each triangle belongs to, counted from 0"""
    areas: np.ndarray
    """[m²] (p,)"""
    closed: np.ndarray
    """(p,) bool: has no border"""


def measure_pieces(surface: Surface) -> Pieces:
    x, triangles = surface.vertices, surface.triangles
    of_triangle = np.asarray(palpate.find_shells(len(x), triangles))[triangles[:, 0]]
    _, of_triangle = np.unique(of_triangle, return_inverse=True)
    areas = compute_areas(surface)
    borders = np.zeros(of_triangle.max() + 1, bool)
    borders[of_triangle[np.flatnonzero(list_sides(triangles)[1] == 1) // 3]] = True
    return Pieces(of_triangle, np.bincount(of_triangle, areas), ~borders)


def compute_areas(surface: Surface) -> np.ndarray:
    """[m²] (t,)"""
    x, triangles = surface.vertices, surface.triangles
    side = x[triangles[:, 1:]] - x[triangles[:, :1]]
    return 0.5 * np.linalg.norm(np.cross(side[:, 0], side[:, 1]), axis=1)


def take(surface: Surface, kept: np.ndarray) -> Surface:
    """The surface of some of its triangles, (t,) bool."""
    used = np.unique(surface.triangles[kept])
    number = np.full(len(surface.vertices), -1, np.int32)
    number[used] = np.arange(len(used), dtype=np.int32)
    return Surface(surface.vertices[used], number[surface.triangles[kept]])


@dataclass(frozen=True)
class Smooth:
    """Smooth the surface; it neither shrinks nor swells."""

    steps: int

    @property
    def title(self) -> str:
        return phrase("Smooth, {steps} steps", steps=self.steps)

    def __call__(self, organ: Organ) -> Organ:
        find_surface(organ)
        if not 1 <= self.steps <= MOST_STEPS:
            raise EditError(
                phrase(
                    "Steps of smoothing: got {got}, expected 1 to {most}.",
                    got=self.steps,
                    most=MOST_STEPS,
                )
            )
        return put_in_place(organ, self.smooth)

    def smooth(self, surface: Surface) -> Surface:
        try:
            found = authoring.smooth_surface(mesh_of(surface), self.steps)
        except ValueError as problem:
            raise EditError(phrase("It cannot be smoothed yet: {why}", why=str(problem))) from None
        before, after = (
            authoring.find_self_intersecting_faces(m) for m in (mesh_of(surface), found)
        )
        if after is None or (before is not None and len(after) > len(before)):
            raise EditError(
                phrase(
                    "Smoothed by {steps} steps the surface would cross itself: take fewer.",
                    steps=self.steps,
                )
            )
        return surface_of(found)


MOST_STEPS = 200
