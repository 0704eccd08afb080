# SPDX-License-Identifier: BSD-3-Clause
"""Where a tissue comes to rest when some of its particles are held elsewhere.

Newton's method on the reference kernels: what a simulation of the same model tends to, without the
wait. Nothing here is for the haptic thread.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_matrix, identity
from scipy.sparse.linalg import splu

import palpate

Points = NDArray[np.float64]

RESIDUAL = 1e-7
"""Newton ends when the free forces are this part of those that hold the rest."""
NEWTON_MAX = 60
SOFTEST = 1e-9
"""Of the mean stiffness, added to every particle: a flat patch of springs has none across."""


class Unbalanced(RuntimeError):
    """No equilibrium was found: the model folds or turns inside out on the way."""


@dataclass(frozen=True)
class Press:
    """A patch of particles that is moved as a whole, in a model with others held."""

    model: palpate.TissueModel
    moved: NDArray[np.int32]
    direction: Points
    """(3,), unit, outward: a press goes the other way."""

    def free(self) -> NDArray[np.bool_]:
        """(n,) of the particles that are neither held nor moved."""
        free = np.ones(palpate.particle_count(self.model), dtype=bool)
        free[np.asarray(self.model.fixed)] = False
        free[self.moved] = False
        return free

    def movable(self) -> NDArray[np.int32]:
        """Those of the patch that the model does not hold."""
        return np.setdiff1d(self.moved, self.model.fixed)

    def measure(self, x: Points) -> float:
        """[N] along the press that holds the patch where it is."""
        return float(compute_pull(self.model, x)[self.movable()].sum(axis=0) @ self.direction)


def compute_pull(model: palpate.TissueModel, x: Points) -> Points:
    """[N] (n, 3) of the tissue on its particles at rest at x."""
    f = np.zeros_like(x)
    palpate.compute_forces(model, palpate.Load(), x, np.zeros_like(x), f)
    return f


def stiffness_of(press: Press, x: Points, projection: palpate.Projection) -> csc_matrix:
    """[N/m] of the free particles."""
    dofs = np.flatnonzero(np.repeat(press.free(), 3))
    k = palpate.compute_stiffness(press.model, x, projection)[dofs][:, dofs].tocsc()
    return k + SOFTEST * abs(k.diagonal()).mean() * identity(len(dofs), format="csc")


def respond(press: Press) -> tuple[Points, float]:
    """The linear response to a unit press: displacements per depth [-] and stiffness [N/m]."""
    rest = np.asarray(press.model.rest_position)
    free = np.repeat(press.free(), 3)
    u = np.zeros_like(rest)
    u[press.movable()] = -press.direction
    whole = palpate.compute_stiffness(press.model, rest, palpate.Projection.none).tocsc()
    right = -(whole @ u.ravel())[free]
    flat = u.ravel()
    flat[free] = splu(stiffness_of(press, rest, palpate.Projection.none)).solve(right)
    u = flat.reshape(-1, 3)
    pull = (whole @ u.ravel()).reshape(-1, 3)
    return u, float(-pull[press.movable()].sum(axis=0) @ press.direction)


def follow(press: Press, depths: Sequence[float], reach: float) -> Iterator[tuple[Points, float]]:
    """Positions and force [N] at each depth [m] in turn, each from the one before.

    Args:
        press: Where.
        depths: Of one sign, from the smallest; negative for a pull.
        reach: [m] The largest step from one equilibrium to the next.

    Raises:
        Unbalanced: naming the depth beyond which there is no equilibrium.
    """
    unit = respond(press)[0]
    x, there = np.asarray(press.model.rest_position).copy(), 0.0
    for depth in depths:
        for stop in np.linspace(there, depth, int(np.ceil(abs(depth - there) / reach)) + 1)[1:]:
            x, there = go(press, x, unit, there, float(stop)), float(stop)
        yield x, press.measure(x)


def go(press: Press, x: Points, unit: Points, before: float, after: float) -> Points:
    """The equilibrium at depth `after` from that at `before`, in halves where it is too far."""
    if abs(after - before) < 1e-6:
        raise Unbalanced(f"no equilibrium beyond a depth of {1e3 * before:.2f} mm")
    try:
        return balance(press, x + (after - before) * unit)
    except Unbalanced:
        middle = 0.5 * (before + after)
        return go(press, go(press, x, unit, before, middle), unit, middle, after)


def balance(press: Press, x: Points) -> Points:
    """Moves the free particles to equilibrium. Raises Unbalanced."""
    free = press.free()
    x, f = x.copy(), compute_pull(press.model, x)
    for _ in range(NEWTON_MAX):
        right = f[free]
        if not np.isfinite(f).all():
            break
        if np.linalg.norm(right) <= RESIDUAL * np.linalg.norm(f) + 1e-13:
            return x
        x, f = search(press, x, find_way(press, x, right.ravel()), right)
    raise Unbalanced("no equilibrium near")


def find_way(press: Press, x: Points, right: Points) -> Points:
    """Newton's step, by the projected tangent where the exact one leads uphill."""
    for projection in (palpate.Projection.none, palpate.Projection.positive_semidefinite):
        try:
            step = splu(stiffness_of(press, x, projection)).solve(right)
        except RuntimeError:  # exactly singular
            continue
        if np.isfinite(step).all() and right @ step > 0.0:
            return step.reshape(-1, 3)
    raise Unbalanced("no direction lowers the energy")


def search(press: Press, x: Points, step: Points, right: Points) -> tuple[Points, Points]:
    """Goes as far along `step` as lowers the energy."""
    free = press.free()
    state = palpate.State(press.model)
    energy = measure_energy(press.model, state, x)
    slope = float((right * step).sum())
    part = 1.0
    while part > 1e-5:
        there = x.copy()
        there[free] += part * step
        after = measure_energy(press.model, state, there)
        # the last steps change less energy than its rounding
        if after <= energy - 1e-4 * part * slope + 1e-13 * abs(energy):
            return there, compute_pull(press.model, there)
        part *= 0.5
    raise Unbalanced("no lower energy along the step")


def measure_energy(model: palpate.TissueModel, state: palpate.State, x: Points) -> float:
    state.position[:] = x
    energy = palpate.compute_energy(model, np.zeros(3), state).elastic()
    return energy if np.isfinite(energy) else np.inf
