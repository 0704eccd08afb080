# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of labels, where a file has them: tables of NIfTI extensions and segments of NRRD."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from palpate_editor.scan_child.nifti_header import open_nifti

MOST_BYTES = 262144
"""Of the beginning of a NIfTI file, where its extensions stand."""
MOST_LETTERS = 80
LABEL = re.compile(rb'<Label Key="(-?\d{1,9})"[^>]*>\s*<!\[CDATA\[([^\]]*)\]\]>')
VALUE = re.compile(r"Segment(\d+)_LabelValue")


def find_label_names(path: Path, meta: Mapping[str, str]) -> dict[int, str]:
    """Label -> name; a file that has no names, or damaged ones, gives none."""
    if path.name.endswith((".nii", ".nii.gz")):
        return read_nifti_names(path)
    names: dict[int, str] = {}
    for key, value in meta.items():
        found = VALUE.fullmatch(key)
        name = meta.get(f"Segment{found[1]}_Name", "") if found else ""
        if name and value.strip().isdecimal():
            names[int(value)] = clean(name)
    return names


def read_nifti_names(path: Path) -> dict[int, str]:
    """Of a label table as Connectome Workbench and TotalSegmentator write it."""
    try:
        with open_nifti(path) as file:
            head = file.read(MOST_BYTES)
    except (OSError, EOFError):
        return {}
    end = head.find(b"</LabelTable>")
    found = LABEL.findall(head[: max(end, 0)])
    return {int(key): clean(name.decode(errors="replace")) for key, name in found if name}


def clean(name: str) -> str:
    return "".join(letter for letter in name if letter.isprintable()).strip()[:MOST_LETTERS]
