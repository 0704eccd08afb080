# SPDX-License-Identifier: BSD-3-Clause
"""What is in a database: attempts listed, shown, and exported as CSV."""

from __future__ import annotations

import csv
import io
from typing import Any

from sqlalchemy import select

from palpate.records.store import Store
from palpate.records.tables import (
    attempt,
    device,
    event,
    metric,
    person,
    scenario,
    session,
    step_result,
)

NOTE = "Not validated. Not a medical device. Results do not show clinical competence."
WIDE = ("attempt", "person", "scenario", "version", "level", "seed", "device", "started",
        "outcome", "ticks", "missed", "counts_for_judging", "why_not")  # fmt: skip
DICTIONARY = {
    "attempt": "id, in order of time",
    "person": "code; empty for a guest, or one who was forgotten",
    "scenario": "id of the task",
    "version": "of the task",
    "level": "of the task",
    "seed": "what its parameters were drawn from",
    "device": "kind; a mouse gives no force, and its numbers are not comparable",
    "started": "UTC",
    "outcome": "done, failed, timed_out are performance; left, device_fault, diverged, interrupted "
    "are not",
    "ticks": "of 1/1000 s, as the scene says",
    "missed": "ticks that came too late",
    "counts_for_judging": "0 or 1",
    "why_not": "why it does not count",
    "metric": "name; version, value and unit stand beside it",
}

Row = dict[str, Any]


def list_attempts(store: Store, code: str = "", most: int = 0, scenario_id: str = "") -> list[Row]:
    """The newest first; of a person, or of a task, where those are given."""
    chosen = (
        select(
            attempt.c.id.label("attempt"), person.c.code.label("person"),
            scenario.c.id.label("scenario"), scenario.c.version, attempt.c.level, attempt.c.seed,
            device.c.kind.label("device"), attempt.c.started, attempt.c.ended, attempt.c.outcome,
            attempt.c.ticks, attempt.c.missed, attempt.c.counts_for_judging, attempt.c.why_not,
            attempt.c.trace, attempt.c.trace_bytes, attempt.c.trace_state,
        )
        .join_from(attempt, session, attempt.c.session == session.c.id)
        .join(person, session.c.person == person.c.id)
        .join(device, session.c.device == device.c.id)
        .join(scenario, attempt.c.scenario == scenario.c.sha256)
        .order_by(attempt.c.id.desc())
    )  # fmt: skip
    if code:
        chosen = chosen.where(person.c.code == code.upper())
    if scenario_id:
        chosen = chosen.where(scenario.c.id == scenario_id)
    if most:
        chosen = chosen.limit(most)
    with store.begin() as connection:
        return [dict(row._mapping) for row in connection.execute(chosen)]


def list_history(store: Store, code: str, most: int = 500) -> list[Row]:
    """The attempts of a person, the newest first, with the title of each task by language, and what
    was judged of it: None where an attempt was not played to its end.
    """
    rows = list_attempts(store, code, most)
    judged = {"time": "time_s", "errors": "errors", "peak_force": "peak_force_N"}
    with store.begin() as connection:
        titles = {row.id: row.title for row in connection.execute(
            select(scenario.c.id, scenario.c.title))}  # fmt: skip
        of = {row["attempt"]: dict.fromkeys(judged.values()) for row in rows}
        found = connection.execute(
            select(metric.c.attempt, metric.c.name, metric.c.value).where(
                metric.c.name.in_(judged), metric.c.attempt.in_(list(of)))
        )  # fmt: skip
        for each in found:
            of[each.attempt][judged[each.name]] = each.value
    return [{**row, "title": titles[row["scenario"]], **of[row["attempt"]]} for row in rows]


def show_attempt(store: Store, identity: str) -> Row | None:
    """All of one; a beginning of its id that no other has is enough."""
    found = [row for row in list_attempts(store) if row["attempt"].startswith(identity)]
    if len(found) != 1:
        return None
    of = found[0]["attempt"]
    with store.begin() as connection:

        def read(table: Any, order: Any) -> list[Row]:
            rows = connection.execute(select(table).where(table.c.attempt == of).order_by(order))
            return [{k: v for k, v in row._mapping.items() if k != "attempt"} for row in rows]

        return {
            **found[0],
            "steps": read(step_result, step_result.c.from_tick),
            "metrics": read(metric, metric.c.name),
            "events": read(event, event.c.seq),
        }


def export_csv(store: Store, long: bool = False) -> str:
    """One row per attempt, or with `long` one per metric; a dictionary of the columns stands in
    front, on lines that begin with #.
    """
    rows = list_attempts(store)[::-1]
    with store.begin() as connection:
        metrics = [dict(row._mapping) for row in connection.execute(select(metric))]
    of: dict[str, dict[str, Row]] = {}
    for each in metrics:
        of.setdefault(each["attempt"], {})[each["name"]] = each
    text = io.StringIO()
    text.write(f"# {NOTE}\n")
    for name, said in DICTIONARY.items():
        text.write(f"# {name}: {said}\n")
    names = sorted({each["name"] for each in metrics})
    columns = [*WIDE, *(("metric", "metric_version", "value", "unit") if long else names)]
    writer = csv.DictWriter(text, columns, lineterminator="\n")
    writer.writeheader()
    for row in rows:
        plain = {name: "" if row[name] is None else row[name] for name in WIDE}
        plain["counts_for_judging"] = int(row["counts_for_judging"])
        found = of.get(row["attempt"], {})
        if not long:
            writer.writerow({**plain, **{name: each["value"] for name, each in found.items()}})
            continue
        for name, each in sorted(found.items()):
            writer.writerow({**plain, "metric": name, "metric_version": each["version"],
                             "value": each["value"], "unit": each["unit"]})  # fmt: skip
    return text.getvalue()
