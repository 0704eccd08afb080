# SPDX-License-Identifier: BSD-3-Clause
"""An attempt from before its first tick to its verdict, and what a program left that was killed."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

from sqlalchemy import Connection, select, update

import palpate
from palpate.assessment.verdict import KINDS, pick_events
from palpate.records.people import Person
from palpate.records.store import Store, make_id, now
from palpate.records.tables import (
    attempt,
    device,
    event,
    metric,
    outbox,
    scenario,
    session,
    station,
    step_result,
)

Report = dict[str, Any]

INTERRUPTED, EXPIRED = "interrupted", "expired"
PERFORMANCE = ("done", "failed", "timed_out")
"""Outcomes that say something of the person."""
MOST_MISSED = 1e-3
"""[-] of the ticks; with more an attempt is not judged."""
METRIC_VERSION = 1


@dataclass(frozen=True)
class Begun:
    """An attempt that goes on."""

    id: str
    trace: Path
    lock: int


def begin_session(store: Store, who: Person, kind: str, check: Mapping[str, Any]) -> str:
    """One person at one device; `check` is what its check has found."""
    with store.begin() as connection:
        place = connection.execute(select(station.c.id)).scalars().first()
        known = connection.execute(select(device.c.id).where(device.c.kind == kind)).scalars()
        machine = known.first()
        if machine is None:
            machine = make_id()
            connection.execute(
                device.insert().values(id=machine, kind=kind, firmware="", serial_hash="",
                                       calibrated=None, calibration={})
            )  # fmt: skip
        identity = make_id()
        connection.execute(
            session.insert().values(
                id=identity, person=who.id, station=place, device=machine,
                software=f"palpate {version('palpate')}", started=now(), check=dict(check),
            )
        )  # fmt: skip
    return identity


def note_check(store: Store, of: str, check: Mapping[str, Any]) -> None:
    """What the check of the device has found in a session."""
    with store.begin() as connection:
        connection.execute(update(session).where(session.c.id == of).values(check=dict(check)))


def begin_attempt(
    store: Store,
    of: str,
    played: palpate.scenario.Scenario,
    drawn: palpate.scenario.DrawnTask,
    file_sha256: str,
) -> Begun:
    """Its row is on the disk when this comes back: `interrupted`, until there is a verdict.

    Args:
        store: Where.
        of: The session.
        played: The scenario.
        drawn: What is judged in it.
        file_sha256: Of its file.
    """
    identity = make_id()
    lock = store.lock(identity)
    assert lock is not None
    assessment = json.loads(played.assessment)
    titles = {code: texts.get(assessment["title"], "")
              for code, texts in assessment["texts"].items()}  # fmt: skip
    name = f"{identity}.prec"
    with store.begin() as connection:
        connection.execute(  # another program may begin with the same file at this moment
            scenario.insert().prefix_with("OR IGNORE").values(
                sha256=file_sha256, id=drawn.id, version=drawn.version, title=titles,
                reviews=assessment.get("reviews", []),
            )
        )  # fmt: skip
        connection.execute(
            attempt.insert().values(
                id=identity, session=of, scenario=file_sha256, level=drawn.level, seed=drawn.seed,
                drawn={each.name: each.place or each.value for each in drawn.values}, guide={},
                started=now(), ended=None, outcome=INTERRUPTED, trace=name,
            )
        )  # fmt: skip
    return Begun(identity, store.traces / name, lock)


def end_attempt(store: Store, begun: Begun, report: Mapping[str, Any]) -> None:
    """One transaction: the row, its steps, events and metrics, from the report of a played run."""
    verdict = report["verdict"]
    why_not = find_why_not(report)
    with store.begin() as connection:
        connection.execute(
            update(attempt)
            .where(attempt.c.id == begun.id)
            .values(
                ended=now(), outcome=verdict["outcome"], ticks=report["ticks"],
                missed=report["missed_ticks"], late_p99_us=report["lateness_p99_us"],
                counts_for_judging=not why_not, why_not=why_not, **describe_trace(begun.trace),
            )
        )  # fmt: skip
        put_steps(connection, begun.id, verdict)
        put_events(connection, begun.id, verdict["events"])
        put_metrics(connection, begun.id, verdict)
        connection.execute(outbox.insert().values(table="attempt", row_id=begun.id))
    store.unlock(begun.id, begun.lock)


def find_why_not(report: Mapping[str, Any]) -> str:
    """Why an attempt does not count for judging; empty where it does."""
    outcome = report["verdict"]["outcome"]
    if outcome not in PERFORMANCE:
        return f"outcome {outcome}"
    if report["missed_ticks"] > MOST_MISSED * max(report["ticks"], 1):
        return "more than 0.1 % of the ticks were missed"
    if report.get("record_gaps"):
        return "the trace has gaps"
    if not report.get("has_force", False):
        return "no force; not comparable"
    return ""


def describe_trace(trace: Path) -> Report:
    if not trace.exists():
        return {"trace_sha256": None, "trace_bytes": 0, "trace_state": EXPIRED}
    data = trace.read_bytes()
    return {"trace_sha256": hashlib.sha256(data).hexdigest(), "trace_bytes": len(data)}


def put_steps(connection: Connection, identity: str, verdict: Mapping[str, Any]) -> None:
    rows = [
        {"attempt": identity, "step": step["id"], "from_tick": step["from_tick"],
         "to_tick": step["until_tick"], "outcome": step["status"]}
        for step in verdict["steps"]
    ]  # fmt: skip
    if rows:
        connection.execute(step_result.insert(), rows)


def put_events(connection: Connection, identity: str, events: list[Report]) -> None:
    rows = [
        {"attempt": identity, "seq": seq, "tick": each["tick"], "kind": each["kind"],
         "data": {k: v for k, v in each.items() if k not in ("tick", "kind")}}
        for seq, each in enumerate(events)
    ]  # fmt: skip
    if rows:
        connection.execute(event.insert(), rows)


def put_metrics(connection: Connection, identity: str, verdict: Mapping[str, Any]) -> None:
    """Whole numbers of the judge; each limit's under its own name."""
    rows = [("time", verdict["time_s"], "s"), ("errors", verdict["errors"], "1"),
            ("warnings", verdict["warnings"], "1"),
            ("peak_force", verdict["peak_force_N"], "N")]  # fmt: skip
    for limit in verdict["limits"]:
        rows += [(f"limit.{limit['id']}.count", limit["count"], "1"),
                 (f"limit.{limit['id']}.duration", limit["duration_s"], "s")]  # fmt: skip
    connection.execute(
        metric.insert(),
        [{"attempt": identity, "step": "", "name": name, "version": METRIC_VERSION,
          "value": float(value), "unit": unit} for name, value, unit in rows],
    )  # fmt: skip


def close_interrupted(store: Store) -> list[str]:
    """Ends the attempts of programs that were killed, with what their traces hold; those of
    programs that live are left alone. Gives their ids.
    """
    with store.begin() as connection:
        rows = connection.execute(
            select(attempt.c.id, attempt.c.trace).where(attempt.c.ended.is_(None))
        ).all()
        expired = connection.execute(
            select(attempt.c.trace).where(attempt.c.trace_state == EXPIRED)
        ).scalars()
        for name in expired:  # of a program that was killed while it forgot
            (store.traces / name).unlink(missing_ok=True)
    closed = []
    for identity, name in rows:
        handle = store.lock(identity)
        if handle is None:
            continue
        close_one(store, identity, store.traces / name)
        store.unlock(identity, handle)
        closed.append(identity)
    return closed


def close_one(store: Store, identity: str, trace: Path) -> None:
    ticks, events, why = 0, [], "the program was ended"
    try:
        record = palpate.read_record(str(trace))
        ticks = len(record.hand) // max(record.instruments, 1)
        events = [
            {"tick": int(row["tick"]), "kind": KINDS[int(row["kind"])], "index": int(row["index"]),
             "value": float(row["value"])}
            for row in pick_events(record.events)
        ]  # fmt: skip
    except OSError as problem:
        why = f"the program was ended, and its trace cannot be read: {problem}"
    with store.begin() as connection:
        closed = connection.execute(
            update(attempt)
            .where(attempt.c.id == identity, attempt.c.ended.is_(None))
            .values(ended=now(), outcome=INTERRUPTED, ticks=ticks, counts_for_judging=False,
                    why_not=why, **describe_trace(trace))
        )  # fmt: skip
        if closed.rowcount == 0:  # another program that began now has closed it meanwhile
            return
        put_events(connection, identity, events)
        connection.execute(outbox.insert().values(table="attempt", row_id=identity))
