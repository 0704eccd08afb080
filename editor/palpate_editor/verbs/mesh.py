# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that reads mesh files: import."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall

from palpate_editor import authoring
from palpate_editor.appearance import write_colour
from palpate_editor.check import describe_problem, measure_surface
from palpate_editor.doctor import list_surface_problems
from palpate_editor.document import EMPTY
from palpate_editor.edits import import_read
from palpate_editor.formats import EXTENSIONS
from palpate_editor.verbs.check import describe_problems
from palpate_editor.verbs.clean import add_cleaning, clean, describe_cleaning
from palpate_editor.verbs.decimate import decimate_to, describe_decimate
from palpate_editor.verbs.files import (
    OUTPUTS,
    describe_loops,
    write_any,
)
from palpate_editor.verbs.parts import choose_outer, read_assembling
from palpate_editor.verbs.source import add_source

# ---------------------------------------------------------------- import


def add_import(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file",
        type=Path,
        help=f"a mesh file: {' '.join(EXTENSIONS)}, or one of them packed by gzip (.gz)",
    )
    add_source(parser)
    parser.add_argument(
        "--outer", action="store_true", help="only the parts that lie inside no other"
    )
    parser.add_argument(
        "--region-per-part",
        action="store_true",
        help="keep each part as a region of its name, for a tissue of its own (palpate material "
        "--tissue NAME=TISSUE)",
    )
    add_cleaning(parser)
    parser.add_argument("--vertices", type=int, help="decimate to exactly this many")
    add_output(
        parser,
        "--out",
        "-o",
        writes=OUTPUTS,
        required=True,
        help=".organ, or a mesh file in metres, z up",
    )


def run_import(call: argparse.Namespace) -> Report:
    assembling = read_assembling(call, regions=call.region_per_part)
    scene = authoring.read_mesh(call.file)
    parts = choose_outer(call, scene) if call.outer else call.part
    try:
        edit = import_read(
            call.file, scene, parts=parts, unit=call.unit, up=call.up, assembling=assembling
        )
    except ValueError as problem:  # more parts than there can be regions
        raise WrongCall(str(problem)) from None
    organ = edit(EMPTY)
    assert organ.source is not None
    source = organ.source
    repaired = asdict(source.repairs)
    report = {
        "out": str(call.out),
        "unit": source.unit,
        "unit_guessed": source.unit_guessed,
        "unit_reason": source.unit_reason,
        "up": source.up,
        "up_reason": source.up_reason,
        "parts_used": list(source.parts),
        "assembly": None if organ.assembly is None else asdict(organ.assembly),
        "regions": {},
        "colour": None if edit.colour is None else write_colour(edit.colour),
        "welded_vertices": repaired.pop("welded_vertices"),
        "repaired": repaired,
    }
    organ, cleaned = clean(call, organ)
    report |= cleaned
    if call.vertices is not None:
        organ, report["decimated"] = decimate_to(organ, call.vertices, call.file)
    assert organ.surface is not None and organ.source is not None
    report["regions"] = {name: len(ids) for name, ids in organ.regions.items()}
    report["mesh"] = measure_surface(organ.surface)[0].as_dict()
    report["notes"] = list(organ.source.notes)
    report["wall_thickness_m"] = organ.material.wall_thickness
    report["problems"] = [describe_problem(p, organ.surface) for p in list_surface_problems(organ)]
    write_any(call.out, organ)
    return report


def describe_assembly(report: Report) -> str:
    done = report["assembly"] or {}
    if done.get("subtracted"):
        return f"united, without {', '.join(done['subtracted'])}"
    return "united" if done.get("unite") else f"{report['welded_vertices']} vertices welded"


def describe_import(report: Report) -> str:
    mesh = report["mesh"]
    loops = mesh["border_loops"]
    done = ", ".join(
        f"{count} {name.replace('_', ' ')}" for name, count in report["repaired"].items() if count
    )
    lines = [
        f"parts {', '.join(report['parts_used'])}; {describe_assembly(report)}",
        f"unit {report['unit']}: {report['unit_reason']}; up {report['up']}: {report['up_reason']}",
        f"repaired: {done or 'nothing to do'}",
        "closed"
        if not loops
        else f"{describe_loops(loops)}, kept open as a wall of "
        f"{1e3 * report['wall_thickness_m']:g} mm (palpate material --wall; palpate repair "
        "--fill-holes closes them)",
    ]
    lines += describe_cleaning(report)
    if "decimated" in report:
        lines.append(describe_decimate(report["decimated"]))
    lines.append(
        f"wrote {report['out']}: {mesh['vertices']} vertices, {mesh['triangles']} triangles"
    )
    if report["regions"]:
        rows = [f"{name} ({count} vertices)" for name, count in report["regions"].items()]
        lines.append(f"regions: {', '.join(rows)}")
    lines += [f"note: {note}" for note in report["notes"]]
    wrong = [p for p in report["problems"] if p["severity"] == "error"]
    if wrong:
        lines += ["no tissue can be built on it yet:", *describe_problems(wrong)]
    return "\n".join(lines)


VERBS = [
    Verb(
        "import",
        "read a mesh file, weld, repair, orient, and write it in metres, z up",
        "palpate import VH_F_Spleen.glb -o spleen.organ",
        add_import,
        run_import,
        describe_import,
    ),
]
