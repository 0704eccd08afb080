# SPDX-License-Identifier: BSD-3-Clause
"""What a laparoscope sees: a camera at its tip, whose lamp is beside its lens."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

import palpate
from palpate.render.camera import Array, Camera
from palpate.render.instrument import find_rotation, name_look
from palpate.render.instrument_meshes import MESHES

HEADLIGHT = 0.06
"""[m] At which the lamp lights as brightly as those of the studio do."""


@dataclass
class ScopeCamera(Camera):
    """Stands where a laparoscope has its lens, and turns with its shaft."""

    axes: Array = field(default_factory=lambda: np.array([[1, 0, 0], [0, 0, 1], [0, 1, 0.0]]))
    """(3, 3) Unit vectors to the right, up and forward."""

    def basis(self) -> tuple[Array, Array, Array]:
        right, up, forward = self.axes
        return right, up, forward

    def describe(self) -> tuple[float, ...]:
        return (*super().describe(), *map(float, self.axes.ravel()))


def has_camera(tool: palpate.Tool) -> bool:
    """Whether an instrument is one to see with: what is drawn with optics, as a laparoscope is."""
    mesh = MESHES.get(name_look(tool))
    return mesh is not None and mesh.optics is not None


def place_scope(tool: palpate.Tool, position: ArrayLike, orientation: ArrayLike) -> ScopeCamera:
    """What a laparoscope sees that is held at a position [m] and a unit quaternion (x, y, z, w).

    The optics are those of the shipped mesh (meshes/tools.toml). Raises ValueError for a tool
    without a camera.
    """
    mesh = MESHES.get(name_look(tool))
    if mesh is None or mesh.optics is None:
        raise ValueError(f"tool: got a {name_look(tool)}, expected a laparoscope")
    optics = mesh.optics
    start = float(np.asarray(tool.capsules[0].from_)[2])
    wide = tool.radius / mesh.radius
    at = np.array(optics.at) * [wide, wide, 1.0] + [0.0, 0.0, start - mesh.tip]
    turned = find_rotation(orientation).astype(float)
    forward, up = turned @ np.array(optics.axis), turned @ np.array(optics.up)
    eye = np.asarray(position, dtype=float) + turned @ at
    return ScopeCamera(
        distance=HEADLIGHT,
        target=eye + HEADLIGHT * forward,
        field_of_view=optics.field_of_view,
        headlight=HEADLIGHT,
        axes=np.array([np.cross(forward, up), up, forward]),
        elevation=math.asin(max(-1.0, min(1.0, -float(forward[2])))),
    )
