# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scan is, before anything is cut out of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from palpate_editor.scan_child.dicom_series import read_dicom_folder
from palpate_editor.scan_child.refused import Refused
from palpate_editor.scan_child.volume import Volume, check_voxels
from palpate_editor.scan_child.volume_file import read_volume_file

MOST_LABELS = 512
"""Different whole numbers that are labels; more are grey levels."""
PATCHES = 0.5
"""[-] Of their voxels, that have an equal neighbour in labels; grey levels have noise."""
TILTED = 0.1
"""[degree] From which a gantry was tilted."""
FINE, COARSE = 0.05, 20.0
"""[mm] Between voxels: less or more than a clinical scan has, whose unit may be another."""


def read_scan(path: Path, series: str | None) -> Volume:
    """A file, or a folder of DICOM slices. Raises Refused or OSError."""
    if path.is_dir():
        volume = read_dicom_folder(path, series)
    elif series is not None:
        raise Refused("--series", "one file", "a folder of DICOM slices")
    else:
        path.open("rb").close()
        volume = read_volume_file(path)
    check_voxels(volume.voxels)
    return volume


def describe_volume(volume: Volume) -> dict[str, Any]:
    """Numbers for JSON; lengths in millimetres, as scans have them."""
    voxels = volume.voxels
    spacing = np.linalg.norm(volume.steps, axis=0)
    notes = list(volume.notes)
    if volume.tilt > TILTED:
        notes.append(f"the gantry was tilted by {volume.tilt:.1f} degrees")
    if spacing.min() < FINE or spacing.max() > COARSE:
        shown = " x ".join(f"{length:.4g}" for length in spacing)
        notes.append(f"voxels of {shown} mm are not those of a clinical scan: is the unit another?")
    return {
        "format": volume.format,
        "size": list(voxels.shape[::-1]),
        "spacing": spacing.tolist(),
        "steps": volume.steps.tolist(),
        "origin": volume.origin.tolist(),
        "tilt": volume.tilt,
        "type": str(voxels.dtype),
        "low": float(voxels.min()),
        "high": float(voxels.max()),
        "labels": list_labels(volume),
        "notes": notes,
    }


def list_labels(volume: Volume) -> list[dict[str, Any]] | None:
    """Each label but 0 with its name and its voxels; None for grey levels."""
    voxels = volume.voxels
    if np.issubdtype(voxels.dtype, np.floating) and (voxels != np.rint(voxels)).any():
        return None
    if float(voxels.min()) < 0.0:
        return None
    found, counts = np.unique(voxels, return_counts=True)
    if len(found) > MOST_LABELS or not is_in_patches(voxels):
        return None
    return [
        {"label": int(label), "name": volume.names.get(int(label), ""), "voxels": int(count)}
        for label, count in zip(found, counts, strict=True)
        if label != 0
    ]


def is_in_patches(voxels: np.ndarray) -> bool:
    """Whether most voxels that are not 0 have a neighbour of the same number along their row."""
    first = voxels[:, :, :-1]
    chosen = first != 0
    return bool((first == voxels[:, :, 1:])[chosen].sum() >= PATCHES * chosen.sum())


def save(path: Path, array: np.ndarray) -> None:
    np.save(path, np.ascontiguousarray(array), allow_pickle=False)
