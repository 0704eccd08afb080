# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that makes the file a trainee gets."""

from __future__ import annotations

import argparse
from pathlib import Path

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb
from palpate.files.file_kind import PUBLISHED
from palpate.files.refusal import Refusal

from palpate_editor.check import describe_problem
from palpate_editor.document.cost_rules import LATE
from palpate_editor.edits import SetTask
from palpate_editor.publish import PublishError, publish
from palpate_editor.verbs.check import describe_problems
from palpate_editor.verbs.files import ReadFile, apply, open_any


def add_publish(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate or .scene.json")
    parser.add_argument("--title", help="what the trainee chooses it by; default: the document's")
    parser.add_argument("--task", help="what the trainee is asked to do; default: the document's")
    parser.add_argument(
        "--in",
        dest="language",
        default="",
        metavar="LANGUAGE",
        help="--title and --task are a translation, such as tr",
    )
    parser.add_argument(
        "--slow",
        action="store_true",
        help="also where a tick in touch takes longer than there is on the reference machine, up "
        "to four times: for a faster one",
    )
    add_output(
        parser, "--out", "-o", writes=PUBLISHED, required=True, help=".palpate file to write"
    )


def run_publish(call: argparse.Namespace) -> Report:
    if call.out.suffix != ".palpate":
        raise Refusal(call.out, "", f"a name ending in {call.out.suffix!r}", ".palpate")
    read = ReadFile.of(call.file)
    organ = open_any(call.file)
    if call.title is not None or call.task is not None:
        edit = SetTask(call.title, call.task, call.language)
        organ = apply(edit, organ, call.file, "--title, --task")
    read.check(call.out)
    try:
        return {"published": True, **publish(organ, call.out, slow=call.slow)}
    except PublishError as refused:
        problems = list(map(describe_problem, refused.problems))
        return {"published": False, "out": None, "problems": problems}


def describe_publish(report: Report) -> str:
    problems = describe_problems(report["problems"])
    if not report["published"]:
        return "\n".join(["not published:", *problems, *suggest_ways_out(report["problems"])])
    lines = [f"wrote {report['out']}: {report['title']}; {report['description']}"]
    return "\n".join(lines + (problems if report["problems"] else []))


def suggest_ways_out(problems: list[Report]) -> list[str]:
    """How an organ that is late can be published as it is."""
    if not any(problem["problem"] == LATE for problem in problems):
        return []
    return [
        "  palpate material FILE --exchange-rate 100Hz -o FILE lets it tick beside the hand; "
        "--slow publishes it for a faster machine"
    ]


VERBS = [
    Verb(
        "publish",
        "check an organ and write the file that a trainee opens",
        "palpate publish spleen.organ --title Spleen -o spleen.palpate",
        add_publish,
        run_publish,
        describe_publish,
        failed=lambda report: not report["published"],
    ),
]
