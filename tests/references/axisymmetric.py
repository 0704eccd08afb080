# SPDX-License-Identifier: BSD-3-Clause
"""A rigid, frictionless ball on the axis of a disc that is bonded to a rigid base.

Axisymmetric elements of nine nodes, linear or neo-Hookean, graded towards the ball. It shares
nothing with solve_contacts.py: tests hold one against the other, and both against Hertz.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.sparse as sparse
from numpy.typing import NDArray
from scipy.sparse.linalg import splu

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

PENALTY = 2e3
"""Of E*/R: at a pressure of E* ball and body overlap by R/PENALTY."""
NEWTON_MAX = 60
RESIDUAL = 1e-7


class Lost(Exception):
    """Newton did not reach equilibrium."""


@dataclass(frozen=True)
class Found:
    depth: float
    """[m]"""
    force: float
    """[N]"""
    radius: float
    """[m] of the contact, as the body is then."""


def grade(length: float, size: float, flat: float, growth: float) -> Floats:
    """Positions from 0 to `length`: steps of `size` up to `flat`, each `growth` of the last."""
    if flat >= length:
        return np.linspace(0.0, length, max(2, round(length / size) + 1))
    x = [0.0]
    while x[-1] < length:
        step = size if x[-1] < flat or len(x) < 2 else growth * (x[-1] - x[-2])
        x.append(x[-1] + step)
    whole = np.array(x)
    far = np.clip((whole - flat) / (whole[-1] - flat), 0.0, 1.0)
    return whole * (1.0 + far * (length / whole[-1] - 1.0))


class Disc:
    """Of a radius and a thickness [m], of Young's modulus [Pa] and Poisson's ratio."""

    def __init__(self, r: Floats, z: Floats, young_modulus: float, poisson_ratio: float):
        self.mu = young_modulus / (2.0 * (1.0 + poisson_ratio))
        self.lam = 2.0 * self.mu * poisson_ratio / (1.0 - 2.0 * poisson_ratio)
        self.plane = young_modulus / (1.0 - poisson_ratio**2)
        r, z = put_middles(r), put_middles(z)
        columns, rows = len(r), len(z)
        self.x = np.stack(np.meshgrid(r, -z, indexing="ij"), axis=2).reshape(-1, 2)
        number = np.arange(columns * rows).reshape(columns, rows)
        self.cells = np.array(
            [
                number[2 * i : 2 * i + 3, 2 * j : 2 * j + 3].ravel()
                for i in range(columns // 2)
                for j in range(rows // 2)
            ]
        )
        fixed = np.concatenate([2 * number[:, -1], 2 * number[:, -1] + 1, 2 * number[0]])
        self.free = np.setdiff1d(np.arange(2 * columns * rows), fixed)
        self.size = 2 * columns * rows
        self.dofs = (2 * self.cells[:, :, None] + np.arange(2)).reshape(len(self.cells), 18)
        self.place_points()
        self.place_surface(number[:, 0])

    def place_points(self) -> None:
        """At Gauss points: (cell, point, 5, 18) from displacements to rr, rz, zr, zz, hoop."""
        points, weights = np.polynomial.legendre.leggauss(3)
        corner = self.x[self.cells]
        slopes, share = [], []
        for p, wp in zip(points, weights, strict=True):
            for q, wq in zip(points, weights, strict=True):
                (a, da), (b, db) = shape(p), shape(q)
                value = np.outer(a, b).ravel()
                local = np.stack([np.outer(da, b).ravel(), np.outer(a, db).ravel()])
                jacobian = np.einsum("dn,enx->edx", local, corner)
                gradient = np.linalg.inv(jacobian) @ local
                radius = corner[:, :, 0] @ value
                part = np.zeros((len(corner), 5, 18))
                part[:, 0, 0::2], part[:, 1, 0::2] = gradient[:, 0], gradient[:, 1]
                part[:, 2, 1::2], part[:, 3, 1::2] = gradient[:, 0], gradient[:, 1]
                part[:, 4, 0::2] = value / radius[:, None]
                slopes.append(part)
                share.append(np.abs(np.linalg.det(jacobian)) * wp * wq * 2.0 * np.pi * radius)
        self.slopes, self.share = np.stack(slopes, axis=1), np.stack(share, axis=1)

    def place_surface(self, top: Ints) -> None:
        """Five points of every element of the upper face: nodes, shape functions, area [m²]."""
        points, weights = np.polynomial.legendre.leggauss(5)
        first = np.arange(0, len(top) - 2, 2)
        trios = np.stack([top[first], top[first + 1], top[first + 2]], axis=1)
        value = np.array([shape(p)[0] for p in points])
        self.top_nodes = np.repeat(trios, 5, axis=0)
        self.top_shape = np.tile(value, (len(trios), 1))
        self.top_r = (self.top_shape * self.x[self.top_nodes, 0]).sum(axis=1)
        half = 0.5 * (self.x[trios[:, 2], 0] - self.x[trios[:, 0], 0])
        self.top_area = (half[:, None] * weights).ravel() * 2.0 * np.pi * self.top_r

    def stretch(self, u: Floats) -> tuple[Floats, Floats]:
        """Components of F^-T as rr, rz, zr, zz, hoop, and ln J, NaN where turned inside out."""
        g = np.einsum("eqcn,en->eqc", self.slopes, u[self.dofs])
        rr, rz, zr, zz, hoop = (
            1.0 + g[..., 0],
            g[..., 1],
            g[..., 2],
            1.0 + g[..., 3],
            1.0 + g[..., 4],
        )
        flat = rr * zz - rz * zr
        good = (flat > 0.0) & (hoop > 0.0)
        with np.errstate(all="ignore"):
            log = np.where(good, np.log(np.where(good, flat * hoop, 1.0)), np.nan)
            turned = np.stack([zz / flat, -zr / flat, -rz / flat, rr / flat, 1.0 / hoop], axis=2)
        self.f = np.stack([rr, rz, zr, zz, hoop], axis=2)
        return turned, log

    def energy(self, u: Floats) -> float:
        _, log = self.stretch(u)
        if np.isnan(log).any():
            return np.inf
        square = (self.f**2).sum(axis=2) - 3.0 - 2.0 * log
        return float((self.share * (0.5 * self.mu * square + 0.5 * self.lam * log**2)).sum())

    def forces(self, u: Floats) -> Floats:
        turned, log = self.stretch(u)
        stress = self.mu * self.f + (self.lam * log - self.mu)[..., None] * turned
        local = np.einsum("eq,eqcn,eqc->en", self.share, self.slopes, stress, optimize=True)
        return np.bincount(self.dofs.ravel(), local.ravel(), self.size)

    def tangent(self, u: Floats) -> sparse.csc_matrix:
        turned, log = self.stretch(u)
        t = turned[..., :4].reshape(*log.shape, 2, 2)
        c = self.lam * turned[..., :, None] * turned[..., None, :]
        c[..., range(5), range(5)] += self.mu
        rest = self.mu - self.lam * log
        for a in range(4):
            for b in range(4):
                i, j, k, m = a // 2, a % 2, b // 2, b % 2
                c[..., a, b] += rest * t[..., i, m] * t[..., k, j]
        c[..., 4, 4] += rest * turned[..., 4] ** 2
        right = np.einsum("eq,eqcd,eqdn->eqcn", self.share, c, self.slopes, optimize=True)
        count = len(self.cells)
        k = self.slopes.reshape(count, 45, 18).transpose(0, 2, 1) @ right.reshape(count, 45, 18)
        rows, columns = np.broadcast_arrays(self.dofs[:, :, None], self.dofs[:, None, :])
        flat = (rows.ravel(), columns.ravel())
        return sparse.csc_matrix((k.ravel(), flat), shape=(self.size, self.size))

    @cached_property
    def stiffness(self) -> sparse.csc_matrix:
        """Of the undeformed disc."""
        return self.tangent(np.zeros(self.size))


def put_middles(x: Floats) -> Floats:
    whole = np.empty(2 * len(x) - 1)
    whole[::2], whole[1::2] = x, 0.5 * (x[1:] + x[:-1])
    return whole


def shape(p: float) -> tuple[Floats, Floats]:
    """The three quadratics of [-1, 1] and their slopes."""
    return (
        np.array([0.5 * p * (p - 1.0), 1.0 - p * p, 0.5 * p * (p + 1.0)]),
        np.array([p - 0.5, -2.0 * p, p + 0.5]),
    )


@dataclass(frozen=True)
class Ball:
    """On a disc, `depth` [m] beyond its first touch; its column alone where `linear`."""

    disc: Disc
    radius: float
    depth: float
    linear: bool

    def touch(self, u: Floats) -> tuple[Floats, Floats, Floats]:
        """Overlap [m], its negative slope (q, 2), and distance from the centre, of the points."""
        disc = self.disc
        moved = (disc.top_shape[..., None] * u.reshape(-1, 2)[disc.top_nodes]).sum(axis=1)
        if self.linear:
            under = disc.top_r < self.radius
            gap = self.radius - np.sqrt(np.where(under, self.radius**2 - disc.top_r**2, 0.0))
            overlap = np.where(under, self.depth - gap + moved[:, 1], -1.0)
            return overlap, np.tile([0.0, -1.0], (len(gap), 1)), np.full(len(gap), np.inf)
        at = moved + np.stack([disc.top_r, np.full(len(moved), self.depth - self.radius)], axis=1)
        at[:, 1] = np.minimum(at[:, 1], 0.0)
        distance = np.linalg.norm(at, axis=1)
        return self.radius - distance, at / distance[:, None], distance

    @property
    def penalty(self) -> float:
        """[N/m³]"""
        return PENALTY * self.disc.plane / self.radius

    def energy(self, u: Floats) -> float:
        overlap = np.maximum(self.touch(u)[0], 0.0)
        return float(0.5 * self.penalty * (self.disc.top_area * overlap**2).sum())

    def forces(self, u: Floats) -> tuple[Floats, float]:
        disc = self.disc
        overlap, normal, _ = self.touch(u)
        push = self.penalty * disc.top_area * np.maximum(overlap, 0.0)
        each = -(push[:, None] * normal)[:, None, :] * disc.top_shape[:, :, None]
        dofs = 2 * disc.top_nodes[:, :, None] + np.arange(2)
        gradient = np.bincount(dofs.ravel(), each.ravel(), disc.size)
        return gradient, float(-(push * normal[:, 1]).sum())

    def tangent(self, u: Floats) -> sparse.csc_matrix:
        disc = self.disc
        overlap, normal, distance = self.touch(u)
        on = overlap > 0.0
        n, values = normal[on], disc.top_shape[on]
        along = n[:, :, None] * n[:, None, :]
        block = along - (overlap[on] / distance[on])[:, None, None] * (np.eye(2) - along)
        weight = self.penalty * disc.top_area[on]
        k = np.einsum("q,qa,qb,qij->qaibj", weight, values, values, block).reshape(-1, 6, 6)
        dofs = (2 * disc.top_nodes[on][:, :, None] + np.arange(2)).reshape(-1, 6)
        rows, columns = np.broadcast_arrays(dofs[:, :, None], dofs[:, None, :])
        flat = (rows.ravel(), columns.ravel())
        return sparse.csc_matrix((k.ravel(), flat), shape=(disc.size, disc.size))


def press(disc: Disc, radius: float, depths: Floats, linear: bool, step: float) -> list[Found]:
    """Equilibria at ascending depths [m], in steps of at most `step` of the radius. Raises Lost."""
    u, before, there = np.zeros(disc.size), np.zeros(disc.size), 0.0
    last, found = 0.0, []
    for depth in np.asarray(depths).tolist():
        count = int(np.ceil((depth - there) / (step * radius) - 1e-9))
        for following in np.linspace(there, depth, count + 1)[1:].tolist():
            ball = Ball(disc, radius, following, linear)
            ahead = min(1.0, (following - there) / (there - last)) if there > last else 0.0
            v = settle(ball, u + ahead * (u - before), u)
            before, u, last, there = u, v, there, following
        ball = Ball(disc, radius, depth, linear)
        on = ball.touch(u)[0] > 0.0
        moved = (disc.top_shape * u[2 * disc.top_nodes]).sum(axis=1)
        wide = (disc.top_r + (0.0 if linear else moved))[on]
        found.append(Found(depth, ball.forces(u)[1], float(wide.max(initial=0.0))))
    return found


def settle(ball: Ball, guess: Floats, before: Floats) -> Floats:
    disc = ball.disc

    def measure(u: Floats) -> float:
        stored = 0.5 * u @ (disc.stiffness @ u) if ball.linear else disc.energy(u)
        return float(stored) + ball.energy(u)

    u = guess if np.isfinite(measure(guess)) else before
    for _ in range(NEWTON_MAX):
        gradient, force = ball.forces(u)
        inner = disc.stiffness @ u if ball.linear else disc.forces(u)
        right = (inner + gradient)[disc.free]
        if np.abs(right).sum() < RESIDUAL * max(force, 1e-9):
            return u
        bulk = disc.stiffness if ball.linear else disc.tangent(u)
        matrix = (bulk + ball.tangent(u))[disc.free][:, disc.free]
        step = np.zeros(disc.size)
        step[disc.free] = -splu(matrix).solve(right)
        energy, part = measure(u), 1.0
        while part > 1e-4 and measure(u + part * step) > energy * (1.0 + 1e-11):
            part *= 0.5
        u = u + part * step
    raise Lost(f"no equilibrium after {NEWTON_MAX} steps, {1e3 * ball.depth:g} mm deep")


def build_disc(
    radius: float, thickness: float, ball: float, young_modulus: float, poisson_ratio: float,
    fine: float = 10.0, flat: float = 1.5,
) -> Disc:  # fmt: skip
    """A disc with elements of `fine` to the ball's radius, `flat` times it far and deep."""
    size = ball / fine
    r = grade(radius, size, min(flat * ball, radius), 1.3)
    z = grade(thickness, size, min(ball, thickness), 1.3)
    return Disc(r, z, young_modulus, poisson_ratio)
