# SPDX-License-Identifier: BSD-3-Clause
"""The verb `records`: what is in this station's database, and who is taken out of it."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall
from palpate.files.file_kind import ATTEMPTS
from palpate.files.whole_file import write_whole

MOST = 20


def add_records(parser: argparse.ArgumentParser) -> None:
    actions = parser.add_subparsers(dest="action", metavar="ACTION", required=True)
    listed = actions.add_parser("list", help="the newest attempts")
    listed.add_argument("--person", default="", metavar="CODE")
    listed.add_argument("--most", type=int, default=MOST, help=f"0 for all; default: {MOST}")
    show = actions.add_parser("show", help="one attempt: its steps, metrics and events")
    show.add_argument("attempt", help="its id, or the beginning of it")
    export = actions.add_parser("export", help="all attempts as CSV")
    export.add_argument("--csv", action="store_true", required=True)
    export.add_argument("--long", action="store_true", help="a row for each metric")
    add_output(export, "-o", "--out", writes=ATTEMPTS, help="default: standard output")
    join = actions.add_parser("join", help="a new code for a person who agrees to be recorded")
    join.add_argument("--language", choices=("en", "tr"), default="en")
    join.add_argument("--agree", action="store_true", help="they have read the text and agree")
    join.add_argument("--research", action="store_true", help="and that it is used for research")
    forget = actions.add_parser("forget", help="delete what is known of a person")
    forget.add_argument("code")
    for action in (listed, show, export, join, forget):
        action.add_argument(
            "--json",
            action="store_true",
            default=argparse.SUPPRESS,
            help="report as JSON on standard output",
        )


def run_records(call: argparse.Namespace) -> Report:
    # it loads SQLAlchemy, which no other verb needs
    from palpate.records.attempts import close_interrupted
    from palpate.records.store import Store

    store = Store()
    closed = close_interrupted(store)
    try:
        return {"action": call.action, "database": str(store.path), "closed": closed,
                **ACTIONS[call.action](store, call)}  # fmt: skip
    finally:
        store.close()


def run_list(store: Any, call: argparse.Namespace) -> Report:
    from palpate.records.queries import list_attempts

    return {"attempts": list_attempts(store, call.person, max(call.most, 0))}


def run_show(store: Any, call: argparse.Namespace) -> Report:
    from palpate.records.queries import show_attempt

    found = show_attempt(store, call.attempt)
    if found is None:
        raise WrongCall(f"attempt: got {call.attempt!r}, expected the id of one attempt")
    return {"attempt": found}


def run_export(store: Any, call: argparse.Namespace) -> Report:
    from palpate.records.queries import export_csv

    text = export_csv(store, call.long)
    if call.out is None:
        return {"csv": text}
    write_whole(Path(call.out), text.encode())
    return {"out": str(call.out)}


def run_join(store: Any, call: argparse.Namespace) -> Report:
    from palpate.records.people import CONSENT, add_person, give_consent

    if not call.agree:
        return {"code": None, "text": CONSENT[call.language]}
    who = give_consent(store, add_person(store), call.language, True, call.research)
    return {"code": who.code, "text": CONSENT[call.language]}


def run_forget(store: Any, call: argparse.Namespace) -> Report:
    from palpate.records.people import forget

    gone = forget(store, call.code)
    if gone is None:
        raise WrongCall(f"code: got {call.code!r}, expected one that is known here")
    return {"code": call.code.upper(), "removed": gone}


ACTIONS = {"list": run_list, "show": run_show, "export": run_export, "join": run_join,
           "forget": run_forget}  # fmt: skip


def describe_records(report: Report) -> str:
    note = "not validated, not a medical device"
    if "csv" in report:
        return str(report["csv"]).rstrip("\n")
    lines = [f"closed {identity}, which was interrupted" for identity in report["closed"]]
    if report["action"] == "list":
        lines += [describe_row(row) for row in report["attempts"]] or ["no attempts yet"]
    elif report["action"] == "show":
        lines += describe_attempt(report["attempt"])
    elif report["action"] == "forget":
        lines += [f"{count} {name}" for name, count in report["removed"].items()]
    elif report["action"] == "join":
        lines.append(report["text"])
        code = report["code"]
        lines.append(f"code {code}" if code else "nothing is recorded: --agree says they agree")
    else:
        lines.append(f"wrote {report['out']}")
    return "\n".join([*lines, note])


def describe_row(row: Report) -> str:
    level = f" {row['level']}" if row["level"] else ""
    return (
        f"{row['attempt']}  {row['person'] or 'guest':8}  {row['scenario']}{level} "
        f"seed {row['seed']}: {row['outcome']}, {row['ticks']} ticks, {row['started']}"
    )


def describe_attempt(row: Report) -> list[str]:
    lines = [describe_row(row), f"trace {row['trace']}, {row['trace_bytes']} bytes"]
    lines += [f"  {step['outcome']:8} {step['step']}" for step in row["steps"]]
    lines += [f"  {each['name']} {each['value']:g} {each['unit']}" for each in row["metrics"]]
    lines += [f"  tick {each['tick']}: {each['kind']} {each['data']}" for each in row["events"]]
    if row["why_not"]:
        lines.append(f"does not count for judging: {row['why_not']}")
    return lines


RECORDS_VERB = Verb(
    "records",
    "attempts of trainees on this computer: list, show, export, join, forget",
    "palpate records list --most 5",
    add_records,
    run_records,
    describe_records,
)
