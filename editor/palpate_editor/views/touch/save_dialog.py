# SPDX-License-Identifier: GPL-3.0-or-later
"""Asking for the name of a file to write, without holding up what runs meanwhile."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QWidget


def ask_save(
    parent: QWidget, title: str, name: str, filters: str, chosen: Callable[[str], None]
) -> QFileDialog:
    """Opens a dialog that proposes `name`; `chosen`, a bound method, is told what was chosen."""
    dialog = QFileDialog(parent, title)
    dialog.setObjectName("save_dialog")
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.setNameFilter(filters)
    dialog.setDefaultSuffix(Path(name).suffix.lstrip("."))
    dialog.selectFile(name)
    dialog.fileSelected.connect(chosen)
    dialog.finished.connect(dialog.deleteLater)
    dialog.open()
    return dialog
