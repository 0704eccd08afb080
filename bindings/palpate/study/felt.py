# SPDX-License-Identifier: BSD-3-Clause
"""What is felt before and after the near field [accuracy: felt]: balls in a block, what carries a
scene, and what touch costs.

Forces and counts are the same on every machine; times are those of a thread, and only their ratio
in one process is kept.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np

import palpate
from palpate.runs.press import Place
from palpate.runs.trial import (
    DEPTH,
    FAR,
    LONG_HOLD,
    LONG_MEAN,
    choose_places,
    press_places,
    with_contact,
)
from palpate.scene.pair_friction import keep_pairs
from palpate.study.half_space import compute_sphere_force
from palpate.study.indent import measure_indentation
from palpate.study.tool import load_with_ball
from palpate.study.tool_block import CELLS, EDGE, open_blocks

HARD, NEAR = "hard", "near field"
"""Laws of contact: before and after."""
BALLS = (3e-3, 5e-3, 8e-3)
"""[m]"""
PRESSED = 2e-3
"""[m] of the ball beyond its first touch, in the block."""
TWICE = 2.0
WARM_UP, BATCHES, TICKS = 100, 15, 20
"""Ticks before any is timed; batches, and ticks of each, of which the median counts."""


@dataclass(frozen=True)
class BlockRow:
    """A ball at one place of the block."""

    kind: str
    law: str
    radius: float
    """[m]"""
    place: str
    felt: float
    """[N]"""
    theory: float
    """[N] of a sphere on an elastic layer."""


@dataclass(frozen=True)
class ShareRow:
    """What carries the force of a scene: means of its places."""

    scene: str
    law: str
    places: int
    felt: float
    """[N]"""
    home_share: float | None
    """[-] of the felt force, through home springs; None where there are none."""
    home_twice: float | None
    """[-] How many times the force is felt once home springs are twice as stiff ..."""
    links_twice: float | None
    """... springs and bonds, volumes and prisms left as they are ..."""
    angles_twice: float | None
    """... or angles and their coupling to stretch. None where there are none."""


@dataclass(frozen=True)
class CostRow:
    """A tick in touch beside one in the air."""

    kind: str
    law: str
    ratio: float
    """[-] of a thread's time, medians."""
    substeps_in_air: int
    substeps_in_touch: int


def press_block(
    balls: Iterable[float] = BALLS, places: int | None = None, kinds: int | None = None
) -> list[BlockRow]:
    """Every ball at the places of the block's reference, under both laws.

    Args:
        balls: [m]
        places: How many of the reference's; None for all.
        kinds: How many kinds of solid; None for all.
    """
    rows = []
    for pressed in open_blocks()[:kinds]:
        reference, kind = pressed.reference, pressed.name.removeprefix("block, ")
        constants = reference.young_modulus, reference.poisson_ratio
        for radius in balls:
            theory = compute_sphere_force(PRESSED, radius, CELLS[2] * EDGE, *constants)
            near = load_with_ball(pressed, radius)
            hard = with_contact(near, 0.0)
            for law, scene in ((HARD, hard), (NEAR, near)):
                for spot in reference.places[:places]:
                    place = Place(np.array(spot.point), np.array(spot.direction))
                    felt = float(measure_indentation(scene, place, np.array([PRESSED]))[0])
                    rows.append(BlockRow(kind, law, radius, spot.name, felt, theory))
    return rows


def measure_shares(name: str, scene: palpate.Scene, count: int | None = None) -> ShareRow:
    """Presses a scene as it is and with one part of its first tissue twice as stiff.

    Args:
        name: Of the scene.
        scene: The result of build_scene.
        count: Of places; None for as many as a check presses.
    """
    places = choose_places(scene, *([] if count is None else [count]))
    found = press_places(scene, places, LONG_HOLD, DEPTH, LONG_MEAN)
    forces = np.array([trial.force for trial in found])
    shares = [trial.home_share for trial in found if trial.home_share is not None]

    def ratio(part: str) -> float | None:
        changed = stiffen(scene, part)
        if changed is None:
            return None
        stiff = press_places(changed, places, LONG_HOLD, DEPTH, LONG_MEAN)
        felt = forces > 0.0  # open jaws may leave a place untouched
        stiffer = np.array([trial.force for trial in stiff])
        return float(np.mean(stiffer[felt] / forces[felt])) if felt.any() else None

    return ShareRow(
        scene=name,
        law=NEAR if scene.bodies[0].contact_modulus else HARD,
        places=len(places),
        felt=float(forces.mean()),
        home_share=float(np.mean(shares)) if shares else None,
        home_twice=ratio("home"),
        links_twice=ratio("links"),
        angles_twice=ratio("angles"),
    )


FIELDS = tuple(
    name for name, value in vars(palpate.TissueModel).items() if isinstance(value, property)
)
"""Of a tissue, whatever laws there are."""


def stiffen(scene: palpate.Scene, part: str, times: float = TWICE) -> palpate.Scene | None:
    """The scene with home springs, links or angles so many times as stiff; None without any, and
    where its triangles cannot take as much."""
    body = scene.bodies[0]
    tissue = body.tissue
    tables = {name: getattr(tissue, name) for name in FIELDS}
    if part == "home":
        stiffened = {"home": times * np.asarray(tissue.home)}
        there = np.asarray(tissue.home).any()
    elif part == "links":
        stiffened = {name: scale_links(tables[name], times) for name in ("springs", "bonds")}
        stiffened["angles"] = scale_angles(tissue.angles, 1.0, times)
        there = len(tissue.springs.ends) + len(tissue.bonds.ends) > 0
    else:
        stiffened = {"angles": scale_angles(tissue.angles, times, 1.0)}
        angles = tissue.angles
        there = np.any(angles.bend_stiffness) or np.any(angles.stretch_coupling)
    if not there:
        return None
    try:
        changed = palpate.TissueModel(**tables | stiffened)
    except ValueError:  # a triangle takes so much of angles, and no more
        return None
    stiff = palpate.SoftBody(tissue=changed, contact_modulus=body.contact_modulus)
    return palpate.build_scene(
        palpate.Scene(
            bodies=[stiff], instruments=keep_pairs(scene.instruments, [0]), rate=scene.rate
        )
    )


def scale_links(links: palpate.Links, times: float) -> palpate.Links:
    """Their damping stays as it is."""
    stiffness = times * np.asarray(links.stiffness)
    return palpate.Links(links.ends, links.rest_length, stiffness, links.damping)


def scale_angles(angles: palpate.Angles, times: float, bonds: float) -> palpate.Angles:
    """`bonds` is the factor of what each triangle gives its bonds."""
    return palpate.Angles(
        angles.corners,
        angles.rest_cosine,
        angles.rest_length,
        times * np.asarray(angles.bend_stiffness),
        times * np.asarray(angles.stretch_coupling),
        bonds * np.asarray(angles.bond_share),
    )


def measure_touch(
    kind: str, scene: palpate.Scene, clock: Callable[[], float] = time.thread_time
) -> CostRow:
    """What a tick that presses a scene's top costs, over one in the air; batches take turns, so
    that what else the machine does meets both."""
    air, touch = (Held(scene, above) for above in (FAR, 0.0))
    spans: list[tuple[float, float]] = []
    for _ in range(BATCHES):
        pair = []
        for held in (air, touch):
            start = clock()
            held.tick(TICKS)
            pair.append(clock() - start)
        spans.append((pair[0], pair[1]))
    return CostRow(
        kind=kind,
        law=NEAR if scene.bodies[0].contact_modulus else HARD,
        ratio=median(b for _, b in spans) / median(a for a, _ in spans),
        substeps_in_air=air.world.bodies[0].substeps,
        substeps_in_touch=touch.world.bodies[0].substeps,
    )


class Held:
    """A hand that stays at the depth of a check's press, or in the air."""

    def __init__(self, scene: palpate.Scene, above: float):
        self.scene, self.world = scene, palpate.World(scene, recovers=False)
        self.sample = palpate.HapticSample()
        [place] = choose_places(scene, 1)
        radius = scene.instruments[0].tool.radius
        for height in np.linspace(1e-3, -DEPTH, WARM_UP) + above:
            self.sample.position = place.point + place.outward * (radius + height)
            self.tick(1)

    def tick(self, count: int) -> None:
        for _ in range(count):
            palpate.tick(self.scene, self.sample, 1.0 / self.scene.rate, self.world)


def summarise(ratios: Sequence[float], digits: int = 2) -> str:
    """The mean (least to most)."""
    mean = sum(ratios) / len(ratios)
    return f"{mean:.{digits}f} ({min(ratios):.{digits}f} to {max(ratios):.{digits}f})"
