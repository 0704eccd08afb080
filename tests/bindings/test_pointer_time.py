# SPDX-License-Identifier: BSD-3-Clause
"""The mouse as the hand: what is felt does not depend on how often the window draws, and a stroke
keeps its depth all over an organ."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.viewport import Grip, make_view
from pointers import LEFT, NO_BUTTON, Bench, tell_mouse
from PySide6.QtCore import QEvent, QPoint, QPointF
from surfaces import organ_scene
from windows import turn_wheel

ORGANS = Path(__file__).resolve().parents[1] / "scenes" / "springs"
MIDDLE = QPoint(160, 120)
PRESS, MOVE, RELEASE = (
    QEvent.Type.MouseButtonPress,
    QEvent.Type.MouseMove,
    QEvent.Type.MouseButtonRelease,
)


@pytest.fixture
def open_bench(qtbot):
    """open_bench(scene) is the view, with it in it, and the mouse as the hand."""

    view = make_view()
    qtbot.addWidget(view)

    def open_it(scene: palpate.Scene, size=(320, 240)) -> Bench:
        view.resize(*size)
        x = palpate.compute_surface(scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position)
        view.show_surface(x, scene.bodies[0].tissue.triangles)
        view.show()
        qtbot.waitExposed(view)
        return Bench(view, scene)

    return open_it


def press_for(bench: Bench, rate: float, lasts: float) -> np.ndarray:
    """[N] of every tick of a press that lasts so long [s], in a window of so many frames [1/s]."""
    bench.hover(MIDDLE)
    begun = bench.ticks
    at = QPointF(MIDDLE)
    bench.play(
        rate,
        [
            (0.13, lambda now: tell_mouse(bench.view, PRESS, at, LEFT, now)),
            (0.13 + lasts, lambda now: tell_mouse(bench.view, RELEASE, at, NO_BUTTON, now)),
        ],
        2.0 + 2 * lasts,
    )
    return np.linalg.norm(bench.forces[begun:], axis=1)


def test_the_same_press_gives_the_same_force_at_5_at_20_and_at_60_frames_a_second(open_bench):
    felt = [press_for(open_bench(organ_scene(2)), rate, 1.0) for rate in (5, 20, 60)]

    peaks = [force.max() for force in felt]
    impulses = [force.sum() for force in felt]
    assert peaks[0] > 0.01
    assert peaks == pytest.approx([peaks[0]] * 3, rel=0.03)
    assert impulses == pytest.approx([impulses[0]] * 3, rel=0.03)


@pytest.mark.parametrize("rate", [2.0, 0.4])
def test_a_press_of_a_second_is_felt_however_seldom_the_window_finds_time(open_bench, rate):
    """At 0.4 frames a second the window hears of the press once it is over."""
    ideal = press_for(open_bench(organ_scene(2)), 1000, 1.0)
    bench = open_bench(organ_scene(2))
    bench.hover(MIDDLE)
    begun, at = bench.ticks, QPointF(MIDDLE)
    bench.play(
        rate,
        [
            (0.1, lambda now: tell_mouse(bench.view, PRESS, at, LEFT, now)),
            (1.1, lambda now: tell_mouse(bench.view, RELEASE, at, NO_BUTTON, now)),
        ],
        6.0,
    )

    force = np.linalg.norm(bench.forces[begun:], axis=1)
    assert force.max() == pytest.approx(ideal.max(), rel=0.03)
    assert 0.7 < (force > 0.5 * ideal.max()).sum() / bench.scene.rate < 1.5
    assert force[-1] == 0.0
    assert bench.hand.grip is Grip.hovering


def turn_towards(bench: Bench, pixels: list[QPointF]) -> np.ndarray:
    """(n, 3) outward normals of the surface at rest under pixels."""
    normals = np.asarray(palpate.compute_vertex_normals(bench.x, bench.faces))
    found = []
    for at in pixels:
        hit = palpate.find_ray_hit(bench.tree, bench.x, *bench.view.ray_at(at))
        found.append(np.asarray(hit.weights) @ normals[bench.faces[hit.triangle]])
    return np.array([n / np.linalg.norm(n) for n in found])


def find_stroke(bench: Bench, height: float) -> list[QPointF]:
    """Pixels across the organ from rim to rim, `height` [-] of its radius over its middle."""
    place = bench.view.scenery.centre + [0.0, 0.0, height * bench.view.scenery.radius]
    row = bench.view.world_to_pixel(place).y()
    line = [QPointF(x, row) for x in range(bench.view.width())]
    seen = [at for at in line if bench.view.pick(at) is not None]
    return seen[4:-4]


LIVER, KIDNEY, SPLEEN = ("liver", -0.3, 6e-3), ("kidney", 0.3, 6e-3), ("spleen", 0.0, 6e-3)


@pytest.mark.parametrize(
    ("rate", "organ", "height", "deepest"),
    [
        (10, *KIDNEY),
        (10, *SPLEEN),
        (60, *SPLEEN),
        *(pytest.param(*row, marks=pytest.mark.verify)
          for row in ((10, *LIVER), (60, *LIVER), (60, *KIDNEY))),
    ],
)  # fmt: skip
def test_a_stroke_over_a_convex_organ_keeps_contact_and_depth_all_the_way(
    open_bench, organ, height, deepest, rate
):
    bench = open_bench(palpate.scenario.read(ORGANS / f"{organ}.palpate").scene, (1280, 800))
    stroke = find_stroke(bench, height)
    normals = turn_towards(bench, stroke)
    turned = np.degrees(np.arccos(np.clip(normals[0] @ normals[-1], -1.0, 1.0)))
    assert turned > 90.0
    bench.hover(stroke[0].toPoint())
    tell_mouse(bench.view, PRESS, stroke[0], LEFT, bench.time)
    while bench.hand.depth > deepest:
        turn_wheel(bench.view, stroke[0].toPoint(), -1)
    bench.settle()
    chosen, begun = bench.hand.depth, bench.ticks
    assert bench.depth() == pytest.approx(chosen, rel=0.05)

    lasts = 3.0

    def go(at: QPointF):
        return lambda now: tell_mouse(bench.view, MOVE, at, LEFT, now)

    count = len(stroke) - 1
    moves = [(lasts * k / count, go(at)) for k, at in enumerate(stroke) if k]
    bench.play(rate, moves, lasts + 0.5)

    depths = np.array([bench.depth(np.array(s.position)) for s in bench.samples[begun::5]])
    assert all(bench.touching[begun:])
    assert depths.min() > 0.8 * chosen
    assert depths.max() < 1.2 * chosen
    there = bench.view.world_to_pixel(bench.hand.goal)
    assert abs(there.x() - stroke[-1].x()) < 1.0


def test_a_drag_past_the_rim_stays_on_the_organ(open_bench):
    bench = open_bench(organ_scene(2))
    bench.hover(MIDDLE)
    tell_mouse(bench.view, PRESS, QPointF(MIDDLE), LEFT, bench.time)
    bench.settle()
    for k in range(1, 40):
        at = QPointF(160 - 4 * k, 120)
        tell_mouse(bench.view, MOVE, at, LEFT, bench.time)
        bench.feel(30)
    bench.settle()

    assert bench.view.pick(at) is None
    assert bench.world.instruments[0].tool.touching
    assert bench.depth() == pytest.approx(bench.hand.depth, rel=0.1)


def test_a_recorded_hand_of_the_mouse_replays_to_the_same_bits(tmp_path, open_bench):
    bench = open_bench(organ_scene(2))
    bench.hover(MIDDLE)
    press_for(bench, 20, 0.3)
    again = palpate.World(bench.scene)
    device = palpate.ReplayDevice(bench.samples)
    for k in range(bench.ticks):
        command = palpate.tick(bench.scene, device.read(0.0), 1.0 / bench.scene.rate, again)
        assert np.array(command.force).tobytes() == bench.forces[k].tobytes()

    assert palpate.compute_hash(again) == palpate.compute_hash(bench.world)
