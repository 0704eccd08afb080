# SPDX-License-Identifier: BSD-3-Clause
"""Several instruments of a scenario at once, and a device that is the handle of one."""

from __future__ import annotations

import copy
from types import SimpleNamespace

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.cli.play import describe_play_report
from palpate.command.verb import WrongCall
from palpate.render import build_instrument
from palpate.runs.felt import read_all_rendered, read_column, read_felt_by_any, read_touched
from palpate.runs.other_hands import find_centre, find_fulcrum, name_hands, park
from palpate.runs.pictures import place_instruments
from palpate.runs.play import open_play
from palpate.runs.play_report import play_headless
from palpate.runs.script_file import write_script_file
from palpate.viewport import Grip, PointerHands, make_view
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from surfaces import organ_scene
from windows import RIGHT, move, turn_wheel

MIDDLE = QPoint(160, 120)
SHIFT, ALT = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.AltModifier


def make_scene(trocar: bool = True) -> palpate.Scene:
    """An organ, a probe through a trocar or held freely, and a ball."""
    scene = organ_scene(2)
    probe = copy.copy(scene.instruments[0])
    probe.tool = palpate.Tool(radius=0.0025, capsules=[palpate.Capsule(to=[0.0, 0.0, 0.02])])
    if trocar:
        probe.trocar = (0.0, 0.0, 0.18)
    ball = palpate.Instrument(tool=palpate.Tool(radius=0.003))
    return palpate.build_scene(
        palpate.Scene(bodies=list(scene.bodies), instruments=[probe, ball], rate=scene.rate)
    )


@pytest.fixture
def published(tmp_path):
    path = tmp_path / "two.palpate"
    scenario.write(path, scenario.Scenario(scene=make_scene(), title="Two", task="Press"))
    return path


def write_touch(path, scene, x, depth):
    """Down onto the top of the organ beside its middle, and up again."""
    surface = np.asarray(scene.bodies[0].tissue.rest_position)
    top = surface[:, 2].max() + 0.003
    frames = [(0.0, top + 0.01), (0.3, top - depth), (0.5, top - depth), (0.7, top + 0.01)]
    write_script_file(path, [palpate.KeyFrame(t, (x, 0.0, z)) for t, z in frames])
    return path


def test_two_scripts_drive_two_instruments_at_once(published, tmp_path):
    scene = scenario.read(published).scene
    first = write_touch(tmp_path / "a.json", scene, 0.0, 0.004)
    second = write_touch(tmp_path / "b.json", scene, 0.008, 0.004)
    play = open_play(
        published, [f"script:{first}", f"script:{second}"], record=tmp_path / "two.prec"
    )

    report = play_headless(play)

    rows = palpate.read_record(tmp_path / "two.prec")
    assert rows.instruments == 2 and report["outcome"] == "done"
    both = read_touched(rows, 0) & read_touched(rows, 1)
    assert both.sum() > 100
    any_touches = read_touched(rows, 0) | read_touched(rows, 1)
    assert report["time_in_touch_s"] == report["time_in_touch_computed_s"]
    assert report["time_in_touch_s"] == pytest.approx(1e-3 * any_touches.sum())
    assert " s in touch, of any of 2 instruments\n" in describe_play_report(report)
    assert palpate.replay(play.scenario.scene, rows).equal


def test_what_only_the_second_instrument_felt_is_told_of_the_run(published, tmp_path):
    scene = scenario.read(published).scene
    away = write_touch(tmp_path / "a.json", scene, 0.0, -0.008)
    second = write_touch(tmp_path / "b.json", scene, 0.008, 0.004)
    record = tmp_path / "two.prec"
    play = open_play(published, [f"script:{away}", f"script:{second}"], record=record)

    report = play_headless(play)

    rows = palpate.read_record(record)
    assert not read_touched(rows, 0).any()
    force = np.linalg.norm(read_column(rows, "felt", "force", 1).astype(float), axis=1)
    assert report["peak_computed_N"] == pytest.approx(force.max()) and force.max() > 0.05
    assert report["time_in_touch_computed_s"] == pytest.approx(1e-3 * read_touched(rows, 1).sum())


def test_motors_of_two_devices_are_off_no_longer_than_the_run(tmp_path):
    off = np.zeros((4, 2), dtype=[("touched", np.uint32)])
    off["touched"][:3, 0] = off["touched"][1:, 1] = palpate.NOT_RENDERED
    hand = np.zeros((4, 2), dtype=[("time", float)])
    record = SimpleNamespace(hand=hand, felt=off, instruments=2)
    assert read_all_rendered(record).tolist() == [False] * 4
    assert not read_felt_by_any(record).any()


def test_the_other_hand_is_parked_beside_the_organ(published, tmp_path):
    scene = scenario.read(published).scene
    script = write_touch(tmp_path / "a.json", scene, 0.0, 0.004)
    play = open_play(published, f"script:{script}", record=tmp_path / "one.prec")
    assert play.others == ["parked"]

    play_headless(play)

    rows = palpate.read_record(tmp_path / "one.prec")
    assert read_touched(rows, 0).any() and not read_touched(rows, 1).any()
    where = read_column(rows, "hand", "position", 1)
    assert np.ptp(where, axis=0).max() == 0.0
    assert where[0] == pytest.approx(park(scene, 1))


def test_a_picture_of_a_record_has_every_instrument():
    scene = make_scene()
    world = palpate.World(scene)
    samples = [palpate.HapticSample(position=(x, 0.0, 0.09)) for x in (0.0, 0.03)]
    palpate.tick(scene, samples, 1e-3, world)

    *shaft, ball = place_instruments(scene, world)

    assert len(shaft) == len(build_instrument(scene.instruments[0].tool).parts)
    assert ball.shape.vertices.mean(axis=0) == pytest.approx([0.03, 0.0, 0.09], abs=1e-3)
    only = organ_scene(2)
    assert place_instruments(only, palpate.World(only)) == []


def test_hands_are_named_in_the_order_of_the_instruments():
    assert name_hands([], 2) == ["pointer", "pointer"]
    assert name_hands(["script:a.json"], 3) == ["script:a.json", "parked", "parked"]
    assert name_hands(["pointer", "parked"], 2) == ["pointer", "parked"]
    with pytest.raises(WrongCall, match="got 3, expected at most 2"):
        name_hands(["pointer"] * 3, 2)


def test_a_hand_that_cannot_be_another_s_is_refused(published):
    play = open_play(published, ["pointer", "plant"])
    with pytest.raises(WrongCall, match="'plant' for instrument 2"):
        play.build_others()


# ---------------------------------------------------------------- the mouse


@pytest.fixture
def view(qtbot):
    made = make_view()
    qtbot.addWidget(made)
    made.resize(320, 240)
    scene = make_scene()
    made.show_surface(scene.bodies[0].tissue.rest_position, scene.bodies[0].tissue.triangles)
    made.show()
    qtbot.waitExposed(made)
    return made


class Pair:
    """Two hands of one mouse, tick by tick."""

    def __init__(self, view, scene):
        self.devices = [palpate.SurfacePointer(scene, 0, i) for i in range(2)]
        self.hands = view.tool = PointerHands(view, list(enumerate(self.devices)), scene)
        self.view, self.ticks = view, 0

    def feel(self, ticks=400):
        for _ in range(ticks):
            self.ticks += 1
            samples = [device.read(1e-3 * self.ticks) for device in self.devices]
        return samples


def test_tab_gives_the_mouse_to_the_other_instrument_and_the_first_stays(view):
    pair = Pair(view, make_scene())
    move(view, MIDDLE)
    before = pair.feel()
    assert np.linalg.norm(np.array(before[0].position) - before[1].position) > 0.005
    assert dict(view.hint.pairs)["Tab"] == "instrument 2"

    QTest.keyClick(view, Qt.Key.Key_Tab)
    assert pair.hands.active == 1 and dict(view.hint.pairs)["Tab"] == "instrument 1"
    move(view, MIDDLE + QPoint(12, 8))
    after = pair.feel()
    assert np.array(after[0].position) == pytest.approx(np.array(before[0].position), abs=1e-9)
    assert np.linalg.norm(np.array(after[1].position) - before[1].position) > 0.002


def test_what_is_held_stays_held_while_the_mouse_is_elsewhere(view):
    pair = Pair(view, make_scene())
    move(view, MIDDLE)
    QTest.keyClick(view, Qt.Key.Key_A)
    held = pair.feel(600)[0]
    assert held.buttons == palpate.ATTACH_BUTTON

    QTest.keyClick(view, Qt.Key.Key_Tab)
    move(view, MIDDLE + QPoint(20, 0))
    later = pair.feel()
    assert later[0].buttons == palpate.ATTACH_BUTTON and later[1].buttons == 0
    QTest.keyClick(view, Qt.Key.Key_Tab)
    assert pair.hands.hand.grip is Grip.holding
    # back with the pointer elsewhere it does not leap there
    move(view, MIDDLE + QPoint(21, 0))
    back = pair.feel()[0]
    moved = np.linalg.norm(np.array(back.position) - np.array(held.position))
    assert moved < 3.0 * view.pixel_size_at(back.position)


def test_tab_does_nothing_while_a_button_is_down(view):
    pair = Pair(view, make_scene())
    QTest.mousePress(view, RIGHT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    QTest.keyClick(view, Qt.Key.Key_Tab)
    assert pair.hands.active == 0
    QTest.mouseRelease(view, RIGHT, Qt.KeyboardModifier.NoModifier, MIDDLE)


def test_shift_and_the_wheel_turn_an_instrument_about_its_shaft(view):
    pair = Pair(view, make_scene())
    move(view, MIDDLE)
    pair.feel()
    depth = pair.hands.hand.depth
    turn_wheel(view, QPointF(MIDDLE), 3, SHIFT)
    x, y, z, w = pair.feel(600)[0].orientation
    assert 2.0 * np.arctan2(z, w) == pytest.approx(np.radians(30.0)) and x == y == 0.0
    assert pair.hands.hand.depth == depth
    assert "Alt + wheel" not in dict(view.hint.pairs)  # its trocar holds it


def test_alt_and_the_wheel_lean_a_shaft_that_no_trocar_holds(view):
    pair = Pair(view, make_scene(trocar=False))
    move(view, MIDDLE)
    turn_wheel(view, QPointF(MIDDLE), 4, ALT)
    x, y, z, w = pair.feel(600)[0].orientation
    assert 2.0 * np.arccos(w) == pytest.approx(np.radians(20.0))
    assert np.array([x, y, z]) / np.sin(np.radians(10.0)) == pytest.approx(view.camera.basis()[0])
    turn_wheel(view, QPointF(MIDDLE), 40, ALT)
    for _ in range(40):
        turn_wheel(view, QPointF(MIDDLE), 1, ALT)
    x, y, z, w = pair.feel(2000)[0].orientation
    assert 1.0 - 2.0 * (x * x + y * y) >= np.cos(np.radians(75.1))


def test_a_hand_turns_by_3_rad_a_second_at_most():
    scene = make_scene()
    device = palpate.SurfacePointer(scene)
    half = (0.0, 0.0, np.sin(0.5), np.cos(0.5))  # 1 rad
    device.post(palpate.PointerTarget(goal=(0.0, 0.0, 0.03), depth=-0.01, orientation=half))
    device.read(0.0)
    angles = []
    for tick in range(1, 500):
        _, _, z, w = device.read(1e-3 * tick).orientation
        angles.append(2.0 * np.arctan2(z, w))
    assert np.diff(angles).max() <= 3e-3 + 1e-9
    assert angles[-1] == pytest.approx(1.0)
    with pytest.raises(ValueError, match="a quaternion of norm 2"):
        device.post(palpate.PointerTarget(orientation=(0.0, 0.0, 0.0, 2.0)))


# ---------------------------------------------------------------- a handle


def test_the_arm_as_a_handle_moves_the_tip_through_the_trocar(published, tmp_path):
    """The same script through the simulated arm as a tip and as a handle: the tip goes there."""
    scene = scenario.read(published).scene
    script = write_touch(tmp_path / "a.json", scene, 0.0, 0.004)
    paths = {}
    for length in (0.0, 0.32):
        record = tmp_path / f"{length}.prec"
        play = open_play(
            published, f"plant:script:{script}", record=record, duration=1.2, fulcrum=length
        )
        report = play_headless(play)
        assert report["time_in_touch_computed_s"] > 0.05
        paths[length] = read_column(palpate.read_record(record), "hand", "position")
    for path in paths.values():
        assert np.abs(path[-1] - paths[0.0][-1]).max() < 4e-3  # as far as an arm gives way


def test_a_fulcrum_asks_for_a_trocar_and_a_shaft_that_reaches_the_organ(published, tmp_path):
    scene = scenario.read(published).scene
    with pytest.raises(WrongCall, match="got no arm"):
        open_play(published, "pointer", fulcrum=0.3)
    with pytest.raises(WrongCall, match="expected at least"):
        open_play(published, "plant", fulcrum=0.1)
    with pytest.raises(WrongCall, match="no trocar"):
        find_fulcrum(scene, 1, 0.3)
    middle = find_centre(scene, 0, 0.0)
    handle = find_centre(scene, 0, 0.32)
    assert np.linalg.norm(handle - middle) == pytest.approx(0.32)
    assert np.cross(handle - middle, scene.instruments[0].trocar - middle) == pytest.approx(
        0.0, abs=1e-12
    )


def test_a_fulcrum_device_is_one_of_python_too():
    fulcrum = palpate.Fulcrum((0.0, 0.0, 0.2), 0.3)
    handle = (0.01, 0.0, 0.3)
    tip = palpate.compute_fulcrum_tip(fulcrum, handle)
    assert palpate.compute_fulcrum_handle(fulcrum, tip) == pytest.approx(np.array(handle))
    script = palpate.ScriptedDevice([palpate.KeyFrame(0.0, handle)])
    device = palpate.FulcrumDevice(script, fulcrum)
    assert device.read(0.0).position == pytest.approx(np.array(tip))
    device.write(palpate.HapticCommand((1.0, 0.0, 0.0)))
    wanted = palpate.carry_force(fulcrum, handle, (1.0, 0.0, 0.0))
    assert script.last_command.force == pytest.approx(np.array(wanted))
    with pytest.raises(ValueError, match="a positive number"):
        palpate.FulcrumDevice(script, palpate.Fulcrum((0.0, 0.0, 0.2), 0.0))
