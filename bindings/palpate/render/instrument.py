# SPDX-License-Identifier: BSD-3-Clause
"""What is seen of an instrument of capsules: the part that touches, and its shaft to the hand."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.render.shapes import Shape, build_capsule

SHAFT = 0.25
"""[m] of the shaft that is drawn: instruments for the abdomen are a little longer."""
SHAFT_PART = 0.8
"""[-] Of the radius: what is drawn only is thinner than what touches."""


def build_instrument(tool: palpate.Tool) -> Shape | None:
    """In the tool's frame [m]; None for a ball, which has no shaft.

    The shaft goes along z from the end of the last capsule; it is drawn and touches nothing.
    """
    if not tool.capsules:
        return None
    parts = [build_capsule(part.from_, part.to, tool.radius) for part in tool.capsules]
    end = np.array(tool.capsules[-1].to)
    if end[2] < SHAFT:
        parts.append(build_capsule(end, [end[0], end[1], SHAFT], SHAFT_PART * tool.radius))
    return join_shapes(parts)


def join_shapes(shapes: list[Shape]) -> Shape:
    """One after the other."""
    counts = np.cumsum([0] + [len(shape.vertices) for shape in shapes[:-1]])
    return Shape(
        np.concatenate([shape.vertices for shape in shapes]),
        np.concatenate([shape.normals for shape in shapes]),
        np.concatenate(
            [shape.triangles + np.uint32(k) for shape, k in zip(shapes, counts, strict=True)]
        ),
    )


def place_instrument(shape: Shape, position: ArrayLike, orientation: ArrayLike) -> Shape:
    """Where the tool is [m], turned by a unit quaternion (x, y, z, w)."""
    turn = find_rotation(orientation)
    vertices = shape.vertices @ turn.T + np.asarray(position, dtype=np.float32)
    return Shape(vertices, shape.normals @ turn.T, shape.triangles)


def find_rotation(orientation: ArrayLike) -> NDArray[np.float32]:
    """The matrix (3, 3) of a unit quaternion (x, y, z, w)."""
    x, y, z, w = np.asarray(orientation, dtype=float)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ],
        dtype=np.float32,
    )
