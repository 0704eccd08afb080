# SPDX-License-Identifier: GPL-3.0-or-later
"""The verbs before a trainee gets an organ: repair, publish."""

from __future__ import annotations

import argparse
from pathlib import Path

import palpate
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb
from palpate.files.file_kind import PUBLISHED
from palpate.files.refusal import Refusal

from palpate_editor.check import describe_problem
from palpate_editor.document import Organ
from palpate_editor.edits import FillHoles, SetTask
from palpate_editor.publish import PublishError, publish
from palpate_editor.repair_all import repair_all
from palpate_editor.verbs.check import describe_problems
from palpate_editor.verbs.files import (
    OUTPUTS,
    ReadFile,
    apply,
    describe_loops,
    open_any,
    write_any,
)

EVERY_HOLE = 2**31 - 1
"""[edges] More than any hole has."""
NO_PROBLEM = ""
"""The name of none."""

# ---------------------------------------------------------------- repair


def add_repair(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, or OBJ written by `palpate import`")
    parser.add_argument(
        "--problem",
        action="append",
        default=[],
        metavar="NAME",
        help="of `palpate check --json`, may be repeated; default: all errors that can be repaired",
    )
    parser.add_argument(
        "--fill-holes",
        type=int,
        nargs="?",
        const=EVERY_HOLE,
        metavar="EDGES",
        help="close every hole, or those of at most so many edges; other problems are repaired "
        "only where --problem names them",
    )
    add_output(parser, "--out", "-o", writes=OUTPUTS, required=True, help=".organ or mesh file")


def run_repair(call: argparse.Namespace) -> Report:
    read = ReadFile.of(call.file)
    organ = open_any(call.file)
    done: list[str] = []
    if call.fill_holes is not None:
        organ = fill_holes(call, organ)
        done.append(FillHoles.title)
    wanted = call.problem or ([] if call.fill_holes is None else [NO_PROBLEM])
    assessment, repaired = repair_all(
        organ,
        wanted,
        lambda problem, before: apply(problem.fix, before, call.file, problem.where),
    )
    organ, done = assessment.organ, done + repaired
    if not done and call.problem:
        raise Refusal(
            call.file, "--problem", ", ".join(call.problem), "problems it has, that can be repaired"
        )
    read.check(call.out)
    write_any(call.out, organ)
    return {
        "out": str(call.out),
        "done": done,
        "problems": [describe_problem(p, organ.surface) for p in assessment.problems],
    }


def fill_holes(call: argparse.Namespace, organ: Organ) -> Organ:
    """The organ without those holes the call wants closed. Raises Refusal."""
    if organ.surface is None:
        raise Refusal(call.file, "organ", "no surface", "an imported mesh")
    sizes = [len(loop) for loop in palpate.find_border_loops(organ.surface.triangles)]
    holes = tuple(i for i, size in enumerate(sizes) if size <= call.fill_holes)
    if not holes:
        found = f"{describe_loops(sizes)}, none of at most {call.fill_holes} edges"
        raise Refusal(
            call.file, "--fill-holes", found if sizes else "a closed surface", "holes to fill"
        )
    return apply(FillHoles(holes), organ, call.file, "--fill-holes")


def describe_repair(report: Report) -> str:
    done = ", ".join(report["done"]) or "nothing to repair"
    heading = f"wrote {report['out']}: {done}; what is left:"
    return "\n".join([heading, *describe_problems(report["problems"])])


# ---------------------------------------------------------------- publish


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
        return {"published": True, **publish(organ, call.out)}
    except PublishError as refused:
        problems = list(map(describe_problem, refused.problems))
        return {"published": False, "out": None, "problems": problems}


def describe_publish(report: Report) -> str:
    problems = describe_problems(report["problems"])
    if not report["published"]:
        return "\n".join(["not published:", *problems])
    lines = [f"wrote {report['out']}: {report['title']}; {report['description']}"]
    return "\n".join(lines + (problems if report["problems"] else []))


VERBS = [
    Verb(
        "repair",
        "repair the problems of an organ that need no choice",
        "palpate repair spleen.organ --problem shells --fill-holes 12 -o spleen.organ",
        add_repair,
        run_repair,
        describe_repair,
    ),
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
