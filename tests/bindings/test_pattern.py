# SPDX-License-Identifier: BSD-3-Clause
"""Spots and vessels on a surface: where they are drawn, and that they stick to it."""

from __future__ import annotations

import json
from dataclasses import asdict, replace

import numpy as np
import pytest
from palpate.render import (
    Appearance,
    Camera,
    Pattern,
    Renderer,
    build_appearance,
    draw_picture,
    open_context,
)
from palpate.render.authored_appearance import find_appearance
from palpate.scene.scene_parts import AppearancePart
from round_surfaces import ball

pytestmark = pytest.mark.usefixtures("little_sky")

SIZE = (240, 200)
PLAIN = Appearance(colour=(0.5, 0.2, 0.2))
SPOTTED = Appearance(colour=(0.5, 0.2, 0.2), pattern=Pattern((0.9, 0.8, 0.7), 0.004, strength=0.9))


def picture(appearance, **more):
    options = {"size": SIZE, "supersample": 1, "wireframe": False, **more}
    return draw_picture(*ball(), appearance=appearance, **options).astype(int)


def middle(pixels):
    return pixels[70:130, 90:150]


def test_a_pattern_brings_spots_of_its_colour():
    plain, spotted = middle(picture(PLAIN)), middle(picture(SPOTTED))

    assert spotted[..., 1].std() > 2.0 * plain[..., 1].std()
    assert spotted[..., 1].max() > plain[..., 1].max() + 20


def test_a_pattern_without_strength_changes_nothing():
    faint = Appearance(
        colour=(0.5, 0.2, 0.2), pattern=Pattern((0.9, 0.8, 0.7), 0.004, strength=0.0)
    )

    assert np.abs(picture(faint) - picture(PLAIN)).max() <= 1


def test_a_colour_map_is_not_painted_over():
    values = ball()[0][:, 2]

    assert np.array_equal(picture(SPOTTED, values=values), picture(PLAIN, values=values))


def test_a_rough_surface_has_a_wider_and_fainter_highlight():
    wet, dry = (
        picture(Appearance(colour=(0.3, 0.1, 0.1), gloss=1.0, roughness=r)).sum(axis=2)
        for r in (0.15, 0.9)
    )

    def width(pixels):
        bright = middle(pixels)
        return (bright > 0.5 * (bright.max() + np.median(bright))).sum()

    assert width(wet) < width(dry)


PART = AppearancePart(
    colour=(0.5, 0.2, 0.2),
    pattern_colour=(0.9, 0.8, 0.7),
    pattern_size=0.004,
    pattern_strength=0.9,
    vein_colour=(0.4, 0.1, 0.1),
    vein_strength=0.5,
    relief=0.1,
    gloss=0.8,
    roughness=0.25,
    subsurface=0.4,
)


def test_what_files_say_of_an_appearance_is_what_is_drawn():
    appearance = build_appearance(PART)

    assert (appearance.colour, appearance.gloss, appearance.roughness) == (PART.colour, 0.8, 0.25)
    assert appearance.pattern == Pattern(
        PART.pattern_colour, 0.004, 0.9, 0.1, PART.vein_colour, 0.5
    )


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            {"colour": (0.5, 0.2)},
            "appearance.colour: got [0.5, 0.2], expected three numbers of 0 to 1",
        ),
        ({"pattern_size": 0.0}, "appearance.pattern_size: got 0.0 m, expected a positive length"),
        ({"roughness": 1.5}, "appearance.roughness: got 1.5, expected 0 to 1"),
    ],
)
def test_an_appearance_out_of_its_ranges_is_refused(change, said):
    with pytest.raises(ValueError) as refused:
        build_appearance(replace(PART, **change))

    assert str(refused.value) == said


class Published:
    """As much of a published scenario as an appearance is found in."""

    def __init__(self, authored: str):
        self.authored = authored


@pytest.mark.parametrize("version", [1, 4, 5])
def test_a_player_finds_the_appearance_that_a_designer_gave_in_any_version(version):
    content = {"appearance": asdict(PART)}
    if version < 5:
        old = asdict(PART)
        old["softness"] = old.pop("subsurface")
        content = {"look": old}
    document = {"format": "organ", "version": version, "content": content}

    assert find_appearance(Published(json.dumps(document))) == build_appearance(PART)


@pytest.mark.parametrize(
    "authored",
    ["", "{", "[]", "{}", '{"content": null}', '{"content": {"appearance": null}}',
     '{"version": 5, "content": {"appearance": {"colour": 1}}}', "[" * 100000,
     '{"version": "5", "content": {"appearance": null}}',
     '{"version": 5, "content": {"appearance": null}}', '{"version": 4, "content": {"look": 3}}',
     json.dumps({"version": 4, "content": {"look": asdict(PART)}}),
     json.dumps({"version": 5, "content": {"appearance": {**asdict(PART), "gloss": 7}}})],
)  # fmt: skip
def test_an_appearance_that_cannot_be_read_is_no_reason_not_to_play(authored):
    assert find_appearance(Published(authored)) is None


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
