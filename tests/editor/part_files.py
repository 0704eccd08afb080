# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files of balls and boxes, a part for each."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
from palpate_editor.authoring import import_mesh, read_mesh
from palpate_editor.edits.part_list import list_parts
from scipy.spatial import ConvexHull
from small_meshes import CORNERS, CUBE

Parts = dict[str, tuple[np.ndarray, np.ndarray]]


def ball(radius: float, centre: tuple[float, float, float] = (0.0, 0.0, 0.0), vertices: int = 300):
    """[mm] A sphere: the hull of points on a spiral from pole to pole."""
    x, triangles = unit_ball(vertices)
    return radius * x + np.array(centre), triangles


@cache
def unit_ball(vertices: int) -> tuple[np.ndarray, np.ndarray]:
    k = np.arange(vertices) + 0.5
    height, angle = 1.0 - 2.0 * k / vertices, np.pi * (1.0 + np.sqrt(5.0)) * k
    across = np.sqrt(1.0 - height**2)
    x = np.column_stack([across * np.cos(angle), across * np.sin(angle), height])
    triangles = ConvexHull(x).simplices.copy()
    inward = np.linalg.det(x[triangles]) < 0.0
    triangles[inward] = triangles[inward][:, ::-1]
    return x, triangles


def box(low: tuple[float, float, float], size: float = 10.0):
    """[mm] A cube."""
    return 100.0 * size * CORNERS + np.array(low), CUBE


def write_parts(path: Path, parts: Parts) -> Path:
    """An OBJ in millimetres with an object for each."""
    lines, first = [], 1
    for name, (x, triangles) in parts.items():
        lines.append(f"o {name}")
        lines += [f"v {p[0]!r} {p[1]!r} {p[2]!r}" for p in x.tolist()]
        lines += [f"f {a} {b} {c}" for a, b, c in (triangles + first).tolist()]
        first += len(x)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def read_parts(tmp_path: Path, parts: Parts):
    path = write_parts(tmp_path / "parts.obj", parts)
    return path, {part.name: part for part in list_parts(read_mesh(path), "mm", "z")}


def volume_of(path: Path, **options: object) -> float:
    """[ml] of what becomes one solid, which is clean."""
    report = import_mesh(path, unit="mm", up="z", **options).report
    assert (report.closed, report.outward) == (True, True)
    assert (report.non_manifold_edges, report.self_intersecting_faces) == (0, 0)
    return report.volume_ml
