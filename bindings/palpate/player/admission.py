# SPDX-License-Identifier: BSD-3-Clause
"""Who plays, what they have agreed to, and whether their device is fit for attempts that count."""

from __future__ import annotations

import tempfile
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from palpate.command.verb import Report, WrongCall
from palpate.files.refusal import Refusal
from palpate.player.boards import Board
from palpate.player.check_run import CheckRun
from palpate.player.sentences import translate
from palpate.runs.kept_play import Keeper, open_store
from palpate.translation.refusals import say_refusal

if TYPE_CHECKING:
    from palpate.player.host import Host
    from palpate.records.people import Person
    from palpate.records.store import Store


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
        self.person: Person | None = None
        self._store: Store | None = None
        self._practice: tempfile.TemporaryDirectory[str] | None = None
        self.check = CheckRun(window, self)
        self.check.found.connect(self._take_check)
        who, consent, board = self.over.who, self.over.consent, self.over.check
        who.code_entered.connect(self._take_code)
        who.new_wanted.connect(self._take_new)
        who.guest_wanted.connect(self._take_guest)
        who.practice_wanted.connect(self.practise)
        who.languages.chosen.connect(window.use_language)
        consent.agreed.connect(self._agree)
        consent.declined.connect(self.practise)
        board.go.clicked.connect(self.admitted)
        board.again.clicked.connect(self.check.start)
        board.practice.clicked.connect(self.practise)
        self.over.start.check.clicked.connect(self.check.start)

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
        self.keeper = self.person = None
        if self._practice is None:
            self._practice = tempfile.TemporaryDirectory(prefix="palpate-practice-")
        self.admitted.emit()

    # ------------------------------------------------------------ who

    def _open(self) -> Store | None:
        try:
            self._store = self._store or open_store()
        except (OSError, Refusal) as problem:
            text = translate("Player", "The database cannot be used, so nothing can be kept: %1")
            self._refuse(text.replace("%1", say_refusal(str(problem))))
        return self._store

    def _refuse(self, sentence: str) -> None:
        self.over.who.refuse(sentence)
        self.over.place()

    def _take_code(self, code: str) -> None:
        from palpate.records.people import find_person

        store = self._open()
        if store is None:
            return
        self.person = find_person(store, code)
        if self.person is None:
            text = translate("Player", "Nobody has the code %1 on this computer.")
            self._refuse(text.replace("%1", code))
        elif self.person.practice:
            self._keep()
        else:
            self._ask("")

    def _take_new(self) -> None:
        self._add(guest=False)

    def _take_guest(self) -> None:
        self._add(guest=True)

    def _add(self, guest: bool) -> None:
        from palpate.records.people import add_person

        store = self._open()
        if store is not None:
            self.person = add_person(store, guest)
            self._ask(self.person.code or "")

    def _ask(self, code: str) -> None:
        self.over.consent.tell(self.window.language, code)
        self.window.show_board(self.over.consent)

    def _agree(self) -> None:
        from palpate.records.people import give_consent

        assert self._store is not None and self.person is not None
        self.person = give_consent(self._store, self.person, self.window.language)
        self._keep()

    def _keep(self) -> None:
        assert self._store is not None and self.person is not None
        try:
            self.keeper = Keeper(self._store, self.person, self.window.play)
        except (OSError, WrongCall) as problem:
            self._refuse(str(problem))
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
