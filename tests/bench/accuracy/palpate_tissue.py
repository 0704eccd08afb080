# SPDX-License-Identifier: BSD-3-Clause
"""The common work at equal accuracy in Palpate: whole haptic ticks of an organ as it is published.

`palpate_tissue.py FOLDER WORK SIZE [WORD ...]`. SIZE is how many tetrahedra fill the organ, or to
how many vertices a wall is decimated; WORK's modulus gives all constants of the tissue. A word is

    a number          [N/m³] the stiffness of the tool under the hard law of contact
    mesh              with the far field of these tetrahedra, not of finer ones as solids ship
    linear            a linear solid: its response is solved beforehand
    facets            a ball feels how curved the facets under it are
    implicit_damping  symplectic Euler with implicit damping
    damping:NUMBER    [-] of critical, of what swings fastest, if not that of the organ as it ships
    hz:NUMBER         ticks a second, if not 1000
    sleeps:NUMBER     [mN] the force may be wrong by, so that tissue at rest may sleep

A step is a tick with as many substeps as it asks for: tree, candidates, near field, tool, forces,
alarm. The hand holds the tool by a spring so stiff that the ball is where the hand is, to a
hundredth of a millimetre.
"""

from __future__ import annotations

import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
from palpate.runs.press import take_surface
from palpate.scene.scene_parts import FillPart, HandPart
from palpate_editor.compile import compile_organ
from palpate_editor.document import Organ
from palpate_editor.edits import decimate_organ
from palpate_editor.shipped import make_organ
from palpate_editor.truth.contact import find_touch
from work import Engine, Work, press, read_work, report

COUPLING, FORCE_MAX = 1e4, 100.0
"""[N/m], [N]"""
DRAG = 60.0
"""[1/s] So that what swings has come to rest within a hold."""


OF_MESH, LINEAR, FACETS, DAMPED = "mesh", "linear", "facets", "implicit_damping"
RATE, SLEEPS, DAMPING = "hz:", "sleeps:", "damping:"


def make_work_organ(work: Work, size: int, *words: str) -> Organ:
    """The shipped organ of the work with another modulus, ball and number of elements. Raises
    ValueError for a word that it does not know."""
    wall = work.wall_thickness is not None
    organ = make_organ(work.shipped)
    if wall:
        organ = decimate_organ(organ, size)(organ)
    organ = replace(
        organ,
        material=replace(
            organ.material,
            density=work.density,
            young_modulus=work.young_modulus,
            poisson_ratio=work.poisson_ratio,
            wall_thickness=work.wall_thickness,
        ),
        model=replace(organ.model, drag=DRAG),
        fill=organ.fill if wall else FillPart(size),
        tool=replace(organ.tool, radius=work.radius),
        hand=HandPart(coupling=COUPLING, force_max=FORCE_MAX),
    )
    for word in words:
        organ = change(organ, word)
    return organ


def change(organ: Organ, word: str) -> Organ:
    """What a word says."""
    if word == OF_MESH:
        return replace(organ, far_field=None)
    if word == LINEAR:
        return replace(organ, model=replace(organ.model, kind="linear_solid"))
    if word == FACETS:
        return replace(organ, model=replace(organ.model, contact_curvature="facets"))
    if word.startswith(DAMPING):
        ratio = float(word.removeprefix(DAMPING))
        return replace(organ, material=replace(organ.material, damping_ratio=ratio))
    if word == DAMPED:
        integrator = "symplectic_euler_implicit_damping"
        return replace(organ, model=replace(organ.model, integrator=integrator))
    if word.startswith(RATE):
        return replace(organ, hand=replace(organ.hand, rate=float(word.removeprefix(RATE))))
    if word.startswith(SLEEPS):
        error = 1e-3 * float(word.removeprefix(SLEEPS))
        return replace(organ, hand=replace(organ.hand, force_error=error))
    return replace(
        organ,
        model=replace(organ.model, contact_law="hard"),
        tool=replace(organ.tool, stiffness=float(word)),
    )


class Tissue:
    """A running scene as an engine."""

    def __init__(self, scene: palpate.Scene, work: Work):
        self.scene, self.outward = scene, np.array(work.direction)
        self.dt = 1.0 / scene.rate
        self.world, self.sample = palpate.World(scene), palpate.HapticSample()
        self.substeps: list[int] = []

    def step(self, centre: np.ndarray) -> None:
        self.sample.position = centre
        palpate.tick(self.scene, self.sample, self.dt, self.world)

    def force(self) -> float:
        self.substeps.append(self.world.bodies[0].substeps)
        lag = np.asarray(self.world.instruments[0].tool.position) - self.sample.position
        return float(COUPLING * lag @ self.outward)

    def positions(self) -> np.ndarray:
        if self.world.alarm.kind != palpate.AlarmKind.none:
            return np.full((1, 3), np.nan)
        return np.asarray(self.world.bodies[0].tissue.position)


def press_organ(work: Work, size: int, *words: str) -> dict:
    """The row of one size."""
    began = time.perf_counter()
    scene = compile_organ(make_work_organ(work, size, *words))
    built = time.perf_counter() - began
    x, triangles = (np.asarray(part) for part in take_surface(scene, 0))
    touch = find_touch(x, triangles, np.array(work.point), np.array(work.direction), work.radius)
    tissue = Tissue(scene, work)
    rest = np.array(tissue.positions())
    engine = Engine(tissue.step, tissue.force, tissue.positions)
    row = press(engine, work, rest, touch, tissue.dt)
    cells = len(palpate.list_tetrahedra(scene.bodies[0].tissue)) or len(triangles)
    about = {"vertices": len(rest), "cells": cells, "dt_ms": 1e3 * tissue.dt}
    substeps = float(np.median(tissue.substeps or [0]))
    return {**about, "substeps": substeps, "load_s": built, **row}


def main() -> None:
    folder, name, size = Path(sys.argv[1]), sys.argv[2], int(sys.argv[3])
    work = read_work(folder / f"{name}.json")
    row = press_organ(work, size, *sys.argv[4:])
    report(work, row, engine="Palpate", version=palpate.__version__, recipe=str(size))


if __name__ == "__main__":
    main()
