# SPDX-License-Identifier: BSD-3-Clause
"""Cutting a closed mesh open with a plane, as a surgeon cuts a duct."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from palpate_meshes.generate.field import DIGITS, Array, Field, Point, plane
from palpate_meshes.generate.relax import find_border_vertices

NEAR = 1e-3
"""[-] of an edge: vertices nearer to the plane than this are put on it."""


@dataclass(frozen=True)
class Opening:
    """A cut across a tube."""

    centre: Point
    """[mm] Where the axis of the tube meets the plane."""
    outward: Point
    """What lies on this side of the plane is thrown away."""
    reach: float
    """[mm] The plane is this large around its centre; farther parts of the organ are not cut."""
    vertices: int
    """Of the rim that is left."""


def cut_open(points: Array, triangles: Array, opening: Opening) -> tuple[Array, Array]:
    """The mesh without what lies beyond the opening, its rim in the plane."""
    height = plane(points, opening.centre, opening.outward)
    q = points - np.asarray(opening.centre, float)
    far = (q * q).sum(axis=1) > opening.reach * opening.reach
    height = np.where(far, -1.0, height)
    vertices = [tuple(row) for row in points.tolist()]
    made: dict[tuple[int, int], int] = {}

    def crossing(a: int, b: int) -> int:
        key = (min(a, b), max(a, b))
        if key not in made:
            t = height[key[0]] / (height[key[0]] - height[key[1]])
            t = min(max(float(t), NEAR), 1.0 - NEAR)
            p, q = vertices[key[0]], vertices[key[1]]
            made[key] = len(vertices)
            vertices.append(tuple(u + t * (v - u) for u, v in zip(p, q, strict=True)))
        return made[key]

    kept = []
    for corners in triangles.tolist():
        polygon = []
        for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
            if height[a] <= 0.0:
                polygon.append(a)
            if (height[a] <= 0.0) != (height[b] <= 0.0):
                polygon.append(crossing(a, b))
        kept += [(polygon[0], b, c) for b, c in zip(polygon[1:], polygon[2:], strict=False)]
    used, numbered = np.unique(np.array(kept), return_inverse=True)
    return np.array(vertices)[used], numbered.reshape(-1, 3)


def place_rim(points: Array, triangles: Array, field: Field, opening: Opening) -> Array:
    """The rim evenly around the centre of the cut, on plane and surface."""
    rim = find_border_vertices(triangles)
    u, v = span_plane(opening.outward)
    q = points[rim] - np.asarray(opening.centre, float)
    x, y = (q[:, 0] * e[0] + q[:, 1] * e[1] + q[:, 2] * e[2] for e in (u, v))
    order = np.argsort(np.arctan2(y, x), kind="stable")
    points = points.copy()
    for k, vertex in enumerate(rim[order]):
        angle = 2.0 * math.pi * (k + 0.5) / len(rim) - math.pi
        c, s = round(math.cos(angle), DIGITS), round(math.sin(angle), DIGITS)
        ray = np.array([c * a + s * b for a, b in zip(u, v, strict=True)])
        points[vertex] = march(field, np.asarray(opening.centre, float), ray, opening.reach)
    return points


def span_plane(normal: Point) -> tuple[Point, Point]:
    """Two unit vectors that span the plane, the first of them level."""
    length = math.sqrt(sum(a * a for a in normal))
    nx, ny, nz = (a / length for a in normal)
    level = math.sqrt(nx * nx + ny * ny)
    u = (ny / level, -nx / level, 0.0) if level > 1e-6 else (1.0, 0.0, 0.0)
    v = (ny * u[2] - nz * u[1], nz * u[0] - nx * u[2], nx * u[1] - ny * u[0])
    return u, v


def march(field: Field, start: Array, ray: Array, reach: float) -> Array:
    """Where a ray from inside leaves the organ, by bisection."""
    low, high = 0.0, reach
    for _ in range(50):
        mid = 0.5 * (low + high)
        if field((start + mid * ray)[None])[0] < 0.0:
            low = mid
        else:
            high = mid
    return start + low * ray
