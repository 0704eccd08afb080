# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb about appearance: which an organ has, and giving it another."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb
from palpate.files.file_kind import ORGAN
from palpate.files.refusal import Refusal

from palpate_editor.appearance import find_style, read_colour, read_styles, write_colour
from palpate_editor.document import Organ
from palpate_editor.document.files import write_organ
from palpate_editor.edits import SetAppearance
from palpate_editor.verbs.files import ReadFile, apply, open_any

PLAIN = "none"
"""The word for plain tissue, without an appearance of its own."""


def read_argument(text: str) -> tuple[float, ...]:
    try:
        return read_colour(text)
    except ValueError as problem:
        raise argparse.ArgumentTypeError(str(problem)) from None


def add_appearance(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate or .scene.json")
    parser.add_argument(
        "--style",
        choices=(*read_styles(), PLAIN),
        help="what it shall look like; default: as it does, which is needed for --colour alone",
    )
    parser.add_argument(
        "--colour",
        "--color",
        type=read_argument,
        metavar="#RRGGBB",
        help="of the tissue in sRGB; its spots and vessels go with it (the style's own)",
    )
    parser.add_argument(
        "--keep-vertex-colours",
        action="store_true",
        help="leave the colours that the organ's file gave its vertices where they are; else a new "
        "style or colour takes their place",
    )
    add_output(
        parser,
        "--out",
        "-o",
        writes=ORGAN,
        help=".organ to write; without one, how it looks is reported",
    )


def run_appearance(call: argparse.Namespace) -> Report:
    read = ReadFile.of(call.file)
    organ = open_any(call.file)
    wanted = call.style is not None or call.colour is not None
    if wanted != (call.out is not None):
        found, expected = ("no --out", "--out") if wanted else ("--out", "--style or --colour")
        raise Refusal(call.file, "", found, f"{expected} beside the other options")
    if wanted:
        if call.out.suffix != ".organ":
            raise Refusal(call.out, "", f"a name ending in {call.out.suffix!r}", ".organ")
        organ = change(call, organ)
        read.check(call.out)
        write_organ(call.out, organ)
    style = find_style(organ.appearance)
    return {
        "out": None if call.out is None else str(call.out),
        "style": None if style is None else style.name,
        "colour": None if organ.appearance is None else write_colour(organ.appearance.colour),
        "appearance": None if organ.appearance is None else asdict(organ.appearance),
        "vertex_colours": organ.surface is not None and organ.surface.colours is not None,
        "styles": list(read_styles()),
    }


def change(call: argparse.Namespace, organ: Organ) -> Organ:
    """The organ as the call wants it to look."""
    style = call.style
    if style is None:
        known = find_style(organ.appearance)
        if known is None:
            found = "plain tissue" if organ.appearance is None else "an appearance of its own"
            raise Refusal(call.file, "--colour", found, "--style beside it")
        style = known.name
    if style == PLAIN and call.colour is not None:
        raise Refusal(call.file, "--colour", f"--style {PLAIN}", "a style that has a colour")
    keep = call.keep_vertex_colours
    if keep and (organ.surface is None or organ.surface.colours is None):
        raise Refusal(call.file, "--keep-vertex-colours", "no colours of its vertices", "some")
    edit = SetAppearance(None if style == PLAIN else style, call.colour, keep)
    return apply(edit, organ, call.file, "--style")


def describe_appearance(report: Report) -> str:
    if report["appearance"] is None:
        line = "plain tissue"
    else:
        line = f"{report['style'] or 'an appearance of its own'}, {report['colour']}"
    if report["vertex_colours"]:
        line += ", with the colours of its vertices"
    if report["out"]:
        return f"wrote {report['out']}: {line}"
    return f"{line}; styles: {', '.join(report['styles'])}"


VERBS = [
    Verb(
        "appearance",
        "say an organ's appearance, or give it that of a shipped one",
        "palpate appearance spleen.organ --style liver --colour '#7a2d25' -o spleen.organ",
        add_appearance,
        run_appearance,
        describe_appearance,
    ),
]
