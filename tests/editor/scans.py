# SPDX-License-Identifier: GPL-3.0-or-later
"""Scans of a body that is known exactly: an ellipsoid somewhere in a patient, in every format.

Its voxels are set where their middles, by the volume's own steps and origin, lie inside; so a
reader that loses a sign, an axis, a spacing or a tilt puts the body somewhere else.
"""

from __future__ import annotations

import gzip
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import SimpleITK

MIDDLE = np.array([30.0, -12.0, 55.0])
"""[mm] Left of the middle, in front, above."""
RADII = np.array([24.0, 15.0, 9.0])
"""[mm]"""
VOLUME = 4.0 / 3.0 * np.pi * float(np.prod(RADII))
"""[mm³]"""
BOX = np.array([MIDDLE - RADII, MIDDLE + RADII])
PLAIN = np.diag([1.5, 1.5, 1.5])
UNEVEN = np.diag([1.0, 1.25, 2.5])
MIRRORED = np.diag([-1.0, -1.25, 2.5])
TILT = 18.0
"""[degree]"""
TILTED = np.array([[1.0, 0.0, 0.0], [0.0, 1.25, -2.5 * np.tan(np.radians(TILT))], [0.0, 0.0, 2.5]])
TURNED_AXES = np.array([[0.0, 0.0, 2.0], [1.2, 0.0, 0.0], [0.0, 1.2, 0.0]])
"""Sagittal: columns run to the back, rows upwards, slices to the left."""


def turn(degrees: float) -> np.ndarray:
    """About an axis that is none of the patient's."""
    axis = np.array([1.0, 2.0, 3.0]) / np.sqrt(14.0)
    cross = np.cross(np.eye(3), -axis)
    angle = np.radians(degrees)
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross


OBLIQUE = turn(25.0) @ UNEVEN
PLACES = {
    "plain": PLAIN,
    "uneven": UNEVEN,
    "mirrored": MIRRORED,
    "sagittal": TURNED_AXES,
    "oblique": OBLIQUE,
    "tilted": TILTED,
}


@dataclass
class Made:
    """Voxels (d, h, w) and where they are."""

    voxels: np.ndarray
    steps: np.ndarray
    origin: np.ndarray


def make_scan(steps: np.ndarray, kind: type = np.uint8, inside: float = 3, outside: float = 0):
    """A volume with the body well inside of it."""
    margin = 4.0 * np.abs(steps).sum(axis=1)
    corners = np.array(np.meshgrid(*np.stack([BOX[0] - margin, BOX[1] + margin], 1))).reshape(3, -1)
    index = np.linalg.solve(steps, corners)
    low, high = np.floor(index.min(axis=1)), np.ceil(index.max(axis=1))
    size = (high - low).astype(int) + 1
    origin = steps @ low
    i, j, k = np.meshgrid(*map(np.arange, size), indexing="ij")
    x = np.stack([i, j, k], -1) @ steps.T + origin
    within = (((x - MIDDLE) / RADII) ** 2).sum(axis=-1) <= 1.0
    voxels = np.where(within, inside, outside).astype(kind)
    return Made(np.ascontiguousarray(voxels.transpose(2, 1, 0)), steps, origin)


def make_image(made: Made) -> SimpleITK.Image:
    """As SimpleITK has it: unit axes, which need not be perpendicular, and spacings."""
    image = SimpleITK.GetImageFromArray(made.voxels)
    spacing = np.linalg.norm(made.steps, axis=0)
    image.SetSpacing(spacing.tolist())
    image.SetOrigin(made.origin.tolist())
    image.SetDirection((made.steps / spacing).ravel().tolist())
    return image


def write_scan(path: Path, made: Made) -> Path:
    """NIfTI, NRRD or MetaImage, by the name's ending."""
    if path.name.endswith((".nii", ".nii.gz")):
        write_nifti(path, made)
    else:
        SimpleITK.WriteImage(make_image(made), str(path), True)
    return path


def write_nifti(path: Path, made: Made) -> None:
    """Written plainly, then given its matrix: SimpleITK writes perpendicular axes alone."""
    plain = Made(made.voxels, np.diag(np.linalg.norm(made.steps, axis=0)), np.zeros(3))
    loose = path.with_name(f"loose-{path.name.removesuffix('.gz')}")
    SimpleITK.WriteImage(make_image(plain), str(loose))
    data = bytearray(loose.read_bytes())
    loose.unlink()
    rows = np.column_stack([np.diag([-1.0, -1.0, 1.0]) @ made.steps, [-1, -1, 1] * made.origin])
    data[280:328] = rows.astype("<f4").tobytes()
    data[252:256] = np.array([0, 1], "<i2").tobytes()  # no qform; sform of the scanner
    if path.name.endswith(".gz"):
        path.write_bytes(gzip.compress(bytes(data)))
    else:
        path.write_bytes(bytes(data))


def write_dicom(
    folder: Path, made: Made, series: str = "1.2.826.0.1.3680043.2.1125.1", title: str = "abdomen"
) -> Path:
    """A slice a file, whose names say nothing of their order."""
    folder.mkdir(exist_ok=True)
    spacing = np.linalg.norm(made.steps, axis=0)
    axes = made.steps / spacing
    writer = SimpleITK.ImageFileWriter()
    writer.KeepOriginalImageUIDOn()
    count = len(made.voxels)
    for k, plane in enumerate(made.voxels):
        image = SimpleITK.GetImageFromArray(plane.astype(np.int16))
        image.SetSpacing(spacing[:2].tolist())
        position = made.origin + k * made.steps[:, 2]
        for key, value in {
            "0008|0060": "CT",
            "0008|103e": title,
            "0008|0018": f"{series}.{k + 1}",
            "0020|000d": f"{series}.0",
            "0020|000e": series,
            "0020|0013": str(k + 1),
            "0020|0032": "\\".join(f"{x:.6f}" for x in position),
            "0020|0037": "\\".join(f"{x:.8f}" for x in axes[:, :2].T.ravel()),
        }.items():
            image.SetMetaData(key, value)
        writer.SetFileName(str(folder / f"{title}-{(7 * k) % count:03d}-{k}.dcm"))
        writer.Execute(image)
    return folder
