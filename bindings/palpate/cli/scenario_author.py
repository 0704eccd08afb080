# SPDX-License-Identifier: BSD-3-Clause
"""`palpate scenario new|step|limit`: an assessment written from the command line."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from palpate import scenario
from palpate.assessment import author, author_tools
from palpate.assessment.author import AuthorError, Json
from palpate.assessment.publish import (
    find_regions,
    list_bodies,
    list_stones,
    read_assessment,
)
from palpate.cli import scenario_tools, scenario_values
from palpate.cli.scenario_places import add_at, find_place
from palpate.command.output import add_output
from palpate.command.verb import Report, WrongCall, plain_number, quantity
from palpate.files.file_kind import ASSESSMENT
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole
from palpate.runs.run import PUBLISHED

BAND = "LEAST..MOST, either may be left out, or $ and the name of a parameter"


NONE = "none"
"""Takes a value of a step away."""


def band_of(unit: str) -> Any:
    """A reader of 0.2N..0.5N, 4mm.. and ..1.5N."""
    one = quantity(unit)

    def read(text: str) -> list[float | str | None] | str:
        if text == NONE:
            return text
        least, dots, most = text.partition("..")
        if not dots or not (least or most):
            raise argparse.ArgumentTypeError(f"got {text!r}, expected {BAND}")
        return [end if end.startswith("$") else one(end) if end else None for end in (least, most)]

    return read


def or_none(read: Any) -> Any:
    """A reader that knows NONE as well."""
    return lambda text: text if text == NONE else read(text)


def read_bound(text: str) -> float | str:
    """1.5, or $limit."""
    try:
        return text if text.startswith("$") else float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"got {text!r}, expected a number or $NAME") from None


def add_new(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("organ", type=Path, help=f"published organ, {PUBLISHED}")
    add_output(
        parser, "-o", "--out", writes=ASSESSMENT, required=True, help="assessment to write, .json"
    )
    parser.add_argument("--title", required=True, help="in English")
    parser.add_argument("--title-tr", default="", help="in Turkish; sentences are written in both")
    parser.add_argument("--id", default="", help="default: of the title")
    parser.add_argument("--time", type=quantity("s"), help="limit; default: 60s")


def add_step(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="assessment, .json")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--add", metavar="VERB", choices=author.VERBS, help=", ".join(author.VERBS))
    for name in ("change", "duplicate", "mute", "unmute", "remove", "move"):
        what.add_argument(f"--{name}", metavar="ID")
    parser.add_argument("--to", type=int, help="of --move: its number, counted from 1")
    parser.add_argument("--id", default="", help="of a new step; default: its verb")
    parser.add_argument("--do", choices=author.VERBS, help="another verb")
    parser.add_argument("--tool", metavar="NAME", help="with which instrument it is done")
    add_at(parser)
    parser.add_argument("--force", dest="force_N", type=band_of("N"), help=f"0.2N..0.5N: {BAND}")
    parser.add_argument("--depth", dest="depth_m", type=band_of("m"), help="4mm..8mm")
    parser.add_argument("--distance", dest="distance_m", type=band_of("m"), help="4mm..8mm")
    parser.add_argument(
        "--for", dest="for_s", type=or_none(quantity("s")), help="how long it must be so"
    )
    parser.add_argument(
        "--within", dest="within_s", type=or_none(quantity("s")), help="longer is an error"
    )
    parser.add_argument("--share", type=plain_number(), help="[-] of a path")
    parser.add_argument(
        "--space", metavar="PLACE",
        help="of remove and carry: a space of the assessment, or space:X,Y,Z,RADIUS [m]",
    )  # fmt: skip
    add_say(parser)


def add_limit(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="assessment, .json")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--add", metavar="MEASURE", choices=author.MEASURES,
                      help=", ".join(author.MEASURES))  # fmt: skip
    what.add_argument("--change", metavar="ID")
    what.add_argument("--remove", metavar="ID")
    parser.add_argument("--id", default="", help="of a new limit; default: its measure")
    parser.add_argument(
        "--above",
        type=read_bound,
        help="[N], [m], [m/s] or [N/s], as measured, or $ and a parameter",
    )
    parser.add_argument("--below", type=read_bound, help="likewise")
    parser.add_argument("--for", dest="for_s", type=or_none(quantity("s")), help="default: 0.02s")
    parser.add_argument("--then", choices=author.CONSEQUENCES, default="")
    parser.add_argument("--tool", metavar="NAME", help="of which instrument it is watched")
    add_at(parser)
    add_say(parser)


def add_say(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--say", help="in English; default: a sentence of what is asked")
    parser.add_argument("--say-tr", help="in Turkish")


def run_new(call: argparse.Namespace) -> Report:
    published = scenario.read(call.organ)
    regions = list(find_regions(call.organ, published))
    bodies = list_bodies(published)
    if len(published.scene.instruments) != 1 or len(published.scene.bodies) != (len(bodies) or 1):
        raise Refusal(call.organ, "scene", "several bodies or tools", "one of each")
    titles = {"en": call.title, "tr": call.title_tr}
    stones = list_stones(published)
    made = author.new_assessment(call.organ.stem, titles, call.id, bodies, stones)
    if call.time is not None:
        made["finish"]["time_limit_s"] = call.time
    return write(call.out, made, {"regions": regions})


def run_step(call: argparse.Namespace) -> Report:
    return run_change(change_step, call)


def run_limit(call: argparse.Namespace) -> Report:
    return run_change(change_limit, call)


def run_value(call: argparse.Namespace) -> Report:
    """place, text, level, parameter, time, record or tool."""
    return run_change(CHANGES[call.action], call)


def run_change(
    change: Callable[[Json, argparse.Namespace], Json], call: argparse.Namespace
) -> Report:
    made = read_assessment(call.file)
    try:
        return write(call.file, change(made, call), {})
    except AuthorError as problem:
        raise WrongCall(str(problem)) from None
    except (KeyError, TypeError, AttributeError) as problem:
        raise Refusal(
            call.file, "", f"no assessment ({problem!r})", "one as `new` writes"
        ) from None


CHANGES: dict[str, Callable[[Json, argparse.Namespace], Json]] = {
    "place": scenario_values.change_place,
    "text": scenario_values.change_text,
    "level": scenario_values.change_level,
    "parameter": scenario_values.change_parameter,
    "time": scenario_values.change_time,
    "record": scenario_values.change_recorded,
    "tool": scenario_tools.change_tool,
}


def change_step(made: Json, call: argparse.Namespace) -> Json:
    for name, act in (("remove", author.remove_step), ("duplicate", duplicate)):
        if getattr(call, name):
            return act(made, getattr(call, name))
    if call.mute or call.unmute:
        return author.mute_step(made, call.mute or call.unmute, bool(call.mute))
    if call.move:
        if call.to is None:
            raise WrongCall("--move: got no --to, expected the number it shall have")
        return author.move_step(made, call.move, call.to - 1)
    made, at = take_place(made, call.at)
    names = ("force_N", "depth_m", "distance_m", "for_s", "within_s", "share")
    values = {name: getattr(call, name) for name in names if getattr(call, name) is not None}
    values = {name: None if value == NONE else value for name, value in values.items()}
    made, space = take_place(made, call.space)
    if space:
        verb = call.do or call.add or made["steps"][author.find(made["steps"], call.change)]["do"]
        if verb not in author.SPACES:
            raise AuthorError(f"--space: got one to {verb}, expected none")
        values[author.SPACES[verb]] = space
    if call.add:
        made, identity = author.add_step(made, call.add, at, values, call.id)
    else:
        identity = call.change
        values |= {"do": call.do} if call.do else {}
        made = author.change_step(made, identity, {**values, **({"at": at} if at else {})})
    if call.tool:
        made = author_tools.give_step(made, identity, call.tool)
    say = made["steps"][author.find(made["steps"], identity)]["say"]
    return set_texts(made, say, call)


def duplicate(made: Json, identity: str) -> Json:
    return author.duplicate_step(made, identity)[0]


def change_limit(made: Json, call: argparse.Namespace) -> Json:
    if call.remove:
        return author.remove_limit(made, call.remove)
    made, at = take_place(made, call.at)
    names = ("above", "below", "for_s")
    values = {name: getattr(call, name) for name in names if getattr(call, name) is not None}
    values |= {"place": at} if at else {}
    if call.tool:
        author_tools.require_tool(made, call.tool)
        values["tool"] = call.tool
    if call.add:
        made, identity = author.add_limit(made, call.add, values, call.then or "error", call.id)
    else:
        identity, made = call.change, author.change_limit(made, call.change, values, call.then)
    say = made["limits"][author.find(made["limits"], identity)]["say"]
    return set_texts(made, say, call)


def set_texts(made: Json, key: str, call: argparse.Namespace) -> Json:
    for code, text in (("en", call.say), ("tr", call.say_tr)):
        if text is not None:
            made = author.set_text(made, key, code, text)
    return made


def take_place(made: Json, told: str | None) -> tuple[Json, str | None]:
    """The place of --at, which is put into the assessment where it is a new one."""
    if not told:
        return made, None
    kind, colon, rest = told.partition(":")
    if not colon:
        known = ", ".join(made.get("places", {})) or "none yet"
        if told not in made.get("places", {}) and not told.startswith("$"):
            raise AuthorError(
                f"--at: got {told!r}, expected region:, ball:, path:, object:, space: "
                f"or one of {known}"
            )
        return made, told
    name = {"region": rest, "ball": "spot", "path": "line", "object": rest}.get(kind, kind)
    return author.add_place(made, name, find_place(made, told))


def write(path: Path, made: Json, more: Report) -> Report:
    text = json.dumps(made, ensure_ascii=False, indent=2)
    write_whole(path, (text + "\n").encode())
    steps = [
        {"id": step["id"], "do": step["do"], "at": step.get("at"), "muted": "muted" in step}
        for step in made["steps"]
    ]
    return {"assessment": str(path), "id": made["id"], "title": made["texts"]["en"]["title"],
            "steps": steps, "limits": [limit["id"] for limit in made.get("limits", [])],
            "problems": [], **more}  # fmt: skip


def describe_authored(report: Report) -> str:
    lines = [f"{report['assessment']}: {report['title']}"]
    for number, step in enumerate(report["steps"], start=1):
        muted = "  (muted)" if step["muted"] else ""
        lines.append(f"  {number}. {step['id']}: {step['do']} {step['at'] or ''}{muted}".rstrip())
    lines += [f"  limit {name}" for name in report["limits"]]
    if report.get("regions"):
        lines.append("regions to use with --at region:NAME: " + ", ".join(report["regions"]))
    return "\n".join(lines)
