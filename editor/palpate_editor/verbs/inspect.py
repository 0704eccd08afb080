# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `inspect`: all that is good, bad and doubtful about a surface, and changes nothing."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

from palpate.command.verb import Report, Verb

from palpate_editor import authoring
from palpate_editor.check import describe_problem, measure_surface
from palpate_editor.compile import surface_of
from palpate_editor.doctor import find_stable_step, list_repaired, list_surface_problems
from palpate_editor.document import EMPTY, Organ, Source, Surface
from palpate_editor.edits.import_mesh import import_read
from palpate_editor.verbs.check import describe_problems
from palpate_editor.verbs.files import describe_loops, open_any
from palpate_editor.verbs.parts import describe_parts, read_assembling, report_parts
from palpate_editor.verbs.source import add_source

BARS = " ▁▂▃▄▅▆▇█"


def add_inspect(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="mesh file of any format that is read, or .organ")
    add_source(parser)


def run_inspect(call: argparse.Namespace) -> Report:
    if call.file.suffix == ".organ":
        return inspect_organ(open_any(call.file))
    scene = authoring.read_mesh(call.file)
    assembling = read_assembling(call)
    edit = import_read(
        call.file, scene, parts=call.part, unit=call.unit, up=call.up, assembling=assembling
    )
    source = edit.source
    joined = authoring.join_parts(
        scene, parts=call.part, unit=source.unit, up=source.up, **assembling.options()
    )
    raw = joined.mesh
    found = authoring.inspect_mesh(raw)
    repaired = [describe_problem(p, surface_of(raw)) for p in list_repaired(surface_of(raw), found)]
    organ = edit(EMPTY)
    return {
        **found.as_dict(),
        **describe_meaning(source),
        "parts": report_parts(scene, source.unit, source.up),
        "subtracted": list(joined.subtracted),
        **judge(organ, repaired),
    }


def inspect_organ(organ: Organ) -> Report:
    """Of the surface a working file's tissue is built on."""
    surface = organ.surface if organ.surface is not None else Surface([], [])
    found, _ = measure_surface(surface)
    meaning = {} if organ.source is None else describe_meaning(organ.source)
    return {**found.as_dict(), **meaning, "parts": [], **judge(organ, [])}


def judge(organ: Organ, repaired: list[Report]) -> Report:
    found = list_surface_problems(organ)
    return {
        "repaired_at_import": repaired,
        "problems": [describe_problem(p, organ.surface) for p in found],
        "stable_step": asdict(find_stable_step(organ)),
    }


def describe_meaning(source: Source) -> Report:
    return {
        "unit": source.unit,
        "unit_guessed": source.unit_guessed,
        "unit_reason": source.unit_reason,
        "up": source.up,
        "up_guessed": source.up_guessed,
        "up_reason": source.up_reason,
        "format": source.format,
        "parts_used": list(source.parts),
        "welded_vertices": source.repairs.welded_vertices,
        "notes": list(source.notes),
    }


# ---------------------------------------------------------------- in words


def describe_inspect(report: Report) -> str:
    lines = [*describe_size(report), *describe_triangles(report), *describe_step(report)]
    lines += describe_source(report)
    if report["repaired_at_import"]:
        lines += ["importing it repairs:", *describe_problems(report["repaired_at_import"])]
    if report["problems"]:
        lines += ["then there is:", *describe_problems(report["problems"])]
    else:
        lines.append("then nothing is wrong with its surface")
    return "\n".join(lines)


def known(value: float | None, unit: str = "") -> str:
    return "unknown" if value is None else f"{value:.4g}{unit}"


def describe_size(report: Report) -> list[str]:
    outward = {True: "outwards", False: "inwards", None: "unknown"}[report["outward"]]
    return [
        f"{report['vertices']} vertices, {report['triangles']} triangles, "
        f"{report['shells']} shell(s), genus {known(report['genus'])}, Euler number "
        f"{report['euler_number']}",
        f"size {' x '.join(f'{length:.1f}' for length in report['size_mm'])} mm, volume "
        f"{known(report['volume_ml'], ' ml')}, thinnest {known(report['thinnest_mm'], ' mm')}",
        "closed" if report["closed"] else f"open: {describe_borders(report)}",
        f"triangles face {outward}; {report['non_manifold_edges']} edges of more than two, "
        f"{known(report['self_intersecting_faces'])} that cross others",
    ]


def describe_borders(report: Report) -> str:
    lengths = report["border_lengths_mm"]
    around = f"{lengths[0]:.1f} mm around"
    if len(lengths) > 1:
        around = f"{min(lengths):.1f} to {max(lengths):.1f} mm around"
    return f"{describe_loops(report['border_loops'])}, {around}"


def describe_triangles(report: Report) -> list[str]:
    if not report["triangles"]:
        return []
    shortest, median, longest = report["edges_mm"]
    return [
        f"angles {draw_bars(report['angles_deg']['counts'])} 0 to 180 degrees, smallest "
        f"{known(report['smallest_angle_deg'], ' degrees')}",
        f"edges  {draw_bars(report['edge_lengths_mm']['counts'])} {shortest:.3g} to {longest:.3g} "
        f"mm, half of them below {median:.3g} mm",
    ]


def draw_bars(counts: list[int]) -> str:
    """A letter for each count, as high as it is; what is there at all can be seen."""
    most = max(counts, default=0)
    steps = len(BARS) - 1
    return "".join(BARS[-(-count * steps // most)] if count else BARS[0] for count in counts)


def describe_step(report: Report) -> list[str]:
    found = report["stable_step"]
    if found["step"] is None:
        return [f"stable step unknown: {found['refusal']}"]
    wall = "" if found["wall"] is None else f" and a wall of {1e3 * found['wall']:g} mm"
    kind = found["kind"].replace("_", " ")
    return [
        f"stable step {1e6 * found['step']:.3g} us as a {kind} of the constants it has{wall}: "
        f"{found['substeps']} a tick"
    ]


def describe_source(report: Report) -> list[str]:
    if "unit" not in report:
        return []
    guess = "guessed" if report["unit_guessed"] else "stated"
    lines = [
        f"unit {report['unit']} ({guess}: {report['unit_reason']})",
        f"up {report['up']} ({report['up_reason']})",
    ]
    if report["parts"]:
        lines += describe_parts(report["parts"])
    return lines + [f"note: {note}" for note in report["notes"]]


VERBS = [
    Verb(
        "inspect",
        "say what is good and bad about a mesh file",
        "palpate inspect VH_F_Spleen.glb --json",
        add_inspect,
        run_inspect,
        describe_inspect,
    ),
]
