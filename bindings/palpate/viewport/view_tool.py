# SPDX-License-Identifier: BSD-3-Clause
"""What a view asks of a tool, and what it is, for annotations."""

from __future__ import annotations

from typing import Protocol, TypeVar

from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent

View = TypeVar("View", contravariant=True)


class ViewTool(Protocol[View]):
    """Gets the events of a View first; True means that the event was meant for it."""

    def press(self, view: View, event: QMouseEvent) -> bool: ...
    def move(self, view: View, event: QMouseEvent) -> bool: ...
    def release(self, view: View, event: QMouseEvent) -> bool: ...
    def wheel(self, view: View, event: QWheelEvent) -> bool: ...
    def leave(self, view: View) -> None: ...
    def key(self, view: View, event: QKeyEvent) -> bool: ...
