# SPDX-License-Identifier: GPL-3.0-or-later
"""Questions before something could be lost: unsaved changes, and a file that has changed."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QMessageBox, QWidget

from palpate_editor.views.translations import tr

BUTTONS = QMessageBox.StandardButton
SAVE_AS, OVERWRITE, RELOAD = BUTTONS.Save, BUTTONS.Yes, BUTTONS.Reset
"""Of the question about a changed file."""


def build_box(parent: QWidget, name: str, answered: Callable[[int], None]) -> QMessageBox:
    box = QMessageBox(parent)
    box.setObjectName(name)
    box.finished.connect(answered)
    box.finished.connect(box.deleteLater)
    return box


def ask_unsaved(parent: QWidget, name: str, answered: Callable[[int], None]) -> QMessageBox:
    """Shows the question whether to save `name` before going on: Save, Discard or Cancel."""
    box = build_box(parent, "unsaved", answered)
    box.setIcon(QMessageBox.Icon.Question)
    box.setWindowTitle(tr("Unsaved changes"))
    box.setText(tr("{name} has changes that are not saved.").format(name=name))
    box.setInformativeText(tr("Save them before going on?"))
    box.setStandardButtons(BUTTONS.Save | BUTTONS.Discard | BUTTONS.Cancel)
    box.button(BUTTONS.Save).setText(tr("Save"))
    box.button(BUTTONS.Discard).setText(tr("Do not save"))
    box.button(BUTTONS.Cancel).setText(tr("Cancel"))
    box.setDefaultButton(BUTTONS.Save)
    box.open()
    return box


def ask_changed(parent: QWidget, name: str, answered: Callable[[int], None]) -> QMessageBox:
    """Shows the question what to do about a file that holds what another program wrote."""
    box = build_box(parent, "changed_file", answered)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setWindowTitle(tr("The file has changed"))
    box.setText(
        tr("{file} was changed by another program after it was read here.").format(file=name)
    )
    box.setInformativeText(
        tr(
            "Overwriting loses what the other program wrote; reading it again loses what was "
            "changed here. Under another name both are kept."
        )
    )
    box.setStandardButtons(SAVE_AS | OVERWRITE | RELOAD | BUTTONS.Cancel)
    box.button(SAVE_AS).setText(tr("Save as…"))
    box.button(OVERWRITE).setText(tr("Overwrite"))
    box.button(RELOAD).setText(tr("Read it again"))
    box.button(BUTTONS.Cancel).setText(tr("Cancel"))
    box.setDefaultButton(SAVE_AS)
    box.open()
    return box
