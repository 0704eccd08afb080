# SPDX-License-Identifier: BSD-3-Clause
"""Who plays, what they have agreed to, and whether their device is fit for attempts that count."""

from __future__ import annotations

import tempfile
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from palpate.command.verb import Report, WrongCall
from palpate.player.boards import Board
from palpate.player.check_run import CheckRun
from palpate.player.identification import Identification
from palpate.runs.kept_play import Keeper

if TYPE_CHECKING:
    from palpate.player.host import Host
    from palpate.records.people import Person


class Admission(QObject):
    """Leads from who to consent and, with a device, to its check. Nothing is kept of anybody who
    has not come through.
    """

    admitted = Signal()
    """The brief may be shown."""

    def __init__(self, window: Host, parent: QObject):
        super().__init__(parent)
        self.window, self.over = window, window.over
        self.keeper: Keeper | None = None
        self.checked: Report | None = None
        """What the check of this device has found, in this window or one before."""
        self._practice: tempfile.TemporaryDirectory[str] | None = None
        self.check = CheckRun(window, self)
        self.check.found.connect(self._take_check)
        who, board = self.over.who, self.over.check
        self.identification = Identification(
            who, self.over.consent, window.show_board, self._find_language, self
        )
        self.identification.identified.connect(self._keep)
        self.identification.practising.connect(self.practise)
        who.languages.chosen.connect(window.use_language)
        board.go.clicked.connect(self.admitted)
        board.again.clicked.connect(self.check.start)
        board.practice.clicked.connect(self.practise)
        self.over.start.check.clicked.connect(self.check.start)

    @property
    def person(self) -> Person | None:
        """Who is asked, or was."""
        return self.identification.person

    @property
    def practice_folder(self) -> str | None:
        """Where records of practice go, which go with the window; None where there is none."""
        return None if self._practice is None else self._practice.name

    @property
    def asked(self) -> bool:
        """Whether it is asked who plays: where a task is judged, and a person plays it."""
        play = self.window.play
        return play.drawn is not None and not play.hand and not play.frames

    @property
    def blocked(self) -> bool:
        """Attempts with this device would not count."""
        return self.checked is not None and self.checked["force"] and not self.checked["ok"]

    @property
    def may_play(self) -> bool:
        """False until a person has said who they are, and agreed or chosen practice."""
        if not self.asked or self.practice_folder is not None:
            return True
        return self.keeper is not None and not self.blocked and not self.check.busy

    def first_board(self) -> Board:
        return self.over.who if self.asked and self.keeper is None else self.over.start

    def use(self, keeper: Keeper) -> None:
        """A person who was named before the window."""
        self.keeper = keeper
        self._go_on()

    def practise(self) -> None:
        self.keeper = None
        if self._practice is None:
            self._practice = tempfile.TemporaryDirectory(prefix="palpate-practice-")
        self.admitted.emit()

    def _find_language(self) -> str:
        return self.window.language

    def _keep(self) -> None:
        store, person = self.identification.store, self.identification.person
        assert store is not None and person is not None
        try:
            self.keeper = Keeper(store, person, self.window.play)
        except (OSError, WrongCall) as problem:
            self.identification.refuse(str(problem))
            return
        self._go_on()

    # ------------------------------------------------------------ the device

    def _go_on(self) -> None:
        """To the check of an arm, once; a mouse has no force that could be checked."""
        if self.window.play.arm and self.asked and self.checked is None:
            self.check.start()
        else:
            self._note_check()
            self.admitted.emit()

    def _take_check(self, found: Report | None) -> None:
        first = self.checked is None
        if found is None and not (self.window.play.arm and self.asked and first):
            self.admitted.emit()
            return
        self.checked = found or {"force": True, "note": "left", "checks": [], "ok": False}
        self._note_check()
        if first and self.checked["ok"] and self.checked["force"]:
            self.admitted.emit()
            return
        self.over.check.tell(self.checked)
        self.window.show_board(self.over.check)

    def _note_check(self) -> None:
        if self.keeper is not None and self.checked is not None:
            self.keeper.note_check(self.checked)
