# SPDX-License-Identifier: GPL-3.0-or-later
"""What a brush means: in reach, in sight, and of one piece with what was hit."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate_editor.brush import (
    build_neighbours,
    compute_falloff,
    grow,
    select_linked,
    shrink,
    smooth,
    stamp,
)
from palpate_meshes.generate import ellipsoid

DOWN = np.array([0.0, 0.0, -1.0])


def grid(n: int, height: float = 0.0, up: bool = True) -> tuple[np.ndarray, np.ndarray]:
    """A flat sheet of n x n vertices, 1 m apart, that faces up or down."""
    x, y = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    vertices = np.column_stack((x.ravel(), y.ravel(), np.full(n * n, height))).astype(float)
    first = (n * np.arange(n - 1)[:, None] + np.arange(n - 1)).ravel()
    a, b, c, d = first, first + n, first + n + 1, first + 1
    triangles = np.concatenate((np.column_stack((a, b, c)), np.column_stack((a, c, d))))
    return vertices, (triangles if up else triangles[:, ::-1]).astype(np.int32)


def stack(*sheets: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Several surfaces as one, joined nowhere."""
    counts = np.cumsum([0, *(len(v) for v, _ in sheets)])
    return (
        np.concatenate([v for v, _ in sheets]),
        np.concatenate([t + k for (_, t), k in zip(sheets, counts, strict=False)]),
    )


def paint(surface, hit, radius, direction=DOWN, **options) -> set[int]:
    """Ids a brush means where a ray from far away, through `hit`, comes first."""
    vertices, triangles = surface
    normals = np.asarray(palpate.compute_vertex_normals(vertices, triangles))
    tree = palpate.AabbTree(vertices, triangles)
    hit = np.asarray(hit, float)
    found = palpate.find_ray_hit(tree, vertices, hit - 9.0 * direction, direction)
    neighbours = build_neighbours(triangles, len(vertices))
    ids = stamp(vertices, normals, triangles, neighbours, found.triangle, np.array(found.point),
                radius, direction, **options)  # fmt: skip
    return set(ids.tolist())


def walk(surface, seed, allowed) -> set[int]:
    """A flood fill as one would write it first, to hold the quick one against."""
    reached, front = set(), [i for i in seed if allowed[i]]
    beside: dict[int, set[int]] = {}
    for a, b, c in surface[1].tolist():
        for i, j in ((a, b), (b, c), (c, a)):
            beside.setdefault(i, set()).add(j)
            beside.setdefault(j, set()).add(i)
    while front:
        i = front.pop()
        if i not in reached:
            reached.add(i)
            front += [j for j in beside[i] if allowed[j]]
    return reached


def test_neighbours_are_those_an_edge_joins():
    neighbours = build_neighbours(np.array([[0, 1, 2], [2, 1, 3]]), vertex_count=5)

    rows = [neighbours.of(np.array([i])).tolist() for i in range(5)]

    assert rows == [[1, 2], [0, 2, 3], [0, 1, 3], [1, 2], []]
    assert neighbours.of(np.array([0, 3])).tolist() == [1, 2, 1, 2]
    assert neighbours.of(np.array([], int)).tolist() == []


def test_an_empty_surface_has_no_neighbours():
    assert build_neighbours(np.empty((0, 3), np.int32)).count == 0


def test_a_brush_means_what_lies_within_its_radius():
    ids = paint(grid(11), (5.1, 5.0, 0.0), 1.45)

    assert ids == {11 * i + j for i in (4, 5, 6) for j in (4, 5, 6)} - {11 * 4 + 4, 11 * 4 + 6}


def test_a_brush_never_paints_through_a_thin_wall():
    outer, inner = grid(11, 0.01), grid(11, 0.0, up=False)  # 1 cm of wall under a brush of 3 m
    wall = stack(outer, inner)

    ids = paint(wall, (5.1, 5.0, 0.01), 3.0)

    assert ids and max(ids) < 121


def test_a_brush_never_paints_a_second_skin_behind_the_first():
    skins = stack(grid(11, 0.01), grid(11, 0.0))  # both face the viewer

    assert max(paint(skins, (5.1, 5.0, 0.01), 3.0)) < 121
    assert max(paint(skins, (5.1, 5.0, 0.01), 3.0, connected=False)) >= 121


def test_a_brush_reaches_what_faces_away_only_when_asked_to():
    wall = stack(grid(11, 0.01), grid(11, 0.0, up=False))

    both = paint(wall, (5.1, 5.0, 0.01), 3.0, front_only=False, connected=False)

    assert max(both) >= 121
    assert max(paint(wall, (5.1, 5.0, 0.01), 3.0, front_only=True, connected=False)) < 121


def test_a_brush_does_not_jump_over_a_fold():
    vertices, triangles = grid(11)
    vertices[:, 2] = -4.0 * np.minimum(np.abs(vertices[:, 0] - 5.0) % 5, 1.0)  # a ridge at x = 5
    vertices[vertices[:, 0] == 5, 2] = -40.0  # and a chasm in its middle

    ids = paint((vertices, triangles), (3.1, 5.0, 0.0), 3.5)

    assert ids and vertices[list(ids), 0].max() < 5.0


def test_a_click_between_vertices_means_the_closest_one():
    assert paint(grid(5), (2.2, 2.1, 0.0), 0.01) == {5 * 2 + 2}


@pytest.mark.parametrize("seed", range(5))
def test_a_stamp_is_what_a_plain_flood_finds(seed):
    rng = np.random.default_rng(seed)
    surface = vertices, triangles = ellipsoid(vertices=400, seed=seed)
    normals = np.asarray(palpate.compute_vertex_normals(vertices, triangles))
    direction = rng.normal(size=3)
    direction /= np.linalg.norm(direction)
    triangle = int(rng.integers(len(triangles)))
    hit = vertices[triangles[triangle]].mean(axis=0)
    radius = 0.4 * np.ptp(vertices, axis=0).max()

    ids = stamp(vertices, normals, triangles, build_neighbours(triangles), triangle, hit, radius,
                direction)  # fmt: skip

    allowed = (np.linalg.norm(vertices - hit, axis=1) < radius) & (normals @ direction < 0)
    if allowed[triangles[triangle]].any():
        assert set(ids.tolist()) == walk(surface, triangles[triangle].tolist(), allowed)
    else:
        assert len(ids) >= 1


def test_falloff_is_one_in_the_middle_and_nothing_at_the_rim():
    x = np.array([[0.0, 0, 0], [0.5, 0, 0], [1.0, 0, 0]])
    ids = np.arange(3)

    soft = compute_falloff(x, ids, np.zeros(3), 1.0)

    assert soft.tolist() == [1.0, 0.5, 0.0]
    assert compute_falloff(x, ids, np.zeros(3), 1.0, falloff=0.0).tolist() == [1.0, 1.0, 1.0]
    assert compute_falloff(x, ids, np.zeros(3), 1.0, falloff=0.5).tolist() == [1.0, 1.0, 0.0]


def test_linked_is_the_whole_piece_and_no_other():
    vertices, triangles = stack(grid(3), grid(3, 1.0))

    assert select_linked(np.array([4]), build_neighbours(triangles)).tolist() == list(range(9))


def test_growing_and_shrinking_move_the_rim_by_one_edge():
    neighbours = build_neighbours(grid(7)[1])
    one = np.array([7 * 3 + 3])

    grown = grow(one, neighbours)

    assert grown.tolist() == sorted([24, 17, 31, 23, 25, 16, 32])
    assert shrink(grown, neighbours).tolist() == one.tolist()
    assert shrink(np.arange(49), neighbours).tolist() == list(range(49))


def test_smoothing_moves_towards_the_mean_of_the_neighbours():
    neighbours = build_neighbours(np.array([[0, 1, 2]]), vertex_count=4)
    values = np.array([1.0, 3.0, 5.0, 7.0])

    assert smooth(values, np.array([0]), neighbours, 1.0).tolist() == [4.0]
    assert smooth(values, np.array([0, 1]), neighbours, 0.5).tolist() == [2.5, 3.0]
    assert smooth(values, np.array([3]), neighbours).tolist() == [7.0]  # nobody beside it
