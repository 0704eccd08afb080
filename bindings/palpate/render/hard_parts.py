# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies and scenery as they are drawn: stones that move, bones and tables that do not."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.render.instrument import DrawnPart, find_rotation
from palpate.render.part import Appearance
from palpate.render.shapes import Shape, sharpen

CREASE = math.radians(40.0)
"""[rad] Of an edge: stones have meshes as coarse as a ball of 42 vertices."""
BESIDE, NEAR = 1.5, 2.5
"""[-] Of the organs' radius, from their middle."""
STONE = Appearance(
    (0.80, 0.66, 0.42), gloss=0.35, roughness=0.55, subsurface=0.1, receives_instruments=True
)
BONE = Appearance(
    (0.77, 0.73, 0.65), gloss=0.25, roughness=0.6, subsurface=0.1, receives_instruments=True
)


class Pose(Protocol):
    """Where a rigid body is: a RigidBody at the start, its RigidState or RigidSnapshot later."""

    @property
    def position(self) -> NDArray[np.float64]: ...
    @property
    def orientation(self) -> NDArray[np.float64]: ...


def build_scenery(scene: palpate.Scene) -> list[DrawnPart]:
    """[m] All scenery, where it is."""
    return [DrawnPart(build_shape(part.mesh), BONE) for part in scene.scenery]


def build_rigid(scene: palpate.Scene) -> list[DrawnPart]:
    """[m] All rigid bodies, each in its own frame."""
    return [DrawnPart(build_shape(body.mesh), STONE) for body in scene.rigid]


def build_shape(mesh: palpate.SurfaceMesh) -> Shape:
    """A mesh that is smooth but for its edges."""
    return sharpen(np.asarray(mesh.vertices), np.asarray(mesh.triangles), CREASE)


def place_rigid(drawn: Sequence[DrawnPart], poses: Sequence[Pose]) -> list[DrawnPart]:
    """[m] Rigid bodies where they are."""
    return [
        DrawnPart(place_shape(part.shape, pose.position, pose.orientation), part.appearance)
        for part, pose in zip(drawn, poses, strict=True)
    ]


def place_shape(shape: Shape, position: ArrayLike, orientation: ArrayLike) -> Shape:
    """A shape of a frame at `position` [m], turned by a unit quaternion (x, y, z, w)."""
    turned = find_rotation(orientation).T.astype(np.float32)
    at = np.asarray(position, dtype=np.float32)
    return Shape(shape.vertices @ turned + at, shape.normals @ turned, shape.triangles)


def choose_framed(
    parts: Sequence[DrawnPart], middle: ArrayLike, radius: float
) -> NDArray[np.float64]:
    """[m] (n, 3) What of the parts is framed with organs in a ball: all of a part that is near,
    else its points that are nearer still."""
    framed = [np.zeros((0, 3))]
    for part in parts:
        points = part.shape.vertices.astype(float)
        far = np.linalg.norm(points - np.asarray(middle), axis=1)
        framed.append(points if far.max() <= NEAR * radius else points[far <= BESIDE * radius])
    return np.concatenate(framed)
