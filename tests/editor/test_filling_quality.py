# SPDX-License-Identifier: GPL-3.0-or-later
"""What is told of a filling: how many, how flat, how fine, where; and open organs are closed."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.scene.scene_parts import FillPart
from palpate_editor.check import assess
from palpate_editor.compile import mesh_of, surface_of
from palpate_editor.document import EMPTY, Filling, Organ
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import (
    CapHoles,
    DecimateTo,
    EditError,
    SetChoice,
    SetConstant,
    SetRegion,
)
from palpate_editor.edits.cap import find_caps
from palpate_editor.fill import fill_organ
from palpate_editor.filling_quality import compute_dihedrals, compute_volume, measure_filling
from palpate_editor.shipped import make_organ as make_shipped
from palpate_meshes.generate import ellipsoid, tube

REGULAR = float(np.degrees(np.arccos(1.0 / 3.0)))
"""[degree] Between two faces of a regular tetrahedron."""
MOST_FLAT = 5.0


def make_organ(made: tuple[np.ndarray, np.ndarray], tetrahedra: int = 900) -> Organ:
    surface = surface_of(palpate.SurfaceMesh(*made))
    organ = replace(EMPTY.with_surface(surface), imported=surface, name="spleen")
    return replace(SetChoice("kind", "solid")(organ), fill=FillPart(tetrahedra))


@pytest.fixture(scope="module")
def spleen() -> Organ:
    organ = make_organ(ellipsoid(600))
    x = organ.surface.vertices
    return SetRegion("end", np.flatnonzero(x[:, 0] > 0.6 * x[:, 0].max()))(organ)


@pytest.fixture(scope="module")
def opened() -> Organ:
    """A gallbladder, cut at its duct."""
    return make_organ(tube(600))


# ---------------------------------------------------------------- measuring


def test_angles_of_a_regular_and_of_a_flat_tetrahedron():
    regular = np.array([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    flat = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.01]])
    x, t = np.concatenate([regular, flat]), np.array([[0, 1, 2, 3], [4, 5, 6, 7]])

    angles = compute_dihedrals(x, t)

    assert angles[0] == pytest.approx(REGULAR, abs=1e-9)
    # faces with the normals (0, -h, 1) and (-h, -h, 1): the tangent is h / sqrt(1 + h²)
    h = 0.01
    assert angles[1] == pytest.approx(np.degrees(np.arctan(h / np.sqrt(1.0 + h * h))), rel=1e-9)
    assert compute_dihedrals(7.0 * x[:, ::-1] + 3.0, t[:, [1, 0, 2, 3]]) == pytest.approx(angles)
    assert compute_volume(regular[[0, 2, 1, 3]], np.array([[0, 1, 2, 3]])) == pytest.approx(8 / 3)


def test_a_report_is_of_the_tetrahedra_that_fill_the_organ(spleen):
    quality, solid = measure_filling(spleen), fill_organ(spleen)

    assert (quality.asked, quality.tetrahedra) == (900, len(solid.tetrahedra))
    assert quality.tetrahedra == pytest.approx(900, rel=0.1)
    smallest = np.degrees(palpate.compute_smallest_dihedral(solid))
    assert quality.angles_deg.min() == pytest.approx(smallest, rel=1e-9)
    assert 0.9 < quality.volume_share < 1.05
    assert 0.0 < quality.outside_distance < quality.edges[1]
    assert quality.edges[0] < quality.edges[1] < quality.edges[2]
    assert quality.fine_edge is None and quality.caps == ()


def test_places_are_the_flattest_and_apart(spleen):
    quality = measure_filling(spleen)

    angles = [place.angle_deg for place in quality.places]
    assert len(angles) == 5 and angles == sorted(angles)
    assert angles[0] == quality.angles_deg.min()
    points = np.array([place.point for place in quality.places])
    away = np.linalg.norm(points[:, None] - points[None], axis=2)[np.triu_indices(5, 1)]
    assert away.min() >= 3.0 * quality.edges[1]


def test_a_graded_filling_says_how_fine_it_is_at_its_region(spleen):
    finer = replace(spleen, fill=FillPart(3000, fine_region="end", fine_ratio=0.4))
    whole = replace(spleen, fill=FillPart(3000, fine_region="end", fine_ratio=1.0))

    graded, plain = measure_filling(finer), measure_filling(whole)

    assert graded.fine_edge < 0.8 * plain.fine_edge
    assert graded.edges[2] > plain.edges[2]
    assert graded.tetrahedra == pytest.approx(3000, rel=0.1)
    assert "filling" not in {p.key for p in assess(finer).problems}


@pytest.mark.landing
@pytest.mark.parametrize("region", ["hilum", "upper pole", "attachment"])
def test_a_graded_filling_of_a_shipped_organ_has_as_many_as_were_asked_for(region):
    organ = make_shipped("spleen")
    fine = replace(organ, fill=FillPart(3000, sizing="counted", fine_region=region))

    assert measure_filling(fine).tetrahedra == pytest.approx(3000, rel=0.07)


def test_an_improved_filling_is_not_complained_of(spleen):
    assert assess(spleen).facts.tissue.filling.smallest_angle_deg > MOST_FLAT
    assert not {"flat_tetrahedra", "filling"} & {p.key for p in assess(spleen).problems}


def test_flat_tetrahedra_of_a_file_are_told_with_their_place():
    """Of 3.5 degrees: flat, and not so flat that the organ is filled again."""
    height = 0.04 * np.tan(np.radians(3.5))
    middle = np.array([[0.0, 0, 0], [0.04, 0, 0], [0, 0.04, 0], [0.04, 0.04, height]])
    x = np.concatenate([middle, [[0.02, 0.02, 0.05], [0.02, 0.02, -0.05]]])
    t = np.array([[0, 1, 2, 3], [0, 1, 3, 4], [0, 3, 2, 4], [0, 2, 1, 5], [1, 2, 3, 5]])
    corners = x[t]
    turned = np.einsum(
        "ij,ij->i",
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]),
        corners[:, 3] - corners[:, 0],
    )
    t[turned < 0] = t[turned < 0][:, [0, 2, 1, 3]]
    solid = palpate.SolidMesh(x, t)
    surface = surface_of(palpate.SurfaceMesh(x, np.asarray(palpate.find_boundary(solid))))
    organ = replace(EMPTY.with_surface(surface), imported=surface, filling=Filling(x, t))
    organ = replace(SetChoice("kind", "solid")(organ), fill=FillPart(len(t)))

    (problem,) = (p for p in assess(organ).problems if p.key == "flat_tetrahedra")

    assert "at 3.5 degrees to each other, at (20, 20, " in str(problem.got)
    assert problem.faces is not None and len(problem.faces) == 1


# ---------------------------------------------------------------- open organs


def test_an_open_organ_is_closed_for_filling_and_its_cap_is_known(opened):
    (loop,) = palpate.find_border_loops(opened.surface.triangles)

    capped = CapHoles(even=True, bent=True)(opened)

    assert palpate.is_closed(capped.surface.triangles) and find_caps(capped) == ["cap"]
    count = opened.vertex_count
    inside = capped.regions["cap"]
    assert set(inside[inside < count]) == set(loop)
    assert set(inside[inside >= count]) == set(range(count, capped.vertex_count))
    assert np.array_equal(capped.surface.vertices[:count], opened.surface.vertices)
    assert capped.material.wall_thickness is None
    assert measure_filling(capped).caps == ("cap",)
    assert {p.key for p in assess(capped).errors} <= {"no_title"}


def test_a_chosen_wall_goes_with_it_and_other_regions_stay(opened):
    hollow = SetConstant("material", "wall_thickness", 2e-3)(opened)
    named = SetRegion("cap", np.array([1, 2, 3]))(hollow)

    capped = CapHoles(even=True, bent=True)(named)

    assert capped.material.wall_thickness is None
    assert list(capped.regions) == ["cap", "cap 2"]
    assert list(capped.regions["cap"]) == [1, 2, 3]


def test_two_holes_have_two_caps():
    organ = make_organ(ellipsoid(600))
    x = organ.surface.vertices[:, 0]
    ends = np.isin(organ.surface.triangles, [x.argmin(), x.argmax()]).any(axis=1)
    surface = replace(organ.surface, triangles=organ.surface.triangles[~ends])
    used = np.unique(surface.triangles)
    number = np.zeros(len(surface.vertices), np.int32)
    number[used] = np.arange(len(used))
    cut = make_organ((surface.vertices[used], number[surface.triangles]))
    assert len(palpate.find_border_loops(cut.surface.triangles)) == 2

    capped = CapHoles(even=True, bent=True)(cut)

    assert find_caps(capped) == ["cap", "cap 2"]
    ends = [
        capped.surface.vertices[capped.regions[name]][:, 0].mean() for name in find_caps(capped)
    ]
    assert abs(ends[0] - ends[1]) > 0.03


def test_a_cap_is_known_after_decimation_too(opened):
    capped = CapHoles(even=True, bent=True)(opened)

    small = DecimateTo(300, features=True)(capped)

    cap = mesh_of(replace(capped.surface, triangles=pick_within(capped, "cap")))
    after = mesh_of(replace(small.surface, triangles=pick_within(small, "cap")))
    assert palpate.compute_area(after) == pytest.approx(palpate.compute_area(cap), rel=0.25)


def pick_within(organ: Organ, name: str) -> np.ndarray:
    inside = np.zeros(organ.vertex_count, bool)
    inside[organ.regions[name]] = True
    triangles = organ.surface.triangles
    return triangles[inside[triangles].all(axis=1)]


def test_a_closed_organ_has_nothing_to_close(spleen):
    with pytest.raises(EditError, match="There is no hole to fill"):
        CapHoles(even=True, bent=True)(spleen)


def test_a_solid_with_holes_is_offered_to_be_closed(opened):
    for organ in (opened, SetConstant("material", "wall_thickness", 2e-3)(opened)):
        (problem,) = (p for p in assess(organ).problems if p.key == "open_solid")

        assert problem.fix == CapHoles(even=True, bent=True) and "close it for filling" in str(
            problem.expected
        )
        assert {p.key for p in assess(problem.fix(organ)).errors} <= {"no_title"}


# ---------------------------------------------------------------- the verb


def test_the_verb_closes_fills_and_writes_what_rebuilds(opened, tmp_path, capsys):
    path, out = tmp_path / "a.organ", tmp_path / "b.organ"
    write_organ(path, replace(opened, history=None))

    assert main(["fill", str(path), "-o", str(out)]) == 1
    assert "an open one, 1 hole of" in capsys.readouterr().err and not out.exists()
    words = ["fill", str(path), "--close", "--tetrahedra", "1200", "-o", str(out)]
    assert main([*words, "--json"]) == 0

    report = json.loads(capsys.readouterr().out)
    assert report["caps"] == ["cap"] and report["asked"] == 1200
    assert report["tetrahedra"] == pytest.approx(1200, rel=0.1)
    assert sum(report["angles_deg"]["counts"]) == report["tetrahedra"]
    assert len(report["places"]) == 5 and report["problems"] == []
    assert find_caps(read_organ(out)) == ["cap"]
    assert main(["rebuild", str(out)]) == 0
    capsys.readouterr()
    assert main(words) == 0
    said = capsys.readouterr().out
    assert "of 1200 asked for" in said and "closed by: cap" in said and "the flattest:" in said


def test_the_verb_measures_without_writing_and_makes_a_solid_of_a_surface(spleen, tmp_path, capsys):
    path, out = tmp_path / "a.organ", tmp_path / "b.organ"
    write_organ(path, SetChoice("kind", "mass_spring")(spleen))
    before = path.read_bytes()

    assert main(["fill", str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["out"] is None and path.read_bytes() == before
    words = ["--fine", "end", "--fine-ratio", "0.4", "-o", str(out)]
    assert main(["fill", str(path), *words]) == 0
    assert "at the finer region" in capsys.readouterr().out
    made = read_organ(out)
    assert (made.model.kind, made.fill.fine_region, made.fill.fine_ratio) == ("solid", "end", 0.4)


@pytest.mark.parametrize(
    ("words", "code", "sentence"),
    [
        (["--fine-ratio", "0.4"], 2, "--fine-ratio has no effect without --fine REGION"),
        (["--fine", "apex"], 1, "There is no region apex"),
        (["--tetrahedra", "12"], 1, "must be a whole number of 100 to 40000, got 12"),
        (["--close"], 1, "There is no hole to fill"),
    ],
)
def test_the_verb_refuses_what_cannot_be_with_a_sentence(
    spleen, tmp_path, capsys, words, code, sentence
):
    path = tmp_path / "a.organ"
    write_organ(path, spleen)
    before = path.read_bytes()

    assert main(["fill", str(path), *words, "-o", str(path)]) == code
    assert sentence in capsys.readouterr().err and path.read_bytes() == before
