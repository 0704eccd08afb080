# SPDX-License-Identifier: BSD-3-Clause
"""Instruments of capsules in Python: values, files, records, pictures."""

import copy
import json
import pickle
import runpy
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.files.refusal import Refusal
from palpate.render import build_instrument, build_shade, draw_picture, place_instrument
from palpate.render.instrument import find_rotation, name_look
from palpate.render.instrument_shade import find_glow, place_axes
from surfaces import MEMBRANE, ellipsoid

MESHES = Path(__file__).resolve().parents[2] / "meshes"
SCENARIOS = MESHES / "scenarios"


def probe_scene(**fields) -> palpate.Scene:
    scene = palpate.make_scene(
        palpate.build_mass_spring(ellipsoid((0.03, 0.025, 0.02), 2), MEMBRANE, 50.0)
    )
    scene.instruments[0].tool = palpate.Tool(
        radius=0.003,
        capsules=[palpate.Capsule(to=(0.0, 0.0, 0.02))],
    )
    for name, value in fields.items():
        setattr(scene.instruments[0], name, value)
    return palpate.build_scene(scene)


def test_an_instrument_is_a_value():
    instrument = probe_scene(trocar=(0.0, 0.0, 0.1)).instruments[0]

    for same in (copy.deepcopy(instrument), pickle.loads(pickle.dumps(instrument))):
        assert [list(c.to) for c in same.tool.capsules] == [[0.0, 0.0, 0.02]]
        assert same.trocar == pytest.approx([0.0, 0.0, 0.1])
    assert "Capsule" in repr(instrument.tool)
    instrument.trocar = None
    assert instrument.trocar is None


def test_a_file_keeps_capsules_and_trocar_to_the_bit_and_refuses_damaged_ones(tmp_path):
    path = tmp_path / "probe.palpate"
    scene = probe_scene(trocar=(0.01, 0.02, 0.13))
    scenario.write(path, scenario.Scenario(scene=scene))

    read = scenario.read(path).scene.instruments[0]

    assert list(read.trocar) == [0.01, 0.02, 0.13]
    assert [list(c.from_) + list(c.to) for c in read.tool.capsules] == [[0, 0, 0, 0, 0, 0.02]]
    scene.instruments[0].tool.capsules = [palpate.Capsule(to=(0.0, 0.0, 0.7))]
    with pytest.raises(ValueError, match=r"scene\.instruments\[0\]\.tool\.capsules: got 0\.7"):
        scenario.write(path, scenario.Scenario(scene=scene))


def test_a_ball_has_no_trocar():
    scene = probe_scene()
    scene.instruments[0].tool.capsules = []
    scene.instruments[0].trocar = (0.0, 0.0, 0.1)

    with pytest.raises(ValueError, match="none for a ball"):
        palpate.build_scene(scene)


def test_what_is_seen_of_an_instrument_goes_from_its_tip_along_its_shaft():
    scene = probe_scene()
    shape = build_instrument(scene.instruments[0].tool)
    assert shape is not None and build_instrument(palpate.Tool()) is None
    turned = place_instrument(shape, (0.01, 0.0, 0.05), (0.0, np.sqrt(0.5), 0.0, np.sqrt(0.5)))
    vertices = np.concatenate([part.shape.vertices for part in turned])
    normals = np.concatenate([part.shape.normals for part in turned])

    # z became x
    assert vertices[:, 0].min() == pytest.approx(0.01 - 0.003, abs=1e-5)
    assert vertices[:, 0].max() > 0.2
    assert np.abs(vertices[:, 1]).max() == pytest.approx(0.003, abs=1e-5)
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1.0, abs=1e-5)

    x = np.asarray(palpate.surface_position(palpate.World(scene).bodies[0]))
    faces = scene.bodies[0].tissue.triangles
    options = {"tool": ((0.01, 0.0, 0.05), 0.003), "size": (320, 200), "supersample": 1}
    ball = draw_picture(x, faces, **options)
    drawn = draw_picture(x, faces, instrument=turned, **options)
    assert (ball != drawn).any()


def test_an_assessment_says_the_shape_of_its_tools():
    organ = scenario.read(MESHES / "published" / "spleen.palpate")
    path = SCENARIOS / "spleen_probe.json"
    made = with_assessment(path, read_assessment(path), organ)

    instrument = made.scene.instruments[0]
    assert instrument.tool.radius == 0.0025 and instrument.tool.friction == 0.1
    assert [list(c.to) for c in instrument.tool.capsules] == [[0, 0, 0.02]]
    assert instrument.trocar is not None
    # a scene with another tool than its assessment says is refused
    wrong = json.loads(made.assessment)
    wrong["tools"]["probe"]["radius_m"] = 0.004
    other = scenario.Scenario(
        scene=made.scene, assessment=json.dumps(wrong), assessment_arrays=made.assessment_arrays
    )
    with pytest.raises(ValueError, match="radius_m: got 0.004, expected 0.0025"):
        scenario.draw_task(other)
    wrong["tools"]["probe"]["length_m"] = 0.9
    with pytest.raises(Refusal, match="tools.probe"):
        with_assessment(path, wrong, organ)


def test_the_example_of_two_instruments_holds():
    program = MESHES.parent / "tests" / "examples" / "two_instruments" / "two_instruments.py"

    assert runpy.run_path(str(program))["main"]() == 0


def test_an_instrument_is_drawn_as_what_of_it_touches():
    wide, thin = palpate.Tool(radius=0.005), palpate.Tool(radius=0.0025)
    for tool in (wide, thin):
        tool.capsules = [palpate.Capsule(to=[0.0, 0.0, 0.02])]
    assert [name_look(t) for t in (palpate.Tool(), thin, wide)] == ["ball", "probe", "laparoscope"]
    drawn = build_instrument(wide)
    assert drawn is not None
    x = drawn.parts[0].shape.vertices
    tip = x[x[:, 2] < 0.25]
    assert np.abs(tip[:, :2]).max() == pytest.approx(0.005, abs=1e-5)
    # the lens is slanted: its foremost point stands out of the round end that touches
    assert -0.010 < x[:, 2].min() < -0.005


def test_a_grasper_is_drawn_as_long_and_as_wide_as_its_jaws():
    class Jaws:
        hinge = (0.0, 0.0, 0.0135)
        axis = (1.0, 0.0, 0.0)

    class Grasper:
        radius, jaws = 0.0006, Jaws()
        capsules = [palpate.Capsule(from_=[0, y, 0], to=[0, y, 0.012]) for y in (6e-4, -6e-4)]

    drawn = build_instrument(Grasper())
    assert drawn is not None and drawn.hinge == 0.0135
    jaws = [part.shape.vertices for part in drawn.parts if part.turns]
    assert len(jaws) == 2
    for x in jaws:
        assert x[:, 2].min() == pytest.approx(0.0, abs=1e-4)
        assert np.abs(x[:, 0]).max() == pytest.approx(0.5 * 0.0024, abs=1e-4)
    shaft = next(part.shape.vertices for part in drawn.parts if not part.turns)
    assert np.ptp(shaft[:, 2]) == pytest.approx(0.3095 - 0.0008, abs=2e-3)

    placed = place_instrument(drawn, (0, 0, 0), (0, 0, 0, 1), 0.4)
    tips = [part.shape.vertices[part.shape.vertices[:, 2].argmin(), 1] for part in placed[1:]]
    from_, _ = place_axes(Grasper(), (0, 0, 0), np.eye(3), 0.4)
    # drawn jaws open to where those that touch are
    assert sorted(np.sign(tips)) == sorted(np.sign(from_[:, 1])) == [-1, 1]
    assert max(np.abs(tips)) == pytest.approx(np.abs(from_[:, 1]).max(), abs=1.5e-3)


def test_the_shade_of_an_instrument_is_of_its_tip_and_its_shaft():
    tool = palpate.Tool(radius=0.0025)
    tool.capsules = [palpate.Capsule(to=[0.0, 0.0, 0.02])]
    quarter = find_rotation((0.0, np.sqrt(0.5), 0.0, np.sqrt(0.5)))  # z becomes x
    shade = build_shade(tool, (0.0, 0.0, 0.1), quarter, glow=find_glow(True, 1.0))

    assert shade.from_ == pytest.approx(np.array([[0, 0, 0.1], [0.02, 0, 0.1]]), abs=1e-7)
    assert shade.to == pytest.approx(np.array([[0.02, 0, 0.1], [0.25, 0, 0.1]]), abs=1e-7)
    assert find_glow(False, 9.0) == 0.0 < shade.glow < find_glow(True, 5.0) == 1.0
