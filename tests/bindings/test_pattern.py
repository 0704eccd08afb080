# SPDX-License-Identifier: BSD-3-Clause
"""Spots and vessels on a surface: where they are drawn, and that they stick to it."""

from __future__ import annotations

import numpy as np
import pytest
from palpate.render import Camera, Look, Pattern, Renderer, draw_picture, open_context
from round_surfaces import ball

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
