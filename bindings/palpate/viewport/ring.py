# SPDX-License-Identifier: BSD-3-Clause
"""Thin tubes over a surface: the ring of a brush, and lines that mark places."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from palpate.render import Shape

AROUND, ACROSS = 72, 8


def build_ring(centre: ArrayLike, normal: ArrayLike, radius: float, thickness: float) -> Shape:
    """A ring of `radius` [m] around `centre` [m], across `normal`; `thickness` [m] of its tube."""
    axis = np.asarray(normal, dtype=float)
    axis = axis / np.linalg.norm(axis)
    first = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    first /= np.linalg.norm(first)
    second = np.cross(axis, first)
    u = np.arange(AROUND)[:, None, None] * 2 * math.pi / AROUND
    v = np.arange(ACROSS)[None, :, None] * 2 * math.pi / ACROSS
    outward = np.cos(u) * first + np.sin(u) * second
    normals = (np.cos(v) * outward + np.sin(v) * axis).reshape(-1, 3)
    vertices = np.broadcast_to(radius * outward, (AROUND, ACROSS, 3)).reshape(-1, 3)
    vertices = vertices + thickness * normals + np.asarray(centre, dtype=float)
    return Shape(
        vertices.astype(np.float32), normals.astype(np.float32), list_triangles(AROUND, True)
    )


def build_tube(points: ArrayLike, outward: ArrayLike, closed: bool, thickness: float) -> Shape:
    """A tube along `points` [m] (n, 3) on a surface, whose normals there are `outward`, (n, 3);
    `thickness` [m] is its radius. Closed, its last point is joined to its first."""
    x = np.asarray(points, dtype=float)
    along = np.roll(x, -1, axis=0) - np.roll(x, 1, axis=0) if closed else np.gradient(x, axis=0)
    side = np.cross(along, np.asarray(outward, dtype=float))
    side /= np.maximum(np.linalg.norm(side, axis=1, keepdims=True), 1e-12)
    up = np.cross(side, along)
    up /= np.maximum(np.linalg.norm(up, axis=1, keepdims=True), 1e-12)
    v = np.arange(ACROSS)[None, :, None] * 2 * math.pi / ACROSS
    normals = (np.cos(v) * side[:, None] + np.sin(v) * up[:, None]).reshape(-1, 3)
    vertices = np.repeat(x, ACROSS, axis=0) + thickness * normals
    return Shape(
        vertices.astype(np.float32), normals.astype(np.float32), list_triangles(len(x), closed)
    )


@cache
def list_triangles(count: int, closed: bool) -> NDArray[np.uint32]:
    """Of a tube with so many points along it; the array belongs to all."""
    last = count if closed else count - 1
    i, j = np.meshgrid(np.arange(last), np.arange(ACROSS), indexing="ij")
    a, b = i * ACROSS + j, (i + 1) % count * ACROSS + j
    c, d = (i + 1) % count * ACROSS + (j + 1) % ACROSS, i * ACROSS + (j + 1) % ACROSS
    return np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3).astype(np.uint32)
