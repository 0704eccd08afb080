# SPDX-License-Identifier: BSD-3-Clause
"""Attempts that are kept in the database of this station: whose they are, and from when on.

The row of an attempt and its trace are there before its first tick. palpate.records is imported
where it is needed: it loads SQLAlchemy.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import palpate
from palpate.assessment.verdict import describe_verdict, pick_events
from palpate.command.verb import Report, WrongCall
from palpate.device.names import find_port
from palpate.runs.play import Play
from palpate.runs.play_report import describe_run, play_headless
from palpate.scene.scene_file import hash_file

if TYPE_CHECKING:
    from palpate.records.attempts import Begun
    from palpate.records.people import Person
    from palpate.records.store import Store


class Keeper:
    """Keeps the attempts of one person at one device, one after the other."""

    def __init__(self, store: Store, who: Person, play: Play):
        """Raises WrongCall for a person who has not agreed to be recorded."""
        from palpate.records.attempts import begin_session

        if not who.practice:
            raise WrongCall("--person: has not agreed to be recorded; `palpate records join` asks")
        self.store, self.who, self.play = store, who, play
        self.file_sha256 = hash_file(play.path)
        self.session = begin_session(store, who, self.device, {})
        self.begun: Begun | None = None

    @property
    def device(self) -> str:
        """What kind it is."""
        play = self.play
        if find_port(play.arm):
            return "arm"
        return f"simulated hand {play.hand}" if play.hand else "script" if play.frames else "mouse"

    @property
    def has_force(self) -> bool:
        return bool(find_port(self.play.arm))

    def note_check(self, check: Report) -> None:
        """What the check of the device has found."""
        from palpate.records.attempts import note_check

        note_check(self.store, self.session, check)

    def list_history(self) -> list[Report]:
        """All attempts of the person; of a guest none, for they are linked to nobody."""
        from palpate.records.queries import list_history

        return [] if self.who.code is None else list_history(self.store, self.who.code)

    def begin(self) -> Begun:
        """The row of one more attempt is on the disk; its trace is to be written where it says."""
        from palpate.records.attempts import begin_attempt

        assert self.play.drawn is not None
        scenario, drawn = self.play.scenario, self.play.drawn
        self.begun = begin_attempt(self.store, self.session, scenario, drawn, self.file_sha256)
        return self.begun

    def end(self, report: Report) -> None:
        """Its verdict, in one transaction."""
        from palpate.records.attempts import end_attempt

        begun, self.begun = self.begun, None
        if begun is not None:
            end_attempt(self.store, begun, {**report, "has_force": self.has_force})

    def list_before(self, most: int = 5) -> list[Report]:
        """Earlier attempts at this task by the same person; of a guest those of now alone."""
        from palpate.records.queries import list_attempts

        assert self.play.drawn is not None
        if self.who.code is None:
            return []
        rows = list_attempts(self.store, self.who.code, most + 1, self.play.drawn.id)
        current = None if self.begun is None else self.begun.id
        return [row for row in rows if row["attempt"] != current][:most]

    def give_up(self) -> None:
        """What is begun and cannot be ended stays `interrupted`, with what its trace holds."""
        from palpate.records.attempts import close_one

        begun, self.begun = self.begun, None
        if begun is not None:
            close_one(self.store, begun.id, begun.trace)
            self.store.unlock(begun.id, begun.lock)


def describe_kept(
    play: Play, record: Path, costs: palpate.LoopReport, state: palpate.TaskState
) -> Report:
    """The report of a run that a window has followed, without a replay of it: its events are those
    of its record, its sums those of its last frame.
    """
    assert play.drawn is not None
    rows = palpate.read_record(str(record))
    assessment = json.loads(play.scenario.assessment)
    verdict = describe_verdict(play.drawn, state, pick_events(rows.events), assessment)
    verdict["outcome"] = palpate.find_outcome(rows).name
    return {**describe_run(play, record, costs), "verdict": verdict}


def open_store() -> Store:
    """The database, after attempts that a killed program left were closed."""
    from palpate.records.attempts import close_interrupted
    from palpate.records.store import Store

    store = Store()
    close_interrupted(store)
    return store


def open_keeper(play: Play, code: str) -> Keeper:
    """Of the person of a code; an empty one is a guest, who agrees by asking to be kept. Attempts
    that a killed program left are closed first. Raises WrongCall, Refusal or OSError.
    """
    from palpate.records.people import add_person, find_person, give_consent

    if play.drawn is None:
        raise WrongCall(f"--person or --guest: {play.path.name} has no task that is judged")
    store = open_store()
    if not code:
        return Keeper(store, give_consent(store, add_person(store, guest=True), "en"), play)
    who = find_person(store, code)
    if who is None:
        raise WrongCall(f"--person: got {code!r}, expected a code of `palpate records join`")
    return Keeper(store, who, play)


def play_kept(play: Play, code: str) -> Report:
    """As play_headless, kept in the database."""
    keeper = open_keeper(play, code)
    begun = keeper.begin()
    print(f"attempt {begun.id}", file=sys.stderr, flush=True)
    play.record = begun.trace
    try:
        report: dict[str, Any] = play_headless(play)
        keeper.end(report)
    except BaseException:
        keeper.give_up()
        raise
    return {**report, "attempt": begun.id, "person": keeper.who.code}
