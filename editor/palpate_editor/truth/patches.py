# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a P2 body's surface that a ball may touch, and how it responds there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sparse

from palpate_editor.truth.cholesky import Factor
from palpate_editor.truth.contact import Patch, find_gap
from palpate_editor.truth.elasticity import Body, Press
from palpate_editor.truth.tetrahedra import Floats, Ints, find_surface

BLOCK = 128
"""Loads that are solved for at once."""
FACING = 0.15
"""Cosine between a facet's normal and the press, at least."""
DEEP = 1.8
"""Of the ball's radius: how far from the place a facet may lie."""
# Dunavant's seven points, exact to degree five
POINTS = np.array(
    [[1 / 3, 1 / 3, 1 / 3]]
    + [
        np.roll([1 - 2 * a, a, a], k).tolist()
        for a in (0.470142064105115, 0.101286507323456)
        for k in range(3)
    ]
)
WEIGHTS = np.array([0.225] + 3 * [0.132394152788506] + 3 * [0.125939180544827])


@dataclass(frozen=True)
class Footprint:
    """Facets under a ball: the nodes of their points and what area belongs to each."""

    nodes: Ints
    """(q, 6) of the body, three corners and the middles after them."""
    shape: Floats
    """(q, 6) P2 shape functions."""
    position: Floats
    """[m] (q, 3) at rest."""
    area: Floats
    """[m²] (q,) of the surface at rest."""
    facing: Floats
    """(q,) Cosine between the facet's normal and the press."""


def find_footprint(
    body: Body, point: Floats, direction: Floats, reach: float, radius: float
) -> Footprint:
    """Facets that face the press and have a corner within `reach` [m] of its axis."""
    x = body.basis.mesh.p.T
    faces = find_surface(body.basis.mesh.t.T)
    corners = x[faces] - point
    height = corners @ direction
    beside = np.linalg.norm(corners - height[..., None] * direction, axis=2).min(axis=1)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = 0.5 * np.linalg.norm(normal, axis=1)
    # find_surface gives the corners as the tetrahedron has them: outward where those turn right
    facing = normal @ direction / (2.0 * area)
    near = np.linalg.norm(corners, axis=2).min(axis=1) < DEEP * radius
    on = (beside < reach) & (facing > FACING) & near
    nodes = find_nodes(body, faces[on])
    shape = compute_shapes(POINTS)
    count, each = int(on.sum()), len(POINTS)
    return Footprint(
        np.repeat(nodes, each, axis=0),
        np.tile(shape, (count, 1)),
        np.einsum("qk,fkd->fqd", POINTS, x[faces[on]]).reshape(-1, 3),
        (area[on][:, None] * WEIGHTS).ravel(),
        np.repeat(facing[on], each),
    )


def compute_shapes(weights: Floats) -> Floats:
    """(q, 6) P2 shape functions of a triangle at barycentric weights (q, 3)."""
    middles = [4.0 * weights[:, [i]] * weights[:, [j]] for i, j in ((0, 1), (1, 2), (2, 0))]
    return np.concatenate([weights * (2.0 * weights - 1.0), *middles], axis=1)


def find_nodes(body: Body, faces: Ints) -> Ints:
    """The six nodes of triangles that are given by their vertices."""
    mesh, basis = body.basis.mesh, body.basis
    ends = np.sort(mesh.edges.T, axis=1).astype(np.int64)
    count = mesh.p.shape[1]
    keys = ends[:, 0] * count + ends[:, 1]
    order = np.argsort(keys)
    nodes = [basis.nodal_dofs[0][faces]]
    for i, j in ((0, 1), (1, 2), (2, 0)):
        pair = np.sort(faces[:, [i, j]], axis=1).astype(np.int64)
        found = order[np.searchsorted(keys[order], pair[:, 0] * count + pair[:, 1])]
        nodes.append(basis.edge_dofs[0][found][:, None])
    return np.concatenate(nodes, axis=1)


def condense(
    press: Press,
    print_: Footprint,
    point: Floats,
    direction: Floats,
    radius: float,
    touch: float,
    told: Callable[[float], None] = lambda part: None,
) -> Patch:
    """The body condensed to the nodes of a footprint, along the press, with the gap of a ball.

    `told` hears after every block of loads which part of them [-] is solved, and may raise.
    """
    at = find_freedoms(press, print_)
    values = np.broadcast_to(direction, at.shape)
    compliance = find_compliance(press.factor, at, values, told)
    return lay_ball(press, print_, compliance, point, direction, radius, touch)


def condense_whole(
    press: Press, print_: Footprint, told: Callable[[float], None] = lambda part: None
) -> Floats:
    """[m/N] (3m, 3m) of the nodes of a footprint, axis by axis of each."""
    at = find_freedoms(press, print_).reshape(-1, 1)
    return find_compliance(press.factor, at, np.ones(at.shape), told)


def place_ball(
    press: Press,
    print_: Footprint,
    whole: Floats,
    point: Floats,
    direction: Floats,
    radius: float,
    touch: float,
) -> Patch:
    """As condense, from the compliance of all axes."""
    count = len(whole) // 3
    along = np.einsum("iajb,a,b->ij", whole.reshape(count, 3, count, 3), direction, direction)
    return lay_ball(press, print_, along, point, direction, radius, touch)


def find_touched(press: Press, print_: Footprint) -> Ints:
    """(m,) The free nodes of a footprint."""
    touched = np.unique(print_.nodes)
    return touched[np.isin(touched, press.free)]


def find_freedoms(press: Press, print_: Footprint) -> Ints:
    """(m, 3) Rows of the stiffness that the nodes of a footprint have."""
    touched = find_touched(press, print_)
    return 3 * np.searchsorted(press.free, touched)[:, None] + np.arange(3)


def lay_ball(
    press: Press,
    print_: Footprint,
    compliance: Floats,
    point: Floats,
    direction: Floats,
    radius: float,
    touch: float,
) -> Patch:
    """A patch of nodes of known compliance, with the gap of a ball to its points."""
    touched = find_touched(press, print_)
    number = np.full(press.body.node_count, -1)
    number[touched] = np.arange(len(touched))
    rows = np.repeat(np.arange(len(print_.nodes)), 6)
    columns = number[print_.nodes].ravel()
    values = np.where(columns >= 0, print_.shape.ravel(), 0.0)
    shape = sparse.csr_matrix(
        (values, (rows, np.maximum(columns, 0))), shape=(len(print_.nodes), len(touched))
    )
    offset = print_.position - point
    gap = find_gap(offset, direction, radius, touch)
    beside = np.linalg.norm(offset - np.outer(offset @ direction, direction), axis=1)
    kept = np.isfinite(gap)
    area = (print_.area * print_.facing)[kept]
    return Patch(compliance, shape[kept], area, gap[kept], touched, beside[kept])


def find_compliance(
    factor: Factor, freedoms: Ints, values: Floats, told: Callable[[float], None]
) -> Floats:
    """[m/N] (m, m) of loads: the one with row k has values[k] at freedoms[k], both (m, few).

    Half of each solution is enough for the products of all with all, and most of it is nothing:
    a load is felt along its way to the root of the elimination alone.
    """
    count = len(freedoms)
    halves: list[tuple[Ints, Floats]] = []
    for first in range(0, count, BLOCK):
        part = slice(first, min(first + BLOCK, count))
        loads = np.zeros((factor.size, part.stop - first))
        for column in range(freedoms.shape[1]):
            loads[freedoms[part, column], np.arange(part.stop - first)] = values[part, column]
        half = factor.halve(loads)
        rows = np.flatnonzero(half.any(axis=1))
        halves.append((rows, half[rows]))
        told(part.stop / count)
    known = np.unique(np.concatenate([rows for rows, _ in halves]))
    whole = np.zeros((len(known), count))
    for k, (rows, half) in enumerate(halves):
        whole[np.searchsorted(known, rows), k * BLOCK : k * BLOCK + half.shape[1]] = half
    return np.asarray(whole.T @ whole)
