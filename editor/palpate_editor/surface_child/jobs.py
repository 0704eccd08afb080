# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be done to a surface in a process of its own.

A job takes the surface, its numbers, and a function that keeps what is found so far: where the time
is over, the last that was kept is the answer.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import palpate

from palpate_editor import authoring

Keep = Callable[[palpate.SurfaceMesh, dict[str, Any]], None]
RINGS = (0, 1, 1, 2, 2, 3, 4, 6)
"""Around the crossing triangles, round by round: little is taken out first."""


def remove_crossings(mesh: palpate.SurfaceMesh, numbers: dict[str, Any], keep: Keep) -> None:
    """Round by round, until nothing crosses or no round helps."""
    del numbers
    left = count(mesh)
    for rings in RINGS:
        if left == 0:
            break
        found = authoring.remove_crossings(mesh, rings)
        now = count(found.mesh)
        if now is not None and (left is None or now < left):
            mesh, left = found.mesh, now
            keep(mesh, {"left": left})
    keep(mesh, {"left": left})


def count(mesh: palpate.SurfaceMesh) -> int | None:
    """Triangles that cross others; None where counting would take too long."""
    faces = authoring.find_self_intersecting_faces(mesh)
    return None if faces is None else len(faces)


def wrap(mesh: palpate.SurfaceMesh, numbers: dict[str, Any], keep: Keep) -> None:
    found = authoring.wrap_surface(mesh, numbers["alpha"])
    told = {
        "volume": found.volume,
        "to_source": found.to_source.most,
        "to_source_mean": found.to_source.mean,
        "from_source": found.from_source.most,
        "from_source_mean": found.from_source.mean,
        "dropped": [
            {"triangles": piece.triangles, "size": piece.size, "middle": list(piece.middle)}
            for piece in found.dropped
        ],
    }
    keep(found.mesh, told)


def remesh(mesh: palpate.SurfaceMesh, numbers: dict[str, Any], keep: Keep) -> None:
    """To even triangles, fine around some points, growing as fast with the distance from them."""
    lengths = np.full(len(mesh.vertices), float(numbers["edge_length"]))
    if numbers["fine"]:
        away = find_distances(np.asarray(mesh.vertices), np.asarray(numbers["fine"]))
        fine = float(numbers["fine_length"])
        lengths = np.minimum(lengths, fine + numbers["growth"] * away)
    made = authoring.remesh_surface(mesh, lengths.tolist())
    there = authoring.measure_distance(made, mesh)
    back = authoring.measure_distance(mesh, made)
    told = {
        "mean_distance": there.mean,
        "max_distance": max(there.most, back.most),
        "smallest_angle_deg": float(np.degrees(palpate.compute_smallest_angle(made))),
        "crossing": count(made),
    }
    keep(made, told)


def find_distances(points: np.ndarray, to: np.ndarray) -> np.ndarray:
    """[m] (n,) From each of `points` [m] (n, 3) to the nearest of `to` [m] (k, 3)."""
    nearest = np.full(len(points), np.inf)
    for some in np.array_split(to, max(1, len(to) * len(points) // 4_000_000)):
        squared = ((points[:, None] - some[None]) ** 2).sum(axis=2)
        nearest = np.minimum(nearest, squared.min(axis=1))
    return np.sqrt(nearest)


JOBS: dict[str, Callable[[palpate.SurfaceMesh, dict[str, Any], Keep], None]] = {
    "remove_crossings": remove_crossings,
    "wrap": wrap,
    "remesh": remesh,
}
