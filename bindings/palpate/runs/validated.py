# SPDX-License-Identifier: BSD-3-Clause
"""To which depth a press is validated: how far the contact references go [accuracy: tool].

Deeper, and under other tips, a scene can be pressed, but no truth was solved to compare it with.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.runs.press import Place, take_surface
from palpate.scene.scene_parts import ROUNDING, VALIDATED_PART, VALIDATED_RADII, VALIDATED_TIPS

BELOW = 1e-5
"""[m] under the surface, where the way through the body begins."""
STEP, MOST_LOOKS = 1e-3, 1000
"""[m] of a script's way between two looks at how deep it is, and the most from frame to frame."""


@dataclass(frozen=True)
class Validity:
    """How deep a tool may go at a place for its force to be validated."""

    thickness: float | None
    """[m] of the body along the press, a hollow one with its far wall; None where nothing is
    behind the place, as in a sheet."""
    depth: float
    """[m] of the tool beyond its first touch; 0 where no depth is validated."""
    bound: str
    """Which length it comes from: thickness, radius or wall; tip where no reference has such
    a one: a ball of this radius."""


@dataclass(frozen=True)
class PressDepth:
    """How deep a press goes at a place, and to which depth it is validated there."""

    depth: float
    """[m] of the hand's tip below the surface at rest. The tool, on its spring, goes less."""
    place: Place
    validity: Validity


def find_validity(scene: palpate.Scene, place: Place, wall: float | None = None) -> Validity:
    """For the first instrument, at a place of the first body.

    Args:
        wall: [m] of a hollow body: linear truth of a wall holds for depths below its thickness;
            None for a solid.
    """
    return Depths(scene, wall).find(place)


class Depths:
    """Looks up the validated depth at many places of a scene."""

    def __init__(self, scene: palpate.Scene, wall: float | None = None):
        tool = scene.instruments[0].tool
        self.wall, self.radius = wall, tool.radius
        self.has_reference = not tool.capsules and within(tool.radius, *VALIDATED_TIPS)
        self.x, self.triangles = take_surface(scene, 0)
        self.tree = palpate.AabbTree(self.x, self.triangles)
        self.normals = np.asarray(palpate.compute_vertex_normals(self.x, self.triangles))
        self.size = float(palpate.compute_diagonal(self.x))

    def find(self, place: Place) -> Validity:
        thickness = self.find_thickness(place)
        if not self.has_reference:
            return Validity(thickness, 0.0, "tip")
        bounds = {"radius": VALIDATED_RADII * self.radius}
        if thickness is not None:
            bounds["thickness"] = VALIDATED_PART * thickness
        if self.wall is not None:
            bounds["wall"] = self.wall
        bound = min(bounds, key=lambda name: bounds[name])
        return Validity(thickness, bounds[bound], bound)

    def find_thickness(self, place: Place) -> float | None:
        """[m] along the press to where the body ends: of a hollow one the farthest wall."""
        inward = -place.outward
        if self.wall is None:
            origin, direction = place.point + BELOW * inward, inward
        else:  # what is met first from behind the body
            origin, direction = place.point + 2.0 * self.size * inward, place.outward
        hit = palpate.find_ray_hit(self.tree, self.x, origin, direction)
        if hit is None:
            return None
        length = float((np.asarray(hit.point) - place.point) @ inward)
        return length if length > BELOW else None

    def find_place(self, centre: NDArray[np.float64]) -> tuple[Place, float]:
        """The surface point closest to the middle of a tip, and how deep the tip is there [m]."""
        found = palpate.find_closest_point(self.tree, self.x, centre)
        corners = self.triangles[found.triangle]
        outward = np.asarray(found.weights) @ self.normals[corners]
        outward /= np.linalg.norm(outward)
        point = np.array(found.point)
        away = float(np.linalg.norm(centre - point))
        above = away if (centre - point) @ outward >= 0.0 else -away
        return Place(point, outward), self.radius - above


def within(value: float, low: float, high: float) -> bool:
    return low * (1.0 - ROUNDING) <= value <= high * (1.0 + ROUNDING)


def measure_script(
    scene: palpate.Scene, frames: Sequence[palpate.KeyFrame], wall: float | None = None
) -> PressDepth | None:
    """Where a script of the first instrument goes farthest beyond what is validated, or comes
    nearest to it; None where it never comes below the surface at rest."""
    depths = Depths(scene, wall)
    worst: PressDepth | None = None
    for centre in list_centres(frames):
        place, depth = depths.find_place(centre)
        if depth <= 0.0:
            continue
        press = PressDepth(depth, place, depths.find(place))
        if worst is None or find_excess(press) > find_excess(worst):
            worst = press
    return worst


def find_excess(press: PressDepth) -> float:
    """[m]"""
    return press.depth - press.validity.depth


def list_centres(frames: Sequence[palpate.KeyFrame]) -> Iterator[NDArray[np.float64]]:
    """[m] Of the tip's middle, along a script's way."""
    if frames:
        yield np.array(frames[0].position)
    for before, after in pairwise(frames):
        start, end = np.array(before.position), np.array(after.position)
        # straight, whatever the speed (core/sim/device/simulated_devices.cpp)
        count = int(np.clip(np.ceil(np.linalg.norm(end - start) / STEP), 1, MOST_LOOKS))
        for part in np.arange(1, count + 1) / count:
            yield start + part * (end - start)
