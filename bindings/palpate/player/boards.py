# SPDX-License-Identifier: BSD-3-Clause
"""What stands in the middle while nothing runs: the start, the menu, and how it went."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QPushButton, QWidget

import palpate
from palpate.command.verb import Report
from palpate.player.cards import FolderLine, Page, Table
from palpate.player.sentences import (
    format_clock,
    format_number,
    say_earlier,
    say_gestures,
    say_keys,
    say_no_force,
    say_outcome,
    say_stylus,
    translate,
)
from palpate.translation import LANGUAGES
from palpate.viewport.hint_line import PLAIN, Means


class Board(Page):
    """A card with a headline, a few lines, and buttons."""

    def __init__(self, parent: QWidget):
        super().__init__(parent, "board")
        self.rows.setContentsMargins(36, 26, 36, 26)
        self.rows.setSpacing(12)
        self.headline = self.add("headline")
        self.main: QPushButton | None = None
        """The button one most likely wants."""
        self.hide()

    def add_button(self, main: bool = False) -> QPushButton:
        button = QPushButton(self.page)
        if main:
            button.setObjectName("main")
            self.main = button
        button.setCursor(Qt.CursorShape.PointingHandCursor)
        self.rows.addWidget(button)
        return button

    def say(self) -> None:
        """Sets all texts."""

    def focus(self) -> None:
        """Gives the keyboard to the button one most likely wants."""
        if self.main is not None:
            self.main.setFocus()

    def press(self) -> None:
        """Enter: the button that has the keyboard, else the one one most likely wants."""
        focus = self.window().focusWidget()
        chosen = isinstance(focus, QPushButton) and self.isAncestorOf(focus)
        button = focus if chosen else self.main
        if isinstance(button, QPushButton):
            button.click()

    def confirm(self) -> None:
        """The button of the device: as Enter."""
        self.press()


class Choice(QWidget):
    """Buttons in a row of which one is down."""

    chosen = Signal(str)

    def __init__(self, parent: QWidget, codes: Sequence[str]):
        super().__init__(parent)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(10)
        group = QButtonGroup(self)
        self.buttons: dict[str, QPushButton] = {}
        for code in codes:
            button = QPushButton(self)
            button.setCheckable(True)
            button.setProperty("code", code)
            button.setCursor(Qt.CursorShape.PointingHandCursor)
            group.addButton(button)
            row.addWidget(button)
            self.buttons[code] = button
        group.buttonClicked.connect(self._tell)

    def choose(self, code: str) -> None:
        self.buttons[code].setChecked(True)

    def _tell(self, button: QPushButton) -> None:
        self.chosen.emit(button.property("code"))


class StartBoard(Board):
    """The task, how a hand moves, where records go, and the way in."""

    def __init__(
        self, parent: QWidget, folder: Path, has_button: bool = False, means: Means = PLAIN
    ):
        """`has_button`: the hand is on a stylus, whose button is listened to here; `means`: what
        a hand can do with the instrument that it begins with."""
        super().__init__(parent)
        self.task = self.add("body")
        self.rows.addSpacing(4)
        say = say_stylus if has_button else say_gestures
        self.gestures = Table(self, partial(say, means))
        self.rows.addWidget(self.gestures)
        self.rows.addSpacing(4)
        self.limits, self.before = self.add("body"), self.add("caption")
        self.note = self.add("caption")
        for label in (self.limits, self.before, self.note):
            label.hide()
        self.start = self.add_button(main=True)
        self.ghost, self.check, self.history = (self.add_button() for _ in range(3))
        for button in (self.ghost, self.check, self.history):
            button.hide()
        self.languages = Choice(self, list(LANGUAGES))
        self.rows.addWidget(self.languages)
        self._folder: Path | None = folder
        self._brief: tuple[tuple[str, ...], tuple[Report, ...], bool] = ((), (), True)
        self.records = FolderLine(self)
        self.rows.addWidget(self.records)
        self.say()

    def tell_brief(
        self, limits: Sequence[str], before: Sequence[Report], force: bool, folder: Path | None
    ) -> None:
        """Of a task that is judged: its limits, the attempts before, whether force is felt, and
        where runs are kept, None for nowhere.
        """
        self._folder = folder
        self._brief = tuple(limits), tuple(before), force
        self.say()

    def _say_brief(self) -> None:
        limits, before, force = self._brief
        said = translate("Player", "Not allowed:")
        self.limits.setText("\n".join([said, *(f"\N{BULLET} {limit}" for limit in limits)]))
        self.limits.setVisible(bool(limits))
        said = translate("Player", "Attempts before")
        self.before.setText("\n".join([said, *map(say_earlier, before)]))
        self.before.setVisible(bool(before))
        self.note.setText(say_no_force())
        self.note.setVisible(not force)

    def tell(self, title: str, task: str) -> None:
        """What the scenario says of itself."""
        self.headline.setText(title)
        self.task.setText(task)
        self.task.setVisible(bool(task))

    def say(self) -> None:
        self._say_brief()
        self.gestures.say()
        self.start.setText(translate("Player", "Start"))
        self.ghost.setText(translate("Player", "Show me how it is done"))
        self.check.setText(translate("Player", "Check the device"))
        self.history.setText(translate("Player", "History"))
        for code, name in LANGUAGES.items():
            self.languages.buttons[code].setText(name)
        text = translate("Player", "Every run is recorded in %1")
        self.records.setVisible(self._folder is not None)
        if self._folder is not None:
            self.records.tell(text.replace("%1", str(self._folder)), self._folder)


class MenuBoard(Board):
    """What Esc opens."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.resume = self.add_button(main=True)
        self.restart = self.add_button()
        self.full_screen = self.add_button()
        self.languages = Choice(self, list(LANGUAGES))
        self.themes = Choice(self, ["dark", "light"])
        self.sounds = Choice(self, ["on", "off"])
        self.sounds.choose("on")
        self.rows.addWidget(self.languages)
        self.rows.addWidget(self.themes)
        self.rows.addWidget(self.sounds)
        self.quit = self.add_button()
        self.keys = Table(self, say_keys)
        self.rows.addSpacing(4)
        self.rows.addWidget(self.keys)
        self.say()

    def say(self) -> None:
        self.headline.setText(translate("Player", "Paused"))
        self.resume.setText(translate("Player", "Resume"))
        self.restart.setText(translate("Player", "Restart"))
        self.full_screen.setText(translate("Player", "Full screen on or off"))
        self.quit.setText(translate("Player", "Quit"))
        for code, name in LANGUAGES.items():
            self.languages.buttons[code].setText(name)
        self.themes.buttons["dark"].setText(translate("Player", "Dark"))
        self.themes.buttons["light"].setText(translate("Player", "Light"))
        self.sounds.buttons["on"].setText(translate("Player", "Sounds on"))
        self.sounds.buttons["off"].setText(translate("Player", "Sounds off"))
        self.keys.say()


class EndBoard(Board):
    """How the run went, and where its record is."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.trouble, self.facts = self.add("body"), self.add("body")
        self.record = FolderLine(self)
        self.rows.addWidget(self.record)
        self.restart = self.add_button(main=True)
        self.quit = self.add_button()
        self._time, self._peak, self._path, self._trouble = 0.0, 0.0, "", ""
        self._state: palpate.TaskState | None = None
        self.say()

    def tell(
        self,
        time: float,
        peak: float,
        record: str,
        trouble: str,
        state: palpate.TaskState | None = None,
    ) -> None:
        """[s] of the run and [N] of its peak; `trouble` is a sentence, or empty; `state` is that of
        a task, where there was one.
        """
        self._time, self._peak, self._path, self._trouble = time, peak, record, trouble
        self._state = state
        self.say()

    def say(self) -> None:
        trouble = self._trouble
        self.headline.setText(
            translate("Player", "The run was ended") if trouble else translate("Player", "Finished")
        )
        self.trouble.setText(trouble)
        self.trouble.setVisible(bool(trouble))
        facts = translate("Player", "Time %1. Peak force %2 N.")
        facts = facts.replace("%1", format_clock(self._time))
        facts = facts.replace("%2", format_number(self._peak, 2))
        verdict = "" if self._state is None else say_outcome(self._state)
        self.facts.setText(f"{verdict}\n{facts}" if verdict else facts)
        text = translate("Player", "Record: %1").replace("%1", self._path)
        self.record.tell(text, Path(self._path).parent)
        self.restart.setText(translate("Player", "Restart"))
        self.quit.setText(translate("Player", "Quit"))
