# SPDX-License-Identifier: BSD-3-Clause
"""Ways for a simulated hand through what is hollow, and where a laparoscope sees something."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import palpate
from palpate.assessment.organ_surface import Vec, unit

STEP = 0.008
"""[m] between two corners of a way."""
NEAR = 0.009
"""[m] Surface that is nearer is kept away from."""
ROUNDS, PUSH = 40, 2.5e-4
"""Of keeping away, each by so much [m]."""
DISTANCES = np.linspace(0.03, 0.12, 37)
"""[m] Of a lens from what it looks at."""
ROLLS = 24
"""In which a tool is tried about its shaft."""
Z = np.array([0.0, 0.0, 1.0])


class Hollows:
    """The surfaces of a scene at rest, to find what lies between them."""

    def __init__(self, task: palpate.Task):
        self.trees = []
        for surface in task.surfaces:
            x = np.array(surface.vertices)
            self.trees.append((palpate.AabbTree(x, np.array(surface.triangles)), x))

    def find_nearest(self, p: Vec) -> tuple[Vec, float]:
        """The nearest point of any surface, and how far [m] it is."""
        found = [palpate.find_closest_point(tree, x, p) for tree, x in self.trees]
        nearest = min((each for each in found if each is not None), key=lambda hit: hit.distance)
        return np.array(nearest.point), float(nearest.distance)

    def is_seen(self, eye: Vec, point: Vec) -> bool:
        """Whether no surface lies between."""
        side = point - eye
        far = float(np.linalg.norm(side))
        hits = [palpate.find_ray_hit(tree, x, eye, side) for tree, x in self.trees]
        return all(hit is None or hit.distance > far for hit in hits)

    def keep_to_middle(self, a: Vec, b: Vec) -> list[Vec]:
        """Corners from a to b, b the last, each as far from what is beside it as that is across."""
        along = unit(b - a)
        count = max(1, int(np.linalg.norm(b - a) / STEP))
        way: list[Vec] = []
        for k in range(1, count):
            p = a + (b - a) * (k / count)
            for _ in range(ROUNDS):
                nearest, distance = self.find_nearest(p)
                if distance > NEAR:
                    break
                away = p - nearest
                away -= (away @ along) * along
                p = p + PUSH * unit(away) if np.linalg.norm(away) > 0.0 else p
            way.append(p)
        return [*way, b]


def roll_about_shaft(roll: float) -> tuple[float, ...]:
    """(x, y, z, w) of a device that is turned by an angle [rad] about its shaft."""
    return (0.0, 0.0, float(np.sin(0.5 * roll)), float(np.cos(0.5 * roll)))


def turn_tool(shaft: Vec, roll: float) -> Rotation:
    """The tool's, whose z goes along the shaft: as [contact: trocar]."""
    shaft = unit(shaft)
    axis = np.cross(Z, shaft)
    size = float(np.linalg.norm(axis))
    angle = float(np.arctan2(size, Z @ shaft))
    swing = Rotation.from_rotvec(axis / size * angle) if size > 0.0 else Rotation.identity()
    return swing * Rotation.from_rotvec([0.0, 0.0, roll])


def find_thinnest_roll(points: NDArray[np.float64], shaft: Vec) -> float:
    """[rad] The roll in which jaws, which open along the tool's y, have the least between them."""
    best = (np.inf, 0.0)
    for roll in np.linspace(0.0, np.pi, ROLLS, endpoint=False):
        opens = turn_tool(shaft, float(roll)).apply([0.0, 1.0, 0.0])
        best = min(best, (float(np.ptp(points @ opens)), float(roll)))
    return best[1]


def find_lookout(
    camera: palpate.TaskCamera,
    trocar: Vec,
    points: NDArray[np.float64],
    distance: palpate.Band,
    hollows: Hollows,
    clear: float,
) -> tuple[Vec, float] | None:
    """Where a tip is, and its roll [rad], whose lens has the middle of points (n, 3) in the middle
    of its picture, with most of them not hidden, and `clear` [m] from all surfaces; None where
    there is none."""
    middle = points.mean(axis=0)
    forward, at = np.array(camera.forward), np.array(camera.at)
    best: tuple[float, float, Vec, float] | None = None
    for roll in np.linspace(0.0, 2.0 * np.pi, ROLLS, endpoint=False):
        for far in DISTANCES[(distance.least <= DISTANCES) & (distance.most >= DISTANCES)]:
            tip = middle + 0.5 * (trocar - middle)
            for _ in range(30):
                turned = turn_tool(trocar - tip, float(roll))
                tip = middle - far * turned.apply(forward) - turned.apply(at)
            lens = tip + turned.apply(at)
            gap = hollows.find_nearest(tip)[1]
            if gap < clear or np.linalg.norm(trocar - tip) < 0.02:
                continue
            seen = float(np.mean([hollows.is_seen(lens, point) for point in points]))
            if seen >= 0.75 and (best is None or (seen, -abs(far - 0.07)) > best[:2]):
                best = (seen, -abs(float(far) - 0.07), tip, float(roll))
    return None if best is None else (best[2], best[3])
