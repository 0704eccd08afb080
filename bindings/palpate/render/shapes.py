# SPDX-License-Identifier: BSD-3-Clause
"""Tools and arrows as triangles, counter-clockwise from outside."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

SEGMENTS = 64
"""Around an axis: smooth at any size a picture has."""
SHARP = math.radians(35.0)
"""[rad] Between two triangles: a larger angle is drawn as an edge, unless another is asked for."""
ROUND = 1e-4
"""[-] Normals that differ by less are one."""
ARROW_HEAD = 2.3
"""Radius of an arrow's head in radii of its shaft."""


@dataclass(frozen=True)
class Shape:
    """A surface as the renderer takes it."""

    vertices: NDArray[np.float32]
    """[m] (n, 3)"""
    normals: NDArray[np.float32]
    """[-] (n, 3), unit, outward."""
    triangles: NDArray[np.uint32]
    """(t, 3)"""


def build_sphere(centre: ArrayLike, radius: float, segments: int = SEGMENTS) -> Shape:
    """A ball around `centre` [m]."""
    return build_capsule(centre, centre, radius, segments)


def build_capsule(
    start: ArrayLike, end: ArrayLike, radius: float, segments: int = SEGMENTS
) -> Shape:
    """All within `radius` [m] of the segment from `start` to `end` [m]."""
    a, b = as_point(start, "start"), as_point(end, "end")
    require_positive(radius, "radius")
    bend = np.linspace(-math.pi / 2, 0.0, segments // 4 + 1)
    lower = np.stack([radius * np.cos(bend), radius * np.sin(bend)], axis=1)
    upper = lower[::-1] * [1.0, -1.0]
    length = float(np.linalg.norm(b - a))
    profile = np.concatenate([lower, upper + [0.0, length]])
    slopes = np.concatenate([lower, upper]) / radius
    return turn(profile, slopes, a, b - a, segments)


def build_arrow(start: ArrayLike, end: ArrayLike, radius: float) -> Shape:
    """A shaft of `radius` [m] from `start`, and a head with its point at `end` [m].

    An arrow too short for its head gets a smaller one, so that it always ends where it says.
    """
    a, b = as_point(start, "start"), as_point(end, "end")
    require_positive(radius, "radius")
    length = float(np.linalg.norm(b - a))
    require_positive(length, "length")
    head = min(5.0 * radius, 0.6 * length)
    wide = ARROW_HEAD * radius * head / (5.0 * radius)
    shaft = min(radius, 0.6 * wide)
    neck = length - head
    slope = np.array([head, wide]) / math.hypot(head, wide)
    # every edge stands twice, once with the normal of either side, so that it stays sharp
    profile = [
        [0, 0],
        [shaft, 0],
        [shaft, 0],
        [shaft, neck],
        [shaft, neck],
        [wide, neck],
        [wide, neck],
        [0, length],
    ]
    slopes = [[0, -1], [0, -1], [1, 0], [1, 0], [0, -1], [0, -1], slope, slope]
    return turn(np.array(profile, dtype=float), np.array(slopes, dtype=float), a, b - a)


def turn(
    profile: NDArray[np.float64],
    slopes: NDArray[np.float64],
    origin: NDArray[np.float64],
    axis: NDArray[np.float64],
    segments: int = SEGMENTS,
) -> Shape:
    """Turns a profile of (distance from the axis, height along it) into a surface around the axis.

    `slopes` are its normals in the same plane. An axis of no length stands for z.
    """
    length = np.linalg.norm(axis)
    along = axis / length if length > 0.0 else np.array([0.0, 0.0, 1.0])
    helper = np.eye(3)[np.abs(along).argmin()]
    first = np.cross(along, helper)
    first /= np.linalg.norm(first)
    angle = np.arange(segments) * 2 * math.pi / segments
    ring = np.cos(angle)[:, None] * first + np.sin(angle)[:, None] * np.cross(along, first)
    vertices = profile[:, :1, None] * ring + profile[:, 1:, None] * along + origin
    normals = slopes[:, :1, None] * ring + slopes[:, 1:, None] * along
    j, i = np.meshgrid(np.arange(len(profile) - 1), np.arange(segments), indexing="ij")
    a, b = j * segments + i, j * segments + (i + 1) % segments
    c, d = b + segments, a + segments
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    return Shape(
        vertices.reshape(-1, 3).astype(np.float32),
        normals.reshape(-1, 3).astype(np.float32),
        triangles.astype(np.uint32),
    )


def as_point(value: ArrayLike, name: str) -> NDArray[np.float64]:
    point = np.asarray(value, dtype=float)
    if point.shape != (3,) or not np.isfinite(point).all():
        raise ValueError(f"{name} must be three finite numbers, got {value!r}")
    return point


def require_positive(value: float, name: str) -> None:
    if not (math.isfinite(value) and value > 0.0):
        raise ValueError(f"{name} must be positive, got {value!r}")


def sharpen(x: NDArray[np.float64], triangles: NDArray[np.integer], sharp: float = SHARP) -> Shape:
    """Normals that are smooth where a surface is round, and not across its edges.

    A corner's normal is the mean, by area, of the triangles round its vertex that are turned by
    less than `sharp` [rad] from its own.
    """
    a, b, c = (x[triangles[:, k]] for k in range(3))
    area = np.cross(b - a, c - a)
    unit = area / np.maximum(np.linalg.norm(area, axis=1, keepdims=True), 1e-30)
    vertex = triangles.ravel()
    corner, other = pair_corners(vertex, len(x))
    alike = np.einsum("ij,ij->i", unit[corner // 3], unit[other // 3]) > math.cos(sharp)
    normals = np.zeros((len(vertex), 3))
    np.add.at(normals, corner[alike], area[other[alike] // 3])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    rows = np.column_stack([vertex, np.round(normals / ROUND)])
    _, first, inverse = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    return Shape(
        x[vertex[first]].astype(np.float32),
        normals[first].astype(np.float32),
        inverse.reshape(-1, 3).astype(np.uint32),
    )


def pair_corners(
    vertex: NDArray[np.integer], count: int
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Each corner of a triangle with each that is at the same of `count` vertices, itself too."""
    by_vertex = np.argsort(vertex, kind="stable")
    times = np.bincount(vertex, minlength=count)
    first = np.concatenate([[0], np.cumsum(times)[:-1]])
    around = times[vertex]
    corner = np.repeat(np.arange(len(vertex)), around)
    number = np.arange(len(corner)) - np.repeat(np.cumsum(around) - around, around)
    return corner, by_vertex[first[vertex[corner]] + number]
