# SPDX-License-Identifier: GPL-3.0-or-later
"""What was done, as command lines, and all problems of the organ, in two tabs."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QFont
from PySide6.QtWidgets import (
    QHeaderView,
    QPlainTextEdit,
    QTabWidget,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)

from palpate_editor.document.problems import SEVERITIES, Problem
from palpate_editor.views.context import Context
from palpate_editor.views.icons import plain_icon
from palpate_editor.views.theme import fixed_font
from palpate_editor.views.translations import say, say_got, tr

LINES = 2000
"""Kept in the log."""
SIGNS = {"error": ("cross", "bad"), "warning": ("warning", "warning"), "note": ("info", "faint")}
STAGE = Qt.ItemDataRole.UserRole


class LogDock(QTabWidget):
    """Log and problems."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.setDocumentMode(True)
        self.log = QPlainTextEdit(self)
        self.log.setObjectName("log")
        self.log.setReadOnly(True)
        self.log.setMaximumBlockCount(LINES)
        self.log.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.log.setFont(fixed_font(QFont(self.font())))
        self.log.setPlaceholderText(tr("What you do appears here as a command line."))
        self.problems = QTreeWidget(self)
        self.problems.setObjectName("problems")
        self.problems.setRootIsDecorated(False)
        self.problems.setIconSize(QSize(16, 16))
        self.problems.setHeaderLabels([tr("Stage"), tr("Found"), tr("Expected")])
        header = self.problems.header()
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(2, QHeaderView.ResizeMode.Stretch)
        self.problems.itemActivated.connect(self.go)
        self.problems.itemClicked.connect(self.go)
        self.addTab(self.problems, tr("Problems"))
        self.addTab(self.log, tr("Log"))
        context.command_logged.connect(self.add_command)
        context.remarked.connect(self.add_remark)
        context.told.connect(self.add_sentence)
        context.assessed.connect(self.fill_problems)
        context.theme_changed.connect(self.on_theme)

    def add_command(self, line: str) -> None:
        self.log.appendPlainText(f"{datetime.now():%H:%M:%S}  $ {line}")

    def add_remark(self, text: str) -> None:
        """Behind the sign that a shell passes over."""
        self.log.appendPlainText(f"{datetime.now():%H:%M:%S}  # {text}")

    def add_sentence(self, sentence: str, severity: str) -> None:
        sign = {"error": "✗", "warning": "!", "info": "·"}[severity]
        self.log.appendPlainText(f"{datetime.now():%H:%M:%S}  {sign} {sentence}")

    def on_theme(self, theme: str) -> None:
        del theme
        self.fill_problems()

    def fill_problems(self) -> None:
        assessment, stages = self.context.assessment, self.context.stages
        problems = [] if assessment is None else sorted(assessment.problems, key=self.rank)
        self.problems.clear()
        for problem in problems:
            text = [stages.title(problem.stage), say_got(problem), say(problem.expected)]
            item = QTreeWidgetItem(text)
            sign, colour = SIGNS[problem.severity]
            item.setIcon(0, plain_icon(sign, getattr(self.context.colours, colour)))
            item.setData(0, STAGE, problem.stage)
            for column in (1, 2):
                item.setToolTip(column, text[column])
            self.problems.addTopLevelItem(item)
        title = tr("Problems") if not problems else f"{tr('Problems')} ({len(problems)})"
        self.setTabText(0, title)

    def go(self, item: QTreeWidgetItem) -> None:
        self.context.show_stage(item.data(0, STAGE))

    def rank(self, problem: Problem) -> tuple[int, int]:
        """The gravest first, then as the stages follow each other."""
        return SEVERITIES.index(problem.severity), self.context.stages.place(problem.stage)
