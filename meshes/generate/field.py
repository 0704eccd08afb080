# SPDX-License-Identifier: BSD-3-Clause
"""Shapes as signed fields: negative inside, about a distance near the surface, lengths in mm.

A field takes points (n, 3) [mm] and gives (n,) [mm]. Nothing here but + - * /, square roots and
comparisons, which IEEE 754 rounds alike everywhere: the same organ is the same bytes on every
machine. Sines, powers and matrix products would not be, so they are not used.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np
from palpate_meshes.generate.relax import measure

Array = np.ndarray
Field = Callable[[Array], Array]
Point = Sequence[float]
Nodes = tuple[tuple[float, ...], ...]
Turn = tuple[tuple[float, float, float], ...]

SLACK = 1e-6
"""[mm] Much more than rounding."""
DIGITS = 12
"""Sines and cosines of given angles are rounded to this, where all mathematics libraries agree."""


def smooth_min(a: Array, b: Array, k: Array | float) -> Array:
    """The lesser, rounded off over the length k [mm] (polynomial smooth minimum)."""
    h = np.maximum(k - np.abs(a - b), 0.0) / k
    return np.minimum(a, b) - h * h * k * 0.25


def join(a: Array, b: Array, k: Array | float) -> Array:
    """Both shapes, grown together over k [mm]."""
    return smooth_min(a, b, k)


def cut(a: Array, b: Array, k: Array | float) -> Array:
    """The first without the second, the rim rounded over k [mm]."""
    return -smooth_min(-a, b, k)


def keep(a: Array, b: Array, k: Array | float) -> Array:
    """What is in both, the rim rounded over k [mm]."""
    return -smooth_min(-a, -b, k)


def turn_about(axis: Point, degrees: float) -> Turn:
    """The rotation about an axis, as rows (Rodrigues)."""
    length = math.sqrt(sum(a * a for a in axis))
    x, y, z = (a / length for a in axis)
    s = round(math.sin(math.radians(degrees)), DIGITS)
    c = round(math.cos(math.radians(degrees)), DIGITS)
    t = 1.0 - c
    return (
        (t * x * x + c, t * x * y - s * z, t * x * z + s * y),
        (t * x * y + s * z, t * y * y + c, t * y * z - s * x),
        (t * x * z - s * y, t * y * z + s * x, t * z * z + c),
    )


def apply_turn(turn: Turn, p: Array) -> Array:
    x, y, z = p.T
    return np.stack([r[0] * x + r[1] * y + r[2] * z for r in turn], axis=1)


def invert_turn(turn: Turn) -> Turn:
    (a, b, c), (d, e, f), (g, h, i) = turn
    return ((a, d, g), (b, e, h), (c, f, i))


def ball(p: Array, centre: Point, radius: float) -> Array:
    return measure(p - np.asarray(centre, float)) - radius


def ellipsoid_field(
    p: Array, centre: Point, radii: Point, turn: Turn | None = None, square: float = 0.0
) -> Array:
    """An ellipsoid, or with `square` up to 1 one that is nearer to a box (quartic).

    Its distance to first order: k (k - 1) over half the slope of k².
    """
    q = p - np.asarray(centre, float)
    if turn is not None:
        q = apply_turn(invert_turn(turn), q)
    r = np.asarray(radii, float)
    u = q / r
    round_k = measure(u)
    slope = measure(u / r)
    inner = -float(r.min())
    distance = np.where(round_k < 1e-9, inner, round_k * (round_k - 1.0) / np.maximum(slope, 1e-12))
    if square == 0.0:
        return distance
    fourth = u * u
    fourth = fourth * fourth
    boxy_k = np.sqrt(np.sqrt(fourth[:, 0] + fourth[:, 1] + fourth[:, 2]))
    k = (1.0 - square) * round_k + square * boxy_k
    return np.where(round_k < 1e-9, inner, round_k * (k - 1.0) / np.maximum(slope, 1e-12))


def rod(p: Array, a: Point, b: Point, ra: float, rb: float | None = None) -> Array:
    """A capsule between two points whose radius [mm] goes from ra to rb."""
    return rods(p, np.array([[*a, ra], [*b, ra if rb is None else rb]], float))


def rods(p: Array, nodes: Array) -> Array:
    """Distance to the nearest of the rods between each two rows (x, y, z, radius) that follow each
    other, (points,)."""
    x, y, z, r = (column[:, None] for column in nodes.T)
    u, v, w = (column[1:] - column[:-1] for column in (x, y, z))
    qx, qy, qz = (p[:, axis] - column[:-1] for axis, column in enumerate((x, y, z)))
    t = (qx * u + qy * v + qz * w) / (u * u + v * v + w * w)
    t = np.minimum(np.maximum(t, 0.0), 1.0)
    qx, qy, qz = qx - t * u, qy - t * v, qz - t * w
    apart = np.sqrt(qx * qx + qy * qy + qz * qz) - (r[:-1] + (r[1:] - r[:-1]) * t)
    return np.asarray(apart.min(axis=0))


def tube_field(p: Array, nodes: Nodes, steps: int = 8) -> Array:
    """A ball swept along a Catmull-Rom spline through rows (x, y, z, radius) [mm]."""
    spine, pieces, around = cut_spline(nodes, steps)
    nearest = np.full(len(p), np.inf)
    # a piece that cannot be the nearest is left out, which changes no bit of what comes out
    at_most = balls(p, spine[::steps]).min(axis=0)
    for piece, near_piece in zip(pieces, balls(p, around) <= at_most + SLACK, strict=True):
        near = np.flatnonzero(near_piece)
        if len(near) > 0:
            nearest[near] = np.minimum(nearest[near], rods(p[near], piece))
    return nearest


def balls(p: Array, rows: Array) -> Array:
    """Distance to each of balls (x, y, z, radius), (balls, points)."""
    x, y, z, r = (column[:, None] for column in rows.T)
    dx, dy, dz = p[:, 0] - x, p[:, 1] - y, p[:, 2] - z
    return np.asarray(np.sqrt(dx * dx + dy * dy + dz * dz) - r)


@lru_cache(maxsize=64)
def cut_spline(nodes: Nodes, steps: int) -> tuple[Array, list[Array], Array]:
    """The points of draw_spline; those of each of its pieces; and a ball around each piece."""
    spine = draw_spline(nodes, steps)
    pieces = [spine[first : first + steps + 1] for first in range(0, len(spine) - 1, steps)]
    around = []
    for piece in pieces:
        middle = piece[steps // 2][:3]
        around.append([*middle, max(math.dist(middle, row[:3]) + row[3] for row in piece)])
    return np.array(spine), [np.array(piece) for piece in pieces], np.array(around)


@lru_cache(maxsize=64)
def draw_spline(nodes: Nodes, steps: int) -> list[list[float]]:
    """Points on the Catmull-Rom spline through nodes of any dimension, ends included."""
    rows = [[float(v) for v in node] for node in nodes]
    first = [2.0 * a - b for a, b in zip(rows[0], rows[1], strict=True)]
    last = [2.0 * a - b for a, b in zip(rows[-1], rows[-2], strict=True)]
    rows = [first, *rows, last]
    drawn = []
    for p0, p1, p2, p3 in zip(rows, rows[1:], rows[2:], rows[3:], strict=False):
        for step in range(steps):
            t = step / steps
            drawn.append(
                [
                    0.5
                    * (
                        2.0 * b
                        + (c - a) * t
                        + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t
                        + (3.0 * b - a - 3.0 * c + d) * t * t * t
                    )
                    for a, b, c, d in zip(p0, p1, p2, p3, strict=True)
                ]
            )
    return [*drawn, rows[-2]]


def plane(p: Array, point: Point, outward: Point) -> Array:
    """Half the space, on the side that `outward` turns its back to."""
    length = math.sqrt(sum(a * a for a in outward))
    n = [a / length for a in outward]
    q = p - np.asarray(point, float)
    return q[:, 0] * n[0] + q[:, 1] * n[1] + q[:, 2] * n[2]


def ramp(x: Array, low: float, high: float) -> Array:
    """0 below low, 1 above high, smooth between."""
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


@lru_cache(maxsize=8)
def draw_heights(seed: int, size: int) -> Array:
    """Random numbers of -1 to 1, (size, size, size)."""
    return np.random.default_rng(seed).random((size, size, size)) * 2.0 - 1.0


def bumps(p: Array, height: float, length: float, seed: int) -> Array:
    """Hills of about `height` [mm], `length` [mm] apart, others for each seed (value noise)."""
    size = 32
    heights = draw_heights(seed, size)
    q = p / length + 0.5 * size
    floor = np.floor(q)
    t = q - floor
    t = t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
    i, j, k = floor.astype(np.int64).T % size
    i1, j1, k1 = (i + 1) % size, (j + 1) % size, (k + 1) % size
    x, y, z = t.T

    def along_x(jj: Array, kk: Array) -> Array:
        return heights[i, jj, kk] * (1.0 - x) + heights[i1, jj, kk] * x

    low = along_x(j, k) * (1.0 - y) + along_x(j1, k) * y
    high = along_x(j, k1) * (1.0 - y) + along_x(j1, k1) * y
    return height * (low * (1.0 - z) + high * z)
