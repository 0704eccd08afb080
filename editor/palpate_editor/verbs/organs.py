# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that shows what comes with Palpate: organs."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from palpate.command.output import Files, add_output, add_output_folder
from palpate.command.verb import Report, Verb
from palpate.files.file_kind import ORGAN, PICTURE, PUBLISHED
from palpate.files.refusal import Refusal
from palpate_meshes.catalogue import (
    Entry,
    Tissue,
    read_regions,
    read_terms,
    read_tool_catalogue,
)

from palpate_editor.document.files import write_organ
from palpate_editor.publish import PublishError
from palpate_editor.shipped import list_organs, make_organ, write_files


def add_organs(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("names", nargs="*", metavar="NAME", help="organs to speak of (all)")
    add_output_folder(
        parser,
        "--write",
        writes=lambda call: list_outputs(
            call, call.write, {".organ": ORGAN, ".palpate": PUBLISHED}
        ),
        metavar="DIR",
        help="write each as .organ to edit, .palpate to play",
    )
    add_output(
        parser, "--out", "-o", writes=ORGAN, metavar="FILE", help="write one organ as this .organ"
    )
    parser.add_argument("--vertices", type=int, metavar="N", help="of --out; another resolution")
    add_output_folder(
        parser,
        "--pictures",
        writes=lambda call: list_outputs(call, call.pictures, {".png": PICTURE}),
        metavar="DIR",
        help="write a picture of each",
    )
    add_output_folder(
        parser,
        "--thumbnails",
        writes=list_thumbnails,
        metavar="DIR",
        help="write the start page's small pictures",
    )
    add_output(
        parser,
        "--contact-sheet",
        writes=PICTURE,
        metavar="FILE",
        help="write all on one picture, tools too",
    )


def list_outputs(call: argparse.Namespace, folder: Path, kinds: dict[str, str]) -> Files:
    """What is written into a folder: a file of each kind for each organ."""
    return [
        (folder / f"{entry.name}{ending}", kind)
        for entry, _ in choose(call.names)
        for ending, kind in kinds.items()
    ]


def list_thumbnails(call: argparse.Namespace) -> Files:
    # loads the renderer, which every other output does without
    from palpate_editor import gallery

    return [(call.thumbnails / name, PICTURE) for name in gallery.list_thumbnails()]


def run_organs(call: argparse.Namespace) -> Report:
    chosen = choose(call.names)
    written: list[str] = []
    if call.out is not None:
        written.append(write_one(call))
    elif call.vertices is not None:
        raise Refusal(None, "--vertices", "no file to write", "--out FILE beside it")
    if call.write is not None:
        try:
            for _, working, scenario in write_files(
                call.write, [entry.name for entry, _ in chosen]
            ):
                written += [str(working), str(scenario)]
        except PublishError as refused:
            raise Refusal(call.write, "", str(refused), "organs that can be published") from None
    written += draw_pictures(call, chosen)
    # loads SciPy, which every other command does without
    from palpate_meshes.tools import read_tool_names

    return {
        **read_terms(),
        "organs": [describe_organ(entry, tissue) for entry, tissue in chosen],
        "tools": [describe_tool(name) for name in read_tool_names()],
        "written": written,
    }


def choose(names: list[str]) -> list[tuple[Entry, Tissue]]:
    """The organs that are named, or all."""
    everything = list_organs()
    known = [entry.name for entry, _ in everything]
    for name in names:
        if name not in known:
            raise Refusal(None, "NAME", name, f"one of {', '.join(known)}")
    return [row for row in everything if not names or row[0].name in names]


def write_one(call: argparse.Namespace) -> str:
    if len(call.names) != 1:
        raise Refusal(None, "NAME", f"{len(call.names)} names", "one NAME, which --out writes")
    if call.out.suffix != ".organ":
        raise Refusal(call.out, "", f"a name ending in {call.out.suffix!r}", ".organ")
    try:
        organ = make_organ(call.names[0], call.vertices)
    except ValueError as problem:
        expected = f"a number the shape can have ({problem})"
        raise Refusal(call.names[0], "--vertices", str(call.vertices), expected) from None
    write_organ(call.out, organ)
    return str(call.out)


def draw_pictures(call: argparse.Namespace, chosen: list[tuple[Entry, Tissue]]) -> list[str]:
    """Writes what pictures were asked for; the renderer is loaded only then."""
    if call.pictures is call.contact_sheet is call.thumbnails is None:
        return []
    from palpate.render import write_png

    from palpate_editor import gallery

    written = []
    if call.pictures is not None:
        call.pictures.mkdir(parents=True, exist_ok=True)
        for entry, tissue in chosen:
            path = call.pictures / f"{entry.name}.png"
            write_png(path, gallery.draw_organ(entry, tissue, size=(1280, 960)))
            written.append(str(path))
    if call.thumbnails is not None:
        call.thumbnails.mkdir(parents=True, exist_ok=True)
        for name, pixels in gallery.draw_thumbnails():
            write_png(call.thumbnails / name, pixels)
            written.append(str(call.thumbnails / name))
    if call.contact_sheet is not None:
        write_png(call.contact_sheet, gallery.draw_contact_sheet())
        written.append(str(call.contact_sheet))
    return written


def describe_organ(entry: Entry, tissue: Tissue) -> Report:
    return {
        "name": entry.name,
        "title": entry.title,
        "mesh": str(entry.mesh),
        "sha256": entry.sha256,
        "generator": entry.generator,
        "parameters": entry.parameters,
        "vertices": entry.vertices,
        "triangles": entry.triangles,
        "border_loops": list(entry.border),
        "tissue": tissue.name,
        "kind": tissue.kind,
        "note": tissue.note,
        "material": tissue.material,
        "model": tissue.model,
        "tetrahedra": entry.tetrahedra,
        "wall_vertices": entry.wall_vertices,
        "published": [vars(row) for row in tissue.published],
        "size_source": entry.size_source,
        "volume_source": entry.volume_source,
        "regions": {name: len(ids) for name, ids in read_regions(entry.name).items()},
        "task": entry.task,
    }


def describe_tool(name: str) -> Report:
    from palpate_meshes.tools import read_tool

    tool = read_tool(name)
    return {
        "name": name,
        "title": tool.title,
        "source": tool.source,
        "parts": {part: vars(row) for part, row in read_tool_catalogue()[name].items()},
        "collision_shapes": len(tool.shapes),
        "jaws": tool.jaws is not None,
        "needle": tool.needle is not None,
    }


def describe_organs(report: Report) -> str:
    rows = [describe_row(row) for row in report["organs"]]
    tools = ", ".join(tool["name"] for tool in report["tools"])
    lines = [*rows, f"tools: {tools}", f"{report['author']}, {report['licence']}"]
    return "\n".join(lines + [f"wrote {path}" for path in report["written"]])


def describe_row(row: dict[str, Any]) -> str:
    moduli = [r for r in row["published"] if r["quantity"] == "young_modulus"]
    low, high = min(r["low"] for r in moduli), max(r["high"] for r in moduli)
    border = f", hole of {row['border_loops'][0]}" if row["border_loops"] else ", closed"
    counts = f"{row['vertices']:5} vertices, {row['triangles']:5} triangles{border}"
    chosen = row["material"]["young_modulus"]
    scale, unit = (1e9, "GPa") if chosen >= 1e9 else (1e3, "kPa")
    return (
        f"{row['name']:14} {counts:43} {row['kind']:7} E {chosen / scale:g} {unit} "
        f"(published {low / scale:g} to {high / scale:g})"
    )


VERBS = [
    Verb(
        "organs",
        "list the organs that come with Palpate; write them, draw them",
        "palpate organs --write organs --contact-sheet organs.png",
        add_organs,
        run_organs,
        describe_organs,
    ),
]
