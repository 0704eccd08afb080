# SPDX-License-Identifier: GPL-3.0-or-later
"""What a person's hands do in the main window: keys, clicks, dialogs, dropped files."""

from __future__ import annotations

from pathlib import Path

from palpate_editor.views.window import MainWindow
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QAction, QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QFileDialog, QLineEdit, QWidget

LEFT = Qt.MouseButton.LeftButton
CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


def click(widget: QWidget) -> None:
    """The left button in the middle of a widget."""
    assert widget.isVisible(), f"{widget.objectName()} cannot be seen"
    assert widget.isEnabled(), f"{widget.objectName()} cannot be used"
    QTest.mouseClick(widget, LEFT, Qt.KeyboardModifier.NoModifier, widget.rect().center())


def child(window: QWidget, name: str, kind: type = QWidget) -> QWidget:
    found = window.findChild(kind, name)
    assert found is not None, f"there is no {name}"
    return found


def press(window: MainWindow, key: Qt.Key, modifiers: Qt.KeyboardModifier = None) -> None:
    """A key on the window itself, as when no field has the cursor."""
    window.activateWindow()
    assert QTest.qWaitForWindowActive(window)
    window.view.setFocus()
    QTest.keyClick(window, key, modifiers or Qt.KeyboardModifier.NoModifier)


def type_into(field: QWidget, text: str) -> None:
    """Replaces what stands in a field, and presses Return."""
    click(field)
    edit = field if isinstance(field, QLineEdit) else field.findChild(QLineEdit)
    edit.selectAll()
    QTest.keyClicks(edit, text)
    QTest.keyClick(edit, Qt.Key.Key_Return)


def choose_file(qtbot, window: MainWindow, path: Path) -> None:
    """Types a path into the file dialog that is open, and accepts it."""
    qtbot.waitUntil(lambda: bool(find_dialogs(window)))
    dialog = find_dialogs(window)[-1]
    edit = dialog.findChild(QLineEdit, "fileNameEdit")
    edit.setText(str(path))
    buttons = dialog.findChild(QDialogButtonBox)
    roles = (QDialogButtonBox.ButtonRole.AcceptRole,)
    accept = next(b for b in buttons.buttons() if buttons.buttonRole(b) in roles)
    click(accept)
    qtbot.waitUntil(lambda: not find_dialogs(window))


def find_dialogs(window: MainWindow) -> list[QFileDialog]:
    return [dialog for dialog in window.findChildren(QFileDialog) if dialog.isVisible()]


def drop(window: QWidget, *paths: Path) -> None:
    """A drag that enters and is let go; Qt swallows a drop that never entered."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    none = Qt.KeyboardModifier.NoModifier
    copy = Qt.DropAction.CopyAction
    QApplication.sendEvent(window, QDragEnterEvent(QPoint(5, 5), copy, data, LEFT, none))
    QApplication.sendEvent(window, QDropEvent(QPointF(5, 5), copy, data, LEFT, none))


def action(window: MainWindow, name: str) -> QAction:
    return window.actions_by_name.actions[name]


def log_of(window: MainWindow) -> str:
    return window.log.log.toPlainText()
