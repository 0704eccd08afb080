# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that does again what was done to an organ: rebuild."""

from __future__ import annotations

import argparse
from pathlib import Path

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall
from palpate.files.file_kind import ORGAN
from palpate.files.refusal import Refusal

from palpate_editor.document.files import write_organ
from palpate_editor.rebuild import (
    describe_begin,
    find_difference,
    read_again,
    read_steps,
    rebuild,
    require_history,
)
from palpate_editor.verbs.files import ReadFile, open_any


def add_rebuild(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ")
    parser.add_argument(
        "--original",
        type=Path,
        metavar="FILE",
        help="read the mesh file or the scan again as well; default: the surface that the organ "
        "keeps of it",
    )
    parser.add_argument(
        "--steps", type=int, metavar="N", help="write the organ as it was after the first N"
    )
    add_output(parser, "--out", "-o", writes=ORGAN, help=".organ to write; default: none")


def run_rebuild(call: argparse.Namespace) -> Report:
    if call.steps is not None and call.out is None:
        raise WrongCall("--steps has no effect without --out: all steps are compared")
    read, organ = ReadFile.of(call.file), open_any(call.file)
    steps = read_steps(organ, call.file)
    count = len(steps) if call.steps is None else call.steps
    if not 0 <= count <= len(steps):
        raise Refusal(call.file, "--steps", str(count), f"0 to {len(steps)}, as many as it has")
    if call.original is not None:
        steps = read_again(steps, call.original, call.file)
    made = rebuild(organ, steps[:count], call.file)
    if call.steps is None:
        difference = find_difference(made, organ)
        if difference is not None:
            place, got, kept = difference
            raise Refusal(
                call.file, place, f"{got} from its {count} steps", f"{kept}, as it is in the file"
            )
    if call.out is not None:
        read.check(call.out)
        write_organ(call.out, made)
    return {
        "file": str(call.file),
        "begins_with": describe_begin(require_history(organ, call.file)),
        "steps": [
            {"edit": type(step.edit).__name__, "title": str(step.title), "done": row < count}
            for row, step in enumerate(steps)
        ],
        "same": True if call.steps is None else None,
        "out": None if call.out is None else str(call.out),
    }


def describe_rebuild(report: Report) -> str:
    lines = [f"{report['file']}: begins with {report['begins_with']}"]
    lines += [
        f"  {row + 1:3} {step['title']}" + ("" if step["done"] else " (left out)")
        for row, step in enumerate(report["steps"])
    ]
    if report["same"]:
        lines.append("done again: the same organ, bit for bit")
    if report["out"]:
        lines.append(f"wrote {report['out']}")
    return "\n".join(lines)


VERBS = [
    Verb(
        "rebuild",
        "list what was done to an organ, and do it again from the original: the same bytes",
        "palpate rebuild spleen.organ",
        add_rebuild,
        run_rebuild,
        describe_rebuild,
    ),
]
