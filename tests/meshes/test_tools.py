# SPDX-License-Identifier: BSD-3-Clause
"""The instruments that ship: sound, in real sizes, and described as a contact needs them."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.render import DrawnInstrument, DrawnPart, place_instrument
from palpate.render.instrument import METAL
from palpate.render.instrument_meshes import DRAWN, MESHES, read_part
from palpate.scene.instrument_kinds import DESCRIPTIONS as SHIPPED
from palpate.scene.instrument_kinds import KINDS, InstrumentKind
from palpate.scene.scene_file import build_tool
from palpate.scene.scene_parts import ToolPart
from palpate_editor.authoring import inspect_mesh
from palpate_meshes.catalogue import hash_bytes, read_tool_catalogue
from palpate_meshes.tools import (
    DESCRIPTIONS,
    FOLDER,
    build_tools,
    open_jaws,
    read_tool,
    read_tool_names,
)

TOOLS = read_tool_names()
SHAFTS = {"grasper": 5e-3, "laparoscope": 10e-3, "syringe": 15.8e-3}
"""[m] Diameters."""
STANDS_OUT = 6e-4
"""[m] As deep as the teeth of the jaws: a capsule has none."""


@pytest.mark.parametrize("name", TOOLS)
def test_every_part_is_closed_outward_and_in_one_piece(name):
    for part, (vertices, triangles) in read_tool(name).parts.items():
        report = inspect_mesh(palpate.SurfaceMesh(vertices, triangles))

        assert report.closed and report.shells == 1 and report.outward, part
        assert report.self_intersecting_faces == 0, part


@pytest.mark.parametrize("name", TOOLS)
def test_a_tool_points_along_z_from_its_origin(name):
    points = np.concatenate([vertices for vertices, _ in read_tool(name).parts.values()])

    assert points[:, 2].max() == pytest.approx(0.0, abs=2e-4)
    assert points[:, 2].min() < -0.12
    middle = points[points[:, 2] < -0.1]
    assert np.abs(middle.mean(axis=0)[:2]).max() < 1e-3


@pytest.mark.parametrize("name", TOOLS)
def test_the_shaft_is_as_thick_as_the_instrument_s(name):
    tool = read_tool(name)
    points = np.concatenate([vertices for vertices, _ in tool.parts.values()])
    ahead = points[(points[:, 2] > -0.306) & (points[:, 2] < -0.006)]
    ahead = ahead[np.linalg.norm(ahead[:, :2], axis=1) < 0.6 * SHAFTS[name]]

    assert 2 * np.linalg.norm(ahead[:, :2], axis=1).max() == pytest.approx(SHAFTS[name], rel=0.02)


def compute_winding(points, vertices, triangles):
    """[-] How often a surface goes round each point: 1 inside, 0 outside."""
    corner = vertices[triangles][None] - points[:, None, None]
    a, b, c = (corner[:, :, i] for i in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    volume = (a * np.cross(b, c)).sum(axis=2)
    dots = (a * b).sum(axis=2) * lc + (b * c).sum(axis=2) * la + (c * a).sum(axis=2) * lb
    return np.arctan2(volume, la * lb * lc + dots).sum(axis=1) / (2.0 * np.pi)


def sample_shape(shape, count=150):
    """[m] Points all over a sphere or capsule."""
    random = np.random.default_rng(0)
    out = random.normal(size=(count, 3))
    out /= np.linalg.norm(out, axis=1)[:, None]
    a = np.asarray(shape.a)
    axis_vector = np.asarray(shape.a if shape.b is None else shape.b) - a
    along = np.where(out @ axis_vector > 0.0, 1.0, 0.0)
    # the flank too, not only the two ends
    half = count // 2
    if shape.b is not None:
        axis = axis_vector / np.linalg.norm(axis_vector)
        out[:half] -= (out[:half] @ axis)[:, None] * axis
        out[:half] /= np.linalg.norm(out[:half], axis=1)[:, None]
        along[:half] = random.random(half)
    return a + along[:, None] * axis_vector + shape.radius * out


@pytest.mark.parametrize("name", TOOLS)
def test_collision_shapes_fill_their_part_and_do_not_stand_out_of_it(name):
    tool = read_tool(name)

    for shape in tool.shapes:
        vertices, triangles = tool.parts[shape.part]
        points = sample_shape(shape)
        tree = palpate.AabbTree(vertices, triangles)
        away = np.array([palpate.find_closest_point(tree, vertices, p).distance for p in points])
        outside = compute_winding(points, vertices, triangles) < 0.5
        assert away[outside].max(initial=0.0) < STANDS_OUT, shape
        # as thick as it is: somewhere it comes close to the wall
        assert away.min() < 1e-4, shape


def test_pads_lie_on_the_teeth_and_face_each_other():
    tool = read_tool("grasper")
    upper, lower = tool.pads

    assert np.array_equal(np.asarray(upper.normal), -np.asarray(lower.normal))
    for pad, other in ((upper, lower), (lower, upper)):
        to_other = np.asarray(other.centre) - np.asarray(pad.centre)
        assert to_other @ pad.normal > 0.0
        across = np.cross(tool.jaws.axis, pad.normal)
        offset = tool.parts[pad.part][0] - np.asarray(pad.centre)
        over = (np.abs(offset @ across) < pad.length / 2) & (
            np.abs(offset @ np.asarray(tool.jaws.axis)) < pad.width / 2
        )
        # the highest teeth touch the pad's plane and nothing of the jaw stands before it
        assert (offset[over] @ pad.normal).max() == pytest.approx(0.0, abs=1e-6)


def test_the_laparoscope_looks_out_of_its_slanted_front():
    camera = read_tool("laparoscope").camera
    vertices = read_tool("laparoscope").parts["shaft"][0]
    axis, up = np.asarray(camera.axis), np.asarray(camera.up)

    assert np.linalg.norm(axis) == pytest.approx(1.0) and axis @ up == pytest.approx(0.0)
    assert np.degrees(np.arccos(axis[2])) == pytest.approx(30.0)
    # the lens lies in the front, and nothing of the tool is before it
    assert ((vertices - np.asarray(camera.at)) @ axis).max() == pytest.approx(0.0, abs=2e-5)


def test_the_jaws_open_about_their_hinge_and_away_from_each_other():
    tool = read_tool("grasper")
    closed, half, wide = (open_jaws(tool, share) for share in (0.0, 0.5, 1.0))

    def gap(parts):
        """[m] Between the tips of the jaws."""
        upper, lower = parts["upper_jaw"][0], parts["lower_jaw"][0]
        tips = [points[tool.parts[name][0][:, 2] > -0.003].mean(axis=0)
                for name, points in (("upper_jaw", upper), ("lower_jaw", lower))]  # fmt: skip
        return tips[0][1] - tips[1][1]

    assert gap(closed) < gap(half) < gap(wide)
    # each turns by the angle, 22 mm from the hinge
    expected = gap(closed) + 2 * 0.021 * np.sin(tool.jaws.open)
    assert gap(wide) == pytest.approx(expected, abs=1.5e-3)
    assert np.array_equal(wide["shaft"][0], closed["shaft"][0])
    assert closed["upper_jaw"][0][:, 1].min() > 0.0 > closed["lower_jaw"][0][:, 1].max()


def test_the_needle_is_the_front_of_the_syringe():
    tool = read_tool("syringe")
    points = tool.parts["barrel"][0]
    front = points[points[:, 2] > -tool.needle.length + 1e-4]

    assert tool.needle.axis == (0.0, 0.0, 1.0)
    assert np.linalg.norm(front[:, :2], axis=1).max() == pytest.approx(tool.needle.radius, abs=1e-7)


def test_tools_built_again_are_the_published_ones():
    for name, parts in build_tools().items():
        published = read_tool(name).parts
        assert set(parts) == set(published)
        for part, (vertices, triangles) in parts.items():
            assert np.abs(vertices - published[part][0]).max() <= 1e-8
            assert np.array_equal(triangles, published[part][1])


def test_the_catalogue_has_the_counts_and_the_hash_of_every_part():
    catalogue = read_tool_catalogue()

    assert list(catalogue) == TOOLS
    for name, rows in catalogue.items():
        assert list(rows) == list(read_tool(name).parts)
        for part, row in rows.items():
            vertices, triangles = read_tool(name).parts[part]
            assert (row.vertices, row.triangles) == (len(vertices), len(triangles))
            assert row.sha256 == hash_bytes((FOLDER / f"{name}_{part}.obj").read_bytes())


def test_what_there_is_not_is_refused():
    with pytest.raises(ValueError, match="expected one of grasper, laparoscope, syringe"):
        read_tool("stapler")
    with pytest.raises(ValueError, match="has no jaws"):
        open_jaws(read_tool("syringe"), 0.5)
    with pytest.raises(ValueError, match="share must be 0 to 1"):
        open_jaws(read_tool("grasper"), 1.5)


def test_the_library_ships_the_description_of_the_instruments():
    assert SHIPPED.read_bytes() == DESCRIPTIONS.read_bytes()


def test_what_touches_follows_from_what_ships():
    assert {
        "ball": InstrumentKind(3e-3, 0.0, 0.0),
        "probe": InstrumentKind(2.5e-3, 0.02, 0.1),
        "laparoscope": InstrumentKind(5e-3, 0.02, 0.1),
        "grasper": InstrumentKind(1.2e-3, 0.02, 0.5, 0.52),
        "syringe": InstrumentKind(4e-4, 0.04, 0.1),
    } == KINDS
    grasper, jaw = KINDS["grasper"], read_tool("grasper").parts["upper_jaw"][0]
    # closed jaws touch each other in the middle, and are as high as they are drawn
    assert 2 * grasper.radius == pytest.approx(jaw[:, 1].max(), abs=1e-5)
    jaws = build_tool(ToolPart(**vars(grasper))).jaws
    assert jaws.hinge[2] == pytest.approx(-read_tool("grasper").jaws.hinge[2], abs=1.1e-4)
    needle = read_tool("syringe").needle
    assert (KINDS["syringe"].radius, KINDS["syringe"].length) == (needle.radius, needle.length)
    assert KINDS["laparoscope"].radius == read_tool("laparoscope").shapes[0].radius


def test_every_instrument_that_ships_is_drawn_as_itself():
    assert list(MESHES) == TOOLS
    assert {path.stem for path in DRAWN.glob("*.obj")} == {
        path.stem for path in FOLDER.glob("*.obj")
    }


@pytest.mark.parametrize("name", list(MESHES))
def test_what_is_drawn_of_an_instrument_is_what_ships(name):
    mesh, tool = MESHES[name], read_tool(name)
    assert {part.name for part in mesh.parts} == {f"{name}_{part}" for part in tool.parts}
    for part in mesh.parts:
        ships = (FOLDER / f"{part.name}.obj").read_bytes()
        assert (DRAWN / f"{part.name}.obj").read_bytes() == ships
        short = part.name.removeprefix(f"{name}_")
        assert part.colour == tool.colours[short]
        assert part.turns == (0.0 if tool.jaws is None else tool.jaws.turns.get(short, 0.0))
    points = tool.parts["barrel" if tool.needle else "shaft"][0]
    front = points[points[:, 2] > (-0.0401 if tool.needle else -0.3)]
    assert mesh.radius == pytest.approx(np.abs(front[:, 0]).max(), rel=0.01)
    assert mesh.tip == -tool.shapes[0].a[2]
    assert mesh.hinge == (0.0 if tool.jaws is None else -tool.jaws.hinge[2])
    assert mesh.needle == (0.0 if tool.needle is None else tool.needle.length)


def test_drawn_jaws_open_as_those_that_ship():
    tool, mesh = read_tool("grasper"), MESHES["grasper"]
    parts = tuple(
        DrawnPart(read_part(part.name), METAL, part.turns) for part in mesh.parts if part.turns
    )
    drawn = DrawnInstrument(parts, mesh.hinge)
    opened = open_jaws(tool, 0.5)
    placed = place_instrument(drawn, (0, 0, 0), (0, 0, 0, 1), 0.5 * tool.jaws.open)
    for part, now in zip([p for p in mesh.parts if p.turns], placed, strict=True):
        wanted = opened[part.name.removeprefix("grasper_")][0] * (1.0, -1.0, -1.0)
        low, high = now.shape.vertices.min(axis=0), now.shape.vertices.max(axis=0)
        assert low == pytest.approx(wanted.min(axis=0), abs=1e-7)
        assert high == pytest.approx(wanted.max(axis=0), abs=1e-7)
        assert np.linalg.norm(now.shape.normals, axis=1) == pytest.approx(1.0, abs=1e-5)
