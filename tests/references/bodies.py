# SPDX-License-Identifier: BSD-3-Clause
"""Bodies of tetrahedra that references are solved on: positions [m], (n, 3) and (t, 4)."""

from __future__ import annotations

from itertools import permutations

import numpy as np
from palpate_editor.truth.tetrahedra import Floats, Ints, finish


def build_ellipsoid(semi_axes: tuple[float, float, float], n: int) -> tuple[Floats, Ints]:
    """Eight tetrahedra about the centre, each cut into n³, blown up to an ellipsoid: 8 n³.

    Layers of the octahedron become layers of the ellipsoid; the sine makes its edges equal arcs.
    """
    points, cells = [], []
    for signs in np.ndindex(2, 2, 2):
        lattice, part = cut_tetrahedron(n)
        corner = np.where(np.array(signs), -1.0, 1.0)
        cells.append(part + sum(map(len, points)))
        points.append(lattice * corner)
    x, t = weld(np.vstack(points) / n, np.vstack(cells))
    layer = np.abs(x).sum(axis=1, keepdims=True)
    inside = layer[:, 0] > 0.0
    direction = np.sin(0.5 * np.pi * x[inside] / layer[inside])
    x[inside] = layer[inside] * direction / np.linalg.norm(direction, axis=1, keepdims=True)
    return finish(x * np.array(semi_axes), t)


def cut_tetrahedron(n: int) -> tuple[Floats, Ints]:
    """The tetrahedron of the origin and n times the axes, cut into n³ of one size.

    The cubes 0 <= w <= v <= u <= n, cut by Kuhn's six tetrahedra, are sheared into it.
    """
    index: dict[tuple[int, ...], int] = {}
    cells = []
    for cube in np.ndindex(n, n, n):
        for order in permutations(range(3)):
            corners = [np.array(cube)]
            for axis in order:
                corners.append(corners[-1] + np.eye(3, dtype=int)[axis])
            if all(c[0] >= c[1] >= c[2] for c in corners):
                cells.append([index.setdefault(tuple(map(int, c)), len(index)) for c in corners])
    u, v, w = np.array(list(index), dtype=float).T
    return np.stack([u - v, v - w, w], axis=1), np.array(cells)


def build_block(size: tuple[float, float, float], n: tuple[int, int, int]) -> tuple[Floats, Ints]:
    """A box from the origin, each of its cells cut by Kuhn's six tetrahedra."""
    axes = [np.linspace(0.0, s, m + 1) for s, m in zip(size, n, strict=True)]
    x = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    strides = np.array([(n[1] + 1) * (n[2] + 1), n[2] + 1, 1])
    base = np.stack(np.meshgrid(*map(np.arange, n), indexing="ij"), axis=-1).reshape(-1, 3)
    cells = []
    for order in permutations(range(3)):
        corners = [base]
        for axis in order:
            corners.append(corners[-1] + np.eye(3, dtype=int)[axis])
        cells.append(np.stack([c @ strides for c in corners], axis=1))
    return finish(x - np.array([size[0], size[1], 0.0]) / 2.0, np.vstack(cells))


def weld(x: Floats, t: Ints) -> tuple[Floats, Ints]:
    _, first, inverse = np.unique(np.round(x, 9), axis=0, return_index=True, return_inverse=True)
    return x[first], inverse.ravel()[t]


def build_layer(rings: list[float], levels: list[float]) -> tuple[Floats, Ints]:
    """A disc of the ring radii, 6 k points on ring k, stacked on levels of z from top to bottom."""
    flat, triangles = [np.zeros((1, 2))], []
    for k, radius in enumerate(rings[1:], start=1):
        angle = 2.0 * np.pi * np.arange(6 * k) / (6 * k)
        start, inner = sum(map(len, flat)), sum(map(len, flat[:-1]))
        flat.append(radius * np.stack([np.cos(angle), np.sin(angle)], axis=1))
        for six in range(6):
            out = [start + (six * k + i) % (6 * k) for i in range(k + 1)]
            into = [inner + (six * (k - 1) + i) % max(6 * (k - 1), 1) for i in range(k)]
            triangles += [(into[i], out[i], out[i + 1]) for i in range(k)]
            triangles += [(into[i], out[i + 1], into[i + 1]) for i in range(k - 1)]
    disc = np.vstack(flat)
    count = len(disc)
    x = np.vstack([np.column_stack([disc, np.full(count, z)]) for z in levels])
    cells = []
    for level in range(len(levels) - 1):
        for triangle in triangles:
            # cut by vertex number, so that neighbours cut the sides between them alike
            a, b, c = (level * count + i for i in sorted(triangle))
            cells += [(a, b, c, c + count), (a, b, b + count, c + count)]
            cells.append((a, a + count, b + count, c + count))
    return finish(x, np.array(cells))
