# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong with a method that no step breaks: what it damps, how it chatters, how it gives.

Each is a short run of the tissue itself, with nothing in touch, in steps of one tick.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

import palpate
from palpate.study.step_limit import LIGHT, Knocked, find_scale

TICKS = 6
"""That each of these runs takes."""
SLOW = 10
"""Ticks of a step in which it sags: in short ones every method is right."""
LONG = 100.0
"""[-] Times 2/w: a step that no explicit method could take."""
LONG_STEPS = 3
KNOCK = 1e-5
"""[-] of the diagonal, that a knock of the whole organ moves it in a tick."""
WEIGHT = (0.0, 0.0, -0.1)
"""[m/s²] A hundredth of its weight: it sags, and stays linear."""
FINER = 2.0
"""Times finer than symplectic Euler needs: so Runge-Kutta 4 follows the same knock."""


@dataclass(frozen=True)
class Failure:
    """How a method errs that never blows up."""

    loss: float
    """[-] of the energy that a knock should have left after TICKS ticks: what the method took."""
    chatter: float
    """[-] of the energy of motion, after a knock of every particle: what changes its direction at
    each step."""
    softness: float | None
    """[-] How far it sags in TICKS steps of SLOW ticks, over how far it should; of XPBD
    and projective dynamics alone."""


def holds_long_steps(tissue: palpate.TissueModel, integrator: palpate.Integrator) -> bool:
    """Whether no energy of motion grows in steps a hundred times too long for others.

    Raises ValueError where the integrator is not for such a tissue.
    """
    knocked = Knocked(tissue, integrator)
    dt = LONG * find_scale(tissue)
    if not math.isfinite(dt):
        return True
    stepper = palpate.ImplicitStepper(tissue, integrator)
    state = knocked.knock(knocked.noise, knocked.length / dt)
    start = knocked.measure_motion(state)
    for _ in range(LONG_STEPS):
        if not stepper.step(knocked.load, dt, state):
            return False
        if not knocked.measure_motion(state) <= start:
            return False
    return True


def measure_failure(
    tissue: palpate.TissueModel, integrator: palpate.Integrator, period: float
) -> Failure:
    """Of an implicit integrator in steps of `period` [s], a tick.

    Raises ValueError where the integrator is not for such a tissue.
    """
    knocked = Knocked(tissue, integrator)
    return Failure(
        loss=measure_loss(knocked, period),
        chatter=measure_chatter(knocked, period),
        softness=measure_softness(knocked, period),
    )


def measure_loss(knocked: Knocked, period: float) -> float:
    """[-] See Failure."""
    shape = knocked.shape(np.ones_like(knocked.noise))
    speed = KNOCK / LIGHT * knocked.length / period
    rest = knocked.knock(shape, 0.0)
    left = []
    for stepper in (palpate.ImplicitStepper(knocked.tissue, knocked.integrator), None):
        state = knocked.knock(shape, speed)
        run(knocked, stepper, period, state)
        left.append(measure_energy(knocked, state) - measure_energy(knocked, rest))
    return 1.0 - left[0] / left[1] if left[1] > 0.0 else 0.0


def run(
    knocked: Knocked,
    stepper: palpate.ImplicitStepper | None,
    period: float,
    state: palpate.State,
) -> None:
    """TICKS ticks; by short steps of Runge-Kutta 4 where there is no stepper."""
    if stepper is not None:
        for _ in range(TICKS):
            stepper.step(knocked.load, period, state)
        return
    limit = palpate.stable_step(knocked.tissue)
    steps = max(1, math.ceil(FINER * TICKS * period / limit))
    dt = TICKS * period / steps
    for _ in range(steps):
        palpate.step(knocked.tissue, knocked.load, dt, palpate.Integrator.runge_kutta_4, state)


def measure_energy(knocked: Knocked, state: palpate.State) -> float:
    """[J] Of all that it holds."""
    return float(palpate.compute_energy(knocked.tissue, (0.0, 0.0, 0.0), state).total())


def measure_chatter(knocked: Knocked, period: float) -> float:
    """[-] See Failure."""
    stepper = palpate.ImplicitStepper(knocked.tissue, knocked.integrator)
    state = knocked.knock(knocked.noise, knocked.length / period)
    before, turning, going = np.array(state.velocity), 0.0, 0.0
    for tick in range(TICKS):
        stepper.step(knocked.load, period, state)
        now = np.array(state.velocity)
        if 2 * tick >= TICKS:  # once what is lost at once is lost
            turning += float((knocked.mass * (now - before) ** 2).sum())
            going += float((knocked.mass * (now + before) ** 2).sum())
        before = now
    return turning / (turning + going) if turning + going > 0.0 else 0.0


def measure_softness(knocked: Knocked, period: float) -> float | None:
    """[-] See Failure."""
    own = (palpate.Integrator.xpbd, palpate.Integrator.projective_dynamics)
    if knocked.integrator not in own:
        return None
    sags = []
    for integrator in (knocked.integrator, palpate.Integrator.implicit_euler):
        stepper = palpate.ImplicitStepper(knocked.tissue, integrator)
        state, load = knocked.knock(knocked.noise, 0.0), palpate.Load()
        load.gravity = WEIGHT
        for _ in range(TICKS):
            stepper.step(load, SLOW * period, state)
        sags.append(float(np.linalg.norm(np.asarray(state.position) - knocked.rest)))
    return sags[0] / sags[1] if sags[1] > 0.0 else None
