# SPDX-License-Identifier: BSD-3-Clause
"""A stiff spot in the tissue: its constants, the scene that an attempt draws, and how it feels."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment.inclusion import PATCH, Inclusion, find_loss, find_stress
from palpate.assessment.publish import read_assessment, take_attempt, with_assessment
from palpate.files.refusal import Refusal

MESHES = Path(__file__).resolve().parents[2] / "meshes"
WEBER = 1.23
"""[-] Between stiffnesses that a hand can tell apart: some 23 % [JonesHunter90]."""

Json = dict[str, Any]


def spleen_with_lumps() -> tuple[Json, scenario.Scenario]:
    """A spleen with two balls, one of which is stiff."""
    organ = scenario.read(MESHES / "published" / "spleen.palpate")
    x = np.asarray(organ.scene.bodies[0].tissue.rest_position)
    top, bottom = x[x[:, 2].argmax()], x[x[:, 2].argmin()]
    places = {}
    for name, point, side in (("top", top, -1.0), ("bottom", bottom, 1.0)):
        centre = point + np.array([0.0, 0.0, side * 0.012])
        places[name] = {
            "organ": "spleen",
            "ball": [*point.tolist(), 0.01],
            "inclusion": {"ball": [*centre.tolist(), 0.01], "stiffness": 10},
        }
    assessment = {
        "palpate_scenario": 1, "id": "lumps", "version": "1", "title": "t",
        "organs": {"spleen": {}}, "tools": {"tip": {"kind": "probe"}}, "places": places,
        "parameters": {"spot": {"unit": "place", "choose": ["top", "bottom"]}},
        "inclusion": "$spot",
        "steps": [{"id": "find", "do": "find", "at": "$spot", "say": "t"}],
        "finish": {"time_limit_s": 60}, "texts": {"en": {"title": "Lumps", "t": "Find it"}},
    }  # fmt: skip
    return assessment, organ


@pytest.fixture(scope="module")
def lumps() -> scenario.Scenario:
    assessment, organ = spleen_with_lumps()
    return with_assessment("lumps.json", assessment, organ)


def test_a_point_force_is_in_balance_with_the_stress_under_it():
    step = 0.02
    line = np.arange(-30.0, 30.0, step) + 0.5 * step
    x, y = np.meshgrid(line, line)
    plane = np.stack([x, y, np.full_like(x, 0.5)], axis=-1)

    stress = find_stress(plane, 0.45)

    assert stress[..., 2].sum() * step * step == pytest.approx(-1.0, rel=1e-2)
    under = find_stress(np.array([[0.0, 0.0, 2.0]]), 0.45)[0]
    assert under[2] == pytest.approx(-3.0 / (8.0 * np.pi), rel=1e-6)  # -3 / (2 pi z²)


def test_a_disc_gives_way_less_over_what_is_stiffer_nearer_and_larger():
    def loss(radius: float, depth: float, times: float, aside: float = 0.0) -> float:
        return find_loss(Inclusion(np.zeros(3), radius, times), aside, depth, 5e3, 0.45)

    half_space = 16.0 / (3.0 * np.pi**2 * 5e3 / (1.0 - 0.45**2) * PATCH)
    assert loss(0.01, 0.015, 1.0) == 0.0
    assert 0.0 < loss(0.01, 0.02, 10.0) < loss(0.01, 0.015, 10.0) < half_space
    assert loss(0.01, 0.015, 2.0) < loss(0.01, 0.015, 10.0)
    assert loss(0.01, 0.015, 10.0, aside=0.03) < 0.05 * loss(0.01, 0.015, 10.0)
    # what is softer gives way more
    assert loss(0.01, 0.015, 0.5) < 0.0


def test_a_seed_draws_the_place_and_the_scene_has_the_constants_of_that_place_alone(lumps):
    drawn = {}
    for seed in range(8):
        task = scenario.draw_task(lumps, "", seed)
        drawn[task.inclusion] = task
    assert set(drawn) == {"top", "bottom"}
    plain = lumps.scene.bodies[0]

    for name, task in drawn.items():
        body = scenario.draw_scene(lumps, task).bodies[0]
        arrays = lumps.assessment_arrays
        springs = np.asarray(body.tissue.springs.stiffness)
        assert np.array_equal(springs, arrays[f"constants/{name}/tissue/springs/stiffness"])
        far = np.asarray(body.far_compliance)
        assert np.array_equal(far, arrays[f"constants/{name}/contact/far_compliance"])
        assert springs.max() > 3.0 * np.asarray(plain.tissue.springs.stiffness).min()
        assert np.array_equal(body.tissue.mass, plain.tissue.mass)
        assert body.substeps >= plain.substeps
        assert body.spectrum_stiffness > plain.spectrum_stiffness
        assert take_attempt(lumps, task).scene.bodies[0].spectrum_stiffness == (
            body.spectrum_stiffness
        )


@pytest.mark.landing
def test_a_file_keeps_the_constants_and_refuses_them_damaged(lumps, tmp_path):
    path = tmp_path / "lumps.palpate"
    scenario.write(path, lumps)
    read = scenario.read(path)
    task = scenario.draw_task(read, "", 0)
    again = scenario.draw_scene(read, task).bodies[0]
    assert again.spectrum_stiffness == scenario.draw_scene(lumps, task).bodies[0].spectrum_stiffness

    container = scenario.pack(lumps)
    springs = "assessment/constants/top/tissue/springs/stiffness"
    for name, array in (
        (springs, np.ones(3)),
        (springs, np.full(len(container.arrays[springs]), 1e300)),
        ("assessment/constants/top/tissue/mass", np.ones(3)),
        ("assessment/constants/nowhere/tissue/springs/stiffness", np.ones(3)),
    ):
        other = scenario.Container(
            format="palpate", version=container.version, content=container.content,
            arrays={**container.arrays, name: array},
        )  # fmt: skip
        with pytest.raises(palpate.FileError, match="constants/"):
            scenario.unpack(other, "x.palpate")


@pytest.mark.landing
def test_an_inclusion_that_nobody_draws_or_that_is_not_there_is_refused():
    assessment, organ = spleen_with_lumps()
    for change in (
        lambda a: a.pop("inclusion"),
        lambda a: a.update(inclusion="side"),
        lambda a: a["places"]["top"].pop("inclusion"),
        lambda a: a["places"]["top"]["inclusion"].update(stiffness=0),
        lambda a: a["places"]["top"]["inclusion"].update(ball=[0, 0, 0, -1]),
        lambda a: a["places"]["top"]["inclusion"].update(colour=1),
    ):
        other = copy.deepcopy(assessment)
        change(other)
        with pytest.raises(Refusal):
            made = with_assessment("lumps.json", other, organ)
            for seed in range(8):
                try:
                    scenario.draw_task(made, "", seed)
                except ValueError as problem:
                    raise Refusal("lumps.json", "", str(problem), "") from None


def feel(scene: palpate.Scene, point: np.ndarray, outward: np.ndarray, depth: float) -> float:
    """[N/m] of a press so deep, at rest."""
    world, radius = palpate.World(scene), scene.instruments[0].tool.radius
    command = palpate.HapticCommand()
    for tick in range(700):
        sunk = min(-0.003 + 3e-5 * tick, depth)
        sample = palpate.HapticSample(time=1e-3 * tick, position=point + outward * (radius - sunk))
        command = palpate.tick(scene, sample, 1e-3, world)
    tip = np.asarray(world.instruments[0].tool.position)
    return float(np.linalg.norm(command.force) / (radius - (tip - point) @ outward))


@pytest.mark.landing
def test_the_lumps_of_the_liver_are_felt_where_they_are_and_nowhere_else():
    assessment = read_assessment(MESHES / "scenarios" / "liver_hidden_lump.json")
    organ = scenario.read(MESHES / "published" / "liver.palpate")
    made = with_assessment("a", assessment, organ)
    assert len(assessment["parameters"]["spot"]["choose"]) == len(assessment["places"]) == 8
    tissue = organ.scene.bodies[0].tissue
    x = np.asarray(palpate.compute_surface(tissue, tissue.rest_position))
    normals = np.asarray(palpate.compute_vertex_normals(x, np.asarray(tissue.triangles)))
    where = {name: int(((x - place["ball"][:3]) ** 2).sum(axis=1).argmin())
             for name, place in assessment["places"].items()}  # fmt: skip
    plain = {name: feel(organ.scene, x[v], normals[v], 0.006) for name, v in where.items()}
    drawn = {}
    for seed in range(60):
        task = scenario.draw_task(made, "", seed)
        drawn.setdefault(task.inclusion, task)
    assert set(drawn) == set(where)

    names = sorted(where)
    for name in names:
        scene = scenario.draw_scene(made, drawn[name])
        v, other = where[name], names[names.index(name) - 1]
        assert feel(scene, x[v], normals[v], 0.006) > WEBER * plain[name], name
        elsewhere = feel(scene, x[where[other]], normals[where[other]], 0.006)
        assert elsewhere == pytest.approx(plain[other], rel=0.03), (name, other)


def test_the_schema_knows_inclusions():
    import jsonschema

    assessment, _ = spleen_with_lumps()
    schema = Path(palpate.__file__).parent / "schemas" / "assessment.schema.json"
    check = jsonschema.Draft202012Validator(json.loads(schema.read_text(encoding="utf-8")))

    check.validate(assessment)
    assessment["places"]["top"]["inclusion"]["colour"] = 1
    assert not check.is_valid(assessment)
