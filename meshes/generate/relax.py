# SPDX-License-Identifier: BSD-3-Clause
"""Even triangles on a curved surface that is given as a map from a simpler one.

The mesh lives on the simple surface (a sphere, a plane) and is looked at on the organ, where its
triangles have to be well shaped. Counts never change here.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

Map = Callable[[np.ndarray], np.ndarray]

LEAST_EXCESS = 1e-3
"""[rad] Opposite angles this little over pi are rounding; flipping would go to and fro."""

LEAST_COSINE = 0.5
"""A flip turns no triangle by 60 degrees or more."""

STEP = 0.6
"""Of the way to the middle of the neighbours; all of it overshoots where everybody moves."""


def find_edges(triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Directed edges as in their first triangle, the two triangles (-1 on a border), and the two
    corners opposite."""
    corner = np.concatenate([triangles, triangles[:, [1, 2, 0]], triangles[:, [2, 0, 1]]])
    owner = np.tile(np.arange(len(triangles)), 3)
    key = number_edges(corner[:, 0], corner[:, 1], triangles.max(initial=0) + 1)
    order = np.argsort(key, kind="stable")
    first = np.flatnonzero(np.r_[True, np.diff(key[order]) != 0])
    paired = np.diff(np.r_[first, len(order)]) == 2
    second = np.where(paired, order[np.minimum(first + 1, len(order) - 1)], -1)
    first = order[first]
    sides = np.stack([owner[first], np.where(paired, owner[second], -1)], axis=1)
    apexes = np.stack([corner[first, 2], np.where(paired, corner[second, 2], -1)], axis=1)
    return corner[first, :2], sides, apexes


def find_border_vertices(triangles: np.ndarray) -> np.ndarray:
    """The vertices of every border loop, ascending."""
    edges, sides, _ = find_edges(triangles)
    return list_border(edges, sides)


def list_border(edges: np.ndarray, sides: np.ndarray) -> np.ndarray:
    """Vertices of the edges that have one triangle, ascending."""
    return np.unique(edges[sides[:, 1] < 0])


def compute_normals(x: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Normals of the triangles, twice their area long."""
    a, b, c = (x[triangles[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def compute_angles(x: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """[rad] The three angles of every triangle."""
    angles = []
    for i in range(3):
        here = x[triangles[:, i]]
        u, v = x[triangles[:, (i + 1) % 3]] - here, x[triangles[:, (i + 2) % 3]] - here
        angles.append(np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(axis=1)))
    return np.stack(angles, axis=1)


def compare_opposite(
    x: np.ndarray, one: np.ndarray, two: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """How far the angles at the first corners of two triangles are over pi together.

    Returns:
        Minus the sine of their sum, which is the excess itself where it is small (2 where the sum
        is over 3/2 pi); and the cosine, which grows with the sum from pi to 2 pi. Square roots are
        the same on every machine, arcs are not.
    """
    sines, cosines = [], []
    for corners in (one, two):
        here = x[corners[:, 0]]
        u, v = x[corners[:, 1]] - here, x[corners[:, 2]] - here
        sine, cosine = measure(np.cross(u, v)), u[:, 0] * v[:, 0] + u[:, 1] * v[:, 1]
        cosine = cosine + u[:, 2] * v[:, 2]
        length = np.maximum(np.sqrt(sine * sine + cosine * cosine), np.finfo(float).tiny)
        sines.append(sine / length)
        cosines.append(cosine / length)
    over = -(sines[0] * cosines[1] + cosines[0] * sines[1])
    cosine = cosines[0] * cosines[1] - sines[0] * sines[1]
    return np.where((over > 0.0) & (cosine > 0.0), 2.0, over), cosine


def measure(q: np.ndarray) -> np.ndarray:
    """Lengths of vectors (n, 3), rounded the same on every machine."""
    x, y, z = q.T
    return np.sqrt(x * x + y * y + z * z)


def flip_edges(x: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, int]:
    """One pass of Delaunay flips, the worst first; edges next to a flipped one wait."""
    edges, sides, apexes = find_edges(triangles)
    inner = np.flatnonzero(sides[:, 1] >= 0)
    u, v = edges[inner].T
    a, b = apexes[inner].T
    turn, excess = compare_opposite(x, np.stack([a, u, v], axis=1), np.stack([b, u, v], axis=1))
    one, two = np.stack([a, u, b], axis=1), np.stack([b, v, a], axis=1)
    before = compute_normals(x, triangles)
    mean = before[sides[inner]].sum(axis=1)
    agrees = np.ones(len(inner), bool)
    for corners in (one, two):
        n = compute_normals(x, corners)
        lengths = np.linalg.norm(n, axis=1) * np.linalg.norm(mean, axis=1)
        agrees &= (n * mean).sum(axis=1) > LEAST_COSINE * lengths
    valence = np.bincount(triangles.ravel(), minlength=len(x))
    valence[list_border(edges, sides)] += 2
    candidates = np.flatnonzero(
        (turn > LEAST_EXCESS) & agrees & (valence[u] > 3) & (valence[v] > 3)
    )

    # no two triangles may come to share an edge that is there already
    doubled = np.isin(number_edges(a, b, len(x)), number_edges(*edges.T, len(x)))
    candidates = candidates[~doubled[candidates]]
    changed = np.zeros(len(x), bool)
    flipped = triangles.copy()
    flips = 0
    for k in candidates[np.argsort(-excess[candidates], kind="stable")]:
        around = [u[k], v[k], a[k], b[k]]
        if changed[around].any():
            continue
        flipped[sides[inner[k]]] = one[k], two[k]
        changed[around] = True
        flips += 1
    return flipped, flips


def number_edges(a: np.ndarray, b: np.ndarray, count: int) -> np.ndarray:
    """A number for each pair of `count` vertices, whichever comes first."""
    return np.minimum(a, b).astype(np.int64) * count + np.maximum(a, b)


def find_displacement(x: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """From every vertex to the mean of its triangles' centres by area, along the surface."""
    normals = compute_normals(x, triangles)
    area = np.linalg.norm(normals, axis=1)
    centres = x[triangles].mean(axis=1)
    middle, normal, weight = np.zeros_like(x), np.zeros_like(x), np.zeros(len(x))
    for corner in triangles.T:
        np.add.at(middle, corner, centres * area[:, None])
        np.add.at(normal, corner, normals)
        np.add.at(weight, corner, area)
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    displacement = middle / weight[:, None] - x
    return displacement - (displacement * normal).sum(axis=1)[:, None] * normal


def pull_back(
    organ: Map, tangents: np.ndarray, at: np.ndarray, displacement: np.ndarray
) -> np.ndarray:
    """The step on the simple surface that the map turns into `displacement`, by least squares.

    Args:
        organ: From the simple surface to the organ.
        tangents: Two unit tangents of the simple surface per point, shape (n, 2, 3).
        at: Points of the simple surface.
        displacement: Steps on the organ.
    """
    h = 1e-5 * np.abs(at).max()
    columns = [(organ(at + h * t) - organ(at - h * t)) / (2 * h) for t in tangents.swapaxes(0, 1)]
    j = np.stack(columns, axis=2)
    normal_matrix = np.einsum("nij,nik->njk", j, j)
    step = np.linalg.solve(normal_matrix, np.einsum("nij,ni->nj", j, displacement)[:, :, None])[
        :, :, 0
    ]
    return np.einsum("nj,nji->ni", step, tangents)


def relax(
    points: np.ndarray,
    triangles: np.ndarray,
    organ: Map,
    tangents: Map,
    settle: Map,
    rounds: int,
) -> tuple[np.ndarray, np.ndarray]:
    """Rounds of flips and moves; border vertices stay.

    Args:
        points: On the simple surface.
        triangles: Between them.
        organ: From the simple surface to the organ.
        tangents: Two unit tangents of the simple surface per point, shape (n, 2, 3).
        settle: Back onto the simple surface after a step along its tangents.
        rounds: How many.

    Returns:
        Vertices on the organ, and triangles.
    """
    free = np.ones(len(points), bool)
    free[find_border_vertices(triangles)] = False
    for _ in range(rounds):
        for _ in range(3):
            triangles, flips = flip_edges(organ(points), triangles)
            if flips == 0:
                break
        displacement = STEP * find_displacement(organ(points), triangles)[free]
        here = points[free]
        points = points.copy()
        points[free] = settle(here + pull_back(organ, tangents(here), here, displacement))
    for _ in range(10):
        triangles, flips = flip_edges(organ(points), triangles)
        if flips == 0:
            break
    return organ(points), triangles
