# SPDX-License-Identifier: BSD-3-Clause
"""The dent under a ball as tissue has it, drawn in place of triangles that are larger than it is.

What is felt of a ball on coarse triangles is the dent that tissue would have [contact: near field];
the triangles themselves sink as one. So those around the ball are drawn in small pieces that are
moved down along the ball's path: where it touches, onto the ball, and around it as a half space
sinks beside a ball [Hertz82].
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

REACH = 3.0
"""[-] radii from the ball's axis, where the dent has run out."""
PIECES = 3.5
"""[-] of an edge, to a radius."""
MOST_PIECES, MOST_POINTS = 24, 24_000
"""Of an edge, and of a dent."""
LEAST, DEEPEST = 1e-3, 3.0
"""[-] radii: less is no dent, and more not one that this ball has made."""
FACING = 0.2
"""[-] cosine between a triangle and the dent it may belong to."""


@dataclass(frozen=True)
class DentPatch:
    """Pieces of triangles, each point by its place in one of them."""

    hidden: Rows
    """(h,) the triangles that are drawn in pieces."""
    corners: Rows
    """(p, 3) vertices of the triangle that each point lies in."""
    weights: Array
    """(p, 3) barycentric."""
    triangles: Rows
    """(t, 3) of the points."""
    position: Array
    """[m] (p, 3)"""
    normal: Array
    """(p, 3) unit."""
    openness: NDArray[np.float32]
    """[-] (p,) what is left of the sky: less the deeper a point has sunk beside the ball."""

    def carry(self, values: NDArray[np.float32]) -> NDArray[np.float32]:
        """What vertices have, (n,) or (n, k), at the points."""
        weights = self.weights.astype(np.float32)
        return np.einsum("pc,pc...->p...", weights, values[self.corners])


@dataclass(frozen=True)
class Ball:
    """With the axis of the dent, which points out of the tissue."""

    centre: Array
    radius: float
    axis: Array
    depth: float
    """[m] of its lowest point below the surface."""

    def sink(self, points: Array) -> Array:
        """[m] (p,) how far each point of the surface goes down."""
        away = points - self.centre
        height = away @ self.axis
        r = np.linalg.norm(away - height[:, None] * self.axis, axis=1)
        under = np.sqrt(np.maximum(self.radius**2 - r**2, 0.0))
        clear = np.where(r < self.radius, height + under, 0.0)
        touched = self.touched_radius
        rim = max(0.0, self.depth - self.radius + np.sqrt(self.radius**2 - touched**2))
        beside = rim * run_out(np.maximum(r / touched, 1.0)) * fade(r / self.radius)
        return np.maximum(np.where(r < touched, self.depth - self.radius + under, beside), clear)

    @property
    def touched_radius(self) -> float:
        """[m] sqrt(R d) at small depth [Hertz82], three quarters of R at 3R/2."""
        return self.radius * float(np.sqrt(self.depth / (self.radius + self.depth)))


def run_out(rho: Array) -> Array:
    """[-] A half space beside a ball, from 1 at the rim of what is touched [Johnson85, 3.42]."""
    inverse = 1.0 / rho
    return (2.0 / np.pi) * ((2.0 - rho**2) * np.arcsin(inverse) + np.sqrt(rho**2 - 1.0))


def fade(radii: Array) -> Array:
    """[-] From 1 at the ball to 0 where the dent has run out."""
    t = np.clip((REACH - radii) / (REACH - 1.0), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def build_dent(
    vertices: Array,
    normals: NDArray[np.floating],
    triangles: NDArray[np.integer],
    centre: Array,
    radius: float,
    edge: float,
) -> DentPatch | None:
    """The dent of a ball in a surface, None where it makes none.

    Args:
        vertices: [m] (n, 3)
        normals: (n, 3) unit.
        triangles: (t, 3)
        centre: [m] (3,) of the ball.
        radius: [m]
        edge: [m] the longest of the triangles, or nearly.
    """
    under = find_near(vertices, triangles, centre, radius + edge)
    ball = find_ball(vertices, triangles[under], centre, radius)
    if ball is None:
        return None
    hidden = find_dented(vertices, triangles, ball, edge)
    # of a mesh that is finer than that the triangles themselves show a dent
    if not 0 < len(hidden) <= MOST_POINTS // 3:
        return None
    pieces, places = count_pieces(vertices[triangles[hidden]], radius), triangles[hidden]
    weights, grid = cut_triangle(pieces)
    of_points = np.repeat(places, len(weights), axis=0)
    of_weights = np.tile(weights, (len(hidden), 1))
    points = np.einsum("pc,pck->pk", of_weights, vertices[of_points])
    smooth = np.einsum("pc,pck->pk", of_weights, normals[of_points].astype(np.float64))
    first, sunk = len(weights) * np.arange(len(hidden)), ball.sink(points)
    return DentPatch(
        hidden, of_points, of_weights, (first[:, None, None] + grid).reshape(-1, 3),
        points - sunk[:, None] * ball.axis, tilt(ball, points, smooth),
        (1.0 / (1.0 + sunk / radius)).astype(np.float32),
    )  # fmt: skip


def find_near(vertices: Array, triangles: NDArray[np.integer], centre: Array, reach: float) -> Rows:
    """The triangles with a vertex within reach [m]; of a surface nothing as large is made."""
    near = np.abs(vertices[:, 0] - centre[0]) < reach
    for axis in (1, 2):
        near &= np.abs(vertices[:, axis] - centre[axis]) < reach
    if not near.any():
        return np.zeros(0, np.intp)
    return np.flatnonzero(near[triangles[:, 0]] | near[triangles[:, 1]] | near[triangles[:, 2]])


def find_dented(vertices: Array, triangles: NDArray[np.integer], ball: Ball, edge: float) -> Rows:
    """The triangles that face the way of a dent and have a part in it, or nearly."""
    near = find_near(vertices, triangles, ball.centre, REACH * ball.radius + edge)
    corners = vertices[triangles[near]]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    away = np.linalg.norm(find_closest(corners, across, ball.centre) - ball.centre, axis=1)
    facing = across @ ball.axis > FACING * np.linalg.norm(across, axis=1)
    return near[facing & (away < (REACH + 0.5) * ball.radius)]


def find_ball(vertices: Array, triangles: Rows, centre: Array, radius: float) -> Ball | None:
    """The ball with what it presses: along the normals of what is near, those nearest most."""
    if not len(triangles):
        return None
    corners = vertices[triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    foot = find_closest(corners, across, centre)
    distance = np.linalg.norm(foot - centre, axis=1)
    size = np.linalg.norm(across, axis=1)
    usable = (size > 0.0) & (distance < DEEPEST * radius)
    if not usable.any():
        return None
    # the nearer, the more: all of what the nearest has, nothing half a radius farther
    share = np.maximum(1.0 - (distance - distance[usable].min()) / (0.5 * radius), 0.0) * usable
    axis = ((share / np.maximum(size, 1e-300))[:, None] * across).sum(axis=0)
    length = float(np.linalg.norm(axis))
    if not length > 0.0:
        return None
    axis /= length
    nearest = foot[np.argmin(np.where(usable, distance, np.inf))]
    depth = radius - float((centre - nearest) @ axis)
    if not LEAST * radius < depth < DEEPEST * radius:
        return None
    return Ball(np.asarray(centre, dtype=np.float64), radius, axis, depth)


def find_closest(corners: Array, across: Array, centre: Array) -> Array:
    """[m] (t, 3) of each triangle a point near the closest one: the foot, kept in the triangle."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    square = np.maximum(np.einsum("ij,ij->i", across, across), 1e-300)
    to = centre - a
    v = np.einsum("ij,ij->i", np.cross(to, c - a), across) / square
    w = np.einsum("ij,ij->i", np.cross(b - a, to), across) / square
    weights = np.maximum(np.stack([1.0 - v - w, v, w], axis=1), 0.0)
    weights /= weights.sum(axis=1, keepdims=True)
    return np.einsum("tc,tck->tk", weights, corners)


def count_pieces(corners: Array, radius: float) -> int:
    """Of every edge: as small as the ball asks for, and no more than can be drawn."""
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    wanted = int(np.ceil(PIECES * float(edges.max()) / radius))
    most = int(np.sqrt(2.0 * MOST_POINTS / len(corners)) - 1.5)
    return max(1, min(wanted, most, MOST_PIECES))


@cache
def cut_triangle(pieces: int) -> tuple[Array, Rows]:
    """Barycentric points (p, 3) of a triangle cut into pieces² alike, and their corners."""
    places = [(i, j) for i in range(pieces + 1) for j in range(pieces + 1 - i)]
    number = {place: k for k, place in enumerate(places)}
    weights = np.array([(pieces - i - j, i, j) for i, j in places], dtype=np.float64) / pieces
    rows = []
    for i, j in places:
        if i + j < pieces:
            rows.append((number[i, j], number[i + 1, j], number[i, j + 1]))
        if i + j < pieces - 1:
            rows.append((number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]))
    return weights, np.array(rows, dtype=np.intp)


def tilt(ball: Ball, points: Array, normals: Array) -> Array:
    """(p, 3) unit normals of what has sunk: turned by how fast that changes along the surface."""
    step = 0.02 * ball.radius
    first = np.cross(ball.axis, np.eye(3)[np.argmin(np.abs(ball.axis))])
    first /= np.linalg.norm(first)
    turned = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    for way in (first, np.cross(ball.axis, first)):
        along = way - (normals @ way)[:, None] * normals
        slope = (ball.sink(points + step * along) - ball.sink(points - step * along)) / (2 * step)
        turned = turned + slope[:, None] * way
    return turned / np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-300)
