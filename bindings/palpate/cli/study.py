# SPDX-License-Identifier: BSD-3-Clause
"""The verb `study`: models held against finite elements, as a table and as a chart."""

from __future__ import annotations

import argparse
from dataclasses import asdict

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb
from palpate.files.file_kind import FINDINGS, PICTURE
from palpate.study.findings import write_findings
from palpate.study.reference import list_references, read_reference

SHIPPED = ("spleen", "kidney", "liver", "gallbladder", "stomach")


def add_study(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("what", choices=("accuracy",), help="accuracy: models beside references")
    parser.add_argument(
        "--reference",
        action="append",
        choices=list_references(),
        help="may be repeated; without it the shipped organs",
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


def describe_study(report: Report) -> str:
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
