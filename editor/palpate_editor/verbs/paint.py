# SPDX-License-Identifier: GPL-3.0-or-later
"""The verbs for what a hand does in the window: paint and text."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall
from palpate.files.file_kind import ORGAN

from palpate_editor.argument_text import read_factors, read_ids, read_region
from palpate_editor.document import Organ
from palpate_editor.document.files import write_organ
from palpate_editor.edits import (
    FixVertices,
    PaintStiffness,
    RemoveRegion,
    SetName,
    SetRegion,
    SetTask,
)
from palpate_editor.verbs.files import ReadFile, apply, open_any

NOTHING = "nothing to do: name what is painted"


# ---------------------------------------------------------------- paint


def add_paint(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .scene.json, or OBJ of `palpate import`")
    parser.add_argument(
        "--stiffness",
        type=read_factors,
        action="append",
        default=[],
        metavar="VERTICES:FACTOR,...",
        help="factors of the stiffness at some vertices, such as 5-9:2.5,12:1; may be repeated",
    )
    parser.add_argument(
        "--fix", type=read_ids, metavar="VERTICES", help="hold these at rest: 3,5-9"
    )
    parser.add_argument("--free", type=read_ids, metavar="VERTICES", help="let these go")
    parser.add_argument(
        "--region",
        type=read_region,
        action="append",
        default=[],
        metavar="NAME=VERTICES",
        help="give some vertices a name; may be repeated",
    )
    parser.add_argument("--forget", action="append", default=[], metavar="NAME", help="of a region")
    add_output(parser, "--out", "-o", writes=ORGAN, required=True, help=".organ to write")


def run_paint(call: argparse.Namespace) -> Report:
    read = ReadFile.of(call.file)
    organ = open_any(call.file)
    before = organ
    if call.stiffness:
        ids = np.concatenate([ids for ids, _ in call.stiffness])
        values = np.concatenate([values for _, values in call.stiffness])
        organ = apply(PaintStiffness(ids, values), organ, call.file, "--stiffness")
    for option, ids, fixed in (("--fix", call.fix, True), ("--free", call.free, False)):
        if ids is not None:
            organ = apply(FixVertices(ids, fixed), organ, call.file, option)
    for name, ids in call.region:
        organ = apply(SetRegion(name, ids), organ, call.file, "--region")
    for name in call.forget:
        organ = apply(RemoveRegion(name), organ, call.file, "--forget")
    if organ is before:
        raise WrongCall("--stiffness, --fix, --free, --region or --forget: " + NOTHING)
    read.check(call.out)
    write_organ(call.out, organ)
    return describe_organ(call.out, organ)


def describe_organ(out: Path, organ: Organ) -> Report:
    return {
        "out": str(out),
        "vertices": organ.vertex_count,
        "fixed": int(organ.fixed.sum()),
        "painted": int((organ.stiffness_scale != 1.0).sum()),
        "regions": {name: len(ids) for name, ids in organ.regions.items()},
    }


def describe_paint(report: Report) -> str:
    regions = ", ".join(f"{name} ({count})" for name, count in report["regions"].items())
    return (
        f"wrote {report['out']}: of {report['vertices']} vertices {report['fixed']} fixed, "
        f"{report['painted']} with a stiffness of their own; regions: {regions or 'none'}"
    )


# ---------------------------------------------------------------- text


def add_texts(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate or .scene.json")
    parser.add_argument("--name", help="of the organ")
    parser.add_argument("--title", help="what the trainee chooses it by")
    parser.add_argument("--task", help="what the trainee is asked to do")
    parser.add_argument(
        "--in",
        dest="language",
        default="",
        metavar="LANGUAGE",
        help="title and task are a translation, such as tr; both empty take it away",
    )
    add_output(parser, "--out", "-o", writes=ORGAN, required=True, help=".organ to write")


def run_texts(call: argparse.Namespace) -> Report:
    if call.name is None and call.title is None and call.task is None:
        raise WrongCall("--name, --title or --task: nothing to do: say one of them")
    read = ReadFile.of(call.file)
    organ = open_any(call.file)
    if call.name is not None:
        organ = apply(SetName(call.name), organ, call.file, "--name")
    if call.title is not None or call.task is not None:
        edit = SetTask(call.title, call.task, call.language)
        organ = apply(edit, organ, call.file, "--title, --task")
    read.check(call.out)
    write_organ(call.out, organ)
    return {
        "out": str(call.out),
        "name": organ.name,
        "title": organ.title,
        "task": organ.task,
        "languages": {
            code: {"title": translation.title, "task": translation.task}
            for code, translation in organ.languages.items()
        },
    }


def describe_texts(report: Report) -> str:
    lines = [f"wrote {report['out']}: {report['name']}", f"{report['title']}: {report['task']}"]
    lines += [
        f"{code}: {translation['title']}: {translation['task']}"
        for code, translation in report["languages"].items()
    ]
    return "\n".join(lines)


VERBS = [
    Verb(
        "paint",
        "give some vertices of an organ a stiffness or a name, hold them or let them go",
        "palpate paint spleen.organ --stiffness 20-30:2.5 --fix 0-9 -o spleen.organ",
        add_paint,
        run_paint,
        describe_paint,
    ),
    Verb(
        "text",
        "name an organ, and say title and task of its scenario, in further languages too",
        "palpate text spleen.organ --title Dalak --in tr -o spleen.organ",
        add_texts,
        run_texts,
        describe_texts,
    ),
]
