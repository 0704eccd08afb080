# SPDX-License-Identifier: BSD-3-Clause
"""A hollow organ like a gallbladder: a bent pear whose duct is cut, with one border loop."""

from __future__ import annotations

import numpy as np

from palpate_meshes.generate.ellipsoid import (
    find_tangents,
    settle_on_sphere,
    spread_on_sphere,
    triangulate_sphere,
)
from palpate_meshes.generate.relax import relax

ROUNDS = 100
LEAST_VERTICES = 100
DUCT_SHARE = 0.965
"""[-] height on the unit sphere, -1 to 1, where the duct is cut."""

BODY_SHARE = 0.75
"""[-] area of the pear over that of a cylinder around it"""


def cut_cap(points: np.ndarray, border: int) -> np.ndarray:
    """Points of the sphere below the cut, and a ring of `border` points on it as the last ones."""
    turn = 2.0 * np.pi * np.arange(border) / border
    ring = np.sqrt(1.0 - DUCT_SHARE**2)
    rim = np.stack([ring * np.cos(turn), ring * np.sin(turn), np.full(border, DUCT_SHARE)], axis=1)
    return np.concatenate([points, rim])


def spread_below_cut(count: int, gap: float, seed: int) -> np.ndarray:
    """`count` evenly spread points whose height stays `gap` below the cut."""
    top = DUCT_SHARE - gap
    unit = spread_on_sphere(count, seed)
    z = -1.0 + (unit[:, 2] + 1.0) * (top + 1.0) / 2.0
    ring = np.sqrt(1.0 - z * z) / np.linalg.norm(unit[:, :2], axis=1)
    return np.stack([unit[:, 0] * ring, unit[:, 1] * ring, z], axis=1)


def tube(
    vertices: int = 600,
    seed: int = 0,
    *,
    length: float = 0.085,
    radius: float = 0.018,
    duct_radius: float = 0.0045,
    bend: float = 0.012,
    border: int | None = None,
) -> tuple[np.ndarray, np.ndarray]:
    """An open organ of genus 0 with exactly `vertices` vertices and one loop of `border` of them.

    Args:
        vertices: At least 100.
        seed: Of the points' small disorder.
        length: [m] from the fundus to the cut.
        radius: [m] of the body.
        duct_radius: [m] at the cut.
        bend: [m] how far the middle lies beside the line between the ends.
        border: Vertices of the cut, at least 3; about as far apart as all others when None.

    Returns:
        Vertices [m] (n, 3) and triangles (2 n - 2 - border, 3).
    """
    if vertices < LEAST_VERTICES:
        raise ValueError(f"vertices: got {vertices}, expected at least {LEAST_VERTICES}")
    if border is None:
        edge = np.sqrt(2.0 * BODY_SHARE * 2.0 * np.pi * radius * length / (np.sqrt(3.0) * vertices))
        border = max(6, round(2.0 * np.pi * duct_radius / edge))
    rim_ring = np.sqrt(1.0 - DUCT_SHARE**2)

    def organ(p: np.ndarray) -> np.ndarray:
        # along: 0 at the fundus, 1 at the cut; the sphere's own ring is swept to the pear's
        along = (p[:, 2] + 1.0) / (DUCT_SHARE + 1.0)
        neck = 1.0 / (1.0 + np.exp(-12.0 * (along - 0.72)))
        wide = radius * (1.0 - neck) + duct_radius / rim_ring * neck
        middle = bend * np.sin(np.pi * along)
        return np.stack([length * along, wide * p[:, 0], wide * p[:, 1] + middle], axis=1)

    # a ring of points just below the rim would crowd it: leave about one edge free
    gap = 0.5 * 2.0 * np.pi * rim_ring / border * rim_ring
    points = cut_cap(spread_below_cut(vertices - border, gap, seed), border)
    hull = triangulate_sphere(points)
    rim = set(range(vertices - border, vertices))
    inside = [not rim.issuperset(t) for t in hull.tolist()]
    return relax(points, hull[inside], organ, find_tangents, settle_on_sphere, ROUNDS)
