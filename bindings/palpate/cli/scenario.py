# SPDX-License-Identifier: BSD-3-Clause
"""The verb `scenario`: a task is put into a published file, checked, and tried out."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from palpate import scenario
from palpate.assessment.check import find_problems
from palpate.assessment.check_parts import find_all_problems
from palpate.assessment.check_problem import ERROR
from palpate.assessment.provenance import (
    REVIEWED,
    describe_selfplay,
    with_review,
    with_selfplay,
)
from palpate.assessment.publish import read_assessment, require_assessment, with_assessment
from palpate.assessment.selfplay import Attempt, judge_hands, play_all
from palpate.assessment.texts import find_text
from palpate.cli import scenario_author, scenario_tools, scenario_values
from palpate.cli.scenario_author import (
    CHANGES,
    describe_authored,
    run_limit,
    run_new,
    run_step,
    run_value,
)
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall
from palpate.files.file_kind import PUBLISHED as PUBLISHED_FILE
from palpate.files.refusal import Refusal
from palpate.runs.run import PUBLISHED, is_published

MOST_SEEDS = 1000


def add_scenario(parser: argparse.ArgumentParser) -> None:
    actions = parser.add_subparsers(dest="action", metavar="ACTION", required=True)
    publish = actions.add_parser(
        "publish", help="put an assessment, a JSON file, into a published organ"
    )
    publish.add_argument("file", type=Path, help=f"published organ, {PUBLISHED}")
    publish.add_argument("assessment", type=Path, help="assessment, .json")
    add_output(publish, "-o", "--out", writes=PUBLISHED_FILE, required=True, help="the new file")
    check = actions.add_parser("check", help="list all that is wrong with a scenario's task")
    check.add_argument("file", type=Path, help=f"published scenario, {PUBLISHED}, or assessment")
    check.add_argument("--organ", type=Path, help=f"that an assessment, .json, is of: {PUBLISHED}")
    selfplay = actions.add_parser(
        "selfplay", help="let careful, idle, violent and clumsy hands play every level"
    )
    selfplay.add_argument("file", type=Path, help=f"published scenario, {PUBLISHED}")
    selfplay.add_argument("--seeds", type=int, default=3, help="of each level; default: 3")
    add_output(selfplay, "-o", "--out", writes=PUBLISHED_FILE,
               help="write the scenario with the report of it in it")  # fmt: skip
    review = actions.add_parser("review", help="note in a scenario who has looked at what of it")
    review.add_argument("file", type=Path, help=f"published scenario, {PUBLISHED}")
    review.add_argument("--of", required=True, choices=REVIEWED)
    review.add_argument("--by", required=True, help="who")
    review.add_argument("--role", required=True, help="as what: surgeon, teacher ...")
    add_output(review, "-o", "--out", writes=PUBLISHED_FILE, required=True, help="the new file")
    new = actions.add_parser("new", help="begin an assessment of a published organ")
    step = actions.add_parser("step", help="add, change, order, mute or remove a step")
    limit = actions.add_parser("limit", help="add, change or remove a limit")
    scenario_author.add_new(new)
    scenario_author.add_step(step)
    scenario_author.add_limit(limit)
    values = []
    for name, (words, add) in VALUES.items():
        values.append(actions.add_parser(name, help=words))
        add(values[-1])
    for action in (publish, check, selfplay, review, new, step, limit, *values):
        action.add_argument(
            "--json",
            action="store_true",
            default=argparse.SUPPRESS,
            help="report as JSON on standard output",
        )


VALUES = {
    "place": ("name a place of the organ, or take one away", scenario_values.add_place),
    "text": ("write a sentence in a language", scenario_values.add_text),
    "level": ("add or remove a level", scenario_values.add_level),
    "parameter": ("set a number that levels change or a seed draws", scenario_values.add_parameter),
    "time": ("set the time limit", scenario_values.add_time),
    "tool": ("say which instruments there are, and their shape", scenario_tools.add_tool),
    "record": ("take the band of a step from a recorded hand", scenario_values.add_record),
}
AUTHOR = {"new": run_new, "step": run_step, "limit": run_limit, **dict.fromkeys(CHANGES, run_value)}


def run_scenario(call: argparse.Namespace) -> Report:
    if call.action in AUTHOR:
        return {"action": call.action, **AUTHOR[call.action](call)}
    if call.action == "check" and call.organ is not None:
        return check_file(call.file, call.organ)
    if not is_published(call.file):
        raise Refusal(
            call.file,
            "",
            f"a name ending in {call.file.suffix!r}",
            f"a published file, {PUBLISHED}",
        )
    if call.action == "publish":
        return publish(call.file, call.assessment, call.out)
    published = scenario.read(call.file)
    assessment = require_assessment(call.file, published)
    report: Report = {
        "action": call.action,
        "scenario": str(call.file),
        "id": assessment["id"],
        "title": find_text(assessment, assessment["title"], "en"),
    }
    if call.action == "check":
        problems = find_problems(published)
        return {**report, "problems": [vars(problem) for problem in problems]}
    if call.action == "review":
        try:
            reviewed = with_review(published, call.of, call.by, call.role)
        except ValueError as problem:
            raise WrongCall(str(problem)) from None
        scenario.write(call.out, reviewed)
        return {**report, "scenario": str(call.out), "problems": []}
    if not 1 <= call.seeds <= MOST_SEEDS:
        raise WrongCall(f"--seeds: got {call.seeds}, expected 1 to {MOST_SEEDS}")
    played = play_all(published, range(call.seeds), tell_attempt)
    if call.out is not None:
        scenario.write(call.out, with_selfplay(published, describe_selfplay(published, played)))
    return {
        **report,
        "attempts": [one.describe() for one in played],
        "problems": judge_hands(played),
    }


def tell_attempt(played: Attempt) -> None:
    print(describe_attempt(played.describe()), file=sys.stderr, flush=True)


def check_file(file: Path, organ: Path) -> Report:
    """All that is wrong with an assessment that is not in a package yet."""
    assessment = read_assessment(file)
    problems = find_all_problems(file, assessment, scenario.read(organ))
    return {"action": "check", "scenario": str(file), "id": assessment.get("id"),
            "title": "", "problems": [vars(problem) for problem in problems]}  # fmt: skip


def publish(file: Path, assessment: Path, out: Path) -> Report:
    made = with_assessment(assessment, read_assessment(assessment), scenario.read(file))
    scenario.write(out, made)
    return {
        "action": "publish",
        "scenario": str(out),
        "title": made.title,
        "problems": [vars(problem) for problem in find_problems(made)],
    }


def describe_scenario(report: Report) -> str:
    if report["action"] in AUTHOR:
        return describe_authored(report)
    lines = [f"{report['scenario']}: {report['title']}"]
    lines += [describe_attempt(each) for each in report.get("attempts", [])]
    for problem in report["problems"]:
        lines.append(f"{problem['severity']}: {problem['where']}: {problem['message']}")
    if not report["problems"]:
        asked = {
            "selfplay": "careful hands finish, idle and violent ones do not",
            "check": "no problems in 20 attempts of each level",
        }
        lines.append(asked.get(report["action"], "written"))
    lines.append("not validated, not a medical device")
    return "\n".join(lines)


def describe_attempt(told: Report) -> str:
    level = f"{told['level']} " if told["level"] else ""
    limits = "".join(f", {name} {count}x" for name, count in told["limits"].items())
    return (
        f"{told['hand']:8} {level}seed {told['seed']}: {told['outcome']} in "
        f"{told['time_s']:.1f} s, {told['errors']} errors{limits}, "
        f"peak {told['peak_force_N']:.2f} N"
    )


def has_errors(report: Report) -> bool:
    return any(problem["severity"] == ERROR for problem in report["problems"])


SCENARIO_VERB = Verb(
    "scenario",
    "scenarios with a task: write one, put it into a published organ, check it, let hands play it",
    "palpate scenario selfplay spleen_push_and_pull.palpate --seeds 3",
    add_scenario,
    run_scenario,
    describe_scenario,
    has_errors,
)
