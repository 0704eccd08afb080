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
from palpate.render.shapes import Shape

CREASE = math.radians(40.0)
"""[rad] Triangles that meet at more than this have an edge between them, as those of a box have."""
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


def build_shape(mesh: palpate.SurfaceMesh) -> Shape:
    """A mesh that is smooth but for its creases: every corner of a triangle has a vertex of its
    own, with the mean normal, by area, of those triangles around it that bend by less."""
    x, triangles = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    a, b, c = (x[triangles[:, k]] for k in range(3))
    area = np.cross(b - a, c - a)
    facing = area / np.linalg.norm(area, axis=1, keepdims=True)
    corner, other = pair_corners(triangles.ravel(), len(x))
    own, beside = corner // 3, other // 3
    smooth = np.einsum("ij,ij->i", facing[own], facing[beside]) >= math.cos(CREASE)
    normals = np.zeros((triangles.size, 3))
    np.add.at(normals, corner[smooth], area[beside[smooth]])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Shape(
        x[triangles.ravel()].astype(np.float32),
        normals.astype(np.float32),
        np.arange(triangles.size, dtype=np.uint32).reshape(-1, 3),
    )


def pair_corners(
    vertex: NDArray[np.int32], count: int
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Each corner of a triangle with each that is at the same of `count` vertices, itself too."""
    by_vertex = np.argsort(vertex, kind="stable")
    times = np.bincount(vertex, minlength=count)
    first = np.concatenate([[0], np.cumsum(times)[:-1]])
    around = times[vertex]
    corner = np.repeat(np.arange(len(vertex)), around)
    number = np.arange(len(corner)) - np.repeat(np.cumsum(around) - around, around)
    return corner, by_vertex[first[vertex[corner]] + number]
