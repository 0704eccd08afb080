# SPDX-License-Identifier: BSD-3-Clause
"""The few triangles that settling leaves thin: their corners are moved one by one."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from palpate_meshes.generate.field import Array
from palpate_meshes.generate.relax import (
    compute_normals,
    find_border_vertices,
    flip_edges,
    measure,
)

SWEEPS = 24
GOOD = 0.94
"""[-] Triangles with a cost below this are left alone; 1 is the worst the gate lets through."""
COS_SMALLEST, COS_LARGEST = 0.866, -0.342
"""Of 30 and of 110 degrees."""
AROUND = np.array([(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if x or y], float)
REACHES = (0.25, 0.08, 0.025)
"""[-] Of the edges around a vertex: how far it is moved, in one try after the other."""

Settle = Callable[[Array, float], Array]


def repair_triangles(points: Array, triangles: Array, settle: Settle) -> tuple[Array, Array]:
    """Moves corners of thin triangles along the surface while the worst around them gets better.

    Args:
        points: (n, 3)
        triangles: (t, 3)
        settle: Puts points back onto the surface, moving none farther than a length.
    """
    points = points.copy()
    fixed = set(find_border_vertices(triangles).tolist())
    for sweep in range(SWEEPS):
        bad = np.unique(triangles[compute_costs(points, triangles) > GOOD])
        moved = 0
        for vertex in bad.tolist():
            if vertex not in fixed:
                reach = REACHES[sweep % len(REACHES)]
                moved += move_vertex(points, triangles, vertex, reach, settle)
        triangles, flips = flip_edges(points, triangles)
        if not moved and not flips and sweep >= len(REACHES):
            break
    return points, triangles


def move_vertex(points: Array, triangles: Array, vertex: int, reach: float, settle: Settle) -> bool:
    """Moves one vertex to the best of some places around it; whether that is better than here."""
    star = triangles[(triangles == vertex).any(axis=1)]
    rest = star[star != vertex]
    edge = float(measure(points[rest] - points[vertex]).mean())
    n = compute_normals(points, star).sum(axis=0)
    aside = np.eye(3)[int(np.abs(n).argmin())]
    u = np.cross(n, aside)
    v = np.cross(n, u)
    u, v = (w / measure(w[None]) for w in (u, v))
    tries = points[vertex] + reach * edge * (AROUND[:, :1] * u + AROUND[:, 1:] * v)
    tries = settle(tries, reach * edge)
    here = compute_costs(points, star).max()
    old = points[vertex].copy()
    best = None
    for place in tries:
        points[vertex] = place
        cost = compute_costs(points, star).max()
        if cost < here - 1e-6 and faces(compute_normals(points, star), n):
            here, best = cost, place
    points[vertex] = old if best is None else best
    return best is not None


def faces(normals: Array, n: Array) -> bool:
    """Whether all of the normals are on the side of n."""
    return bool(((normals * n).sum(axis=1) > 0.0).all())


def compute_costs(points: Array, triangles: Array) -> Array:
    """How bad each triangle's angles are: 1 where one of them is only just allowed."""
    worst = np.full(len(triangles), -np.inf)
    for i in range(3):
        here = points[triangles[:, i]]
        u = points[triangles[:, (i + 1) % 3]] - here
        v = points[triangles[:, (i + 2) % 3]] - here
        dot = u[:, 0] * v[:, 0] + u[:, 1] * v[:, 1] + u[:, 2] * v[:, 2]
        cosine = dot / np.maximum(measure(u) * measure(v), np.finfo(float).tiny)
        worst = np.maximum(worst, np.maximum(cosine / COS_SMALLEST, cosine / COS_LARGEST))
    return worst
