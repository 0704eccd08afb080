# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of what is felt before and after the near field, and that they hold."""

from __future__ import annotations

import json
import re
from dataclasses import asdict
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.runs.press import find_top
from palpate.runs.trial import press_places, with_contact
from palpate.study.contact_reference import read_contact_reference
from palpate.study.felt import (
    HARD,
    NEAR,
    PRESSED,
    BlockRow,
    CostRow,
    ShareRow,
    measure_shares,
    measure_touch,
    press_block,
    stiffen,
)
from palpate.study.tool_block import open_blocks
from palpate_editor.compile import compile_organ
from palpate_editor.felt import (
    MESH_KINDS,
    PER_VERTEX,
    MeshRow,
    list_places,
    make_ellipsoid,
    press_mesh,
)
from palpate_editor.felt_tables import write_felt
from palpate_meshes.catalogue import PUBLISHED

ACCURACY = Path(__file__).parents[2] / "core" / "ACCURACY.md"


def find_row(*begin: str) -> list[float]:
    """Numbers of the row of ACCURACY.md's part on what is felt whose first cells are these."""
    text = ACCURACY.read_text(encoding="utf-8")
    part = text[text.index("[accuracy: felt]") :]
    start = "".join(rf"\| {re.escape(cell)} +" for cell in begin)
    row = re.search(rf"(?m)^{start}\|(.*)$", part)
    assert row is not None, begin
    return [float(number) for number in re.findall(r"\d+(?:\.\d+)?", row.group(1))]


# --- the block -------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def block():
    return press_block([5e-3], places=1, kinds=1)


@pytest.mark.landing
def test_a_ball_in_the_block_is_felt_as_on_tissue_by_the_near_field_and_not_by_the_hard_law(block):
    hard, near = block

    assert (hard.law, near.law) == (HARD, NEAR) and hard.theory == near.theory
    assert hard.felt / hard.theory > 1.5
    cases = read_contact_reference("block").list_cases("linear")
    [truth] = [c for c in cases if (c.radius, c.place) == (near.radius, near.place)]
    assert near.felt == pytest.approx(truth.find_force(PRESSED), rel=0.1)


def test_the_rows_of_the_block_are_what_comes_out(block):
    for row in block:
        kept = find_row("springs + volumes", row.law)
        least, most = kept[4], kept[5]  # of the ball of 5 mm, behind the mean
        assert 0.98 * least <= row.felt / row.theory <= 1.02 * most


@pytest.mark.verify
def test_every_row_of_the_block_is_what_comes_out():
    rows = press_block()

    for kind in ("springs + volumes", "linear solid"):
        for law in (HARD, NEAR):
            ours = [r.felt / r.theory for r in rows if (r.kind, r.law) == (kind, law)]
            balls = np.reshape(ours, (3, 3))
            found = np.column_stack([balls.mean(axis=1), balls.min(axis=1), balls.max(axis=1)])
            assert find_row(kind, law) == pytest.approx(found.ravel(), rel=0.02, abs=0.01)


# --- the meshes ------------------------------------------------------------------------------


@pytest.mark.parametrize(("kind", "law"), MESH_KINDS, ids=lambda value: value.replace(" ", "_"))
def test_the_coarsest_mesh_is_what_comes_out(kind, law):
    row = press_mesh(kind, law, 300)

    assert 1e3 * row.felt == pytest.approx(find_row(kind.replace("_", " "), law)[0], rel=0.02)


def test_the_same_places_are_pressed_on_every_mesh():
    coarse, fine = (
        list_places(compile_organ(make_ellipsoid("mass_spring", HARD, count)))
        for count in (300, 1200)
    )

    for one, other in zip(coarse, fine, strict=True):
        assert one.point == pytest.approx(other.point, abs=2e-3)


def test_a_finer_solid_has_as_many_more_tetrahedra():
    assert make_ellipsoid("solid", NEAR, 600).fill.tetrahedra == 600 * PER_VERTEX
    assert make_ellipsoid("solid", NEAR, 600).material.wall_thickness is None
    assert make_ellipsoid("shell", HARD, 600).material.wall_thickness == 5e-3


@pytest.mark.verify
def test_every_mesh_is_what_comes_out_and_the_near_field_is_felt_alike_on_all():
    found = {
        (kind, law): [1e3 * press_mesh(kind, law, count).felt for count in (300, 600, 1200, 2400)]
        for kind, law in MESH_KINDS
    }

    for (kind, law), felt in found.items():
        assert find_row(kind.replace("_", " "), law)[:4] == pytest.approx(felt, rel=0.02)
    near = found["solid", NEAR]
    assert max(near) / min(near) < 1.08


# --- what carries a scene ----------------------------------------------------------------------


def foundation() -> palpate.Scene:
    """A surface that home springs alone carry: the springs along it have next to no tension."""
    return compile_organ(make_ellipsoid("mass_spring", HARD, 100))


def test_what_is_twice_as_stiff_by_one_is_as_it_was():
    scene = foundation()
    places = [find_top(scene)]

    for part in ("home", "links"):
        same = press_places(stiffen(scene, part, 1.0), places)[0].force
        assert same == pytest.approx(press_places(scene, places)[0].force, rel=1e-9)
    assert stiffen(scene, "angles") is None


def test_doubled_constants_are_twice_those_of_before():
    tissue = foundation().bodies[0].tissue

    home = stiffen(foundation(), "home").bodies[0].tissue
    links = stiffen(foundation(), "links").bodies[0].tissue

    assert np.asarray(home.home) == pytest.approx(2.0 * np.asarray(tissue.home))
    assert np.asarray(home.springs.stiffness) == pytest.approx(np.asarray(tissue.springs.stiffness))
    assert np.asarray(links.home) == pytest.approx(np.asarray(tissue.home))
    assert np.asarray(links.springs.stiffness) == pytest.approx(
        2.0 * np.asarray(tissue.springs.stiffness)
    )


def test_of_a_foundation_home_springs_carry_all_and_the_springs_along_it_next_to_nothing():
    """Twice as stiff it is felt less than twice as much: hand and contact are springs as well."""
    row = measure_shares("a", foundation(), 1)

    assert row.law == HARD and row.places == 1 and row.angles_twice is None
    assert row.home_share == pytest.approx(1.0, abs=0.05)
    assert 1.7 < row.home_twice < 2.0
    assert row.links_twice == pytest.approx(1.0, abs=0.05)


def test_angles_of_which_no_triangle_takes_more_are_not_doubled():
    """A wall's own constants under plane stress are at the end of what is stable."""
    wall = compile_organ(make_ellipsoid("molecular", HARD, 100))

    assert stiffen(wall, "angles", 1.0) is not None
    assert stiffen(wall, "angles") is None


def test_a_solid_with_a_near_field_keeps_it_when_its_springs_are_doubled():
    scene = with_contact(open_blocks(hard=True)[0].load(), 6e3)

    changed = stiffen(scene, "links")

    assert changed.bodies[0].contact_modulus == 6e3 and changed.bodies[0].near_field is not None
    assert stiffen(scene, "home") is None


SPRINGS = Path(__file__).parents[1] / "scenes" / "springs"


@pytest.mark.parametrize(
    "name",
    [
        "kidney",
        *(pytest.param(name, marks=pytest.mark.verify)
          for name in ("spleen", "liver", "gallbladder", "stomach")),
    ],
)  # fmt: skip
def test_the_row_of_a_scene_is_what_comes_out(name):
    row = measure_shares(name, palpate.scenario.read(str(SPRINGS / f"{name}.palpate")).scene)

    felt, share, *twice = find_row(f"springs/{name}.palpate", row.law)
    assert 1e3 * row.felt == pytest.approx(felt, rel=0.02)
    assert 100.0 * row.home_share == pytest.approx(share, abs=2.0)
    found = [row.home_twice, row.links_twice, row.angles_twice]
    assert twice == pytest.approx([each for each in found if each is not None], abs=0.03)


# --- what touch costs --------------------------------------------------------------------------


def test_the_cost_of_touch_is_the_ratio_of_medians_of_a_clock():
    times = iter(range(1000))

    def clock() -> float:
        """Each second span, one in touch, takes three times as long."""
        k = next(times)
        return float(k // 4 * 4 + (0, 1, 1, 4)[k % 4])

    row = measure_touch("springs", foundation(), clock)

    assert row.ratio == pytest.approx(3.0)
    assert row.substeps_in_touch > row.substeps_in_air >= 1


# --- the verb ----------------------------------------------------------------------------------


def test_the_verb_gives_the_rows_of_the_parts_that_were_asked_for(capsys):
    scene = str(PUBLISHED / "simple_tissue.palpate")

    assert main(["felt", scene, "--only", "scenes", "--json"]) == 0

    report = json.loads(capsys.readouterr().out)
    assert list(report) == ["scenes"] and [row["scene"] for row in report["scenes"]] == [scene]
    assert report["scenes"][0]["places"] == 5


def test_a_file_that_is_not_there_is_refused(tmp_path, capsys):
    assert main(["felt", str(tmp_path / "no.palpate"), "--only", "scenes"]) == 1

    assert "no.palpate" in capsys.readouterr().err


def test_the_tables_have_every_row_once():
    report = {
        "block": [asdict(BlockRow("springs", law, ball, place, felt, 0.05))
                  for law, felt in ((HARD, 0.1), (NEAR, 0.05)) for ball in (3e-3, 8e-3)
                  for place in "ab"],
        "mesh": [asdict(MeshRow("linear_solid", NEAR, count, 5 * count, 0.1 + 1e-6 * count))
                 for count in (300, 1200)],
        "scenes": [asdict(ShareRow("a/b/c.palpate", HARD, 5, 0.119, 0.9, 1.64, 1.06, None))],
        "cost": [asdict(CostRow("shell", HARD, 2.65, 2, 5))],
    }  # fmt: skip

    text = write_felt(report)

    rows = [[c.strip() for c in line.strip("|").split("|")] for line in text.splitlines()
            if line.startswith("|") and "--" not in line]  # fmt: skip
    assert ["springs", "hard", "2.00 (2.00 to 2.00)", "2.00 (2.00 to 2.00)"] in rows
    assert ["linear solid", "near field", "100", "101", "1%"] in rows
    assert ["b/c.palpate", "hard", "119 mN", "90%", "1.64", "1.06", "-"] in rows
    assert ["shell", "hard", "2", "5", "2.6"] in rows or ["shell", "hard", "2", "5", "2.7"] in rows
    assert len(rows) == 4 + 2 + 1 + 1 + 1
