# SPDX-License-Identifier: BSD-3-Clause
"""A scenario as a card: picture, goal, level, reviews, and the last attempts."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

import palpate
from palpate.assessment.texts import find_text
from palpate.command.verb import Report
from palpate.player.cards import build_label
from palpate.player.debrief import say_goal_bound
from palpate.player.sentences import say_earlier, translate
from palpate.translation.refusals import say_refusal

PICTURE = (300, 200)
"""[px]"""


class ScenarioCard(QFrame):
    """One scenario. What cannot be read says so, and cannot be played."""

    def __init__(self, path: Path, parent: QWidget):
        super().__init__(parent)
        self.setObjectName("board")
        self.path = path
        self.assessment: dict[str, Any] = {}
        self.problem = ""
        self.levels: list[str] = []
        self.words = palpate.scenario.Words()
        column = QVBoxLayout(self)
        self.picture = QLabel(self)
        self.picture.setFixedSize(*PICTURE)
        self.picture.setAlignment(Qt.AlignmentFlag.AlignCenter)
        column.addWidget(self.picture, 0, Qt.AlignmentFlag.AlignHCenter)
        self.title, self.goal, self.reviews, self.last = (
            build_label(name, self, wrap=True) for name in ("title", "body", "caption", "caption")
        )
        for label in (self.title, self.goal, self.reviews, self.last):
            column.addWidget(label)
        column.addStretch(1)
        row = QHBoxLayout()
        self.level = QComboBox(self)
        self.play = QPushButton(self)
        self.play.setObjectName("main")
        row.addWidget(self.level)
        row.addWidget(self.play, 1)
        column.addLayout(row)
        self.read()

    def read(self) -> None:
        try:
            self.scenario = palpate.scenario.read(self.path)
        except OSError as problem:
            self.problem = say_refusal(str(problem))
            return
        self.levels = palpate.scenario.list_levels(self.scenario)
        self.assessment = json.loads(self.scenario.assessment) if self.scenario.assessment else {}
        self.level.addItems(self.levels)
        if "normal" in self.levels:
            self.level.setCurrentText("normal")
        self.level.setVisible(bool(self.levels))

    def say(self, language: str, before: list[Report]) -> None:
        self.play.setText(translate("Player", "Play"))
        self.level.setAccessibleName(translate("Player", "Level"))
        self.play.setEnabled(not self.problem)
        if self.problem:
            self.title.setText(self.path.name)
            self.goal.setText(self.problem)
            return
        words = palpate.scenario.find_words(self.scenario, language)
        title = words.title or self.path.stem
        if self.assessment:
            title = find_text(self.assessment, self.assessment["title"], language)
        self.title.setText(title)
        goals = [say_goal_bound(goal) for goal in self.assessment.get("goals", [])]
        free = translate("Player", "To feel: nothing is judged.")
        self.goal.setText("\n".join(goals) if self.assessment else free)
        self.reviews.setText(self.say_reviews())
        self.last.setText("\n".join(map(say_earlier, before)))

    def say_reviews(self) -> str:
        rows = self.assessment.get("reviews", [])
        if not rows:
            return translate("Player", "Reviewed by nobody yet")
        text = translate("Player", "Reviewed: %1")
        return text.replace("%1", ", ".join(f"{row['of']} ({row['role']})" for row in rows))
