# SPDX-License-Identifier: BSD-3-Clause
"""The verb `study`: models held against finite elements, as a table and as a chart."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall
from palpate.files.file_kind import FINDINGS, PICTURE
from palpate.study.findings import write_findings
from palpate.study.reference import list_references, read_reference

if TYPE_CHECKING:  # it loads SciPy
    from palpate.study.tool import PressedScene

BLOCK = "block"
SHIPPED = ("spleen", "kidney", "liver", "gallbladder", "stomach")


def add_study(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("what", choices=("accuracy",), help="accuracy: models beside references")
    parser.add_argument(
        "--reference",
        action="append",
        choices=list_references(),
        help="may be repeated; without it the shipped organs",
    )
    parser.add_argument(
        "--tool",
        nargs="+",
        type=Path,
        metavar="FILE.palpate",
        help="press published scenes of shipped organs with balls of 2 to 8 mm instead; "
        f"{BLOCK!r} is one of 3000 tetrahedra",
    )
    parser.add_argument("--deep", action="store_true", help="deep presses and pulls too")
    add_output(
        parser,
        "--findings",
        writes=FINDINGS,
        metavar="FILE.json",
        help="keep the forces of every kind, as palpate material says them",
    )
    add_output(parser, "--chart", writes=PICTURE, help="cost against error as PNG")


def run_study(call: argparse.Namespace) -> Report:
    # loads SciPy, which every other command does without
    if call.tool:
        return run_tool(call)
    from palpate.study.accuracy import compare_deep, compare_linear

    references = [read_reference(name) for name in call.reference or SHIPPED]
    rows = compare_linear(references)
    if call.deep:
        rows += compare_deep(references)
    report: Report = {
        "references": [
            {
                "name": reference.name,
                "title": reference.title,
                "vertices": len(reference.vertices),
                "tetrahedra": len(reference.tetrahedra),
                "wall_thickness_m": reference.wall_thickness,
                "command": reference.command,
                "places": [
                    {
                        "name": place.name,
                        "thickness_m": place.thickness,
                        "force_error": place.find("linear", "P2").force_error,
                        "displacement_error": place.find("linear", "P2").displacement_error,
                    }
                    for place in reference.places
                ],
            }
            for reference in references
        ],
        "rows": [asdict(row) for row in rows],
        "costs": [],
        "chart": None,
        "findings": None,
    }
    if call.findings is not None:
        write_findings(call.findings, rows)
        report["findings"] = str(call.findings)
    if call.chart is not None:
        # loads matplotlib, which the table does without
        from palpate.study.chart import save_chart
        from palpate.study.cost import measure_costs
        from palpate.study.models import SOLID, WALL, form_of

        costs = measure_costs(references)
        groups = {"Solid organs": SOLID, "Hollow organs, as their walls": WALL}
        save_chart(
            call.chart,
            rows,
            costs,
            {title: [r.name for r in references if form_of(r) == form]
             for title, form in groups.items()},
        )  # fmt: skip
        report["costs"] = [asdict(cost) for cost in costs]
        report["chart"] = str(call.chart)
    return report


def run_tool(call: argparse.Namespace) -> Report:
    from palpate.study.reference import LAWS
    from palpate.study.tool import compare_tool, open_pressed, tell_apart
    from palpate.study.tool_block import open_blocks

    for option in ("reference", "deep", "findings", "chart"):
        if getattr(call, option):
            raise WrongCall(f"--{option} is of models beside references, and not of --tool")
    scenes = []
    for path in call.tool:
        blocks = str(path) == BLOCK
        scenes += [*open_blocks(), *open_blocks(hard=True)] if blocks else [open_pressed(path)]
    scenes = tell_apart(scenes)
    return {
        "scenes": [describe_pressed(scene) for scene in scenes],
        "tool_rows": [
            asdict(row) for scene in scenes for law in LAWS for row in compare_tool(scene, law)
        ],
    }


def describe_pressed(scene: PressedScene) -> Report:
    which = scene.name.removeprefix(scene.reference.name) if scene.file else ""
    return {
        "file": scene.file,
        "body": scene.name,
        "title": scene.reference.title + which,
        "kind": scene.kind,
        "constants_derived": scene.derived,
        "young_modulus_Pa": scene.young_modulus,
        "tool_radius_m": scene.radius,
        "held": scene.reference.held,
        "command": scene.reference.command,
        "places": [
            {"name": place.name, "thickness_m": place.thickness} for place in scene.reference.places
        ],
    }


def describe_study(report: Report) -> str:
    if "tool_rows" in report:
        from palpate.study.tool import ToolRow, write_tool_tables

        return write_tool_tables(report["scenes"], [ToolRow(**row) for row in report["tool_rows"]])
    from palpate.study.accuracy import Row
    from palpate.study.tables import write_tables

    return write_tables(report["references"], [Row(**row) for row in report["rows"]])


STUDY = Verb(
    "study",
    "hold the kinds of tissue model against finite elements",
    "palpate study accuracy --reference spleen --deep",
    add_study,
    run_study,
    describe_study,
)
