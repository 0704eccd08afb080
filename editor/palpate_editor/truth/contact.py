# SPDX-License-Identifier: GPL-3.0-or-later
"""Frictionless contact of a rigid ball with a body whose response is linear.

The body is condensed to the surface nodes that the ball may touch: how far each of them sinks
along the press under a force along the press on each. What is left is a small problem of one
unilateral condition per point of the surface, solved for every depth. Displacements are small:
the force acts along the press, and the ball is a column over every point.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import scipy.sparse as sparse
from numpy.typing import NDArray

from palpate_editor.truth.tetrahedra import Floats, Ints

PENALTY = 1e4
"""Of E*/R: the stiffness of the contact. At a pressure of E* ball and body overlap by R/PENALTY."""
NEWTON_MAX = 80
EDGE_POINTS = 65
"""Points of an edge at which the first touch is tried."""


@dataclass(frozen=True)
class Patch:
    """The part of a surface that a ball may touch, over m nodes and q points."""

    compliance: Floats
    """[m/N] (m, m): how far a node sinks along the press under a force on another."""
    shape: sparse.csr_matrix
    """(q, m): displacement at the points from that of the nodes."""
    area: Floats
    """[m²] (q,) that belongs to a point, seen along the press."""
    gap: Floats
    """[m] (q,) from the surface to a ball that just touches the body, along the press."""
    nodes: Ints = field(default_factory=lambda: np.empty(0, np.int64))
    """(m,) which of the body's nodes they are."""
    beside: Floats = field(default_factory=lambda: np.empty(0))
    """[m] (q,) of the points from the axis of the press."""


@dataclass(frozen=True)
class Contact:
    depth: float
    """[m] of the ball beyond its first touch."""
    force: float
    """[N] along the press."""
    radius: float
    """[m] of the circle that has the area of the contact, or to its farthest point."""
    push: Floats
    """[N] (m,) on the nodes of a patch, against the direction of the press."""
    on: NDArray[np.bool_]
    """(q,) the points that are touched."""


class NoContact(Exception):
    """The active set did not settle."""


def press_ball(patch: Patch, depths: Floats, stiffness: float) -> list[Contact]:
    """Force and contact at ascending depths [m]; `stiffness` [N/m³] is that of the penalty.

    p = stiffness max(0, depth - gap - W A f), f = W^T (area p): semi-smooth Newton on f.

    Raises:
        NoContact: where the active set does not settle.
    """
    force = np.zeros(len(patch.compliance))
    found = []
    for depth in np.asarray(depths).tolist():
        force, on = settle(patch, depth, stiffness, force)
        radius = float(np.sqrt(patch.area[on].sum() / np.pi))
        found.append(Contact(depth, float(force.sum()), radius, force, on))
    return found


def settle(patch: Patch, depth: float, stiffness: float, force: Floats) -> tuple[Floats, Floats]:
    """Newton, as far along every step as lowers the energy, which is convex."""
    shape, sink = patch.shape, patch.shape @ patch.compliance
    one = np.eye(len(force))

    def measure(f: Floats) -> tuple[float, Floats]:
        overlap = np.maximum(depth - patch.gap - sink @ f, 0.0)
        stored = 0.5 * f @ (patch.compliance @ f)
        return float(stored + 0.5 * stiffness * (patch.area * overlap**2).sum()), overlap

    energy, overlap = measure(force)
    for _ in range(NEWTON_MAX):
        weight = stiffness * patch.area * (overlap > 0.0)
        left = shape.T @ (weight * overlap) - force
        step = np.linalg.solve(one + (shape.T @ sparse.diags(weight)) @ sink, left)
        part = 1.0
        before = energy
        while part > 1e-6:
            energy, overlap = measure(force + part * step)
            if energy <= before * (1.0 + 1e-12):
                break
            part *= 0.5
        force = force + part * step
        if np.abs(step).sum() < 1e-7 * np.abs(force).sum():
            return force, overlap > 0.0
    raise NoContact(f"no active set after {NEWTON_MAX} steps at {1e3 * depth:g} mm")


def find_gap(offset: Floats, direction: Floats, radius: float, touch: float) -> Floats:
    """[m] from points to a ball whose centre is `touch` over the place, against the press.

    Args:
        offset: [m] (q, 3) from the place.
        direction: Unit (3,), outward.
        radius: [m] of the ball; points beside it are infinitely far below.
        touch: [m] Height of the centre at first touch.
    """
    height = offset @ direction
    beside = ((offset - height[:, None] * direction) ** 2).sum(axis=1)
    with np.errstate(invalid="ignore"):
        reach = np.sqrt(radius**2 - beside)
    return np.where(beside < radius**2, touch - height - reach, np.inf)


def find_touch(x: Floats, triangles: Ints, point: Floats, direction: Floats, r: float) -> float:
    """[m] Height over the place of a ball's centre when it first touches a surface on its way.

    The ball comes along the axis through `point`. It touches a facet where the facet's plane is a
    tangent of it, or an edge, whose points are tried one by one.
    """
    height = (x - point) @ direction
    side = x - point - height[:, None] * direction
    reach = 3.0 * r + find_edge(x, triangles)
    near = np.linalg.norm(side[triangles].mean(axis=1), axis=1) < reach
    a, b, c = (x[triangles[near][:, k]] - point for k in range(3))
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    found = [touch_facets(a, b, c, normal, direction, r)]
    part = np.linspace(0.0, 1.0, EDGE_POINTS)[:, None, None]
    for p, q in ((a, b), (b, c), (c, a)):
        tried = (p + part * (q - p)).reshape(-1, 3)
        found.append(-find_gap(tried, direction, r, 0.0))
    return float(max(np.max(f, initial=-np.inf) for f in found))


def find_edge(x: Floats, triangles: Ints) -> float:
    """[m] The longest edge."""
    return float(
        max(
            np.linalg.norm(x[triangles[:, k]] - x[triangles[:, k - 1]], axis=1).max()
            for k in range(3)
        )
    )


def touch_facets(
    a: Floats, b: Floats, c: Floats, normal: Floats, direction: Floats, r: float
) -> Floats:
    """[m] Height of a centre on the axis that is r over each facet's plane; -inf beside it."""
    facing = normal @ direction
    ahead = facing > 1e-3
    a, b, c, normal, facing = (part[ahead] for part in (a, b, c, normal, facing))
    height = ((a * normal).sum(axis=1) + r) / facing
    foot = height[:, None] * direction - r * normal
    inside = np.ones(len(a), dtype=bool)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= (np.cross(q - p, foot - p) * normal).sum(axis=1) >= -1e-15
    return height[inside]
