# SPDX-License-Identifier: BSD-3-Clause
"""The shapes that pictures show beside an organ, and the machine's OpenGL."""

import numpy as np
import pytest
from palpate.render import (
    RenderError,
    build_arrow,
    build_capsule,
    build_sphere,
    describe_gl,
    open_context,
)


@pytest.mark.parametrize(
    ("shape", "volume"),
    [
        (build_sphere([0.1, 0.2, 0.3], 0.03), 4 / 3 * np.pi * 0.03**3),
        (
            build_capsule([0.0, 0.0, 0.0], [0.0, 0.1, 0.05], 0.02),
            4 / 3 * np.pi * 0.02**3 + np.pi * 0.02**2 * np.hypot(0.1, 0.05),
        ),
    ],
    ids=["sphere", "capsule"],
)
def test_a_shape_has_its_volume_and_looks_outward(shape, volume):
    corners = shape.vertices.astype(float)[shape.triangles]

    found = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6

    assert found == pytest.approx(volume, rel=0.01)
    face = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    agree = np.einsum("ij,ij->i", face, shape.normals[shape.triangles].sum(axis=1))
    assert (agree >= 0.0).all()
    assert np.allclose(np.linalg.norm(shape.normals, axis=1), 1.0, atol=1e-6)


@pytest.mark.parametrize("length", [0.002, 0.05, 0.3])
def test_an_arrow_begins_and_ends_where_it_says(length):
    direction = np.array([1.0, -2.0, 2.0]) / 3.0
    start = np.array([0.1, 0.0, -0.1])

    shape = build_arrow(start, start + length * direction, 0.003)
    along = (shape.vertices - start) @ direction

    assert along.min() == pytest.approx(0.0, abs=1e-7)
    assert along.max() == pytest.approx(length, abs=1e-7)


def test_the_machine_tells_its_opengl():
    assert "OpenGL" in describe_gl()


def test_a_machine_without_opengl_is_told_what_to_install():
    with (
        pytest.raises(RenderError, match="libgl1.*libegl1"),
        open_context(libgl="libNoSuchGL.so.1", libegl="libNoSuchEGL.so.1"),
    ):
        pass
