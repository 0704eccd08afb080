# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps what painting needs of the open surface, and never holds up the window for it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import palpate
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from palpate_editor.document import Surface
from palpate_editor.views.context import Context
from palpate_editor.views.jobs import Progress
from palpate_editor.views.touch.painted_surface import PaintedSurface
from palpate_editor.views.touch.selection import keep_visible

QUICK = 15_000
"""Vertices of a surface that is made ready between two pictures; larger ones take a thread."""


class SurfaceKeeper(QObject):
    """One for all tools of a context: keeper_of(context)."""

    ready = Signal()
    """A large surface can be painted from now on."""

    def __init__(self, context: Context):
        super().__init__(context)
        self.context = context
        self._kept: PaintedSurface | None = None
        self._wanted: Surface | None = None

    def find(self) -> PaintedSurface | None:
        """Of the open organ; None where there is none, or not yet."""
        surface = self.context.session.organ.surface
        if surface is None:
            return None
        if self._kept is not None and self._kept.surface is surface:
            return self._kept
        if len(surface.vertices) <= QUICK:
            self._kept = PaintedSurface(surface)
            return self._kept
        if self._wanted is not surface:
            self._wanted = surface
            work = PaintedWork(surface)
            self.context.jobs.start_unseen("painting", work, self._take, self.context.refuse)
        return None

    def _take(self, painted: PaintedSurface) -> None:
        if painted.surface is self._wanted:
            self._kept, self._wanted = painted, None
            self.ready.emit()


def keeper_of(context: Context) -> SurfaceKeeper:
    """The one of a context; made when it is first asked for."""
    return context.findChild(SurfaceKeeper) or SurfaceKeeper(context)


@dataclass(frozen=True, eq=False)
class PaintedWork:
    """Makes a large surface ready, in a thread."""

    surface: Surface

    def __call__(self, progress: Progress) -> PaintedSurface:
        del progress
        return PaintedSurface(self.surface)


@dataclass(frozen=True, eq=False)
class SeenWork:
    """Finds which of some vertices an eye [m] sees: at once for few, in a thread for many."""

    painted: PaintedSurface
    ids: NDArray[np.intp]
    eye: NDArray[np.float64]

    def __call__(self, progress: Progress | None = None) -> NDArray[np.intp]:
        del progress
        surface = self.painted.surface
        tree = palpate.AabbTree(surface.vertices, surface.triangles)
        return keep_visible(self.ids, surface.vertices, self.painted.normals, tree, self.eye)
