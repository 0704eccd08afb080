# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of a chart: the plot, the row that was clicked on, and where a chart comes from."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from palpate.study.chart_file import read_chart, write_chart
from palpate.study.scene_chart import Chart, Configuration, Row
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from palpate_editor.advice_words import describe_advised
from palpate_editor.chart_fit import find_difference, find_present, find_wanted
from palpate_editor.chart_words import describe_chart
from palpate_editor.configuration import name_configuration
from palpate_editor.document import Organ
from palpate_editor.edits import Configure
from palpate_editor.views.chart.advisor import Advisor
from palpate_editor.views.chart.chart_plot import ChartPlot
from palpate_editor.views.chart.row_card import RowCard
from palpate_editor.views.chart.work_bar import WorkBar
from palpate_editor.views.context import Context
from palpate_editor.views.elided_label import ElidedLabel
from palpate_editor.views.files import Files
from palpate_editor.views.jobs import Progress
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.translations import say, tr

if TYPE_CHECKING:  # it loads SciPy
    from palpate_editor.advise import Advised


class ReadWork:
    """Reads a chart's file."""

    def __init__(self, path: Path):
        self.path = path

    def __call__(self, progress: Progress) -> Chart:
        progress(tr("Opening {file}").format(file=self.path.name), 0.3)
        return read_chart(self.path)


class ChartView(QWidget):
    """Shows one chart, whatever it was drawn for, and says where it is not of the organ."""

    opened = Signal()
    """There is another chart to look at."""

    def __init__(
        self,
        context: Context,
        tasks: Tasks,
        files: Files,
        advisor: Advisor,
        parent: QWidget | None = None,
    ):
        super().__init__(parent)
        self.setObjectName("chart_view")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.context, self.tasks, self.files, self.advisor = context, tasks, files, advisor
        self.chart: Chart | None = None
        self.advised: Advised | None = None
        """What was advised of this chart last."""
        self.plot = ChartPlot(self.name_row, self)
        self.plot.chosen.connect(self.show_row)
        self.card = RowCard(self)
        self.card.wanted.connect(self.apply_row)
        middle = QHBoxLayout()
        middle.setSpacing(0)
        middle.addWidget(self.plot, 1)
        middle.addWidget(self.card)
        self.bar = self.build_bar()
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 4, 4, 4)
        column.setSpacing(2)
        column.addLayout(self.bar)
        column.addLayout(middle, 1)
        context.session.changed.connect(self.on_changed)
        advisor.drawn.connect(self.show_chart)
        advisor.advised.connect(self.show_advised)
        self.show_chart(None)

    def build_bar(self) -> QHBoxLayout:
        bar = QHBoxLayout()
        bar.setSpacing(8)
        self.summary = ElidedLabel(self)
        self.summary.setObjectName("chart_summary")
        self.work = WorkBar(self.advisor, self)
        self.draw_button = QPushButton(tr("Draw the chart"), self)
        self.draw_button.setObjectName("draw_chart")
        self.draw_button.clicked.connect(self.advisor.draw)
        self.advisor.began.connect(self.show_busy)
        self.advisor.ended.connect(self.show_busy)
        self.open_button = QPushButton(tr("Open a chart…"), self)
        self.open_button.setObjectName("open_chart")
        self.open_button.clicked.connect(self.ask_open)
        self.save_button = QPushButton(tr("Save the chart…"), self)
        self.save_button.setObjectName("save_chart")
        self.save_button.clicked.connect(self.ask_save)
        bar.addWidget(self.summary, 1)
        bar.addWidget(self.work)
        for button in (self.draw_button, self.open_button, self.save_button):
            button.setProperty("small", True)
        bar.addWidget(self.draw_button)
        bar.addWidget(self.open_button)
        bar.addWidget(self.save_button)
        return bar

    # ------------------------------------------------------------ showing

    def show_chart(self, chart: Chart | None) -> None:
        if chart is None or self.chart is None or chart.key != self.chart.key:
            self.advised = None
            self.card.show_nothing()
        self.chart = chart
        self.plot.show_chart(chart)
        self.save_button.setEnabled(chart is not None)
        self.show_present()

    def show_present(self) -> None:
        """What depends on the organ: its row, and whether the chart is of it."""
        organ, chart = self.context.session.organ, self.chart
        if chart is None:
            self.summary.setText("")
            return
        difference = None if organ.surface is None else find_difference(chart, organ)
        words = describe_chart(chart) if difference is None else difference
        self.summary.setText(str(say(words)))
        present = None if difference is not None else find_present(chart.rows, organ)
        self.plot.show_present(None if present is None else present.number)
        if self.card.row is not None:
            self.show_row(self.card.row.number)

    def show_row(self, number: int) -> None:
        """In words, with a ring around its point."""
        row = self.plot.find_row(number)
        if row is None or self.chart is None:
            return
        self.plot.select(number)
        organ, advised, more = self.context.session.organ, self.advised, []
        choice = None if advised is None else advised.advice.choice
        if advised is not None and choice is not None and choice.row.number == number:
            more = describe_advised(advised, self.chart, organ)
        self.card.show_row(row, self.chart, organ, more)

    def show_advised(self, advised: Advised) -> None:
        """The choice, with a ring around it and in words."""
        self.advised = advised
        choice = advised.advice.choice
        self.plot.advise(None if choice is None else choice.row.number)
        if choice is not None:
            self.show_row(choice.row.number)
        self.opened.emit()

    def show_busy(self) -> None:
        self.draw_button.setDisabled(self.advisor.is_busy)

    def name_row(self, row: Row) -> str:
        return name_configuration(row.configuration, self.context.session.organ)

    def on_changed(self, before: Organ, after: Organ) -> None:
        del before, after
        self.show_present()

    # ------------------------------------------------------------ doing

    def apply_row(self, number: int) -> None:
        """One edit, one step to undo; a coarser surface is made beside the window."""
        row, organ = self.plot.find_row(number), self.context.session.organ
        if row is None or self.chart is None:
            return
        difference = find_difference(self.chart, organ)
        if difference is not None and organ.surface is not None:
            self.context.tell(str(say(difference)), "warning")
            return
        edit = Configure(self.find_configuration(row, organ))
        if edit.configuration.vertices in (0, organ.vertex_count):
            self.context.apply(edit)
        else:
            self.tasks.apply_slowly(edit)

    def find_configuration(self, row: Row, organ: Organ) -> Configuration:
        """The row's; of one that is advised with the steps that were advised."""
        choice = None if self.advised is None else self.advised.advice.choice
        if choice is not None and choice.row.number == row.number:
            row = replace(row, configuration=choice.configuration)
        return find_wanted(row, organ)

    def ask_open(self) -> None:
        filters = [tr("Charts (*.json)"), tr("All files (*)")]
        self.files.ask(tr("Open a chart"), filters, self.open_name)

    def open_name(self, name: str) -> None:
        self.open(Path(name))

    def open(self, path: Path) -> None:
        """Reads it beside the window."""
        title = tr("Opening {file}").format(file=path.name)
        self.context.jobs.start_unseen(title, ReadWork(path), self.on_read, self.context.refuse)

    def on_read(self, chart: Chart) -> None:
        self.advisor.use_chart(chart)
        self.show_chart(chart)
        self.opened.emit()

    def ask_save(self) -> None:
        filters = [tr("Charts (*.json)")]
        name = f"{self.context.stem()}.chart.json"
        self.files.ask(tr("Save the chart"), filters, self.save_name, save=name)

    def save_name(self, name: str) -> None:
        if self.chart is None:
            return
        path = Path(name)
        try:
            write_chart(path, self.chart)
        except OSError as problem:
            self.context.refuse(problem)
            return
        self.context.tell(tr("Saved as {file}.").format(file=path.name), "info")
