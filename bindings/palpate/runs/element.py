# SPDX-License-Identifier: BSD-3-Clause
"""Which element of a tissue an alarm is of, and where that is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import palpate

AlarmKind = palpate.AlarmKind


@dataclass(frozen=True)
class Element:
    """A part of a tissue."""

    name: str
    """particle, link, tetrahedron or vertex (of the surface)."""
    index: int
    """Of its table, links springs before bonds."""
    place: NDArray[np.float64]
    """[m] (3,) its middle at rest."""


def find_element(
    scene: palpate.Scene,
    alarm: palpate.Alarm,
    body: int,
    hand: NDArray[Any] | None = None,
) -> Element | None:
    """What an alarm of a body is of. An alarm of energy names nothing: of that it is the particle
    that moves with the most of it in the tick before, found by running the scene again through
    `hand`, Record.hand of the run up to the tick of the alarm; None without.
    """
    if not 0 <= body < len(scene.bodies):
        return None
    tissue = scene.bodies[body].tissue
    if alarm.kind is AlarmKind.energy:
        return None if hand is None else find_liveliest(scene, body, hand)
    if alarm.kind in (AlarmKind.not_finite, AlarmKind.moved_far):
        return make_element("particle", alarm.index, [alarm.index], tissue)
    if alarm.kind in (AlarmKind.overstretched, AlarmKind.collapsed):
        return find_row("link", alarm.index, [tissue.springs.ends, tissue.bonds.ends], tissue)
    if alarm.kind is AlarmKind.inverted:
        tables = [tissue.volumes, tissue.corotated, tissue.neo_hookean]
        return find_row(
            "tetrahedron", alarm.index, [t.corners for t in tables if len(t.corners)][:1], tissue
        )
    if alarm.kind is AlarmKind.pressed_deep:
        x = palpate.compute_surface(tissue, tissue.rest_position)
        return Element("vertex", alarm.index, np.array(x[alarm.index]))
    return None


def find_row(
    name: str, index: int, tables: list[Any], tissue: palpate.TissueModel
) -> Element | None:
    """A row of tables that are counted one after the other."""
    row = index
    for table in tables:
        if 0 <= row < len(table):
            return make_element(name, index, np.asarray(table)[row], tissue)
        row -= len(table)
    return None


def make_element(name: str, index: int, particles: Any, tissue: palpate.TissueModel) -> Element:
    x = np.asarray(tissue.rest_position)[np.asarray(particles, int)]
    return Element(name, index, x.mean(axis=0))


def find_liveliest(scene: palpate.Scene, body: int, hand: NDArray[Any]) -> Element | None:
    """The particle of the most kinetic energy before the last tick of a hand."""
    world = palpate.World(scene)
    rows = hand.reshape(len(hand), -1)
    for row in rows[:-1]:
        samples = [read_sample(each) for each in row]
        palpate.tick(scene, samples, 1.0 / scene.rate, world)
    tissue = scene.bodies[body].tissue
    speed = np.linalg.norm(np.asarray(world.bodies[body].tissue.velocity), axis=1)
    energy = np.asarray(tissue.mass) * speed**2
    if not np.isfinite(energy).all() or not energy.any():
        return None
    liveliest = int(energy.argmax())
    return make_element("particle", liveliest, [liveliest], tissue)


def read_sample(row: Any) -> palpate.HapticSample:
    """A row of Record.hand as a tick takes it."""
    sample = palpate.HapticSample()
    for name in ("time", "position", "orientation", "velocity", "grip"):
        setattr(sample, name, row[name])
    sample.buttons = int(row["buttons"])
    return sample


def cut_hand(record: palpate.Record, kind: palpate.EventKind) -> NDArray[Any] | None:
    """Record.hand up to the first event of a kind, its tick included; None where it has none."""
    ticks = np.asarray(record.events["tick"])[np.asarray(record.events["kind"]) == int(kind)]
    return None if not len(ticks) else np.asarray(record.hand)[: int(ticks[0]) + 1]
