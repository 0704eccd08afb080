# SPDX-License-Identifier: GPL-3.0-or-later
"""The verbs that repair a surface: repair, remesh."""

from __future__ import annotations

import argparse
from pathlib import Path

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, quantity
from palpate.files.refusal import Refusal

from palpate_editor.check import describe_problem
from palpate_editor.document import Organ
from palpate_editor.edits import (
    CleanUp,
    DropDoubled,
    DropFins,
    DropPieces,
    Edit,
    FillHoles,
    Remesh,
    RemoveCrossings,
    Smooth,
    StitchBorders,
    Wrap,
)
from palpate_editor.edits.change import find_change, say_change
from palpate_editor.edits.clean import SMALL
from palpate_editor.edits.ladder import Rung, climb
from palpate_editor.guarded import TIME
from palpate_editor.repair_all import apply_fix, repair_problems
from palpate_editor.verbs.check import describe_problems
from palpate_editor.verbs.files import (
    OUTPUTS,
    ReadFile,
    apply,
    open_any,
    write_any,
)
from palpate_editor.verbs.holes import add_fill_holes, find_holes
from palpate_editor.verbs.wrapping import add_step, add_wrap, find_number

NOTHING = ""
"""The name of no problem."""

# ---------------------------------------------------------------- repair


def add_repair(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, or OBJ written by `palpate import`")
    parser.add_argument(
        "--all",
        action="store_true",
        help="repair the surface step by step, from cleaning to, where nothing else helps, a wrap; "
        "without any option this is done, and then errors of its material are repaired",
    )
    parser.add_argument(
        "--problem",
        action="append",
        default=[],
        metavar="NAME",
        help="of `palpate check --json`, may be repeated",
    )
    add_steps(parser)
    parser.add_argument(
        "--dry-run", action="store_true", help="say what it would do and cost; write nothing"
    )
    add_output(parser, "--out", "-o", writes=OUTPUTS, help=".organ or mesh file")


def add_steps(parser: argparse.ArgumentParser) -> None:
    """One step each; they are taken in this order."""
    parser.add_argument(
        "--clean",
        action="store_true",
        help="drop doubled and empty triangles and specks, part what only touches, turn outwards",
    )
    told = "join borders that lie so near to each other; default: a twentieth of their edges"
    add_step(parser, "--stitch", "M", told, read=quantity("m"))
    parser.add_argument(
        "--drop-fins",
        action="store_true",
        help="drop triangles that stand on edges of two others and end freely",
    )
    told = f"drop pieces that have less than this part of the area; default: {SMALL:g}"
    add_step(parser, "--drop-pieces", "SHARE", told, usual=SMALL)
    parser.add_argument(
        "--drop-doubled",
        action="store_true",
        help="drop closed pieces inside of others that face outwards too and count twice",
    )
    add_fill_holes(parser)
    told = f"take out triangles that cross others, for at most so long; default: {TIME:g}"
    add_step(parser, "--crossings", "SECONDS", told, usual=TIME)
    parser.add_argument(
        "--smooth", type=int, metavar="STEPS", help="smooth it; it neither shrinks nor swells"
    )
    add_wrap(parser)


def run_repair(call: argparse.Namespace) -> Report:
    check_output(call)
    read = ReadFile.of(call.file)
    organ = open_any(call.file)
    if organ.surface is None:
        raise Refusal(call.file, "organ", "no surface", "an imported mesh")
    asked = list(list_steps(call, organ))
    rungs: list[Rung] = []
    left: list[str] = []
    if call.all or not (asked or call.problem):
        found = climb(organ)
        organ, left = found.organ, [str(text) for text in found.left]
        rungs += found.rungs
    for option, edit in asked:
        after = apply(edit, organ, call.file, option)
        rungs.append(tell_step(edit, organ, after))
        organ = after
    wanted = call.problem or ([NOTHING] if asked or call.all else [])
    assessment, repaired = repair_problems(
        organ,
        wanted,
        (lambda problem, before: apply(problem.fix, before, call.file, problem.where))
        if call.problem
        else apply_fix,
    )
    if not repaired and call.problem:
        raise Refusal(
            call.file, "--problem", ", ".join(call.problem), "problems it has, that can be repaired"
        )
    if not call.dry_run:
        read.check(call.out)
        write_any(call.out, assessment.organ)
    return {
        "out": None if call.dry_run else str(call.out),
        "done": [*(rung.title for rung in rungs), *repaired],
        "steps": [{"step": rung.title, "did": list(map(str, rung.did))} for rung in rungs],
        "left": left,
        "problems": [describe_problem(p, assessment.organ.surface) for p in assessment.problems],
    }


def check_output(call: argparse.Namespace) -> None:
    if call.out is None and not call.dry_run:
        raise Refusal(None, "--out", "nothing", "a file to write, or --dry-run")


def list_steps(call: argparse.Namespace, organ: Organ) -> list[tuple[str, Edit]]:
    """Option and edit of each step that is asked for. Raises Refusal."""
    steps: list[tuple[str, Edit]] = []
    if call.clean:
        steps.append(("--clean", CleanUp()))
    if call.stitch is not None:
        steps.append(("--stitch", StitchBorders(find_number(call.stitch))))
    if call.drop_fins:
        steps.append(("--drop-fins", DropFins()))
    if call.drop_pieces is not None:
        steps.append(("--drop-pieces", DropPieces(call.drop_pieces)))
    if call.drop_doubled:
        steps.append(("--drop-doubled", DropDoubled()))
    if call.fill_holes is not None:
        steps.append(("--fill-holes", choose_holes(call, organ)))
    if call.crossings is not None:
        steps.append(("--crossings", RemoveCrossings(call.crossings)))
    if call.smooth is not None:
        steps.append(("--smooth", Smooth(call.smooth)))
    if call.wrap is not None:
        steps.append(("--wrap", Wrap(find_number(call.wrap), past_holes=True)))
    return steps


def tell_step(edit: Edit, before: Organ, after: Organ) -> Rung:
    change = find_change(edit, before, after)
    return Rung(edit.title, () if change is None else tuple(say_change(change)))


def choose_holes(call: argparse.Namespace, organ: Organ) -> FillHoles:
    """Those that the call wants closed. Raises Refusal."""
    holes = find_holes(call, organ)
    if not holes:
        raise Refusal(call.file, "--fill-holes", "a closed surface", "holes to fill")
    return FillHoles(tuple(holes), even=True, bent=True)


def describe_repair(report: Report) -> str:
    lines = []
    for step in report["steps"]:
        lines += [f"{step['step']}:", *(f"  {text}" for text in step["did"])]
    done = ", ".join(report["done"]) or "nothing to repair"
    out = "nothing written" if report["out"] is None else f"wrote {report['out']}"
    lines.append(f"{out}: {done}")
    lines += [f"  left: {text}" for text in report["left"]]
    return "\n".join([*lines, "what is left:", *describe_problems(report["problems"])])


# ---------------------------------------------------------------- remesh


def add_remesh(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, or OBJ written by `palpate import`")
    parser.add_argument(
        "--edge-length",
        type=quantity("m"),
        required=True,
        metavar="M",
        help="of most edges, such as 3mm",
    )
    parser.add_argument("--region", default="", metavar="NAME", help="where edges are shorter")
    parser.add_argument(
        "--region-edge-length", type=quantity("m"), metavar="M", help="of the edges there"
    )
    parser.add_argument(
        "--dry-run", action="store_true", help="say what it would do and cost; write nothing"
    )
    add_output(parser, "--out", "-o", writes=OUTPUTS, help=".organ or mesh file")


def run_remesh(call: argparse.Namespace) -> Report:
    check_output(call)
    read = ReadFile.of(call.file)
    organ = open_any(call.file)
    edit = Remesh(call.edge_length, call.region, call.region_edge_length)
    after = apply(edit, organ, call.file, "--edge-length")
    assert after.surface is not None and after.decimation is not None
    rung = tell_step(edit, organ, after)
    if not call.dry_run:
        read.check(call.out)
        write_any(call.out, after)
    return {
        "out": None if call.dry_run else str(call.out),
        "step": rung.title,
        "did": list(map(str, rung.did)),
        "vertices": after.decimation.vertices,
        "triangles": after.decimation.triangles,
        "smallest_angle_deg": after.decimation.smallest_angle_deg,
        "mean_distance_mm": 1e3 * after.decimation.mean_distance,
        "max_distance_mm": 1e3 * after.decimation.max_distance,
    }


def describe_remesh(report: Report) -> str:
    out = "nothing written" if report["out"] is None else f"wrote {report['out']}"
    mean, most = report["mean_distance_mm"], report["max_distance_mm"]
    return "\n".join(
        [
            f"{report['step']}:",
            *(f"  {text}" for text in report["did"]),
            f"{out}: {report['vertices']} vertices, {report['triangles']} triangles; smallest "
            f"angle {report['smallest_angle_deg']:.1f} degrees; {mean:.3f} mm from the imported "
            f"surface on average, {most:.3f} mm at most",
        ]
    )


VERBS = [
    Verb(
        "repair",
        "repair a surface, step by step or all at once, and say what each step did",
        "palpate repair spleen.organ --fill-holes 12 --crossings -o spleen.organ",
        add_repair,
        run_repair,
        describe_repair,
    ),
    Verb(
        "remesh",
        "make the triangles of a surface even, of a chosen size",
        "palpate remesh spleen.organ --edge-length 4mm -o spleen.organ",
        add_remesh,
        run_remesh,
        describe_remesh,
    ),
]
