# SPDX-License-Identifier: GPL-3.0-or-later
"""Patches over holes turn by less than 30 degrees from the triangles at the rim that allow it."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate_editor.document import EMPTY, Surface
from palpate_editor.edits import import_file
from palpate_editor.edits.bend_patch import MOST_TURN, Rim, bend_patches, find_excess
from palpate_editor.edits.even_patch import Patch
from palpate_editor.edits.fill_holes import fill
from test_even_patch import check_kept, compare_edges, open_shape
from test_fill_holes import ball, cut, ends


def measure_turns(surface: Surface, closed: Surface) -> list[float]:
    """[degree] Of the edges of rims that allow a patch to go on smoothly."""
    patch = Patch(closed, len(surface.vertices), len(surface.triangles))
    return list(Rim(patch, surface).list_turns(patch).values())


def make_dented() -> tuple[Surface, Surface]:
    """A ball with a hole at its end, and the same with a patch pushed in."""
    surface = cut(ball(), (ends(ball())[0], 0.2))
    closed = fill(surface, [0], even=True)
    x, count = closed.vertices.copy(), len(surface.vertices)
    edge = np.linalg.norm(x[surface.triangles[:, 0]] - x[surface.triangles[:, 1]], axis=1).mean()
    middle = surface.vertices.mean(axis=0)
    inwards = middle - x[count:].mean(axis=0)
    x[count:] += 0.7 * edge * inwards / np.linalg.norm(inwards)
    return surface, Surface(x, closed.triangles)


def test_a_patch_that_is_pushed_in_is_bent_out_to_go_on_as_the_rim_does():
    surface, dented = make_dented()
    before = measure_turns(surface, dented)

    bent = bend_patches(dented, surface)

    assert len(before) > 10 and max(before) > MOST_TURN + 10.0
    assert max(measure_turns(surface, bent)) < MOST_TURN
    excess = [
        find_excess(Patch(each, len(surface.vertices), len(surface.triangles)))
        for each in (dented, bent)
    ]
    assert excess[1] <= max(1.0, excess[0])
    check_kept(surface, bent)


def test_a_patch_that_goes_on_smoothly_stays_as_it_is():
    surface = open_shape("sphere", 0)
    closed = fill(surface, [0], even=True)

    assert bend_patches(closed, surface) is closed


def test_an_edge_allows_no_smooth_patch_where_the_next_leaves_its_plane():
    # a box without its lid: at each rim the next side stands upright on it
    x = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)], float)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4)]
    rows = [t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))]
    surface = Surface(x, np.array(rows, np.int32))
    closed = fill(surface, [0], even=False)
    patch = Patch(closed, len(surface.vertices), len(surface.triangles))

    rim = Rim(patch, surface)

    assert len(rim.normal) == 4 and not rim.smooth
    assert bend_patches(closed, surface) is closed


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("shape", ["torus", "sphere", "spleen"])
def test_patches_over_clean_cuts_turn_by_less(shape, seed):
    surface = open_shape(shape, seed)
    closed = fill(surface, range(len(palpate.find_border_loops(surface.triangles))), True, True)

    turns = measure_turns(surface, closed)

    assert turns and max(turns) < MOST_TURN


@pytest.mark.landing
@pytest.mark.parametrize(
    "name", ["hra_VH_F_Urinary_Bladder.glb", "vtkdata_Torso.vtp", "VH_F_Pancreas.glb",
             "gca_EdinGCA_3D_00020_small-intestine.vtk"],
)  # fmt: skip
def test_so_do_those_over_torn_rims_of_real_organs(name, shared_data):
    surface = import_file(shared_data(f"organs/{name}"))(EMPTY).surface
    beyond = filled = 0
    for hole, loop in enumerate(palpate.find_border_loops(surface.triangles)):
        if len(loop) > 100 or (closed := fill(surface, [hole], True, True)) is surface:
            continue
        filled += 1
        beyond += sum(turn > MOST_TURN for turn in measure_turns(surface, closed))
        ratios = compare_edges(surface, closed, loop)
        assert ratios.size == 0 or (ratios.min() >= 0.5 and ratios.max() <= 2.0)
        check_kept(surface, closed)

    assert filled and beyond == 0
