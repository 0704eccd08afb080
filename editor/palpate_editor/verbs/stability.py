# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `stability`: how long a step of each way to simulate an organ may be."""

from __future__ import annotations

import argparse
import shlex
import sys
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from palpate.command.output import Files, add_output_folder
from palpate.command.verb import Report, Verb, WrongCall
from palpate.files.file_kind import ATLAS, PICTURE, SVG
from palpate.files.refusal import Refusal
from palpate.study.atlas_file import read_atlas, write_atlas

from palpate_editor.verbs.chart import describe_rerun, has_failed, read_count
from palpate_editor.verbs.files import open_any

if TYPE_CHECKING:  # they load SciPy and matplotlib
    from palpate.study.atlas import Atlas

    from palpate_editor.atlas import Step
    from palpate_editor.atlas_jobs import Plan

KINDS = {".json": ATLAS, ".png": PICTURE, ".svg": SVG}
"""Ending -> what is written."""


def add_stability(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate or .scene.json")
    add_output_folder(
        parser,
        "--out",
        writes=list_outputs,
        metavar="DIR",
        help="keep the atlas in this folder as NAME.json, and draw it as NAME.png and NAME.svg",
    )
    parser.add_argument(
        "--workers", type=read_count, metavar="N", help="run in so many processes at once (1)"
    )
    parser.add_argument(
        "--resume",
        type=Path,
        metavar="FOLDER",
        help="keep every finished tissue in this folder at once, and take what it has",
    )
    parser.add_argument(
        "--rerun",
        type=Path,
        metavar="ATLAS.json",
        help="run a random tenth of this atlas again, and say whether its limits are the same",
    )


def list_outputs(call: argparse.Namespace) -> Files:
    return [(find_output(call, ending), kind) for ending, kind in KINDS.items()]


def find_output(call: argparse.Namespace, ending: str) -> Path:
    """NAME.json of NAME.organ, NAME.palpate or NAME.scene.json."""
    out: Path = call.out
    return out / f"{call.file.name.split('.')[0] or 'organ'}{ending}"


def run_stability(call: argparse.Namespace) -> Report:
    for option in ("out", "resume"):
        if call.rerun is not None and getattr(call, option) is not None:
            raise WrongCall(f"--{option} has no effect on --rerun, which draws nothing")
    # they load SciPy, which every other command does without
    from palpate_editor.atlas import compute_key, draw_atlas, run_tissues
    from palpate_editor.atlas_store import Store

    before = None if call.rerun is None else read_atlas(call.rerun)
    plan = make_plan(call)
    runner = run_tissues(call.workers or 1)
    if before is not None:
        from palpate_editor.atlas_rerun import rerun_atlas

        return {"atlas": str(call.rerun), "rerun": rerun_atlas(call.rerun, plan, before, runner)}
    with Store(compute_key(plan), call.resume) as store:
        atlas = draw_atlas(
            plan,
            runner=runner,
            store=store,
            told=tell,
            command=shlex.join(["palpate", "stability", str(call.file)]),
        )
    return keep(call, atlas)


def make_plan(call: argparse.Namespace) -> Plan:
    """Raises Refusal or OSError."""
    from palpate_editor.atlas_jobs import Plan
    from palpate_editor.chart_jobs import pack_document

    organ = open_any(call.file)
    if organ.surface is None:
        raise Refusal(call.file, "organ", "no surface", "an imported mesh")
    return Plan(pack_document(organ))


def tell(step: Step) -> None:
    """On the terminal, what was finished."""
    spot = step.rows[0].spot if step.rows else None
    name = "" if spot is None else (
        f" {spot.kind}, {spot.stiffness:g} x stiffness, damping {spot.damping}, mesh {spot.mesh}"
    )  # fmt: skip
    print(f"{step.done}/{step.all}{name}", file=sys.stderr)


def keep(call: argparse.Namespace, atlas: Atlas) -> Report:
    """Writes what was asked for. Raises OSError, or Refusal where there is nothing to draw."""
    files = []
    if call.out is not None:
        from palpate.study.atlas_plot import save_atlas

        if not atlas.rows:
            raise Refusal(call.out, "--out", "no tissue that was finished", "a row to draw")
        call.out.mkdir(parents=True, exist_ok=True)
        write_atlas(find_output(call, ".json"), atlas)
        for ending in (".png", ".svg"):
            save_atlas(find_output(call, ending), atlas)
        files = [str(path) for path, _ in list_outputs(call)]
    return {**asdict(atlas), "files": files}


def describe_stability(report: Report) -> str:
    if "rerun" in report:
        return "\n".join(map(describe_rerun, report["rerun"]))
    from palpate.files.json_part import read_part
    from palpate.study.atlas import Atlas
    from palpate.study.atlas_words import say_present

    given = {name: value for name, value in report.items() if name != "files"}
    atlas: Atlas = read_part(None, "report", Atlas, given | {"rows": list(given["rows"])})
    lines = [
        f"{row.spot.kind}, {row.integrator}: {describe_row(row, atlas.rate)}"
        for kind in atlas.list_kinds()
        for name in atlas.list_integrators()
        if (row := atlas.find_usual(kind, name)) is not None
    ]
    lines.append(f"{len(atlas.rows)} rows; {say_present(atlas.present)}")
    if not atlas.complete:
        lines.append("not finished: with --resume FOLDER a second call goes on from here")
    return "\n".join([*lines, *(f"wrote {file}" for file in report["files"])])


def describe_row(row: object, rate: float) -> str:
    from palpate.study.atlas import LIMITED, Row
    from palpate.study.atlas_words import say_row, write_step

    assert isinstance(row, Row)
    said = ", ".join(filter(None, (*say_row(row, rate), row.reason)))
    if row.outcome == LIMITED and row.predicted is not None:
        said += f" (foretold {write_step(row.predicted)})"
    return said


VERBS = [
    Verb(
        "stability",
        "find how long a time step of each way to simulate an organ may be before it blows up",
        "palpate stability spleen.organ --out atlases",
        add_stability,
        run_stability,
        describe_stability,
        has_failed,
    )
]
