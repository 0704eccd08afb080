# SPDX-License-Identifier: BSD-3-Clause
"""Spots and vessels on a surface: where they are drawn, and that they stick to it."""

from __future__ import annotations

import json
from dataclasses import asdict, replace

import numpy as np
import pytest
from palpate.render import (
    Camera,
    Look,
    Pattern,
    Renderer,
    build_look,
    draw_picture,
    open_context,
)
from palpate.render.authored_look import find_look
from palpate.scene.scene_parts import LookPart
from round_surfaces import ball

pytestmark = pytest.mark.usefixtures("little_sky")

SIZE = (240, 200)
PLAIN = Look(colour=(0.5, 0.2, 0.2))
SPOTTED = Look(colour=(0.5, 0.2, 0.2), pattern=Pattern((0.9, 0.8, 0.7), 0.004, strength=0.9))


def picture(look, **more):
    options = {"size": SIZE, "supersample": 1, "wireframe": False, **more}
    return draw_picture(*ball(), look=look, **options).astype(int)


def middle(pixels):
    return pixels[70:130, 90:150]


def test_a_pattern_brings_spots_of_its_colour():
    plain, spotted = middle(picture(PLAIN)), middle(picture(SPOTTED))

    assert spotted[..., 1].std() > 2.0 * plain[..., 1].std()
    assert spotted[..., 1].max() > plain[..., 1].max() + 20


def test_a_pattern_without_strength_changes_nothing():
    faint = Look(colour=(0.5, 0.2, 0.2), pattern=Pattern((0.9, 0.8, 0.7), 0.004, strength=0.0))

    assert np.abs(picture(faint) - picture(PLAIN)).max() <= 1


def test_a_colour_map_is_not_painted_over():
    values = ball()[0][:, 2]

    assert np.array_equal(picture(SPOTTED, values=values), picture(PLAIN, values=values))


def test_a_rough_surface_has_a_wider_and_fainter_highlight():
    wet, dry = (
        picture(Look(colour=(0.3, 0.1, 0.1), gloss=1.0, roughness=r)).sum(axis=2)
        for r in (0.15, 0.9)
    )

    def width(pixels):
        bright = middle(pixels)
        return (bright > 0.5 * (bright.max() + np.median(bright))).sum()

    assert width(wet) < width(dry)


PART = LookPart(
    colour=(0.5, 0.2, 0.2),
    pattern_colour=(0.9, 0.8, 0.7),
    pattern_size=0.004,
    pattern_strength=0.9,
    vein_colour=(0.4, 0.1, 0.1),
    vein_strength=0.5,
    relief=0.1,
    gloss=0.8,
    roughness=0.25,
    softness=0.4,
)


def test_what_files_say_of_a_look_is_what_is_drawn():
    look = build_look(PART)

    assert (look.colour, look.gloss, look.roughness) == (PART.colour, 0.8, 0.25)
    assert look.pattern == Pattern(PART.pattern_colour, 0.004, 0.9, 0.1, PART.vein_colour, 0.5)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"colour": (0.5, 0.2)}, "look.colour: got [0.5, 0.2], expected three numbers of 0 to 1"),
        ({"pattern_size": 0.0}, "look.pattern_size: got 0.0 m, expected a positive length"),
        ({"roughness": 1.5}, "look.roughness: got 1.5, expected 0 to 1"),
    ],
)
def test_what_nothing_can_look_like_is_refused(change, said):
    with pytest.raises(ValueError) as refused:
        build_look(replace(PART, **change))

    assert str(refused.value) == said


class Published:
    """As much of a published scenario as a look is found in."""

    def __init__(self, authored: str):
        self.authored = authored


def test_a_player_finds_the_look_that_a_designer_gave():
    document = {"format": "organ", "version": 1, "content": {"look": asdict(PART)}}

    assert find_look(Published(json.dumps(document))) == build_look(PART)


@pytest.mark.parametrize(
    "authored",
    ["", "{", "[]", "{}", '{"content": null}', '{"content": {"look": null}}',
     '{"content": {"look": {"colour": 1}}}', "[" * 100000,
     json.dumps({"content": {"look": {**asdict(PART), "gloss": 7}}})],
)  # fmt: skip
def test_a_look_that_nobody_can_read_is_no_reason_not_to_play(authored):
    assert find_look(Published(authored)) is None


def shoot(gl, part, renderer):
    frame = gl.framebuffer([gl.renderbuffer(SIZE, 4)], gl.depth_renderbuffer(SIZE))
    frame.use()
    camera = Camera()
    camera.fit(ball()[0], SIZE)
    renderer.draw(camera, SIZE)
    data = np.frombuffer(frame.read(components=3, alignment=1), np.uint8)
    frame.release()
    return data.reshape(SIZE[1], SIZE[0], 3).astype(int)


@pytest.mark.parametrize("moved", [False, True])
def test_a_pattern_sticks_to_the_tissue_that_moves(moved):
    """Turned by a right angle about the axis of sight's height, other spots come to the front."""
    x, triangles = ball()
    turned = x @ np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    normals = (x / np.linalg.norm(x, axis=1)[:, None]).astype(np.float32)
    with open_context() as gl:
        renderer = Renderer(gl)
        renderer.use_bounds(np.zeros(3), 1.2 * float(np.linalg.norm(x, axis=1).max()))
        part = renderer.add(len(x), triangles, SPOTTED)
        part.update(position=x.astype(np.float32), normal=normals)
        before = middle(shoot(gl, part, renderer))
        if moved:
            spun = (turned / np.linalg.norm(turned, axis=1)[:, None]).astype(np.float32)
            part.update(position=turned.astype(np.float32), normal=spun)
        after = middle(shoot(gl, part, renderer))
        renderer.release()

    # a pattern fixed in space would look the same again on a ball
    assert (np.abs(after - before).max() > 40) == moved
