# SPDX-License-Identifier: BSD-3-Clause
"""Who plays, and what they have agreed to: two boards, in whichever window they are."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from palpate.files.refusal import Refusal
from palpate.player.boards import Board
from palpate.player.people_boards import ConsentBoard, WhoBoard
from palpate.player.sentences import translate
from palpate.runs.kept_play import open_store
from palpate.translation.refusals import say_refusal

if TYPE_CHECKING:
    from palpate.records.people import Person
    from palpate.records.store import Store


class Identification(QObject):
    """From the board that asks who plays to a person who has agreed, or to practice."""

    identified = Signal()
    """`store` and `person` are of a person whose attempts may be kept."""
    practising = Signal()
    """Nothing is kept."""

    def __init__(
        self,
        who: WhoBoard,
        consent: ConsentBoard,
        show: Callable[[Board | None], None],
        find_language: Callable[[], str],
        parent: QObject,
    ):
        """`show` shows a board, of a height that fits what it says."""
        super().__init__(parent)
        self.who, self.consent = who, consent
        self.store: Store | None = None
        self.person: Person | None = None
        self._show, self._find_language = show, find_language
        who.code_entered.connect(self.take_code)
        who.new_wanted.connect(self._take_new)
        who.guest_wanted.connect(self._take_guest)
        who.practice_wanted.connect(self._practise)
        consent.agreed.connect(self._agree)
        consent.declined.connect(self._practise)

    def refuse(self, sentence: str) -> None:
        self.who.refuse(sentence)
        self._show(self.who)

    def take_code(self, code: str) -> None:
        """Of a person who was here before."""
        from palpate.records.people import find_person

        store = self._open()
        if store is None:
            return
        self.person = find_person(store, code)
        if self.person is None:
            text = translate("Player", "Nobody has the code %1 on this computer.")
            self.refuse(text.replace("%1", code))
        elif self.person.practice:
            self.identified.emit()
        else:
            self._ask("")

    def _open(self) -> Store | None:
        try:
            self.store = self.store or open_store()
        except (OSError, Refusal) as problem:
            text = translate("Player", "The database cannot be used, so nothing can be kept: %1")
            self.refuse(text.replace("%1", say_refusal(str(problem))))
        return self.store

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
        self.consent.tell(self._find_language(), code)
        self._show(self.consent)

    def _agree(self) -> None:
        from palpate.records.people import give_consent

        assert self.store is not None and self.person is not None
        self.person = give_consent(self.store, self.person, self._find_language())
        self.identified.emit()

    def _practise(self) -> None:
        self.person = None
        self.practising.emit()
