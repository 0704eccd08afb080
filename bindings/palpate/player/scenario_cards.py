# SPDX-License-Identifier: BSD-3-Clause
"""The scenarios of a folder as cards: picture, goal, level, reviews, and the last attempts."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from PySide6.QtCore import QProcess, Qt
from PySide6.QtGui import QCloseEvent, QKeyEvent, QPixmap, QResizeEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

import palpate
from palpate.assessment.texts import find_text
from palpate.command.verb import Report
from palpate.device.names import POINTER
from palpate.files.refusal import Refusal
from palpate.player.cards import Notice, build_label
from palpate.player.debrief import say_goal_bound
from palpate.player.history_board import HistoryBoard
from palpate.player.sentences import say_earlier, translate
from palpate.player.style import build_palette, build_style
from palpate.player.trainee_window import TraineeWindow
from palpate.runs.kept_play import Keeper
from palpate.runs.play import open_play
from palpate.runs.run import PUBLISHED
from palpate.scene.scene_file import hash_file
from palpate.system.data_folder import find_cache_folder
from palpate.system.isolated import build_verb
from palpate.translation.refusals import say_refusal

COLUMNS, LETTER = 3, 15.0
PICTURE = (300, 200)
"""[px]"""
LAST = 5


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


class ScenariosWindow(QWidget):
    """Opens the trainee's window of a card, and comes back when that is closed."""

    def __init__(
        self, folder: Path, theme: str = "dark", language: str = "en", device: str = POINTER
    ):
        super().__init__()
        self.folder, self.theme, self.language = folder, theme, language
        self.device = device
        self.window_of_play: TraineeWindow | None = None
        self.keeper: Keeper | None = None
        """Who played last: the next card asks them nothing."""
        self.checked: Report | None = None
        """What the check of their device has found."""
        self._waiting: list[ScenarioCard] = []
        self._drawing = QProcess(self)
        self._drawing.finished.connect(self._show_picture)
        column = QVBoxLayout(self)
        self.headline = build_label("headline", self)
        self.see_history = QPushButton(self)
        self.see_history.clicked.connect(self.show_history)
        top = QHBoxLayout()
        top.addWidget(self.headline, 1)
        top.addWidget(self.see_history)
        column.addLayout(top)
        self.problem = build_label("body", self, wrap=True)
        self.problem.hide()
        column.addWidget(self.problem)
        area = QScrollArea(self)
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        page = QWidget()
        page.setObjectName("page")
        grid = QGridLayout(page)
        grid.setSpacing(16)
        area.setWidget(page)
        area.viewport().setAutoFillBackground(False)
        page.setAutoFillBackground(False)
        column.addWidget(area, 1)
        self.notice = Notice(self)
        column.addWidget(self.notice, 0, Qt.AlignmentFlag.AlignLeft)
        self.cards = [ScenarioCard(path, page) for path in sorted(folder.glob(f"*{PUBLISHED}"))]
        for number, card in enumerate(self.cards):
            card.play.setProperty("number", number)
            card.play.clicked.connect(self._play)
            grid.addWidget(card, number // COLUMNS, number % COLUMNS)
        for number in range(COLUMNS):
            grid.setColumnStretch(number, 1)
        grid.setRowStretch(len(self.cards) // COLUMNS + 1, 1)
        self.history = HistoryBoard(self)
        self.history.back.clicked.connect(self.history.hide)
        self.setPalette(build_palette(theme))
        self.setStyleSheet(build_style(theme, LETTER))
        self.resize(1100, 760)
        self.say()
        self._waiting = [card for card in self.cards if not card.problem]
        self._draw_next()

    def say(self) -> None:
        self.setWindowTitle("Palpate")
        self.headline.setText(translate("Player", "Scenarios"))
        self.see_history.setText(translate("Player", "History"))
        self.see_history.setVisible(self.keeper is not None)
        self.history.say()
        self.notice.say()
        for card in self.cards:
            card.say(self.language, self._list_before(card))
        if not self.cards:
            text = translate("Player", "No published scenarios in %1")
            self._tell(text.replace("%1", str(self.folder)))

    def _list_before(self, card: ScenarioCard) -> list[Report]:
        """Attempts of the person who played last."""
        if self.keeper is None or self.keeper.who.code is None or not card.assessment:
            return []
        from palpate.records.queries import list_attempts

        code = self.keeper.who.code
        return list_attempts(self.keeper.store, code, LAST, card.assessment["id"])

    def _tell(self, sentence: str) -> None:
        self.problem.setText(sentence)
        self.problem.setVisible(bool(sentence))

    def show_history(self) -> None:
        """All attempts of the person who played last."""
        if self.keeper is None:
            return
        self.history.tell(self.keeper.list_history(), self.theme)
        self.history.show()
        self._place_history()
        self.history.focus()

    def _place_history(self) -> None:
        wide = min(640, self.width() - 40)
        high = self.history.fit(wide, self.notice.y() - 20)
        self.history.setGeometry((self.width() - wide) // 2, 10, wide, high)
        self.history.raise_()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_history()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter presses the button that has the keyboard, Esc closes what is open."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            button = self.focusWidget()
            if isinstance(button, QPushButton):
                button.click()
        elif event.key() == Qt.Key.Key_Escape:
            if self.history.isHidden():
                self.close()
            else:
                self.history.hide()
        else:
            super().keyPressEvent(event)

    # ------------------------------------------------------------ playing

    def _play(self) -> None:
        self.open(self.cards[self.sender().property("number")])

    def open(self, card: ScenarioCard) -> None:
        """The trainee's window of a card, for the person who played last where there is one."""
        self._tell("")
        try:
            play = open_play(card.path, self.device, level=card.level.currentText())
            self.window_of_play = window = TraineeWindow(play, self.theme, self.language)
            if self.keeper is not None and play.drawn is not None:
                admission = window.attendance.admission
                admission.checked = self.checked
                admission.use(Keeper(self.keeper.store, self.keeper.who, play))
        except (OSError, Refusal) as problem:
            self._tell(say_refusal(str(problem)))
            return
        window.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose, False)
        window.closed.connect(self._come_back)
        window.show()
        self.hide()

    def _come_back(self) -> None:
        window = self.window_of_play
        if window is not None:
            self.keeper = window.attendance.keeper or self.keeper
            self.checked = window.attendance.admission.checked
            self.language = window.language
        self.say()
        self.show()

    # ------------------------------------------------------------ pictures

    def _draw_next(self) -> None:
        """In a process of its own, one after the other: kept for the next time."""
        while self._waiting:
            card = self._waiting[0]
            path = find_picture(card.path)
            if path.exists():
                self._use_picture(card, path)
                self._waiting.pop(0)
                continue
            path.parent.mkdir(parents=True, exist_ok=True)
            size = f"{2 * PICTURE[0]}x{2 * PICTURE[1]}"
            program, *words = build_verb("render", str(card.path), "-o", str(path))
            words += ["--no-wireframe", "--size", size, "--theme", self.theme]
            self._drawing.start(program, words)
            return

    def _show_picture(self) -> None:
        if not self._waiting:  # the window was closed meanwhile
            return
        card = self._waiting.pop(0)
        self._use_picture(card, find_picture(card.path))
        self._draw_next()

    def _use_picture(self, card: ScenarioCard, path: Path) -> None:
        pixels = QPixmap(str(path))
        if not pixels.isNull():
            kept = Qt.AspectRatioMode.KeepAspectRatio
            smooth = Qt.TransformationMode.SmoothTransformation
            card.picture.setPixmap(pixels.scaled(*PICTURE, kept, smooth))

    def closeEvent(self, event: QCloseEvent) -> None:
        self._waiting = []
        self._drawing.kill()
        self._drawing.waitForFinished(2000)
        super().closeEvent(event)


def find_picture(path: Path) -> Path:
    """Where the picture of a file is kept, by its content."""
    return find_cache_folder() / "pictures" / f"{hash_file(path)}.png"
