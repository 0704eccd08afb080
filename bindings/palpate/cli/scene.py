# SPDX-License-Identifier: BSD-3-Clause
"""The verb `scene`: several published organs are placed in one scene, checked and published."""

from __future__ import annotations

import argparse
import math
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from palpate import FileError, scenario
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall, quantity
from palpate.files.file_kind import LAYOUT, PUBLISHED
from palpate.files.refusal import Refusal
from palpate.layout import document
from palpate.layout.check import check, describe_pair
from palpate.layout.document import (
    History,
    Layout,
    LayoutError,
    PlacedBody,
    TouchingPair,
    read_layout,
    write_layout,
)
from palpate.layout.gaps import Surface
from palpate.layout.placed import build_body, find_region, find_surface, read_organ, read_placed
from palpate.layout.publish import make_scenario
from palpate.layout.snap import measure_patch, snap
from palpate.scene.scene_file import hash_file

SNAP_GAP = 5e-4
"""[m] The thickest barrier that is chosen."""
READS = {"new": "write a layout without bodies", "add": "place a published organ in it",
         "place": "move, turn, snap or remove a body, or let it fold",
         "pair": "say which two bodies may touch", "undo": "take back the last change",
         "redo": "make it again", "check": "list overlaps, costs and all that is wrong",
         "publish": "write what `palpate press` and `palpate play` run"}  # fmt: skip


def add_scene(parser: argparse.ArgumentParser) -> None:
    actions = parser.add_subparsers(dest="action", metavar="ACTION", required=True)
    made = {name: actions.add_parser(name, help=text) for name, text in READS.items()}
    add_output(made["new"], "--out", "-o", dest="file", writes=LAYOUT, required=True,
               help="the layout, .json")  # fmt: skip
    for name, action in made.items():
        if name != "new":
            action.add_argument("file", type=Path, help="layout, .json, as `new` writes")
        action.add_argument(
            "--json", action="store_true", default=argparse.SUPPRESS,
            help="report as JSON on standard output",
        )  # fmt: skip
    for option in ("--title", "--task", "--title-tr", "--task-tr"):
        for name in ("new", "publish"):
            made[name].add_argument(option)
    made["add"].add_argument("organ", type=Path, help="published organ of one body, .palpate")
    made["add"].add_argument("--name", help="default: of the file")
    made["place"].add_argument("name", metavar="NAME")
    for name in ("add", "place"):
        add_placement(made[name])
    add_more(made["place"])
    add_pair(made["pair"])
    made["check"].add_argument(
        "--quick", action="store_true", help="press nothing, measure nothing"
    )
    add_output(made["publish"], "--out", "-o", writes=PUBLISHED, required=True, help="the .palpate")


def add_placement(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--at", type=read_three, metavar="X,Y,Z", help="[mm] of its own origin")
    parser.add_argument(
        "--turn", type=read_three, metavar="X,Y,Z",
        help="[degree] about x, then y, then z of the scene, about its own origin",
    )  # fmt: skip


def add_more(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--by", type=read_three, metavar="X,Y,Z", help="[mm] from where it is")
    parser.add_argument("--snap", metavar="REGION", help="of it, which is laid ...")
    parser.add_argument("--onto", metavar="BODY/REGION", help="... on this one of another body")
    parser.add_argument(
        "--gap", type=quantity("m"), default=SNAP_GAP, help="between them then (0.5mm)"
    )
    parser.add_argument("--fold", action=argparse.BooleanOptionalAction, default=None,
                        help="whether parts of its surface may touch each other")  # fmt: skip
    parser.add_argument("--renew", action="store_true", help="take its file as it is now")
    parser.add_argument("--remove", action="store_true", help="with the pairs it is in")


def add_pair(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("first", metavar="NAME")
    parser.add_argument("second", metavar="NAME")
    parser.add_argument("--thickness", type=quantity("m"), default=0.0, help="default: chosen")
    parser.add_argument("--stiffness", type=quantity("N/m3"), default=0.0, help="default: chosen")
    parser.add_argument("--damping", type=float, default=0.3, help="[-] of critical (0.3)")
    parser.add_argument("--remove", action="store_true", help="they pass through each other")


def read_three(text: str) -> tuple[float, float, float]:
    try:
        x, y, z = (float(part) for part in text.split(","))
    except ValueError:
        x = math.nan
    if not (math.isfinite(x) and math.isfinite(y) and math.isfinite(z)):
        raise argparse.ArgumentTypeError(f"got {text!r}, expected X,Y,Z")
    return x, y, z


def run_scene(call: argparse.Namespace) -> Report:
    try:
        if call.action == "new":
            return write(call, History(set_words(Layout(), call)))
        history = read_layout(call.file)
        if call.action in ("check", "publish"):
            return run_checked(call, set_words(history.now, call))
        if call.action in ("undo", "redo"):
            return write(call, getattr(document, call.action)(history))
        return write(call, document.apply(history, CHANGES[call.action](history.now, call)))
    except LayoutError as problem:
        raise WrongCall(str(problem)) from None


def set_words(layout: Layout, call: argparse.Namespace) -> Layout:
    names = ("title", "task", "title_tr", "task_tr")
    told = {name: getattr(call, name, None) for name in names}
    return replace(layout, **{name: text for name, text in told.items() if text is not None})


def change_add(layout: Layout, call: argparse.Namespace) -> Layout:
    read_organ(call.organ)
    body = PlacedBody(
        call.name or call.organ.stem,
        Path(os.path.relpath(call.organ.resolve(), call.file.resolve().parent)).as_posix(),
        hash_file(call.organ),
    )
    return document.add_body(layout, place(body, call))


def change_place(layout: Layout, call: argparse.Namespace) -> Layout:
    if call.remove:
        return document.remove_body(layout, call.name)
    if bool(call.snap) != bool(call.onto):
        raise WrongCall("--snap, --onto: got one, expected both: a region of it and BODY/REGION")
    changed = document.change_body(layout, call.name, lambda body: place(body, call))
    if call.renew:
        file = call.file.parent / changed.bodies[changed.find(call.name)].file
        read_organ(file)
        changed = document.change_body(
            changed, call.name, lambda body: replace(body, sha256=hash_file(file))
        )
    return snap_body(changed, call) if call.snap else changed


def place(body: PlacedBody, call: argparse.Namespace) -> PlacedBody:
    if call.at is not None:
        body = replace(body, position=tuple(1e-3 * x for x in call.at))
    if getattr(call, "by", None) is not None:
        moved = np.asarray(body.position) + 1e-3 * np.asarray(call.by)
        body = replace(body, position=tuple(map(float, moved)))
    if call.turn is not None:
        turn = Rotation.from_euler("xyz", call.turn, degrees=True).as_rotvec()
        body = replace(body, rotation=tuple(map(float, turn)))
    if getattr(call, "fold", None) is not None:
        body = replace(body, may_fold=call.fold)
    return body


def snap_body(layout: Layout, call: argparse.Namespace) -> Layout:
    other, slash, region = call.onto.partition("/")
    if not slash or other == call.name:
        raise WrongCall(f"--onto: got {call.onto!r}, expected BODY/REGION of another body")
    surfaces, patches = [], []
    for name, where in ((call.name, call.snap), (other, region)):
        placed = layout.bodies[layout.find(name)]
        organ = read_placed(call.file, placed)
        surfaces.append(Surface(*find_surface(build_body(organ, placed, touches=False))))
        try:
            patches.append(measure_patch(surfaces[-1], find_region(organ, where)))
        except ValueError as problem:
            raise WrongCall(f"{name}/{where}: {problem}") from None
    return document.change_body(
        layout,
        call.name,
        lambda body: snap(body, surfaces[0], patches[0], surfaces[1], patches[1], call.gap),
    )


def change_pair(layout: Layout, call: argparse.Namespace) -> Layout:
    if call.remove:
        return document.remove_pair(layout, call.first, call.second)
    pair = TouchingPair(call.first, call.second, call.thickness, call.stiffness, call.damping)
    return document.set_pair(layout, pair)


CHANGES: dict[str, Callable[[Layout, argparse.Namespace], Layout]] = {
    "add": change_add,
    "place": change_place,
    "pair": change_pair,
}


def write(call: argparse.Namespace, history: History) -> Report:
    write_layout(call.file, history)
    return {
        "action": call.action,
        "layout": str(call.file),
        **describe_layout(history.now),
        "can_undo": len(history.before),
        "can_redo": len(history.undone),
    }


def describe_layout(layout: Layout) -> Report:
    bodies = [
        {
            "name": body.name,
            "file": body.file,
            "position_m": list(body.position),
            "rotation_rad": list(body.rotation),
            "may_fold": body.may_fold,
        }
        for body in layout.bodies
    ]
    pairs = [[pair.first, pair.second] for pair in layout.pairs]
    return {"title": layout.title, "bodies": bodies, "pairs": pairs}


def run_checked(call: argparse.Namespace, layout: Layout) -> Report:
    """Checks, and writes the file where there is nothing that forbids it."""
    if call.action == "publish" and call.out.suffix != ".palpate":
        raise Refusal(call.out, "", f"a name ending in {call.out.suffix!r}", ".palpate")
    measures = call.action == "publish" or not call.quick
    checked = check(call.file, layout, measures)
    report: Report = {
        "action": call.action,
        "layout": str(call.file),
        **describe_layout(layout),
        "problems": [vars(problem) for problem in checked.problems],
        "costs": [],
        "measured": measures,
        "out": None,
    }
    if checked.scene is None or checked.assembly is None:
        return report
    count = len(checked.scene.body_pairs)
    report["costs"] = [describe_pair(layout, checked.scene, i, checked) for i in range(count)]
    if call.action == "publish" and not checked.has_errors:
        made = make_scenario(layout, checked.assembly, checked.scene)
        try:
            scenario.write(call.out, made)
        except ValueError as problem:
            raise FileError(str(call.out), "", str(problem), "a scene that a file holds") from None
        report["out"] = str(call.out)
    return report


def describe_scene(report: Report) -> str:
    lines = [f"{report['layout']}: {report['title'] or 'without a title'}"]
    for body in report["bodies"]:
        at = ", ".join(f"{1e3 * x:.2f}" for x in body["position_m"])
        turn = Rotation.from_rotvec(body["rotation_rad"]).as_euler("xyz", degrees=True)
        folds = "; may fold" if body["may_fold"] else ""
        lines.append(
            f"  {body['name']}: at {at} mm, turned {', '.join(f'{x:.1f}' for x in turn)} degrees"
            f"{folds}"
        )
    if "problems" not in report:
        lines += [f"  {first} and {second} may touch" for first, second in report["pairs"]]
        lines.append(f"  {report['can_undo']} changes can be undone, {report['can_redo']} redone")
        return "\n".join(lines)
    lines += map(describe_costs, report["costs"])
    for problem in report["problems"]:
        lines.append(f"{problem['severity']}: {problem['where']}: {problem['message']}")
    return "\n".join([*lines, describe_end(report)])


def describe_costs(told: dict[str, Any]) -> str:
    head = f"  {told['pair']}: thickness {1e3 * told['thickness_m']:.2f} mm"
    if "pair_median_us" not in told:
        return head
    return (
        f"{head}; pressed together {told['most_touching']} vertices touch, "
        f"{told['pair_median_us']:.0f} us median and {told['pair_p99_us']:.0f} us p99 of ticks of "
        f"{told['tick_median_us']:.0f} and {told['tick_p99_us']:.0f} us on this machine"
    )


def describe_end(report: Report) -> str:
    if has_failed(report):
        return "not published" if report["action"] == "publish" else "cannot be published"
    if report["out"]:
        return f"wrote {report['out']}; not validated, not a medical device"
    return "can be published" + ("" if report["measured"] else "; no pair was pressed (--quick)")


def has_failed(report: Report) -> bool:
    return any(problem["severity"] == "error" for problem in report.get("problems", ()))


SCENE_VERB = Verb(
    "scene",
    "place several published organs in one scene, say which may touch, check and publish it",
    "palpate scene add fossa.layout.json meshes/published/liver.palpate",
    add_scene,
    run_scene,
    describe_scene,
    failed=has_failed,
)
