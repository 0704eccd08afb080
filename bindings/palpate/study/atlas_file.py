# SPDX-License-Identifier: BSD-3-Clause
"""Atlases of organs as readable JSON, a line for each row; atlas.schema.json describes the file."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from palpate.files.json_part import read_part
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import INTEGRATORS, KINDS, ORIGINS
from palpate.study.atlas import (
    DAMPINGS,
    LIMITED,
    LOST,
    MESHES,
    OUTCOMES,
    REFUSED,
    Atlas,
    Row,
)
from palpate.study.row_file import Fault, check_rows, read_rows, write_rows

FORMAT, VERSION = "palpate atlas", 1
MOST_BYTES = 16 * 2**20
MOST_ROWS = 20_000


def write_atlas(path: Path, atlas: Atlas) -> None:
    """Writes whole or not at all. Raises OSError."""
    write_rows(path, asdict(atlas), FORMAT, VERSION)


def read_atlas(path: Path) -> Atlas:
    """Checked field by field and against its hash. Raises Refusal or OSError."""
    content, told = read_rows(path, FORMAT, VERSION, "an atlas", MOST_BYTES, MOST_ROWS)
    atlas: Atlas = read_part(path, "atlas", Atlas, content, whole=True)
    check_rows(path, content, told, find_faults(atlas))
    return atlas


def read_row(file: object, where: str, data: Any) -> Row:
    """One row by itself, as a run that goes on keeps them. Raises Refusal."""
    row: Row = read_part(file, where, Row, data, whole=True)
    for what, got, expected in find_row_faults(where, row):
        raise Refusal(file, what, got, expected)
    return row


def find_faults(atlas: Atlas) -> Iterator[Fault]:
    """What does not belong together, though every field is of its kind."""
    present = atlas.present
    for where, value in {
        "rate": atlas.rate,
        "steps": atlas.steps,
        "present.step": present.step,
        "present.substeps": present.substeps,
        "present.young_modulus": present.young_modulus,
        "present.size": present.size,
    }.items():
        if not value > 0.0:
            yield where, f"{value:g}", "a number above 0"
    yield from find_strangers("present", present.kind, present.integrator)
    if present.constants not in ORIGINS:
        yield "present.constants", repr(present.constants), "one of " + ", ".join(ORIGINS)
    for where, limit in (("predicted", present.predicted), ("measured", present.measured)):
        if limit is not None and not limit > 0.0:
            yield f"present.{where}", f"{limit:g}", "a number above 0, or null"
    for i, row in enumerate(atlas.rows):
        yield from find_row_faults(f"rows[{i}]", row)
        if row.number != i:
            yield f"rows[{i}].number", str(row.number), f"{i}, its place in the list"


def find_strangers(where: str, kind: str, integrator: str) -> Iterator[Fault]:
    for name, value, allowed in (("kind", kind, KINDS), ("integrator", integrator, INTEGRATORS)):
        if value not in allowed:
            yield f"{where}.{name}", repr(value), "one of " + ", ".join(allowed)


def find_row_faults(where: str, row: Row) -> Iterator[Fault]:
    yield from find_strangers(where, row.spot.kind, row.integrator)
    choices = {
        "outcome": (row.outcome, OUTCOMES),
        "spot.damping": (row.spot.damping, DAMPINGS),
        "spot.mesh": (row.spot.mesh, MESHES),
    }
    for name, (value, allowed) in choices.items():
        if value not in allowed:
            yield f"{where}.{name}", repr(value), "one of " + ", ".join(allowed)
    if not row.spot.stiffness > 0.0:
        yield f"{where}.spot.stiffness", f"{row.spot.stiffness:g}", "a number above 0"
    if (row.outcome == LIMITED) != (row.predicted is not None):
        yield f"{where}.predicted", repr(row.predicted), "a limit of a limited row, and of no other"
    if (row.outcome in (REFUSED, LOST)) != bool(row.reason):
        yield f"{where}.reason", repr(row.reason), "one where it did not run, only there"
    for name in ("predicted", "held", "failed"):
        step = getattr(row, name)
        if step is not None and not step > 0.0:
            yield f"{where}.{name}", f"{step:g}", "a number above 0, or null"
    if row.held is not None and row.failed is not None and not row.held < row.failed:
        yield f"{where}.held", f"{row.held:g}", f"less than what failed, {row.failed:g}"
