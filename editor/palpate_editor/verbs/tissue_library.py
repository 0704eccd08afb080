# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that looks tissues up, and the options by which an organ is given one."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

from palpate.command.verb import Report, Verb, WrongCall
from palpate.files.refusal import Refusal

from palpate_editor.document import Organ
from palpate_editor.document.constants import find_constant
from palpate_editor.edits import SetTissue
from palpate_editor.tissue_library import (
    LibraryTissue,
    Value,
    choose,
    find_own_file,
    find_tissue,
    read_library,
    search,
)
from palpate_editor.verbs.files import apply

MARKS = {"checked": "checked", "recalled": "RECALLED", "unknown": "UNKNOWN"}


def add_library(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--library",
        dest="own_tissues",
        type=Path,
        metavar="FILE",
        help=f"your own tissues, as TOML ({find_own_file().name} in the folder of your settings)",
    )


# ---------------------------------------------------------------- for the verb material


def add_tissue_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--tissue",
        action="append",
        default=[],
        metavar="[REGION=]NAME",
        help="of the library (palpate tissues): its constants for the organ, or its stiffness for "
        "a region; may be repeated",
    )
    parser.add_argument(
        "--recalled",
        action="store_true",
        help="take values of --tissue that nobody has looked up, where none was",
    )
    add_library(parser)


def set_tissues(call: argparse.Namespace, organ: Organ) -> Organ:
    """The organ with every tissue of the call, that of the whole organ first. Raises Refusal."""
    if not call.tissue:
        for option, is_given in (("--recalled", call.recalled), ("--library", call.own_tissues)):
            if is_given:
                raise WrongCall(f"{option} needs --tissue")
        return organ
    tissues = read_library(call.own_tissues)
    modulus = getattr(call, "material.young_modulus")
    wanted = [text.rpartition("=")[::2] for text in call.tissue]
    for region, name in sorted(wanted, key=lambda row: row[0] != ""):
        own = None if region else modulus
        try:
            applied = choose(
                find_tissue(tissues, name), region, recalled=call.recalled, young_modulus=own
            )
        except Refusal as refused:
            raise Refusal(call.file, refused.where, refused.got, refused.expected) from None
        organ = apply(SetTissue(applied), organ, call.file, "--tissue")
    return organ


# ---------------------------------------------------------------- tissues


def add_tissues(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("search", nargs="*", help="words of what is looked for, in any language")
    add_library(parser)


def run_tissues(call: argparse.Namespace) -> Report:
    words = " ".join(call.search)
    found = search(read_library(call.own_tissues), words)
    if not found:
        raise Refusal(None, "tissues", f"{words!r}, which none is called", "other words, or none")
    return {"search": words, "tissues": [report_tissue(tissue) for tissue in found]}


def report_tissue(tissue: LibraryTissue) -> Report:
    try:
        taken = choose(tissue)
        default = {
            name: getattr(taken, name)
            for name in ("young_modulus", "poisson_ratio", "density", "wall_thickness")
        }
    except Refusal:
        default = None
    return {
        "name": tissue.name,
        "title": tissue.title,
        "kind": tissue.kind,
        "note": tissue.note,
        "origin": tissue.origin,
        "status": tissue.status,
        "default": default,
        "published": [asdict(value) for value in tissue.values],
    }


def describe_tissues(report: Report) -> str:
    rows = report["tissues"]
    if len(rows) == 1:
        return describe_one(rows[0])
    lines = [describe_row(row) for row in rows]
    return "\n".join([*lines, "more of one: palpate tissues NAME"])


def describe_row(row: Report) -> str:
    numbers = [
        end
        for value in row["published"]
        if value["quantity"] == "young_modulus" and value["low"] is not None
        for end in (value["low"], value["high"])
    ]
    span = f"{write_modulus(min(numbers))} to {write_modulus(max(numbers))}" if numbers else "none"
    default = row["default"]
    taken = "none" if default is None else write_modulus(default["young_modulus"])
    mark = "" if row["status"] == "checked" else f"  {MARKS[row['status']]}"
    return f"{row['name']:14} {row['title']:18} {row['kind']:7} E {taken:12} published {span}{mark}"


def write_modulus(value: float) -> str:
    scale, unit = next(row for row in ((1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa"), (0.0, "Pa"))
                       if value >= row[0])  # fmt: skip
    return f"{value / (scale or 1.0):.3g} {unit}"


def describe_one(row: Report) -> str:
    default = row["default"]
    taken = (
        "no default: its Young's modulus is not checked"
        if default is None
        else "taken: "
        + ", ".join(write(name, x, x) for name, x in default.items() if x is not None)
    )
    lines = [f"{row['name']}: {row['title']} ({row['kind']}; {row['origin']})", taken]
    if row["note"]:
        lines.append(" ".join(row["note"].split()))
    lines += [describe_value(Value(**value)) for value in row["published"]]
    return "\n".join(lines)


def describe_value(value: Value) -> str:
    number = "no number" if value.low is None else write(value.quantity, value.low, value.high)
    return (
        f"  {MARKS[value.status]:8} {number}\n"
        f"           {value.method}; {value.setting}, rate: {value.rate}\n"
        f"           {value.source}"
    )


def write(quantity: str, low: float, high: float | None) -> str:
    constant = find_constant("material", quantity)
    assert constant is not None and high is not None
    ends = f"{low / constant.scale:.4g}"
    if high != low:
        ends += f" to {high / constant.scale:.4g}"
    return f"{constant.label} {ends} {constant.unit}".rstrip()


VERBS = [
    Verb(
        "tissues",
        "look up what is published about tissues, with sources and how far they can be trusted",
        "palpate tissues heart",
        add_tissues,
        run_tissues,
        describe_tissues,
    ),
]
