# SPDX-License-Identifier: BSD-3-Clause
"""Draws the dent under a tool in place of the triangles around it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from palpate.viewport.dent_patch import MOST_POINTS, DentPatch, build_dent
from palpate.viewport.thing import Thing

CARRIED = frozenset({"value", "selection", "torn", "rest", "tint"})
"""Streams of a surface that its pieces have as well."""


class DrawnDent:
    """The pieces, and the surface without what they stand for."""

    def __init__(self) -> None:
        self.thing: Thing | None = None
        """None until there is a dent; then with room for any, and the rest of it without area."""
        self._edge = 0.0

    def take_surface(self, vertices: NDArray[np.float64], triangles: NDArray[np.integer]) -> None:
        """A new surface, in which there is no dent yet."""
        self.hide(None, triangles)
        edges = (vertices[triangles[:, k]] - vertices[triangles[:, k - 1]] for k in range(3))
        self._edge = max(float(np.linalg.norm(e, axis=1).max(initial=0.0)) for e in edges)

    def show(
        self,
        surface: Thing | None,
        vertices: NDArray[np.float64],
        triangles: NDArray[np.integer],
        ball: tuple[ArrayLike, float] | None,
    ) -> bool:
        """The dent of a ball, centre [m] (3,) and radius [m], in a surface; False for none."""
        patch = None
        if surface is not None and ball is not None and ball[1] > 0.0:
            centre, radius = np.asarray(ball[0], dtype=np.float64), float(ball[1])
            normals = surface.streams["normal"]
            patch = build_dent(vertices, normals, triangles, centre, radius, self._edge)
        if surface is None or patch is None:
            self.hide(surface, triangles)
            return False
        rows = np.array(triangles)
        rows[patch.hidden] = rows[patch.hidden][:, :1]
        surface.use_triangles(rows)
        self._write(surface, patch)
        return True

    def hide(self, surface: Thing | None, triangles: NDArray[np.integer]) -> None:
        """The surface whole again."""
        if self.thing is not None and self.thing.visible:
            self.thing.visible = False
            if surface is not None:
                surface.use_triangles(triangles)

    def _write(self, surface: Thing, patch: DentPatch) -> None:
        thing = self.thing
        if thing is None:
            rows = np.zeros((2 * MOST_POINTS, 3), np.uint32)
            thing = self.thing = Thing(MOST_POINTS, rows, surface.appearance)
        thing.visible = True
        # its edges would be those of the pieces
        thing.appearance = replace(surface.appearance, wired=False)
        rows = np.zeros_like(thing.triangles)
        rows[: len(patch.triangles)] = patch.triangles
        thing.use_triangles(rows)
        thing.write_first("position", patch.position)
        thing.write_first("normal", patch.normal)
        if "tint" in surface.streams:
            thing.tint()
        for name in CARRIED & surface.streams.keys():
            thing.write_first(name, patch.carry(surface.streams[name]))
        thing.write_first("openness", patch.openness * patch.carry(surface.streams["openness"]))
