# SPDX-License-Identifier: GPL-3.0-or-later
"""The verbs about mesh files: inspect, import."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall

from palpate_editor import authoring
from palpate_editor.appearance import write_colour
from palpate_editor.check import describe_problem, measure_surface, place_problem
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.problems import Facts
from palpate_editor.document.rules import find_import_problems, find_repair_problems
from palpate_editor.edits import import_read
from palpate_editor.verbs.check import describe_problems
from palpate_editor.verbs.clean import add_cleaning, clean, describe_cleaning
from palpate_editor.verbs.decimate import decimate_to, describe_decimate
from palpate_editor.verbs.files import (
    OUTPUTS,
    describe_loops,
    write_any,
)
from palpate_editor.verbs.parts import (
    add_assembling,
    choose_outer,
    describe_parts,
    read_assembling,
    report_parts,
)

UNITS = ("m", "cm", "mm", "um", "in", "ft")
UPS = ("x", "y", "z", "-x", "-y", "-z")


def add_source(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--part",
        action="append",
        default=[],
        metavar="NAME",
        help="part of the file to use, or a group of parts, may be repeated; default: all",
    )
    parser.add_argument("--unit", choices=UNITS, help="of the file; default: stated or guessed")
    parser.add_argument("--up", choices=UPS, help="axis of the file; default: stated or z")
    add_assembling(parser)


# ---------------------------------------------------------------- inspect


def add_inspect(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="mesh file")
    add_source(parser)


def run_inspect(call: argparse.Namespace) -> Report:
    scene = authoring.read_mesh(call.file)
    options = read_assembling(call).options()
    joined = authoring.join_parts(scene, parts=call.part, unit=call.unit, up=call.up, **options)
    return {
        **authoring.inspect_mesh(joined.mesh).as_dict(),
        "unit": joined.unit,
        "unit_guessed": joined.unit_guessed,
        "unit_reason": joined.unit_reason,
        "up": joined.up,
        "up_guessed": joined.up_guessed,
        "up_reason": joined.up_reason,
        "format": scene.format,
        "parts": report_parts(scene, joined.unit, joined.up),
        "parts_used": list(joined.parts),
        "subtracted": list(joined.subtracted),
        "welded_vertices": joined.welded_vertices,
        "notes": list(scene.notes),
    }


def describe_inspect(report: Report) -> str:
    def known(value: object, unit: str = "") -> str:
        return "unknown" if value is None else f"{value:.4g}{unit}"

    loops = report["border_loops"]
    guess = "guessed" if report["unit_guessed"] else "stated"
    lines = [
        f"{report['vertices']} vertices, {report['triangles']} triangles, "
        f"{report['shells']} shell(s), genus {known(report['genus'])}",
        "closed" if report["closed"] else f"open: {describe_loops(loops)}",
        f"outward: {'unknown' if report['outward'] is None else report['outward']}",
        f"{report['non_manifold_edges']} non-manifold edges, "
        f"{known(report['self_intersecting_faces'])} self-intersecting faces, smallest angle "
        f"{known(report['smallest_angle_deg'], ' degrees')}",
        f"size {' x '.join(f'{length:.1f}' for length in report['size_mm'])} mm, volume "
        f"{known(report['volume_ml'], ' ml')}",
        f"unit {report['unit']} ({guess}: {report['unit_reason']})",
        f"up {report['up']} ({report['up_reason']})",
        *describe_parts(report["parts"]),
    ]
    return "\n".join(lines + [f"note: {note}" for note in report["notes"]])


# ---------------------------------------------------------------- import


def add_import(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file", type=Path, help="OBJ, STL, PLY, OFF, GLB, 3DS, FBX, DAE, VTK, VTP, VTU or MSH"
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
    assert organ.surface is not None
    report["regions"] = {name: len(ids) for name, ids in organ.regions.items()}
    mesh, facts = measure_surface(organ.surface)
    report["mesh"] = mesh.as_dict()
    report["notes"] = list(source.notes)
    report["problems"] = list_problems(organ, Facts(facts))
    write_any(call.out, organ)
    return report


def list_problems(organ: Organ, facts: Facts) -> list[Report]:
    """What is wrong with an imported surface, before anything is built on it."""
    found = [*find_import_problems(organ, facts), *find_repair_problems(organ, facts)]
    return [describe_problem(place_problem(p, organ, facts), organ.surface) for p in found]


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
        else f"{describe_loops(loops)}, kept open (palpate repair --fill-holes closes them)",
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
        "inspect",
        "say what is good and bad about a mesh file",
        "palpate inspect VH_F_Spleen.glb --json",
        add_inspect,
        run_inspect,
        describe_inspect,
    ),
    Verb(
        "import",
        "read a mesh file, weld, repair, orient, and write it in metres, z up",
        "palpate import VH_F_Spleen.glb -o spleen.organ",
        add_import,
        run_import,
        describe_import,
    ),
]
