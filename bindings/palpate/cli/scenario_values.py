# SPDX-License-Identifier: BSD-3-Clause
"""`palpate scenario place|text|level|parameter|time|record`: the rest of what a task is made of."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import palpate
from palpate import scenario
from palpate.assessment import author, author_values
from palpate.assessment.author import AuthorError, Json
from palpate.cli.scenario_places import add_at, find_place
from palpate.command.verb import WrongCall, plain_number, quantity
from palpate.runs.hand_record import find_bands
from palpate.runs.run import PUBLISHED

RECORDED = ("hold", "push", "trace", "find")
"""Verbs whose band can be taken from a hand that presses."""


def add_place(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="assessment, .json")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--set", metavar="NAME", help="a new place, or another one of this name")
    what.add_argument("--remove", metavar="NAME")
    add_at(parser)


def add_text(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="assessment, .json")
    parser.add_argument("key", help="of a text, as in the file")
    parser.add_argument("text", help="empty: it is missing")
    parser.add_argument("--in", dest="language", default="en", metavar="LANGUAGE",
                        help="such as tr; default: en")  # fmt: skip


def add_level(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="assessment, .json")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--add", metavar="LEVEL")
    what.add_argument("--remove", metavar="LEVEL")


def add_parameter(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="assessment, .json")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--set", metavar="NAME", help="a new parameter, or other values of one")
    what.add_argument("--remove", metavar="NAME")
    what.add_argument("--rename", metavar="NAME")
    parser.add_argument("--to", metavar="NAME", help="of --rename")
    parser.add_argument("--unit", choices=author_values.UNITS, help="of a new one")
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument("--value", type=plain_number("SI units"), help="[SI] the usual one")
    kind.add_argument("--uniform", metavar="LEAST..MOST", type=read_range,
                      help="[SI] the seed draws one between")  # fmt: skip
    kind.add_argument("--choose", metavar="A,B,...", type=read_choice,
                      help="the seed draws one of these numbers or places")  # fmt: skip
    parser.add_argument(
        "--level", metavar="LEVEL=VALUE", type=read_level, action="append", default=[],
        help="[SI] another value at a level; LEVEL= takes it away",
    )  # fmt: skip


def add_time(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="assessment, .json")
    parser.add_argument("time", type=quantity("s"), help="after which the task is over, 60s")


def add_record(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="assessment, .json")
    parser.add_argument("step", metavar="ID", help="whose band is taken from the hand")
    parser.add_argument("record", type=Path, help="a run of the organ, .prec")
    parser.add_argument("organ", type=Path, help=f"that was played, {PUBLISHED}")


def read_range(text: str) -> list[float]:
    least, _, most = text.partition("..")
    try:
        return [float(least), float(most)]
    except ValueError:
        raise argparse.ArgumentTypeError(f"got {text!r}, expected LEAST..MOST") from None


def read_choice(text: str) -> list[float | str]:
    return [read_number(part.strip()) for part in text.split(",")]


def read_number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def read_level(text: str) -> tuple[str, float | None]:
    level, equals, value = text.partition("=")
    try:
        if level and equals:
            return level, float(value) if value else None
    except ValueError:
        pass
    raise argparse.ArgumentTypeError(f"got {text!r}, expected LEVEL=VALUE")


def change_place(made: Json, call: argparse.Namespace) -> Json:
    if call.remove:
        return author_values.remove_place(made, call.remove)
    if not call.at:
        raise WrongCall("--set: got no --at, expected what the place is")
    return author_values.set_place(made, call.set, find_place(made, call.at))


def change_text(made: Json, call: argparse.Namespace) -> Json:
    if call.key not in made["texts"]["en"]:
        known = ", ".join(made["texts"]["en"])
        raise AuthorError(f"key: got {call.key!r}, expected one of {known}")
    return author.set_text(made, call.key, call.language, call.text)


def change_level(made: Json, call: argparse.Namespace) -> Json:
    if call.remove:
        return author_values.remove_level(made, call.remove)
    return author_values.add_level(made, call.add)


def change_parameter(made: Json, call: argparse.Namespace) -> Json:
    if call.remove:
        return author_values.remove_parameter(made, call.remove)
    if call.rename:
        if not call.to:
            raise WrongCall("--rename: got no --to, expected the new name")
        return author_values.rename_parameter(made, call.rename, call.to)
    values: dict[str, Any] = {
        name: getattr(call, name)
        for name in ("unit", "value", "uniform", "choose")
        if getattr(call, name) is not None
    }
    made = author_values.set_parameter(made, call.set, values)
    for level, value in call.level:
        made = author_values.set_level_value(made, call.set, level, value)
    return made


def change_time(made: Json, call: argparse.Namespace) -> Json:
    return author_values.set_time(made, call.time)


def change_recorded(made: Json, call: argparse.Namespace) -> Json:
    """The band is what the hand felt, or how deep it was, 20 % less to 20 % more."""
    step = made["steps"][author.find(made["steps"], call.step)]
    if step["do"] not in RECORDED:
        raise AuthorError(f"step: got one to {step['do']}, expected {', '.join(RECORDED)}")
    scene, record = scenario.read(call.organ).scene, palpate.read_record(str(call.record))
    row = int(made.get("tools", {}).get(step.get("tool"), {}).get("instrument", 0))
    if row >= min(len(scene.instruments), record.instruments):
        raise AuthorError(
            f"record: got one of {record.instruments} instruments of {call.organ.name}, which has "
            f"{len(scene.instruments)}, expected number {row + 1}, with which the step is done"
        )
    values = find_bands(scene, record, step["do"], row)
    if values is None:
        raise AuthorError("record: got one in which nothing was pressed, expected a press")
    return author.change_step(made, call.step, values)
