# SPDX-License-Identifier: BSD-3-Clause
"""The verb `scene`: several published organs, stones and scenery are placed in one scene, checked
and published."""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Callable
from pathlib import Path

from palpate.cli.scene_changes import CHANGES, KINDS, ORGAN, UNITS, change_words
from palpate.cli.scene_words import describe_scene, has_failed
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall, quantity
from palpate.files.file_kind import ASSESSMENT, LAYOUT, PUBLISHED
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole
from palpate.layout import document
from palpate.layout.check import check, describe_pair
from palpate.layout.document import History, Layout, LayoutError, Placed
from palpate.layout.layout_file import read_layout, write_layout
from palpate.layout.ranges import FLUID, FRICTION, GRAVITY, PLACE, TURN, Range
from palpate.layout.stone import FEWEST, MOST
from palpate.layout.task import find_task
from palpate.layout.write import write_checked
from palpate.scene.instrument_kinds import KINDS as TOOLS

SNAP_GAP = 5e-4
"""[m] The thickest barrier that is chosen."""
READS = {"new": "write a layout without bodies",
         "add": "place a published organ in it, or a mesh as a stone or as scenery",
         "place": "move, turn, snap, change or remove what is in it",
         "pair": "say which two bodies may touch, or which scenery stops a body",
         "tool": "say with which instrument it is touched",
         "set": "keep its title, its task, gravity and the fluid that stones are in",
         "task": "take the judged task of an assessment into it, out of it, or away",
         "undo": "take back the last change", "redo": "make it again",
         "check": "list overlaps, costs and all that is wrong",
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
        for name in ("new", "set", "publish"):
            made[name].add_argument(option)
    for name in ("new", "set", "check", "publish"):
        made[name].add_argument(
            "--gravity", type=or_none(three(GRAVITY)), metavar="X,Y,Z",
            help="[m/s²]; default, and none: as the first organ has it, which is 0 of most",
        )  # fmt: skip
        made[name].add_argument(
            "--fluid", type=or_none(read_two), metavar="DENSITY,VISCOSITY",
            help="[kg/m³], [Pa s] that stones are in: 1000,0.001 of water that irrigates; or none",
        )  # fmt: skip
    made["add"].add_argument(
        "organ", type=Path, metavar="FILE",
        help="published organ of one body, .palpate; of a stone or scenery its mesh, .obj",
    )  # fmt: skip
    made["add"].add_argument("--name", help="default: of the file")
    add_kind(made["add"])
    made["place"].add_argument("name", metavar="NAME")
    for name in ("add", "place"):
        add_placement(made[name])
        add_hard(made[name])
        made[name].add_argument(
            "--weightless", action=argparse.BooleanOptionalAction, default=None,
            help="whether an organ's shape is the one under its weight, as it was scanned: gravity "
            "does not act on it",
        )  # fmt: skip
    add_more(made["place"])
    add_pair(made["pair"])
    add_tool(made["tool"])
    add_task(made["task"])
    made["check"].add_argument(
        "--quick", action="store_true", help="press nothing, measure nothing"
    )
    add_output(made["publish"], "--out", "-o", writes=PUBLISHED, required=True, help="the .palpate")


def add_kind(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--as", dest="kind", choices=KINDS, default=ORGAN,
        help="an organ; a stone, which moves and keeps its shape; or scenery, which never moves",
    )  # fmt: skip
    parser.add_argument("--unit", choices=UNITS, default="m", help="of the mesh (m)")


def add_hard(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--density", type=quantity("kg/m3"), help="of a stone (2000kg/m3)")
    parser.add_argument(
        "--spheres", type=int, metavar="N",
        help=f"of a stone's hull, {FEWEST} to {MOST} (14): what tissue and scenery touch of it",
    )  # fmt: skip
    parser.add_argument(
        "--friction", type=float,
        help="[-] of a stone on all it touches (0.3), or of scenery on the bodies it stops (0)",
    )  # fmt: skip
    parser.add_argument(
        "--tool-friction", type=read_own_friction, metavar="MU",
        help="[-] of instruments on it: smooth metal has 0.01 to 0.11 on wet bowel, profiled jaws "
        "up to 0.8; `own`: that of the instrument, as of all else",
    )  # fmt: skip


def add_placement(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--at", type=three(PLACE), metavar="X,Y,Z", help="[mm] of its own origin")
    parser.add_argument(
        "--turn", type=three(TURN), metavar="X,Y,Z",
        help="[degree] about x, then y, then z of the scene, about its own origin",
    )  # fmt: skip


def add_more(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--by", type=three(PLACE), metavar="X,Y,Z", help="[mm] from where it is")
    parser.add_argument("--snap", metavar="REGION", help="of it, which is laid ...")
    parser.add_argument("--onto", metavar="BODY/REGION", help="... on this one of another body")
    parser.add_argument(
        "--gap", type=quantity("m"), default=SNAP_GAP, help="between them then (0.5mm)"
    )
    parser.add_argument("--fold", action=argparse.BooleanOptionalAction, default=None,
                        help="whether parts of its surface may touch each other")  # fmt: skip
    parser.add_argument("--renew", action="store_true", help="take its file as it is now")
    parser.add_argument("--remove", action="store_true", help="a body with the pairs it is in")


def add_pair(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("first", metavar="NAME")
    parser.add_argument("second", metavar="NAME")
    parser.add_argument("--thickness", type=quantity("m"), default=0.0, help="default: chosen")
    parser.add_argument("--stiffness", type=quantity("N/m3"), default=0.0, help="default: chosen")
    parser.add_argument("--damping", type=float, default=0.3, help="[-] of critical (0.3)")
    parser.add_argument(
        "--friction", type=float, default=0.0,
        help="[-] of one on the other; wet serosa has some hundredths (0)",
    )  # fmt: skip
    parser.add_argument("--remove", action="store_true", help="they pass through each other")


def add_tool(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--kind", choices=TOOLS, default="grasper", help="(grasper)")
    parser.add_argument("--radius", type=quantity("m"), help="default: as usual of its kind")
    parser.add_argument("--length", type=quantity("m"), help="of shaft or jaws, likewise")
    parser.add_argument("--jaw-opening", type=float, metavar="RAD", help="of each jaw, likewise")
    parser.add_argument("--friction", type=float, help="[-] likewise")
    parser.add_argument("--grip-force", type=quantity("N"), help="of each jaw at its middle (5N)")
    parser.add_argument(
        "--trocar", type=three(PLACE), metavar="X,Y,Z",
        help="[mm] where its shaft passes the wall; without one the device turns it",
    )  # fmt: skip
    parser.add_argument("--remove", action="store_true", help="that of the first organ again")


def add_task(parser: argparse.ArgumentParser) -> None:
    """`--write` is no change, and a change has no `--write`."""
    parser.add_argument(
        "assessment", type=Path, nargs="?", metavar="FILE",
        help="assessment, .json, as `palpate scenario new` writes; of each organ and stone by the "
        "id of its name",
    )  # fmt: skip
    add_output(parser, "--write", writes=ASSESSMENT, help="the task as it is, to be worked on")
    parser.add_argument("--remove", action="store_true", help="it is a scene to feel again")


def or_none(read: Callable[[str], tuple[float, ...]]) -> Callable[[str], tuple[float, ...]]:
    """Reads `none` too, as no numbers."""
    return lambda text: () if text == "none" else read(text)


def read_own_friction(text: str) -> tuple[float, ...]:
    """[-] One number; none for `own`."""
    if text == "own":
        return ()
    try:
        mu = float(text)
    except ValueError:
        mu = math.nan
    if not FRICTION.holds(mu):
        raise argparse.ArgumentTypeError(f"got {text!r}, expected {FRICTION}, or own")
    return (mu,)


def read_two(text: str) -> tuple[float, float]:
    try:
        density, viscosity = (float(part) for part in text.split(","))
    except ValueError:
        density = viscosity = math.nan
    if not (FLUID[0].holds(density) and FLUID[1].holds(viscosity)):
        raise argparse.ArgumentTypeError(
            f"got {text!r}, expected DENSITY,VISCOSITY of up to 20000 kg/m³ and 10 Pa s"
        )
    return density, viscosity


def three(range: Range) -> Callable[[str], tuple[float, float, float]]:
    """Reads X,Y,Z in its unit."""

    def read(text: str) -> tuple[float, float, float]:
        try:
            x, y, z = (float(part) for part in text.split(","))
        except ValueError:
            x = y = z = math.nan
        if not all(range.holds(each * range.scale) for each in (x, y, z)):
            most = range.say(range.most)
            raise argparse.ArgumentTypeError(f"got {text!r}, expected X,Y,Z of up to {most} each")
        return x, y, z

    return read


def run_scene(call: argparse.Namespace) -> Report:
    try:
        if call.action == "new":
            return write(call, History(change_words(Layout(), call)))
        history = read_layout(call.file)
        if call.action in ("check", "publish"):
            return run_checked(call, change_words(history.now, call))
        if call.action in ("undo", "redo"):
            return write(call, getattr(document, call.action)(history))
        if call.action == "task" and call.write is not None:
            return write_task(call, history)
        return write(call, document.apply(history, CHANGES[call.action](history.now, call)))
    except LayoutError as problem:
        raise WrongCall(str(problem)) from None


def write(call: argparse.Namespace, history: History) -> Report:
    write_layout(call.file, history)
    return describe_history(call, history)


def describe_history(call: argparse.Namespace, history: History) -> Report:
    return {
        "action": call.action,
        "layout": str(call.file),
        **describe_layout(history.now),
        "can_undo": len(history.before),
        "can_redo": len(history.undone),
    }


def write_task(call: argparse.Namespace, history: History) -> Report:
    """The layout stays as it is. Raises LayoutError."""
    if call.assessment is not None or call.remove:
        raise WrongCall("--write: got one with a change, expected one or the other")
    task = find_task(history.now)
    if task is None:
        raise LayoutError("task: got none, expected one that FILE has brought")
    write_whole(call.write, (json.dumps(task, indent=1, ensure_ascii=False) + "\n").encode())
    return describe_history(call, history)


def describe_layout(layout: Layout) -> Report:
    pairs = [[pair.first, pair.second] for pair in layout.pairs]
    bodies = [{**describe_placed(each), "may_fold": each.may_fold, "weightless": each.weightless}
              for each in layout.bodies]  # fmt: skip
    stones = [
        {
            **describe_placed(each),
            "density_kg_per_m3": each.density,
            "friction": each.friction,
            "spheres": each.spheres,
        }
        for each in layout.stones
    ]
    scenery = [
        {**describe_placed(each), "friction": each.friction, "stops": list(each.stops)}
        for each in layout.scenery
    ]
    return {
        "title": layout.title,
        "task": layout.task,
        "gravity_m_per_s2": list(layout.gravity) or None,
        "fluid": list(layout.fluid) or None,
        "bodies": bodies,
        "pairs": pairs,
        "pair_friction": [pair.friction for pair in layout.pairs],
        "stones": stones,
        "scenery": scenery,
        "tools": [vars(tool) for tool in layout.tools],
        "assessment": find_task(layout),
    }


def describe_placed(part: Placed) -> Report:
    return {
        "name": part.name,
        "file": part.file,
        "position_m": list(part.position),
        "rotation_rad": list(part.rotation),
        "tool_friction": list(part.tool_friction),
    }


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
    for told, stone in zip(report["stones"], checked.assembly.stones, strict=True):
        told |= {"mass_kg": stone.body.mass, "hull_gap_m": stone.hull.deepest}
    report["costs"] = [describe_pair(layout, checked.scene, i, checked) for i in range(count)]
    if call.action == "publish" and write_checked(call.out, layout, checked):
        report["out"] = str(call.out)
    return report


SCENE_VERB = Verb(
    "scene",
    "place organs, stones and scenery in one scene, say which may touch, check and publish it",
    "palpate scene add fossa.layout.json meshes/published/liver.palpate",
    add_scene,
    run_scene,
    describe_scene,
    failed=has_failed,
)
