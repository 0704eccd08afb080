# SPDX-License-Identifier: BSD-3-Clause
"""How far tissue between jaws is stretched, for those who watch a run. Knows no Qt."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.runs.live import Frame

TORN = 2.4
"""[-] of the length at rest, at which the weakest strips of human esophagus, stomach and bowel
tore [Egorov02]; a tissue that tears has a bound of its own (`SoftBody.tear_stretch`)."""
ABOUT = 0.01
"""[m] of an instrument's position within which it is looked for: that of jaws is their tip."""


@dataclass(frozen=True)
class RestSurface:
    """Of one body."""

    triangles: NDArray[np.int64]
    inverse: NDArray[np.float64]
    """[1/m] (t, 2, 2) of both first sides of each triangle, in its own plane."""
    bound: float
    """[-]"""


def measure_rest(body: palpate.SoftBody) -> RestSurface:
    tissue = body.tissue
    x = np.asarray(palpate.compute_surface(tissue, tissue.rest_position))
    triangles = np.asarray(tissue.triangles, dtype=np.int64).reshape(-1, 3)
    one, other = (x[triangles[:, k]] - x[triangles[:, 0]] for k in (1, 2))
    length = np.linalg.norm(one, axis=1)
    along = np.einsum("tk,tk->t", one, other) / length
    across = np.linalg.norm(np.cross(one, other), axis=1) / length
    sides = np.zeros((len(triangles), 2, 2))
    sides[:, 0, 0], sides[:, 0, 1], sides[:, 1, 1] = length, along, across
    return RestSurface(triangles, np.linalg.inv(sides), body.tear_stretch or TORN)


def find_stretches(
    rest: RestSurface, x: NDArray[np.float64], rows: NDArray[np.int64]
) -> NDArray[np.float64]:
    """[-] The larger principal stretch of some triangles with their vertices at x [m] (n, 3): of
    F = dx (dX)^-1 the root of the larger eigenvalue of F^T F."""
    corners = x[rest.triangles[rows]]
    sides = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)
    f = sides @ rest.inverse[rows]
    c = np.einsum("tki,tkj->tij", f, f)
    middle, half = 0.5 * (c[:, 0, 0] + c[:, 1, 1]), 0.5 * (c[:, 0, 0] - c[:, 1, 1])
    return np.asarray(np.sqrt(middle + np.hypot(half, c[:, 0, 1])))


class StretchGauge:
    """Of the bodies of a scene."""

    def __init__(self, scene: palpate.Scene):
        self.scene = scene
        self.rests = [measure_rest(body) for body in scene.bodies]

    def measure(self, frame: Frame, instrument: int) -> tuple[float, float]:
        """[-] The largest stretch about an instrument, and at how much its tissue is harmed; 1 and
        TORN where there is no tissue."""
        at = np.asarray(frame.instruments[instrument].tool_position)
        found = (1.0, TORN)
        for rest, x in zip(self.rests, frame.positions, strict=True):  # of surfaces
            near = np.linalg.norm(x - at, axis=1) < ABOUT
            rows = np.flatnonzero(near[rest.triangles].any(axis=1))
            if len(rows):
                found = max(found, (float(find_stretches(rest, x, rows).max()), rest.bound))
        return found
