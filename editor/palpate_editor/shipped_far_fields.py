# SPDX-License-Identifier: GPL-3.0-or-later
"""The far fields of the solids that come with Palpate, solved once and kept beside their meshes.

    .venv/bin/python -m palpate_editor.shipped_far_fields [NAME ...]

solves those that are missing, and those that are of another surface than the organ has now: a
minute to four each.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
from palpate.files.whole_file import write_whole
from palpate_meshes.catalogue import PUBLISHED, read_catalogue

from palpate_editor.document import Organ
from palpate_editor.document.far_compliance import compute_key, wants_far_field
from palpate_editor.document.far_field import FarField

FORMAT, VERSION = "palpate-far-field", 1


def find_table(name: str) -> Path:
    return PUBLISHED / f"{name}.far_field.json"


def read_table(name: str) -> FarField | None:
    """Of a shipped organ; None where none is kept. Raises ValueError or OSError."""
    path = find_table(name)
    if not path.is_file():
        return None
    content = json.loads(path.read_text(encoding="utf-8"))
    if (content.get("format"), content.get("version")) != (FORMAT, VERSION):
        raise ValueError(f"{path}: format: expected {FORMAT!r} of version {VERSION}")
    softness = np.array(content["softness"], float).ravel()
    return FarField(content["key"], content["patch"], content["tetrahedra"], softness)


def write_table(name: str, table: FarField) -> None:
    head = {
        "format": FORMAT,
        "version": VERSION,
        "command": f"python -m palpate_editor.shipped_far_fields {name}",
        "key": table.key,
        "patch": table.patch,
        "tetrahedra": table.tetrahedra,
    }
    rows = ",\n  ".join(json.dumps([float(f"{v:.9g}") for v in row]) for row in table.tensors)
    text = f'{json.dumps(head, indent=1)[:-2]},\n "softness": [\n  {rows}\n ]\n}}\n'
    write_whole(find_table(name), text.encode())


def list_missing(names: list[str]) -> list[tuple[str, Organ]]:
    """Shipped solids with no table, or one that was solved for something else."""
    from palpate_editor.shipped import make_organ

    found = []
    for name in names:
        organ = make_organ(name)
        if wants_far_field(organ):
            table = read_table(name)
            if table is None or table.key != compute_key(organ):
                found.append((name, organ))
    return found


def main(names: list[str]) -> None:
    # it loads the solver
    from palpate_editor.truth.far_field import solve_far_field

    for name, organ in list_missing(names or list(read_catalogue())):
        table = solve_far_field(organ)
        write_table(name, table)
        print(f"{find_table(name)}: {len(table.tensors)} vertices, {table.tetrahedra} tetrahedra")


if __name__ == "__main__":
    main(sys.argv[1:])
