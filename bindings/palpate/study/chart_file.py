# SPDX-License-Identifier: BSD-3-Clause
"""Charts of organs as readable JSON, a line for each row; chart.schema.json describes the file."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from palpate.files.json_part import read_part
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import CONTACT_LAWS, FILLED, KINDS, ORIGINS
from palpate.study.row_file import Fault, check_rows, read_rows, write_rows
from palpate.study.scene_chart import FAR_FIELDS, OUTCOMES, PATHS, RAN, Chart, Row

FORMAT, VERSION = "palpate chart", 1
MOST_BYTES = 16 * 2**20
MOST_ROWS = 10_000


def write_chart(path: Path, chart: Chart) -> None:
    """Writes whole or not at all. Raises OSError."""
    write_rows(path, asdict(chart), FORMAT, VERSION)


def read_chart(path: Path) -> Chart:
    """Checked field by field and against its hash. Raises Refusal or OSError."""
    content, told = read_rows(path, FORMAT, VERSION, "a chart", MOST_BYTES, MOST_ROWS)
    given = content | {"rows": [add_far_field(row) for row in content["rows"]]}
    chart: Chart = read_part(path, "chart", Chart, given, whole=True)
    check_rows(path, content, told, find_faults(chart))
    return chart


def add_far_field(row: Any) -> Any:
    """Of charts of before there was a choice: that of the mesh."""
    found = row.get("configuration") if isinstance(row, dict) else None
    if not isinstance(found, dict) or "far_field" in found:
        return row
    return row | {"configuration": found | {"far_field": "mesh"}}


def read_row(file: object, where: str, data: Any) -> Row:
    """One row by itself, as a run that goes on keeps them. Raises Refusal."""
    row: Row = read_part(file, where, Row, data, whole=True)
    for what, got, expected in find_row_faults(where, row):
        raise Refusal(file, what, got, expected)
    return row


def find_faults(chart: Chart) -> Iterator[Fault]:
    """What does not belong together, though every field is of its kind."""
    positive = {
        "young_modulus": chart.young_modulus,
        "tool_radius": chart.tool_radius,
        "rate": chart.rate,
        "truth.force": chart.truth.force,
        "way.speed": chart.way.speed,
        "force_target": chart.force_target,
        "displacement_target": chart.displacement_target,
    }
    for where, value in positive.items():
        if not value > 0.0:
            yield where, f"{value:g}", "a number above 0"
    for where, value in {
        "truth.force_error": chart.truth.force_error,
        "truth.displacement_error": chart.truth.displacement_error,
    }.items():
        if not value >= 0.0:
            yield where, f"{value:g}", "0 or more"
    if chart.way.kind not in PATHS:
        yield "way.kind", repr(chart.way.kind), "one of " + ", ".join(PATHS)
    for i, row in enumerate(chart.rows):
        yield from find_row_faults(f"rows[{i}]", row)
        if row.number != i:
            yield f"rows[{i}].number", str(row.number), f"{i}, its place in the list"
    own = sum(row.own for row in chart.rows)
    if chart.rows and own != 1:
        yield "rows", f"{own} rows of the organ's own configuration", "one"


def find_row_faults(where: str, row: Row) -> Iterator[Fault]:
    choices = {
        "outcome": (row.outcome, OUTCOMES),
        "configuration.kind": (row.configuration.kind, KINDS),
        "configuration.constants": (row.configuration.constants, ORIGINS),
        "configuration.contact_law": (row.configuration.contact_law, CONTACT_LAWS),
        "configuration.far_field": (row.configuration.far_field, FAR_FIELDS),
    }
    for name, (value, allowed) in choices.items():
        if value not in allowed:
            yield f"{where}.{name}", repr(value), "one of " + ", ".join(allowed)
    ran = row.outcome == RAN
    if ran != (row.total is not None) or (ran and row.counts is None):
        yield (
            f"{where}.total",
            "nothing" if row.total is None else "errors",
            ("errors and counts of a run that came to its end, and of no other"),
        )
    if ran == bool(row.reason):
        yield f"{where}.reason", repr(row.reason), "one where it did not run to the end, only there"
    if (row.configuration.kind in FILLED) != (row.configuration.tetrahedra > 0):
        found = str(row.configuration.tetrahedra)
        yield f"{where}.configuration.tetrahedra", found, "more than 0 of a solid, 0 of a surface"
    for name, value in list_sizes(row):
        if not (value >= 0.0 and math.isfinite(value)):
            yield f"{where}.{name}", f"{value:g}", "0 or more"


def list_sizes(row: Row) -> Iterator[tuple[str, float]]:
    """What is never below 0."""
    yield "jump", row.jump
    for name in ("substeps", "vertices", "tetrahedra"):
        yield f"configuration.{name}", getattr(row.configuration, name)
    for name in ("total", "model", "time", "counts", "cost"):
        part = getattr(row, name)
        for key, value in asdict(part).items() if part is not None else ():
            if value is not None:
                yield f"{name}.{key}", value
