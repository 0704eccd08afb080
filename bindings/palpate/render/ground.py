# SPDX-License-Identifier: BSD-3-Clause
"""The floor of the studio: nothing of it is seen but the soft shadow upon it."""

from __future__ import annotations

import moderngl
import numpy as np
from numpy.typing import NDArray

from palpate.render.openness import Sky
from palpate.render.program import build_program, write_matrix
from palpate.render.theme import Theme

CELLS = 96
REACH = 2.2
"""[-] half the side of the floor in radii of what stands on it."""
BLURS = 6
FOCUS = 2.0
"""[-] how much of the light comes from above: what comes from the side makes long streaks."""
FAINTEST = 0.03
"""[-] darkness that counts as none."""


class Ground:
    """A square of floor and how dark it is where."""

    def __init__(
        self,
        context: moderngl.Context,
        centre: NDArray[np.float64],
        reach: float,
        darkness: NDArray[np.float64],
    ):
        """`darkness` is (cells, cells), 0 to 1, rows along y; `centre` and `reach` are in [m]."""
        self._context = context
        self._program = build_program(context, "ground")
        self._texture = context.texture(
            darkness.shape[::-1], 1, darkness.astype(np.float32), dtype="f4"
        )
        self._texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        self._texture.repeat_x = self._texture.repeat_y = False
        corners = np.array([[-1, -1], [1, -1], [-1, 1], [1, 1]], np.float32)
        self._corners = context.buffer(corners)
        self._square = context.vertex_array(self._program, [(self._corners, "2f", "corner")])
        self._program["centre"].value, self._program["reach"].value = tuple(centre), reach

    def draw(self, theme: Theme, world_to_clip: NDArray[np.float64]) -> None:
        """Darkens what has been drawn; hides nothing that will be."""
        self._context.enable_only(moderngl.BLEND)
        self._context.blend_func = (
            moderngl.SRC_ALPHA,
            moderngl.ONE_MINUS_SRC_ALPHA,
            moderngl.ZERO,
            moderngl.ONE,
        )
        write_matrix(self._program, "world_to_clip", world_to_clip)
        self._program["colour"].value = theme.shadow
        self._program["strength"].value = theme.shadow_strength
        self._texture.use(0)
        self._program["darkness"].value = 0
        self._square.render(moderngl.TRIANGLE_STRIP)

    def release(self) -> None:
        for thing in (self._square, self._corners, self._texture, self._program):
            thing.release()


def build_ground(
    context: moderngl.Context, sky: Sky, centre: NDArray[np.float64], radius: float, height: float
) -> Ground:
    """The floor at a height [m] under a ball, shaded by what the sky's maps show."""
    points, up = lay_floor(centre, radius, height)
    return shade_floor(context, centre, radius, height, sky.measure(points, up, FOCUS))


def lay_floor(
    centre: NDArray[np.float64], radius: float, height: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Points [m] (cells², 3) of the floor, and their normals."""
    line = np.linspace(-1.0, 1.0, CELLS)
    x, y = np.meshgrid(line, line)
    points = np.stack([x, y, np.zeros_like(x)], axis=-1).reshape(-1, 3) * REACH * radius
    points += [centre[0], centre[1], height]
    return points, np.tile([0.0, 0.0, 1.0], (len(points), 1))


def shade_floor(
    context: moderngl.Context,
    centre: NDArray[np.float64],
    radius: float,
    height: float,
    open_sky: NDArray[np.float64],
) -> Ground:
    """The floor, of whose points (cells²,) some share of the sky is seen."""
    line = np.linspace(-1.0, 1.0, CELLS)
    x, y = np.meshgrid(line, line)
    darkness = blur(1.0 - open_sky.reshape(CELLS, CELLS))
    # far away the few lamps of a sky leave streaks, fainter than what is cut off here
    darkness = np.clip((darkness - FAINTEST) / (1.0 - FAINTEST), 0.0, 1.0)
    # the shadow ends before the floor does
    fade = np.clip(3.0 * (1.0 - np.hypot(x, y)), 0.0, 1.0)
    middle = np.array([centre[0], centre[1], height])
    return Ground(context, middle, REACH * radius, darkness * fade)


def blur(grid: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rounds of the mean over three cells each way: the lamps of a sky are few."""
    for _ in range(BLURS):
        for axis in (0, 1):
            padded = np.pad(grid, [(1, 1) if a == axis else (0, 0) for a in (0, 1)], mode="edge")
            n = grid.shape[axis]
            grid = sum(np.take(padded, np.arange(n) + k, axis) for k in range(3)) / 3.0
    return grid
