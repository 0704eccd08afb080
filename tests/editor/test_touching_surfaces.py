# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that touch themselves are parted there; specks and fins go, the rest stays."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from broken_twins import build_voxels
from palpate_editor.authoring import cut_crowded_edges, inspect_mesh, repair_mesh
from palpate_meshes.generate import ellipsoid
from small_meshes import CORNERS, CUBE, inside_out, mesh_of, scaled, together


def voxels(solid: np.ndarray) -> palpate.SurfaceMesh:
    """The surface of voxels of 1 cm, with the vertices of neighbours shared."""
    return mesh_of(*build_voxels(solid, 0.01))


def diagonal_cubes() -> palpate.SurfaceMesh:
    """Two cubes that share an edge: four triangles at it."""
    solid = np.zeros((2, 2, 1), bool)
    solid[0, 0, 0] = solid[1, 1, 0] = True
    return voxels(solid)


@pytest.mark.parametrize("turned", [False, True], ids=["outward", "inside out"])
def test_solids_that_touch_along_an_edge_are_parted_there(turned):
    cubes = inside_out(diagonal_cubes()) if turned else diagonal_cubes()
    assert inspect_mesh(cubes).non_manifold_edges == 1

    repaired = repair_mesh(cubes)

    assert repaired.parted_edges == 1
    report = inspect_mesh(repaired.mesh)
    assert (report.non_manifold_edges, report.self_intersecting_faces) == (0, 0)
    assert (report.shells, report.closed, report.outward) == (2, True, True)
    assert report.volume_ml == pytest.approx(2.0, rel=1e-3)
    palpate.validate(repaired.mesh)
    # as far apart as it says, and no other vertex has moved
    assert len(repaired.mesh.vertices) == len(cubes.vertices) + 2
    before = {tuple(p) for p in np.asarray(cubes.vertices).tolist()}
    moved = [p for p in np.asarray(repaired.mesh.vertices).tolist() if tuple(p) not in before]
    assert len(moved) == 4
    corner = 0.01
    away = [np.linalg.norm(np.array(p[:2]) - corner) for p in moved]
    diagonal = 0.01 * np.sqrt(4 + 4 + 1)
    assert max(away) <= 1e-4 * diagonal * (1 + 1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_a_segmentation_that_touches_itself_along_edges_becomes_a_manifold(seed):
    random = np.random.default_rng(seed)
    solid = random.random((7, 7, 7)) < 0.35
    mesh = voxels(solid)
    assert inspect_mesh(mesh).non_manifold_edges > 10

    repaired = repair_mesh(mesh)

    report = inspect_mesh(repaired.mesh)
    assert (report.non_manifold_edges, report.closed, report.outward) == (0, True, True)
    # where it touches in a single edge between corners that touch as well, a few folds are left
    assert report.self_intersecting_faces <= 0.02 * report.triangles
    assert report.volume_ml == pytest.approx(float(solid.sum()), rel=2e-3)
    palpate.validate(repaired.mesh)


def test_copies_of_a_split_vertex_are_no_crossing():
    """Two pyramids that touch at their tips, taken apart there."""
    tip, base = [0.0, 0, 0], [[1.0, 1, 1], [-1, 1, 1], [-1, -1, 1], [1, -1, 1]]
    other = [[x, y, -z] for x, y, z in base]
    upper = [[0, i + 1, (i + 1) % 4 + 1] for i in range(4)] + [[1, 3, 2], [1, 4, 3]]
    lower = [[0, 5 + (i + 1) % 4, 5 + i] for i in range(4)] + [[5, 6, 7], [5, 7, 8]]
    mesh = mesh_of(0.01 * np.array([tip, *base, *other]), upper + lower)

    repaired = repair_mesh(mesh)

    assert repaired.split_vertices == 1
    assert inspect_mesh(repaired.mesh).self_intersecting_faces == 0


def test_a_speck_is_dropped_and_a_small_piece_stays():
    organ = mesh_of(*ellipsoid(150, hollow=0.0, bow=0.0))
    whole = palpate.compute_diagonal(organ.vertices)
    cube = mesh_of(CORNERS + 1.0, CUBE)
    size = palpate.compute_diagonal(cube.vertices)
    speck, piece = (scaled(cube, share * whole / size) for share in (5e-4, 5e-3))
    apart = mesh_of(np.asarray(piece.vertices) - 0.9, piece.triangles)
    near = mesh_of(np.asarray(speck.vertices) - 0.95, speck.triangles)

    repaired = repair_mesh(together(organ, near, apart))

    assert repaired.dropped_islands == 1
    assert inspect_mesh(repaired.mesh).shells == 2


def test_a_fin_is_cut_off_and_the_surface_goes_on():
    """A wall of two triangles stands on a flat sheet of two."""
    sheet_and_wall = mesh_of(
        [[0, 0, 0], [1, 0, 0], [0.5, 1, 0], [0.5, -1, 0], [0.5, 0.1, 1]],
        [[0, 1, 2], [1, 0, 3], [0, 1, 4]],
    )
    cut = cut_crowded_edges(sheet_and_wall)

    report = inspect_mesh(cut)
    assert (report.non_manifold_edges, report.shells) == (0, 2)
    assert sorted(report.border_loops) == [3, 4]
    assert report.self_intersecting_faces == 0
    palpate.validate(repair_mesh(cut).mesh)
