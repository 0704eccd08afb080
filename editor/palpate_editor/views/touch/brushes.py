# SPDX-License-Identifier: GPL-3.0-or-later
"""The two brushes: one holds vertices at rest, one makes them stiffer or softer."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from palpate.viewport import View
from PySide6.QtCore import QObject, Qt

from palpate_editor.document import Organ
from palpate_editor.edits import FixVertices, PaintStiffness
from palpate_editor.views.context import Context
from palpate_editor.views.touch.brush_tool import BrushTool, Keys
from palpate_editor.views.touch.colours import show_fixed, show_painted, show_stiffness
from palpate_editor.views.touch.painted_surface import PaintedSurface
from palpate_editor.views.touch.stroke import (
    Brush,
    FixStroke,
    SmoothStroke,
    StiffnessStroke,
)
from palpate_editor.views.translations import tr

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


class FixPaint:
    """Vertices that must not move; Ctrl frees them."""

    name, shortcut, has_factor = "fix", "X", False

    def title(self) -> str:
        return tr("Fix")

    def hint(self) -> str:
        return tr("Drag to fix, Ctrl to free, [ ] or Ctrl+wheel for the size, Esc to leave")

    def begin(self, organ: Organ, surface: PaintedSurface, brush: Brush, keys: Keys) -> FixStroke:
        del surface, brush
        return FixStroke(organ.fixed, not keys & CONTROL)

    def show_stroke(self, view: View, stroke: FixStroke) -> None:
        show_fixed(view, stroke.values, None)

    def show_organ(self, view: View, organ: Organ) -> None:
        show_painted(view, organ)

    def find_painted(self, organ: Organ) -> NDArray[np.bool_]:
        return organ.fixed

    def erase(self, ids: NDArray[np.intp]) -> FixVertices:
        return FixVertices(ids, False)


class StiffnessPaint:
    """Local stiffness; Ctrl gives back the organ's own, Shift evens out."""

    name, shortcut, has_factor = "stiffness", "B", True

    def title(self) -> str:
        return tr("Stiffness")

    def hint(self) -> str:
        return tr(
            "Drag to paint, Ctrl to erase, Shift to smooth, [ ] or Ctrl+wheel for the size, "
            "Esc to leave"
        )

    def begin(
        self, organ: Organ, surface: PaintedSurface, brush: Brush, keys: Keys
    ) -> StiffnessStroke | SmoothStroke:
        if keys & SHIFT:
            return SmoothStroke(organ.stiffness_scale, surface.neighbours)
        factor = 1.0 if keys & CONTROL else brush.factor
        return StiffnessStroke(organ.stiffness_scale, factor, brush.strength)

    def show_stroke(self, view: View, stroke: StiffnessStroke | SmoothStroke) -> None:
        show_stiffness(view, stroke.values, always=True)

    def show_organ(self, view: View, organ: Organ) -> None:
        show_fixed(view, organ.fixed, None)
        show_stiffness(view, organ.stiffness_scale, always=True)

    def find_painted(self, organ: Organ) -> NDArray[np.bool_]:
        return organ.stiffness_scale != 1.0

    def erase(self, ids: NDArray[np.intp]) -> PaintStiffness:
        return PaintStiffness(ids, 1.0)


class FixTool(BrushTool[FixStroke]):
    """Paints with FixPaint."""

    def __init__(self, context: Context, brush: Brush, parent: QObject | None = None):
        super().__init__(context, brush, FixPaint(), parent)


class StiffnessTool(BrushTool[StiffnessStroke | SmoothStroke]):
    """Paints with StiffnessPaint."""

    def __init__(self, context: Context, brush: Brush, parent: QObject | None = None):
        super().__init__(context, brush, StiffnessPaint(), parent)
