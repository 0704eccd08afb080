# SPDX-License-Identifier: GPL-3.0-or-later
"""The far fields of the solids that come with Palpate, solved once and kept beside their meshes.

    .venv/bin/python -m palpate_editor.shipped_far_fields [NAME ...]

solves those that are missing, and those that are of another surface than the organ has now: a
minute to four each.
"""

from __future__ import annotations

import sys

from palpate_meshes.catalogue import read_catalogue

from palpate_editor.document import Organ
from palpate_editor.document.far_compliance import compute_key, wants_far_field
from palpate_editor.far_field_tables import find_table, read_table, write_table
from palpate_editor.shipped import make_organ


def list_missing(names: list[str]) -> list[tuple[str, Organ]]:
    """Shipped solids with no table, or one that was solved for something else."""
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
