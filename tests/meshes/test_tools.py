# SPDX-License-Identifier: BSD-3-Clause
"""The instruments that ship: sound, in real sizes, and described as a contact needs them."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate_editor.authoring import inspect_mesh
from palpate_meshes.tools import build_tools, open_jaws, read_tool, read_tool_names

TOOLS = read_tool_names()
SHAFTS = {"grasper": 5e-3, "laparoscope": 10e-3, "syringe": 15.8e-3}
"""[m] Diameters."""


def distance_to(shape, points):
    """[m] From points to a sphere or capsule, negative inside."""
    a = np.asarray(shape.a)
    b = np.asarray(shape.a if shape.b is None else shape.b)
    way = b - a
    t = np.clip((points - a) @ way / max(way @ way, 1e-30), 0.0, 1.0)
    return np.linalg.norm(points - a - t[:, None] * way, axis=1) - shape.radius


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


@pytest.mark.parametrize("name", TOOLS)
def test_collision_shapes_stay_inside_or_close_to_their_part(name):
    tool = read_tool(name)

    for shape in tool.shapes:
        ends = [np.asarray(shape.a), np.asarray(shape.a if shape.b is None else shape.b)]
        points = tool.parts[shape.part][0]
        for end in ends:
            nearest = np.linalg.norm(points - end, axis=1).min()
            assert nearest < shape.radius + 0.012, shape
        assert distance_to(shape, points).min() < 3e-4, shape


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


def test_what_there_is_not_is_refused():
    with pytest.raises(ValueError, match="expected one of grasper, laparoscope, syringe"):
        read_tool("stapler")
    with pytest.raises(ValueError, match="has no jaws"):
        open_jaws(read_tool("syringe"), 0.5)
    with pytest.raises(ValueError, match="share must be 0 to 1"):
        open_jaws(read_tool("grasper"), 1.5)
