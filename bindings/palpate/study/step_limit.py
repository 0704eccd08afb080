# SPDX-License-Identifier: BSD-3-Clause
"""How long a step of a tissue may be: found by running it, and foretold beside that.

A tissue is knocked so lightly that it stays linear, nothing touches it, and STEPS steps are taken.
Where its energy of motion comes to three times as much in the second half of them as in the first,
the step was too long: what swings in a stable way, however far, comes to the same in both.
Everything is counted and nothing is timed, so that any machine finds the same.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

import palpate

LIMIT_SHARE = 0.9
"""[-] of the foretold limit, that palpate.stable_step gives: the rest is its reserve."""
STEPS = 160
"""Of a run: a motion that grows more slowly than threefold in half of them is not seen."""
GROWN = 3.0
"""[-] The largest energy of motion of the second half of a run, over that of the first."""
BLOWN_UP = 1e6
"""[-] Times that of the knock: no need to go on."""
FINE = 1.02
"""[-] Between the longest step that held and the shortest that did not."""
LIGHT = 1e-6
"""[-] of the diagonal, that a knock moves a particle in a step: nearly linear, and far from what
is lost by rounding."""
WIDEST, NARROWEST = 40.0, 1.0 / 4096.0
"""[-] of the first guess, between which a limit is looked for."""
PATIENCE = 300
"""Steps in which a tissue under pressure comes to rest."""
SEED = 17


@dataclass(frozen=True)
class Bracket:
    """Steps [s] between which a tissue begins to fail; None where no step on that side was found
    within WIDEST and NARROWEST."""

    held: float | None
    failed: float | None

    @property
    def limit(self) -> float | None:
        """[s] Their geometric mean."""
        if self.held is None or self.failed is None:
            return None
        return math.sqrt(self.held * self.failed)


def foretell_limit(tissue: palpate.TissueModel, integrator: palpate.Integrator) -> float:
    """[s] At which it should fail; 0 where no step holds, infinite where every one does."""
    limit: float = palpate.stable_step(tissue, integrator) / LIMIT_SHARE
    return limit if limit > 1e-6 * find_scale(tissue) else 0.0


def find_scale(tissue: palpate.TissueModel) -> float:
    """[s] 2/w of its fastest motion, undamped; infinite where nothing can swing."""
    stiffness = palpate.estimate_spectrum(tissue).stiffness
    return 2.0 / math.sqrt(stiffness) if stiffness > 0.0 else math.inf


class Knocked:
    """A tissue at rest, of its own or under its own pressure, to be knocked and run."""

    def __init__(self, tissue: palpate.TissueModel, integrator: palpate.Integrator):
        """Raises ValueError where it does not come to rest."""
        self.tissue, self.integrator = tissue, integrator
        self.load = palpate.Load()
        self.mass = np.asarray(tissue.mass)[:, None]
        self.free = np.ones(len(self.mass), bool)
        self.free[np.asarray(tissue.fixed, int)] = False
        low, high = palpate.compute_bounds(tissue.rest_position)
        self.length = LIGHT * float(np.linalg.norm(high - low))
        self.rest = settle(tissue, self.length)
        noise = np.random.default_rng(SEED).standard_normal(self.rest.shape)
        self.noise = self.shape(noise)
        self.worst = self.noise
        """The knock that grew last, with all others in it."""

    def shape(self, velocity: np.ndarray) -> np.ndarray:
        """A knock of that shape: its root mean square is 1 over the free particles."""
        shaped = np.where(self.free[:, None], velocity, 0.0)
        size = math.sqrt(float((shaped**2).sum()) / max(int(self.free.sum()), 1))
        return shaped / size if size > 0.0 else shaped

    def knock(self, shape: np.ndarray, speed: float) -> palpate.State:
        """At rest, moving as `shape` says, at `speed` [m/s]."""
        state = palpate.State(self.tissue)
        state.position[:] = self.rest
        state.velocity[:] = speed * shape
        return state

    def measure_motion(self, state: palpate.State) -> float:
        """[J] Its energy of motion."""
        with np.errstate(over="ignore", invalid="ignore"):
            return float(0.5 * (self.mass * np.asarray(state.velocity) ** 2).sum())

    def grows(self, dt: float) -> bool:
        """Whether a knock grows in steps of dt [s]."""
        state = self.knock(self.worst, self.length / dt)
        most = start = self.measure_motion(state)
        for step in range(1, STEPS + 1):
            palpate.step(self.tissue, self.load, dt, self.integrator, state)
            energy = self.measure_motion(state)
            if 2 * step <= STEPS:
                most = max(most, energy)
                fails = not energy <= BLOWN_UP * start
            else:
                fails = not energy <= GROWN * most
            if fails:
                self.remember(state)
                return True
        return False

    def remember(self, state: palpate.State) -> None:
        """What has grown is in the next knock, and so is everything else."""
        velocity = np.array(state.velocity)
        if np.isfinite(velocity).all():
            self.worst = self.shape(self.shape(velocity) + self.noise)


def settle(tissue: palpate.TissueModel, length: float) -> np.ndarray:
    """[m] (n, 3) Where its particles rest, to a part of `length` [m]; under its own pressure that
    is not where they are built. Raises ValueError where they do not come to rest."""
    state = palpate.State(tissue)
    if tissue.pressure == 0.0:
        return np.array(state.position)
    stepper = palpate.ImplicitStepper(tissue, palpate.Integrator.implicit_euler)
    dt, load = 20.0 * find_scale(tissue), palpate.Load()
    for _ in range(PATIENCE):
        before = np.array(state.position)
        state.velocity[:] = 0.0
        if not stepper.step(load, dt, state):
            break
        if np.abs(np.asarray(state.position) - before).max() <= 1e-4 * length:
            return np.array(state.position)
    raise ValueError("pressure: the tissue does not come to rest under it")


def measure_limit(
    tissue: palpate.TissueModel, integrator: palpate.Integrator, guess: float
) -> Bracket:
    """Between which steps a tissue begins to fail under an explicit integrator.

    Args:
        tissue: Compiled; it has particles that are free.
        integrator: An explicit one.
        guess: [s] Where to begin looking.

    Raises:
        ValueError: where the tissue does not come to rest.
    """
    knocked = Knocked(tissue, integrator)
    factor, held, failed = 1.1, None, None
    while failed is None and factor <= WIDEST:
        if knocked.grows(factor * guess):
            failed = factor
        else:
            held, factor = factor, 1.25 * factor
    factor = 0.95
    while failed is not None and held is None and factor >= NARROWEST:
        if knocked.grows(factor * guess):
            failed, factor = factor, factor * (0.8 if factor > 0.3 else 0.5)
        else:
            held = factor
    while held is not None and failed is not None and failed > FINE * held:
        middle = math.sqrt(held * failed)
        if knocked.grows(middle * guess):
            failed = middle
        else:
            held = middle
    return Bracket(
        None if held is None else held * guess, None if failed is None else failed * guess
    )
