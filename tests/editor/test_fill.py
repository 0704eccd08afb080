# SPDX-License-Identifier: GPL-3.0-or-later
"""How a solid is filled is the designer's choice: tetrahedra, nodal share, reach."""

from __future__ import annotations

import json
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.cli.main import main
from palpate.scene.scene_parts import FILLED, FillPart
from palpate_editor import _authoring
from palpate_editor.check import assess
from palpate_editor.compile import build_organ
from palpate_editor.document.constants import MOST_TETRAHEDRA
from palpate_editor.document.cost_rules import compute_tick_share
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import (
    EditError,
    RemoveRegion,
    SetChoice,
    SetConstant,
    SetFineRegion,
    SetReach,
)
from palpate_editor.fill import fill_organ, fill_surface
from palpate_editor.open_organ import open_organ
from palpate_editor.shipped import make_organ as make_shipped
from palpate_meshes.catalogue import PUBLISHED

REACH = "diaphragmatic surface"
COUNT_ERROR = _authoring.COUNT_ERROR


@pytest.fixture(scope="module")
def spleen():
    return replace(SetChoice("kind", "linear_solid")(make_shipped("spleen")), fill=FillPart(600))


@pytest.fixture
def file(spleen, tmp_path) -> Path:
    write_organ(tmp_path / "spleen.organ", spleen)
    return tmp_path / "spleen.organ"


def test_what_a_new_organ_is_filled_with_is_what_the_library_chooses():
    assert FillPart().nodal_share == palpate.SolidOptions().nodal_share
    assert _authoring.MOST_TETRAHEDRA == MOST_TETRAHEDRA


def test_more_tetrahedra_fill_the_same_organ_finer_and_cost_more(spleen):
    solid = SetChoice("kind", "solid")(spleen)
    finer = SetConstant("fill", "tetrahedra", 1800.0)(solid)

    coarse, fine = assess(solid), assess(finer)

    assert finer.fill.tetrahedra == 1800 and isinstance(finer.fill.tetrahedra, int)
    counts = [found.facts.tissue.tetrahedra for found in (coarse, fine)]
    assert counts[0] == pytest.approx(600, rel=COUNT_ERROR)
    assert counts[1] == pytest.approx(1800, rel=COUNT_ERROR)
    shares = [compute_tick_share(found.organ, found.facts) for found in (coarse, fine)]
    assert shares[1] / shares[0] >= counts[1] / counts[0]


@pytest.mark.landing
@pytest.mark.parametrize("name", ["spleen", "liver", "kidney"])
def test_published_solids_carry_the_filling_that_their_document_still_gives(name):
    """Nothing of what shipped before tetrahedra were counted changes."""
    organ = open_organ(PUBLISHED / f"{name}.organ")
    before = open_organ(PUBLISHED / f"{name}.palpate")
    carried = scenario.read(str(PUBLISHED / f"{name}.palpate")).scene.bodies[0].tissue

    assert organ.fill == before.fill and organ.fill.sizing == "estimated"
    again = np.asarray(palpate.list_tetrahedra(build_organ(organ)))
    assert np.array_equal(again, np.asarray(palpate.list_tetrahedra(carried)))


def test_a_number_that_is_asked_for_in_an_older_document_is_counted():
    organ = open_organ(PUBLISHED / "spleen.palpate")

    again = SetConstant("fill", "tetrahedra", 2000)(organ)

    assert again.fill.sizing == "counted"
    made = len(fill_organ(again).tetrahedra)
    assert made == pytest.approx(2000, rel=COUNT_ERROR)
    assert (
        len(fill_organ(replace(organ, fill=replace(organ.fill, tetrahedra=2000))).tetrahedra)
        < (1.0 - COUNT_ERROR) * 2000
    )


def test_a_solid_is_filled_finer_at_a_region_and_as_many_tetrahedra_as_asked(spleen):
    whole = replace(spleen, fill=FillPart(3000))
    finer = SetConstant("fill", "fine_ratio", 0.3)(SetFineRegion("lower pole")(whole))

    plain, graded = fill_organ(whole), fill_organ(finer)

    assert len(graded.tetrahedra) == pytest.approx(3000, rel=COUNT_ERROR)
    place = spleen.surface.vertices[spleen.regions["lower pole"]]
    edges = [measure_edges_near(solid, place) for solid in (plain, graded)]
    assert edges[1][0] < 0.6 * edges[0][0] and edges[1][1] > edges[0][1]
    assert fill_organ(finer) is graded


def measure_edges_near(solid: palpate.SolidMesh, place: np.ndarray) -> tuple[float, float]:
    """[m] Mean edges of tetrahedra within 5 mm of points, and of those beyond 30 mm."""
    x = np.asarray(solid.vertices)[np.asarray(solid.tetrahedra)]
    away = np.linalg.norm(x.mean(axis=1)[:, None] - place[None], axis=2).min(axis=1)
    edges = np.linalg.norm(x[:, [0, 0, 0, 1, 1, 2]] - x[:, [1, 2, 3, 2, 3, 3]], axis=2)
    return float(edges[away < 5e-3].mean()), float(edges[away > 30e-3].mean())


def test_a_fine_region_that_is_gone_is_an_error_and_no_region_has_no_ratio(spleen, file, capsys):
    gone = RemoveRegion("lower pole")(SetFineRegion("lower pole")(spleen))

    (problem,) = assess(gone).errors
    assert problem.where == "fill.fine_region" and assess(problem.fix(gone)).errors == ()
    with pytest.raises(EditError, match="no region apex"):
        SetFineRegion("apex")(spleen)
    words = ["material", str(file), "-o", str(file)]
    assert main([*words, "--fine-ratio", "0.3"]) == 1
    assert "--fine REGION with it" in capsys.readouterr().err
    assert main([*words, "--fine", "lower pole", "--fine-ratio", "0.3"]) == 0
    assert read_organ(file).fill == FillPart(600, fine_region="lower pole", fine_ratio=0.3)
    assert main([*words, "--fine", "none"]) == 0
    assert read_organ(file).fill.fine_region == ""
    assert main([*words, "--kind", "mss", "--fine", "lower pole"]) == 1
    assert "--kind solid with it" in capsys.readouterr().err


def test_the_nodal_share_is_that_of_the_tissue(spleen):
    tables = ("volumes", "elastic", "corotated", "neo_hookean")
    for kind, table in zip(FILLED, tables, strict=True):
        organ = SetConstant("fill", "nodal_share", 0.25)(SetChoice("kind", kind)(spleen))

        assert getattr(build_organ(organ), table).nodal_share == 0.25


def test_a_filling_is_kept_while_other_constants_change(spleen):
    once = fill_surface(spleen.surface, 600)

    assert fill_surface(spleen.surface, 600) is once
    assert fill_surface(spleen.surface, 700) is not once


@pytest.mark.parametrize("count", [99, 0, -3, MOST_TETRAHEDRA + 1, 2**40, 600.5])
def test_a_count_that_fills_nothing_is_refused_with_the_range(spleen, count):
    with pytest.raises(EditError, match="a whole number of 100 to 40000"):
        SetConstant("fill", "tetrahedra", count)(spleen)
    if count == int(count):
        with pytest.raises(ValueError, match="fill.tetrahedra: got .*100 to 40000"):
            build_organ(replace(spleen, fill=FillPart(int(count))))


def test_a_reach_makes_the_response_smaller_and_the_same_where_it_reaches(spleen):
    whole, part = build_organ(spleen), build_organ(SetReach(REACH)(spleen))

    sizes = [palpate.measure_response(tissue) for tissue in (whole, part)]

    assert sizes[1].moved == sizes[0].moved
    assert sizes[1].bytes < 0.8 * sizes[0].bytes
    skin = np.asarray(part.skin.corners)[spleen.regions[REACH]]
    assert set(np.asarray(part.elastic.reach)) == set(skin.ravel())


def test_the_memory_is_told_before_anything_is_solved_and_no_more_where_nothing_changed(spleen):
    told = []

    found = assess(SetReach(REACH)(spleen), measured=told.append)
    assess(replace(found.organ, title="Spleen"), before=found, measured=told.append)

    assert [size.bytes for size in told] == [found.scene.bodies[0].response.size.bytes]


def test_another_region_is_another_tissue(spleen):
    found = assess(SetReach(REACH)(spleen))
    fewer = {**found.organ.regions, REACH: found.organ.regions[REACH][::2]}

    again = assess(replace(found.organ, regions=fewer), before=found)

    assert again.scene.bodies[0].response.size.pushed < found.scene.bodies[0].response.size.pushed


def test_a_reach_that_is_gone_is_an_error_with_the_regions_there_are(spleen):
    gone = RemoveRegion(REACH)(SetReach(REACH)(spleen))

    (problem,) = assess(gone).errors

    assert problem.where == "fill.reach" and "'lower pole'" in str(problem.expected)
    assert assess(problem.fix(gone)).errors == ()
    with pytest.raises(EditError, match="no region apex"):
        SetReach("apex")(spleen)
    with pytest.raises(EditError, match="hilum has no vertices"):
        SetReach("hilum")(replace(spleen, regions={"hilum": np.empty(0, int)}))


def test_the_verb_sets_the_filling_and_says_the_memory_first(file, capsys):
    words = ["--tetrahedra", "500", "--nodal-share", "0.5", "--reach", REACH]

    assert main(["material", str(file), *words, "-o", str(file), "--json"]) == 0

    said = capsys.readouterr()
    report = json.loads(said.out)
    assert report["scene"]["fill"] == asdict(FillPart(500, 0.5, REACH))
    assert f"its response takes {1e-6 * report['response_bytes']:.1f} MB for " in said.err
    assert read_organ(file).fill == FillPart(500, 0.5, REACH)
    assert main(["material", str(file), "--reach", "none", "-o", str(file), "--json"]) == 0
    assert read_organ(file).fill.reach == ""
    assert json.loads(capsys.readouterr().out)["response_bytes"] > report["response_bytes"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--tetrahedra", "12"], "Tetrahedra must be a whole number of 100 to 40000, got 12"),
        (["--nodal-share", "1.5"], "Nodal share must be 0 to 1, got 1.5"),
        (["--reach", "apex"], "There is no region apex"),
    ],
)
def test_a_filling_that_cannot_be_is_refused_with_a_sentence(file, words, sentence, capsys):
    before = file.read_bytes()

    assert main(["material", str(file), *words, "-o", str(file)]) == 1

    assert sentence in capsys.readouterr().err
    assert file.read_bytes() == before


@pytest.mark.landing
def test_a_response_too_large_for_memory_is_refused_before_it_is_solved(file, capsys, monkeypatch):
    """Of a body that is not flat, more tetrahedra than files hold make one."""
    monkeypatch.setattr("palpate.scenario.MOST_ELASTIC", 40_000)
    words = ["--tetrahedra", "24000", "-o", str(file)]

    assert main(["material", str(file), *words]) == 1

    said = capsys.readouterr().err
    assert "its response takes 118.5 MB for 1814 of 1814 particles" in said
    assert "linear solid: response: got 118.461" in said
    assert "expected at most 67.1089 MB: fill with fewer tetrahedra, or limit the reach" in said
    assert read_organ(file).fill.tetrahedra == 600


@pytest.mark.parametrize(
    ("kind", "reason"),
    [
        ("solid", "solids are moved whole, for they have no home springs"),
        ("linear_solid", "it costs what is touched, so there is nothing to let sleep"),
        ("corotated_solid", "solids are moved whole, for they have no home springs"),
        ("shell", "how far springs carry a pull, which is not how far a wall bends"),
    ],
)
def test_tissue_that_never_sleeps_says_why_it_allows_no_error_of_the_force(spleen, kind, reason):
    wall = 2e-3 if kind == "shell" else None
    organ = replace(
        SetChoice("kind", kind)(spleen),
        material=replace(spleen.material, wall_thickness=wall),
        hand=replace(spleen.hand, force_error=1e-3),
    )

    (problem,) = assess(organ).errors

    assert problem.where == "scene: force_error [N]"
    assert str(problem.expected).startswith("0: ") and reason in str(problem.expected)
    assert assess(SetConstant("hand", "force_error", 0.0)(organ)).errors == ()


def test_more_than_a_linear_solid_has_room_for_is_refused_before_it_is_filled(
    file, capsys, monkeypatch
):
    def fill(*words):
        raise AssertionError("it was filled")

    monkeypatch.setattr("palpate_editor.fill.fill_surface", fill)
    words = ["--kind", "linear", "--tetrahedra", "40000", "-o", str(file)]

    assert main(["material", str(file), *words]) == 1

    said = capsys.readouterr().err
    assert "fill.tetrahedra: got 40000, expected at most" in said
