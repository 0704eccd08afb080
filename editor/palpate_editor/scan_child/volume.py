# SPDX-License-Identifier: GPL-3.0-or-later
"""A volume as the reader has it in memory, and what every volume is held to."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from palpate_editor.scan_child.refused import Refused

MOST_VOXELS = 600_000_000
LEAST_SPACING, MOST_SPACING = 1e-4, 1e3
"""[mm] Between neighbours; beyond these a header is damaged, not unusual."""
LEAST_SKEW = 1e-3
"""[-] Volume of a voxel over that of the box with its edges: flatter than this it is no volume."""


@dataclass
class Volume:
    """Voxels and where they are in the patient."""

    voxels: np.ndarray
    """(d, h, w): slice, row, column."""
    steps: np.ndarray
    """[mm] (3, 3): column c is the way from a voxel to the next along column, row and slice; x to
    the patient's left, y to the back, z up."""
    origin: np.ndarray
    """[mm] (3,) Of the middle of voxel 0, 0, 0."""
    format: str
    names: dict[int, str] = field(default_factory=dict)
    """Of labels, where the file has them."""
    notes: list[str] = field(default_factory=list)

    @property
    def voxel_size(self) -> float:
        """[mm³]"""
        return float(abs(np.linalg.det(self.steps)))

    @property
    def tilt(self) -> float:
        """[degree] Between the slices' normal and the way from slice to slice: a tilted gantry."""
        return find_tilt(self.steps)


def find_tilt(steps: np.ndarray) -> float:
    """[degree] See Volume.tilt."""
    normal = np.cross(steps[:, 0], steps[:, 1])
    along = abs(normal @ steps[:, 2])
    across = np.linalg.norm(np.cross(normal, steps[:, 2]))
    return float(np.degrees(np.arctan2(across, along)))


def check_size(size: tuple[int, ...]) -> None:
    """Raises Refused for what has not three extents. `size` is columns, rows, slices, ..."""
    shown = " x ".join(map(str, size))
    if len(size) < 3 or min(size[:3]) < 2:
        expected = "a volume: at least 2 columns, rows and slices"
        raise Refused("size", f"a picture of {shown} voxels", expected)
    if any(extent != 1 for extent in size[3:]):
        raise Refused(
            "size",
            f"{len(size)} dimensions, {shown}",
            "3: one volume, not a series of them over time or channel",
        )
    if float(np.prod([float(extent) for extent in size])) > MOST_VOXELS:
        raise Refused("size", f"{shown} voxels", f"at most {MOST_VOXELS} in all")


def check_places(steps: np.ndarray, origin: np.ndarray) -> None:
    """Raises Refused for a header whose voxels are nowhere."""
    lengths = np.linalg.norm(steps, axis=0)
    if not (np.isfinite(steps).all() and np.isfinite(origin).all()):
        raise Refused("header", "a spacing or origin that is no number", "finite ones")
    if lengths.min() < LEAST_SPACING or lengths.max() > MOST_SPACING:
        raise Refused(
            "spacing",
            " x ".join(f"{length:.4g}" for length in lengths) + " mm",
            f"{LEAST_SPACING:g} to {MOST_SPACING:g} mm",
        )
    if abs(np.linalg.det(steps)) < LEAST_SKEW * np.prod(lengths):
        raise Refused("direction", "axes that lie in one plane", "three of their own")


def check_voxels(voxels: np.ndarray) -> None:
    """Raises Refused where a voxel is no finite number."""
    if not np.issubdtype(voxels.dtype, np.floating):
        return
    bad = ~np.isfinite(voxels)
    if bad.any():
        k, j, i = (int(rows[0]) for rows in np.nonzero(bad))
        raise Refused(
            f"voxel {i}, {j}, {k}",
            f"{voxels[k, j, i]}, and {int(bad.sum()) - 1} more that are no numbers",
            "finite numbers everywhere",
        )
