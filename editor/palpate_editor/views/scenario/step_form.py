# SPDX-License-Identifier: GPL-3.0-or-later
"""The form of one step: verb, place, bands, dwell, and what it says."""

from __future__ import annotations

from palpate.assessment import author, author_tools
from palpate.assessment.author import Json
from PySide6.QtCore import Signal
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from palpate_editor.views.scenario.band_row import BandRow, NumberRow
from palpate_editor.views.scenario.task_draft import TaskDraft
from palpate_editor.views.scenario.words import say_verb
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import tr

POINT, PATH = "point", "path"
OF_VERB = {
    "hold": ("force_N", "depth_m"), "push": ("force_N", "depth_m"),
    "pull": ("force_N", "distance_m"), "trace": ("force_N",), "find": ("force_N",),
}  # fmt: skip
"""Which bands a verb may have."""
LASTING = ("touch", "hold", "push", "pull", "grasp", "release", "look", "remove", "carry")
RECORDED = ("hold", "push", "trace", "find")
"""Verbs whose band can be taken from a hand that presses."""


class Choice(QComboBox):
    """A wheel that scrolls the form must not change it on the way."""

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()


class StepForm(QWidget):
    """What is written here is an edit at once."""

    draw_wanted = Signal(str)
    """POINT or PATH is to be drawn on the organ; empty for no more."""
    record_wanted = Signal()

    def __init__(self, draft: TaskDraft, parent: QWidget | None = None):
        super().__init__(parent)
        self.draft = draft
        self._writing = False
        self.labels: dict[str, QLabel] = {}
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(7)
        self.verb = self._choice("step_verb", tr("What is to be done"), column)
        self.verb.activated.connect(self._set_verb)
        self.place = self._choice("step_place", tr("Where"), column)
        self.place.activated.connect(self._set_place)
        self.tool = self._choice("step_tool", tr("With which instrument"), column)
        self.tool_label = self.labels["step_tool"]
        self.tool.activated.connect(self._set_tool)
        column.addLayout(self._build_draw())
        self.bands = {
            "force_N": BandRow("force", tr("Force"), "N", 1.0, 0.05, 100, self),
            "depth_m": BandRow("depth", tr("Depth"), "mm", 1e-3, 0.5, 60, self),
            "distance_m": BandRow("distance", tr("Pulled distance"), "mm", 1e-3, 0.5, 80, self),
        }
        for key, row in self.bands.items():
            row.setProperty("member", key)
            row.entered.connect(self._set_band)
            column.addWidget(row)
        self.share = NumberRow("share", tr("Share of the line"), "%", 0.01, 5.0, 20, self)
        self.share.entered.connect(self._set_share)
        self.lasting = NumberRow("for_s", tr("Kept for"), "s", 1.0, 0.5, 40, self)
        self.lasting.entered.connect(self._set_lasting)
        self.record = QPushButton(tr("Record from my hand"), self)
        self.record.setObjectName("record_hand")
        self.record.setCheckable(True)
        self.record.setToolTip(
            tr("Do it once with the mouse: the band is what was felt, 20 % less to 20 % more")
        )
        self.record.clicked.connect(self.record_wanted)
        for widget in (self.share, self.lasting, self.record):
            column.addWidget(widget)
        draft.shown.connect(self.show_draft)

    def _choice(self, name: str, text: str, column: QVBoxLayout) -> Choice:
        label = write_label(text, "name", self)
        box = Choice(self)
        box.setObjectName(name)
        box.setAccessibleName(text)
        column.addWidget(label)
        column.addWidget(box)
        self.labels[name] = label
        return box

    def _build_draw(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(6)
        self.draw: dict[str, QPushButton] = {}
        for kind, text, tip in (
            (POINT, tr("Click a point"), tr("A ball of 10 mm around a point of the organ")),
            (PATH, tr("Draw a line"), tr("Click along the organ; Enter or a double click ends it")),
        ):
            button = QPushButton(text, self)
            button.setObjectName(f"draw_{kind}")
            button.setProperty("small", True)
            button.setProperty("kind", kind)
            button.setCheckable(True)
            button.setToolTip(tip)
            button.clicked.connect(self._draw)
            row.addWidget(button, 1)
            self.draw[kind] = button
        return row

    # ------------------------------------------------------------ showing

    def show_draft(self) -> None:
        step = self.draft.step
        self.setVisible(step is not None)
        if step is None:
            return
        self._writing = True
        verb = str(step.get("do"))
        self.verb.clear()
        for each in self.draft.verbs:
            self.verb.addItem(say_verb(each), each)
        self.verb.setCurrentIndex(max(self.verb.findData(verb), 0))
        self._list_places(step)
        self._list_tools(step)
        wanted = OF_VERB.get(verb, ())
        for key, row in self.bands.items():
            row.setVisible(key in wanted)
            row.show_band(step.get(key, [None, None]))
        self.share.setVisible(verb == "trace")
        self.share.show_value(step.get("share", 1.0))
        self.lasting.setVisible(verb in LASTING)
        self.lasting.show_value(step.get("for_s", 0.0))
        self.record.setVisible(verb in RECORDED and self.draft.records)
        self.draw[PATH].setVisible(self.draft.records)
        self._writing = False

    def _list_places(self, step: Json) -> None:
        """The places there are, and the regions of the organ that are none yet."""
        draft = self.draft
        self.place.clear()
        for name in draft.places:
            self.place.addItem(draft.name_place(name), name)
        regions = {draft.name_region(place) for place in draft.places.values()}
        for region in draft.regions:
            if region not in regions:
                self.place.addItem(region, f"region:{region}")
        at = str(step.get("at", ""))
        if at.startswith("$"):
            self.place.insertItem(0, at, at)
        self.place.setCurrentIndex(self.place.findData(at))
        self.place.setEnabled(str(step.get("do")) != "release" or bool(at))

    def _list_tools(self, step: Json) -> None:
        """Where there is a choice."""
        tools = self.draft.tools
        self.tool.clear()
        for name in tools:
            self.tool.addItem(name, name)
        self.tool.setCurrentIndex(self.tool.findData(step.get("tool", next(iter(tools), ""))))
        for widget in (self.tool, self.tool_label):
            widget.setVisible(len(tools) > 1)

    def end_drawing(self) -> None:
        for button in self.draw.values():
            button.setChecked(False)

    # ------------------------------------------------------------ changing

    def _set_verb(self) -> None:
        verb = self.verb.currentData()
        values: Json = {"do": verb}
        step = self.draft.step
        if step is not None and "at" not in step and verb != "release":
            made, at = self.draft.find_usual_place(verb)
            self.draft.apply(author.change_step(made, step["id"], {**values, "at": at}), "change")
            return
        self.draft.set_step(values)

    def _set_place(self) -> None:
        chosen = str(self.place.currentData())
        if chosen.startswith("region:"):
            region = chosen.partition(":")[2]
            self.draft.set_place(region, self.draft.of_region(region))
        elif self.draft.assessment is not None:
            self.draft.set_at(self.draft.assessment, chosen)

    def _set_tool(self) -> None:
        if self.draft.step is not None:
            tool = str(self.tool.currentData())
            self.draft.change("tool", author_tools.give_step, self.draft.step["id"], tool)
            self.draft.shown.emit()  # what was refused is shown as it was

    def _set_band(self, band: list[float | None]) -> None:
        if not self._writing:
            key = self.sender().property("member")
            self.draft.set_step({key: band})

    def _set_share(self, share: float) -> None:
        self.draft.set_step({"share": share})

    def _set_lasting(self, seconds: float) -> None:
        self.draft.set_step({"for_s": seconds if seconds > 0.0 else None})

    def _draw(self) -> None:
        button = self.sender()
        assert isinstance(button, QPushButton)
        kind = str(button.property("kind"))
        for other in self.draw.values():
            if other is not button:
                other.setChecked(False)
        self.draw_wanted.emit(kind if button.isChecked() else "")
