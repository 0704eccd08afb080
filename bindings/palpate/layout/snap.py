# SPDX-License-Identifier: BSD-3-Clause
"""A body is placed so that a region of it lies on a region of another."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from palpate.layout.document import PlacedBody
from palpate.layout.gaps import Surface, find_least
from palpate.layout.placed import Ints

Floats = NDArray[np.float64]
HALVINGS = 24
"""Of the way along which the body comes nearer: to 0.1 um of a metre."""


@dataclass(frozen=True)
class Patch:
    """Where a region is, which way it faces and along which way it is longest."""

    centre: Floats
    """[m] (3,)"""
    normal: Floats
    """[-] (3,), unit, outwards."""
    longest: Floats
    """[-] (3,), unit, across the normal; its sign means nothing."""


def measure_patch(surface: Surface, vertices: Ints) -> Patch:
    """Weighted by area: of the triangles with all corners in the region, else of those with one.

    Raises ValueError for a region that no triangle has a corner in, or that faces nowhere.
    """
    inside = np.isin(surface.triangles, vertices)
    chosen = inside.all(axis=1)
    if not chosen.any():
        chosen = inside.any(axis=1)
    if not chosen.any():
        raise ValueError("got a region without a triangle, expected some surface")
    corners = surface.x[surface.triangles[chosen]]
    cross = 0.5 * np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(cross, axis=1)
    centre = np.average(corners.mean(axis=1), axis=0, weights=areas)
    mean = cross.sum(axis=0) / areas.sum()
    if np.linalg.norm(mean) < 0.1:
        raise ValueError("got a region that faces all ways, expected one side of an organ")
    normal = mean / np.linalg.norm(mean)
    offset = corners - centre
    across = offset - (offset @ normal)[..., None] * normal
    # second moments of a triangle: A / 12 (sum x x' + s s'), s the sum of its corners
    ends = np.concatenate([across, across.sum(axis=1, keepdims=True)], axis=1)
    values, axes = np.linalg.eigh(np.einsum("t,tki,tkj->ij", areas, ends, ends))
    return Patch(centre, normal, axes[:, int(np.argmax(values))])


def measure_longest_edge(surface: Surface) -> float:
    """[m]"""
    corners = surface.x[surface.triangles]
    return float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max())


def snap(
    placed: PlacedBody, surface: Surface, patch: Patch, still: Surface, onto: Patch, gap: float
) -> PlacedBody:
    """The body turned until the patches face each other and their longest ways lie along each
    other, with the least turn that does, and moved until its surface is `gap` [m] away.

    Args:
        placed: Where the body stands.
        surface: Of the body, there.
        patch: Of that surface.
        still: The other body's surface.
        onto: Of that one.
        gap: Between the surfaces where they are nearest.
    """
    sign = 1.0 if patch.longest @ onto.longest >= 0.0 else -1.0
    turn, _ = Rotation.align_vectors(
        [-onto.normal, sign * onto.longest], [patch.normal, patch.longest], weights=[np.inf, 1.0]
    )
    x = turn.apply(surface.x - patch.centre) + onto.centre
    turned = Surface(x, surface.triangles)
    # where surfaces cross, an end of some edge is within its length of the other
    reach = gap + max(measure_longest_edge(still), measure_longest_edge(turned))
    far = gap + float(np.linalg.norm(turned.high - turned.low))
    near = 0.0
    for _ in range(HALVINGS):
        middle = 0.5 * (near + far)
        least = find_least(still, turned, reach, middle * onto.normal)
        is_near = least is not None and least.size <= gap
        near, far = (middle, far) if is_near else (near, middle)
    position = turn.apply(np.asarray(placed.position) - patch.centre) + onto.centre
    position = position + far * onto.normal
    rotation = (turn * Rotation.from_rotvec(placed.rotation)).as_rotvec()
    return replace(
        placed, position=tuple(map(float, position)), rotation=tuple(map(float, rotation))
    )
