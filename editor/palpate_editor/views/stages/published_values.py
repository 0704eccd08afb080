# SPDX-License-Identifier: GPL-3.0-or-later
"""A tissue of the library: found by words, its constants taken, its values shown."""

from __future__ import annotations

from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import MaterialPart, ModelPart
from palpate.viewport.tone import set_tone
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.document import Organ
from palpate_editor.edits import SetMaterial, SetTissue
from palpate_editor.tissue_library import LibraryTissue, choose, find_named, read_library, search
from palpate_editor.views.context import Context
from palpate_editor.views.shipped_organs import name_tissue
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.stages.published_dialog import PublishedDialog, say_range, say_status
from palpate_editor.views.translations import tr

TONES = {"checked": "good", "recalled": "warning", "unknown": "bad"}


class TissueBox(QComboBox):
    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scrolling the form must not change the tissue on the way."""
        event.ignore()


def read_tissues(context: Context) -> list[LibraryTissue]:
    """The library; without a designer's own file where that one is damaged."""
    try:
        return read_library()
    except (Refusal, OSError) as problem:
        context.refuse(problem)
        return read_library(own=False)


class PublishedValues(QWidget):
    """Rows at the top of the form."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.known = read_tissues(context)
        self.titles = {t.name: name_tissue(t.name, t.title) for t in self.known}
        self.tissues = self.known
        """Those that the words find."""
        self.shown_name = ""
        """Of the organ whose own tissue was chosen last."""
        self.dialog: PublishedDialog | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(6)
        column.addLayout(self.build_choice())
        self.about = write_label("", "note", self)
        self.about.setObjectName("tissue_status")
        self.about.setWordWrap(True)
        column.addWidget(self.about)
        self.accept = QCheckBox(tr("Use it although nobody has looked it up"), self)
        self.accept.setObjectName("accept_recalled")
        self.accept.toggled.connect(self.show_tissue)
        column.addWidget(self.accept)
        column.addLayout(self.build_buttons())
        self.fill("")

    def build_choice(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(8)
        self.words = QLineEdit(self)
        self.words.setObjectName("tissue_words")
        self.words.setPlaceholderText(tr("Search…"))
        self.words.setAccessibleName(tr("Words of the tissue"))
        self.words.setClearButtonEnabled(True)
        self.words.textChanged.connect(self.fill)
        self.box = TissueBox(self)
        self.box.setObjectName("published_tissue")
        self.box.setAccessibleName(tr("Tissue to look up"))
        self.box.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.box.currentIndexChanged.connect(self.change_tissue)
        row.addWidget(self.words, 2)
        row.addWidget(self.box, 3)
        return row

    def build_buttons(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(8)
        self.region = TissueBox(self)
        self.region.setObjectName("tissue_region")
        self.region.setAccessibleName(tr("Where the tissue is used"))
        self.region.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.region.addItem(tr("All of the organ"), "")
        self.take = QPushButton(tr("Use"), self)
        self.take.setObjectName("use_tissue")
        self.take.setToolTip(tr("Use the constants of this tissue"))
        self.take.clicked.connect(self.use_tissue)
        self.show_button = QPushButton(tr("Values…"), self)
        self.show_button.setObjectName("show_published")
        self.show_button.setToolTip(tr("What the literature says, and what you add to it"))
        self.show_button.clicked.connect(self.show_values)
        row.addWidget(self.region, 1)
        row.addWidget(self.take)
        row.addWidget(self.show_button)
        return row

    # ------------------------------------------------------------ showing

    def fill(self, words: str) -> None:
        """The tissues that have every word; all where none has."""
        chosen = self.chosen()
        found = search(self.known, words, self.titles)
        set_tone(self.words, "" if found else "bad")
        self.tissues = found or self.known
        self.box.blockSignals(True)
        self.box.clear()
        self.box.addItems([self.titles[tissue.name] for tissue in self.tissues])
        self.box.setCurrentIndex(self.tissues.index(chosen) if chosen in self.tissues else 0)
        self.box.blockSignals(False)
        if self.chosen() is not chosen:
            self.change_tissue()

    def chosen(self) -> LibraryTissue | None:
        row = self.box.currentIndex()
        return self.tissues[row] if 0 <= row < len(self.tissues) else None

    def show_organ(self, organ: Organ) -> None:
        """The regions that can be given a tissue of their own; of another organ, its tissue."""
        if organ.name != self.shown_name:
            self.shown_name = organ.name
            own = find_named(self.tissues, organ.name)
            if own is not None:
                self.box.setCurrentIndex(self.tissues.index(own))
        names = [name for name, ids in organ.regions.items() if ids.size]
        known = [self.region.itemData(row) for row in range(1, self.region.count())]
        if names != known:
            chosen = self.region.currentData()
            while self.region.count() > 1:
                self.region.removeItem(1)
            for name in names:
                self.region.addItem(tr("Region {name}").format(name=name), name)
            self.region.setCurrentIndex(max(self.region.findData(chosen), 0))

    def change_tissue(self) -> None:
        self.accept.setChecked(False)
        self.show_tissue()

    def show_tissue(self) -> None:
        """What is known of its stiffness, and whether it can be used."""
        tissue = self.chosen()
        if tissue is None:
            return
        numbers = [
            end
            for value in tissue.values_of("young_modulus")
            for end in (value.low, value.high)
            if end is not None
        ]
        said = say_status(tissue.status)
        if numbers:
            span = say_range("young_modulus", min(numbers), max(numbers))
            said = tr("{span} published; {status}").format(span=span, status=said)
        self.about.setText(said[:1].upper() + said[1:] + ".")
        set_tone(self.about, TONES[tissue.status])
        recalled = tissue.status == "recalled"
        self.accept.setVisible(recalled)
        self.take.setEnabled(tissue.status == "checked" or (recalled and self.accept.isChecked()))

    # ------------------------------------------------------------ doing

    def show_values(self) -> None:
        if self.dialog is None:
            self.dialog = PublishedDialog(self.context, self)
        tissue = self.chosen()
        if tissue is not None:
            self.dialog.show_tissue(self.known.index(tissue))

    def use_tissue(self) -> None:
        tissue, region = self.chosen(), self.region.currentData()
        if tissue is None:
            return
        if tissue.shipped is not None and not region:
            shipped = tissue.shipped
            material, model = MaterialPart(**shipped.material), ModelPart(**shipped.model)
            self.context.apply(SetMaterial(material, model, self.titles[tissue.name]))
            return
        try:
            applied = choose(tissue, region, recalled=self.accept.isChecked())
        except Refusal as refused:
            self.context.refuse(refused)
            return
        self.context.apply(SetTissue(applied))
