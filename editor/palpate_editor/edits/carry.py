# SPDX-License-Identifier: GPL-3.0-or-later
"""Taking what was painted on one surface over to another of the same organ."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate

from palpate_editor.document import Organ, Surface
from palpate_editor.document.far_compliance import compute_key, is_stale
from palpate_editor.edits.wall import settle_wall

MOST_FACTORS = 16
"""Different factors of stiffness that are painted in one piece each; more are a smooth change."""
ON_BORDER = 0.99
"""[-] Of its point, a vertex on the border of what is painted is inside, but for rounding."""


def carry_paint(organ: Organ, surface: Surface, exact: bool = False) -> Organ:
    """`organ` on `surface`, each vertex painted as the old surface is at the point closest to it.

    A factor of stiffness is interpolated; a vertex is fixed, or in a region, where most of its
    point is. A region that nothing is left of goes. A surface that is open now has a wall. With
    `exact` the borders of what is painted (number_painted) are lines of `surface` too, and only
    what is on them or within is inside.
    """
    old = organ.surface
    fresh = settle_wall(organ.with_surface(surface), organ)
    if old is None or not is_painted(organ):
        return fresh
    corners, weights = find_closest(old, surface.vertices)

    def spread(values: np.ndarray) -> np.ndarray:
        return (values[corners] * weights).sum(axis=1)

    def find_inside(inside: np.ndarray) -> np.ndarray:
        share = spread(inside.astype(float))
        return share >= (ON_BORDER if exact and has_triangle(old, inside) else 0.5)

    regions = {}
    for name, ids in organ.regions.items():
        kept = np.flatnonzero(find_inside(mark(old, ids)))
        if kept.size:
            regions[name] = kept
    return replace(
        fresh,
        fixed=find_inside(organ.fixed),
        stiffness_scale=spread(organ.stiffness_scale),
        regions=regions,
    )


def carry_far_field(organ: Organ, made: Organ) -> Organ:
    """`made`, the same body on another surface, with the far field of `organ` at the points closest
    to its vertices; without one where that is of fewer vertices, or of something else."""
    far, old, new = organ.far_field, organ.surface, made.surface
    if far is None or old is None or new is None or is_stale(organ):
        return made
    if len(new.vertices) > len(old.vertices):
        return made
    corners, weights = find_closest(old, new.vertices)
    softness = (far.tensors[corners] * weights[:, :, None]).sum(axis=1)
    carried = replace(far, key=compute_key(made), softness=softness.ravel())
    return replace(made, far_field=carried)


def mark(surface: Surface, ids: np.ndarray) -> np.ndarray:
    """(n,) bool"""
    inside = np.zeros(len(surface.vertices), bool)
    inside[ids] = True
    return inside


def has_triangle(surface: Surface, inside: np.ndarray) -> bool:
    return bool(inside[surface.triangles].all(axis=1).any())


def number_painted(organ: Organ, source: Surface) -> tuple[np.ndarray, np.ndarray]:
    """(t,) twice: a number for each triangle of `source`, the imported surface. The first differs
    where one is all held, or all of a factor of stiffness, and the other not; the second where one
    is all within a region."""
    held = [organ.fixed]
    factors = np.unique(organ.stiffness_scale)
    if len(factors) <= MOST_FACTORS:
        held += [organ.stiffness_scale == factor for factor in factors]
    assert organ.surface is not None
    named = [mark(organ.surface, ids) for ids in organ.regions.values()]
    return number_within(organ.surface, held, source), number_within(organ.surface, named, source)


def number_within(surface: Surface, masks: list[np.ndarray], source: Surface) -> np.ndarray:
    """(t,) A number for each triangle of `source` by which of the masks, (n,) bool each on
    `surface`, all of its corners are in."""
    if not any(each.any() for each in masks):
        return np.zeros(len(source.triangles), int)
    if surface is not source:
        corners, weights = find_closest(surface, source.vertices)
        masks = [(each[corners] * weights).sum(axis=1) >= 0.5 for each in masks]
    within = np.array([each[source.triangles].all(axis=1) for each in masks])
    return np.asarray(np.unique(within, axis=1, return_inverse=True)[1]).ravel()


def is_painted(organ: Organ) -> bool:
    return bool(organ.fixed.any() or (organ.stiffness_scale != 1.0).any() or organ.regions)


def find_closest(surface: Surface, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Corners (n, 3) and weights (n, 3) of the surface's points closest to `points` [m] (n, 3)."""
    tree = palpate.AabbTree(surface.vertices, surface.triangles)
    found = [palpate.find_closest_point(tree, surface.vertices, point) for point in points]
    corners = surface.triangles[[near.triangle for near in found]]
    return corners, np.array([near.weights for near in found])
