# SPDX-License-Identifier: BSD-3-Clause
"""The scenarios of a folder as cards, once it is known who plays."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QCloseEvent, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from palpate.command.verb import Report
from palpate.device.names import POINTER, split_hand
from palpate.files.refusal import Refusal
from palpate.player.boards import Board
from palpate.player.card_pictures import CardPictures
from palpate.player.cards import Notice, build_label
from palpate.player.device_button import DeviceButton
from palpate.player.history_board import HistoryBoard
from palpate.player.identification import Identification
from palpate.player.people_boards import ConsentBoard, WhoBoard
from palpate.player.scenario_card import ScenarioCard
from palpate.player.sentences import translate
from palpate.player.style import build_palette, build_style
from palpate.player.trainee_window import TraineeWindow
from palpate.runs.kept_play import Keeper
from palpate.runs.play import Play, open_play
from palpate.runs.run import PUBLISHED
from palpate.translation.refusals import say_refusal
from palpate.viewport.application import use_language

if TYPE_CHECKING:
    from palpate.records.people import Person

COLUMNS, LETTER = 3, 15.0
LAST = 5
"""Attempts on a card."""


class ScenariosWindow(QWidget):
    """Opens the trainee's window of a card, and comes back when that is closed."""

    def __init__(
        self, folder: Path, theme: str = "dark", language: str = "en", device: str = POINTER
    ):
        super().__init__()
        self.folder, self.theme, self.language = folder, theme, language
        self.device = device
        self.window_of_play: TraineeWindow | None = None
        self.practising = False
        """Nothing is kept of the person at this window."""
        self.played: Counter[str] = Counter()
        """How often each file was opened from here: what a seed counts where nothing is kept."""
        self.checked: Report | None = None
        """What the check of their device has found."""
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
        self._build_boards()
        self.setPalette(build_palette(theme))
        self.setStyleSheet(build_style(theme, LETTER))
        self.resize(1100, 760)
        self.say()
        self.pictures = CardPictures(self.cards, theme, self)
        self.button = DeviceButton(split_hand(device)[0], self)
        self.button.pressed.connect(self._take_offer)
        self.button.listen()
        if any(card.assessment for card in self.cards):
            self.show_board(self.who)

    def _build_boards(self) -> None:
        self.history, self.who = HistoryBoard(self), WhoBoard(self)
        self.consent = ConsentBoard(self)
        self.boards: tuple[Board, ...] = self.who, self.consent, self.history
        self.history.back.clicked.connect(self.hide_board)
        self.who.languages.choose(self.language)
        self.who.languages.chosen.connect(self.use_language)
        self.identification = Identification(
            self.who, self.consent, self.show_board, self._find_language, self
        )
        self.identification.identified.connect(self._welcome)
        self.identification.practising.connect(self._practise)

    def _find_language(self) -> str:
        return self.language

    def use_language(self, code: str) -> None:
        """One of palpate.translation.LANGUAGES."""
        self.language = code
        use_language(code)
        self.say()
        board = self.board()
        if board is not None:
            self.show_board(board)

    # ------------------------------------------------------------ who

    @property
    def person(self) -> Person | None:
        """Whose attempts are kept; None before that is known, and while it is practised."""
        return None if self.practising else self.identification.person

    def _welcome(self) -> None:
        self.practising = False
        self.hide_board()
        self.say()

    def _practise(self) -> None:
        self.practising = True
        self.hide_board()
        self.say()

    def say(self) -> None:
        self.setWindowTitle("Palpate")
        self.headline.setText(translate("Player", "Scenarios"))
        self.see_history.setText(translate("Player", "History"))
        self.see_history.setVisible(self.person is not None)
        for board in self.boards:
            board.say()
        self.notice.say()
        for card in self.cards:
            card.say(self.language, self._list_before(card))
        if not self.cards:
            text = translate("Player", "No published scenarios in %1")
            self._tell(text.replace("%1", str(self.folder)))

    def _list_before(self, card: ScenarioCard) -> list[Report]:
        """The last attempts of the person."""
        return self._list_attempts(card)[:LAST]

    def _list_attempts(self, card: ScenarioCard) -> list[Report]:
        person, store = self.person, self.identification.store
        if person is None or person.code is None or store is None or not card.assessment:
            return []
        from palpate.records.queries import list_attempts

        return list_attempts(store, person.code, scenario_id=card.assessment["id"])

    def choose_seed(self, card: ScenarioCard) -> int:
        """Practice counts up, so that nobody learns where a thing is hidden."""
        return max(len(self._list_attempts(card)), self.played[str(card.path)])

    def _tell(self, sentence: str) -> None:
        self.problem.setText(sentence)
        self.problem.setVisible(bool(sentence))

    # ------------------------------------------------------------ boards

    def show_history(self) -> None:
        """All attempts of the person."""
        person, store = self.person, self.identification.store
        if person is None or store is None:
            return
        from palpate.records.queries import list_history

        rows = [] if person.code is None else list_history(store, person.code)
        self.history.tell(rows, self.theme)
        self.show_board(self.history)

    def board(self) -> Board | None:
        """The one that is shown."""
        return next((board for board in self.boards if not board.isHidden()), None)

    def show_board(self, board: Board | None) -> None:
        """Over the cards, which wait for it."""
        for other in self.boards:
            other.setVisible(other is board)
        for card in self.cards:
            card.setEnabled(board is None)
        self.see_history.setEnabled(board is None)
        self._place_boards()
        if board is not None:
            board.focus()

    def hide_board(self) -> None:
        self.show_board(None)
        if self.cards:
            self.cards[0].play.setFocus()

    def _place_boards(self) -> None:
        wide = min(640, self.width() - 40)
        for board in self.boards:
            high = board.fit(wide, max(self.notice.y() - 20, 100))
            top = max(10, (self.notice.y() - high) // 2)
            board.setGeometry((self.width() - wide) // 2, top, wide, high)
            board.raise_()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_boards()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter presses the button that has the keyboard, Esc closes what is open."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._take_offer(device=False)
        elif event.key() == Qt.Key.Key_Escape:
            if self.board() is self.history:
                self.hide_board()
            else:
                self.close()
        else:
            super().keyPressEvent(event)

    def _take_offer(self, device: bool = True) -> None:
        """Enter, or the button of the device."""
        board, button = self.board(), self.focusWidget()
        if board is not None:
            board.confirm() if device else board.press()
        elif isinstance(button, QPushButton):
            button.click()

    # ------------------------------------------------------------ playing

    def _play(self) -> None:
        self.open(self.cards[self.sender().property("number")])

    def open(self, card: ScenarioCard) -> None:
        """The trainee's window of a card, for the person at this window."""
        self._tell("")
        self.button.rest()
        try:
            level, seed = card.level.currentText(), 0
            if card.assessment:
                seed = self.choose_seed(card)
                self.played[str(card.path)] = seed + 1
            play = open_play(card.path, self.device, level=level, seed=seed)
            self.window_of_play = window = TraineeWindow(play, self.theme, self.language)
            if play.drawn is not None:
                self._admit(window, play)
        except (OSError, Refusal) as problem:
            self._tell(say_refusal(str(problem)))
            self.button.listen()
            return
        window.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose, False)
        window.closed.connect(self._come_back)
        window.show()
        self.hide()

    def _admit(self, window: TraineeWindow, play: Play) -> None:
        """It is known already who plays."""
        admission, store = window.attendance.admission, self.identification.store
        admission.checked = self.checked
        if self.person is not None and store is not None:
            admission.use(Keeper(store, self.person, play))
        elif self.practising:
            admission.practise()

    def _come_back(self) -> None:
        window = self.window_of_play
        if window is not None:
            self.checked = window.attendance.admission.checked
            self.language = window.language
        self.say()
        self.show()
        self.button.listen()

    def closeEvent(self, event: QCloseEvent) -> None:
        self.pictures.close()
        self.button.rest()
        super().closeEvent(event)
