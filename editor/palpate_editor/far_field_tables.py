# SPDX-License-Identifier: GPL-3.0-or-later
"""The kept far fields of the solids that come with Palpate, beside their meshes."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from palpate.files.whole_file import write_whole
from palpate_meshes.catalogue import PUBLISHED

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
