# SPDX-License-Identifier: BSD-3-Clause
"""How a mouse moves the camera. Knows pixels and the camera, not Qt."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from palpate.render import Camera

Array = NDArray[np.float64]

TURN = math.radians(0.4)
"""[rad] for each pixel of a drag."""
ZOOM = 1.12
"""[-] for each notch of the wheel."""
NEAREST, FARTHEST = 0.05, 40.0
"""[-] distance of the eye in radii of what is in sight."""
MARGIN = 0.09
"""[-] of the view's sides that stays free when all is fitted in."""


def turn(camera: Camera, x: float, y: float) -> None:
    """Orbits by a drag of (x, y) pixels: the surface follows the mouse."""
    camera.orbit(-TURN * x, TURN * y)


def zoom_to(camera: Camera, point: ArrayLike, factor: float, radius: float) -> None:
    """Comes nearer by `factor` while `point` [m] keeps its pixel.

    Eye and target shrink towards the point, so the eye stops before it gets there.
    """
    wanted = min(max(camera.distance / factor, NEAREST * radius), FARTHEST * radius)
    share = wanted / camera.distance
    at = np.asarray(point, dtype=float)
    camera.target = at + share * (np.asarray(camera.target, dtype=float) - at)
    camera.distance = wanted


def meet_target_plane(camera: Camera, origin: Array, direction: Array) -> Array:
    """[m] Where a ray crosses the plane through the target that is parallel to the picture."""
    return meet_plane(origin, direction, camera.target, camera.basis()[2])


def meet_plane(origin: Array, direction: Array, point: ArrayLike, normal: Array) -> Array:
    """[m] Where a ray crosses the plane through `point`; the point itself where it never does."""
    slope = float(direction @ normal)
    if abs(slope) < 1e-9:
        return np.asarray(point, dtype=float)
    along = float((np.asarray(point, dtype=float) - origin) @ normal) / slope
    return origin + along * direction


def measure_pixel(camera: Camera, point: ArrayLike, height: float) -> float:
    """[m] that one pixel covers at the depth of a point, in a view `height` pixels high."""
    depth = float((np.asarray(point, dtype=float) - camera.eye()) @ camera.basis()[2])
    return 2.0 * max(depth, 0.0) * math.tan(camera.field_of_view / 2) / height


def fit(
    camera: Camera,
    points: Array,
    size: tuple[int, int],
    margins: tuple[int, int, int, int] = (0, 0, 0, 0),
) -> None:
    """All points into what margins (left, top, right, bottom) [px] leave of a view, and some room
    around them; into the whole view where they leave next to nothing.
    """
    left, top, right, bottom = find_frame(size, margins)
    x, y = MARGIN * (right - left), MARGIN * (bottom - top)
    camera.fit(points, size, (left + x, top + y, right - x, bottom - y))


def find_frame(
    size: tuple[int, int], margins: tuple[int, int, int, int]
) -> tuple[int, int, int, int]:
    """Left, top, right and bottom [px] of what margins leave of a view; of the whole view where
    they leave next to nothing."""
    left, top, right, bottom = margins
    if size[0] - left - right < size[0] / 4 or size[1] - top - bottom < size[1] / 4:
        return 0, 0, size[0], size[1]
    return left, top, size[0] - right, size[1] - bottom
