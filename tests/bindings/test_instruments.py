# SPDX-License-Identifier: BSD-3-Clause
"""Instruments of capsules in Python: values, files, records, pictures."""

import copy
import json
import pickle
import runpy
import zipfile
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.assessment.selfplay import attempt
from palpate.bench.part_goals import leave_out
from palpate.error import FileError
from palpate.files.refusal import Refusal
from palpate.render import build_instrument, build_shade, draw_picture, place_instrument
from palpate.render.instrument import find_rotation, name_look
from palpate.render.instrument_meshes import MESHES as DRAWN
from palpate.render.instrument_meshes import read_part
from palpate.render.instrument_shade import find_glow, place_axes
from palpate.runs.cause import scale_pressure
from palpate.runs.device_check import build_wall
from palpate.scene.instrument_kinds import KINDS
from palpate.scene.pair_friction import keep_pairs
from palpate.scene.scene_file import build_tool
from palpate.scene.scene_parts import ToolPart
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


def grasper_scene(**fields) -> palpate.Scene:
    scene = probe_scene()
    tool = scene.instruments[0].tool
    tool.radius, tool.friction = 0.0012, 0.5
    tool.capsules = [
        palpate.Capsule(from_=(0.0, y, 0.0), to=(0.0, y, 0.02)) for y in (0.0012, -0.0012)
    ]
    tool.jaws = palpate.Jaws(**fields)
    scene.instruments[0].tool = tool
    return scene


def numbers_of(jaws: palpate.Jaws) -> list:
    return [*jaws.hinge, *jaws.axis, jaws.open, jaws.grip, jaws.pad_area]


def test_jaws_are_values_that_a_file_keeps_to_the_bit(tmp_path):
    scene = palpate.build_scene(grasper_scene(open=0.4, grip=3.0, hinge=(0.0, 0.0, 0.023)))
    jaws = scene.instruments[0].tool.jaws
    for same in (copy.deepcopy(jaws), pickle.loads(pickle.dumps(jaws))):
        assert numbers_of(same) == numbers_of(jaws) != numbers_of(palpate.Jaws())
    path = tmp_path / "grasper.palpate"
    scenario.write(path, scenario.Scenario(scene=scene))

    assert numbers_of(scenario.read(path).scene.instruments[0].tool.jaws) == numbers_of(jaws)
    scene.instruments[0].tool.jaws = None
    assert scene.instruments[0].tool.jaws is None


@pytest.mark.parametrize(
    ("field", "value", "message"),
    [
        ("open", 2.0, r"tool\.jaws\.open \[rad\]: got 2, expected more than 0, up to pi/2"),
        ("open", 0.0, r"tool\.jaws\.open"),
        ("grip", -1.0, r"tool\.jaws\.grip \[N\]: got -1"),
        ("pad_area", float("nan"), r"tool\.jaws\.pad_area"),
        ("axis", (0.0, 0.0, 2.0), r"tool\.jaws\.axis: got 2, expected a unit vector"),
        ("hinge", (0.0, 0.0, 0.7), r"tool\.jaws\.hinge \[m\]: got 0\.7"),
    ],
)
def test_jaws_that_cannot_be_are_refused(field, value, message):
    with pytest.raises(ValueError, match=message):
        palpate.build_scene(grasper_scene(**{field: value}))


def test_jaws_are_two_capsules():
    scene = grasper_scene()
    scene.instruments[0].tool.capsules = scene.instruments[0].tool.capsules[:1]
    with pytest.raises(ValueError, match="a tool of two capsules, which are its jaws"):
        palpate.build_scene(scene)


@pytest.mark.parametrize("damage", ["grip", "open", "hinge"])
def test_a_file_with_damaged_jaws_is_refused(tmp_path, damage):
    path = tmp_path / "grasper.palpate"
    scenario.write(path, scenario.Scenario(scene=palpate.build_scene(grasper_scene())))
    names = zipfile.ZipFile(path).namelist()
    parts = {name: zipfile.ZipFile(path).read(name) for name in names}
    manifest = json.loads(parts["manifest.json"])
    del manifest["content"]["scene"]["instruments"][0]["tool"]["jaws"][damage]
    parts["manifest.json"] = json.dumps(manifest).encode()
    with zipfile.ZipFile(path, "w") as damaged:
        for name in names:
            damaged.writestr(name, parts[name])

    with pytest.raises(FileError, match=rf"jaws\.{damage}: got nothing"):
        scenario.read(path)


def test_a_button_closes_jaws_in_the_air_and_a_grip_axis_as_far_as_it_is():
    scene = palpate.build_scene(grasper_scene())
    world = palpate.World(scene)
    far = (0.0, 0.0, 0.2)

    def angle_after(ticks: int, **hand) -> float:
        for _ in range(ticks):
            sample = palpate.HapticSample(position=far, **hand)
            assert list(palpate.tick(scene, sample, 1e-3, world).force) == [0.0, 0.0, 0.0]
        return world.instruments[0].tool.jaw_angle

    assert angle_after(3) == pytest.approx(0.52)
    assert angle_after(20, buttons=palpate.ATTACH_BUTTON) == pytest.approx(0.52 - 0.2, abs=1e-9)
    assert angle_after(60, buttons=palpate.ATTACH_BUTTON) == 0.0
    assert angle_after(100, grip=0.3) == pytest.approx(0.22)
    tool = world.instruments[0].tool
    assert tool.pinch == tool.pad_pressure == 0.0 and not tool.has_hold()


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


@pytest.mark.parametrize("seed", [0, 1])
def test_the_probe_on_the_spleen_is_drawn_along_it_and_its_friction_is_felt(seed):
    organ = scenario.read(MESHES / "published" / "spleen.palpate")
    path = SCENARIOS / "spleen_probe.json"
    made = with_assessment(path, read_assessment(path), organ)
    drawn = scenario.draw_task(made, "normal", seed)
    assert drawn.places[drawn.task.steps[0].place] == ("upper", "lower")[seed]
    played = attempt(made.scene, drawn, "careful")
    assert played.state.outcome is palpate.Outcome.done and played.state.errors == 0
    step = played.state.steps[drawn.steps.index("draw")]

    smooth = copy.copy(made.scene)
    smooth.instruments[0].tool = copy.copy(smooth.instruments[0].tool)
    smooth.instruments[0].tool.friction = 0.0
    (samples,), dragged, pressed = played.samples, [], []
    worlds = [(each, palpate.World(each)) for each in (made.scene, palpate.build_scene(smooth))]
    for tick, sample in enumerate(samples):
        forces = [palpate.tick(scene, sample, 1e-3, world).force for scene, world in worlds]
        if step.from_tick + 500 <= tick < step.until_tick:
            ahead = np.subtract(samples[tick].position, samples[tick - 100].position)
            ahead /= np.linalg.norm(ahead)
            dragged.append([-np.dot(force, ahead) for force in forces])
            pressed.append(np.linalg.norm(forces[1]))

    with_it, without = np.mean(dragged, axis=0)
    assert with_it - without == pytest.approx(0.1 * np.mean(pressed), rel=0.3)


@pytest.mark.parametrize(
    "name",
    ["two_instruments", "two_organs", pytest.param("stone", marks=pytest.mark.landing)],
)
def test_the_example_of_two_holds(name):
    program = MESHES.parent / "tests" / "examples" / name / f"{name}.py"

    assert runpy.run_path(str(program))["main"]() == 0


def test_an_instrument_is_drawn_as_what_of_it_touches():
    for kind, usual in KINDS.items():
        assert name_look(build_tool(ToolPart(**vars(usual)))) == kind
    wide = palpate.Tool(radius=0.005, capsules=[palpate.Capsule(to=[0.0, 0.0, 0.02])])
    drawn = build_instrument(wide)
    assert drawn is not None
    x = drawn.parts[0].shape.vertices
    tip = x[x[:, 2] < 0.25]
    assert np.abs(tip[:, :2]).max() == pytest.approx(0.005, abs=1e-5)
    # the lens is slanted: its foremost point stands out of the round end that touches
    assert -0.010 < x[:, 2].min() < -0.005


def test_a_syringe_is_drawn_with_its_own_meshes_behind_a_needle_as_that_which_touches():
    drawn = build_instrument(build_tool(ToolPart(**vars(KINDS["syringe"]))))
    barrel, plunger = drawn.parts
    for part, name in ((barrel, "syringe_barrel"), (plunger, "syringe_plunger")):
        assert np.array_equal(part.shape.triangles, read_part(name).triangles)
    assert (barrel.appearance.colour, plunger.appearance.colour) == tuple(
        part.colour for part in DRAWN["syringe"].parts
    )

    fine = palpate.Tool(radius=0.0003, capsules=[palpate.Capsule(to=[0.0, 0.0, 0.025])])
    for tool, x in (
        (build_tool(ToolPart(**vars(KINDS["syringe"]))), barrel.shape.vertices),
        (fine, build_instrument(fine).parts[0].shape.vertices),
    ):
        end = tool.capsules[0].to[2]
        # its point stands out of the round end that touches
        assert -0.001 < x[:, 2].min() < -tool.radius
        needle = x[x[:, 2] < end + 1e-6]
        assert needle[:, 2].max() == pytest.approx(end, abs=1e-6)
        assert np.abs(needle[:, :2]).max() == pytest.approx(tool.radius, rel=1e-3)
        behind = x[x[:, 2] > end + 0.019]
        # 10 ml, whatever the needle
        assert np.linalg.norm(behind[:, :2], axis=1).max() == pytest.approx(0.0135, rel=1e-3)
        assert np.ptp(behind[:, 2]) == pytest.approx(0.081, abs=1e-4)


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


def test_a_file_keeps_the_coefficient_of_each_pair(tmp_path):
    scene = probe_scene()
    instrument = scene.instruments[0]
    instrument.tool.friction = 0.3
    instrument.pair_friction = [0.0625]
    built = palpate.build_scene(scene)
    assert built.instruments[0].pair_friction == [0.0625]
    assert pickle.loads(pickle.dumps(instrument)).pair_friction == [0.0625]
    palpate.scenario.write(tmp_path / "pair.palpate", palpate.scenario.Scenario(scene=built))
    read = palpate.scenario.read(tmp_path / "pair.palpate").scene.instruments[0]
    assert read.pair_friction == [0.0625]

    instrument.pair_friction = [0.1, 0.2]
    with pytest.raises(ValueError, match=r"pair_friction \[-\]: got 2 numbers, expected 1"):
        palpate.build_scene(scene)


def rubbing_pair() -> palpate.Scene:
    """Two organs, on the second of which the instrument rubs less."""
    one = probe_scene()
    points = ellipsoid((0.03, 0.025, 0.02), 2)
    beside = palpate.SurfaceMesh(np.asarray(points.vertices) + (0.2, 0.0, 0.0), points.triangles)
    instrument = one.instruments[0]
    instrument.tool.friction, instrument.pair_friction = 0.3, [0.2, 0.1]
    other = palpate.SoftBody(tissue=palpate.build_mass_spring(beside, MEMBRANE, 50.0))
    return palpate.build_scene(
        palpate.Scene(bodies=[one.bodies[0], other], instruments=[instrument])
    )


def test_instruments_of_another_scene_take_along_what_holds_there():
    scene = rubbing_pair()
    assert [one.pair_friction for one in keep_pairs(scene.instruments, [1])] == [[0.1]]
    assert [one.pair_friction for one in keep_pairs(scene.instruments)] == [[]]
    assert scene.instruments[0].pair_friction == [0.2, 0.1]


def test_what_is_made_of_a_scene_of_several_coefficients_is_built():
    scene = rubbing_pair()
    assert build_wall(scene).instruments[0].pair_friction == []
    assert leave_out(scene, 0, friction=True).instruments[0].tool.friction == 0.0
    bare = scale_pressure(scene, 10.0)
    assert bare.instruments[0].pair_friction == [0.2]
