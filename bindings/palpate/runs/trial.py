# SPDX-License-Identifier: BSD-3-Clause
"""A press of a scene at several places, tick by tick: what is felt, and what carries it.

Counts and forces are the same on every machine; nothing here is measured by a clock.
"""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.runs.press import Place, find_place, find_top, take_surface

DEPTH = 3e-3
"""[m] of the hand's tip below the surface at rest."""
SPEED = 0.06
"""[m/s] of the hand."""
CLEARANCE = 2e-4
"""[m] over the surface, where the hand begins."""
HOLD, MEAN = 0.05, 0.02
"""[s] at the depth, and at the end of that, over which forces are averaged."""
LONG_HOLD, LONG_MEAN = 0.3, 0.25
"""[s] the same for two laws that are compared: an organ that swings as a whole has its middle."""
PLACES = 5
FAR = 1.0
"""[m] over the surface, where a hand touches nothing."""


@dataclass(frozen=True)
class Trial:
    """One press."""

    place: Place
    force: float
    """[N] along the outward direction, at the end of the hold."""
    home_share: float | None
    """[-] of that, through home springs; None where there are none, or nothing was felt."""
    substeps: int
    """Of a tick in touch, the most."""
    alarm: palpate.Alarm | None = None
    """That ended the press."""

    @property
    def stopped(self) -> bool:
        """Whether an alarm ended the press."""
        return self.alarm is not None


def choose_places(scene: palpate.Scene, count: int = PLACES) -> list[Place]:
    """Places of the first body that give way, as far from each other as can be; the top is one.

    Fewer where there are fewer. A body that is held everywhere has its top alone.
    """
    x, _ = take_surface(scene, 0)
    free = x[find_giving(scene.bodies[0].tissue)]
    top = find_top(scene)
    if not len(free):
        return [top]
    places = [find_place(scene, free[np.linalg.norm(free - top.point, axis=1).argmin()])]
    while len(places) < count:
        points = np.array([place.point for place in places])
        apart = np.linalg.norm(free[:, None] - points[None], axis=2).min(axis=1)
        if apart.max() <= 2.0 * scene.instruments[0].tool.radius:
            break
        places.append(find_place(scene, free[apart.argmax()]))
    return places


def find_giving(tissue: palpate.TissueModel) -> NDArray[np.bool_]:
    """(n,) of the surface's vertices: those that particles carry which are not held and which, of a
    linear solid, can be pushed."""
    moves = np.ones(len(tissue.mass), dtype=bool)
    moves[np.asarray(tissue.fixed, dtype=int)] = False
    reach = np.asarray(tissue.elastic.reach, dtype=int)
    if reach.size:
        moves &= np.isin(np.arange(len(moves)), reach)
    corners = np.asarray(tissue.skin.corners)
    if not len(corners):
        return moves
    return (moves[corners] | (np.asarray(tissue.skin.weights) <= 0.0)).all(axis=1)


def press_places(
    scene: palpate.Scene,
    places: list[Place],
    hold: float = HOLD,
    depth: float = DEPTH,
    mean: float = MEAN,
) -> list[Trial]:
    """Presses each place of a scene from rest with its first instrument, as fast as the machine
    can. Without gravity: an organ that sags is another at every place, and comes to rest late.

    Args:
        scene: The result of build_scene.
        places: Of the first body.
        hold: [s] at the depth; where it is 0, forces are those of a tissue that still moves.
        depth: [m] of the hand.
        mean: [s] at the end of the hold, over which forces are averaged.
    """
    weightless = copy(scene)
    weightless.gravity = [0.0, 0.0, 0.0]
    tissue, untouched = scene.bodies[0].tissue, None
    if len(tissue.home) and tissue.pressure != 0.0:  # which moves what nothing touches
        untouched = run_press(weightless, places[0], hold, depth, mean, FAR)[1]
    return [press_place(weightless, place, hold, depth, mean, untouched) for place in places]


def compare_contact(
    scene: palpate.Scene, places: list[Place], modulus: float, depth: float = DEPTH
) -> list[tuple[float, float] | None]:
    """Force [N] on the hand at each place of a solid under the hard law and by its near field;
    None where an alarm ended a press.

    Args:
        scene: The result of build_scene, of either law.
        places: Of the first body.
        modulus: [Pa] E / (1 - nu²) of the near field.
        depth: [m] of the hand.
    """
    hard, near = (
        press_places(with_contact(scene, each), places, LONG_HOLD, depth, LONG_MEAN)
        for each in (0.0, modulus)
    )
    return [
        None if one.stopped or other.stopped else (one.force, other.force)
        for one, other in zip(hard, near, strict=True)
    ]


def with_contact(scene: palpate.Scene, modulus: float) -> palpate.Scene:
    """The same scene with another contact modulus [Pa] of its first body; 0 for the hard law."""
    if scene.bodies[0].contact_modulus == modulus:
        return scene
    changed = copy(scene)
    changed.bodies[0].contact_modulus = modulus
    return palpate.build_scene(changed)


def press_place(
    scene: palpate.Scene,
    place: Place,
    hold: float,
    depth: float,
    mean: float,
    untouched: NDArray[np.float64] | None,
) -> Trial:
    force, home, substeps, alarm = run_press(scene, place, hold, depth, mean, 0.0)
    along = float(force @ place.outward)
    share = None
    if len(scene.bodies[0].tissue.home) and along > 0.0 and alarm is None:
        carried = home if untouched is None else home - untouched
        share = float(carried @ place.outward) / along
    return Trial(place, along, share, substeps, alarm)


def run_press(
    scene: palpate.Scene, place: Place, hold: float, depth: float, mean: float, above: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], int, palpate.Alarm | None]:
    """Force on the hand [N] (3,), that of home springs on the tissue [N] (3,), both as means over
    the end; the most substeps of a tick in touch; the alarm that ended it."""
    world, sample = palpate.World(scene, recovers=False), palpate.HapticSample()
    radius = scene.instruments[0].tool.radius
    jaws = scene.instruments[0].tool.jaws
    sample.grip = jaws.open if jaws else 0.0  # closed: open ones leave what lies between untouched
    down = int(np.ceil((depth + CLEARANCE) / SPEED * scene.rate))
    ticks = down + round(hold * scene.rate)
    averaged = max(1, min(round(mean * scene.rate), ticks - down))
    force, home, substeps = np.zeros(3), np.zeros(3), 0
    for tick in range(1, ticks + 1):
        height = CLEARANCE - (CLEARANCE + depth) * min(1.0, tick / down) + above
        sample.position = place.point + place.outward * (radius + height)
        command = palpate.tick(scene, sample, 1.0 / scene.rate, world)
        if world.alarm.kind != palpate.AlarmKind.none:
            return force, home, substeps, copy(world.alarm)
        if np.any(command.force):
            substeps = max(substeps, world.bodies[0].substeps)
        if tick > ticks - averaged:
            force += np.asarray(command.force) / averaged
            home += pull_home(scene.bodies[0].tissue, world) / averaged
    return force, home, substeps, None


def pull_home(tissue: palpate.TissueModel, world: palpate.World) -> NDArray[np.float64]:
    """[N] (3,) of all home springs together on the tissue: -sum k_i u_i."""
    home = np.asarray(tissue.home)
    if not home.size:
        return np.zeros(3)
    moved = np.asarray(world.bodies[0].tissue.position) - np.asarray(tissue.rest_position)
    moved[np.asarray(tissue.fixed, dtype=int)] = 0.0
    return np.asarray(-home @ moved)
