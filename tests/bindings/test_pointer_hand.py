# SPDX-License-Identifier: BSD-3-Clause
"""The mouse as the hand: what each gesture does to the tip, and what the tissue feels of it."""

from __future__ import annotations

import copy

import numpy as np
import palpate
import pytest
from palpate.scene.surfaces import join_rest_surfaces, join_triangles
from palpate.viewport import Grip, PointerHand, make_view
from pointers import Bench
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from stones import make_stone
from surfaces import organ_scene
from windows import LEFT, RIGHT, drag, move, turn_wheel

SCENE = organ_scene(2)
MIDDLE = QPoint(160, 120)
BESIDE = QPoint(3, 3)
RADIUS = SCENE.instruments[0].tool.radius


@pytest.fixture
def view(qtbot):
    made = make_view()
    qtbot.addWidget(made)
    made.resize(320, 240)
    made.show_surface(SCENE.bodies[0].tissue.rest_position, SCENE.bodies[0].tissue.triangles)
    made.show()
    qtbot.waitExposed(made)
    return made


@pytest.fixture
def bench(view):
    return Bench(view, SCENE)


def test_the_hand_begins_above_the_organ_and_touches_nothing(bench):
    assert bench.hand.grip is Grip.hovering
    assert bench.settle().tolist() == [0.0, 0.0, 0.0]
    assert not bench.world.instruments[0].tool.touching


def test_hovering_carries_the_tip_along_the_surface_without_touching_it(view, bench):
    for pixel in (QPoint(140, 100), MIDDLE, QPoint(185, 135)):
        bench.hover(pixel)
        hit = view.pick(QPointF(pixel))
        assert np.linalg.norm(bench.position - hit.point) < RADIUS + 2e-3
        assert bench.hand.depth < 0.0
        assert bench.settle().tolist() == [0.0, 0.0, 0.0]


def test_beside_the_organ_the_tip_goes_on_beside_it(view, bench):
    bench.hover(MIDDLE)
    for k in range(1, 9):  # as a mouse moves, not in one jump
        bench.hover(MIDDLE + (BESIDE - MIDDLE) * k / 8)
    bench.hover(BESIDE)

    off = view.world_to_pixel(bench.position)
    assert abs(off.x() - BESIDE.x()) < 3 and abs(off.y() - BESIDE.y()) < 3
    assert bench.settle().tolist() == [0.0, 0.0, 0.0]


def test_the_left_button_presses_until_it_is_let_go(view, bench):
    bench.hover(MIDDLE)
    outward = bench.position - view.pick(QPointF(MIDDLE)).point
    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    force = bench.settle()

    assert bench.hand.grip is Grip.pressing
    assert bench.hand.depth == pytest.approx(bench.hand.press_depth)
    assert bench.world.instruments[0].tool.touching
    assert force @ outward > 0.0
    QTest.mouseRelease(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    assert bench.hand.grip is Grip.hovering
    assert bench.feel(800).tolist() == [0.0, 0.0, 0.0]


def test_pressing_takes_its_time(view, bench):
    bench.hover(MIDDLE)
    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    bench.feel(10)
    assert bench.depth() < 0.0

    short = bench.hand.press_depth - bench.depth()
    bench.feel(round(1e3 * short / 0.05))
    assert bench.depth() < bench.hand.press_depth
    bench.settle()
    assert bench.depth() == pytest.approx(bench.hand.press_depth, rel=0.05)


def test_a_drag_while_pressing_slides_over_the_surface_under_the_pointer(view, bench):
    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    bench.settle()
    azimuth, deep = view.camera.azimuth, bench.depth()

    move(view, MIDDLE + QPoint(25, 10), LEFT)
    bench.settle()

    under = palpate.find_ray_hit(
        bench.tree, bench.x, *view.ray_at(QPointF(MIDDLE + QPoint(25, 10)))
    )
    foot = palpate.find_closest_point(bench.tree, bench.x, bench.position)
    assert np.linalg.norm(np.subtract(foot.point, under.point)) < 1e-3
    assert bench.depth() == pytest.approx(deep, rel=0.05)
    assert view.camera.azimuth == azimuth


def test_what_is_held_is_pulled_along_in_the_plane_of_the_screen(view, bench):
    bench.hover(MIDDLE)
    QTest.mousePress(view, RIGHT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    bench.settle()
    start, forward = bench.position, view.camera.basis()[2]

    move(view, MIDDLE + QPoint(25, 10), RIGHT)
    bench.settle()

    moved = bench.position - start
    assert abs(moved @ forward) < 1e-8
    pixel = view.pixel_size_at(bench.hand.goal)
    assert np.linalg.norm(moved) == pytest.approx(np.hypot(25, 10) * pixel, rel=1e-3)


def test_the_wheel_goes_deeper_and_higher_hovering_and_pressing(view, bench):
    bench.hover(MIDDLE)
    distance = view.camera.distance
    above = bench.depth()
    turn_wheel(view, MIDDLE, 1)
    bench.settle()
    assert bench.depth() > above
    turn_wheel(view, MIDDLE, -1)
    bench.settle()
    assert bench.depth() == pytest.approx(above, abs=1e-5)

    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    weak = np.linalg.norm(bench.settle())
    turn_wheel(view, MIDDLE, 3)
    assert np.linalg.norm(bench.settle()) > weak
    assert view.camera.distance == distance


def test_one_can_stroke_the_surface_at_a_depth_set_with_the_wheel(view, bench):
    bench.hover(MIDDLE)
    turn_wheel(view, MIDDLE, 8)
    bench.settle()
    assert bench.world.instruments[0].tool.touching
    deep = bench.depth()

    move(view, MIDDLE + QPoint(12, 6))
    bench.settle()
    assert bench.depth() == pytest.approx(deep, rel=0.05)
    assert bench.world.instruments[0].tool.touching


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
    assert bench.samples[-1].buttons == palpate.ATTACH_BUTTON

    turn_wheel(view, MIDDLE, -12)
    bench.feel(300)
    moved = np.asarray(bench.world.bodies[0].tissue.position) - np.asarray(
        SCENE.bodies[0].tissue.rest_position
    )
    QTest.mouseRelease(view, button, keys, MIDDLE)

    assert bench.hand.grip is Grip.hovering
    bench.feel(1100)  # the press lasts as long as the mouse says: QTest's buttons are slow
    assert bench.samples[-1].buttons == 0
    assert np.linalg.norm(moved, axis=1).max() > 0.0


def test_the_grip_closes_only_once_the_tip_is_there(view, bench):
    bench.hover(MIDDLE)
    QTest.mousePress(view, RIGHT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    bench.feel(20)
    assert bench.samples[-1].buttons == 0

    bench.settle()
    closed = next(s for s in bench.samples if s.buttons == palpate.ATTACH_BUTTON)
    assert bench.depth(np.array(closed.position)) > 0.0


def test_the_key_a_takes_hold_and_lets_go(view, bench):
    bench.hover(MIDDLE)
    QTest.keyClick(view, Qt.Key.Key_A)
    bench.settle()
    assert bench.hand.grip is Grip.holding
    assert bench.samples[-1].buttons == palpate.ATTACH_BUTTON
    QTest.keyClick(view, Qt.Key.Key_A)
    assert bench.hand.grip is Grip.hovering
    bench.settle()
    assert bench.samples[-1].buttons == 0


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
    bench.settle()
    assert (
        bench.hand.depth
        < palpate.compute_diagonal(np.asarray(SCENE.bodies[0].tissue.rest_position)) / 2
    )


def test_a_far_jump_goes_around_the_organ_and_touches_nothing(view, bench):
    bench.hover(MIDDLE)
    opposite = view.camera.azimuth + np.pi
    view.look_from(opposite, 0.3)
    move(view, MIDDLE)
    bench.settle()

    hit = view.pick(QPointF(MIDDLE))
    assert np.linalg.norm(bench.position - hit.point) < RADIUS + 2e-3
    assert not any(bench.touching)


def test_the_view_says_what_buttons_and_wheel_do_now(view, bench):
    def said() -> dict[str, str]:
        return dict(view.hint.pairs)

    assert {"Left button", "Right button", "Wheel"} <= set(said())
    assert said()["Wheel"] == "deeper or higher"
    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    assert said()["Move"] == "stroke at this depth"
    QTest.mouseRelease(view, LEFT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    QTest.mousePress(view, RIGHT, Qt.KeyboardModifier.NoModifier, MIDDLE)
    assert said()["Let go"] == "release the tissue"
    view.hint.say(None)
    assert not view.hint.isVisible()


def crowd() -> palpate.Scene:
    """The organ, another 80 mm beside it, a table below them and a stone on that."""
    tissue = SCENE.bodies[0].tissue
    beside = copy.copy(tissue)
    np.asarray(beside.rest_position)[:] += (0.08, 0.0, 0.0)
    low = np.asarray(tissue.rest_position)[:, 2].min() - 0.01
    corners = [(-0.1, -0.1, low), (0.2, -0.1, low), (0.2, 0.1, low), (-0.1, 0.1, low)]
    table = palpate.Scenery(palpate.SurfaceMesh(corners, [(0, 1, 2), (0, 2, 3)]), [])
    stone = make_stone()
    stone.position = (0.0, -0.07, low + 0.01)
    return palpate.build_scene(
        palpate.Scene(
            bodies=[palpate.SoftBody(tissue=tissue), palpate.SoftBody(tissue=beside)],
            scenery=[table],
            rigid=[stone],
        )
    )


def show_crowd(view, scene: palpate.Scene) -> Bench:
    view.show_hard_parts(scene)
    view.show_surface(join_rest_surfaces(scene), join_triangles(scene))
    view.look_from(-np.pi / 2, 0.9)
    view.frame_all()
    return Bench(view, scene)


@pytest.mark.parametrize("aside", [(1.0, 0.0, 1.0), (0.0, 0.0, 1.0)])
def test_of_several_bodies_the_mouse_begins_over_the_first_or_what_covers_it(bench, aside):
    other = copy.copy(SCENE.bodies[0].tissue)
    np.asarray(other.rest_position)[:] += aside
    bodies = [palpate.SoftBody(tissue=each) for each in (SCENE.bodies[0].tissue, other)]
    two = palpate.build_scene(palpate.Scene(bodies=bodies))

    hand = PointerHand(bench.view, palpate.SurfacePointer(two), two)

    top = np.asarray(SCENE.bodies[0].tissue.rest_position)[:, 2].max()
    assert hand.goal[2] == pytest.approx(top if aside[0] else top + 1.0, abs=2e-3)


def test_the_mouse_presses_the_organ_that_is_under_it(view):
    bench = show_crowd(view, crowd())
    top = np.asarray(bench.scene.bodies[1].tissue.rest_position).max(axis=0)
    pixel = view.world_to_pixel((0.08, 0.0, top[2])).toPoint()
    bench.hover(pixel)

    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, pixel)
    force = bench.settle()

    assert force[2] > 0.0
    moved = [
        np.abs(np.asarray(state.tissue.position) - np.asarray(body.tissue.rest_position)).max()
        for state, body in zip(bench.world.bodies, bench.scene.bodies, strict=True)
    ]
    assert moved[1] > 1e-4
    assert moved[0] < 1e-6


def test_the_mouse_presses_scenery(view):
    bench = show_crowd(view, crowd())
    corner = np.asarray(bench.scene.scenery[0].mesh.vertices)[3] + (0.01, -0.01, 0.0)
    pixel = view.world_to_pixel(corner).toPoint()
    bench.hover(pixel)
    assert bench.hand.goal[2] == pytest.approx(corner[2])

    QTest.mousePress(view, LEFT, Qt.KeyboardModifier.NoModifier, pixel)

    assert bench.settle()[2] > 0.0


def test_the_mouse_presses_a_stone_where_it_is_seen_now(view):
    bench = show_crowd(view, crowd())
    now = palpate.RigidBody([(0.0, 0.0, 0.0)], [0.005], position=(-0.05, -0.08, 0.02))
    view.move_rigid([now])
    pixel = view.world_to_pixel(now.position).toPoint()

    bench.hover(pixel)

    assert np.linalg.norm(bench.hand.goal - np.asarray(now.position)) < 0.006
    assert np.linalg.norm(bench.position - np.asarray(now.position)) < 0.006 + RADIUS + 3e-3
    turn_wheel(view, pixel, 1)
    bench.settle()
    assert bench.hand.grip is Grip.hovering
