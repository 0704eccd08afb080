# SPDX-License-Identifier: BSD-3-Clause
"""One surface of a view, in main memory and on the graphics card."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from palpate.render import Appearance, Part, Renderer


class Thing:
    """A surface as float32 streams, and the part that shows it while there is a context."""

    def __init__(self, vertex_count: int, triangles: NDArray[np.integer], appearance: Appearance):
        self.triangles, self.appearance, self.visible = triangles, appearance, True
        self.streams = {
            "position": np.zeros((vertex_count, 3), np.float32),
            "normal": np.zeros((vertex_count, 3), np.float32),
            "value": np.zeros(vertex_count, np.float32),
            "selection": np.zeros(vertex_count, np.float32),
            "torn": np.zeros(vertex_count, np.float32),
            "openness": np.ones(vertex_count, np.float32),
            "rest": np.zeros((vertex_count, 3), np.float32),
        }
        self.part: Part | None = None
        self._stale = set(self.streams)
        self._regrouped = False

    def use_triangles(self, triangles: NDArray[np.integer]) -> None:
        """Others of the same vertices, as many as there are."""
        if not np.array_equal(self.triangles, triangles):
            self.triangles, self._regrouped = triangles, True

    def tint(self) -> None:
        """From here on its vertices have colours of their own."""
        count = len(self.streams["position"])
        self.streams.setdefault("tint", np.ones((count, 3), np.float32))

    def write_first(self, name: str, values: ArrayLike) -> None:
        """Copies into the first rows of a stream."""
        np.copyto(self.streams[name][: len(np.asarray(values))], values, casting="same_kind")
        self._stale.add(name)

    def write(self, name: str, values: ArrayLike) -> None:
        """Copies into a stream; nothing is allocated."""
        np.copyto(self.streams[name], values, casting="same_kind")
        self._stale.add(name)

    def place(self, vertices: ArrayLike, scale: float, centre: ArrayLike) -> None:
        """Positions are `vertices`, made larger and moved to `centre` [m]."""
        position = self.streams["position"]
        np.multiply(vertices, np.float32(scale), out=position)
        position += np.asarray(centre, dtype=np.float32)
        self._stale.add("position")

    def show_in(self, renderer: Renderer) -> None:
        """Brings the part up to date. The context must be current."""
        if not self.visible:
            self.hide_from(renderer)
            return
        if self.part is None:
            count = len(self.streams["position"])
            self.part = renderer.add(count, self.triangles, self.appearance)
            self._stale, self._regrouped = set(self.streams), False
        self.part.appearance = self.appearance
        if self._regrouped:
            self.part.use_triangles(self.triangles)
            self._regrouped = False
        self.part.update(**{name: self.streams[name] for name in self._stale})
        self._stale.clear()

    def hide_from(self, renderer: Renderer) -> None:
        if self.part is not None:
            renderer.remove(self.part)
            self.part = None
