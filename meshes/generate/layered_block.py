# SPDX-License-Identifier: BSD-3-Clause
"""A block of skin, fat and muscle with a lump hidden in the fat."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

Array = np.ndarray
SKIN, FAT, MUSCLE = 0.002, 0.012, 0.015
"""[m] Thickness of each layer, from above."""
SIDE, ACROSS = 0.072, 12
"""[m] of the block along x and y, and its cells there."""
TOP = MUSCLE + FAT + SKIN
"""[m] Height of the surface."""
HEIGHTS = (0.0, MUSCLE / 2, MUSCLE, MUSCLE + FAT / 3, MUSCLE + 2 * FAT / 3, MUSCLE + FAT, TOP)
"""[m] Of the layers of nodes."""


@dataclass(frozen=True)
class Lump:
    """A ball of other tissue, which grows into the one around it over a quarter of its radius."""

    centre: tuple[float, float, float]
    """[m]"""
    radius: float
    """[m]"""


LUMP = Lump((0.015, -0.012, MUSCLE + 0.006), 0.006)
"""In the middle of the fat, 8 mm under the surface, beside the middle of the block."""
EDGE = 0.25
"""[-] of the lump's radius, over which it passes into what is around it."""


def layered_block() -> tuple[Array, Array]:
    """A box of tetrahedra, six to a cell, around the axis of z from z = 0 up.

    Returns:
        Vertices [m], shape (n, 3), and tetrahedra, shape (t, 4), of positive volume.
    """
    steps = SIDE * (np.arange(ACROSS + 1) / ACROSS - 0.5)
    z, y, x = np.meshgrid(np.array(HEIGHTS), steps, steps, indexing="ij")
    points = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    stride = np.array([1, ACROSS + 1, (ACROSS + 1) ** 2])
    rows = []
    for cell in itertools.product(range(ACROSS), range(ACROSS), range(len(HEIGHTS) - 1)):
        first = int(stride @ cell)
        for way in itertools.permutations(range(3)):
            row = [first, *(first + np.cumsum(stride[list(way)]))]
            # three turns of the axes keep the sense, three swaps reverse it
            if way in ((0, 2, 1), (1, 0, 2), (2, 1, 0)):
                row[1], row[2] = row[2], row[1]
            rows.append(row)
    return points, np.array(rows, np.int64)


def find_layer_values(points: Array, values: tuple[float, float, float]) -> Array:
    """(...) of skin, fat and muscle at points (..., 3) [m]; on the face of two, their mean."""
    skin, fat, muscle = values
    z = points[..., 2]
    near = 1e-9
    found = np.where(z > MUSCLE + FAT, skin, np.where(z > MUSCLE, fat, muscle))
    found = np.where(np.abs(z - MUSCLE) < near, 0.5 * (fat + muscle), found)
    return np.where(np.abs(z - MUSCLE - FAT) < near, 0.5 * (skin + fat), found)


def find_lump_share(points: Array, lump: Lump = LUMP) -> Array:
    """[-] (...) 1 in the lump, 0 outside of it, at points (..., 3) [m]."""
    distance = np.linalg.norm(points - np.asarray(lump.centre), axis=-1)
    inside = (lump.radius * (1.0 + 0.5 * EDGE) - distance) / (lump.radius * EDGE)
    return np.clip(inside, 0.0, 1.0)
