# SPDX-License-Identifier: BSD-3-Clause
"""The self-test: check by check, and a report to keep."""

from __future__ import annotations

import queue
from pathlib import Path

from PySide6.QtWidgets import QCheckBox, QFileDialog, QGridLayout, QLabel, QWidget

from palpate.command.verb import Report
from palpate.device.link import Ended, Link
from palpate.device.selftest import Check, inspect_link, write_selftest
from palpate.device_window.cards import Page, build_button
from palpate.device_window.job import Job
from palpate.device_window.sentences import say, translate
from palpate.player.cards import build_label
from palpate.translation.refusals import say_refusal


class SelftestPage(Page):
    """Runs the self-test in a thread of its own and shows each check as it is made."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.link: Link | None = None
        self.job: Job | None = None
        self.report: Report | None = None
        self.checks: list[Check] = []
        self._made: queue.SimpleQueue[Check] = queue.SimpleQueue()
        self._problem = ""
        self.card = card = self.add_card()
        self.headline, self.explained = card.add("headline", wrap=True), card.add("faint", True)
        self.motors = QCheckBox(card)
        self.motors.setChecked(True)
        card.rows.addWidget(self.motors)
        self.start, self.save = build_button(card, main=True), build_button(card)
        card.add_row(self.start, self.save)
        self.list_card = self.add_card()
        self.grid = QGridLayout()
        self.grid.setHorizontalSpacing(8)
        self.grid.setVerticalSpacing(3)
        self.grid.setColumnStretch(1, 1)
        self.list_card.rows.addLayout(self.grid)
        self.column.addStretch(1)
        self.start.clicked.connect(self.begin)
        self.save.clicked.connect(self.choose_file)
        self.show_link(None)

    @property
    def busy(self) -> bool:
        return self.job is not None

    def show_link(self, link: Link | None) -> None:
        self.link = link
        if link is None and self.job is not None:
            self.job.wait()
            self.job = None
        self.say()

    def begin(self) -> None:
        """Tests the device; the stylus has to be held."""
        if self.link is None or self.busy:
            return
        self.report, self.checks, self._problem = None, [], ""
        link, motors, tell = self.link, self.motors.isChecked(), self._made.put
        self.job = Job(lambda: inspect_link(link, motors, tell))
        self.say()

    def follow(self) -> None:
        """Shows what was tested meanwhile."""
        news = False
        while not self._made.empty():
            self.checks.append(self._made.get())
            news = True
        job = self.job
        if job is not None and job.done and self._made.empty():
            self.job, self.report, news = None, job.result, True
            if job.problem is not None and not isinstance(job.problem, Ended):
                self._problem = say_refusal(str(job.problem))
        if news:
            self.say()
            # the newest is in sight while they come, the verdict afterwards
            self.widget().adjustSize()
            bar = self.verticalScrollBar()
            bar.setValue(bar.maximum() if self.busy else 0)

    def choose_file(self) -> None:
        name, _ = QFileDialog.getSaveFileName(
            self,
            translate("Device", "Save the report"),
            "selftest.txt",
            translate("Device", "Text (*.txt);;JSON (*.json)"),
        )
        if name:
            self.write(Path(name))

    def write(self, path: Path) -> None:
        """The report as text, or as JSON where the name ends so."""
        if self.report is None:
            return
        try:
            write_selftest(path, self.report)
            text = translate("Device", "Saved: %1").replace("%1", str(path))
        except OSError as problem:
            text = translate("Device", "Could not be saved: %1")
            text = text.replace("%1", say_refusal(str(problem)))
        self.explained.setText(text)

    def say(self) -> None:
        """Sets all texts."""
        self.card.title.setText(translate("Device", "SELF-TEST"))
        self.headline.setText(self._say_verdict())
        self.explained.setText(
            self._problem
            or translate(
                "Device",
                "Hold the stylus in the middle of its reach. The motors push it gently, each way "
                "in turn; then this computer falls silent on purpose, and they have to stop.",
            )
        )
        self.motors.setText(translate("Device", "With motors"))
        self.start.setText(
            translate("Device", "Testing…") if self.busy else translate("Device", "Start the test")
        )
        self.save.setText(translate("Device", "Save the report…"))
        self.start.setEnabled(self.link is not None and not self.busy)
        self.motors.setEnabled(not self.busy)
        self.save.setEnabled(self.report is not None)
        self.list_card.title.setText(translate("Device", "CHECKS"))
        self.list_card.setVisible(bool(self.checks))
        self._fill()

    def _say_verdict(self) -> str:
        if self.report is None:
            return translate("Device", "Is it sound?")
        if self.report["ok"]:
            return translate("Device", "It is sound")
        return translate("Device", "It failed a check: do not let it push anyone")

    def _fill(self) -> None:
        while self.grid.count():
            item = self.grid.takeAt(0)
            if item is not None and item.widget() is not None:
                item.widget().deleteLater()
        for row, check in enumerate(self.checks):
            mark = build_label("good" if check.ok else "bad", self.list_card)
            mark.setText("\N{CHECK MARK}" if check.ok else "\N{BALLOT X}")
            name: QLabel = build_label("number" if not check.ok else "", self.list_card)
            name.setText(say(check.name))
            detail = build_label("faint", self.list_card, wrap=True)
            detail.setText(say(check.detail))
            self.grid.addWidget(mark, 2 * row, 0)
            self.grid.addWidget(name, 2 * row, 1)
            self.grid.addWidget(detail, 2 * row + 1, 1)
