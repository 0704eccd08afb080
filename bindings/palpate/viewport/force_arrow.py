# SPDX-License-Identifier: BSD-3-Clause
"""The arrow of a force, kept in sight however large the force is, and however near the camera."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from palpate.render import Camera
from palpate.viewport.navigation import measure_pixel

Array = NDArray[np.float64]
Frame = tuple[float, float, float, float]
"""left, top, right, bottom [px]"""

NEAREST = 0.5
"""[-] of the tail's distance from the eye that an arrow towards the eye keeps from it."""
CLOSEST = 0.3
"""[-] of the target's distance from the eye that the tail keeps from it."""
SHORTEST = 48.0
"""[px] An arrow of which the frame leaves less is moved inwards."""
THINNEST, THICKEST = 2.0, 6.0
"""[px] radius of the shaft."""


def keep_in_sight(
    camera: Camera, size: tuple[int, int], frame: Frame, start: Array, vector: Array
) -> tuple[Array, Array]:
    """Tail and point [m] of an arrow from `start` along `vector` [m], inside a frame of the view.

    It keeps its direction. It is shortened where it would leave the frame or come into the eye, and
    moved where its tail is out of sight or too little of it would be left.
    """
    tail = bring_in_sight(camera, size, frame, start)
    length = float(np.linalg.norm(vector))
    eye, forward = camera.eye(), camera.basis()[2]
    planes = [(normal, 0.0) for normal in build_planes(camera, size, frame)]
    planes.append((forward, NEAREST * float((tail - eye) @ forward)))
    share = 1.0
    for normal, least in planes:  # where the point would leave the frame through one of its sides
        falls = -float(vector @ normal)
        if falls > 0.0:
            share = min(share, max(0.0, (float((tail - eye) @ normal) - least) / falls))
    point = tail + share * vector
    shortest = min(SHORTEST * measure_pixel(camera, tail, size[1]), length)
    if share * length < shortest:
        back = point - vector * (shortest / length)
        tail = bring_in_sight(camera, size, frame, back)
        point = point + tail - back
    return tail, point


def choose_radius(camera: Camera, height: float, tail: Array, usual: float) -> float:
    """[m] of the shaft: as usual, but neither a thread nor a beam on the screen."""
    pixel = measure_pixel(camera, tail, height)
    return min(max(usual, THINNEST * pixel), THICKEST * pixel)


def bring_in_sight(camera: Camera, size: tuple[int, int], frame: Frame, point: Array) -> Array:
    """[m] The point itself, or the one beside it that is seen at the side of the frame."""
    right, up, forward = camera.basis()
    from_eye = point - camera.eye()
    depth = max(float(from_eye @ forward), CLOSEST * camera.distance)
    scale = depth / find_focal(camera, size)
    left, top, end, bottom = frame
    x = min(max(float(from_eye @ right), (left - size[0] / 2) * scale), (end - size[0] / 2) * scale)
    y = min(max(float(from_eye @ up), (size[1] / 2 - bottom) * scale), (size[1] / 2 - top) * scale)
    return camera.eye() + x * right + y * up + depth * forward


def build_planes(camera: Camera, size: tuple[int, int], frame: Frame) -> list[Array]:
    """Inward normals of the planes through the eye and the four sides of a frame."""
    right, up, forward = camera.basis()
    focal = find_focal(camera, size)
    left, top, end, bottom = frame
    return [
        focal * right - (left - size[0] / 2) * forward,
        -focal * right + (end - size[0] / 2) * forward,
        focal * up - (size[1] / 2 - bottom) * forward,
        -focal * up + (size[1] / 2 - top) * forward,
    ]


def find_focal(camera: Camera, size: tuple[int, int]) -> float:
    """[px] distance of the picture from the eye."""
    return size[1] / 2 / math.tan(camera.field_of_view / 2)
