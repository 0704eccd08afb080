# SPDX-License-Identifier: BSD-3-Clause
"""The scene that comes with Palpate: a liver with its gallbladder in the fossa."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import palpate
import palpate_meshes
import pytest
from palpate import scenario
from palpate.assessment.check_problem import ERROR
from palpate.cli.main import main
from palpate.layout.assemble import build, read_assembly, separate_bodies
from palpate.layout.check import check
from palpate.layout.costs import find_far_side, press_pair, write_press
from palpate.layout.gaps import find_least
from palpate.layout.layout_file import read_layout
from palpate.layout.publish import make_scenario
from palpate.runs.press import find_top, take_surface

SCENES = Path(palpate_meshes.__file__).parent / "scenes"
LAYOUT = SCENES / "liver_gallbladder.layout.json"
PUBLISHED = SCENES / "liver_gallbladder.palpate"


@pytest.fixture(scope="module")
def shipped() -> scenario.Scenario:
    return scenario.read(PUBLISHED)


@pytest.mark.landing
@pytest.mark.parametrize("path", sorted(SCENES.glob("*.layout.json")), ids=lambda path: path.name)
def test_every_layout_that_ships_has_nothing_that_forbids_publishing_it(path):
    found = check(path, read_layout(path).now, measures=False)

    assert [each.message for each in found.problems if each.severity == ERROR] == []


@pytest.mark.landing
def test_the_scene_is_what_its_layout_publishes(shipped):
    layout = read_layout(LAYOUT).now
    assembly = read_assembly(LAYOUT, layout)
    assert separate_bodies(assembly) == []

    made = scenario.pack(make_scenario(layout, assembly, build(assembly)))

    kept = scenario.pack(shipped)
    assert (
        json.loads(made.content)["scene"]["body_pairs"]
        == (json.loads(kept.content)["scene"]["body_pairs"])
    )
    assert made.arrays.keys() == kept.arrays.keys()
    for name, rows in made.arrays.items():
        np.testing.assert_allclose(rows, kept.arrays[name], rtol=1e-9, atol=1e-12, err_msg=name)


def test_a_hand_from_above_comes_to_the_liver_that_covers_the_gallbladder(shipped):
    top = find_top(shipped.scene)

    x, triangles = take_surface(shipped.scene, 1)
    found = palpate.find_closest_point(palpate.AabbTree(x, triangles), x, top.point)
    assert found.distance < 1e-9
    assert top.outward[2] > 0.9


def test_a_press_that_would_begin_inside_of_the_liver_is_refused(shipped, capsys):
    x, _ = take_surface(shipped.scene, 0)
    liver, triangles = take_surface(shipped.scene, 1)
    tree = palpate.AabbTree(liver, triangles)
    hidden = min(x, key=lambda v: palpate.find_closest_point(tree, liver, v).distance)
    at = ",".join(f"{1e3 * each:.2f}" for each in hidden)

    assert main(["press", str(PUBLISHED), f"--at={at}"]) == 1

    said = capsys.readouterr().err
    assert "where the tip would begin inside of body 1, expected a place that can be" in said


@pytest.mark.landing
def test_the_gallbladder_lies_in_the_fossa_half_a_millimetre_from_the_liver(shipped):
    layout = read_layout(LAYOUT).now
    assembly = read_assembly(LAYOUT, layout)
    fossa = scenario.read(SCENES.parent / "published" / "liver.palpate")
    regions = json.loads(fossa.authored)["content"]["regions"]
    number = list(regions).index("gallbladder fossa")
    rows = fossa.authored_arrays[f"regions/{number}"]

    least = find_least(*assembly.surfaces, 2e-3, np.zeros(3))

    assert least.size == pytest.approx(5e-4, abs=1e-6)
    bed = assembly.surfaces[1].x[rows]
    near = [np.linalg.norm(assembly.surfaces[0].used - p, axis=1).min() for p in bed]
    assert np.median(near) < 0.012  # [m] most of the bed is covered by the sac
    assert [body.name for body in layout.bodies] == ["gallbladder", "liver"]


@pytest.mark.landing
def test_pressed_for_a_second_it_raises_no_alarm_and_passes_through_nothing(shipped):
    scene = shipped.scene
    assembly = read_assembly(LAYOUT, read_layout(LAYOUT).now)

    costs = press_pair(scene, 0, assembly.surfaces)

    assert costs.alarm == ""
    assert costs.most_touching >= 3
    assert 0.0 < costs.least_gap < scene.body_pairs[0].thickness
    sac, liver = assembly.surfaces
    nearest = find_least(liver, sac, 2e-3, np.zeros(3))
    samples = write_press(scene, 0, find_far_side(sac, nearest))
    still, world = samples[0], palpate.World(scene)
    for sample in [*samples, *[still] * 200]:
        palpate.tick(scene, sample, 1e-3, world)
        assert not world.alarm


@pytest.mark.landing
def test_a_press_of_it_replays_to_the_bit(tmp_path, capsys):
    record = tmp_path / "press.prec"
    words = ["--at=-3,43,-23", "--depth", "3mm", "--record", str(record)]
    assert main(["press", str(PUBLISHED), *words]) == 0
    assert main(["replay", str(record)]) == 0
    assert "the same bits" in capsys.readouterr().out


def test_it_has_title_and_task_in_turkish_and_colours_of_both_organs(shipped):
    assert shipped.languages["tr"].title == "Safra kesesiyle karaciğer"
    assert shipped.languages["tr"].task and shipped.task
    colours = np.unique(shipped.authored_arrays["colours"], axis=0)
    assert len(colours) == 2
