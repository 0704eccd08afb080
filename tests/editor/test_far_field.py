# SPDX-License-Identifier: GPL-3.0-or-later
"""The far field of a solid, solved on a finer mesh: its law, what it is bound to, what is felt."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import palpate
import pytest
from editor.organs import generate
from palpate.cli.main import main
from palpate.error import FileError
from palpate_editor.check import assess
from palpate_editor.compile import compile_organ
from palpate_editor.document import Organ, Surface
from palpate_editor.document.far_compliance import find_far_compliance, is_stale
from palpate_editor.document.far_field import FarField
from palpate_editor.document.files import pack_organ, read_organ, unpack_organ, write_organ
from palpate_editor.edits import (
    Configure,
    EditError,
    FixLowest,
    PaintStiffness,
    SetChoice,
    SetConstant,
    SetFarField,
)
from palpate_editor.edits.configure import find_configuration
from palpate_editor.far_field import SolveFarField
from palpate_editor.truth import far_field as solver
from palpate_editor.truth.far_field import round_digits, solve_far_field
from palpate_editor.truth.graded import Skin, snap
from palpate_editor.truth.progress import Stopped, TruthError
from palpate_editor.truth.tetrahedra import compute_volumes

POISSON, YOUNG = 0.45, 5e3
MODULUS = YOUNG / (1.0 - POISSON**2)
THICKNESS = 0.05


def make_solid(surface: Surface, tetrahedra: int = 600) -> Organ:
    """Held below, its lowest third."""
    organ = Organ(name="solid").with_surface(surface)
    organ = replace(
        organ,
        imported=surface,
        material=replace(organ.material, young_modulus=YOUNG, poisson_ratio=POISSON),
        model=replace(organ.model, kind="linear_solid", contact_law="near_field"),
        fill=replace(organ.fill, tetrahedra=tetrahedra),
        tool=replace(organ.tool, radius=0.004),
    )
    return FixLowest(0.35)(organ)


def make_block(count: int = 6) -> Surface:
    """100 x 100 x 50 mm, with squares of 100 mm / count."""
    at = np.linspace(-0.05, 0.05, count + 1)
    x, faces = [], []
    for axis, sign in [(a, s) for a in range(3) for s in (-1.0, 1.0)]:
        side = np.stack(np.meshgrid(at, at, indexing="ij"), axis=2).reshape(-1, 2)
        points = np.insert(side, axis, sign * 0.05, axis=1)
        i, j = np.meshgrid(np.arange(count), np.arange(count), indexing="ij")
        a = (i * (count + 1) + j).ravel() + sum(map(len, x))
        b, c, d = a + count + 1, a + count + 2, a + 1
        quads = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
        out = sign * (1.0 if axis != 1 else -1.0) > 0.0
        faces.append(quads if out else quads[:, ::-1])
        x.append(points)
    every = np.concatenate(x) * [1.0, 1.0, THICKNESS / 0.1]
    _, first, number = np.unique(np.round(every, 9), axis=0, return_index=True, return_inverse=True)
    return Surface(every[first], number.reshape(-1)[np.concatenate(faces)].astype(np.int32))


@cache
def make_small() -> Organ:
    return make_solid(Surface(*generate(vertices=60)), tetrahedra=300)


@cache
def solve_small() -> Organ:
    return SolveFarField()(make_small())


@pytest.mark.landing
def test_the_far_field_of_a_thick_block_is_that_of_a_layer():
    block = make_solid(make_block())

    found = solve_far_field(block)

    # [1/m] alpha_0 of [Dimitriadis02] over pi and the thickness
    alpha = -(1.2876 - 1.4678 * POISSON + 1.3442 * POISSON**2) / (1.0 - POISSON)
    layer = alpha / (np.pi * THICKNESS)
    x = block.surface.vertices
    middle = (x[:, 2] > 0.0249) & (np.abs(x[:, :2]) < 0.02).all(axis=1)
    # beside a ball of 4 mm, 2 mm deep, which has 1 / 2a
    ball = 0.5 / np.sqrt(0.004 * 0.002)
    assert middle.sum() >= 4
    assert np.abs(found.tensors[middle, 2] - layer).max() < 0.03 * ball
    assert found.tetrahedra == pytest.approx(solver.TETRAHEDRA, rel=0.1)


def test_a_half_space_gives_way_more_along_its_face_than_into_it():
    normal = np.array([[0.0, 0.6, 0.8]])

    (found,) = solver.find_half_space(normal, np.array([0.01]), POISSON)

    into, aside = normal[0] @ found @ normal[0], found[0, 0]
    assert into == pytest.approx(16.0 / (3.0 * np.pi**2 * 0.01))
    # Mindlin's ratio of compliances
    assert aside / into == pytest.approx((2.0 - POISSON) / (2.0 * (1.0 - POISSON)))
    assert np.array([0.0, 0.8, -0.6]) @ found @ normal[0] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.landing
def test_a_press_aside_on_the_block_is_softer_than_into_it_where_only_its_foot_is_held():
    block = make_solid(make_block())

    found = solve_far_field(block).tensors

    x = block.surface.vertices
    top = (x[:, 2] > 0.0249) & (np.abs(x[:, :2]) < 0.02).all(axis=1)
    assert (found[top, 0] > found[top, 2]).all() and (found[top, 1] > found[top, 2]).all()


@pytest.mark.landing
def test_it_hardly_changes_with_the_mesh_that_it_is_solved_on(monkeypatch):
    fine = solve_small().far_field.tensors
    monkeypatch.setattr(solver, "TETRAHEDRA", 4000)

    coarse = solve_far_field(make_small()).tensors

    free = ~make_small().fixed
    ball = 0.5 / np.sqrt(0.004 * 0.002)
    # along each axis; the surface is the same to rounding, and so which mesh fills it is not: 0.054
    # on a processor with AVX-512, less than 0.05 without
    felt = (ball + coarse[:, :3]) / (ball + fine[:, :3])
    assert np.abs(felt[free] - 1.0).mean() < 0.07


def test_a_softer_tissue_gives_way_as_many_times_more_and_keeps_its_table():
    solid = solve_small()
    stiff = SetConstant("material", "young_modulus", 3.0 * YOUNG)(solid)

    compliance = find_far_compliance(solid)

    assert compliance == pytest.approx(solid.far_field.tensors / MODULUS)
    assert find_far_compliance(stiff) == pytest.approx(compliance / 3.0)


VOID = {
    "another thing is held": FixLowest(0.4),
    "a place is stiffer": PaintStiffness(np.array([3]), 2.0),
    "another Poisson's ratio": SetConstant("material", "poisson_ratio", 0.3),
}


@pytest.mark.parametrize(
    "edit",
    [
        pytest.param(edit, marks=pytest.mark.landing if k else [], id=name)
        for k, (name, edit) in enumerate(VOID.items())
    ],
)
def test_a_table_of_something_else_is_not_felt_and_warned_of(edit):
    organ = edit(solve_small())

    assert is_stale(organ)
    assert find_far_compliance(organ) is None
    assert not len(compile_organ(organ).bodies[0].far_compliance)
    problem = next(p for p in assess(organ).problems if p.key == "far_field")
    assert problem.severity == "warning"
    assert find_far_compliance(problem.fix(organ)) is not None


def test_a_scene_feels_the_table_and_the_hard_law_has_no_use_for_it():
    solid = solve_small()

    body = compile_organ(solid).bodies[0]

    assert np.array_equal(body.far_compliance, find_far_compliance(solid))
    assert len(body.near_field.far_compliance) == solid.vertex_count
    hard = compile_organ(SetChoice("contact_law", "hard")(solid)).bodies[0]
    assert not len(hard.far_compliance)


def test_without_one_a_note_offers_it_and_with_one_nothing_is_said():
    problem = next(p for p in assess(make_small()).problems if p.key == "far_field")

    assert problem.severity == "note"
    assert isinstance(problem.fix, SolveFarField)
    assert all(p.key != "far_field" for p in assess(solve_small()).problems)


def test_files_keep_it_bit_for_bit(tmp_path):
    solid = solve_small()
    write_organ(tmp_path / "a.organ", solid)

    found = read_organ(tmp_path / "a.organ").far_field

    assert (found.key, found.patch, found.tetrahedra) == (
        solid.far_field.key,
        solid.far_field.patch,
        solid.far_field.tetrahedra,
    )
    assert np.array_equal(found.softness, solid.far_field.softness)
    scenario = palpate.scenario.Scenario(scene=compile_organ(solid), title="t")
    palpate.scenario.write(str(tmp_path / "a.palpate"), scenario)
    read = palpate.scenario.read(str(tmp_path / "a.palpate")).scene.bodies[0]
    assert np.array_equal(read.far_compliance, find_far_compliance(solid))


def test_a_file_with_a_table_of_another_length_is_refused():
    from palpate_editor.document.migrations import VERSION

    content, arrays = pack_organ(solve_small())
    shorter = arrays | {"far_field/softness": arrays["far_field/softness"][:-1].copy()}

    with pytest.raises(FileError, match="far_field/softness: got 359 numbers, expected 360"):
        unpack_organ(json.loads(json.dumps(content)), shorter, VERSION, "file")
    del arrays["far_field/softness"]
    with pytest.raises(FileError, match="no such array"):
        unpack_organ(json.loads(json.dumps(content)), arrays, VERSION, "file")


def test_a_configuration_says_which_far_field_it_has():
    solid = solve_small()
    own = find_configuration(solid)

    assert own.far_field == "fine"
    assert find_configuration(make_small()).far_field == "mesh"
    assert Configure(replace(own, far_field="mesh"))(solid).far_field is None
    with pytest.raises(EditError, match="has not been solved"):
        Configure(own)(make_small())


REFUSED = {
    "a wall": (SetConstant("material", "wall_thickness", 0.003), "Only a solid"),
    "the hard law": (SetChoice("contact_law", "hard"), "Only a solid"),
    "springs of the surface": (SetChoice("kind", "mass_spring"), "Only a solid"),
}


@pytest.mark.parametrize(("edit", "why"), REFUSED.values(), ids=REFUSED)
def test_what_has_no_far_field_is_refused_one(edit, why):
    organ = edit(make_small())

    for wanted in (SolveFarField(), SetFarField(solve_small().far_field)):
        with pytest.raises(EditError, match=why):
            wanted(organ)


def test_edits_that_would_change_nothing_or_do_not_fit_are_refused():
    with pytest.raises(EditError, match="of a finer mesh already"):
        SolveFarField()(solve_small())
    with pytest.raises(EditError, match="of the mesh already"):
        SetFarField(None)(make_small())
    with pytest.raises(EditError, match="has 3 numbers"):
        SetFarField(FarField("k", 0.008, 8000, np.zeros(3)))(make_small())


def test_a_body_that_nothing_holds_has_none():
    loose = replace(make_small(), fixed=np.zeros(60, bool))

    with pytest.raises(TruthError, match="no triangle is held"):
        solve_far_field(loose)


@pytest.mark.landing
def test_it_can_be_stopped_and_tells_how_far_it_is():
    said = []
    with pytest.raises(Stopped):
        solve_far_field(make_small(), cancelled=lambda: True)

    solve_far_field(make_small(), said.append)

    assert {p.stage for p in said} >= {"mesh", "stiffness", "factor", "response"}
    assert [p.fraction for p in said] == sorted(p.fraction for p in said)


def test_outer_vertices_go_to_the_surface_and_no_tetrahedron_is_turned_inside_out():
    surface = make_small().surface
    solid = palpate.SurfaceMesh(surface.vertices, surface.triangles)
    from palpate_editor import authoring

    filled = authoring.fill_to_count(solid, 1000)
    x, t = np.array(filled.vertices), np.asarray(filled.tetrahedra, dtype=np.int64)
    skin = Skin(surface.vertices, surface.triangles.astype(np.int64))

    moved = snap(x, t, 0, skin)

    assert (compute_volumes(moved, t) >= 0.2 * compute_volumes(x, t)).all()
    outer = np.unique(palpate.find_boundary(filled))
    off = np.linalg.norm(skin.project(moved[outer])[0] - moved[outer], axis=1)
    assert (off < 1e-9).mean() > 0.9


def test_tables_are_rounded_to_six_digits_of_the_largest():
    assert round_digits(np.array([123.45678, -0.0004, 9.9996])).tolist() == pytest.approx(
        [123.457, 0.0, 10.0], abs=1e-9
    )


def test_the_verb_solves_keeps_and_drops_it(tmp_path: Path, capsys):
    file = tmp_path / "a.organ"
    write_organ(file, make_small())

    for _ in range(2):  # a second time there is nothing to do
        assert main(["material", str(file), "--far-field", "fine", "-o", str(file)]) == 0
        assert np.array_equal(read_organ(file).far_field.softness, solve_small().far_field.softness)
    assert main(["material", str(file), "--far-field", "mesh", "-o", str(file)]) == 0
    assert read_organ(file).far_field is None
    capsys.readouterr()
    assert main(["material", str(file), "--wall", "3mm", "--far-field", "fine", "-o", str(file)])
    assert "--far-field" in capsys.readouterr().err
