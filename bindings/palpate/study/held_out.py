# SPDX-License-Identifier: BSD-3-Clause
"""Presses that score what an advisor chose, at places and depths that no choice was made from.

What they are is a file that was fixed before the advisor was written; where that puts them on an
organ, what the hand does there and how runs are scored stands here. Nothing here runs.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

import palpate
from palpate.files.json_part import is_number, json_kind, read_part
from palpate.files.read_file import read_file
from palpate.files.refusal import Refusal
from palpate.runs.press import Place, find_place_on
from palpate.study.scene_chart import Cost, Errors
from palpate.study.track import CLEARANCE, Course
from palpate.study.truth import Floats

FORMAT, VERSION = "palpate held-out path", 1
MOST_BYTES = 2**16


@dataclass(frozen=True)
class Step:
    """A depth that the hand goes to, and stays at."""

    part_of_depth: float
    """[-] of the deepest that the truth of the place was solved to."""
    hold_s: float


@dataclass(frozen=True)
class HeldOut:
    """What is pressed, of any organ."""

    note: str
    presses: int
    """How many of these are pressed: the first that can be."""
    facing: float
    """[-] Least cosine between the direction and the outward normal of a place."""
    from_held_m: float
    """[m] Least distance of a place from every vertex that is held."""
    from_other_places_radii: float
    """[-] Least distance from the places that the choice was made from, and from each other, in
    radii of the tool."""
    speed_m_per_s: float
    """[m/s] of the hand, mean."""
    steps: tuple[Step, ...]
    directions: tuple[tuple[float, ...], ...] = ()
    """[-] (n, 3) From the middle of the organ; a place is where its ray comes out last."""


def read_held_out(path: Path) -> HeldOut:
    """Checked field by field. Raises Refusal or OSError."""
    try:
        data = json.loads(read_file(path, MOST_BYTES))
    except (ValueError, RecursionError):
        raise Refusal(path, "", "text that is not JSON", "a held-out path") from None
    if not isinstance(data, dict) or (data.get("format"), data.get("version")) != (FORMAT, VERSION):
        raise Refusal(path, "format", "another", f'"{FORMAT}", version {VERSION}')
    content = {name: data[name] for name in data if name not in ("format", "version")}
    directions = read_directions(path, content.pop("directions", None))
    found: HeldOut = read_part(
        path, "held_out", HeldOut, content, without=("directions",), whole=True
    )
    return replace(found, directions=directions)


def read_directions(path: Path, rows: Any) -> tuple[tuple[float, ...], ...]:
    good = isinstance(rows, list) and all(
        isinstance(row, list) and len(row) == 3 and all(map(is_number, row)) and any(row)
        for row in rows
    )
    if not good or not rows:
        raise Refusal(path, "directions", json_kind(rows), "a list of three numbers, not all 0")
    return tuple(tuple(map(float, row)) for row in rows)


def choose_places(
    held_out: HeldOut,
    x: Floats,
    triangles: np.ndarray,
    held: Floats,
    others: Sequence[Floats],
    radius: float,
) -> list[Place]:
    """Where an organ is pressed; fewer than asked for where it has no more such places.

    Args:
        held_out: What is asked for.
        x: [m] (n, 3) vertices of its surface.
        triangles: (t, 3)
        held: [m] (h, 3) vertices that are held.
        others: [m] (3,) places that the choice was made from.
        radius: [m] of the tool.
    """
    found: list[Place] = []
    for direction in held_out.directions:
        place = find_outermost(x, triangles, np.array(direction))
        if place is None or len(found) == held_out.presses:
            continue
        faces = place.outward @ direction >= held_out.facing * np.linalg.norm(direction)
        taken = [*others, *(other.point for other in found)]
        apart = held_out.from_other_places_radii * radius
        if (
            faces
            and find_nearest(place.point, held) >= held_out.from_held_m
            and find_nearest(place.point, taken) >= apart
        ):
            found.append(place)
    return found


def find_nearest(point: Floats, others: Sequence[Floats] | Floats) -> float:
    """[m] to the nearest of them; infinite where there are none."""
    if not len(others):
        return float("inf")
    return float(np.linalg.norm(np.asarray(others) - point, axis=1).min())


def find_outermost(x: Floats, triangles: np.ndarray, direction: Floats) -> Place | None:
    """Where a ray from the middle of a surface leaves it for the last time; None where it misses
    what is open there."""
    middle = x[triangles].mean(axis=(0, 1))
    far = 2.0 * float(np.linalg.norm(np.ptp(x, axis=0)))
    toward = direction / np.linalg.norm(direction)
    tree = palpate.AabbTree(x, triangles)
    hit = palpate.find_ray_hit(tree, x, middle + far * toward, -toward)
    if hit is None or (np.asarray(hit.point) - middle) @ toward <= 0.0:
        return None
    return find_place_on(x, triangles, np.asarray(hit.point))


def write_held_out(course: Course, held_out: HeldOut) -> list[palpate.KeyFrame]:
    """Key frames of a hand that goes to every depth and stays there, at a course's first place."""
    outward, touch = course.truth.direction[0], course.centre[0]
    depth = float(np.abs(course.truth.depth).max())
    frames = [palpate.KeyFrame(0.0, touch + CLEARANCE * outward, 0)]
    now, height = 0.0, CLEARANCE
    for step in held_out.steps:
        wanted = -step.part_of_depth * depth
        for span in (abs(wanted - height) / held_out.speed_m_per_s, step.hold_s):
            now += span
            frames.append(palpate.KeyFrame(now, touch + wanted * outward, 0))
        height = wanted
    return frames


@dataclass(frozen=True)
class PressScore:
    """A configuration at one held-out place."""

    point: tuple[float, ...]
    """[m] (3,)"""
    thickness: float
    """[m]"""
    depth: float
    """[m] The deepest that the truth was solved to there."""
    contact_radius: float
    """[m] of the truth's contact at that depth."""
    force: float
    """[N] The truth's, at that depth."""
    force_error: float
    """[-] of it: the truth's own."""
    displacement_error: float
    """[-] of the depth: the truth's own."""
    errors: Errors | None
    """None where an alarm ended the press."""
    cost: Cost | None
    alarm: str


@dataclass(frozen=True)
class Score:
    """A configuration at all held-out places."""

    presses: tuple[PressScore, ...]

    @property
    def errors(self) -> Errors | None:
        """Of all presses: root mean squares of root mean squares, the largest of the largest; None
        where one did not come to its end, or there is none."""
        found = [press.errors for press in self.presses if press.errors is not None]
        if len(found) < len(self.presses) or not found:
            return None
        seen = [errors.displacement for errors in found if errors.displacement is not None]
        return Errors(
            find_mean([errors.force_rms for errors in found]),
            max(errors.force_most for errors in found),
            find_mean(seen) if len(seen) == len(found) else None,
        )

    @property
    def force_error(self) -> float:
        """[-] The truth's own, the largest."""
        return max((press.force_error for press in self.presses), default=0.0)

    @property
    def displacement_error(self) -> float:
        """[-] The truth's own, the largest."""
        return max((press.displacement_error for press in self.presses), default=0.0)

    @property
    def p99(self) -> float | None:
        """[s] of a tick in touch: the largest; None where a press was not timed."""
        costs = [press.cost for press in self.presses if press.cost is not None]
        if len(costs) < len(self.presses) or not costs:
            return None
        return max(cost.p99 for cost in costs)


def find_mean(values: Sequence[float]) -> float:
    """Root mean square."""
    return float(np.sqrt(np.mean(np.square(values))))
