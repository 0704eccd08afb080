# SPDX-License-Identifier: GPL-3.0-or-later
"""A rigid, frictionless ball in a neo-Hookean body: large displacements, the ball's own normals.

Contact is a penalty at the points of the footprint: an energy of half the stiffness times the area
at rest times the overlap squared, which Newton lowers together with the body's.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sparse

from palpate_editor.truth.cholesky import Factor, NotPositiveDefinite
from palpate_editor.truth.elasticity import NEWTON_MAX, Diverged, Press
from palpate_editor.truth.patches import Footprint
from palpate_editor.truth.tetrahedra import Floats

PENALTY = 300.0
"""Of E*/R: at a pressure of E* ball and body overlap by R/PENALTY."""
RESIDUAL = 1e-5
"""Of the force of the contact."""
FIRST = 0.06
"""Of the radius: the first step, and the largest between two equilibria is three times this."""
LEAST = 2e-3
"""Of the radius: a smaller step is given up."""


@dataclass(frozen=True)
class Found:
    """A ball at rest."""

    depth: float
    """[m]"""
    force: float
    """[N] along the press."""
    radius: float
    """[m] from the axis of the press to the farthest point that is touched."""


@dataclass(frozen=True)
class Ball:
    under: Footprint
    radius: float
    direction: Floats
    stiffness: float
    """[N/m³]"""

    def touch(self, u: Floats, centre: Floats):
        """Overlaps [m], unit vectors from the centre, and distances of the points from it."""
        print_ = self.under
        at = print_.position + np.einsum("qa,qad->qd", print_.shape, u[print_.nodes]) - centre
        above = np.maximum(at @ self.direction, 0.0)
        # beside the upper half it is a shaft: a point there is pushed straight out
        at = at - above[:, None] * self.direction
        distance = np.linalg.norm(at, axis=1)
        return self.radius - distance, at / distance[:, None], distance

    def energy(self, u: Floats, centre: Floats) -> float:
        overlap = np.maximum(self.touch(u, centre)[0], 0.0)
        return float(0.5 * self.stiffness * (self.under.area * overlap**2).sum())

    def forces(self, u: Floats, centre: Floats) -> tuple[Floats, float]:
        """The gradient of the energy (nodes, 3) and the force along the press [N]."""
        overlap, normal, _ = self.touch(u, centre)
        push = self.stiffness * self.under.area * np.maximum(overlap, 0.0)
        each = -(push[:, None] * normal)[:, None, :] * self.under.shape[:, :, None]
        gradient = np.zeros_like(u)
        np.add.at(gradient, self.under.nodes, each)
        return gradient, float(-(push @ (normal @ self.direction)))

    def find_width(self, u: Floats, centre: Floats) -> float:
        """[m] How far from the axis of the press the ball is touched."""
        overlap, normal, distance = self.touch(u, centre)
        beside = normal - (normal @ self.direction)[:, None] * self.direction
        return float((distance * np.linalg.norm(beside, axis=1))[overlap > 0.0].max(initial=0.0))

    def tangent(self, u: Floats, centre: Floats, number: Floats, size: int) -> sparse.csc_matrix:
        """The lower half over the free freedoms."""
        overlap, normal, distance = self.touch(u, centre)
        on = overlap > 0.0
        n, shape = normal[on], self.under.shape[on]
        weight = self.stiffness * self.under.area[on]
        one = np.eye(3) - n[:, :, None] * n[:, None, :]
        block = n[:, :, None] * n[:, None, :] - (overlap[on] / distance[on])[:, None, None] * one
        k = np.einsum("q,qa,qb,qij->qaibj", weight, shape, shape, block).reshape(len(n), 18, 18)
        freedoms = number[(3 * self.under.nodes[on][:, :, None] + np.arange(3)).reshape(-1, 18)]
        rows, columns = np.broadcast_arrays(freedoms[:, :, None], freedoms[:, None, :])
        kept = (rows >= columns) & (columns >= 0)
        return sparse.csc_matrix((k[kept], (rows[kept], columns[kept])), shape=(size, size))


def follow(press: Press, under: Footprint, spot, radius, depths, touch, stiffness) -> list[Found]:
    """Equilibria at ascending depths [m], each from the one before. Raises Diverged."""
    ball = Ball(under, radius, spot.direction, PENALTY * stiffness)
    u, there = np.zeros((press.body.node_count, 3)), 0.0
    last = (u, there)
    found = []
    step = FIRST * radius
    for depth in depths.tolist():
        while there < depth - 1e-12:
            reach = min(step, depth - there)
            if depth - there - reach < 0.3 * reach:
                reach = depth - there
            centre = spot.point + (touch - there - reach) * spot.direction
            ahead = reach / (there - last[1]) if there > last[1] else 0.0
            try:
                v = balance(press, ball, u + min(ahead, 1.5) * (u - last[0]), u, centre)
            except Diverged:
                step = 0.5 * reach
                if step < LEAST * radius:
                    raise
                continue
            last, u, there = (u, there), v, there + reach
            step = min(1.5 * step, 3.0 * FIRST * radius)
        centre = spot.point + (touch - depth) * spot.direction
        found.append(Found(depth, ball.forces(u, centre)[1], ball.find_width(u, centre)))
    return found


def balance(press: Press, ball: Ball, guess: Floats, before: Floats, centre: Floats) -> Floats:
    """Equilibrium from a guess, or from the equilibrium before it where that is turned over."""
    body = press.body
    u = guess if np.isfinite(body.energy(guess)) else before
    number = np.full(3 * body.node_count, -1)
    freedoms = (3 * press.free[:, None] + np.arange(3)).ravel()
    number[freedoms] = np.arange(len(freedoms))
    for _ in range(NEWTON_MAX):
        gradient, force = ball.forces(u, centre)
        right = (body.forces(u, "neo_hookean") + gradient)[press.free].ravel()
        if np.abs(right).sum() < RESIDUAL * max(force, 1e-9):
            return u
        matrix = press.stiffness(u, "neo_hookean") + ball.tangent(u, centre, number, press.size)
        try:
            step = -Factor(matrix)(right)
        except NotPositiveDefinite:
            step = -press.factor(right)
        u = search(press, ball, u, step.reshape(-1, 3), float(right @ step), centre)
    raise Diverged(f"no equilibrium after {NEWTON_MAX} steps")


def search(
    press: Press, ball: Ball, u: Floats, step: Floats, slope: float, centre: Floats
) -> Floats:
    """As far along the step as lowers the energy of body and contact."""
    body = press.body
    energy, part = body.energy(u) + ball.energy(u, centre), 1.0
    while part > 1e-4:
        there = u.copy()
        there[press.free] += part * step
        after = body.energy(there) + ball.energy(there, centre)
        # the last steps change less energy than its rounding
        if after <= energy + 1e-4 * part * slope + 1e-10 * energy:
            return there
        part *= 0.5
    raise Diverged("no lower energy along the step")
