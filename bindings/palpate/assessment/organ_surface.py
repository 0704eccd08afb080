# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces of a scene at rest, as a simulated hand knows its way about them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import palpate

Vec = NDArray[np.float64]

CLEARANCE = 0.012
"""[m] of the tip above an organ where it only passes."""
SAMPLES = 40
"""of a straight way, to see whether it is free"""


def unit(v: Vec) -> Vec:
    length = float(np.linalg.norm(v))
    return v / length if length > 0.0 else np.array([0.0, 0.0, 1.0])


def mark_used(triangles: NDArray[np.int32], count: int) -> NDArray[np.bool_]:
    """(n,) which vertices have a triangle: the inner face of a wall has none."""
    used = np.zeros(count, dtype=bool)
    used[triangles.ravel()] = True
    return used


class OrganSurface:
    """Where places are, and ways between them that touch nothing."""

    def __init__(self, task: palpate.Task, radius: float):
        """`radius` [m] is the tip's."""
        self.radius = radius
        self.vertices = [np.array(surface.vertices) for surface in task.surfaces]
        self.normals = [np.array(surface.normals) for surface in task.surfaces]
        self.outer = [
            mark_used(np.asarray(surface.triangles), len(x))
            for surface, x in zip(task.surfaces, self.vertices, strict=True)
        ]
        self.all = np.concatenate(
            [x[used] for x, used in zip(self.vertices, self.outer, strict=True)]
        )
        self.centre: Vec = 0.5 * (self.all.min(axis=0) + self.all.max(axis=0))
        reach = np.linalg.norm(self.all - self.centre, axis=1).max()
        self.far = float(reach) + radius + CLEARANCE
        """[m] from the centre, where every way is free."""

    def find_anchor(self, place: palpate.TaskPlace) -> tuple[Vec, Vec]:
        """The point [m] of a place that is farthest from what lies outside, and its normal."""
        x, n = self.vertices[place.body], self.normals[place.body]
        if place.kind is not palpate.PlaceKind.region:
            return self.find_nearest(place.body, np.asarray(place.points[0]))
        inside = np.asarray(place.members, dtype=bool)
        members, others = np.flatnonzero(inside), x[~inside & self.outer[place.body]]
        centre = x[members].mean(axis=0)
        far = np.linalg.norm(x[members] - centre, axis=1)
        if len(others):
            gaps = [float(((others - x[v]) ** 2).sum(axis=1).min()) ** 0.5 for v in members]
            far = far - 2.0 * np.minimum(gaps, 3.0 * self.radius)
        best = members[int(np.argmin(far))]
        return x[best], unit(n[best])

    def find_nearest(self, body: int, p: Vec) -> tuple[Vec, Vec]:
        """The nearest vertex [m] and its normal, the point itself where it is on the surface."""
        x = self.vertices[body]
        gaps = np.where(self.outer[body], ((x - p) ** 2).sum(axis=1), np.inf)
        near = np.argsort(gaps)[:4]
        weights = 1.0 / (gaps[near] + 1e-12)
        normal = unit((self.normals[body][near] * weights[:, None]).sum(axis=0))
        return np.array(p), normal

    def above(self, anchor: Vec, normal: Vec, height: float = CLEARANCE) -> Vec:
        """[m] The middle of the tip so high over a point of the surface."""
        return np.asarray(anchor + normal * (self.radius + height))

    def is_free(self, a: Vec, b: Vec) -> bool:
        """Whether the tip touches nothing on the straight way."""
        least = self.radius + 0.5 * CLEARANCE
        for share in np.linspace(0.0, 1.0, SAMPLES):
            p = a + share * (b - a)
            if ((self.all - p) ** 2).sum(axis=1).min() < least * least:
                return False
        return True

    def find_way(self, a: Vec, b: Vec) -> list[Vec]:
        """Corners [m] of a way from a to b, which are clear of the organ, b the last of them."""
        if self.is_free(a, b):
            return [b]
        u, w = unit(a - self.centre), unit(b - self.centre)
        way = [self.centre + self.far * u]
        angle = float(np.arccos(np.clip(u @ w, -1.0, 1.0)))
        side = unit(w - (u @ w) * u)
        if angle > 3.1:  # the far side: round by any side
            side = unit(np.cross(u, (0.3, 0.5, 0.8)))
        count = int(np.ceil(angle / 0.35))
        for k in range(1, count + 1):
            turned = np.cos(angle * k / count) * u + np.sin(angle * k / count) * side
            way.append(self.centre + self.far * turned)
        return [*way, b]
