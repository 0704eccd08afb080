# SPDX-License-Identifier: GPL-3.0-or-later
"""An open surface is hollow: it has the usual wall until a designer chooses one or closes it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
import pytest
from damaged_shapes import damage
from foreign_files import write_obj
from palpate.cli.main import main
from palpate_editor import edits
from palpate_editor.check import assess
from palpate_editor.compile import build_organ
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.defaults import WALL_THICKNESS
from palpate_editor.document.files import read_organ
from palpate_editor.edits import import_file
from palpate_editor.edits.ladder import climb
from palpate_editor.rebuild import read_steps, rebuild
from palpate_meshes.generate import ellipsoid, tube


def read(folder, name: str, x, triangles) -> Organ:
    write_obj(folder / f"{name}.obj", 1e3 * np.asarray(x), triangles)
    return import_file(folder / f"{name}.obj")(EMPTY)


def wall_of(organ: Organ) -> float | None:
    return organ.material.wall_thickness


def with_wall(organ: Organ, wall: float) -> Organ:
    return edits.SetConstant("material", "wall_thickness", wall)(organ)


@pytest.fixture
def opened(tmp_path) -> Organ:
    return read(tmp_path, "spleen", *tube(300))


def test_an_open_surface_is_simulated_as_it_was_read_and_says_as_what(opened):
    assessment = assess(opened)

    assert wall_of(opened) == WALL_THICKNESS
    assert palpate.stable_step(build_organ(opened)) > 0.0
    assert not {"open_solid", "unsound"} & {p.key for p in assessment.problems}
    [holes] = [p for p in assessment.problems if p.key == "holes"]
    assert f"the wall of {1e3 * WALL_THICKNESS:g} mm that it has now" in str(holes.expected)


def test_a_closed_one_is_solid_as_before(tmp_path):
    assert wall_of(read(tmp_path, "spleen", *ellipsoid(300))) is None


def test_closing_it_takes_the_wall_away_that_nobody_chose(opened):
    assert wall_of(edits.FillHoles((0,))(opened)) is None


@pytest.mark.parametrize("wall", [0.002, WALL_THICKNESS])
def test_a_wall_that_was_chosen_stays(opened, wall):
    assert wall_of(edits.FillHoles((0,))(with_wall(opened, wall))) == wall


def test_another_file_in_its_place_has_what_it_needs_itself(opened, tmp_path):
    write_obj(tmp_path / "solid.obj", 1e3 * ellipsoid(300)[0], ellipsoid(300)[1])
    solid = import_file(tmp_path / "solid.obj")

    assert wall_of(solid(opened)) is None
    assert wall_of(solid(with_wall(opened, 0.002))) == 0.002


def test_a_cut_that_opens_a_solid_gives_it_a_wall(tmp_path):
    x, triangles = ellipsoid(300)
    organ = read(tmp_path, "spleen", x, triangles)
    surface = replace(organ.surface, triangles=triangles[1:])
    before = replace(organ, surface=surface, imported=surface)

    assert wall_of(edits.DecimateTo(200)(before)) == WALL_THICKNESS


@pytest.mark.parametrize("chosen", [False, True])
def test_repair_fills_what_is_damage_unless_a_designer_says_that_it_is_hollow(chosen, tmp_path):
    x, triangles = damage("sphere", "one face missing", 0)
    organ = read(tmp_path, "sphere", 1e-3 * x, triangles)
    organ = with_wall(organ, WALL_THICKNESS) if chosen else organ

    repaired = climb(organ).organ

    assert palpate.is_closed(repaired.surface.triangles) is not chosen
    assert wall_of(repaired) == (WALL_THICKNESS if chosen else None)


def test_it_is_rebuilt_with_the_same_wall(tmp_path):
    write_obj(tmp_path / "spleen.obj", 1e3 * tube(300)[0], tube(300)[1])
    out = tmp_path / "spleen.organ"
    assert main(["import", str(tmp_path / "spleen.obj"), "-o", str(out)]) == 0
    organ = read_organ(out)

    assert wall_of(organ) == WALL_THICKNESS
    assert wall_of(rebuild(organ, read_steps(organ, out), out)) == WALL_THICKNESS
