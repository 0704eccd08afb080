# SPDX-License-Identifier: GPL-3.0-or-later
"""PySide6 6.12.0 on Python 3.11 loses one reference of None with every call of a void method,
every overridden virtual and every signal, until the process dies with `deallocating None`.
"""

from __future__ import annotations

import sys
from collections.abc import Callable

import pytest
from PySide6.QtWidgets import QCheckBox, QWidget

CALLS = 400
NOISE = 20
"""References that come and go in the interpreter itself; the fault loses one in every call."""


class Painted(QWidget):
    """A widget whose virtuals are Python's."""

    def paintEvent(self, event):
        return None

    def event(self, event):
        return True


def void_method(widget: QWidget) -> Callable[[], None]:
    return lambda: widget.setWindowModified(True)


def resizing(widget: QWidget) -> Callable[[], None]:
    return lambda: widget.resize(10, 10)


def overridden_virtual(widget: QWidget) -> Callable[[], None]:
    widget.show()
    return widget.repaint


def signal_to_python(widget: QWidget) -> Callable[[], None]:
    box = QCheckBox(widget)
    box.toggled.connect(lambda checked: None)
    return box.toggle


@pytest.mark.parametrize(
    "kind", [void_method, resizing, overridden_virtual, signal_to_python], ids=lambda k: k.__name__
)
@pytest.mark.parametrize("value", [None, True, False], ids=str)
def test_a_call_into_qt_loses_no_reference_of(value, kind, qtbot):
    widget = Painted()
    qtbot.addWidget(widget)
    call = kind(widget)
    call()

    before = sys.getrefcount(value)
    for _ in range(CALLS):
        call()

    assert sys.getrefcount(value) > before - NOISE
