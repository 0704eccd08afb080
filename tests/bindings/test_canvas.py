# SPDX-License-Identifier: BSD-3-Clause
"""How large a frame is drawn while things move: as large as there is time for."""

from __future__ import annotations

import numpy as np
import pytest
from palpate.render import Camera
from palpate.render.context import create_context
from palpate.viewport import canvas
from palpate.viewport.canvas import Canvas
from palpate.viewport.scenery import Scenery
from surfaces import ellipsoid

SIZE = (800, 600)


@pytest.fixture
def drawing():
    """A canvas and what it draws; skipped where a graphics card draws every frame in full."""
    context = create_context()
    with context:
        made, scenery = Canvas(context), Scenery()
        if not made.is_software:
            pytest.skip("cannot be had here: a software renderer beside the graphics card")
        scenery.build(context)
        yield made, scenery
        scenery.release()
        made.release()
    context.release()


def show(scenery: Scenery, refinements: int) -> None:
    mesh = ellipsoid((0.03, 0.025, 0.02), refinements)
    scenery.show_surface(mesh.vertices, mesh.triangles)


def draw(made: Canvas, scenery: Scenery) -> float:
    """Share of the view's width and height that the next quick frame has, before it is
    stretched."""
    scenery.version += 1
    assert made.draw(scenery, Camera(target=np.zeros(3), distance=0.2), SIZE, 1.0)
    width, height = made._targets["whole"].size
    assert width / SIZE[0] == pytest.approx(height / SIZE[1], rel=0.02)
    return width / SIZE[0]


def test_frames_shrink_step_by_step_while_they_take_too_long(drawing, monkeypatch):
    made, scenery = drawing
    show(scenery, 2)
    monkeypatch.setattr(canvas, "QUICK_TIME", 0.0)

    sizes = [draw(made, scenery) for _ in range(5)]

    wanted = [1 / 2, 1 / 2.5, 1 / 3, 1 / 3, 1 / 3]
    assert sizes == pytest.approx(wanted, rel=0.02)


@pytest.mark.parametrize("size", [(160, 120), (1281, 799), (2560, 1600)])
def test_no_frame_is_ever_smaller_than_a_third_of_the_view(drawing, monkeypatch, size):
    made, scenery = drawing
    show(scenery, 5)
    monkeypatch.setattr(canvas, "QUICK_TIME", 0.0)
    for _ in range(3):
        scenery.version += 1
        made.draw(scenery, Camera(target=np.zeros(3), distance=0.2), size, 1.0)

        drawn = made._targets["whole"].size
        assert 3 * drawn[0] >= size[0] and 3 * drawn[1] >= size[1]


def test_a_frame_that_took_too_long_asks_for_a_pause(drawing, monkeypatch):
    made, scenery = drawing
    show(scenery, 2)
    monkeypatch.setattr(canvas, "QUICK_TIME", 1e9)
    draw(made, scenery)
    assert made.pause == 0.0

    monkeypatch.setattr(canvas, "QUICK_TIME", 0.0)
    draw(made, scenery)
    assert 0.0 < made.pause <= canvas.MOST_PAUSE


def test_frames_grow_step_by_step_while_there_is_time(drawing, monkeypatch):
    made, scenery = drawing
    show(scenery, 2)
    monkeypatch.setattr(canvas, "QUICK_TIME", 1e9)

    sizes = [draw(made, scenery) for _ in range(4)]

    assert sizes == pytest.approx([1 / 2, 2 / 3, 1.0, 1.0], rel=0.02)


def test_the_first_frame_of_a_heavy_surface_is_small_and_a_light_ones_is_not(drawing, monkeypatch):
    made, scenery = drawing
    show(scenery, 2)
    monkeypatch.setattr(canvas, "QUICK_TIME", 1e9)
    draw(made, scenery)
    show(scenery, 2)
    light = draw(made, scenery)

    show(scenery, 5)
    assert len(scenery.triangles) > canvas.LIGHT_SURFACE
    heavy = draw(made, scenery)

    assert light == pytest.approx(2 / 3, rel=0.02)
    assert heavy == pytest.approx(1 / 3, rel=0.02)
