# SPDX-License-Identifier: GPL-3.0-or-later
"""From voxels to a closed surface in the patient's own frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage, sparse
from scipy.sparse.csgraph import connected_components
from skimage.measure import marching_cubes

from palpate_editor.scan_child.choice import Choice
from palpate_editor.scan_child.chosen_part import Part, find_cut_sides, find_part
from palpate_editor.scan_child.refused import Refused
from palpate_editor.scan_child.volume import Volume

REACH = 3.0
"""[-] Standard deviations beyond which a Gaussian is taken to be nothing."""
MOST_CHANGE = 0.02
"""[-] Of the volume, by which smoothing may change it."""
GOOD_CHANGE = 0.002
"""[-] At which the search for the level ends."""
MOST_TRIES = 8


@dataclass
class Extracted:
    """A surface, and what was done for it."""

    vertices: np.ndarray
    """[m] (n, 3) x to the patient's left, y to the back, z up."""
    triangles: np.ndarray
    """(t, 3) int32, outward"""
    voxel_volume: float
    """[m³] Of the voxels that were chosen, dropped pieces left out."""
    volume: float
    """[m³] Inside the surface."""
    change: float
    """[-] Of the volume, by smoothing."""
    pieces_dropped: int
    shells_dropped: int
    """Of the surface: cavities, and what smoothing parted."""
    cut_sides: list[str]


def extract_surface(volume: Volume, choice: Choice) -> Extracted:
    """Raises Refused."""
    part = find_part(volume, choice)
    scale = 1e-3 * volume.steps
    voxel_volume = float(abs(np.linalg.det(scale))) * int(part.mask.sum())
    raw = cut(part.field, 0.0)
    if choice.smoothing > 0.0:
        # a mask's own surface has its corners cut off, so its voxels are the measure
        wanted = voxel_volume if choice.labels else measure(raw, scale)
        smoothed, change = smooth(part, choice.smoothing, wanted, scale)
        check_change(change, choice)
    else:
        smoothed, change = raw, 0.0
    points, triangles = smoothed
    points = points + part.corner
    points = points[:, ::-1] @ scale.T + 1e-3 * volume.origin
    if compute_volume(points, triangles) < 0.0:
        # slice, row, column against column, row, slice is a mirror, and so may be the file's axes
        triangles = triangles[:, ::-1]
    points, triangles, dropped = choose_shells(points, triangles, choice)
    return Extracted(
        points,
        triangles.astype(np.int32),
        voxel_volume,
        compute_volume(points, triangles),
        change,
        part.pieces_dropped,
        dropped,
        find_cut_sides(part, volume),
    )


Surface = tuple[np.ndarray, np.ndarray]


def cut(field: np.ndarray, level: float) -> Surface:
    """Where a field is `level`, closed at the edge of its box; vertices in slice, row, column."""
    inside = field - np.float32(level)
    padded = np.pad(inside, 1, constant_values=-float(np.abs(inside).max()))
    # a level that a voxel has exactly makes triangles of no area
    padded[padded == 0.0] = np.float32(1e-6 * max(-padded.min(), 1e-30))
    points, triangles, _, _ = marching_cubes(padded, 0.0)
    return points.astype(np.float64) - 1.0, triangles


def smooth(part: Part, sigma: float, wanted: float, scale: np.ndarray) -> tuple[Surface, float]:
    """The mask's surface through a Gaussian, at the level at which it holds `wanted` [m³].

    At one half it would shrink: convex places lose more than hollow ones gain.
    """
    room = int(np.ceil(REACH * sigma)) + 1
    padded = np.pad(part.mask.astype(np.float32), room)
    field = ndimage.gaussian_filter(padded, sigma, truncate=REACH)
    ascending = np.sort(field[field > 0.0])
    count = int(part.mask.sum())
    # about as many voxels as the mask has lie above the first level
    level = float(ascending[-min(count, len(ascending))])
    most = 0.999 * float(ascending[-1])
    tried: list[tuple[float, float]] = []
    best: tuple[Surface, float] | None = None
    for _ in range(MOST_TRIES):
        level = min(max(level, 1e-3), most)
        found = cut(field, level)
        change = measure(found, scale) / wanted - 1.0
        if best is None or abs(change) < abs(best[1]):
            best = found, change
        if abs(change) < GOOD_CHANGE:
            break
        tried.append((change, level))
        level = find_level(tried)
    assert best is not None
    points, triangles = best[0]
    return (points - room, triangles), best[1]


def find_level(tried: list[tuple[float, float]]) -> float:
    """Where the change of volume is nought, of tries (change, level): on the line between the
    nearest on both sides, which the first try but one has to find."""
    more = min((row for row in tried if row[0] > 0.0), default=None)
    less = max((row for row in tried if row[0] <= 0.0), default=None)
    if more is None or less is None:
        change, level = tried[-1]
        return level + (change + np.copysign(GOOD_CHANGE, change)) * len(tried)
    return more[1] + (less[1] - more[1]) * more[0] / (more[0] - less[0])


def check_change(change: float, choice: Choice) -> None:
    if abs(change) > MOST_CHANGE:
        raise Refused(
            "--smooth",
            f"{choice.smoothing:g} voxels, which change the volume by {100.0 * change:+.1f} %",
            f"at most {100.0 * MOST_CHANGE:g} %: smooth less, or choose the largest piece",
        )


def measure(surface: Surface, scale: np.ndarray) -> float:
    """[m³] Inside a surface in voxels."""
    return abs(compute_volume(surface[0], surface[1])) * float(abs(np.linalg.det(scale)))


def compute_volume(points: np.ndarray, triangles: np.ndarray) -> float:
    """Of a closed surface, positive where its triangles face outwards."""
    return float(volumes_of(points, triangles).sum())


def volumes_of(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """(t,) Of the tetrahedra from the middle to each triangle."""
    a, b, c = (points[triangles[:, corner]] - points.mean(axis=0) for corner in range(3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0


def choose_shells(
    points: np.ndarray, triangles: np.ndarray, choice: Choice
) -> tuple[np.ndarray, np.ndarray, int]:
    """Without shells that are too small; the largest alone where that is asked for.

    Raises Refused where nothing is left.
    """
    count = len(points)
    edges = sparse.coo_matrix(
        (np.ones(2 * len(triangles), bool),
         (triangles[:, [0, 1]].ravel(order="F"), triangles[:, [1, 2]].ravel(order="F"))),
        shape=(count, count),
    )  # fmt: skip
    shells, marks = connected_components(edges, directed=False)
    of_triangle = marks[triangles[:, 0]]
    volumes = np.bincount(of_triangle, volumes_of(points, triangles), minlength=shells)
    kept = np.abs(volumes) >= choice.least_volume
    if choice.largest:
        kept = np.arange(shells) == volumes.argmax()
    if not kept.any():
        raise Refused("--least-volume", "nothing as large as that", "less")
    triangles = triangles[kept[of_triangle]]
    used = np.unique(triangles)
    number = np.full(count, -1)
    number[used] = np.arange(len(used))
    return points[used], number[triangles], int(shells - kept.sum())
