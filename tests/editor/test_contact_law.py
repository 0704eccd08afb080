# SPDX-License-Identifier: GPL-3.0-or-later
"""The law by which a solid is felt under a ball: chosen, kept, published and offered."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from organs import make_organ
from palpate.cli.main import main
from palpate.scene.scene_parts import FILLED, WITH_NEAR_FIELD, FillPart
from palpate_editor.chart import keep_known
from palpate_editor.check import assess
from palpate_editor.compile import compile_organ
from palpate_editor.document.files import (
    VERSION,
    pack_organ,
    read_organ,
    unpack_organ,
    write_organ,
)
from palpate_editor.edits import SetChoice

SPLEEN = replace(make_organ(), fill=FillPart(300))
MODULUS = SPLEEN.material.young_modulus / (1.0 - SPLEEN.material.poisson_ratio**2)


def make_kind(kind: str, **model: str):
    return replace(SPLEEN, model=replace(SPLEEN.model, kind=kind, **model))


@pytest.mark.parametrize("kind", FILLED)
def test_a_solid_is_felt_by_its_near_field_unless_the_hard_law_is_chosen(kind):
    scene = compile_organ(make_kind(kind))

    assert scene.bodies[0].contact_modulus == pytest.approx(MODULUS)
    assert scene.bodies[0].near_field.modulus == pytest.approx(MODULUS)
    hard = compile_organ(make_kind(kind, contact_law="hard"))
    assert hard.bodies[0].contact_modulus == 0.0 and hard.bodies[0].near_field is None


def test_springs_along_the_surface_keep_the_hard_law():
    assert compile_organ(SPLEEN).bodies[0].contact_modulus == 0.0


WALL = replace(
    SPLEEN,
    model=replace(SPLEEN.model, kind="shell", home_stiffness=None),
    material=replace(SPLEEN.material, wall_thickness=2e-3),
)


def test_a_wall_of_prisms_is_felt_by_its_near_field_unless_the_hard_law_is_chosen():
    near = compile_organ(WALL).bodies[0]

    assert near.contact_modulus == pytest.approx(MODULUS)
    assert near.near_field.wall_thickness == pytest.approx(2e-3, rel=0.05)
    hard = replace(WALL, model=replace(WALL.model, contact_law="hard"))
    assert compile_organ(hard).bodies[0].near_field is None


@pytest.mark.parametrize("version", [7, 8])
def test_a_wall_of_an_older_file_keeps_the_hard_law(version):
    content, arrays = pack_organ(WALL)
    content = json.loads(json.dumps(content))
    if version < 8:
        del content["model"]["integrator"]

    assert unpack_organ(content, arrays, version, "old.organ").model.contact_law == "hard"
    content, arrays = pack_organ(WALL)
    content = json.loads(json.dumps(content))
    assert unpack_organ(content, arrays, VERSION, "new.organ").model.contact_law == "near_field"


@pytest.mark.parametrize("version", range(1, 7))
def test_a_solid_of_an_older_file_keeps_the_hard_law_and_a_wall_may_become_a_near_field(version):
    for kind in (*FILLED, "mass_spring"):
        content, arrays = pack_organ(make_kind(kind))
        content = json.loads(json.dumps(content))
        del content["model"]["contact_law"]
        if version < 5:
            content["look"] = content.pop("appearance")
            if content["look"]:
                content["look"]["softness"] = content["look"].pop("subsurface")
        if version < 3:
            content.pop("fill")

        found = unpack_organ(content, arrays, version, "old.organ")

        assert found.model.contact_law == ("hard" if kind in FILLED else "near_field")


def test_the_command_line_chooses_the_law_and_it_is_kept(tmp_path, capsys):
    source, made = tmp_path / "spleen.organ", tmp_path / "hard.organ"
    write_organ(source, SPLEEN)
    call = ["material", str(source), "--kind", "solid", "--contact-law", "hard"]

    assert main([*call, "--out", str(made)]) == 0, capsys.readouterr()

    assert read_organ(made).model.contact_law == "hard"
    capsys.readouterr()
    assert main(["material", str(source), "--contact-law", "hard", "--out", str(made)]) != 0
    assert "--contact-law: got hard, which has no effect here" in capsys.readouterr().err


def test_check_offers_the_near_field_where_the_mesh_is_felt():
    hard, near = make_kind("solid", contact_law="hard"), make_kind("solid")

    assert "coarse_contact" in {problem.key for problem in assess(hard).problems}
    assert "coarse_contact" not in {problem.key for problem in assess(near).problems}
    assert SetChoice("contact_law", "near_field")(hard).model.contact_law == "near_field"


def test_a_solid_may_feel_its_facets_and_older_files_do_not():
    feels = make_kind("solid", contact_curvature="facets")
    body = compile_organ(feels).bodies[0]

    assert body.contact_facets
    assert body.near_field.rest_position == pytest.approx(feels.surface.vertices)
    usual = compile_organ(make_kind("solid")).bodies[0]
    assert not usual.contact_facets and not len(usual.near_field.rest_position)
    hard = make_kind("solid", contact_curvature="facets", contact_law="hard")
    assert not compile_organ(hard).bodies[0].contact_facets
    content, arrays = pack_organ(make_kind("solid"))
    content = json.loads(json.dumps(content))
    del content["model"]["contact_curvature"]
    assert unpack_organ(content, arrays, 12, "old.organ").model.contact_curvature == "vertices"


def test_the_command_line_chooses_the_curvature_and_refuses_it_where_it_counts_for_nothing(
    tmp_path, capsys
):
    source, made = tmp_path / "spleen.organ", tmp_path / "facets.organ"
    write_organ(source, SPLEEN)
    call = ["material", str(source), "--contact-curvature", "facets", "--out", str(made)]

    assert main([*call, "--kind", "solid"]) == 0, capsys.readouterr()
    assert read_organ(made).model.contact_curvature == "facets"
    capsys.readouterr()
    assert main([*call, "--kind", "solid", "--contact-law", "hard"]) == 1
    assert "the hard law knows no curvature" in capsys.readouterr().err
    assert main([*call, "--kind", "shell", "--wall", "2mm"]) == 1
    assert "--contact-curvature: got facets, which has no effect here" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("field", "word"), [("contact_curvature", "round"), ("contact_hold", "glued")]
)
def test_a_word_that_is_no_choice_is_refused(field, word):
    with pytest.raises(ValueError, match=f"model.{field}: got '{word}', expected one of"):
        compile_organ(make_kind("solid", **{field: word}))


@pytest.mark.parametrize(
    ("field", "word"), [("contact_curvature", "facets"), ("contact_hold", "tied")]
)
def test_charts_of_before_keep_their_key_and_one_of_another_contact_has_another(field, word):
    content, _ = pack_organ(make_kind("solid"))
    other, _ = pack_organ(make_kind("solid", **{field: word}))

    keep_known(content)
    keep_known(other)

    assert field not in content["model"]
    assert other["model"][field] == word


@pytest.mark.parametrize("kind", WITH_NEAR_FIELD)
def test_what_is_held_may_be_tied_to_tissue_and_older_files_are_not(kind):
    organ = WALL if kind == "shell" else make_kind(kind)
    tied = replace(organ, model=replace(organ.model, contact_hold="tied"))

    assert compile_organ(tied).bodies[0].tied_holds
    assert not compile_organ(organ).bodies[0].tied_holds
    hard = replace(tied, model=replace(tied.model, contact_law="hard"))
    assert not compile_organ(hard).bodies[0].tied_holds
    content, arrays = pack_organ(organ)
    content = json.loads(json.dumps(content))
    del content["model"]["contact_hold"]
    assert unpack_organ(content, arrays, 13, "old.organ").model.contact_hold == "fastened"


def test_the_command_line_ties_holds_and_refuses_it_where_it_counts_for_nothing(tmp_path, capsys):
    source, made = tmp_path / "spleen.organ", tmp_path / "tied.organ"
    write_organ(source, SPLEEN)
    call = ["material", str(source), "--contact-hold", "tied", "--out", str(made)]

    assert main([*call, "--kind", "solid"]) == 0, capsys.readouterr()
    assert read_organ(made).model.contact_hold == "tied"
    capsys.readouterr()
    assert main([*call, "--kind", "solid", "--contact-law", "hard"]) == 1
    assert "by the hard law what is held gives way as the mesh" in capsys.readouterr().err
    assert main([*call, "--kind", "mss"]) == 1
    assert "--contact-hold: got tied, which has no effect here" in capsys.readouterr().err
