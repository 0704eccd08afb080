# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a mesh file in the view: those that are ticked, and the one under the pointer."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import palpate
from palpate.render import Appearance, Shape, build_appearance
from PySide6.QtCore import QObject

from palpate_editor.appearance import USUAL, make_appearance
from palpate_editor.edits.part_list import Part
from palpate_editor.views.context import Context

MARK = "part under the pointer"
MARKED = Appearance(
    (1.0, 0.62, 0.10), gloss=0.2, subsurface=0.0, seen_through=True, casts_shadow=False
)


class PartsPreview(QObject):
    """Takes the view from the organ and gives it back."""

    def __init__(self, context: Context, parent: QObject | None = None):
        super().__init__(parent)
        self.context = context
        self.marked: Part | None = None

    def show(self, parts: Sequence[Part], frame: bool = False) -> None:
        """Draws these parts in the place of the organ; `frame` puts all of them in sight."""
        view, first = self.context.view, not self.context.previewing
        self.context.show_preview(True)
        vertices, triangles = join(parts)
        view.show_selection(None)
        view.show_surface(vertices, triangles)
        view.use_appearance(build_appearance(make_appearance(USUAL)))
        if (first or frame) and len(triangles):
            view.frame_all()

    def mark(self, part: Part | None) -> None:
        """Highlights a part through all that hides it; None for none."""
        if part is self.marked:
            return
        view, self.marked = self.context.view, part
        view.show_part(MARK, None, MARKED)  # its triangles may be others
        if part is not None and len(part.surface.triangles):
            x, triangles = part.surface.vertices, part.surface.triangles
            normals = np.asarray(palpate.compute_vertex_normals(x, triangles))
            view.show_part(MARK, Shape(x, normals, triangles), MARKED)

    def clear(self) -> None:
        """The organ has the view again."""
        self.mark(None)
        if self.context.previewing:
            self.context.show_preview(False)
            self.context.view.frame_all()


def join(parts: Sequence[Part]) -> tuple[np.ndarray, np.ndarray]:
    """Vertices [m] (n, 3) and triangles (t, 3) of parts beside each other."""
    vertices, triangles, count = [np.zeros((0, 3))], [np.zeros((0, 3), np.int32)], 0
    for part in parts:
        vertices.append(part.surface.vertices)
        triangles.append(part.surface.triangles + count)
        count += len(part.surface.vertices)
    return np.concatenate(vertices), np.concatenate(triangles).astype(np.int32)
