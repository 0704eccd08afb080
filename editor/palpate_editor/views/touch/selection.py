# SPDX-License-Identifier: GPL-3.0-or-later
"""Which vertices a rectangle on the screen means. Knows no widgets."""

from __future__ import annotations

import numpy as np
import palpate
from numpy.typing import NDArray

Array = NDArray[np.float64]

LIFT = 1e-3
"""[-] of the way to the eye that a vertex is lifted off its own surface before it looks there."""


def find_in_rectangle(pixels: Array, low: Array, high: Array) -> NDArray[np.intp]:
    """The rows of `pixels` (n, 2) within two corners."""
    inside = (pixels >= np.minimum(low, high)) & (pixels <= np.maximum(low, high))
    return np.flatnonzero(inside.all(axis=1))


def keep_visible(
    ids: NDArray[np.intp],
    vertices: Array,
    normals: Array,
    tree: palpate.AabbTree,
    eye: Array,
) -> NDArray[np.intp]:
    """Of some vertices [m] those that an eye [m] sees: facing it, and nothing in between."""
    facing = ((eye - vertices[ids]) * normals[ids]).sum(axis=1) > 0.0
    seen = []
    for i in ids[facing]:
        start = vertices[i] + LIFT * (eye - vertices[i])
        if palpate.find_segment_hit(tree, vertices, start, eye) is None:
            seen.append(i)
    return np.array(seen, dtype=np.intp)
