# SPDX-License-Identifier: BSD-3-Clause
"""Measured force-indentation curves: CSV whose header states the units.

# pig liver, flat side down, 1 mm/s
depth [mm], force [N]
0.0, 0.000
0.5, 0.021
"""

from __future__ import annotations

import csv
import math
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from palpate.command.verb import UNITS
from palpate.files.read_file import read_file
from palpate.files.refusal import Refusal

COLUMNS = {"depth": "m", "force": "N"}
"""Column -> the unit that it is brought to."""
LEAST = 4
"""Points of a curve that something can be fitted to."""
HEADER = "a header such as 'depth [mm], force [N]'"


@dataclass(frozen=True)
class Curve:
    """What an indenter felt on its way down."""

    depth: NDArray[np.float64]
    """[m] of the indenter's tip below the surface at rest, ascending, from 0 or more."""
    force: NDArray[np.float64]
    """[N] that pushes the indenter back."""


def read_curve(path: Path) -> Curve:
    """Reads and checks a curve. Raises Refusal, naming the line, or OSError."""
    try:
        lines = read_file(path).decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise Refusal(path, "", "bytes that are not text", "a CSV file in UTF-8") from None
    rows = [
        (number, [cell.strip() for cell in cells])
        for number, cells in enumerate(csv.reader(lines), start=1)
        if any(cell.strip() for cell in cells) and not cells[0].lstrip().startswith("#")
    ]
    if not rows:
        raise Refusal(path, "", "no lines", HEADER)
    scales = read_header(path, *rows[0])
    points = np.array([read_row(path, number, cells, scales) for number, cells in rows[1:]])
    check_points(path, points, [number for number, _ in rows[1:]])
    return Curve(points[:, 0], points[:, 1])


def read_header(path: Path, number: int, cells: list[str]) -> list[tuple[int, float]]:
    """Where depth and force stand in a row, and what brings them to SI."""
    where = f"line {number}"
    found = {}
    for column, cell in enumerate(cells):
        match = re.fullmatch(r"(\w+)\s*\[([^\]]*)\]", cell)
        name, unit = match.groups() if match else (cell, "")
        if name not in COLUMNS:
            continue
        if name in found:
            raise Refusal(path, where, f"two columns named {name!r}", HEADER)
        scales = UNITS[COLUMNS[name]]
        if unit not in scales:
            raise Refusal(
                path,
                where,
                f"{name} in {unit!r}" if unit else f"{name} without a unit",
                f"{name} with its unit in brackets, one of {', '.join(scales)}",
            )
        found[name] = (column, scales[unit])
    missing = [name for name in COLUMNS if name not in found]
    if missing:
        raise Refusal(path, where, f"no column {missing[0]!r} in {', '.join(cells)[:60]!r}", HEADER)
    return [found[name] for name in COLUMNS]


def read_row(
    path: Path, number: int, cells: list[str], scales: list[tuple[int, float]]
) -> list[float]:
    values = []
    for column, scale in scales:
        text = cells[column] if column < len(cells) else ""
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise Refusal(path, f"line {number}", repr(text), "a finite number")
        values.append(scale * value)
    return values


def check_points(path: Path, points: NDArray[np.float64], numbers: list[int]) -> None:
    if len(points) < LEAST:
        raise Refusal(path, "", f"{len(points)} points", f"at least {LEAST}")
    depth, force = points.T
    if depth[0] < 0.0:
        raise Refusal(path, f"line {numbers[0]}", f"a depth of {depth[0]:g} m", "0 or more")
    back = np.flatnonzero(np.diff(depth) <= 0.0)
    if len(back):
        raise Refusal(
            path,
            f"line {numbers[back[0] + 1]}",
            f"a depth of {1e3 * depth[back[0] + 1]:g} mm after one of {1e3 * depth[back[0]]:g} mm",
            "depths that grow: the way down alone",
        )
    if force.max() <= 0.0 or force[-1] <= 0.0:
        raise Refusal(
            path,
            "force",
            f"{force[-1]:g} N at the deepest point",
            "a positive force, which pushes the indenter back",
        )
