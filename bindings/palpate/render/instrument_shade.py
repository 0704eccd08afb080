# SPDX-License-Identifier: BSD-3-Clause
"""What an instrument does to the look of the tissue under it: shadow, ring of height, glow.

The fragment shader draws all three on the surface itself, so that they lie in every dent. The
shadow is that of the key lamp, computed for each fragment from the capsules: it costs no second
picture, and is there in every quick frame as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import moderngl
import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate

MOST_CAPSULES, MOST_RINGS = 16, 4
"""That the shader has room for: what is beyond casts no shadow and has no ring."""
SHAFT = 0.25
"""[m] of the shaft, from the tip, that casts a shadow."""
LEAST_GLOW, GLOW_FORCE = 0.35, 2.0
"""[-] Of the lightest touch, and the force [N] at which it is whole."""

Array = NDArray[np.float64]


@dataclass(frozen=True)
class InstrumentShade:
    """An instrument where it is now."""

    from_: Array
    to: Array
    """[m] (n, 3) the ends of the axes of its capsules."""
    radius: float
    """[m]"""
    glow: float = 0.0
    """[-] 0 to 1, of the tissue that it touches."""
    ring: tuple[Array, float] | None = None
    """[m] The point of the surface nearest to its tip, and the radius of the ring around it."""


def find_glow(touching: bool, force: float) -> float:
    """[-] 0 to 1, by the force [N] of a contact."""
    if not touching:
        return 0.0
    return min(1.0, LEAST_GLOW + (1.0 - LEAST_GLOW) * abs(force) / GLOW_FORCE)


def place_axes(
    tool: palpate.Tool,
    position: ArrayLike,
    rotation: NDArray[np.floating],
    opening: float = 0.0,
) -> tuple[Array, Array]:
    """[m] The ends, (n, 3) each, of the axes of what touches; of a ball both are its middle.

    `opening` [rad] is that of each jaw.
    """
    at = np.asarray(position, dtype=float)
    if not tool.capsules:
        return at[None].copy(), at[None].copy()
    from_ = np.array([part.from_ for part in tool.capsules])
    to = np.array([part.to for part in tool.capsules])
    jaws = getattr(tool, "jaws", None)
    if jaws is not None and opening:
        hinge, axis = np.asarray(jaws.hinge), np.asarray(jaws.axis)
        for jaw, angle in enumerate((opening, -opening)):
            for ends in (from_, to):
                ends[jaw] = turn_about(ends[jaw] - hinge, axis, angle) + hinge
    return from_ @ rotation.T + at, to @ rotation.T + at


def turn_about(point: Array, axis: Array, angle: float) -> Array:
    """A point turned about a unit axis through the origin [Rodrigues]."""
    along = (point @ axis) * axis
    across = point - along
    return along + np.cos(angle) * across + np.sin(angle) * np.cross(axis, point)


def build_shade(
    tool: palpate.Tool,
    position: ArrayLike,
    rotation: NDArray[np.floating],
    glow: float = 0.0,
    ring: tuple[Array, float] | None = None,
    opening: float = 0.0,
) -> InstrumentShade:
    """Of what touches and, of an instrument with a shaft, of the shaft as well."""
    from_, to = place_axes(tool, position, rotation, opening)
    if tool.capsules:
        hand = np.asarray(position, dtype=float) + rotation @ np.array([0.0, 0.0, SHAFT])
        from_, to = np.vstack([from_, to[-1]]), np.vstack([to, hand])
    return InstrumentShade(from_, to, float(tool.radius), glow, ring)


class ShadeUniforms:
    """The instruments of a frame as the shader takes them."""

    def __init__(self) -> None:
        self._from = np.zeros((MOST_CAPSULES, 4), np.float32)
        self._to = np.zeros((MOST_CAPSULES, 4), np.float32)
        self._rings = np.zeros((MOST_RINGS, 4), np.float32)
        self.capsules = self.rings = 0
        """How many there are."""

    def use(self, shades: Sequence[InstrumentShade]) -> None:
        self.capsules = self.rings = 0
        for shade in shades:
            count = min(len(shade.from_), MOST_CAPSULES - self.capsules)
            rows = slice(self.capsules, self.capsules + count)
            self._from[rows, :3], self._from[rows, 3] = shade.from_[:count], shade.radius
            self._to[rows, :3], self._to[rows, 3] = shade.to[:count], shade.glow
            self.capsules += count
            if shade.ring is not None and self.rings < MOST_RINGS:
                self._rings[self.rings, :3], self._rings[self.rings, 3] = shade.ring
                self.rings += 1

    def write(self, program: moderngl.Program) -> None:
        """Into a program that has them."""
        program["capsule_from"].write(self._from)
        program["capsule_to"].write(self._to)
        program["rings"].write(self._rings)
        program["capsule_count"].value = self.capsules
        program["ring_count"].value = self.rings
