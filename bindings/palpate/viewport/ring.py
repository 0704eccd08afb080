# SPDX-License-Identifier: BSD-3-Clause
"""The ring that shows where a brush would paint."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

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
    i, j = np.meshgrid(np.arange(AROUND), np.arange(ACROSS), indexing="ij")
    a, b = i * ACROSS + j, (i + 1) % AROUND * ACROSS + j
    c, d = (i + 1) % AROUND * ACROSS + (j + 1) % ACROSS, i * ACROSS + (j + 1) % ACROSS
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    return Shape(
        vertices.astype(np.float32), normals.astype(np.float32), triangles.astype(np.uint32)
    )
