# SPDX-License-Identifier: BSD-3-Clause
"""The mouse as the hand: what each gesture does to the tip, and what the tissue feels of it."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.viewport import Grip, PointerHand, make_view
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from surfaces import organ_scene
from windows import LEFT, RIGHT, drag, move, turn_wheel

SCENE = organ_scene(2)
MIDDLE = QPoint(160, 120)
BESIDE = QPoint(3, 3)
RADIUS = SCENE.tool.radius


@pytest.fixture
def view(qtbot):
    made = make_view()
    qtbot.addWidget(made)
    made.resize(320, 240)
    made.show_surface(SCENE.tissue.rest_position, SCENE.tissue.triangles)
    made.show()
    qtbot.waitExposed(made)
    return made


class Bench:
    """A hand and the world it would touch, tick by tick and without a clock."""

    def __init__(self, view):
        self.view, self.device = view, palpate.PointerDevice()
        self.hand = view.tool = PointerHand(view, self.device, SCENE)
        self.world = palpate.World(SCENE)
        self.ticks = 0
        self.feel(5)

    def hover(self, pixel: QPoint) -> None:
        move(self.view, pixel)
        self.hand.settle()

    def feel(self, ticks: int = 250) -> np.ndarray:
        """Runs ticks; returns the force [N] of the last."""
        self.hand.settle()
        for _ in range(ticks):
            sample = self.device.read(self.ticks / SCENE.rate)
            command = palpate.tick(SCENE, sample, 1.0 / SCENE.rate, self.world)
            self.ticks += 1
        return np.asarray(command.force)

    def depth(self) -> float:
        """[m] of the tip below the surface at rest."""
        x, faces = np.array(SCENE.tissue.rest_position), np.array(SCENE.tissue.triangles)
        tree = palpate.AabbTree(x, faces)
        return RADIUS - palpate.find_closest_point(tree, x, self.hand.position).distance


@pytest.fixture
def bench(view):
    return Bench(view)


def test_the_hand_begins_above_the_organ_and_touches_nothing(bench):
    assert bench.hand.grip is Grip.hovering
    assert bench.feel().tolist() == [0.0, 0.0, 0.0]
    assert not bench.world.tool.touching


def test_hovering_carries_the_tip_along_the_surface_without_touching_it(view, bench):
    for pixel in (QPoint(140, 100), MIDDLE, QPoint(185, 135)):
        bench.hover(pixel)
        hit = view.pick(QPointF(pixel))
        assert np.linalg.norm(bench.hand.position - hit.point) < RADIUS + 2e-3
        assert bench.hand.depth < 0.0
        assert bench.feel().tolist() == [0.0, 0.0, 0.0]


def test_beside_the_organ_the_tip_goes_on_beside_it(view, bench):
    bench.hover(MIDDLE)
    for k in range(1, 9):  # as a mouse moves, not in one jump
        bench.hover(MIDDLE + (BESIDE - MIDDLE) * k / 8)
    bench.hover(BESIDE)

    off = view.world_to_pixel(bench.hand.position)
    assert abs(off.x() - BESIDE.x()) < 3 and abs(off.y() - BESIDE.y()) < 3
    assert bench.feel().tolist() == [0.0, 0.0, 0.0]


def test_the_left_button_presses_until_it_is_let_go(view, bench):
    bench.hover(MIDDLE)
    outward = bench.hand.position - view.pick(QPointF(MIDDLE)).point
    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    force = bench.feel()

    assert bench.hand.grip is Grip.pressing
    assert bench.hand.depth == pytest.approx(bench.hand.press_depth)
    assert bench.world.tool.touching
    assert force @ outward > 0.0
    QTest.mouseRelease(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    assert bench.hand.grip is Grip.hovering
    assert bench.feel(800).tolist() == [0.0, 0.0, 0.0]


def test_pressing_takes_its_time(view, bench, qtbot):
    bench.hover(MIDDLE)
    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    assert bench.hand.depth < 0.0

    qtbot.waitUntil(lambda: bench.hand.depth == bench.hand.press_depth)


def test_a_drag_while_pressing_stays_in_the_plane_of_the_screen(view, bench):
    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    bench.hand.settle()
    start, forward = bench.hand.position, view.camera.basis()[2]
    azimuth = view.camera.azimuth

    move(view, MIDDLE + QPoint(25, 10), LEFT)
    bench.hand.settle()

    way = bench.hand.position - start
    assert abs(way @ forward) < 1e-9
    pixel = view.pixel_size_at(view.pick(QPointF(MIDDLE)).point)
    assert np.linalg.norm(way) == pytest.approx(np.hypot(25, 10) * pixel, rel=1e-3)
    assert view.camera.azimuth == azimuth


def test_the_wheel_goes_deeper_and_higher_hovering_and_pressing(view, bench):
    bench.hover(MIDDLE)
    distance = view.camera.distance
    above = bench.hand.depth
    turn_wheel(view, MIDDLE, 1)
    bench.hand.settle()
    assert bench.hand.depth > above
    turn_wheel(view, MIDDLE, -1)
    bench.hand.settle()
    assert bench.hand.depth == pytest.approx(above)

    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    weak = np.linalg.norm(bench.feel())
    turn_wheel(view, MIDDLE, 3)
    assert np.linalg.norm(bench.feel()) > weak
    assert view.camera.distance == distance


def test_one_can_stroke_the_surface_at_a_depth_set_with_the_wheel(view, bench):
    bench.hover(MIDDLE)
    turn_wheel(view, MIDDLE, 8)
    bench.feel()
    assert bench.world.tool.touching
    deep = bench.hand.depth

    move(view, MIDDLE + QPoint(12, 6))
    assert bench.hand.depth == deep
    bench.feel()
    assert bench.world.tool.touching


@pytest.mark.parametrize(
    ("button", "keys"),
    [(RIGHT, Qt.KeyboardModifier.NoModifier), (LEFT, Qt.KeyboardModifier.ControlModifier)],
)
def test_right_or_ctrl_takes_hold_and_pulls_until_it_lets_go(view, bench, button, keys):
    bench.hover(MIDDLE)
    QTest.mousePress(view, button, keys, MIDDLE)
    bench.feel(20)  # not yet there: a grip in the air would hold nothing
    bench.feel(300)
    assert bench.hand.grip is Grip.holding
    assert bench.device.read(0.0).buttons == palpate.ATTACH_BUTTON

    turn_wheel(view, MIDDLE, -12)
    bench.feel(300)
    moved = np.asarray(bench.world.tissue.position) - np.asarray(SCENE.tissue.rest_position)
    QTest.mouseRelease(view, button, keys, MIDDLE)

    assert bench.hand.grip is Grip.hovering
    assert bench.device.read(0.0).buttons == 0
    assert np.linalg.norm(moved, axis=1).max() > 0.0


def test_the_grip_closes_only_once_the_tip_is_there(view, bench, qtbot):
    bench.hover(MIDDLE)
    QTest.mousePress(view, RIGHT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    assert bench.device.read(0.0).buttons == 0

    qtbot.waitUntil(lambda: bench.device.read(0.0).buttons == palpate.ATTACH_BUTTON)
    assert bench.hand.depth > 0.0


def test_the_key_a_takes_hold_and_lets_go(view, bench):
    bench.hover(MIDDLE)
    QTest.keyClick(view, Qt.Key.Key_A)
    bench.hand.settle()
    assert bench.hand.grip is Grip.holding
    QTest.keyClick(view, Qt.Key.Key_A)
    assert bench.hand.grip is Grip.hovering
    assert bench.device.read(0.0).buttons == 0


def test_beside_the_organ_the_mouse_moves_the_camera(view, bench):
    azimuth, distance = view.camera.azimuth, view.camera.distance
    drag(view, BESIDE, QPoint(20, 10))
    assert view.camera.azimuth != azimuth
    turn_wheel(view, BESIDE, 1)
    assert view.camera.distance < distance
    turn_wheel(view, MIDDLE, 1, Qt.KeyboardModifier.ControlModifier)
    assert bench.hand.depth < 0.0
    assert bench.hand.grip is Grip.hovering


def test_depths_have_an_end(view, bench):
    bench.hover(MIDDLE)
    for _ in range(500):
        turn_wheel(view, MIDDLE, 5)
    bench.hand.settle()
    assert bench.hand.depth < palpate.compute_diagonal(np.asarray(SCENE.tissue.rest_position)) / 2


def test_a_far_jump_goes_around_the_organ_and_touches_nothing(view, bench):
    bench.hover(MIDDLE)
    bench.feel()
    opposite = view.camera.azimuth + np.pi
    view.look_from(opposite, 0.3)
    move(view, MIDDLE)
    touched = False
    # the hand as a live loop reads it, between the steps of the window
    while bench.hand.is_moving():
        bench.hand.advance()
        for _ in range(8):
            sample = bench.device.read(bench.ticks / SCENE.rate)
            palpate.tick(SCENE, sample, 1.0 / SCENE.rate, bench.world)
            bench.ticks += 1
            touched = touched or bench.world.tool.touching

    hit = view.pick(QPointF(MIDDLE))
    assert np.linalg.norm(bench.hand.position - hit.point) < RADIUS + 2e-3
    assert not touched
