# SPDX-License-Identifier: BSD-3-Clause
"""Whether the instruments of a task can be held: their trocars, handles and numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.assessment.check_problem import ERROR, WARNING, Problem

INSIDE = 0.5
"""[-] Winding number, above which a point lies in what a surface encloses."""


def check_tools(scene: palpate.Scene, assessment: Mapping[str, Any]) -> Iterator[Problem]:
    tools: Mapping[str, Mapping[str, Any]] = assessment["tools"]
    rows = {name: int(said.get("instrument", 0)) for name, said in tools.items()}
    yield from check_numbers(scene, rows)
    for name, said in tools.items():
        trocar = scene.instruments[rows[name]].trocar
        if trocar is None:
            continue
        where = f"tools.{name}"
        if is_in_tissue(scene, np.asarray(trocar)):
            text = f"got {write_point(trocar)}, which lies in an organ, expected a place outside"
            yield Problem(ERROR, f"{where}.{find_said(said)}", text)
        length = float(said.get("fulcrum_m", 0.0))
        least = measure_to_tissue(scene, np.asarray(trocar))
        if 0.0 < length < least:
            text = f"got {length:g}, expected more than {least:.3f}: so far is the organ"
            yield Problem(ERROR, f"{where}.fulcrum_m", text)


def check_numbers(scene: palpate.Scene, rows: Mapping[str, int]) -> Iterator[Problem]:
    """Tools are numbered without a gap: an instrument that is of none has nobody's hand."""
    free = sorted(set(range(len(scene.instruments))) - set(rows.values()))
    for name, row in rows.items():
        below = [other for other in free if other < row]
        if below:
            text = f"got {row}, expected {below[0]}: no tool has that number"
            yield Problem(WARNING, f"tools.{name}.instrument", text)


def is_in_tissue(scene: palpate.Scene, place: NDArray[np.float64]) -> bool:
    for body in scene.bodies:
        tissue = body.tissue
        x = np.asarray(palpate.compute_surface(tissue, tissue.rest_position))
        if palpate.compute_winding_number(np.asarray(tissue.triangles), x, place) > INSIDE:
            return True
    return False


def measure_to_tissue(scene: palpate.Scene, place: NDArray[np.float64]) -> float:
    """[m] From a place to what is nearest of any body's surface at rest."""
    nearest = np.inf
    for body in scene.bodies:
        tissue = body.tissue
        x = np.asarray(palpate.compute_surface(tissue, tissue.rest_position))
        tree = palpate.AabbTree(x, np.asarray(tissue.triangles))
        found = palpate.find_closest_point(tree, x, place)
        if found is not None:
            nearest = min(nearest, found.distance)
    return float(nearest)


def find_said(said: Mapping[str, Any]) -> str:
    """By which of its members a trocar is where it is."""
    return "trocar_m" if "trocar_m" in said else "trocar_height_m"


def write_point(point: Any) -> str:
    return "[" + ", ".join(f"{at:g}" for at in point) + "]"
