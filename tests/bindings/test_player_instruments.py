# SPDX-License-Identifier: BSD-3-Clause
"""Instruments in the trainee's window: forces, pinches, the trocar, the arrow and the hints."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.player.sentences import format_number, name_wrong, say_forces
from palpate.player.trainee_window import Phase
from palpate.runs.live import LiveRun
from palpate.runs.pinch import HARMFUL, LEAST_PINCH, Pinch, find_pinches, tell_pinch
from palpate.runs.play import open_play
from palpate.runs.script_file import write_script_file
from palpate.runs.stretch import TORN, StretchGauge
from palpate.viewport.instruments import see_instruments
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from scipy.spatial.transform import Rotation
from short_tasks import MESHES
from surfaces import MEMBRANE, ellipsoid, organ_scene
from trainees import middle, press_and_wait
from windows import LEFT, RIGHT, grab, keep_picture, move, turn_wheel

pytestmark = pytest.mark.window

NO_KEYS, SHIFT = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
TROCAR = (0.02, 0.0, 0.09)
PATIENCE = 30_000
"""[ms]"""


def build_grasper(trocar: tuple[float, float, float] | None = None) -> palpate.Instrument:
    jaws = [palpate.Capsule(from_=(0.0, y, 0.0), to=(0.0, y, 0.02)) for y in (0.0012, -0.0012)]
    tool = palpate.Tool(radius=0.0012, friction=0.5, capsules=jaws)
    tool.jaws = palpate.Jaws(hinge=(0.0, 0.0, 0.023))
    return palpate.Instrument(tool=tool, trocar=trocar)


@pytest.fixture
def two_graspers(tmp_path):
    """A published organ with one through a trocar and another that is held freely."""
    scene = organ_scene(2)
    instruments = [build_grasper(TROCAR), build_grasper()]
    made = palpate.Scene(bodies=list(scene.bodies), instruments=instruments, rate=scene.rate)
    path = tmp_path / "graspers.palpate"
    scenario.write(path, scenario.Scenario(scene=palpate.build_scene(made), title="Two"))
    return path


@pytest.fixture
def two_balls(tmp_path):
    """A published organ, and a script for each of two balls: one presses deeper."""
    scene = organ_scene(2)
    top = np.asarray(scene.bodies[0].tissue.rest_position)[:, 2].max() + 0.003
    balls = [palpate.Instrument(tool=palpate.Tool(radius=0.003)) for _ in range(2)]
    made = palpate.Scene(bodies=list(scene.bodies), instruments=balls, rate=scene.rate)
    path = tmp_path / "balls.palpate"
    scenario.write(path, scenario.Scenario(scene=palpate.build_scene(made), title="Two"))
    scripts = []
    for x, depth in ((-0.008, 0.004), (0.008, 0.007)):
        ways = [(0.0, top + 0.01), (0.3, top - depth), (60.0, top - depth)]
        frames = [palpate.KeyFrame(time, (x, 0.0, z)) for time, z in ways]
        scripts.append(tmp_path / f"{depth}.json")
        write_script_file(scripts[-1], frames)
    return path, scripts


def stop_and_take(window, qtbot, accept):
    """The first frame that is as it should be, after which nothing is shown any more."""
    window._timer.stop()
    taken = []

    def take() -> bool:
        frame = window.run.take_frame()
        taken.extend([frame] if frame is not None and accept(frame) else [])
        return bool(taken)

    qtbot.waitUntil(take, timeout=PATIENCE)
    return taken[0]


def find_sizes(frame) -> list[float]:
    return [float(np.linalg.norm(one.force)) for one in frame.instruments]


# ---------------------------------------------------------------- forces


def test_f_takes_the_arrow_of_the_force_away_and_gives_it_back(open_window, qtbot):
    window = open_window()
    window.restart()
    press_and_wait(window, qtbot)
    turn_wheel(window.view, middle(window), 10)
    qtbot.waitUntil(lambda: window.over.force.force > 0.1, timeout=PATIENCE)
    window._timer.stop()
    with_arrow = grab(window.view)

    QTest.keyClick(window, Qt.Key.Key_F)
    without = grab(window.view)
    assert not window.view.shows_force
    changed = np.abs(with_arrow - without).sum(axis=-1) > 60
    red = with_arrow[..., 0] - with_arrow[..., 1:].max(axis=-1)
    assert changed.sum() > 100 and (red[changed] > 60).mean() > 0.5

    QTest.keyClick(window, Qt.Key.Key_F)
    assert window.view.shows_force
    assert (np.abs(grab(window.view) - with_arrow).sum(axis=-1) > 60).sum() == 0


def test_each_of_two_instruments_has_a_row_with_the_force_on_its_own_hand(
    open_window, qtbot, two_balls
):
    path, scripts = two_balls
    window = open_window(open_play(path, [f"script:{each}" for each in scripts]))
    window.restart()

    def presses(frame) -> bool:
        less, more = find_sizes(frame)
        return less > 0.03 and more > less + 0.02

    frame = stop_and_take(window, qtbot, presses)
    window.shown.show(frame)

    less, more = (f"{format_number(size, 2)} N" for size in find_sizes(frame))
    assert window.view.hud.isVisible() and less != more
    assert window.view.hud.rows == (("Instrument 1", less), ("Instrument 2", more))
    assert window.shown.force == pytest.approx(find_sizes(frame)[0])  # the bar is of the first
    window.use_language("tr")
    window.shown.show(frame)
    assert [name for name, _ in window.view.hud.rows] == ["Alet 1", "Alet 2"]
    window._finish()
    assert not window.view.hud.isVisible()


def test_of_one_instrument_the_bar_alone_tells_the_force(open_window, qtbot):
    window = open_window()
    window.restart()
    press_and_wait(window, qtbot)

    assert window.view.hud.rows == () and not window.view.hud.isVisible()


@pytest.mark.parametrize("size", [(640, 400), (1280, 800)])
def test_rows_are_of_the_window_s_letters_and_no_banner_covers_them(open_window, size):
    window = open_window()
    window.resize(*size)
    window.restart()
    hud, over = window.view.hud, window.over
    hud.show_rows([("Instrument 1", "0.00 N"), ("Jaws 1", "10.0 N, 357 kPa > 330")])

    over.warning.tell(" ".join(["The force was damped."] * 6))
    over.place()

    assert not over.warning.geometry().intersects(hud.geometry())
    assert window.view.rect().contains(hud.geometry())
    assert not hud.geometry().intersects(over.force.geometry())
    assert hud.font().pixelSize() == max(9, round(0.85 * over._letter))


# ---------------------------------------------------------------- what jaws press with


def frame_of(*pinches: tuple[float, float], turn_limited: bool = False) -> SimpleNamespace:
    """What is read of a frame: of each instrument [N] and [Pa]."""
    instruments = [
        SimpleNamespace(
            pinch=force, pad_pressure=pressure, force=(0, 0, 3), stiffness_error=0.0,
            turn_limited=turn_limited,
        )
        for force, pressure in pinches
    ]  # fmt: skip
    return SimpleNamespace(instruments=tuple(instruments))


def test_jaws_that_press_have_a_row_and_jaws_that_do_not_have_none():
    def say(frame) -> list[tuple[str, str]]:
        return say_forces(frame, find_pinches(frame))

    assert say(frame_of((0.0, 0.0))) == say(frame_of((0.5 * LEAST_PINCH, 9e3))) == []
    assert say(frame_of((6.24, 84_400.0))) == [("Jaws", "6.2 N, 84 kPa")]
    two = say(frame_of((0.0, 0.0), (12.0, 90e3)))
    assert two == [
        ("Instrument 1", "3.00 N"), ("Instrument 2", "3.00 N"), ("Jaws 2", "12.0 N, 90 kPa"),
    ]  # fmt: skip


def test_what_jaws_hold_and_how_far_that_is_stretched_have_a_row_each():
    def say(*stretches: float) -> list[tuple[str, str]]:
        pinches = {
            index: Pinch(6.24, 84e3, stretch=stretch) for index, stretch in enumerate(stretches)
        }
        return say_forces(frame_of(*[(6.24, 84e3)] * len(stretches)), pinches)

    assert say(1.423) == [("Jaws", "6.2 N, 84 kPa"), ("Stretch", "1.42")]
    assert say(2.5)[1:] == [("Stretch", "2.50 > 2.4")]
    assert [name for name, _ in say(1.1, 1.2)] == [
        "Instrument 1", "Jaws 1", "Stretch 1", "Instrument 2", "Jaws 2", "Stretch 2",
    ]  # fmt: skip
    wrong = {0: Pinch(6.0, 84e3, stretch=2.5), 1: Pinch(6.0, 357e3, stretch=1.5)}
    assert name_wrong(wrong, several=True) == ["Jaws 2", "Stretch 1"]


def test_a_gauge_finds_the_largest_stretch_about_an_instrument():
    """By hand: a sheet drawn out along x by a half, and thinned along y, except far away."""
    sheet = ellipsoid((0.03, 0.025, 0.02), 3)
    scene = palpate.build_scene(palpate.make_scene(palpate.build_mass_spring(sheet, MEMBRANE, 50)))
    gauge, x = StretchGauge(scene), np.asarray(scene.bodies[0].tissue.rest_position)

    def measure(positions: np.ndarray, at: np.ndarray) -> tuple[float, float]:
        one = SimpleNamespace(tool_position=at)
        return gauge.measure(SimpleNamespace(instruments=(one,), positions=(positions,)), 0)

    top = x[x[:, 2].argmax()]
    assert measure(x, top) == (pytest.approx(1.0), TORN)
    turn = Rotation.from_rotvec((0.3, -0.2, 0.9)).as_matrix()
    assert measure(x @ turn.T, turn @ top) == (pytest.approx(1.0), TORN)
    drawn = x * (1.5, 0.8, 1.0)
    found, _ = measure(drawn, drawn[x[:, 2].argmax()])
    assert found == pytest.approx(1.5, abs=0.01) and found <= 1.5 + 1e-12
    assert measure(drawn, np.array([1.0, 0.0, 0.0])) == (1.0, TORN)
    scene.bodies[0].tear_stretch = 1.6
    assert StretchGauge(scene).rests[0].bound == 1.6


def test_a_gauge_of_solids_takes_frames_as_they_are_shown():
    """Of its skin, of which there are fewer points than particles."""
    scene = scenario.read(MESHES / "scenes" / "kidney_stone_removal.palpate").scene
    device = palpate.ScriptedDevice([palpate.KeyFrame(0.0, np.array([0.0, 0.0, 0.4]))])
    with LiveRun(
        scene,
        [device] * len(scene.instruments),
        options=palpate.LoopOptions(duration=0.05),
    ) as run:
        assert run.wait(60.0)
        frame = run.take_frame()
    at = SimpleNamespace(tool_position=np.asarray(frame.positions[0])[0])
    shown = SimpleNamespace(instruments=(at,), positions=frame.positions)
    assert StretchGauge(scene).measure(shown, 0) == (pytest.approx(1.0, abs=1e-2), TORN)


def test_an_instrument_that_tissue_keeps_from_turning_is_told():
    def say(frame) -> list[tuple[str, str]]:
        return say_forces(frame, find_pinches(frame))

    assert say(frame_of((0.0, 0.0), turn_limited=True)) == [("Turning", "held by tissue")]
    told = say(frame_of((0.0, 0.0), (0.0, 0.0), turn_limited=True))
    assert told[1::2] == [("Turning 1", "held by tissue"), ("Turning 2", "held by tissue")]


def test_a_pressure_that_harms_is_told_with_what_it_is_beyond():
    assert HARMFUL == 330e3
    assert not Pinch(10.0, HARMFUL).is_wrong and Pinch(10.0, 357e3).is_wrong
    assert tell_pinch(Pinch(10.0, 357e3)) == "10.0 N, 357 kPa > 330"


def test_a_task_says_from_where_on_jaws_press_too_hard():
    measure = palpate.TaskMeasure.pad_pressure
    limits = [
        palpate.TaskLimit(measure=measure, instrument=1, above=True, bound=90e3),
        palpate.TaskLimit(measure=measure, instrument=1, above=True, bound=60e3),
        palpate.TaskLimit(measure=palpate.TaskMeasure.force, instrument=0, above=True, bound=5.0),
    ]
    task = palpate.Task(limits=limits)

    found = find_pinches(frame_of((8.0, 100e3), (8.0, 100e3)), task)

    assert [found[index].bound for index in (0, 1)] == [HARMFUL, 60e3]
    assert [found[index].is_wrong for index in (0, 1)] == [False, True]


@pytest.mark.usefixtures("turkish")
def test_jaws_are_told_in_turkish_too():
    frame = frame_of((6.24, 84_400.0))
    assert say_forces(frame, find_pinches(frame)) == [("Çeneler", "6,2 N, 84 kPa")]


def test_the_row_of_jaws_that_press_too_hard_is_in_the_colour_of_an_alarm(view):
    def count_red() -> int:
        pixels = grab(view.hud)
        return int((pixels[..., 0] - pixels[..., 1:].max(axis=-1) > 80).sum())

    rows = [("Instrument 1", "3.00 N"), ("Jaws 1", "10.0 N, 357 kPa > 330")]
    view.hud.show_rows(rows)
    assert count_red() == 0
    view.hud.show_rows(rows, ["Jaws 1"])
    assert count_red() > 30
    view.hud.show_rows(rows)
    assert count_red() == 0


@pytest.mark.landing
def test_what_the_grasper_of_the_gallbladder_presses_with_is_seen_while_it_holds(
    open_window, qtbot, tmp_path
):
    task = MESHES / "scenarios" / "gallbladder_grasp.json"
    organ = scenario.read(MESHES / "published" / "gallbladder.palpate")
    path = tmp_path / "grasp.palpate"
    scenario.write(path, with_assessment(task, read_assessment(task), organ))
    play = open_play(path, "script:careful")
    play.play_hand()
    window = open_window(play)
    window.restart()
    hud, seen = window.view.hud, []

    def holds() -> bool:
        seen.extend(hud.rows)
        return window.shown.force > 1.0 and bool(hud.rows)

    qtbot.waitUntil(holds, timeout=PATIENCE)
    frame = stop_and_take(window, qtbot, lambda frame: True)
    window.shown.show(frame)
    (one,) = frame.instruments
    assert hud.isVisible() and one.pinch > 1.0 and one.pad_pressure > 1e4
    jaws, (name, stretch) = hud.rows
    assert jaws == ("Jaws", tell_pinch(Pinch(one.pinch, one.pad_pressure)))
    assert name == "Stretch" and 1.0 < float(stretch) < TORN
    assert hud.wrong == ({"Jaws"} if one.pad_pressure > HARMFUL else set())
    keep_picture(window, "player_jaws")
    window._timer.start()
    qtbot.waitUntil(lambda: window.phase is Phase.over, timeout=2 * PATIENCE)
    assert hud.rows == () and {name for name, _ in seen} == {"Jaws", "Stretch"}


# ---------------------------------------------------------------- instruments as they are drawn


def test_the_trocar_of_an_instrument_is_drawn_where_its_shaft_passes_it(
    open_window, qtbot, two_graspers
):
    window = open_window(two_graspers)
    window.restart()
    frame = stop_and_take(window, qtbot, lambda frame: True)
    window.shown.show(frame)
    view = window.view
    things = view.scenery._things
    ports = [name for name in things if name.endswith("trocar") and things[name].visible]

    assert ports == ["instrument 1 trocar"]  # the other is held freely
    x = things[ports[0]].streams["position"]
    assert np.linalg.norm(x.mean(axis=0) - TROCAR) < 0.03
    along = np.array(TROCAR) - frame.tool_position
    along /= np.linalg.norm(along)
    across = (x - frame.tool_position) - np.outer((x - frame.tool_position) @ along, along)
    assert np.linalg.norm(across, axis=1).min() > 0.0012  # round the shaft

    view.zoom(0.3)
    seen = see_instruments(window.scene, frame)
    with_port = grab(view)
    view.show_instruments([replace(each, trocar=None) for each in seen])
    rows, columns = np.nonzero(np.abs(with_port - grab(view)).sum(axis=-1) > 40)
    pixel = view.world_to_pixel(TROCAR)
    assert len(rows) > 30
    assert np.hypot(columns.mean() - pixel.x(), rows.mean() - pixel.y()) < 40.0


# ---------------------------------------------------------------- hints


def test_hints_say_what_jaws_and_two_hands_can_do_and_so_they_do(open_window, qtbot, two_graspers):
    window = open_window(two_graspers)
    window.restart()
    view = window.view

    def said() -> dict[str, str]:
        return dict(view.hint.pairs)

    def find_jaws(instrument: int = 0) -> float:
        return window.run._loop.snapshot().instruments[instrument].jaw_angle

    at = middle(window)
    move(view, at)
    assert view.hint.isVisible()
    assert said()["Wheel"] == "deeper or higher"
    assert said()["Right button"] == "close the jaws and pull"
    assert said()["A"] == "close the jaws, or open them"
    assert said()["Shift + wheel"] == "turn the instrument"
    assert said()["Tab"] == "instrument 2"
    assert "Alt + wheel" not in said()  # its trocar holds it
    depth = window.hand.hand.depth
    turn_wheel(view, at, 1)
    assert window.hand.hand.depth > depth

    QTest.mousePress(view, RIGHT, NO_KEYS, at)
    assert said()["Move"] == "pull sideways" and said()["Let go"] == "open the jaws"
    qtbot.waitUntil(lambda: find_jaws() < 0.4, timeout=PATIENCE)
    QTest.mouseRelease(view, RIGHT, NO_KEYS, at)
    assert said()["Right button"] == "close the jaws and pull"
    qtbot.waitUntil(lambda: find_jaws() > 0.5, timeout=PATIENCE)
    QTest.keyClick(view, Qt.Key.Key_A)
    assert said()["Let go"] == "open the jaws"
    qtbot.waitUntil(lambda: find_jaws() < 0.4, timeout=PATIENCE)

    QTest.keyClick(view, Qt.Key.Key_Tab)
    assert said()["Tab"] == "instrument 1" and said()["Alt + wheel"] == "lean it"
    assert find_jaws() < 0.4  # stays closed
    turn_wheel(view, at, 3, SHIFT)

    def find_roll() -> float:
        _, _, z, w = window.run._loop.snapshot().instruments[1].sample.orientation
        return 2.0 * np.arctan2(z, w)

    qtbot.waitUntil(lambda: find_roll() == pytest.approx(np.radians(30.0)), timeout=PATIENCE)
    QTest.mousePress(view, LEFT, NO_KEYS, at)
    assert said()["Let go"] == "lift off"
    QTest.mouseRelease(view, LEFT, NO_KEYS, at)
    window.use_language("tr")
    qtbot.wait(1)
    assert said()["Sağ düğme"] == "çeneleri kapat ve çek" and "1. alet" in said().values()


@pytest.mark.parametrize("language", ["en", "tr"])
def test_hints_of_jaws_are_seen_on_small_windows_too(open_window, qtbot, two_graspers, language):
    window = open_window(two_graspers)
    window.use_language(language)
    window.restart()
    hint, room = window.view.hint, {}
    for size in ((960, 640), (1280, 800), (1920, 1080)):
        window.resize(*size)
        qtbot.wait(1)
        move(window.view, middle(window))
        assert hint.isVisible() and window.view.rect().contains(hint.geometry())
        room[size[0]] = dict(hint.shown)
    jaws = {"en": "close the jaws and pull", "tr": "çeneleri kapat ve çek"}[language]
    other = {"en": "instrument 2", "tr": "2. alet"}[language]
    assert jaws in room[960].values()
    assert {jaws, other} <= set(room[1280].values())
    assert list(room[1920].items()) == hint.pairs
