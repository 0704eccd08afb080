# SPDX-License-Identifier: GPL-3.0-or-later
"""Patches over holes have edges of 0.5 to 2 times those of the rim beside them."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from damaged_shapes import damage
from palpate_editor import authoring
from palpate_editor.document import EMPTY, Surface
from palpate_editor.edits import import_file
from palpate_editor.edits.even_patch import even_patches
from palpate_editor.edits.fill_holes import fill


def open_shape(shape: str, seed: int) -> Surface:
    x, t = damage(shape, "holes", seed)
    used, rows = np.unique(t, return_inverse=True)
    return Surface(1e-3 * x[used], rows.reshape(-1, 3).astype(np.int32))


def list_edges(triangles: np.ndarray) -> np.ndarray:
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return np.sort(sides, axis=1)


def compare_edges(surface: Surface, closed: Surface, loop: list[int]) -> np.ndarray:
    """[-] Of each inner edge of a patch, how long it is beside the edges of the rim, of which
    near ones count by the square of their distance."""
    x, rim = closed.vertices, np.array(loop)
    lengths = np.linalg.norm(x[rim] - x[np.roll(rim, -1)], axis=1)
    at = 0.5 * (lengths + np.roll(lengths, 1))
    every, times = np.unique(
        list_edges(closed.triangles[len(surface.triangles) :]), axis=0, return_counts=True
    )
    inner = every[times == 2]
    middles = x[inner].mean(axis=1)
    weights = 1.0 / np.maximum(((middles[:, None] - x[rim]) ** 2).sum(axis=2), 1e-18)
    wanted = (weights * at).sum(axis=1) / weights.sum(axis=1)
    return np.linalg.norm(x[inner[:, 0]] - x[inner[:, 1]], axis=1) / wanted


def check_patches(surface: Surface, skip: int = 0) -> int:
    """How many patches there were."""
    filled = 0
    for hole, loop in enumerate(palpate.find_border_loops(surface.triangles)):
        if skip and len(loop) > skip:
            continue
        closed = fill(surface, [hole], even=True)
        if closed is surface:
            continue
        filled += 1
        ratios = compare_edges(surface, closed, loop)
        assert ratios.size == 0 or (ratios.min() >= 0.5 and ratios.max() <= 2.0), (hole, ratios)
        check_kept(surface, closed)
    return filled


def check_kept(surface: Surface, closed: Surface) -> None:
    """What was there is there still, first and in its order; what is new is sound."""
    assert np.array_equal(closed.vertices[: len(surface.vertices)], surface.vertices)
    assert np.array_equal(closed.triangles[: len(surface.triangles)], surface.triangles)
    mesh = palpate.SurfaceMesh(closed.vertices, closed.triangles)
    palpate.validate(mesh)
    before = palpate.SurfaceMesh(surface.vertices, surface.triangles)
    crossing = [len(authoring.find_self_intersecting_faces(m)) for m in (before, mesh)]
    assert crossing[1] <= crossing[0]


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("shape", ["torus", "sphere", "spleen"])
def test_edges_of_a_patch_are_as_long_as_those_of_its_rim(shape, seed):
    assert check_patches(open_shape(shape, seed)) > 0


@pytest.mark.landing
@pytest.mark.parametrize(
    "name", ["hra_VH_F_Urinary_Bladder.glb", "vtkdata_Torso.vtp", "VH_F_Pancreas.glb",
             "gca_EdinGCA_3D_00020_small-intestine.vtk"],
)  # fmt: skip
def test_so_are_those_of_torn_rims_of_real_organs(name, shared_data):
    surface = import_file(shared_data(f"organs/{name}"))(EMPTY).surface

    assert check_patches(surface, skip=100) > 0


def test_a_patch_that_is_even_already_stays_as_it_is():
    surface = open_shape("sphere", 0)
    closed = fill(surface, [0], even=False)
    ratios = compare_edges(surface, closed, palpate.find_border_loops(surface.triangles)[0])
    assert ratios.min() >= 0.5 and ratios.max() <= 2.0

    evened = even_patches(closed, len(surface.vertices), len(surface.triangles))

    assert evened is closed


def test_the_same_hole_is_filled_with_the_same_bits():
    surface = open_shape("torus", 2)

    one, other = (fill(surface, [1], even=True) for _ in range(2))

    assert np.array_equal(one.vertices, other.vertices)
    assert np.array_equal(one.triangles, other.triangles)


def test_without_asking_a_patch_is_as_it_always_was():
    surface = open_shape("torus", 2)
    mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)

    old, found = fill(surface, [1], even=False), authoring.fill_holes(mesh, [1]).mesh

    assert np.array_equal(old.vertices, found.vertices)
    assert not np.array_equal(fill(surface, [1], even=True).triangles, old.triangles)
