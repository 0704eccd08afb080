# SPDX-License-Identifier: BSD-3-Clause
"""The verb `replay`: a record run again, and compared bit by bit."""

from __future__ import annotations

import argparse
from pathlib import Path

from palpate.command.verb import Report, Verb
from palpate.runs.replay import run_replay


def add_replay(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("record", type=Path, help=".prec record")
    parser.add_argument(
        "--scene", type=Path, help="scene file or published file; default: the one the record names"
    )


def run_replay_verb(call: argparse.Namespace) -> Report:
    return run_replay(call.record, call.scene)


def describe_replay(report: Report) -> str:
    if report["equal"]:
        cut = "" if report["complete"] else "; the record ends before the run did"
        return f"{report['ticks']} ticks, the same bits{cut}"
    return (
        f"{report['ticks']} ticks, NOT equal from tick {report['first_difference']}: forces differ "
        f"by up to {report['largest_force_difference_N']:g} N, the tool by up to "
        f"{1e3 * report['largest_position_difference_m']:g} mm\n{explain_difference(report)}"
    )


ARITHMETIC = {
    "palpate": "version of palpate",
    "kernel": "kernel",
    "vector_target": "vector target",
}
"""What a record's header says of how its ticks were rounded, in words."""


def explain_difference(report: Report) -> str:
    """Why a replay may differ from its record."""
    changed = [
        f"{ARITHMETIC[name]} {found['record']!r} (here {found['here']!r})"
        for name, found in report["changed"].items()
    ]
    if not changed:
        return (
            "version, kernel and vector target are those of the record, so the program or the "
            "record has been changed"
        )
    return (
        f"the record was made with {', '.join(changed)}: another one rounds otherwise, so the same "
        "bits cannot be expected here"
    )


REPLAY = Verb(
    "replay",
    "run a record again and compare it bit by bit",
    "palpate replay press.prec",
    add_replay,
    run_replay_verb,
    describe_replay,
    failed=lambda report: not report["equal"],
)
