# SPDX-License-Identifier: BSD-3-Clause
"""What a view asks of a tool, and what it is, for annotations."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent

if TYPE_CHECKING:
    from palpate.viewport.view_base import ViewBase


class ViewTool(Protocol):
    """Gets a view's events first; True means that the event was meant for it."""

    def press(self, view: ViewBase, event: QMouseEvent) -> bool: ...
    def move(self, view: ViewBase, event: QMouseEvent) -> bool: ...
    def release(self, view: ViewBase, event: QMouseEvent) -> bool: ...
    def wheel(self, view: ViewBase, event: QWheelEvent) -> bool: ...
    def leave(self, view: ViewBase) -> None: ...
    def key(self, view: ViewBase, event: QKeyEvent) -> bool: ...
