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
LEAST_FORCE = 1e-4
"""[N] below which nothing is felt that a share could be told of."""


@dataclass(frozen=True)
class FeltPlace:
    """A point that was pressed on both."""

    point: tuple[float, float, float]
    """[m] on the surface of before"""
    before: float | None
    """[N] on the hand; None where an alarm ended the press"""
    after: float | None

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
    """Presses both at the same points, on any thread: some seconds.

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
    moved = [Place(find_place(scenes[1], p.point).point, p.outward) for p in places]
    rows = zip(places, press(scenes[0], places), press(scenes[1], moved), strict=True)
    return FeltChange(DEPTH, tuple(FeltPlace(to_tuple(p.point), one, two) for p, one, two in rows))


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
