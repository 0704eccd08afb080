# SPDX-License-Identifier: BSD-3-Clause
"""Who plays, and what they agree to, before a task that is judged."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLineEdit, QWidget

from palpate.player.boards import Board, Choice
from palpate.player.sentences import translate
from palpate.translation import LANGUAGES


class WhoBoard(Board):
    """A code, a new one, a guest, or practice of which nothing is kept."""

    code_entered = Signal(str)
    new_wanted = Signal()
    guest_wanted = Signal()
    practice_wanted = Signal()

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.text = self.add("body")
        self.field = QLineEdit(self.page)
        self.field.setObjectName("code")
        self.field.setMaxLength(8)
        self.field.returnPressed.connect(self._enter)
        self.rows.addWidget(self.field)
        self.go = self.add_button(main=True)
        self.problem = self.add("body")
        self.new, self.guest, self.practice = (self.add_button() for _ in range(3))
        self.languages = Choice(self, list(LANGUAGES))
        self.rows.addWidget(self.languages)
        self.go.clicked.connect(self._enter)
        self.new.clicked.connect(self.new_wanted)
        self.guest.clicked.connect(self.guest_wanted)
        self.practice.clicked.connect(self.practice_wanted)
        self.problem.hide()
        self.say()

    def refuse(self, sentence: str) -> None:
        self.problem.setText(sentence)
        self.problem.setVisible(bool(sentence))

    def press(self) -> None:
        """Enter in the field has been taken by the field."""
        if not self.field.hasFocus():
            super().press()

    def confirm(self) -> None:
        """The code that stands there, while it is being written."""
        if self.field.hasFocus():
            self._enter()
        else:
            self.press()

    def _enter(self) -> None:
        code = self.field.text().strip().upper()
        if code:
            self.code_entered.emit(code)

    def say(self) -> None:
        self.headline.setText(translate("Player", "Who plays?"))
        self.text.setText(
            translate("Player", "Your attempts are kept under a code, without your name.")
        )
        self.field.setPlaceholderText(translate("Player", "Your code"))
        self.field.setAccessibleName(translate("Player", "Your code"))
        self.go.setText(translate("Player", "Go on with this code"))
        self.new.setText(translate("Player", "I have no code yet"))
        self.guest.setText(translate("Player", "As a guest: kept under no code"))
        self.practice.setText(translate("Player", "Practice: nothing is kept"))
        for code, name in LANGUAGES.items():
            self.languages.buttons[code].setText(name)

    def focus(self) -> None:
        self.field.setFocus()


class ConsentBoard(Board):
    """The text that is agreed to, once for each version of it."""

    agreed = Signal()
    declined = Signal()

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.text = self.add("body")
        self.code = self.add("title")
        self.agree = self.add_button(main=True)
        self.decline = self.add_button()
        self.agree.clicked.connect(self.agreed)
        self.decline.clicked.connect(self.declined)
        self._code = ""
        self._language = "en"
        self.say()

    def tell(self, language: str, code: str) -> None:
        """`code` is the one that is drawn for a new person; empty for a guest."""
        self._language, self._code = language, code
        self.say()

    def confirm(self) -> None:
        """Nothing: what is agreed to has to be read, and is not by a hand that tries its stylus."""

    def say(self) -> None:
        self.headline.setText(translate("Player", "What is kept"))
        self.text.setText(find_consent(self._language))
        code = translate("Player", "Your code is %1. Write it down: nobody can find it for you.")
        self.code.setText(code.replace("%1", self._code))
        self.code.setWordWrap(True)
        self.code.setVisible(bool(self._code))
        self.agree.setText(translate("Player", "I agree"))
        self.decline.setText(translate("Player", "I do not: practice, nothing is kept"))


def find_consent(language: str) -> str:
    """It is palpate.records' own, for its hash is kept; that loads SQLAlchemy."""
    from palpate.records.people import CONSENT

    return CONSENT.get(language, CONSENT["en"])
