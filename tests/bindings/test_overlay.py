# SPDX-License-Identifier: BSD-3-Clause
from itertools import combinations

import numpy as np
import pytest
from palpate.render.colour_map import build_legend
from palpate.render.overlay import Box, Overlay
from palpate.render.theme import DARK, LIGHT

SIZES = [(1280, 720), (640, 360), (3840, 2160), (720, 1280), (400, 300)]


def full_overlay(size, theme=DARK):
    overlay = Overlay(size, theme)
    overlay.add_title("spleen, 600 vertices: pressed 6 mm and pulled 6 mm")
    overlay.add_legend(build_legend([0.0, 5.9]), "displacement [mm]")
    overlay.add_note("arrow: 20 mm per N")
    end = np.array([0.6 * size[0], 0.3 * size[1]])
    overlay.add_label("1.23 N", end + [0.0, 0.2 * size[1]], end, 0.02 * size[1])
    return overlay


@pytest.mark.parametrize("size", SIZES)
def test_nothing_written_overlaps_or_leaves_the_picture(size):
    overlay = full_overlay(size)

    whole = Box(0, 0, *size)
    assert len(overlay.taken) == 4
    assert all(whole.holds(box) for box in overlay.taken)
    assert not any(a.meets(b) for a, b in combinations(overlay.taken, 2))


@pytest.mark.parametrize("size", SIZES)
def test_the_organ_keeps_a_place_of_its_own(size):
    overlay = full_overlay(size)

    free = overlay.free
    assert free.right - free.left > 0.4 * size[0]
    assert free.bottom - free.top > 0.4 * size[1]
    assert not any(free.meets(box) for box in overlay.taken[:3])


@pytest.mark.parametrize("size", SIZES)
def test_letters_never_become_too_small_to_read(size):
    overlay = Overlay(size, DARK)

    assert overlay.letters(15.0) >= 10.5


def test_the_ink_lies_in_the_boxes_that_are_taken():
    size = (640, 360)
    overlay = full_overlay(size, LIGHT)
    blank = np.full((size[1], size[0], 3), 127, np.uint8)

    inked = (overlay.blend(blank) != blank).any(axis=2)

    outside = inked.copy()
    for box in overlay.taken:
        rows = slice(max(0, int(box.top) - 2), int(box.bottom) + 3)
        outside[rows, max(0, int(box.left) - 2) : int(box.right) + 3] = False
    assert inked.any()
    assert not outside.any()


def test_a_label_stays_clear_of_the_arrow_it_names():
    size = (640, 360)
    for angle in np.linspace(0.0, 2 * np.pi, 16, endpoint=False):
        overlay = Overlay(size, DARK)
        start = np.array([320.0, 180.0])
        end = start + 120.0 * np.array([np.cos(angle), np.sin(angle)])

        overlay.add_label("1.23 N", start, end, 20.0)

        (box,) = overlay.taken
        path = start + np.linspace(0.0, 1.0, 200)[:, None] * (end - start)
        inside = (path > [box.left - 10, box.top - 10]) & (path < [box.right + 10, box.bottom + 10])
        assert not inside.all(axis=1).any()


def test_a_title_too_long_for_the_picture_is_shortened():
    overlay = Overlay((400, 300), DARK)

    overlay.add_title("a very long name of a very long organ " * 5)

    (box,) = overlay.taken
    assert box.right <= 400 - overlay.margin + 1


def test_a_picture_too_small_for_a_legend_has_none():
    overlay = Overlay((64, 64), DARK)

    overlay.add_legend(build_legend([0.0, 1.0]), "displacement [mm]")

    assert overlay.taken == []
    assert overlay.free.right - overlay.free.left > 50
