# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball that has taken hold of what it presses, and is moved away.

As the simulation attaches a tool (core/sim/contact/attach_tool.cpp): springs from the ball to the
points that it touches at the grip, without force there, of a stiffness shared out as the pressure
is. They pull in every direction; the contact goes on, where the surface comes to meet the ball.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from palpate_editor.truth.contact import NEWTON_MAX, Contact, NoContact, Patch, press_ball
from palpate_editor.truth.tetrahedra import Floats


@dataclass(frozen=True)
class Hold:
    """How a tool takes hold."""

    stiffness: float
    """[N/m] of all springs together."""
    grip: float
    """[m] of the ball beyond its first touch, where it takes hold."""


@dataclass(frozen=True)
class Held:
    """A patch of m nodes and q points in the grip of a ball."""

    patch: Patch
    compliance: Floats
    """[m/N] (3m, 3m) of the nodes, axis by axis of each."""
    direction: Floats
    """Unit (3,), outward."""
    hold: Hold
    springs: Floats
    """[N/m] (q,) of the points' springs."""
    start: Floats
    """[m] (m, 3) of the nodes at the grip."""
    penalty: float
    """[N/m³] of the contact."""

    def move(self, force: Floats) -> Floats:
        """[m] (m, 3) under forces (m, 3) on the nodes."""
        return np.asarray(self.compliance @ force.ravel()).reshape(-1, 3)

    def find_overlap(self, u: Floats, depth: float) -> Floats:
        """[m] (q,) with the ball."""
        raised = self.patch.shape @ (u @ self.direction)
        return np.maximum(depth - self.patch.gap + raised, 0.0)

    def find_stretch(self, u: Floats, depth: float) -> Floats:
        """[m] (q, 3) of the springs."""
        away = (self.hold.grip - depth) * self.direction
        return np.asarray(away - self.patch.shape @ (u - self.start))

    def find_energy(self, force: Floats, depth: float) -> float:
        u = self.move(force)
        overlap, stretch = self.find_overlap(u, depth), self.find_stretch(u, depth)
        stored = 0.5 * float((force * u).sum())
        pressed = 0.5 * self.penalty * float((self.patch.area * overlap**2).sum())
        return stored + pressed + 0.5 * float((self.springs * (stretch**2).sum(axis=1)).sum())

    def find_forces(self, u: Floats, depth: float) -> Floats:
        """[N] (q, 3) on the points."""
        push = self.penalty * self.patch.area * self.find_overlap(u, depth)
        stretch = self.find_stretch(u, depth)
        return np.asarray(self.springs[:, None] * stretch - push[:, None] * self.direction)

    def find_slope(self, u: Floats, depth: float) -> Floats:
        """[N/m] (3m, 3m) How forces on the nodes fall as these move outward."""
        on = self.find_overlap(u, depth) > 0.0
        shape = self.patch.shape.toarray()
        n = self.direction
        pressed = shape.T @ ((self.penalty * self.patch.area * on)[:, None] * shape)
        pulled = shape.T @ (self.springs[:, None] * shape)
        return np.kron(pressed, np.outer(n, n)) + np.kron(pulled, np.eye(3))


def pull_ball(
    patch: Patch,
    compliance: Floats,
    direction: Floats,
    hold: Hold,
    depths: Floats,
    penalty: float,
) -> list[Contact]:
    """Force and displacement at descending depths [m] below 0, from the grip on.

    Raises:
        NoContact: where the forces do not settle.
    """
    pressed = press_ball(patch, np.array([hold.grip]), penalty)[0]
    sink = patch.shape @ (patch.compliance @ pressed.push)
    pressure = patch.area * np.maximum(hold.grip - patch.gap - sink, 0.0)
    force = -pressed.push[:, None] * direction
    held = Held(
        patch, compliance, direction, hold, hold.stiffness * pressure / pressure.sum(),
        (compliance @ force.ravel()).reshape(-1, 3), penalty,
    )  # fmt: skip
    found = []
    for depth in np.asarray(depths).tolist():
        force = settle(held, depth, force)
        felt = -held.find_forces(held.move(force), depth).sum(axis=0) @ direction
        found.append(Contact(depth, float(felt), pressed.radius, force, pressed.on))
    return found


def settle(held: Held, depth: float, force: Floats) -> Floats:
    """[N] (m, 3) on the nodes: Newton, as far along every step as lowers the energy."""
    one = np.eye(3 * len(force))
    energy = held.find_energy(force, depth)
    for _ in range(NEWTON_MAX):
        u = held.move(force)
        left = held.patch.shape.T @ held.find_forces(u, depth) - force
        matrix = one + held.find_slope(u, depth) @ held.compliance
        step = np.linalg.solve(matrix, left.ravel()).reshape(-1, 3)
        before, part = energy, 1.0
        while part > 1e-6:
            energy = held.find_energy(force + part * step, depth)
            if energy <= before * (1.0 + 1e-12):
                break
            part *= 0.5
        force = force + part * step
        if np.abs(step).sum() < 1e-7 * np.abs(force).sum():
            return force
    raise NoContact(f"no balance after {NEWTON_MAX} steps at {1e3 * depth:g} mm")
