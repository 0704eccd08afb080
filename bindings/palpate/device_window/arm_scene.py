# SPDX-License-Identifier: BSD-3-Clause
"""The device in a view: where it is, where it is to go, what it is asked to push and pushes."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.device_window.arm_shapes import (
    AXLE_HEIGHT,
    ArmShapes,
    build_box,
    build_cage,
    build_ghost,
    build_stand,
    find_points,
)
from palpate.player.style import ACCENTS, mix
from palpate.render import Appearance, build_arrow
from palpate.render.theme import FORCE, THEMES
from palpate.viewport import View

Array = NDArray[np.float64]

COLOURS = {
    "turret": (0.62, 0.65, 0.70),
    "arm": (0.90, 0.48, 0.18),
    "drive": (0.25, 0.52, 0.78),
    "yoke": (0.93, 0.83, 0.42),
    "stylus": (0.26, 0.28, 0.32),
}
"""As the printed parts are drawn."""
STAND = Appearance((0.30, 0.32, 0.36), gloss=0.3, subsurface=0.0)
SCALE = 0.07
"""[m/N] of the arrows."""
LEAST = 0.02
"""[N] below which no arrow is drawn."""
STILL = 2e-4
"""[rad] below which nothing is drawn again."""
LINE = 0.0008
"""[m] radius of a line."""
SIGHT = (-42.0, 18.0)
"""[degree] from where one looks first: from the user's right."""


class ArmScene:
    """Draws a device; knows nothing of how it is driven."""

    def __init__(self, view: View, theme: str):
        self.view = view
        self.arm = palpate.Arm()
        self._shapes = ArmShapes(self.arm)
        self.tip = np.asarray(palpate.Workspace().center)
        """[m] where the tip is drawn."""
        self._theme = theme
        self._drawn: Array | None = None
        self._goal: Array | None = None
        stand = build_stand()
        room = np.array([[0.0, 0.0, -AXLE_HEIGHT], [0.0, 0.0, 0.20]])
        view.wireframe = False
        view.scenery.room = np.concatenate([room, build_cage(self.arm, LINE).vertices])
        view.use_appearance(STAND)
        view.show_surface(stand.vertices, stand.triangles)
        view.look_from(*np.radians(SIGHT))
        view.force_scale = SCALE
        self.use_theme(theme)
        joints = palpate.find_joints(self.arm, palpate.Workspace().center)
        self.show_pose(np.asarray(joints), np.zeros(3))

    def use_arm(self, arm: palpate.Arm) -> None:
        """What its calibration says of its links and joints."""
        self.arm, self._shapes = arm, ArmShapes(arm)
        self._drawn = None
        self._draw_room()

    def use_theme(self, theme: str) -> None:
        self._theme = theme
        self.view.use_theme(theme)
        self._draw_room()
        self.show_goal(self._goal)

    def show_pose(self, joints: ArrayLike, gimbal: ArrayLike) -> None:
        """Joints and gimbal [rad]."""
        pose = np.concatenate([np.asarray(joints, dtype=float), np.asarray(gimbal, dtype=float)])
        if self._drawn is not None and np.abs(pose - self._drawn).max() < STILL:
            return
        self._drawn = pose
        held = palpate.compute_stylus(pose[:3], pose[3:])
        stylus = turn_down(np.asarray(held, dtype=float))
        for name, shape in self._shapes.place(pose[:3], stylus).items():
            self.view.show_part(name, shape, self._appearance(name))
        self.tip = find_points(self.arm, pose[:3])[1]

    def show_forces(self, commanded: ArrayLike, applied: ArrayLike) -> None:
        """Arrows from the tip for forces [N]."""
        accent = ACCENTS[self._theme].accent
        appearance = Appearance(
            accent, gloss=0.3, subsurface=0.0, seen_through=True, casts_shadow=False
        )
        self._show_arrow("commanded", commanded, 0.0032, appearance)
        solid = Appearance(FORCE, gloss=0.3, subsurface=0.0, seen_through=True, casts_shadow=False)
        self._show_arrow("applied", applied, 0.0048, solid)

    def show_goal(self, joints: ArrayLike | None) -> None:
        """The pose [rad] that the arm is to be brought to; None for none."""
        self._goal = None if joints is None else np.asarray(joints, dtype=float)
        shape = None if self._goal is None else build_ghost(self.arm, self._goal)
        accent = ACCENTS[self._theme].accent
        appearance = Appearance(
            accent, gloss=0.2, subsurface=0.0, seen_through=True, casts_shadow=False
        )
        self.view.show_part("ghost", shape, appearance)

    def _show_arrow(
        self, name: str, force: ArrayLike, radius: float, appearance: Appearance
    ) -> None:
        vector = np.asarray(force, dtype=float)
        shape = None
        if np.isfinite(vector).all() and np.linalg.norm(vector) > LEAST:
            shape = build_arrow(self.tip, self.tip + SCALE * vector, radius)
        self.view.show_part(name, shape, appearance)

    def _draw_room(self) -> None:
        theme = THEMES[self._theme]
        faint = mix(theme.backdrop, theme.faint, 0.55)
        plain = Appearance(faint, gloss=0.0, subsurface=0.0, casts_shadow=False)
        self.view.show_part("cage", build_cage(self.arm, LINE), plain)
        accent = mix(theme.backdrop, ACCENTS[self._theme].accent, 0.55)
        appearance = Appearance(accent, gloss=0.0, subsurface=0.0, casts_shadow=False)
        self.view.show_part("box", build_box(palpate.Workspace(), LINE), appearance)

    def _appearance(self, name: str) -> Appearance:
        colour = COLOURS.get(name, ACCENTS[self._theme].warm)
        return Appearance(colour, gloss=0.35, subsurface=0.0)


def turn_down(held: Array) -> Array:
    """Where a quaternion (x, y, z, w) turns the direction straight down."""
    axis, w = held[:3], held[3]
    down = np.array([0.0, 0.0, -1.0])
    return down + 2.0 * np.cross(axis, np.cross(axis, down) + w * down)
