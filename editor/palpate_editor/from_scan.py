# SPDX-License-Identifier: GPL-3.0-or-later
"""An organ out of a scan: the same document, and the same stages after it, as of a mesh file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Repairs, Segmentation, Source, Surface
from palpate_editor.edits.import_mesh import REPAIRS, ImportMesh, make_writable
from palpate_editor.edits.orient import METRES
from palpate_editor.scan import Choice, Limits, ScanSurface, describe_choice, hash_scan
from palpate_editor.scan.reader import never, segment_scan

STATED = "scans are in millimetres"
FRAME = "the scan says where the patient's head is"
SIDES = "left, right, front, back, bottom and top are the patient's"


CUT_ENDS = {
    "left": "the organ ends where the scan does at the left, and is closed there flat",
    "right": "the organ ends where the scan does at the right, and is closed there flat",
    "front": "the organ ends where the scan does at the front, and is closed there flat",
    "back": "the organ ends where the scan does at the back, and is closed there flat",
    "bottom": "the organ ends where the scan does at the bottom, and is closed there flat",
    "top": "the organ ends where the scan does at the top, and is closed there flat",
}
"""Sides of the patient -> what is to be said."""


def import_scan(
    path: Path,
    choice: Choice,
    *,
    series: str | None = None,
    unit: str | None = None,
    limits: Limits | None = None,
    stopped: Callable[[], bool] = never,
) -> tuple[ImportMesh, ScanSurface]:
    """Reads a scan, cuts the organ out, and makes the edit that puts it in the editor.

    Args:
        path: A volume, or a folder of DICOM slices.
        choice: Which voxels.
        series: Of several in a folder.
        unit: Of the volume's spacing, where it is not millimetres.
        limits: Of the reader.
        stopped: See `read_scan`; it is asked for as long as the scan is read.

    Raises what `segment_scan` does.
    """
    found = segment_scan(path, choice, series=series, limits=limits, stopped=stopped)
    return build_import(path, found, series=series, unit=unit), found


def build_import(
    path: Path, found: ScanSurface, *, series: str | None = None, unit: str | None = None
) -> ImportMesh:
    """The edit for a surface that was cut. Raises OSError where the scan can no longer be read."""
    ratio = 1.0 if unit is None else METRES[unit] / METRES["mm"]
    repaired = authoring.repair_mesh(palpate.SurfaceMesh(ratio * found.vertices, found.triangles))
    surface = Surface(np.asarray(repaired.mesh.vertices), np.asarray(repaired.mesh.triangles))
    chosen = describe_choice(found.choice)
    labels = found.scan.labels
    source = Source(
        file=make_writable(path.resolve().name),
        folder=make_writable(str(path.resolve().parent)),
        sha256=hash_scan(path),
        format=found.scan.format,
        parts_available=(chosen,)
        if not found.choice.labels or labels is None
        else tuple(f"label {row.label}" for row in labels),
        parts=(chosen,)
        if not found.choice.labels
        else tuple(f"label {label}" for label in found.choice.labels),
        unit="mm" if unit is None else unit,
        unit_guessed=False,
        unit_reason=STATED if unit is None else "as asked",
        up="z",
        up_guessed=False,
        up_reason=FRAME,
        repairs=Repairs(**{name: getattr(repaired, name) for name in REPAIRS}),
        notes=tuple(list_notes(found)),
    )
    return ImportMesh(name_organ(path, found), source, surface, describe(found, series, ratio))


def describe(found: ScanSurface, series: str | None, ratio: float) -> Segmentation:
    """The line of history; `ratio` of the unit that was asked for to millimetres."""
    choice, cubed = found.choice, ratio**3
    return Segmentation(
        series=series or "",
        labels=choice.labels,
        low=choice.low,
        high=choice.high,
        smooth=choice.smoothing,
        largest=choice.largest,
        least_volume=choice.least_volume,
        size=found.scan.size,
        spacing=tuple((ratio * found.scan.spacing).tolist()),
        tilt=found.scan.tilt,
        voxel_volume=cubed * found.voxel_volume,
        volume=cubed * found.volume,
        volume_change=found.change,
        pieces_dropped=found.pieces_dropped,
        shells_dropped=found.shells_dropped,
    )


def list_notes(found: ScanSurface) -> list[str]:
    """What a designer should know about the scan and what was cut out of it."""
    notes = list(found.scan.notes)
    return notes + [CUT_ENDS[side] for side in found.cut_sides]


def name_organ(path: Path, found: ScanSurface) -> str:
    """The label's own name, where one label with a name was taken; else the file's."""
    if len(found.choice.labels) == 1 and found.scan.labels:
        for row in found.scan.labels:
            if row.label == found.choice.labels[0] and row.name:
                return row.name.replace("_", " ")
    name = path.resolve().name
    for ending in (".gz", *{Path(name.removesuffix(".gz")).suffix}):
        name = name.removesuffix(ending)
    return make_writable(name)
