# SPDX-License-Identifier: BSD-3-Clause
"""A step's band taken from a hand: what it felt once, 20 % less to 20 % more."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.runs.felt import read_column, read_force, read_touched

MARGIN = 0.2
"""[-] to both sides of what was seen."""
SHARE = 0.5
"""[-] of the peak, above which a press counts as what was meant."""
SHORTEST = 50
"""Ticks in touch, for less is no press."""
MOST_ROWS = 100
"""Ticks of which the depth is looked at."""
DIGITS_N, DIGITS_M = 3, 4


def find_bands(
    scene: palpate.Scene, record: palpate.Record, verb: str, instrument: int = 0
) -> dict[str, Any] | None:
    """The values of a step that a hand has done, None where its instrument has pressed nothing.

    Force: the median of what was felt above half of the peak; depth likewise.
    """
    force = np.linalg.norm(read_force(record, instrument), axis=1)
    touched = np.asarray(read_touched(record, instrument), dtype=bool)
    if touched.sum() < SHORTEST or not force.max() > 0.0:
        return None
    meant = touched & (force > SHARE * force.max())
    if verb == "push":
        rows = np.flatnonzero(meant)[:: max(1, int(meant.sum()) // MOST_ROWS)]
        tips = read_column(record, "felt", "position", instrument)[rows]
        seen = float(np.median(find_depths(scene, tips, instrument)))
        if seen > 0.0:
            return {"depth_m": spread(seen, DIGITS_M), "force_N": None}
    return {"force_N": spread(float(np.median(force[meant])), DIGITS_N)}


def find_depths(
    scene: palpate.Scene, tips: NDArray[np.generic], instrument: int = 0
) -> NDArray[np.float64]:
    """[m] (n,) of a tip below the surface of the first body at rest, as a task measures it."""
    tissue, radius = scene.bodies[0].tissue, scene.instruments[instrument].tool.radius
    x = np.asarray(palpate.compute_surface(tissue, tissue.rest_position))
    triangles = np.asarray(tissue.triangles)
    tree = palpate.AabbTree(x, triangles)
    depths = []
    for tip in np.asarray(tips, dtype=float):
        near = palpate.find_closest_point(tree, x, tip)
        a, b, c = x[triangles[near.triangle]]
        inside = np.cross(b - a, c - a) @ (tip - np.asarray(near.point)) < 0.0
        depths.append(radius + near.distance if inside else radius - near.distance)
    return np.array(depths)


def spread(seen: float, digits: int) -> list[float]:
    return [round((1.0 - MARGIN) * seen, digits), round((1.0 + MARGIN) * seen, digits)]
