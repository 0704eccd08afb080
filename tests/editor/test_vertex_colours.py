# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours and pictures of a file come along as colours of vertices, through every edit and
file, and are drawn."""

from __future__ import annotations

import struct
import zlib
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from organs import make_organ, surface_of
from painted_files import (
    JPEG,
    build_ball,
    draw_halves,
    write_painted_glb,
    write_painted_obj,
    write_png,
)
from palpate.cli.main import main
from palpate.render import draw_picture
from palpate.render.authored_appearance import find_colours
from palpate.scenario import Container, read_container, write_container
from palpate_editor import edits
from palpate_editor.authoring import read_mesh
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_editor.document.files import FORMAT, VERSION, read_organ, write_organ
from palpate_editor.edits import decimate_organ, import_file
from palpate_editor.publish import write_scenario
from palpate_editor.vertex_colours import LINEAR, carry_colours, sample, spread_areas
from tiers import keep_everyday

RED, BLUE = (200, 30, 20), (20, 60, 200)
PICTURE = write_png(draw_halves(RED, BLUE))


def import_ball(tmp_path: Path, kind: str = "glb") -> Organ:
    path = tmp_path / f"ball.{kind}"
    if kind == "glb":
        return import_file(write_painted_glb(path, PICTURE))(EMPTY)
    return import_file(write_painted_obj(path, PICTURE), unit="mm")(EMPTY)


def paint_halves(surface: Surface) -> Surface:
    """Above the middle red, below it blue."""
    high = surface.vertices[:, 2] > surface.vertices[:, 2].mean()
    return replace(surface, colours=np.where(high[:, None], RED, BLUE).astype(np.uint8))


def paint_organ(vertices: int = 150) -> Organ:
    surface = paint_halves(surface_of(vertices))
    return replace(make_organ(vertices, None), surface=surface, imported=surface, history=None)


# ---------------------------------------------------------------- from a file


@pytest.mark.parametrize("kind", ["glb", "obj"])
def test_a_picture_is_where_the_file_has_it(kind, tmp_path):
    surface = import_ball(tmp_path, kind).surface
    height = surface.vertices[:, 2]

    # the picture's lower half is red; one row of vertices lies on the border of the halves
    assert (surface.colours[height < -2e-3] == RED).all()
    assert (surface.colours[height > 2e-3] == BLUE).all()
    between = np.sort([RED, BLUE], axis=0)
    middle = surface.colours[abs(height) < 1e-3]
    assert len(middle) == 24
    assert ((middle >= between[0]) & (middle <= between[1])).all()


def test_options_of_a_material_are_no_name_of_its_picture(tmp_path):
    path = write_painted_obj(tmp_path / "a.obj", PICTURE, "-s 1 1 1 -blendu on -bm 0.5 ")

    assert [picture.name for picture in read_mesh(path).pictures] == ["skin of it.png"]


def test_the_factor_of_gltf_multiplies_its_picture_in_linear_light(tmp_path):
    white = write_png(draw_halves((128, 128, 128), (255, 255, 255)))
    path = write_painted_glb(tmp_path / "a.glb", white, factor=(0.5, 0.5, 0.5))

    surface = import_file(path)(EMPTY).surface

    # half of white is 188 of 255 in sRGB, half of 128 is 0.1079 of light, which is 92
    assert (surface.colours[surface.vertices[:, 2] > 2e-3] == 188).all()
    assert (surface.colours[surface.vertices[:, 2] < -2e-3] == 92).all()


def test_a_triangle_has_the_mean_of_its_picture_in_linear_light():
    checkers = (255 * (np.indices((64, 64)).sum(axis=0) % 2)).astype(np.uint8)
    picture = np.repeat(checkers[:, :, None], 3, axis=2)
    places = np.array([[[0.1, 0.1], [0.9, 0.2], [0.3, 0.8]]])

    light = sample(picture, places)

    assert light.mean() == pytest.approx(0.5, abs=0.1)


def test_colours_of_corners_come_along_without_a_picture(tmp_path):
    x, triangles, _ = build_ball()
    colours = np.where(x[:, 2:] > 1.0, RED, BLUE)
    rows = [f"v {a:.9g} {b:.9g} {c:.9g} {r / 255:.6f} {g / 255:.6f} {d / 255:.6f}"
            for (a, b, c), (r, g, d) in zip(x, colours, strict=True)]  # fmt: skip
    rows += [f"f {a} {b} {c}" for a, b, c in triangles + 1]
    (tmp_path / "a.obj").write_text("\n".join(rows) + "\n", encoding="utf-8")

    surface = import_file(tmp_path / "a.obj", unit="mm")(EMPTY).surface

    assert (surface.colours == np.where(surface.vertices[:, 2:] > 1e-3, RED, BLUE)).all()


@pytest.mark.parametrize("full", [1, 255])
@pytest.mark.parametrize("kind", ["COFF", "CNOFF"])
def test_colours_of_an_off_come_along(kind, full, tmp_path):
    x, triangles, _ = build_ball()
    colours = np.where(x[:, 2:] > 1.0, RED, BLUE) * (full / 255)
    normal = "0 0 1 " if "N" in kind else ""
    rows = [kind, f"{len(x)} {len(triangles)} 0"]
    rows += [f"{p[0]:.9g} {p[1]:.9g} {p[2]:.9g} {normal}{c[0]:g} {c[1]:g} {c[2]:g} {full}"
             for p, c in zip(x, colours, strict=True)]  # fmt: skip
    rows += [f"3 {a} {b} {c}" for a, b, c in triangles]
    (tmp_path / "a.off").write_text("\n".join(rows) + "\n", encoding="utf-8")

    surface = import_file(tmp_path / "a.off", unit="mm")(EMPTY).surface

    assert (surface.colours == np.where(surface.vertices[:, 2:] > 1e-3, RED, BLUE)).all()


def write_bomb() -> bytes:
    """A picture of 400 million pixels in some kB."""
    head = struct.pack(">2I5B", 20_000, 20_000, 8, 2, 0, 0, 0)
    body = zlib.compress(b"\0" * 1_000_000)
    return b"".join([
        b"\x89PNG\r\n\x1a\n",
        *(struct.pack(">I", len(b)) + n + b + struct.pack(">I", zlib.crc32(n + b))
          for n, b in ((b"IHDR", head), (b"IDAT", body), (b"IEND", b""))),
    ])  # fmt: skip


@pytest.mark.parametrize(
    ("picture", "said"),
    [
        (None, "the picture skin of it.png is not beside it or below its folder"),
        (b"no picture at all", "stays behind: cannot identify image file"),
        (PICTURE[:-40], "stays behind"),
        (JPEG, "stays behind"),
        (write_bomb(), "stays behind: 20000 x 20000 pixels, at most 64 million"),
    ],
    ids=["missing", "text", "cut", "cut jpeg", "bomb"],
)
def test_a_picture_that_is_none_is_said_and_the_organ_comes_in(picture, said, tmp_path):
    path = write_painted_obj(tmp_path / "a.obj", picture)

    organ = import_file(path, unit="mm")(EMPTY)

    assert organ.surface.colours is None
    assert any(said in note for note in organ.source.notes), organ.source.notes


def test_a_picture_outside_of_the_folder_is_not_opened(tmp_path):
    (tmp_path / "secret.png").write_bytes(PICTURE)
    (tmp_path / "meshes").mkdir()
    path = write_painted_obj(tmp_path / "meshes" / "a.obj", None)
    (path.parent / "skin.mtl").write_text("newmtl skin\nmap_Kd ../secret.png\n", encoding="utf-8")

    scene = read_mesh(path)

    assert scene.pictures == []
    assert any("../secret.png is not beside it" in note for note in scene.notes)


# ---------------------------------------------------------------- from surface to surface


def test_the_same_vertices_have_the_same_colours():
    source = paint_halves(surface_of(150))
    copy = Surface(source.vertices + 0.0, source.triangles)

    assert np.array_equal(carry_colours(copy, source).colours, source.colours)


def test_a_coarser_surface_keeps_the_light_of_the_finer_one():
    organ = paint_organ(600)
    made = decimate_organ(organ, 100)(organ)

    def measure_light(surface: Surface) -> np.ndarray:
        weight = spread_areas(surface)
        return (LINEAR[surface.colours] * weight[:, None]).sum(axis=0) / weight.sum()

    assert len(made.surface.colours) == 100
    assert measure_light(made.surface) == pytest.approx(measure_light(organ.surface), rel=0.05)


def test_the_two_sides_of_a_thin_wall_stay_apart():
    grid = np.stack(np.meshgrid(np.arange(20.0), np.arange(20.0)), -1).reshape(-1, 2) * 1e-3
    ids = np.arange(400).reshape(20, 20)
    a, b, c, d = ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]
    up = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)

    def wall(points: np.ndarray, faces: np.ndarray) -> Surface:
        high = np.column_stack([points, np.full(len(points), 2e-4)])
        low = np.column_stack([points, np.zeros(len(points))])
        return Surface(np.vstack([high, low]), np.vstack([faces, faces[:, ::-1] + len(points)]))

    source = wall(grid, up)
    source = replace(source, colours=np.repeat([RED, BLUE], 400, axis=0).astype(np.uint8))
    ids = np.arange(16).reshape(4, 4)
    a, b, c, d = ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]
    faces = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    line = np.linspace(0.0, 19e-3, 4)
    coarse = wall(np.stack(np.meshgrid(line, line), -1).reshape(-1, 2), faces)

    colours = carry_colours(coarse, source).colours

    assert (colours[:16] == RED).all() and (colours[16:] == BLUE).all()


EDITS = {
    "SetUnit": lambda organ: edits.SetUnit("cm"),
    "SetUp": lambda organ: edits.SetUp("y"),
    "Smooth": lambda organ: edits.Smooth(2),
    "Decimate": lambda organ: decimate_organ(organ, 60),
    "DecimateTo": lambda organ: edits.DecimateTo(60),
    "Wrap": lambda organ: edits.Wrap(4e-3),
    "Remesh": lambda organ: edits.Remesh(8e-3),
}


@pytest.mark.parametrize("name", keep_everyday(EDITS, ("SetUnit", "SetUp", "Smooth", "Decimate")))
def test_an_edit_of_the_surface_keeps_the_colours(name, tmp_path):
    organ = import_ball(tmp_path)

    made = EDITS[name](organ)(organ)

    for surface in (made.surface, made.imported):
        top, bottom = (surface.colours[surface.vertices[:, 2].argmax()],
                       surface.colours[surface.vertices[:, 2].argmin()])  # fmt: skip
        if name != "SetUp":  # which turns it
            assert np.abs(top.astype(int) - BLUE).max() < 60
            assert np.abs(bottom.astype(int) - RED).max() < 60
    assert (made.imported is made.surface) == (made.decimation is None)


def test_another_appearance_takes_their_place_unless_they_are_kept():
    organ = paint_organ()

    plain = edits.SetAppearance("liver", (0.2, 0.3, 0.4))(organ)
    kept = edits.SetAppearance("liver", None, of_vertices=True)(organ)

    assert plain.surface.colours is None and plain.imported is plain.surface
    assert plain.surface.vertices is organ.surface.vertices
    assert kept.surface is organ.surface


# ---------------------------------------------------------------- in files


def test_a_file_keeps_them_to_the_bit(tmp_path):
    organ = import_ball(tmp_path)
    organ = decimate_organ(organ, 100)(organ)
    write_organ(tmp_path / "a.organ", organ)

    again = read_organ(tmp_path / "a.organ")

    assert np.array_equal(again.surface.colours, organ.surface.colours)
    assert np.array_equal(again.imported.colours, organ.imported.colours)
    write_organ(tmp_path / "b.organ", again)
    assert (tmp_path / "a.organ").read_bytes() == (tmp_path / "b.organ").read_bytes()


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        (lambda colours: colours[:-1], "one for each vertex"),
        (lambda colours: colours.astype(np.int32), "<i4 of shape"),
        (lambda colours: colours[:, :2].copy(), "of shape"),
    ],
)
def test_a_damaged_twin_is_refused(wrong, said, tmp_path):
    path = tmp_path / "a.organ"
    write_organ(path, paint_organ())
    found = read_container(str(path), FORMAT, VERSION)
    arrays = dict(found.arrays)
    arrays["imported/colours"] = wrong(arrays["imported/colours"])
    write_container(
        str(path), Container(format=FORMAT, version=VERSION, content=found.content, arrays=arrays)
    )

    with pytest.raises(palpate.FileError, match="imported/colours") as refusal:
        read_organ(path)

    assert said in str(refusal.value)


def test_an_organ_is_rebuilt_in_the_same_colours(tmp_path):
    organ = import_ball(tmp_path)
    for edit in (edits.DecimateTo(120), edits.Smooth(2), edits.SetAppearance("liver", None, True)):
        organ = edit(organ)
    write_organ(tmp_path / "a.organ", organ)

    assert main(["rebuild", str(tmp_path / "a.organ"), "-o", str(tmp_path / "b.organ")]) == 0

    assert (tmp_path / "a.organ").read_bytes() == (tmp_path / "b.organ").read_bytes()


def test_a_published_file_has_them_for_the_vertices_of_its_scene(tmp_path):
    from palpate_editor.compile import compile_organ

    organ = import_ball(tmp_path)
    organ = decimate_organ(organ, 100)(organ)
    scene = compile_organ(organ)
    write_scenario(organ, scene, tmp_path / "a.palpate")

    colours = find_colours(palpate.scenario.read(tmp_path / "a.palpate"))

    assert np.array_equal(colours[:100], organ.surface.colours)
    assert len(colours) == sum(len(body.tissue.rest_position) for body in scene.bodies)


# ---------------------------------------------------------------- drawn


def test_they_are_drawn_in_place_of_colour_and_pattern(tmp_path):
    surface = import_ball(tmp_path).surface

    picture = draw_picture(
        surface.vertices,
        surface.triangles,
        vertex_colours=surface.colours,
        wireframe=False,
        elevation=0.0,
        size=(200, 200),
    ).astype(int)

    upper, lower = picture[60, 100], picture[140, 100]
    assert upper[2] > 1.5 * upper[0] and lower[0] > 1.5 * lower[2]
    with pytest.raises(ValueError, match="vertex_colours must have shape"):
        draw_picture(surface.vertices, surface.triangles, vertex_colours=surface.colours[:-1])
