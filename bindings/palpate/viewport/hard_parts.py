# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies and scenery of a view: what never moves is given once, stones in each frame."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.render.hard_parts import (
    Pose,
    build_rigid,
    build_scenery,
    choose_framed,
    place_rigid,
)
from palpate.render.instrument import DrawnPart
from palpate.scene.surfaces import join_rest_surfaces
from palpate.viewport.scenery import Scenery

FARTHEST = 4.0
"""[-] Of the organs' radius: farther away nothing is drawn, and shadows stay fine."""


class HardParts:
    """Draws them into a scenery; one object for a view."""

    def __init__(self, scenery: Scenery) -> None:
        self._scenery = scenery
        self._rigid: list[DrawnPart] = []
        self._names: list[str] = []
        self.poses: list[tuple[NDArray[np.float64], NDArray[np.float64]]] = []
        """[m] (3,) and unit quaternion (x, y, z, w) of each rigid body, as it is drawn."""

    def show(self, scene: palpate.Scene) -> None:
        """Those of a scene and no others, rigid bodies at the start. What is near to its organs
        will be in sight with the surface that is shown next."""
        for name in self._names:
            self._scenery.show_part(name, None)
        fixed, self._rigid = build_scenery(scene), build_rigid(scene)
        self._names = [f"scenery {s}" for s in range(len(fixed))]
        for name, part in zip(self._names, fixed, strict=True):
            self._scenery.show_part(name, part.shape, part.appearance)
        self._names += [f"rigid {r}" for r in range(len(self._rigid))]
        placed = self.move(scene.rigid)
        organs = join_rest_surfaces(scene)
        middle = 0.5 * (organs.min(axis=0) + organs.max(axis=0))
        radius = float(np.linalg.norm(organs - middle, axis=1).max())
        self._scenery.room = choose_framed([*fixed, *placed], middle, radius)
        far = [
            np.linalg.norm(part.shape.vertices - middle, axis=1).max() for part in [*fixed, *placed]
        ]
        self._scenery.reach = min(float(max(far, default=0.0)), FARTHEST * radius)

    def move(self, poses: Sequence[Pose]) -> list[DrawnPart]:
        """Rigid bodies where they are now [m]."""
        placed = place_rigid(self._rigid, poses)
        self.poses = [(np.array(each.position), np.array(each.orientation)) for each in poses]
        for number, part in enumerate(placed):
            self._scenery.show_part(f"rigid {number}", part.shape, part.appearance)
        return placed
