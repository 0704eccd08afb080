# SPDX-License-Identifier: BSD-3-Clause
"""Persons as codes, what they have agreed to, and how they are forgotten."""

from __future__ import annotations

import hashlib
import secrets
from dataclasses import dataclass

from sqlalchemy import Connection, and_, delete, func, select, update

from palpate.records.store import Store, make_id, now
from palpate.records.tables import (
    answer,
    attempt,
    audit,
    consent,
    event,
    metric,
    person,
    rating,
    session,
    step_result,
    survey,
)

LETTERS = "ABCDEFGHJKLMNPQRSTUVWXYZ"
"""Without I and O, which are read as figures."""
LENGTH = 8

CONSENT = {
    "en": (
        "Palpate records what I do in each attempt: how my hand moves, the forces, times and "
        "errors, under a code and without my name. The records stay on this computer. I may take "
        "this back at any time with my code; then traces and answers are deleted."
    ),
    "tr": (
        "Palpate her denemede yaptıklarımı kaydeder: elimin hareketleri, kuvvetler, süreler ve "
        "hatalar; bir kod altında ve adım olmadan. Kayıtlar bu bilgisayarda kalır. Bunu kodumla "
        "istediğim zaman geri alabilirim; o zaman izler ve yanıtlar silinir."
    ),
}
"""What is agreed to; another text is asked for again."""


@dataclass(frozen=True)
class Person:
    """Who plays: a code, or a guest."""

    id: str
    code: str | None
    practice: bool
    """Whether their attempts may be stored."""
    research: bool


def hash_consent(language: str) -> str:
    return hashlib.sha256(CONSENT[language].encode()).hexdigest()


def draw_code() -> str:
    return "".join(secrets.choice(LETTERS) for _ in range(LENGTH))


def add_person(store: Store, guest: bool = False) -> Person:
    """A new one, who has agreed to nothing yet."""
    identity, code = make_id(), None if guest else draw_code()
    with store.begin() as connection:
        connection.execute(
            person.insert().values(id=identity, code=code, cohort="", experience={}, created=now())
        )
    return Person(identity, code, False, False)


def find_person(store: Store, code: str) -> Person | None:
    """The one of a code, with what they have agreed to as the texts stand now."""
    with store.begin() as connection:
        row = connection.execute(select(person).where(person.c.code == code.upper())).first()
        return None if row is None else read_person(connection, row.id, row.code)


def read_person(connection: Connection, identity: str, code: str | None) -> Person:
    texts = [hash_consent(language) for language in CONSENT]
    given = connection.execute(
        select(consent)
        .where(
            consent.c.person == identity,
            consent.c.withdrawn.is_(None),
            consent.c.text_sha256.in_(texts),
        )
        .order_by(consent.c.given.desc())
    ).first()
    if given is None:
        return Person(identity, code, False, False)
    return Person(identity, code, given.practice, given.research)


def give_consent(
    store: Store, who: Person, language: str, practice: bool = True, research: bool = False
) -> Person:
    """To the text of a language as it stands now."""
    with store.begin() as connection:
        connection.execute(
            consent.insert().values(
                id=make_id(), person=who.id, text_sha256=hash_consent(language), language=language,
                practice=practice, research=research, given=now(), withdrawn=None,
            )
        )  # fmt: skip
    return Person(who.id, who.code, practice, research)


def forget(store: Store, code: str) -> dict[str, int] | None:
    """Deletes traces, events, answers and steps of a person, and the code; attempts stay as counts
    that nobody can be found by. None where there is no such code; how many rows went, else.
    """
    with store.begin() as connection:
        found = connection.execute(select(person.c.id).where(person.c.code == code.upper())).first()
        if found is None:
            return None
        sessions = select(session.c.id).where(session.c.person == found.id)
        attempts = select(attempt.c.id).where(attempt.c.session.in_(sessions))
        names = connection.execute(
            select(attempt.c.trace).where(attempt.c.session.in_(sessions))
        ).scalars()
        traces = [store.traces / name for name in names]
        kept = connection.execute(select(func.count()).select_from(attempts.subquery())).scalar()
        gone = {
            "events": connection.execute(delete(event).where(event.c.attempt.in_(attempts))),
            "steps": connection.execute(
                delete(step_result).where(step_result.c.attempt.in_(attempts))
            ),
            "metrics": connection.execute(delete(metric).where(metric.c.attempt.in_(attempts))),
            "ratings": connection.execute(delete(rating).where(rating.c.attempt.in_(attempts))),
            "answers": connection.execute(
                delete(answer).where(
                    answer.c.survey.in_(select(survey.c.id).where(survey.c.person == found.id))
                )
            ),
            "surveys": connection.execute(delete(survey).where(survey.c.person == found.id)),
        }
        connection.execute(
            update(attempt)
            .where(attempt.c.session.in_(sessions))
            .values(drawn={}, trace_sha256=None, trace_bytes=0, trace_state="expired",
                    counts_for_judging=False, why_not="consent was withdrawn")
        )  # fmt: skip
        connection.execute(
            update(consent)
            .where(and_(consent.c.person == found.id, consent.c.withdrawn.is_(None)))
            .values(withdrawn=now())
        )
        connection.execute(update(person).where(person.c.id == found.id).values(code=None))
        connection.execute(
            audit.insert().values(at=now(), who="person", what="forgotten", why="asked for")
        )
        counts = {name: result.rowcount for name, result in gone.items()}
    removed = [trace for trace in traces if trace.exists()]
    for trace in removed:
        trace.unlink()
    return {**counts, "traces": len(removed), "attempts_kept_as_counts": int(kept or 0)}
