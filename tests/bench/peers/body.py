# SPDX-License-Identifier: BSD-3-Clause
"""The common work: one shell of springs, pressed by a ball, the same for every engine.

An ellipsoid of exactly n vertices and 3n - 6 edges, half axes 5 x 3.5 x 3 cm. Every edge is a
spring of 21.65 N/m (a sheet of E h = 25 N/m as a triangular lattice) with a dashpot; every vertex
is drawn home by a twentieth of that, so that the shell pushes back; its lowest twentieth is held. A
ball of 5 mm comes from above, 1 cm deep within 0.2 s, and stays there.

NumPy and SciPy only: every engine's environment has them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

HALF_AXES = np.array([0.05, 0.035, 0.03])
"""[m]"""
STIFFNESS = np.sqrt(3.0) / 2.0 * 25.0
"""[N/m] of an edge."""
HOME_SHARE = 0.05
MASS = 1050.0 * 4.0 / 3.0 * np.pi * HALF_AXES.prod()
"""[kg] of all."""
RADIUS, DEPTH, CLEARANCE = 5e-3, 1e-2, 1e-3
"""[m] of the ball: its size, how deep it goes, and how far above it begins."""
PRESS_TIME = 0.2
"""[s]"""
WINDOW = (0.15, 0.2)
"""[s] The part of the press over which force and cost are measured."""
TETHER = 0.01
"""[m]"""


@dataclass(frozen=True)
class Body:
    """Springs between points. Of engines that know only one stiffness, tethers hold it."""

    x: NDArray[np.float64]
    """[m] (p, 3): the vertices, then the outer ends of tethers."""
    vertices: int
    triangles: NDArray[np.int32]
    edges: NDArray[np.int32]
    """(e, 2), those of tethers at the end."""
    fixed: NDArray[np.int32]
    home: float
    """[N/m] per vertex."""
    mass: float
    """[kg] of a vertex."""
    damping: float
    """[N·s/m] of an edge, along it."""

    @property
    def free(self) -> NDArray[np.bool_]:
        free = np.ones(len(self.x), dtype=bool)
        free[self.fixed] = False
        return free


def build_body(n: int, tethered: bool = False) -> Body:
    """The shell; with `tethered`, springs of the edges' stiffness instead of homes.

    Every fortieth vertex and one of its neighbours share a point 1 cm below the surface: as many
    newtons per metre and vertex, from the same springs.
    """
    k = np.arange(n) + 0.5
    height, angle = 1.0 - 2.0 * k / n, np.pi * (1.0 + np.sqrt(5.0)) * k
    across = np.sqrt(1.0 - height**2)
    sphere = np.stack([across * np.cos(angle), across * np.sin(angle), height], axis=1)
    triangles = ConvexHull(sphere).simplices.astype(np.int32)
    a, b, c = (sphere[triangles[:, i]] for i in range(3))
    inward = (np.cross(b - a, c - a) * a).sum(axis=1) < 0.0
    triangles[inward] = triangles[inward][:, ::-1]
    x = sphere * HALF_AXES
    fixed = np.sort(np.argsort(x[:, 2])[: max(3, n // 20)]).astype(np.int32)
    if tethered:
        x, triangles, fixed = add_tethers(x, sphere, triangles, fixed)
    sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]],
                                    triangles[:, [2, 0]]]), axis=1)  # fmt: skip
    edges = np.unique(sides, axis=0).astype(np.int32)
    return Body(
        x=x,
        vertices=n,
        triangles=triangles,
        edges=edges,
        fixed=fixed,
        home=0.0 if tethered else HOME_SHARE * STIFFNESS,
        mass=MASS / n,
        damping=0.2 * np.sqrt(STIFFNESS * MASS / n),
    )


def add_tethers(x, sphere, triangles, fixed):
    every = int(round(2.0 / HOME_SHARE))
    normals = sphere / HALF_AXES
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    from_vertex = np.arange(0, len(x), every)
    # a side of the first triangle that has the vertex
    neighbour = np.empty(len(from_vertex), dtype=np.int32)
    for row, v in enumerate(from_vertex):
        corners = triangles[(triangles == v).any(axis=1)][0]
        neighbour[row] = corners[corners != v][0]
    ends = x[from_vertex] - TETHER * normals[from_vertex]
    names = np.arange(len(x), len(x) + len(ends), dtype=np.int32)
    tethers = np.stack([from_vertex.astype(np.int32), neighbour, names], axis=1)
    return (
        np.concatenate([x, ends]),
        np.concatenate([triangles, tethers]),
        np.concatenate([fixed, names]),
    )


def place_ball(time: float) -> float:
    """[m] height of the ball's centre."""
    start = HALF_AXES[2] + RADIUS + CLEARANCE
    return start - (DEPTH + CLEARANCE) * min(time / PRESS_TIME, 1.0)


class ForceMeter:
    """What the ball pushes with, from positions alone, so that every engine is read alike.

    The momentum of the free vertices changes by the pull of their homes, of the springs to what is
    held, and of the ball: m dv/dt = pulls + ball. Averaged over the window.
    """

    def __init__(self, body: Body):
        self.body = body
        free = body.free
        held = free[body.edges[:, 0]] != free[body.edges[:, 1]]
        edges = body.edges[held]
        # the free end first
        swap = ~free[edges[:, 0]]
        edges[swap] = edges[swap][:, ::-1]
        self.edges = edges
        self.rest = np.linalg.norm(body.x[edges[:, 1]] - body.x[edges[:, 0]], axis=1)
        self.free = free
        self.pulls: list[float] = []
        self.momenta: list[tuple[float, float]] = []

    def read(self, time: float, before: NDArray, after: NDArray, dt: float) -> None:
        """Positions [m] (p, 3) at a time and one step later."""
        body = self.body
        d = before[self.edges[:, 1]] - before[self.edges[:, 0]]
        length = np.linalg.norm(d, axis=1)
        springs = (STIFFNESS * (length - self.rest) * d[:, 2] / length).sum()
        homes = -body.home * (before - body.x)[self.free, 2].sum()
        self.pulls.append(float(springs + homes))
        speed = (after - before)[self.free, 2].sum() / dt
        self.momenta.append((time, float(body.mass * speed)))

    def force(self) -> float:
        """[N] downwards, mean over what was read."""
        (t0, p0), (t1, p1) = self.momenta[0], self.momenta[-1]
        return -((p1 - p0) / (t1 - t0) - float(np.mean(self.pulls)))
