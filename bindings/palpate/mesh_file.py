# SPDX-License-Identifier: BSD-3-Clause
"""The one mesh format the simulator itself reads: OBJ in metres, triangles only.

Foreign files come in through `palpate import`, which writes this.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

import palpate
from palpate.verb import Refusal


def read_mesh_file(path: Path) -> palpate.SurfaceMesh:
    """Reads `v x y z` and `f i j k` lines; comments are skipped, anything else is refused.

    Raises Refusal, naming the line, or OSError.
    """
    vertices: list[list[float]] = []
    triangles: list[list[int]] = []
    try:
        lines = path.read_text(encoding="ascii").splitlines()
    except UnicodeDecodeError:
        raise Refusal(
            path, "", "bytes that are not text", "an OBJ written by `palpate import`"
        ) from None
    for number, line in enumerate(lines, start=1):
        word, _, rest = line.partition(" ")
        if not line or word == "#":
            continue
        if word == "v":
            vertices.append(read_numbers(path, number, rest, float))
        elif word == "f":
            triangles.append(read_numbers(path, number, rest, int))
        else:
            raise Refusal(
                path,
                f"line {number}",
                repr(line[:40]),
                "only v and f lines: `palpate import` makes such a file",
            )
    if not triangles:
        raise Refusal(path, "", "no triangles", "a surface")
    corners = np.array(triangles)
    if corners.min() < 1 or corners.max() > len(vertices):
        raise Refusal(
            path,
            "faces",
            f"vertex numbers {corners.min()} to {corners.max()}",
            f"1 to {len(vertices)}",
        )
    mesh = palpate.SurfaceMesh(np.array(vertices), (corners - 1).astype(np.int32))
    try:
        palpate.validate(mesh)
    except ValueError as problem:
        raise Refusal(
            path, "", str(problem), "a clean surface: `palpate import` mends it"
        ) from None
    return mesh


def read_numbers(path: Path, number: int, text: str, kind: type) -> list:
    words = text.split()
    try:
        values = [kind(word) for word in words]
    except ValueError:
        values = []
    if len(values) != 3 or not all(map(math.isfinite, values)):
        raise Refusal(path, f"line {number}", repr(text[:40]), f"three finite {kind.__name__}s")
    return values
