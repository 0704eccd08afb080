# SPDX-License-Identifier: GPL-3.0-or-later
"""The tetrahedra of a file fill the organ, as long as its surface is their outside."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
import pytest
from foreign_files import write_msh, write_msh4, write_vtu
from palpate_editor import authoring
from palpate_editor.document import EMPTY
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.document.fill_rules import find_own_problems
from palpate_editor.edits import (
    SetConstant,
    SetUnit,
    SetUp,
    UseImported,
    decimate_organ,
    import_file,
)
from palpate_editor.edits.own_filling import find_own_filling
from palpate_editor.fill import build_filled, fill_surface
from palpate_meshes.generate import ellipsoid

WRITERS = {"vtu": write_vtu, "msh": write_msh, "4.msh": write_msh4}


@pytest.fixture(scope="module")
def solid() -> palpate.SolidMesh:
    """An ellipsoid of some 600 tetrahedra."""
    surface = palpate.SurfaceMesh(*ellipsoid(vertices=200))
    return authoring.fill_interior(surface, authoring.choose_cell_size(surface, 600))


def write(path, solid, extension="vtu", scale=1e3):
    """In millimetres."""
    WRITERS[extension](path, scale * np.asarray(solid.vertices), np.asarray(solid.tetrahedra))
    return path


def import_solid(path, **options):
    organ = import_file(path, **options)(EMPTY)
    return replace(organ, model=replace(organ.model, kind="corotated_solid"))


@pytest.mark.parametrize("extension", WRITERS)
def test_the_tetrahedra_of_a_file_are_the_filling(extension, solid, tmp_path):
    organ = import_solid(write(tmp_path / f"a.{extension}", solid, extension), unit="mm")

    own = find_own_filling(organ)
    assert own is not None
    assert organ.fill.tetrahedra == len(own.tetrahedra) == len(solid.tetrahedra)
    assert palpate.compute_volume(own) == pytest.approx(palpate.compute_volume(solid))
    tissue = build_filled(organ)
    assert len(palpate.list_tetrahedra(tissue)) == len(solid.tetrahedra)
    assert any("tetrahedra fill the organ" in note for note in organ.source.notes)


def test_a_decimated_surface_is_filled_again_and_the_imported_one_is_not(solid, tmp_path):
    organ = import_solid(write(tmp_path / "a.vtu", solid), unit="mm")
    coarse = decimate_organ(organ, 80)(organ)

    assert find_own_filling(coarse) is None
    # what it is filled with is another
    solid_of_it = fill_surface(coarse.surface, coarse.fill.tetrahedra)
    assert len(palpate.list_tetrahedra(build_filled(coarse))) == len(solid_of_it.tetrahedra)


def test_another_number_of_tetrahedra_asks_for_another_filling(solid, tmp_path):
    organ = import_solid(write(tmp_path / "a.vtu", solid), unit="mm")

    more = SetConstant("fill", "tetrahedra", 2 * len(solid.tetrahedra))(organ)

    assert find_own_filling(more) is None
    count = len(palpate.list_tetrahedra(build_filled(more)))
    assert count > 1.2 * len(solid.tetrahedra)
    back = SetConstant("fill", "tetrahedra", len(solid.tetrahedra))(more)
    assert find_own_filling(back) is not None


def test_a_finer_region_asks_for_another_filling(solid, tmp_path):
    organ = import_solid(write(tmp_path / "a.vtu", solid), unit="mm")
    fill = replace(organ.fill, fine_region="pole")

    finer = replace(organ, regions={"pole": np.arange(5)}, fill=fill)

    assert find_own_filling(finer) is None
    assert any(p.key == "own_filling" for p in find_own_problems(finer))
    assert not list(find_own_problems(organ))


def test_unit_and_axis_move_it_with_the_surface(solid, tmp_path):
    organ = import_solid(write(tmp_path / "a.vtu", solid), unit="mm")

    moved = SetUp("y")(SetUnit("cm")(organ))

    own = find_own_filling(moved)
    assert own is not None
    assert palpate.compute_volume(own) == pytest.approx(1e3 * palpate.compute_volume(solid))


def test_a_unit_that_is_guessed_by_name_keeps_it(solid, tmp_path):
    path = write(tmp_path / "prostate.vtu", solid, scale=1e3 * 0.05 / 0.2)

    organ = import_solid(path)

    assert find_own_filling(organ) is not None


def test_it_is_kept_in_the_file_to_the_bit(solid, tmp_path):
    organ = import_solid(write(tmp_path / "a.vtu", solid), unit="mm")

    write_organ(tmp_path / "a.organ", organ)
    again = read_organ(tmp_path / "a.organ")

    assert np.array_equal(again.filling.vertices, organ.filling.vertices)
    assert np.array_equal(again.filling.tetrahedra, organ.filling.tetrahedra)
    assert find_own_filling(again) is not None


def test_a_tetrahedron_the_wrong_way_round_is_turned(solid, tmp_path):
    cells = np.asarray(solid.tetrahedra).copy()
    cells[::3] = cells[::3][:, [0, 1, 3, 2]]
    write_vtu(tmp_path / "a.vtu", 1e3 * np.asarray(solid.vertices), cells)

    organ = import_solid(tmp_path / "a.vtu", unit="mm")

    assert palpate.compute_volume(find_own_filling(organ)) == pytest.approx(
        palpate.compute_volume(solid)
    )


def flatten(solid):
    """A vertex inside is moved into the face opposite to it: a tetrahedron without height."""
    x, cells = np.asarray(solid.vertices).copy(), np.asarray(solid.tetrahedra)
    outside = np.unique(palpate.find_boundary(solid))
    inner = next(v for v in cells.ravel() if v not in outside)
    cell = next(c for c in cells if inner in c)
    x[inner] = x[[v for v in cell if v != inner]].mean(axis=0)
    return x, cells


def test_flat_tetrahedra_are_not_used_and_that_is_said(solid, tmp_path):
    x, cells = flatten(solid)
    write_vtu(tmp_path / "a.vtu", 1e3 * x, cells)

    organ = import_solid(tmp_path / "a.vtu", unit="mm")

    assert organ.filling is None
    assert any("are not used" in note and "filled again" in note for note in organ.source.notes)


def test_two_tetrahedra_are_too_few_to_be_felt(tmp_path):
    from foreign_files import TETRAHEDRON
    from test_formats import POINTS, TWO

    assert len(TETRAHEDRON) == 4
    write_vtu(tmp_path / "a.vtu", POINTS, TWO)

    organ = import_solid(tmp_path / "a.vtu", unit="mm")

    assert organ.filling is None
    assert any("there are 2" in note for note in organ.source.notes)


def test_the_imported_surface_is_filled_by_them_again(solid, tmp_path):
    organ = import_solid(write(tmp_path / "a.vtu", solid), unit="mm")
    coarse = decimate_organ(organ, 80)(organ)

    assert find_own_filling(UseImported()(coarse)) is not None
