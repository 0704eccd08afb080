# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the 3D view share: the body in it, and what is seen of it."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPoint
from surfaces import ellipsoid

SIZE = (320, 240)
MESH = ellipsoid((0.03, 0.025, 0.02), 3)
X, FACES = np.array(MESH.vertices), np.array(MESH.triangles)
MIDDLE_OF_VIEW = QPoint(SIZE[0] // 2, SIZE[1] // 2)
CORNER = QPoint(4, 4)


def redness(pixels):
    return pixels[..., 0] - np.maximum(pixels[..., 1], pixels[..., 2])


def count_orange(pixels):
    """What is selected: much red, some green, hardly any blue."""
    r, g, b = np.moveaxis(pixels, -1, 0)
    return int(((r - b > 120) & (g - b > 40) & (r - g > 30)).sum())


def silhouette(pixels):
    """(left, top, right, bottom) of what is red."""
    rows, columns = np.nonzero(redness(pixels) > 40)
    return columns.min(), rows.min(), columns.max(), rows.max()
