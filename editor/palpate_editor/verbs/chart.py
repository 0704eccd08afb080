# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `chart`: what each way to simulate an organ costs, and how far it is from the truth."""

from __future__ import annotations

import argparse
import shlex
import sys
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import palpate
from palpate.cli.press import read_point
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall, quantity
from palpate.files.file_kind import CHART, PICTURE, SVG
from palpate.files.refusal import Refusal
from palpate.runs.script_file import read_script_file
from palpate.study.chart_file import read_chart, write_chart

from palpate_editor.document import Organ
from palpate_editor.verbs.files import open_any

if TYPE_CHECKING:  # they load SciPy and matplotlib
    from palpate.study.scene_chart import Chart
    from palpate.study.truth import Truth

    from palpate_editor.chart import Step
    from palpate_editor.chart_jobs import Plan
    from palpate_editor.chart_pool import Runner

PATHS = ("press", "pull", "drag")
MOST_WORKERS = 256


def add_chart(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate or .scene.json")
    parser.add_argument(
        "--path",
        default="press",
        metavar="|".join((*PATHS, "FILE")),
        help="of the hand, with the organ's own tool, as deep as the truth goes; FILE: a script",
    )
    parser.add_argument(
        "--place",
        type=read_point,
        metavar="X,Y,Z",
        help="begin at the surface point nearest to this [mm] (where a check presses first)",
    )
    parser.add_argument(
        "--speed", type=quantity("m/s"), metavar="M/S", help="of the hand, mean (10mm/s)"
    )
    parser.add_argument(
        "--truth",
        type=Path,
        metavar="FILE.truth",
        help="hold against this instead of solving; as `palpate truth --output` writes it",
    )
    parser.add_argument(
        "--workers", type=read_count, metavar="N", help="run rows in so many processes at once (1)"
    )
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="run rows on the Dask cluster of this scheduler: tcp://HOST:PORT",
    )
    parser.add_argument(
        "--resume",
        type=Path,
        metavar="FOLDER",
        help="keep every finished run in this folder at once, and take what it has",
    )
    parser.add_argument(
        "--rerun",
        type=Path,
        metavar="CHART.json",
        help="run one row in ten of this chart again, and say whether its errors are the same",
    )
    add_output(parser, "--output", "-o", writes=CHART, metavar="CHART.json", help="keep the chart")
    add_output(parser, "--png", writes=PICTURE, metavar="FILE.png", help="draw it")
    add_output(parser, "--svg", writes=SVG, metavar="FILE.svg", help="draw it, to be scaled")


def read_count(text: str) -> int:
    count = int(text) if text.isdecimal() else 0
    if not 1 <= count <= MOST_WORKERS:
        raise argparse.ArgumentTypeError(
            f"got {text!r}, expected a whole number of 1 to {MOST_WORKERS}"
        )
    return count


def check_call(call: argparse.Namespace) -> None:
    """Raises WrongCall for options that do not fit together."""
    if call.speed is not None and not call.speed > 0.0:
        raise WrongCall(f"--speed: got {1e3 * call.speed:g} mm/s, expected one above 0")
    if call.scheduler is not None and call.workers is not None:
        raise WrongCall("--workers is of this machine and --scheduler of a cluster: give one")
    if call.path not in PATHS:
        for option in ("speed", "place"):
            if getattr(call, option) is not None:
                raise WrongCall(f"--{option} has no effect on a script, which says it by itself")
    if call.truth is not None and call.place is not None:
        raise WrongCall("--place has no effect on a --truth, which has its own")
    for option in ("output", "png", "svg", "resume"):
        if call.rerun is not None and getattr(call, option) is not None:
            raise WrongCall(f"--{option} has no effect on --rerun, which draws nothing")


def run_chart(call: argparse.Namespace) -> Report:
    check_call(call)
    # they load SciPy, which every other command does without
    from palpate_editor.chart import compute_key, draw_chart
    from palpate_editor.chart_store import Store

    before = None if call.rerun is None else read_chart(call.rerun)
    organ = open_any(call.file)
    plan = make_plan(call, organ)
    runner = choose_runner(call)
    if before is not None:
        return rerun(call, plan, before, runner)
    with Store(compute_key(plan), call.resume) as store:
        chart = draw_chart(
            plan,
            runner=runner,
            store=store,
            told=tell,
            script="" if call.path in PATHS else Path(call.path).name,
            command=write_command(call),
        )
    return keep(call, chart)


def make_plan(call: argparse.Namespace, organ: Organ) -> Plan:
    """Organ, truth and path. Raises Refusal or OSError."""
    from palpate.study.track import SPEED

    from palpate_editor.chart_jobs import Plan, pack_document

    if organ.surface is None:
        raise Refusal(call.file, "organ", "no surface", "an imported mesh")
    is_script = call.path not in PATHS
    keys = read_script_file(Path(call.path)) if is_script else []
    frames = tuple((key.time, tuple(key.position.tolist()), key.buttons) for key in keys)
    return Plan(
        organ=pack_document(organ),
        truth=find_truth(call, organ, keys),
        path="script" if is_script else call.path,
        speed=0.0 if is_script else SPEED if call.speed is None else call.speed,
        frames=frames,
    )


def find_truth(call: argparse.Namespace, organ: Organ, frames: list[palpate.KeyFrame]) -> Truth:
    """Read, or solved and kept. Raises Refusal or OSError."""
    from palpate.study.truth_file import read_truth

    from palpate_editor import truth as solver
    from palpate_editor.verbs.truth import Teller, TruthRefusal

    if call.truth is not None:
        return check_truth(call, organ, read_truth(call.truth))
    near = None if call.place is None else tuple(map(float, call.place))
    kinds = {"press": solver.Press, "pull": solver.Pull, "drag": solver.Drag}
    way = kinds[call.path](near) if call.path in kinds else solver.Script(frames)
    try:
        return solver.solve_truth(organ, way, progress=Teller())
    except solver.TruthError as refused:
        raise TruthRefusal(call.file, str(refused)) from None


def check_truth(call: argparse.Namespace, organ: Organ, truth: Truth) -> Truth:
    """Of this tool and path. Raises Refusal."""
    wanted = "script" if call.path not in PATHS else call.path
    if truth.path != wanted:
        raise Refusal(call.truth, "path", truth.path, f"{wanted}, as --path says")
    if abs(truth.radius - organ.tool.radius) > 1e-9:
        ball = f"{1e3 * organ.tool.radius:g} mm, the organ's own tool"
        raise Refusal(call.truth, "radius", f"{1e3 * truth.radius:g} mm", ball)
    beside = find_farthest(organ, truth)
    if beside > truth.radius:
        got = f"a place {1e3 * beside:.3g} mm off the surface"
        raise Refusal(call.truth, "point", got, f"places of {call.file.name}: it is another body's")
    return truth


def find_farthest(organ: Organ, truth: Truth) -> float:
    """[m] from the organ to the place of a truth that is farthest off it."""
    assert organ.surface is not None
    vertices, triangles = organ.surface.vertices, organ.surface.triangles
    tree = palpate.AabbTree(vertices, triangles)
    nearest = (palpate.find_closest_point(tree, vertices, point) for point in truth.point)
    return max(found.distance for found in nearest if found is not None)


def choose_runner(call: argparse.Namespace) -> Runner:
    from palpate_editor.chart_pool import run_in_processes

    if call.scheduler is None:
        return run_in_processes(call.workers or 1)
    from palpate_editor.chart_cluster import run_on_cluster

    return run_on_cluster(call.scheduler)


def tell(step: Step) -> None:
    """On the terminal, what was finished."""
    name = "" if step.row is None else f" {step.row.name}"
    reason = "" if step.row is None or not step.row.reason else f": {step.row.reason}"
    print(f"{step.stage} {step.done}/{step.all}{name}{reason}", file=sys.stderr)


def write_command(call: argparse.Namespace) -> str:
    """What draws the chart again, wherever it is run."""
    words = ["palpate", "chart", str(call.file)]
    if call.path != "press":
        words += ["--path", call.path]
    if call.place is not None:
        words += ["--place", ",".join(f"{1e3 * value:g}" for value in call.place)]
    if call.speed is not None:
        words += ["--speed", f"{1e3 * call.speed:g}mm/s"]
    return shlex.join(words)


def keep(call: argparse.Namespace, chart: Chart) -> Report:
    """Writes what was asked for. Raises OSError, or Refusal where there is nothing to draw."""
    from palpate.study.scene_chart import find_front
    from palpate.study.scene_chart_plot import save_scene_chart

    if call.output is not None:
        write_chart(call.output, chart)
    for option in ("png", "svg"):
        out = getattr(call, option)
        if out is not None and not chart.list_ran():
            raise Refusal(out, f"--{option}", "no row that came to its end", "a point to draw")
        if out is not None:
            save_scene_chart(out, chart)
    return {
        **asdict(chart),
        "front": [row.number for row in find_front(chart.rows)],
        "files": [str(getattr(call, name)) for name in ("output", "png", "svg")
                  if getattr(call, name) is not None],
    }  # fmt: skip


def rerun(call: argparse.Namespace, plan: Plan, before: Chart, runner: Runner) -> Report:
    from palpate_editor.chart_rerun import rerun_chart

    return {"chart": str(call.rerun), "rerun": rerun_chart(call.rerun, plan, before, runner)}


def describe_chart(report: Report) -> str:
    if "rerun" in report:
        return "\n".join(map(describe_rerun, report["rerun"]))
    rows, front = report["rows"], report["front"]
    lines = [describe_row(row, row["number"] in front) for row in rows]
    failed = [row for row in rows if row["outcome"] != "ran"]
    truth = report["truth"]
    lines.append(
        f"{len(rows) - len(failed)} of {len(rows)} came to their end; * is on the front. Truth: "
        f"{1e3 * truth['force']:.3g} mN, known to {truth['force_error']:.1%}."
    )
    if not report["complete"]:
        lines.append("not finished: with --resume FOLDER a second call goes on from here")
    lines += [f"wrote {file}" for file in report["files"]]
    return "\n".join(lines)


def describe_row(row: Report, on_front: bool) -> str:
    if row["outcome"] != "ran":
        return f"  {row['name']}: {row['outcome']}: {row['reason']}"
    total, cost = row["total"], row["cost"]
    spent = "not timed" if cost is None else f"{1e6 * cost['median']:.0f} us"
    parts = [f"{100 * total['force_rms']:.3g} % force"]
    if total["displacement"] is not None:
        parts.append(f"{100 * total['displacement']:.3g} % displacement")
    limited = " (reference-limited)" if row["reference_limited"] else ""
    own = ", as it is now" if row["own"] else ""
    return f"{'*' if on_front else ' '} {row['name']}{own}: {spent}, {', '.join(parts)}{limited}"


def describe_rerun(row: Report) -> str:
    said = "the same to the bit" if row["largest"] == 0.0 else f"off by {row['largest']:.1e}"
    return f"{'  ' if row['same'] else 'X '}{row['name']}: {said}"


def has_failed(report: Report) -> bool:
    return not all(row["same"] for row in report.get("rerun", ()))


VERBS = [
    Verb(
        "chart",
        "chart what each way to simulate an organ costs against how far it is from the truth",
        "palpate chart spleen.organ -o spleen.chart.json --png spleen.png",
        add_chart,
        run_chart,
        describe_chart,
        has_failed,
    )
]
