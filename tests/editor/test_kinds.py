# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate material`: every kind from a Young's modulus, and what each cannot represent."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import palpate
import pytest
from organs import make_organ, same
from palpate.cli.main import main
from palpate.scene.scene_parts import FILLED, KINDS, FillPart, ModelPart
from palpate.study.findings import read_findings
from palpate_editor.check import assess
from palpate_editor.comparison import (
    COMPARED_KINDS,
    FRONT_KINDS,
    SOLIDS,
    STUDIED,
    WALLS,
    say_error,
)
from palpate_editor.compile import compile_organ, mesh_of
from palpate_editor.document import Organ
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import SetChoice
from palpate_editor.kinds import LINE, SURFACE_KINDS, TISSUE_KINDS, find_solid_limits
from palpate_editor.shipped import list_organs

SOLID = replace(make_organ(200, None), stiffness_scale=np.ones(200))


def hollow(**model: object) -> Organ:
    material = replace(SOLID.material, young_modulus=5e4, wall_thickness=2e-3)
    return replace(SOLID, material=material, model=replace(SOLID.model, **model))


def run(capsys, *words: object) -> dict:
    assert main([*map(str, words), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


@pytest.fixture
def wall(tmp_path):
    write_organ(tmp_path / "wall.organ", hollow())
    return tmp_path / "wall.organ"


def test_every_kind_of_a_wall_is_built_and_says_what_it_cannot_represent(wall, capsys):
    report = run(capsys, "material", wall, "--young-modulus", "5kPa", "--poisson", "0.45")

    rows = {row["name"]: row for row in report["kinds"]}
    assert list(rows) == [kind.name for kind in TISSUE_KINDS]
    for filled in [rows.pop(kind) for kind in FILLED]:
        assert filled["refusal"].startswith("material: wall_thickness: got 2 mm, expected none")
    for row in rows.values():
        assert row["built"], row
        assert row["cannot_represent"]
    assert report["material"]["young_modulus_Pa"] == 5e3
    exact, springs = rows["molecular gradient"], rows["mass_spring van_gelder"]
    assert exact["wall"]["error"] < 1e-9
    assert exact["wall"]["poisson_ratio"] == pytest.approx(0.45)
    assert springs["wall"]["poisson_ratio"] == pytest.approx(1 / 3, abs=0.01)
    assert springs["wall"]["young_modulus"] == pytest.approx(5e3, rel=0.05)
    assert rows["shell"]["particles"] == 2 * exact["particles"]
    assert rows["shell"]["kernel"] == "packed"
    assert any("bending" in limit for limit in exact["cannot_represent"])
    assert not any("bending" in limit for limit in rows["shell"]["cannot_represent"])


def test_the_error_that_is_told_is_that_of_the_built_model(wall, capsys):
    report = run(capsys, "material", wall, "--young-modulus", "50kPa", "--poisson", "0.3")

    organ = read_organ(wall)
    material = palpate.Material(young_modulus=5e4, poisson_ratio=0.3, wall_thickness=2e-3)
    fit = palpate.compare_with_membrane(
        palpate.build_membrane_springs(mesh_of(organ.surface), material), material
    )
    told = next(row for row in report["kinds"] if row["name"] == "mass_spring van_gelder")
    assert told["wall"]["error"] == pytest.approx(fit.error)
    assert f"error {100 * fit.error:.2g} %" in " ".join(told["cannot_represent"])


def test_without_an_output_the_document_stays_as_it_is(wall, capsys):
    before = wall.read_bytes()

    report = run(capsys, "material", wall, "--young-modulus", "5kPa")

    assert report["out"] is None
    assert wall.read_bytes() == before


def test_a_solid_says_why_its_surface_cannot_carry_it(tmp_path, capsys):
    write_organ(tmp_path / "solid.organ", SOLID)

    report = run(capsys, "material", tmp_path / "solid.organ", "--young-modulus", "5kPa")

    for row in report["kinds"]:
        if row["built"]:
            continue
        assert "material: wall_thickness: got none" in row["refusal"]
        name = SURFACE_KINDS[row["name"].split()[0]]
        small = [f for f in read_findings() if f.kind == name and f.depth is None]
        shares = sorted(100 * f.force for f in small if f.body in SOLIDS)
        words = f"{shares[0]:.0f} to {shares[-1]:.0f} % of the organ's force"
        assert words in row["cannot_represent"][0]
    assert not report["kinds"][1]["built"]
    filled = report["kinds"][0]
    linear, *finite = report["kinds"][1 - len(FILLED) :]
    assert filled["name"] == "solid" and filled["built"]
    assert filled["kernel"] == "packed"
    assert linear["name"] == "linear_solid" and linear["built"]
    assert linear["kernel"] == "response"
    limits = " ".join(linear["cannot_represent"])
    assert "deeper than 15%" in limits and "MB of at most 67.1" in limits
    for row in finite:
        assert row["built"] and row["kernel"] == "reference"
        assert "plain code" in " ".join(row["cannot_represent"])
    assert "large strains" in finite[0]["cannot_represent"][0]


@pytest.mark.parametrize(
    ("share", "kind", "also"),
    [
        (0.0, "springs + volumes, each", ""),
        (0.9, "springs + volumes, 0.9 nodal", ", which lock where the nodal average does not"),
        (0.7, "springs + volumes, 0.9 nodal", ", measured at a nodal share of 0.9"),
    ],
)
def test_a_solid_says_what_the_study_found_of_its_nodal_share(share, kind, also):
    organ = replace(SOLID, fill=FillPart(300, share), model=ModelPart(kind="solid"))
    small = [f for f in read_findings() if f.kind == kind and f.depth is None]
    solid = [f for f in small if f.body in SOLIDS]
    deep = [f for f in read_findings() if f.kind == kind and f.depth and f.depth > 0.0]

    mesh, strains, _ = find_solid_limits(organ, compile_organ(organ).bodies[0].tissue, None)

    low, high = (100 * (f - 1) for f in (min(f.least for f in solid), max(f.most for f in solid)))
    assert f"too coarse, {low:.0f} to {high:.0f} % under a small patch" in mesh
    low, high = (100 * (1 - f) for f in (max(f.most for f in deep), min(f.least for f in deep)))
    assert f"large strains: {low:.0f} to {high:.0f} % softer than neo-Hookean" in strains
    assert also in strains


def test_in_words_each_kind_has_its_lines(wall, capsys):
    assert main(["material", str(wall), "--young-modulus", "5kPa"]) == 0

    words = capsys.readouterr().out
    assert words.count("cannot represent") > 8
    assert "molecular, exact membrane: 200 particles" in words
    front, compared = words.split(LINE)
    assert "shell of prisms: " in front and "its error" not in front
    assert compared.count("    its error: ") == 7
    assert "springs, Van Gelder: 200 particles" in compared
    assert f"    its error: {say_error('mass_spring')} (core/ACCURACY.md)" in compared


def test_the_kinds_above_the_line_are_those_of_the_shipped_organs_that_give_way():
    shipped = {tissue.model["kind"] for _, tissue in list_organs() if tissue.kind != "rigid"}

    assert shipped == set(FRONT_KINDS)
    assert {*FRONT_KINDS, *COMPARED_KINDS} == set(KINDS)


def test_the_error_of_a_surface_is_what_the_study_found():
    assert say_error("solid") is None
    found = [f for f in read_findings() if f.kind == STUDIED["mass_spring"] and f.depth is None]
    for bodies, of in ((SOLIDS, "of a solid organ's force"), (WALLS, "of a hollow one's")):
        shares = sorted(100.0 * f.force for f in found if f.body in bodies)
        assert f"{shares[0]:.0f} to {shares[-1]:.0f} % {of}" in say_error("mass_spring")


def test_constants_from_tissue_come_back_and_are_built(wall, capsys):
    run(capsys, "material", wall, "--young-modulus", "40kPa", "--poisson", "0.4", "--kind", "mms",
        "--constants", "tissue", "-o", wall)  # fmt: skip

    organ = read_organ(wall)
    assert (organ.model.kind, organ.model.constants) == ("molecular", "tissue")
    built = compile_organ(organ).bodies[0].tissue
    material = palpate.Material(
        density=organ.material.density,
        young_modulus=4e4,
        poisson_ratio=0.4,
        damping_ratio=organ.material.damping_ratio,
        wall_thickness=2e-3,
    )
    direct = palpate.build_membrane_molecular(mesh_of(organ.surface), material)
    np.testing.assert_array_equal(built.bonds.stiffness, direct.bonds.stiffness)
    assert assess(organ).facts.tissue.wall.error < 1e-9


@pytest.mark.parametrize(
    ("kind", "angle_law"),
    [("mass_spring", "gradient"), ("molecular", "gradient"), ("molecular", "eq10")],
)
def test_choosing_by_hand_goes_on_from_what_the_tissue_gave(kind, angle_law):
    organ = hollow(kind=kind, constants="tissue", angle_law=angle_law)

    chosen = SetChoice("constants", "chosen")(organ)

    assert chosen.model.constants == "chosen"
    assert chosen.model.stiffness != organ.model.stiffness
    before, after = assess(organ).facts.tissue, assess(chosen).facts.tissue
    assert after.refusal is None
    assert before.wall.error < after.wall.error or kind != "molecular"
    # one number for all is not what each had, but it is near
    assert after.wall.young_modulus == pytest.approx(before.wall.young_modulus, rel=0.4)


def test_choosing_by_hand_without_a_wall_keeps_the_numbers():
    organ = replace(SOLID, model=replace(SOLID.model, constants="tissue"))

    chosen = SetChoice("constants", "chosen")(organ)

    assert same(replace(chosen, history=None), SOLID)


def test_a_stretch_bend_that_a_triangle_cannot_take_is_refused_with_triangle_and_range(
    wall, capsys
):
    before = wall.read_bytes()
    words = ["material", str(wall), "--kind", "mms", "--bend", "1mJ", "-o", str(wall)]

    assert main([*words, "--stretch-bend=50N"]) == 1

    said = capsys.readouterr().err
    found = re.search(
        r"triangle \d+: got K_btheta 50 N, which makes its tangent at rest indefinite, expected "
        r"(\S+) to (\S+) N on this mesh",
        said,
    )
    assert found, said
    low, high = map(float, found.groups())
    assert wall.read_bytes() == before
    for beyond, code in ((low, 1), (high, 1), (low, 0), (high, 0)):
        value = (1.01 if code else 0.99) * beyond
        assert main([*words, f"--stretch-bend={value}N"]) == code
