# SPDX-License-Identifier: GPL-3.0-or-later
"""What SimpleITK does not say of a NIfTI file: whether it is whole, and where its axes really are.

It fills up a file that ends too soon with nought, takes a spacing of nought to be 1 mm, and makes
axes perpendicular that are not.
"""

from __future__ import annotations

import gzip
import io
import struct
import zlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from palpate_editor.scan_child.refused import Refused

BLOCK = 2**22
TO_LPS = np.diag([-1.0, -1.0, 1.0])
"""NIfTI has x to the right and y to the front; we, as DICOM, to the left and the back."""


@dataclass
class NiftiHeader:
    """Of version 1 or 2."""

    spacing: np.ndarray
    """(3,) in the file's unit."""
    matrix: np.ndarray | None
    """(3, 4) of the sform; None where there is none."""
    end: int
    """[bytes] Where the voxels end."""


def open_nifti(path: Path) -> gzip.GzipFile | io.BufferedReader:
    """For reading."""
    return gzip.open(path, "rb") if path.name.lower().endswith(".gz") else path.open("rb")


def read_nifti_header(path: Path) -> NiftiHeader:
    """Raises Refused."""
    try:
        with open_nifti(path) as file:
            data = file.read(540)
    except (OSError, EOFError, zlib.error):
        raise Refused("header", "a damaged gzip archive", "a whole one") from None
    for order in "<>":
        version = {348: 1, 540: 2}.get(struct.unpack_from(f"{order}i", data.ljust(4))[0])
        if version is not None and len(data) >= (348 if version == 1 else 540):
            return parse(data, order, version)
    raise Refused("header", "other bytes", "a NIfTI header of 348 or 540 bytes")


def parse(data: bytes, order: str, version: int) -> NiftiHeader:
    if version == 1:
        dim = struct.unpack_from(f"{order}8h", data, 40)
        bits, pixdim = struct.unpack_from(f"{order}h", data, 72)[0], (f"{order}8f", 76)
        start = int(struct.unpack_from(f"{order}f", data, 108)[0])
        code, rows = struct.unpack_from(f"{order}h", data, 254)[0], (f"{order}12f", 280)
    else:
        dim = struct.unpack_from(f"{order}8q", data, 16)
        bits, pixdim = struct.unpack_from(f"{order}h", data, 14)[0], (f"{order}8d", 104)
        start = struct.unpack_from(f"{order}q", data, 168)[0]
        code, rows = struct.unpack_from(f"{order}i", data, 348)[0], (f"{order}12d", 400)
    extents = [max(extent, 1) for extent in dim[1 : 1 + max(min(dim[0], 7), 1)]]
    voxels = 1
    for extent in extents:
        voxels *= extent
    matrix = np.reshape(struct.unpack_from(rows[0], data, rows[1]), (3, 4)) if code > 0 else None
    spacing = np.array(struct.unpack_from(pixdim[0], data, pixdim[1])[1:4])
    return NiftiHeader(spacing, matrix, max(start, 0) + voxels * bits // 8)


def check_nifti(path: Path, header: NiftiHeader, size: tuple[int, ...]) -> None:
    """Raises Refused for a file that ends too soon, and for one that does not say how large it is.

    Reads all of a compressed file, since nothing else tells its length.
    """
    if header.matrix is None and not (np.abs(header.spacing) > 0.0).all():
        raise Refused("spacing", "none (pixdim of 0)", "the distance between voxels")
    found, whole = count_bytes(path, header.end)
    if found < header.end or not whole:
        shown = " x ".join(map(str, size))
        got = f"{found} bytes" if whole else f"{found} bytes, then damaged ones"
        raise Refused("voxels", got, f"{header.end} for {shown} voxels, as the header says")


def count_bytes(path: Path, most: int) -> tuple[int, bool]:
    """Those that can be read, up to `most` or more, and whether nothing on the way was damaged."""
    if not path.name.lower().endswith(".gz"):
        return path.stat().st_size, True
    found = 0
    try:
        with open_nifti(path) as file:
            while found < most:
                block = file.read1(BLOCK)
                if not block:
                    break
                found += len(block)
    except (OSError, EOFError, zlib.error):
        return found, False
    return found, True


def find_nifti_places(header: NiftiHeader, spacing: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Steps and origin [mm] of the sform; `spacing` [mm] tells in which unit it is."""
    assert header.matrix is not None
    lengths = np.linalg.norm(header.matrix[:, :3], axis=0)
    if not np.isfinite(header.matrix).all() or lengths.min() == 0.0:
        raise Refused("header", "a matrix (srow) without places", "three axes and an origin")
    # millimetres, metres or micrometres
    scale = 10.0 ** (3 * round(float(np.log10(np.median(spacing / lengths))) / 3))
    return TO_LPS @ (scale * header.matrix[:, :3]), TO_LPS @ (scale * header.matrix[:, 3])
