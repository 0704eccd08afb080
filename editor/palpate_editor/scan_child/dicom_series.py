# SPDX-License-Identifier: GPL-3.0-or-later
"""A folder of DICOM slices as one volume.

Slices are put in their places by their own positions and orientation, not by what a series reader
makes of them: where the gantry was tilted, the way from slice to slice is not the slices' normal,
and a reader that makes it so shears the patient.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import SimpleITK

from palpate_editor.scan_child.refused import Refused, SeveralSeries
from palpate_editor.scan_child.volume import Volume, check_places, check_size
from palpate_editor.scan_child.volume_file import read_volume_file, shorten

SERIES, TITLE, POSITION, ORIENTATION = "0020|000e", "0008|103e", "0020|0032", "0020|0037"
MOST_FILES = 20_000
TURNED = 1e-3
"""[-] Of two orientations' cosines: more is another one."""
UNEVEN = 0.01
"""[-] Of the distance between slices: more is a gap."""
LEAST_UNEVEN = 0.02
"""[mm] What positions that were rounded in a file are off."""


@dataclass
class Slice:
    """One file of a series."""

    path: Path
    series: str
    title: str
    size: tuple[int, ...]
    """Columns, rows, and frames where there are some."""
    spacing: np.ndarray
    """[mm] (2,) between columns and between rows."""
    position: np.ndarray | None
    """[mm] (3,) of its first voxel."""
    orientation: np.ndarray | None
    """(2, 3) along a row, along a column."""


def read_dicom_folder(folder: Path, series: str | None) -> Volume:
    """The series of a folder, the one named where there are several. Raises Refused."""
    slices = choose_series(list_slices(folder), series)
    if len(slices) == 1 and len(slices[0].size) == 3 and slices[0].size[2] > 1:
        return read_volume_file(slices[0].path)
    check_alike(slices)
    placed = sort_slices(slices)
    steps, origin = find_places(placed)
    columns, rows = placed[0].size[:2]
    check_size((columns, rows, len(placed)))
    check_places(steps, origin)
    return Volume(stack(placed), steps, origin, "DICOM")


def list_slices(folder: Path) -> list[Slice]:
    """Every DICOM picture in the folder itself. Raises Refused where there is none."""
    names = sorted(path for path in folder.iterdir() if path.is_file())
    if len(names) > MOST_FILES:
        raise Refused("", f"a folder of {len(names)} files", f"at most {MOST_FILES}")
    found = [made for made in map(read_slice, names) if made is not None]
    if not found:
        raise Refused("", f"a folder of {len(names)} files, none of them DICOM", "DICOM slices")
    return found


def read_slice(path: Path) -> Slice | None:
    """None for what is no DICOM picture."""
    reader = SimpleITK.ImageFileReader()
    reader.SetFileName(str(path))
    reader.SetImageIO("GDCMImageIO")
    try:
        reader.ReadImageInformation()
    except RuntimeError:
        return None
    meta = {key: reader.GetMetaData(key).strip() for key in reader.GetMetaDataKeys()}
    return Slice(
        path=path,
        series=meta.get(SERIES, ""),
        title=meta.get(TITLE, ""),
        size=tuple(reader.GetSize()),
        spacing=np.array(reader.GetSpacing()[:2]),
        position=read_numbers(meta.get(POSITION, ""), 3),
        orientation=read_orientation(meta.get(ORIENTATION, "")),
    )


def read_numbers(text: str, count: int) -> np.ndarray | None:
    """Of a value with backslashes; None where it has not `count` finite numbers."""
    try:
        numbers = np.array([float(part) for part in text.split("\\")])
    except ValueError:
        return None
    return numbers if len(numbers) == count and np.isfinite(numbers).all() else None


def read_orientation(text: str) -> np.ndarray | None:
    numbers = read_numbers(text, 6)
    return None if numbers is None else numbers.reshape(2, 3)


def choose_series(slices: list[Slice], wanted: str | None) -> list[Slice]:
    by_series: dict[str, list[Slice]] = {}
    for made in slices:
        by_series.setdefault(made.series, []).append(made)
    if wanted is None and len(by_series) == 1:
        return slices
    if wanted in by_series:
        return by_series[wanted]
    shown = "; ".join(
        f"{uid} ({len(group)} slices{', ' + group[0].title if group[0].title else ''})"
        for uid, group in sorted(by_series.items())
    )
    if wanted is None:
        rows = [describe_series(uid, group) for uid, group in sorted(by_series.items())]
        raise SeveralSeries("--series", f"{len(by_series)} series", f"one of {shown}", rows)
    raise Refused("--series", repr(wanted), f"one of {shown}")


def describe_series(uid: str, slices: list[Slice]) -> dict[str, Any]:
    """For JSON."""
    first = slices[0]
    frames = first.size[2] if len(first.size) == 3 and len(slices) == 1 else 1
    return {
        "uid": uid,
        "title": first.title,
        "slices": len(slices) * frames,
        "size": list(first.size[:2]),
    }


def check_alike(slices: list[Slice]) -> None:
    """Raises Refused where slices cannot be the planes of one volume."""
    first = slices[0]
    for made in slices:
        if made.position is None or made.orientation is None:
            raise Refused(
                made.path.name,
                "a slice that does not say where it is",
                "its position and orientation in the patient (0020,0032 and 0020,0037)",
            )
        if made.size[:2] != first.size[:2] or not np.allclose(made.spacing, first.spacing):
            raise Refused(
                made.path.name,
                f"{made.size[0]} x {made.size[1]} pixels",
                f"{first.size[0]} x {first.size[1]} of the same spacing, as in {first.path.name}",
            )
        assert first.orientation is not None
        if np.abs(made.orientation - first.orientation).max() > TURNED:
            raise Refused(made.path.name, "a slice turned against the others", "parallel slices")


def sort_slices(slices: list[Slice]) -> list[Slice]:
    """In the order in which they lie. Raises Refused for gaps, and for slices on each other."""
    orientation = slices[0].orientation
    assert orientation is not None
    normal = np.cross(*orientation)
    heights = np.array([float(normal @ made.position) for made in slices])
    order = np.argsort(heights, kind="stable")
    placed = [slices[k] for k in order]
    if len(placed) < 2:
        raise Refused("", "one slice", "a series of at least 2")
    gaps = np.diff(heights[order])
    usual = float(np.median(gaps))
    allowed = max(UNEVEN * usual, LEAST_UNEVEN)
    for k, gap in enumerate(gaps):
        if gap < LEAST_UNEVEN:
            names = f"{placed[k].path.name} and {placed[k + 1].path.name}"
            raise Refused(names, "two slices at one place", "each place once: another phase?")
        if abs(gap - usual) > allowed:
            raise Refused(
                f"between {placed[k].path.name} and {placed[k + 1].path.name}",
                f"{gap:.3g} mm",
                f"{usual:.3g} mm as between the others: slices are missing or uneven",
            )
    return placed


def find_places(placed: list[Slice]) -> tuple[np.ndarray, np.ndarray]:
    """Steps and origin [mm] of a Volume. Raises Refused where slices do not lie on a line."""
    orientation = placed[0].orientation
    assert orientation is not None
    positions = np.array([made.position for made in placed])
    step = (positions[-1] - positions[0]) / (len(placed) - 1)
    off = np.linalg.norm(
        positions - (positions[0] + np.outer(np.arange(len(placed)), step)), axis=1
    )
    if off.max() > max(UNEVEN * float(np.linalg.norm(step)), LEAST_UNEVEN) * 5.0:
        worst = placed[int(off.argmax())].path.name
        raise Refused(worst, f"a slice {off.max():.3g} mm off the line of the others", "one line")
    columns, rows = placed[0].spacing
    steps = np.column_stack([columns * orientation[0], rows * orientation[1], step])
    return steps, positions[0]


def stack(placed: list[Slice]) -> np.ndarray:
    """(d, h, w) Each slice read by itself, as each may have its own scale of grey levels."""
    planes = []
    for made in placed:
        reader = SimpleITK.ImageFileReader()
        reader.SetFileName(str(made.path))
        reader.SetImageIO("GDCMImageIO")
        try:
            plane = SimpleITK.GetArrayFromImage(reader.Execute())
        except RuntimeError as problem:
            raise Refused(made.path.name, shorten(problem), "a slice that can be read") from None
        plane = plane.reshape(plane.shape[-2:]) if plane.ndim == 3 and len(plane) == 1 else plane
        if plane.shape != made.size[1::-1]:
            raise Refused(made.path.name, f"voxels of shape {plane.shape}", "grey levels")
        planes.append(plane)
    kind = np.result_type(*{plane.dtype for plane in planes})
    return np.stack([plane.astype(kind, copy=False) for plane in planes])
