# SPDX-License-Identifier: GPL-3.0-or-later
"""What is felt of an organ on two surfaces: the same presses before and after it was decimated."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import palpate
from palpate.runs.press import Place, find_place
from palpate.runs.trial import (
    DEPTH,
    LONG_HOLD,
    LONG_MEAN,
    PLACES,
    choose_places,
    press_places,
)

from palpate_editor.compile import compile_organ
from palpate_editor.document import Organ, phrase
from palpate_editor.document.cost_rules import estimate_tick
from palpate_editor.document.far_compliance import is_stale
from palpate_editor.trial import LEAST_DEPTHS, LONG_TICK, LONGEST_TICK

MOST_TRIED, FREE = 12, 3.0
"""Places that are chosen from; tip radii that one is away from what is held."""
AROUND, REACH = 3, 0.35
"""Points around a place that make a spot with it, and how far away they are, in edges of the
coarser surface: whether a vertex or the middle of a triangle lies under the tip changes what is
felt at a point, to either side, and no hand comes to the same point twice."""
LEAST_FORCE = 1e-4
"""[N] below which nothing is felt that a share could be told of."""


@dataclass(frozen=True)
class FeltPlace:
    """A spot that was pressed on both: a point and some around it, nearer than an edge."""

    point: tuple[float, float, float]
    """[m] on the surface of before"""
    before: float | None
    """[N] on the hand, the mean over the spot; None where an alarm ended a press"""
    after: float | None
    single: tuple[float, float] | None = None
    """[-] The least and the greatest change of a single point of the spot, of its own force."""

    @property
    def change(self) -> float | None:
        """[-] of the force before."""
        if self.before is None or self.after is None or self.before < LEAST_FORCE:
            return None
        return self.after / self.before - 1.0


@dataclass(frozen=True)
class FeltChange:
    """The same presses of two organs."""

    depth: float
    """[m] of the hand"""
    places: tuple[FeltPlace, ...] = ()
    untold: str = ""
    """Why nothing was pressed; empty where it was."""

    @property
    def mean(self) -> float | None:
        """[-] The change of the force at all places together."""
        told = [place for place in self.places if place.change is not None]
        before = sum(place.before or 0.0 for place in told)
        after = sum(place.after or 0.0 for place in told)
        return after / before - 1.0 if told else None

    @property
    def largest(self) -> float | None:
        """[-] The change that is furthest from none."""
        changes = [place.change for place in self.places if place.change is not None]
        return max(changes, key=abs, default=None)


def measure_felt_change(before: Organ, after: Organ) -> FeltChange:
    """Presses both at the same spots, on any thread: some seconds.

    Each is compiled as it is, so that constants that come from tissue are derived for its own
    surface. An organ that cannot be built, or ticks too slowly to be waited for, is not pressed.
    A far field that one of the two has and the other has not been solved for is left out of both:
    it is for the surface to say what it changes.
    """
    if any(organ.far_field is None or is_stale(organ) for organ in (before, after)):
        before, after = replace(before, far_field=None), replace(after, far_field=None)
    try:
        scenes = [compile_organ(organ) for organ in (before, after)]
    except ValueError as refused:
        text = phrase("it cannot be built yet: {problem}", problem=str(refused))
        return FeltChange(DEPTH, untold=text)
    ticks = [find_tick(o, s) for o, s in zip((before, after), scenes, strict=True)]
    size = palpate.compute_diagonal(scenes[0].bodies[0].tissue.rest_position)
    if max(ticks) > LONGEST_TICK:
        return FeltChange(DEPTH, untold=phrase("it ticks too slowly to be pressed here"))
    if size < LEAST_DEPTHS * DEPTH:
        return FeltChange(DEPTH, untold=phrase("it is too small to be pressed"))
    places = choose_free(scenes[0], (before, after))
    places = places if max(ticks) <= LONG_TICK else places[:1]
    reach = REACH * max(find_edge(organ) for organ in (before, after))
    return FeltChange(DEPTH, tuple(press_spot(scenes, place, reach) for place in places))


def find_edge(organ: Organ) -> float:
    """[m] The mean over its triangles."""
    assert organ.surface is not None
    corners = organ.surface.vertices[organ.surface.triangles]
    return float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean())


def press_spot(scenes: list[palpate.Scene], place: Place, reach: float) -> FeltPlace:
    spot = spread_about(scenes[0], place, reach)
    moved = [Place(find_place(scenes[1], p.point).point, p.outward) for p in spot]
    forces = [press(scene, each) for scene, each in zip(scenes, (spot, moved), strict=True)]
    before, after = (find_mean(each) for each in forces)
    points = [FeltPlace(to_tuple(place.point), one, two) for one, two in zip(*forces, strict=True)]
    single = [point.change for point in points if point.change is not None]
    span = (min(single), max(single)) if single else None
    return FeltPlace(to_tuple(place.point), before, after, span)


def spread_about(scene: palpate.Scene, place: Place, reach: float) -> list[Place]:
    """The place and those around it, `reach` [m] away along the surface's plane there."""
    along = np.cross(place.outward, np.eye(3)[np.abs(place.outward).argmin()])
    along /= np.linalg.norm(along)
    aside = np.cross(place.outward, along)
    turns = 2.0 * np.pi * np.arange(AROUND) / AROUND
    ring = [place.point + reach * (np.cos(a) * along + np.sin(a) * aside) for a in turns]
    return [place, *(find_place(scene, point) for point in ring)]


def find_mean(forces: list[float | None]) -> float | None:
    """[N] None where one is missing."""
    known = [force for force in forces if force is not None]
    return sum(known) / len(known) if len(known) == len(forces) else None


def choose_free(scene: palpate.Scene, organs: tuple[Organ, Organ]) -> list[Place]:
    """Places away from what is held on either surface: at its rim a part of an edge decides what is
    felt. All of them where none is."""
    places = choose_places(scene, MOST_TRIED)
    least = FREE * scene.instruments[0].tool.radius
    kept = [p for p in places if all(find_held(o, p.point) >= least for o in organs)]
    return (kept or places)[:PLACES]


def find_held(organ: Organ, point: np.ndarray) -> float:
    """[m] to the nearest vertex of the surface that is held."""
    assert organ.surface is not None
    held = organ.surface.vertices[organ.fixed]
    return float(np.linalg.norm(held - point, axis=1).min()) if len(held) else np.inf


def find_tick(organ: Organ, scene: palpate.Scene) -> float:
    """[s] of the reference machine."""
    body = scene.bodies[0]
    count = len(palpate.list_tetrahedra(body.tissue))
    return estimate_tick(organ, count, body.substeps) or 0.0


def press(scene: palpate.Scene, places: list[Place]) -> list[float | None]:
    """[N] at each place."""
    found = press_places(scene, places, LONG_HOLD, DEPTH, LONG_MEAN)
    return [None if trial.stopped else trial.force for trial in found]


def to_tuple(point: np.ndarray) -> tuple[float, float, float]:
    x, y, z = map(float, point)
    return x, y, z
