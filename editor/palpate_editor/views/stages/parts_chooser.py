# SPDX-License-Identifier: GPL-3.0-or-later
"""Which parts of a mesh file are used: found by name, told by size, shown before they are taken."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QEvent, QObject, Signal
from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QPushButton, QVBoxLayout, QWidget

from palpate_editor.document import Organ
from palpate_editor.edits.import_mesh import Assembling
from palpate_editor.edits.part_list import Part, find_outermost
from palpate_editor.views.context import Context
from palpate_editor.views.stages.assembling_form import AssemblingForm
from palpate_editor.views.stages.parts_preview import PartsPreview
from palpate_editor.views.stages.parts_tree import PartsTree
from palpate_editor.views.translations import tr

ROWS = 7
"""That are in sight."""
ROW = 40
"""[px] Of a row, of its two or three lines."""
SEARCHED = 6
"""Parts from which on there is a field to find them by."""


class PartsChooser(QWidget):
    """The tree, what finds in it, and what it shows in the view."""

    changed = Signal()
    """Other parts are ticked."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.known: dict[str, Part | None] = {}
        """By name; None for one whose file was not read in this window."""
        self.preview = PartsPreview(context, self)
        self.search = QLineEdit(self)
        self.search.setObjectName("find_part")
        self.search.setPlaceholderText(tr("Find a part by its name"))
        self.search.setClearButtonEnabled(True)
        self.tree = PartsTree(context, self)
        self.search.textChanged.connect(self.tree.find)
        self.tree.changed.connect(self.on_change)
        self.tree.entered.connect(self.mark)
        self.tree.viewport().installEventFilter(self)
        self.form = AssemblingForm(self)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.search)
        column.addWidget(self.tree)
        column.addLayout(self.build_buttons())
        column.addWidget(self.form)
        context.stage_shown.connect(self.on_stage)
        context.session.changed.connect(self.end_preview)

    def build_buttons(self) -> QHBoxLayout:
        self.show_button = QPushButton(tr("Show them"), self)
        self.show_button.setObjectName("show_parts")
        self.show_button.setCheckable(True)
        self.show_button.setToolTip(
            tr("The ticked parts in the view; the one under the pointer stands out")
        )
        self.show_button.toggled.connect(self.on_show)
        self.all_button, self.none_button = QPushButton(tr("All")), QPushButton(tr("None"))
        self.outer_button = QPushButton(tr("Outer ones"))
        self.outer_button.setToolTip(tr("The parts that lie inside no other"))
        self.all_button.clicked.connect(self.tick_all)
        self.none_button.clicked.connect(self.tick_none)
        self.outer_button.clicked.connect(self.tick_outermost)
        row = QHBoxLayout()
        for button in (self.all_button, self.none_button, self.outer_button, self.show_button):
            button.setProperty("small", True)
            row.addWidget(button)
        row.addStretch(1)
        return row

    # ------------------------------------------------------------ filling

    def show_parts(
        self,
        parts: Mapping[str, Part | None],
        chosen: tuple[str, ...],
        organ: Organ | None = None,
    ) -> None:
        """Lists parts; none chosen means all. With an organ, as it was put together."""
        self.end_preview()
        if list(parts.items()) != list(self.known.items()):
            self.known = dict(parts)
            self.tree.fill(parts)
        self.search.clear()
        if organ is not None:
            self.form.show_organ(organ)
            self.tree.taken = set(organ.assembly.subtracted if organ.assembly else ())
            self.tree.show_signs()
        self.tree.tick({*chosen, *self.tree.taken} if chosen else None)
        rows = max(3, min(ROWS, len(parts)))
        self.tree.setFixedHeight(rows * ROW + 6)
        self.search.setVisible(len(parts) >= SEARCHED)
        self.show_button.setVisible(any(part is not None for part in parts.values()))
        self.outer_button.setVisible(bool(find_outermost(self.list_known())))

    def list_known(self) -> tuple[Part, ...]:
        return tuple(part for part in self.known.values() if part is not None)

    def chosen(self) -> list[str]:
        """The names of the parts that the organ is made of."""
        return self.tree.chosen()

    def assembling(self) -> Assembling:
        return self.form.read(tuple(name for name in self.known if name in self.tree.taken))

    def tick_all(self) -> None:
        self.tree.tick_visible(True)

    def tick_none(self) -> None:
        self.tree.tick_visible(False)

    def tick_outermost(self) -> None:
        self.tree.tick(set(find_outermost(self.list_known())))

    # ------------------------------------------------------------ in the view

    def on_change(self) -> None:
        self.form.show_taken(bool(self.tree.taken))
        self.changed.emit()
        if self.context.previewing:
            self.preview.show(self.list_shown())

    def list_shown(self) -> list[Part]:
        return [part for name in self.tree.shown() if (part := self.known[name]) is not None]

    def on_show(self, shown: bool) -> None:
        if shown:
            self.preview.show(self.list_shown(), frame=True)
        else:
            self.preview.clear()

    def begin_preview(self) -> None:
        """Shows the parts of a file that cannot be used whole, to choose from."""
        self.show_button.setChecked(True)

    def end_preview(self, *_: object) -> None:
        self.show_button.setChecked(False)

    def on_stage(self, stage: str) -> None:
        if stage != "import":
            self.end_preview()

    def mark(self, name: str | None) -> None:
        """Highlights the part under the pointer, or that the keyboard has come to."""
        if self.context.previewing:
            self.preview.mark(None if name is None else self.known.get(name))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Leave:
            self.preview.mark(None)
        return super().eventFilter(watched, event)
