# SPDX-License-Identifier: BSD-3-Clause
import os
import subprocess
import sys

import numpy as np
import palpate
import pytest
from matplotlib.image import imread
from palpate.render import (
    Appearance,
    Camera,
    Renderer,
    build_legend,
    draw_picture,
    open_context,
    save_picture,
    studio,
)
from palpate.render.colour_map import build_viridis
from palpate.render.openness import Sky
from round_surfaces import RADIUS, ball, bowl

pytestmark = pytest.mark.usefixtures("little_sky")

SIZE = (320, 240)
QUICK = {"size": SIZE, "supersample": 1}
TOOL = (np.array([0.0, -RADIUS, 0.0]), 0.004)
"""On the side of the ball that looks at a camera of azimuth -90 degrees."""
FROM_FRONT = {"azimuth": -90.0, "elevation": 0.0}


@pytest.fixture(scope="module")
def gl():
    with open_context() as context:
        yield context


def picture(**appearance):
    return draw_picture(*ball(), **{**QUICK, **appearance}).astype(int)


def redness(pixels):
    return pixels[..., 0] - np.maximum(pixels[..., 1], pixels[..., 2])


def shoot(gl, renderer, camera, size=SIZE):
    """What a renderer draws, (h, w, 3), the top row first."""
    frame = gl.framebuffer([gl.renderbuffer(size, 4)], gl.depth_renderbuffer(size))
    frame.use()
    renderer.draw(camera, size)
    data = np.frombuffer(frame.read(components=3, alignment=1), np.uint8)
    frame.release()
    return data.reshape(size[1], size[0], 3)[::-1].astype(int)


def add_ball(renderer, colour=(0.7, 0.3, 0.3), shift=(0.0, 0.0, 0.0), appearance=None):
    x, triangles = ball()
    part = renderer.add(len(x), triangles, appearance or Appearance(colour=colour))
    normals = palpate.compute_vertex_normals(x, triangles)
    part.update(position=(x + shift).astype(np.float32), normal=normals.astype(np.float32))
    return part


def front_camera():
    camera = Camera(azimuth=-np.pi / 2, elevation=0.0)
    camera.fit(ball()[0], SIZE)
    return camera


def renderer_of(gl):
    renderer = Renderer(gl)
    renderer.use_bounds(np.zeros(3), 0.3)
    return renderer


# ---------------------------------------------------------------- pictures


def test_the_organ_stands_in_the_middle_and_the_background_in_the_corners():
    pixels = picture()

    corners = pixels[[0, 0, -1, -1], [0, -1, 0, -1]]
    assert corners.max() < 70
    assert np.ptp(corners, axis=1).max() < 25  # grey
    assert redness(pixels)[120, 160] > 40


def test_the_light_theme_has_a_light_background():
    pixels = picture(theme="light")

    assert pixels[[0, 0, -1, -1], [0, -1, 0, -1]].min() > 180


def test_the_arrow_of_a_force_is_red_and_no_force_has_none():
    values = np.zeros(len(ball()[0]))

    touched = picture(values=values, tool=TOOL, force=[0.0, -0.2, 1.0], **FROM_FRONT)
    hovering = picture(values=values, tool=TOOL, force=[0.0, 0.0, 0.0], **FROM_FRONT)

    assert (redness(touched) > 90).sum() > 100
    assert (redness(hovering) > 90).sum() == 0


def test_twice_the_force_makes_an_arrow_twice_as_long():
    camera = Camera(azimuth=-np.pi / 2, elevation=0.0, distance=0.5)
    appearance = {"values": np.zeros(400), "tool": TOOL, "force_scale": 0.05, "camera": camera}

    one = picture(force=[0.0, 0.0, 0.5], **appearance)
    two = picture(force=[0.0, 0.0, 1.0], **appearance)

    lengths = [np.ptp(np.flatnonzero((redness(p) > 90).any(axis=1))) for p in (one, two)]
    assert lengths[1] == pytest.approx(2 * lengths[0], rel=0.15)


def test_the_legend_shows_the_colour_map_from_its_low_to_its_high_end():
    x, _ = ball()

    pixels = picture(values=x[:, 2] + RADIUS, legend="height [m]", size=(640, 360))

    # the colours of the bar are not lit, so they are found as they are, one above the other
    left = pixels[:, :160]
    rows = []
    for colour in build_viridis()[[16, 64, 128, 192, 240]].astype(int):
        found = np.abs(left - colour).max(axis=2) <= 6
        assert found.any()
        rows.append(np.flatnonzero(found.any(axis=1)).mean())
    assert all(upper < lower for lower, upper in zip(rows, rows[1:], strict=False))


def test_high_values_are_yellow_and_low_ones_violet():
    x, _ = ball()
    values = np.sign(x[:, 2])

    pixels = picture(values=values, colour_map="viridis", wireframe=False, **FROM_FRONT)

    # the legend takes the left: the organ stands in the right two thirds
    high, low = pixels[70, 200], pixels[170, 200]
    assert min(high[0], high[1]) > high[2] + 60
    assert min(low[0], low[2]) > low[1] + 10


def test_the_wireframe_darkens_the_surface():
    plain, wired = picture(wireframe=False), picture(wireframe=True)

    middle = np.s_[90:150, 130:190]
    darker = plain[middle].mean(axis=2) - wired[middle].mean(axis=2)
    assert darker.max() > 30
    assert darker.min() > -4


def test_selection_is_orange_and_grows_with_what_is_selected():
    x, _ = ball()

    def orange(selected):
        p = picture(selection=selected.astype(float), wireframe=False, **FROM_FRONT)
        return ((p[..., 0] > 150) & (p[..., 1] > 85) & (p[..., 2] < 70)).sum()

    none, some, more = (orange(x[:, 2] > height) for height in (1.0, 0.03, 0.0))
    assert none == 0
    assert 200 < some < more


@pytest.mark.fine
def test_the_inner_side_of_an_open_surface_is_shaded_and_paler_than_the_outer():
    x, triangles = bowl()
    appearance = {"azimuth": -90.0, "elevation": 50.0, "wireframe": False, **QUICK}

    inside = draw_picture(x, triangles, **appearance)[70, 160].astype(int)
    outside = draw_picture(x, triangles[:, ::-1], **appearance)[70, 160].astype(int)

    # the same place in the same light, once from within and once turned inside out
    assert inside.max() > 90 and outside.max() > 90
    assert redness(inside) / inside.max() < 0.7 * redness(outside) / outside.max()


def test_a_tool_that_is_hidden_shines_through():
    hidden = picture(tool=(np.zeros(3), 0.01), **FROM_FRONT)
    alone = picture(**FROM_FRONT)

    changed = np.abs(hidden - alone).max(axis=2) > 12
    assert 100 < changed.sum() < 0.3 * changed.size


def test_the_same_picture_is_the_same_file(tmp_path):
    x, triangles = ball()
    appearance = {
        "values": x[:, 2],
        "legend": "height [m]",
        "tool": TOOL,
        "force": [0, 0, 1],
        **QUICK,
    }

    for name in ("one.png", "two.png"):
        save_picture(tmp_path / name, x, triangles, title="ball", **appearance)

    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()
    read = np.round(255 * imread(tmp_path / "one.png")[..., :3])
    assert np.array_equal(read, draw_picture(x, triangles, title="ball", **appearance))


def test_a_deformed_organ_is_another_picture():
    x, triangles = ball()

    flat = draw_picture(x * [1.0, 1.0, 0.7], triangles, **QUICK).astype(int)

    assert (np.abs(flat - picture()).max(axis=2) > 20).mean() > 0.03


def test_a_picture_drawn_in_tiles_is_the_same_picture(monkeypatch):
    whole = picture(title="ball", size=(300, 210))
    monkeypatch.setattr(studio, "TILE", 100)
    tiled = picture(title="ball", size=(300, 210))

    # samples at edges may fall to the other side by rounding, nothing else
    assert (np.abs(whole - tiled).max(axis=2) > 2).mean() < 0.005


def test_pictures_need_no_display(tmp_path):
    bare = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    program = (
        "import sys, numpy as np\n"
        "from palpate.render import save_picture\n"
        "x = np.vstack([np.zeros(3), np.eye(3)])\n"
        "faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]\n"
        "save_picture(sys.argv[1], x, faces, size=(64, 64))\n"
    )

    subprocess.run([sys.executable, "-c", program, tmp_path / "a.png"], env=bare, check=True)

    pixels = imread(tmp_path / "a.png")
    assert pixels.shape[:2] == (64, 64)
    assert np.ptp(pixels[..., 0]) > 0.2


@pytest.mark.parametrize(
    ("appearance", "word"),
    [
        ({"values": [1.0]}, "values"),
        ({"values": np.full(400, np.nan)}, "values"),
        ({"selection": np.zeros((400, 1))}, "selection"),
        ({"theme": "pink"}, "theme"),
        ({"size": (0, 100)}, "size"),
        ({"supersample": 9}, "supersample"),
        ({"elevation": 91.0}, "elevation"),
        ({"force": [0.0, 0.0, 1.0]}, "tool"),
        ({"tool": (np.zeros(3), 0.0)}, "radius"),
        ({"tool": (np.zeros(2), 0.1)}, "tool"),
        ({"tool": TOOL, "force": [0.0, 0.0, np.inf]}, "force"),
    ],
)
def test_a_wrong_appearance_is_refused_by_name(appearance, word):
    with pytest.raises(ValueError, match=word):
        draw_picture(*ball(), **appearance)


@pytest.mark.parametrize(
    ("vertices", "triangles", "word"),
    [
        (np.zeros((3, 2)), [[0, 1, 2]], "vertices"),
        (np.full((3, 3), np.nan), [[0, 1, 2]], "finite"),
        (np.zeros((3, 3)), [[0, 1, 2]], "one point"),
        (np.eye(3), [[0, 1, 3]], "0 to 2"),
        (np.eye(3), [[0, 1, -1]], "0 to 2"),
        (np.eye(3), np.empty((0, 3), int), "triangles"),
    ],
)
def test_a_wrong_surface_is_refused(vertices, triangles, word):
    with pytest.raises(ValueError, match=word):
        draw_picture(vertices, triangles)


# ---------------------------------------------------------------- the renderer


def test_pixels_change_when_positions_do(gl):
    renderer = renderer_of(gl)
    part = add_ball(renderer)
    before = shoot(gl, renderer, front_camera())

    part.update(position=(0.6 * ball()[0]).astype(np.float32))
    after = shoot(gl, renderer, front_camera())

    assert redness(before)[10, 160] > 30 > abs(redness(after)[10, 160])
    assert np.array_equal(shoot(gl, renderer, front_camera()), after)
    renderer.release()


@pytest.mark.parametrize("order", [1, -1])
def test_what_is_nearer_hides_what_is_farther_in_any_order(gl, order):
    renderer = renderer_of(gl)
    parts = [((0.1, 0.9, 0.1), (0.0, -0.1, 0.0)), ((0.9, 0.1, 0.1), (0.0, 0.1, 0.0))]
    for colour, shift in parts[::order]:
        add_ball(renderer, colour, shift)

    pixel = shoot(gl, renderer, front_camera())[120, 160]

    assert pixel[1] > 2 * pixel[0]
    renderer.release()


def test_a_new_range_changes_the_colours_without_new_values(gl):
    renderer = renderer_of(gl)
    part = add_ball(renderer, appearance=Appearance(mapped=True))
    part.update(value=np.full(400, 1.0, np.float32))

    renderer.use_legend(build_legend([0.0, 1.0]))
    high = shoot(gl, renderer, front_camera())[120, 160]
    renderer.use_legend(build_legend([1.0], value_range=(1.0, 2.0)))
    low = shoot(gl, renderer, front_camera())[120, 160]

    assert high[1] > high[2] + 60 and low[2] > low[1] + 20
    renderer.release()


def test_what_casts_a_shadow_darkens_what_lies_behind_it(gl):
    renderer = renderer_of(gl)
    renderer.shadow_softness = 0.02
    add_ball(renderer)
    # between the ball and the key lamp, which stands to the left, above and before it
    screen = add_ball(renderer, shift=(-0.085, -0.10, 0.115))

    shaded = shoot(gl, renderer, front_camera())
    screen.appearance = Appearance(colour=screen.appearance.colour, casts_shadow=False)
    lit = shoot(gl, renderer, front_camera())

    darker = (lit - shaded).max(axis=2)
    assert (darker > 30).sum() > 1000
    assert (lit - shaded).min() >= -2
    assert (darker[:, 285:] == 0).all()  # nothing stands there
    renderer.release()


@pytest.mark.fine
def test_the_bottom_of_a_bowl_sees_less_sky_than_its_outside(gl):
    x, triangles = bowl()
    renderer = renderer_of(gl)
    part = renderer.add(len(x), triangles, Appearance())
    part.update(position=x.astype(np.float32))
    sky = Sky(gl, renderer.parts, np.zeros(3), RADIUS)
    bottom, up = np.array([[0.0, 0.0, -RADIUS]]), np.array([[0.0, 0.0, 1.0]])

    inside, outside = sky.measure(0.97 * bottom, up), sky.measure(1.03 * bottom, -up)

    # from the bottom of a half ball the rim stands at 45 degrees: sin² 45° of the light arrives
    assert inside == pytest.approx([0.5], abs=0.08)
    assert outside == pytest.approx([1.0])
    renderer.release()


def test_streams_of_the_wrong_shape_or_type_are_refused_and_written_nowhere(gl):
    renderer = renderer_of(gl)
    part = add_ball(renderer)
    before = shoot(gl, renderer, front_camera())
    good = np.zeros((400, 3), np.float32)

    for streams in (
        {"position": good.astype(float)},
        {"position": good[:399]},
        {"position": np.zeros((3, 400), np.float32).T},
        {"position": good, "value": np.zeros((400, 1), np.float32)},
        {"colour": good},
    ):
        with pytest.raises(ValueError, match="position|value|colour"):
            part.update(**streams)

    assert np.array_equal(shoot(gl, renderer, front_camera()), before)
    renderer.release()


def test_a_removed_part_is_gone(gl):
    renderer = renderer_of(gl)
    part = add_ball(renderer)

    renderer.remove(part)

    assert abs(redness(shoot(gl, renderer, front_camera()))[120, 160]) < 30
    renderer.release()
