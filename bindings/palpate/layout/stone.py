# SPDX-License-Identifier: BSD-3-Clause
"""From the mesh of a stone to a rigid body: mass, inertia, and a hull of spheres that lie in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.layout.gaps import Surface

Floats = NDArray[np.float64]

FEWEST, MOST = 8, 20
"""Spheres of a hull: enough to lie and to be held, few enough for every tick."""
CAPS = (0.8, 0.6, 0.45, 0.3)
"""[-] Of the largest ball in the mesh: how large a sphere may be. The nearest hull is taken."""
SMALLEST = 0.15
"""[-] Likewise, how small: smaller ones are pressed through by a light touch."""
DEPTHS = (0.03, 0.06, 0.1, 0.15, 0.2, 0.27, 0.35, 0.45, 0.6)
"""[-] Of half the diagonal: how deep below a triangle the middle of a ball is looked for."""
MOST_TRIANGLES, MOST_POINTS = 250, 600
"""Below which balls are looked for, and from which the hull's distance is measured."""
SWEEPS, POWER = 2, 6
"""How often each sphere is chosen again, and which power of distances is summed."""


@dataclass(frozen=True)
class MassProperties:
    """Of a closed mesh, filled with one material."""

    volume: float
    """[m³]"""
    centre: Floats
    """[m] (3,) of mass."""
    axes: Floats
    """[-] (3, 3) The principal axes as columns, right-handed."""
    inertia: Floats
    """[m⁵] (3,) about them, for a density of 1 kg/m³: times the density, kg m²."""


@dataclass(frozen=True)
class Hull:
    """Spheres in the frame of the mesh they lie in."""

    centres: Floats
    """[m] (k, 3)"""
    radii: Floats
    """[m] (k,)"""
    deepest: float
    """[m] How far a vertex of the mesh stands out of them at most."""


def measure_mass(mesh: palpate.SurfaceMesh) -> MassProperties:
    """Integrals over the tetrahedra from the origin to each triangle, exact for a closed mesh:

        V = sum d/6,  ∫ x dV = sum d/24 s,  ∫ x xᵀ dV = sum d/120 (s sᵀ + a aᵀ + b bᵀ + c cᵀ)

    with d = a · (b × c) and s = a + b + c. Raises ValueError for a volume that is not above 0.
    """
    x, triangles = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    middle = x.mean(axis=0)
    a, b, c = (x[triangles[:, k]] - middle for k in range(3))
    d, s = np.einsum("ij,ij->i", a, np.cross(b, c)), a + b + c
    volume = float(d.sum() / 6.0)
    if not volume > 0.0:
        raise ValueError(
            f"got a volume of {1e9 * volume:.3g} mm³, expected triangles that run "
            "counter-clockwise seen from outside"
        )
    centre = d @ s / 24.0 / volume
    second = sum(np.einsum("i,ij,ik->jk", d, p, p) for p in (s, a, b, c)) / 120.0
    second -= volume * np.outer(centre, centre)
    moments, axes = np.linalg.eigh(np.trace(second) * np.eye(3) - second)
    if np.linalg.det(axes) < 0.0:
        axes[:, 2] *= -1.0
    return MassProperties(volume, centre + middle, axes, moments)


def fit_hull(mesh: palpate.SurfaceMesh, count: int) -> Hull:
    """`count` spheres that lie in a closed mesh and touch it from inside: one after the other where
    they bring the hull nearer to what stands out of it.

    Raises ValueError for a count out of range, and for a mesh too thin to hold them.
    """
    if not FEWEST <= count <= MOST:
        raise ValueError(f"spheres: got {count}, expected {FEWEST} to {MOST}")
    surface = Surface(np.array(mesh.vertices), np.array(mesh.triangles, dtype=np.int32))
    centres, radii = find_balls(surface)
    widest = radii.max(initial=0.0)
    large = radii >= SMALLEST * widest
    if large.sum() < count:
        raise ValueError("got a mesh with no room for spheres, expected one with an inside")
    outside = surface.used[:: 1 + len(surface.used) // MOST_POINTS]
    hulls = []
    for cap in CAPS:
        fit = large & (radii <= cap * widest)
        if fit.sum() >= count:
            chosen = np.flatnonzero(fit)[choose_spheres(outside, centres[fit], radii[fit], count)]
            gaps = np.linalg.norm(surface.used[:, None] - centres[chosen], axis=2) - radii[chosen]
            deepest = float(gaps.min(axis=1).max())
            hulls.append(Hull(centres[chosen], radii[chosen], deepest))
    return min(hulls, key=lambda hull: hull.deepest)


def find_balls(surface: Surface) -> tuple[Floats, Floats]:
    """Centres [m] (k, 3) and radii [m] (k,) of balls in a surface that touch it: below the middle
    of triangles, at some depths."""
    corners = surface.x[surface.triangles]
    rows = np.unique(np.linspace(0, len(corners) - 1, MOST_TRIANGLES).astype(int))
    middles, inward = corners[rows].mean(axis=1), -surface.normals[rows]
    reach = 0.5 * float(np.linalg.norm(surface.high - surface.low))
    centres, radii = [], []
    for depth in DEPTHS:
        for at in middles + depth * reach * inward:
            gap = surface.find_near(at, 0.0, np.zeros(3))
            if gap is not None and gap.size < 0.0:
                centres.append(at)
                radii.append(-gap.size)
    return np.array(centres).reshape(-1, 3), np.array(radii)


def choose_spheres(x: Floats, centres: Floats, radii: Floats, count: int) -> list[int]:
    """The rows of some balls: one after the other that brings all points nearest to the hull, as
    the sum of high powers of their distances tells; then each once more, with all others there."""
    outside = np.linalg.norm(x[:, None] - centres, axis=2) - radii
    np.maximum(outside, 0.0, out=outside)
    outside /= outside.max()
    chosen: list[int] = []
    for step in range(count * (1 + SWEEPS)):
        if step >= count:
            chosen.pop(0)
        others = outside[:, chosen].min(axis=1, initial=1.0)
        left = np.sum(np.minimum(others[:, None], outside) ** POWER, axis=0)
        left[chosen] = np.inf
        chosen.append(int(np.argmin(left)))
    return chosen
