# SPDX-License-Identifier: GPL-3.0-or-later
"""What is known of a scan, and what was cut out of it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from palpate_editor.scan_child.choice import Choice


@dataclass(frozen=True)
class Label:
    """A label of a volume."""

    label: int
    name: str
    """Empty where the file has none."""
    voxels: int


@dataclass(frozen=True)
class Series:
    """One of several in a folder of DICOM slices."""

    uid: str
    title: str
    """Empty where the files have none."""
    slices: int
    size: tuple[int, ...]
    """Columns and rows."""


@dataclass(frozen=True, eq=False)
class Scan:
    """A volume, as its file describes it."""

    path: Path
    format: str
    size: tuple[int, ...]
    """Columns, rows, slices."""
    steps: np.ndarray
    """[m] (3, 3): column c is the way to the next column, row, slice; x to the patient's left, y to
    his back, z up."""
    origin: np.ndarray
    """[m] (3,) Of the first voxel's middle."""
    tilt: float
    """[degree] Of the gantry."""
    type: str
    low: float
    high: float
    labels: tuple[Label, ...] | None
    """None for grey levels."""
    notes: tuple[str, ...]
    voxels: np.ndarray | None = None
    """(d, h, w), where it was asked for."""

    @property
    def spacing(self) -> np.ndarray:
        """[m] (3,)"""
        return np.linalg.norm(self.steps, axis=0)

    @property
    def voxel_volume(self) -> float:
        """[m³]"""
        return float(abs(np.linalg.det(self.steps)))


@dataclass(frozen=True, eq=False)
class ScanSurface:
    """A closed surface that was cut out of a scan."""

    scan: Scan
    choice: Choice
    vertices: np.ndarray
    """[m] (n, 3)"""
    triangles: np.ndarray
    """(t, 3) int32, outward"""
    voxel_volume: float
    """[m³] Of the chosen voxels."""
    volume: float
    """[m³] Inside the surface."""
    change: float
    """[-] Of the volume, by smoothing."""
    pieces_dropped: int
    shells_dropped: int
    cut_sides: tuple[str, ...]
    """Sides of the volume at which the organ ends because the scan does."""
