# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of several bodies and instruments, as Python has them."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import palpate
import pytest
from palpate.runs.live import LiveRun
from palpate.runs.press import find_top
from palpate.runs.replay import follow_header
from palpate.runs.run import describe_arithmetic
from surfaces import organ_scene

DT = 1e-3
ASIDE = np.array([0.1, 0.0, 0.0])


def make_body(offset=(0.0, 0.0, 0.0)) -> palpate.SoftBody:
    tissue = copy.copy(organ_scene(1).bodies[0].tissue)
    np.asarray(tissue.rest_position)[:] += offset
    return palpate.SoftBody(tissue=tissue)


def crowded() -> palpate.Scene:
    instruments = [palpate.Instrument()] * (palpate.scenario.MOST_INSTRUMENTS + 1)
    return palpate.build_scene(palpate.Scene(bodies=[make_body()], instruments=instruments))


@pytest.fixture(scope="module")
def scene() -> palpate.Scene:
    return palpate.build_scene(
        palpate.Scene(
            bodies=[make_body(), make_body(ASIDE)],
            instruments=[palpate.Instrument(), palpate.Instrument()],
        )
    )


def press(height: float, offset=(0.0, 0.0, 0.0)) -> palpate.HapticSample:
    return palpate.HapticSample(position=np.array([0.0, 0.0, height]) + offset)


def test_each_instrument_feels_its_body_as_if_it_were_alone():
    """With substeps as given: whether a tip just touches is a matter of nanometres, and asks for
    two more."""
    bodies = [make_body(), make_body(ASIDE)]
    for body in bodies:
        body.substeps = body.substeps_max = 8
    alone = palpate.build_scene(palpate.Scene(bodies=bodies[:1]))
    instruments = [palpate.Instrument(), palpate.Instrument()]
    scene = palpate.build_scene(palpate.Scene(bodies=bodies, instruments=instruments))
    both, one = palpate.World(scene), palpate.World(alone)
    for i in range(100):
        down = press(0.03 - 1e-4 * i)
        commands = palpate.tick(scene, [down, press(0.05, ASIDE)], DT, both)
        expected = palpate.tick(alone, down, DT, one)
        # vector code that has slept beside another body was at rest within 0.1 um, not to the bit
        np.testing.assert_allclose(commands[0].force, expected.force, atol=1e-4)
        assert commands[1].force.tolist() == [0.0, 0.0, 0.0]

    assert both.instruments[0].tool.touching
    assert not both.instruments[1].tool.touching
    assert both.pair(0, 0).load.push_count == both.bodies[0].load.push_count > 0
    assert both.pair(1, 0).candidates.count == 0
    assert palpate.compute_felt(commands[1], both, 1).touched == 0
    assert both.alarm_body == -1


def test_a_scene_of_several_is_pickled_and_copied_whole(scene):
    for other in (pickle.loads(pickle.dumps(scene)), copy.copy(scene)):
        assert len(other.bodies) == len(other.instruments) == 2
        for mine, its in zip(scene.bodies, other.bodies, strict=True):
            assert its.substeps == mine.substeps
            assert np.array_equal(its.tissue.rest_position, mine.tissue.rest_position)
            assert np.array_equal(its.rest_areas, mine.rest_areas)


def test_bodies_and_instruments_are_changed_in_place_until_the_scene_is_built():
    scene = palpate.Scene(bodies=[make_body(), make_body(ASIDE)])
    scene.bodies[1].substeps = scene.bodies[1].substeps_max = 7
    scene.instruments[0].tool.radius = 0.004

    built = palpate.build_scene(scene)

    assert built.bodies[1].substeps == 7
    assert built.instruments[0].tool.radius == 0.004
    with pytest.raises(AttributeError):
        scene.bodies = []  # type: ignore[misc]


def test_what_is_in_a_world_of_several_is_read_only(scene):
    world = palpate.World(scene)

    with pytest.raises(ValueError, match="read-only"):
        world.bodies[1].tissue.position[:] = 0.0
    with pytest.raises(AttributeError, match="part of a Scene or a World"):
        world.instruments[1].hand = (1.0, 2.0, 3.0)
    with pytest.raises(ValueError, match="got a Load that is part of a World"):
        world.pair(1, 1).load.clear()


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda s, w: palpate.tick(s, [press(0.1)], DT, w), "samples: got 1 entries, expected 2"),
        (lambda s, w: palpate.tick(s, press(0.1), DT, w), "sample: got 1 entries, expected 2"),
        (lambda s, w: w.pair(2, 0), "instrument: got 2, expected 0 to 1"),
        (lambda s, w: w.pair(0, -1), "body: got -1, expected 0 to 1"),
        (
            lambda s, w: palpate.compute_felt(palpate.HapticCommand(), w, 2),
            "instrument: got 2, expected 0 to 1",
        ),
        (lambda s, w: palpate.SurfacePointer(s, body=2), "body: got 2, expected 0 to 1"),
        (
            lambda s, w: palpate.Loop(s, palpate.ScriptedDevice([palpate.KeyFrame()])),
            "loop: devices: got 1, expected 2, one for each instrument of the scene",
        ),
        (
            lambda s, w: palpate.scenario.pack(palpate.scenario.Scenario(scene=crowded())),
            "scene.instruments: got 17, expected 1 to 16",
        ),
        (
            lambda s, w: palpate.build_scene(palpate.Scene(bodies=[])),
            "scene: bodies: got 0, expected at least one to touch",
        ),
    ],
    ids=["few", "one", "pair", "below", "felt", "pointer", "loop", "file", "none"],
)
def test_another_number_of_them_is_refused(scene, call, sentence):
    with pytest.raises(ValueError, match=sentence):
        call(scene, palpate.World(scene))


def test_the_live_loop_shows_every_body():
    scene = palpate.build_scene(palpate.Scene(bodies=[make_body(), make_body(ASIDE)]))
    high, low = palpate.KeyFrame(), palpate.KeyFrame()
    high.position, low.position, low.time = (0.0, 0.0, 0.03), (0.0, 0.0, 0.019), 0.15
    options = palpate.LoopOptions()
    options.duration, options.realtime = 1.0, False
    loop = palpate.Loop(scene, palpate.ScriptedDevice([high, low]), options)
    loop.start()

    assert loop.wait(30.0)

    loop.take_snapshot()
    shown = loop.snapshot().bodies
    moved = [
        np.abs(body.position - soft.tissue.rest_position).max()
        for body, soft in zip(shown, scene.bodies, strict=True)
    ]
    assert moved[0] > 1e-4
    assert moved[1] < 1e-6
    assert [body.substeps >= 1 for body in shown] == [True, True]


def test_a_frame_of_a_live_run_has_the_positions_and_substeps_of_every_body():
    scene = palpate.build_scene(palpate.Scene(bodies=[make_body(), make_body(ASIDE)]))
    high, low = palpate.KeyFrame(), palpate.KeyFrame()
    high.position, low.position, low.time = ASIDE + (0, 0, 0.03), ASIDE + (0, 0, 0.019), 0.15
    options = palpate.LoopOptions(duration=1.0, realtime=False)
    with LiveRun(scene, palpate.ScriptedDevice([high, low]), options=options) as run:
        assert run.wait(30.0)
        frame = run.take_frame()

    assert frame is not None
    moved = [
        np.abs(x - body.tissue.rest_position).max()
        for x, body in zip(frame.positions, scene.bodies, strict=True)
    ]
    assert moved[0] < 1e-6 and moved[1] > 1e-4
    assert len(frame.substeps) == 2 and min(frame.substeps) >= 1


def test_the_top_of_each_body_is_its_own(scene):
    tops = [find_top(scene, body).point for body in (0, 1)]

    assert np.allclose(tops[1] - tops[0], ASIDE, atol=1e-9)


def test_a_record_names_the_arithmetic_of_every_body_and_a_replay_follows_it(scene):
    mixed = palpate.build_scene(palpate.Scene(bodies=[make_body(), make_body(ASIDE)]))
    same = describe_arithmetic(mixed)
    mixed.bodies[1].kernel = palpate.Kernel.reference

    told = describe_arithmetic(mixed)

    packed = "packed" if palpate.simd_targets() else "reference"
    assert same["kernel"] == packed
    assert told["kernel"] == (packed if packed == "reference" else "packed + reference")
    fresh = palpate.build_scene(palpate.Scene(bodies=[make_body(), make_body(ASIDE)]))
    follow_header(fresh, told)
    assert [body.kernel for body in fresh.bodies] == [body.kernel for body in mixed.bodies]


def test_bodies_of_a_pair_touch_and_others_pass_through_each_other():
    top = np.asarray(make_body().tissue.rest_position)[:, 2].max()
    bodies = [make_body(), make_body((0.0, 0.0, 2.0 * top + 3e-4))]
    pair = palpate.BodyPair(0, 1, damping=0.2)
    touching = palpate.build_scene(palpate.Scene(bodies=bodies, body_pairs=[pair]))
    through = palpate.build_scene(palpate.Scene(bodies=bodies))
    with_pair, without = palpate.World(touching), palpate.World(through)
    for i in range(200):
        down = press(3.0 * top + 0.01 - 1e-4 * i)
        palpate.tick(touching, down, DT, with_pair)
        palpate.tick(through, down, DT, without)

    state = with_pair.body_pairs[0]
    assert touching.body_pairs[0].damping == 0.2
    assert 3e-4 <= touching.body_pairs[0].thickness <= 5e-4
    assert touching.body_pairs[0].stiffness > 0.0
    assert state.near
    assert state.touching > 0
    assert 0.0 < state.least_gap < touching.body_pairs[0].thickness
    assert state.force[2] > 0.0
    assert without.body_pairs == ()
    moved = np.asarray(with_pair.bodies[0].tissue.position) - bodies[0].tissue.rest_position
    still = np.asarray(without.bodies[0].tissue.position) - bodies[0].tissue.rest_position
    assert np.abs(moved).max() > 10.0 * np.abs(still).max()


def test_bodies_that_begin_in_each_other_are_refused_with_how_deep():
    scene = palpate.Scene(
        bodies=[make_body(), make_body((0.0, 0.0, 1e-3))], body_pairs=[palpate.BodyPair()]
    )
    with pytest.raises(ValueError, match=r"body_pairs\[0\]: got vertex \d+ of body \d .* inside"):
        palpate.build_scene(scene)


def test_a_scene_keeps_its_pairs_in_copies_and_pickles():
    scene = palpate.Scene(
        bodies=[make_body(), make_body(ASIDE)], body_pairs=[palpate.BodyPair(0, 1, stiffness=1e6)]
    )
    for kept in (copy.deepcopy(scene), pickle.loads(pickle.dumps(palpate.build_scene(scene)))):
        assert kept.body_pairs[0].stiffness == 1e6


def test_a_published_file_keeps_which_bodies_touch(tmp_path):
    bodies = [make_body(), make_body(ASIDE)]
    bodies[1].may_fold = True
    pair = palpate.BodyPair(1, 0, damping=0.1)
    scene = palpate.build_scene(palpate.Scene(bodies=bodies, body_pairs=[pair]))
    path = tmp_path / "two.palpate"

    palpate.scenario.write(path, palpate.scenario.Scenario(scene=scene))
    found = palpate.scenario.read(path).scene

    def numbers(scene: palpate.Scene) -> list[tuple[float, ...]]:
        return [
            (pair.first, pair.second, pair.thickness, pair.stiffness, pair.damping)
            for pair in scene.body_pairs
        ]

    assert numbers(found) == numbers(scene)
    assert [(pair.first, pair.second) for pair in found.body_pairs] == [(1, 0), (1, 1)]
    assert [body.may_fold for body in found.bodies] == [False, True]
