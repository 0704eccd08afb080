# SPDX-License-Identifier: BSD-3-Clause
"""A sheet that is drawn over an organ and holds it to another, as peritoneum does."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

Array = np.ndarray
MARGIN = 1e-9
"""[m] By which a hull may dent inwards, for rounding."""


@dataclass(frozen=True)
class Sling:
    """Where a sheet lies, in a frame of its own: u along it, v across, w away from what it is
    fastened to."""

    origin: Array
    """[m] (3,)"""
    axes: Array
    """[-] (3, 3) rows u, v and w, a right-handed frame."""
    along: tuple[float, float]
    """[m] u of its free ends."""
    across: float
    """[m] |v| of the sides that are fastened."""
    spacing: float
    """[m] of its vertices."""


def sling(
    held: Array, below: Array, place: Sling, slab: float = 5e-3
) -> tuple[Array, Array, Array]:
    """Straight over what it holds: across each u the upper convex hull of what lies there.

    Args:
        held: [m] (n, 3) points that it must pass over.
        below: [m] (m, 3) points of what it is fastened to, over which its sides lie.
        place: Its frame and size.
        slab: [m] Half of the width in u in which points count.

    Returns:
        Vertices [m], shape (n, 3), triangles, shape (t, 3), counter-clockwise from above, and the
        vertices of the fastened sides, ascending.
    """
    over, under = ((points - place.origin) @ place.axes.T for points in (held, below))
    count = max(3, round((place.along[1] - place.along[0]) / place.spacing) + 1)
    sections = [find_section(over, under, u, slab, place) for u in np.linspace(*place.along, count)]
    lengths = [np.linalg.norm(np.diff(rows, axis=0), axis=1).sum() for rows in sections]
    steps = max(4, round(float(np.mean(lengths)) / place.spacing))
    rows = np.array([resample(rows, steps) for rows in sections])
    points = rows.reshape(-1, 3) @ place.axes + place.origin
    width = steps + 1
    i, j = np.meshgrid(np.arange(count - 1), np.arange(steps), indexing="ij")
    a = (i * width + j).ravel()
    b, c, d = a + width, a + width + 1, a + 1
    even = ((i + j) % 2 == 0).ravel()
    first = np.where(even[:, None], np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    second = np.where(even[:, None], np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    sides = np.sort(np.concatenate([np.arange(count) * width, np.arange(count) * width + steps]))
    return points, np.concatenate([first, second]), sides


def find_section(over: Array, under: Array, u: float, slab: float, place: Sling) -> Array:
    """[m] (k, 3) Corners of the hull at u in the sheet's frame, from side to side."""
    sides = []
    for v in (-place.across, place.across):
        near = under[np.argsort(np.hypot(under[:, 0] - u, under[:, 1] - v))[:3]]
        sides.append((v, float(near[:, 2].max())))
    here = over[np.abs(over[:, 0] - u) < slab]
    inside = here[np.abs(here[:, 1]) < place.across]
    corners = sorted([*sides, *map(tuple, inside[:, 1:])])
    hull: list[tuple[float, float]] = []
    for v, w in corners:
        while len(hull) > 1 and not turns_down(hull[-2], hull[-1], (v, w)):
            hull.pop()
        hull.append((v, w))
    return np.array([(u, *corner) for corner in hull])


def turns_down(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> bool:
    """Whether b stands above the line from a to c."""
    return (b[1] - a[1]) * (c[0] - a[0]) > (c[1] - a[1]) * (b[0] - a[0]) + MARGIN**2


def resample(corners: Array, steps: int) -> Array:
    """[m] (steps + 1, 3) as far apart from each other along a line of corners."""
    at = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(corners, axis=0), axis=1))])
    want = np.linspace(0.0, at[-1], steps + 1)
    return np.column_stack([np.interp(want, at, corners[:, k]) for k in range(3)])
