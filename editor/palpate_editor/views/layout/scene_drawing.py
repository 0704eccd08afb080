# SPDX-License-Identifier: GPL-3.0-or-later
"""A layout in the view: bodies as one surface, stones and scenery beside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from palpate.layout.document import Layout, Placed, PlacedBody, PlacedStone
from palpate.layout.placed import move_points
from palpate.render import Appearance, build_sphere
from palpate.render.hard_parts import BONE, STONE
from palpate.viewport import View

from palpate_editor.layout_shapes import Key, PartShape, find_hit, key_of, place_drawn

Floats = NDArray[np.float64]
CHOSEN = (0.98, 0.66, 0.25)
MARK = "overlap"
MARKER = Appearance((0.90, 0.20, 0.16), gloss=0.0, seen_through=True, ghost=0.8, casts_shadow=False)
MARKED, NEAR = 0.02, 40.0
"""[-] Of the scene's radius: the ball at an overlap; in radii of that, how far the eye is then."""


class SceneDrawing:
    """Draws what has a shape; the rest is drawn once its file was read."""

    def __init__(self, view: View):
        self._view = view
        self._shapes: dict[Key, PartShape] = {}
        self._bodies: list[PlacedBody] = []
        self._joined: list[Key] = []
        self._hard: dict[str, Placed] = {}
        self._chosen = ""
        self._framed = False

    def show(self, layout: Layout, shapes: dict[Key, PartShape], chosen: str) -> None:
        """The layout as it is, the part of a name highlighted."""
        self._shapes, self._chosen = shapes, chosen
        self._bodies = [body for body in layout.bodies if key_of(body) in shapes]
        hard = {
            part.name: part for part in (*layout.stones, *layout.scenery) if key_of(part) in shapes
        }
        for name, part in self._hard.items():
            if name not in hard or key_of(part) != key_of(hard[name]):
                self._view.show_part(f"placed {name}", None, STONE)
        self._hard = hard
        self._draw_hard(list(hard.values()))
        self._draw_bodies()
        if not self._framed and (self._bodies or self._hard):
            self._framed = True
            self._view.frame_all()

    def preview(self, part: Placed) -> None:
        """One part elsewhere, for as long as it is dragged."""
        if isinstance(part, PlacedBody):
            moved = [part if body.name == part.name else body for body in self._bodies]
            self._view.move_surface(self._join(moved))
        elif part.name in self._hard:
            self._draw_hard([part])

    def pick(self, origin: Floats, direction: Floats) -> str:
        """The name of the part that a ray meets first; empty beside all."""
        found = [
            (distance, part.name)
            for part in (*self._bodies, *self._hard.values())
            if (distance := find_hit(self._shapes[key_of(part)], part, origin, direction))
            is not None
        ]
        return min(found)[1] if found else ""

    def find_body(self, point: Floats) -> int | None:
        """The number of the body whose surface is nearest to a point [m]; None without any."""
        found = [
            (float(np.linalg.norm(move_points(body, shape.x) - point, axis=1).min()), number)
            for number, body in enumerate(self._bodies)
            if (shape := self._shapes.get(key_of(body))) is not None
        ]
        return min(found)[1] if found else None

    def look_at(self, place: Floats) -> None:
        """Marks a place [m] and comes near to it."""
        view, radius = self._view, MARKED * self._view.scenery.radius
        view.show_part(MARK, build_sphere(place, radius), MARKER)
        view.orbit(0.0, 0.0)  # from here on the camera is where it is put
        view.camera.target = place
        view.camera.distance = NEAR * radius
        view.update()

    def forget_mark(self) -> None:
        self._view.show_part(MARK, None, MARKER)

    # ------------------------------------------------------------ inside

    def _join(self, bodies: Sequence[PlacedBody]) -> Floats:
        """[m] (n, 3) of all bodies, one after the other."""
        moved = [move_points(body, self._shapes[key_of(body)].x) for body in bodies]
        return np.concatenate([np.zeros((0, 3)), *moved])

    def _draw_bodies(self) -> None:
        view, x = self._view, self._join(self._bodies)
        keys = [key_of(body) for body in self._bodies]
        if keys == self._joined and keys:
            view.move_surface(x)
        else:
            self._joined, first, triangles = keys, 0, [np.zeros((0, 3), np.int32)]
            for key in keys:
                triangles.append(self._shapes[key].triangles + np.int32(first))
                first += len(self._shapes[key].x)
            view.show_surface(x, np.concatenate(triangles))
            colours = [self._shapes[key].colours for key in keys]
            if keys and all(each is not None for each in colours):
                view.show_colours(np.concatenate(colours))
        if keys:
            weights = [
                np.full(len(self._shapes[key_of(body)].x), float(body.name == self._chosen))
                for body in self._bodies
            ]
            view.show_selection(np.concatenate(weights))

    def _draw_hard(self, parts: Sequence[Placed]) -> None:
        for part in parts:
            appearance = STONE if isinstance(part, PlacedStone) else BONE
            if part.name == self._chosen:
                # also inside of an organ
                appearance = replace(appearance, colour=CHOSEN, seen_through=True, ghost=0.8)
            shape = place_drawn(self._shapes[key_of(part)], part)
            self._view.show_part(f"placed {part.name}", shape, appearance)
        drawn = [move_points(part, self._shapes[key_of(part)].x) for part in self._hard.values()]
        self._view.scenery.room = np.concatenate([np.zeros((0, 3)), *drawn])
