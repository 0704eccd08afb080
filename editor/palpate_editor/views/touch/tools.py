# SPDX-License-Identifier: GPL-3.0-or-later
"""What the window, the stage panels and the keys ask of a tool, for annotations."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, SignalInstance
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QWidget

from palpate_editor.views.context import Context
from palpate_editor.views.touch.stroke import Brush


class Tool(Protocol):
    """A tool of the viewport: what the tool strip chooses, one at a time."""

    @property
    def name(self) -> str: ...
    @property
    def shortcut(self) -> str: ...
    @property
    def stages(self) -> tuple[str, ...]: ...
    @property
    def left(self) -> SignalInstance: ...

    def title(self) -> str: ...
    def hint(self) -> str: ...
    def activate(self) -> None: ...
    def deactivate(self) -> None: ...
    def actions(self) -> list[QAction]: ...
    def options(self) -> QWidget: ...


class SizedTool(Protocol):
    """A tool that the keys for the size of a brush reach while it has the mouse."""

    active: bool

    @property
    def activated(self) -> SignalInstance: ...

    def grow(self, notches: float) -> None: ...


class PaintTool(Protocol):
    """A brush tool, as its options see it."""

    context: Context
    brush: Brush
    name: str
    has_factor: bool

    @property
    def brush_changed(self) -> SignalInstance: ...

    def set_radius(self, radius: float) -> None: ...
    def count_painted(self) -> tuple[int, int]: ...
    def erase_all(self) -> None: ...


class SelectionTool(Protocol):
    """The tool that selects, as its options and the list of regions see it."""

    context: Context
    selected: NDArray[np.bool_]

    @property
    def selection_changed(self) -> SignalInstance: ...

    def select(
        self,
        ids: NDArray[np.intp],
        modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier,
    ) -> None: ...
    def fix(self) -> None: ...
    def free(self) -> None: ...
    def stiffen(self, factor: float) -> None: ...
