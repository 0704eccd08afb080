# SPDX-License-Identifier: BSD-3-Clause
"""A hollow organ: a gallbladder with its duct cut open.

A blind sac (the fundus) that narrows through the neck into the cystic duct. The cut duct is the one
border loop, so it stays an open surface.
"""

from __future__ import annotations

import numpy as np
from palpate_meshes.generate.relax import relax
from scipy.interpolate import PchipInterpolator

ROUNDS = 60

# from the bottom of the sac to the cut, in parts of the length: radius in parts of the width
ALONG = np.array([0.00, 0.03, 0.09, 0.20, 0.36, 0.52, 0.66, 0.78, 0.88, 1.00])
RADIUS = np.array([0.00, 0.38, 0.66, 0.92, 1.00, 0.92, 0.68, 0.42, 0.29, 0.26])


def tube(
    vertices: int = 600,
    length: float = 0.090,
    width: float = 0.034,
    bend: float = 0.9,
    border: int | None = None,
    seed: int = 0,
) -> tuple[np.ndarray, np.ndarray]:
    """An open surface of exactly `vertices` vertices with one border loop.

    Of b border vertices, it has 2 vertices - 2 - b triangles.

    Args:
        vertices: At least 60.
        length: [m] Along the axis, from the fundus to the cut.
        width: [m] The largest diameter.
        bend: [rad] By which the axis turns from one end to the other; less than pi.
        border: Vertices of the loop; None for as many as make edges as long as the others.
        seed: Turns the rings it starts from: another mesh of the same organ.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside.
    """
    if vertices < 60:
        raise ValueError(f"tube: vertices must be at least 60, got {vertices}")
    if not (0.0 < width < length < np.inf and 0.0 <= bend < np.pi):
        raise ValueError(
            f"tube: expected 0 < width < length and 0 <= bend < pi, got {width}, {length}, {bend}"
        )
    profile = Profile(length, 0.5 * width)
    counts = count_rings(profile, vertices, border)
    points, triangles = stitch_rings(counts, np.random.default_rng(seed))

    def organ(p: np.ndarray) -> np.ndarray:
        return bend_axis(profile.place(p), length, bend)

    return relax(points, triangles, organ, disc_tangents, lambda p: p, ROUNDS)


class Profile:
    """The sac's outline by arc length, so that equal steps on the disc are equal on the organ."""

    def __init__(self, length: float, radius: float):
        outline = PchipInterpolator(ALONG, RADIUS)
        # dense near the pole, where the outline is steep
        t = np.linspace(0.0, 1.0, 4001) ** 2
        r, z = radius * round_off(outline(t), t), length * t
        arc = np.r_[0.0, np.cumsum(np.hypot(np.diff(r), np.diff(z)))]
        self.total = float(arc[-1])
        self._r = PchipInterpolator(arc / arc[-1], r)
        self._z = PchipInterpolator(arc / arc[-1], z)

    def radius(self, s: np.ndarray) -> np.ndarray:
        """[m] At the part s of the way from the pole to the cut."""
        return self._r(s)

    def place(self, p: np.ndarray) -> np.ndarray:
        """From the unit disc (its rim is the cut) to the straight sac, axis along z."""
        s = np.linalg.norm(p[:, :2], axis=1)
        # radius over s is smooth at the pole, the direction is not
        near = np.maximum(s, 1e-9)
        scale = self._r(np.minimum(near, 1.0)) / near
        return np.stack([p[:, 0] * scale, p[:, 1] * scale, self._z(np.clip(s, 0.0, 1.0))], axis=1)


def round_off(radius: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Near the pole an outline must rise like a circle's, with the root of the way."""
    blunt = 0.66 * np.sqrt(np.maximum(t, 0.0) / 0.09)
    weight = np.clip(t / 0.09, 0.0, 1.0) ** 2 * (3.0 - 2.0 * np.clip(t / 0.09, 0.0, 1.0))
    return (1.0 - weight) * blunt + weight * radius


def bend_axis(p: np.ndarray, length: float, bend: float) -> np.ndarray:
    """Turns the axis along an arc in the plane of x and z, lengths on the axis kept."""
    if bend == 0.0:
        return p
    radius = length / bend
    angle = p[:, 2] / radius
    across = radius - p[:, 0]
    return np.stack([radius - across * np.cos(angle), p[:, 1], across * np.sin(angle)], axis=1)


def count_rings(profile: Profile, vertices: int, border: int | None) -> list[int]:
    """How many vertices stand on each ring from the pole (one vertex) to the cut, exact in sum."""
    s = np.linspace(0.0, 1.0, 2001)
    area = 2.0 * np.pi * np.trapezoid(profile.radius(s), s) * profile.total
    edge = np.sqrt(2.0 * area / (np.sqrt(3.0) * vertices))
    rings = max(4, round(profile.total / (edge * np.sqrt(3.0) / 2.0)))
    around = 2.0 * np.pi * profile.radius(np.linspace(0.0, 1.0, rings + 1)[1:])
    if border is None:
        border = max(6, round(around[-1] / edge))
    if not 3 <= border <= vertices // 4:
        raise ValueError(f"tube: border must be 3 to {vertices // 4}, got {border}")
    wanted = around[:-1] * (vertices - 1 - border) / around[:-1].sum()
    counts = np.maximum(3, np.floor(wanted).astype(int))
    while (rest := vertices - 1 - border - counts.sum()) != 0:
        ring = np.argmax(wanted - counts) if rest > 0 else np.argmax(counts - wanted)
        counts[ring] += np.sign(rest)
    if counts.min() < 3:
        raise ValueError(f"tube: vertices must be more for a tube this long, got {vertices}")
    return [1, *counts.tolist(), border]


def stitch_rings(counts: list[int], random: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Rings of points on the unit disc and the triangles between them."""
    points, rings = [], []
    for ring, count in enumerate(counts):
        start = random.uniform(0.0, 2.0 * np.pi)
        angle = start + 2.0 * np.pi * np.arange(count) / count
        rings.append((len(points), angle))
        s = ring / (len(counts) - 1)
        points += [(s * np.cos(a), s * np.sin(a), 0.0) for a in angle]
    triangles = [t for inner, outer in zip(rings, rings[1:], strict=False)
                 for t in stitch(inner, outer)]  # fmt: skip
    return np.array(points), np.array(triangles)


def stitch(
    inner: tuple[int, np.ndarray], outer: tuple[int, np.ndarray]
) -> list[tuple[int, int, int]]:
    """The triangles between two rings, each given by its first vertex and its angles."""
    (first, at), (last, out) = inner, outer
    n, m = len(at), len(out)
    # start at the outer vertex next to the inner ring's first
    j0 = int(np.argmin(np.abs(np.angle(np.exp(1j * (out - at[0]))))))
    turn_in = 2.0 * np.pi * np.arange(n + 1) / n
    offset = np.angle(np.exp(1j * (out[j0] - at[0])))
    turn_out = offset + 2.0 * np.pi * np.arange(m + 1) / m
    triangles, i, j = [], 0, 0
    steps_in = n if n > 1 else 0
    while i < steps_in or j < m:
        a, b = first + i % n, last + (j0 + j) % m
        if j == m or (i < steps_in and turn_in[i + 1] < turn_out[j + 1]):
            triangles.append((a, b, first + (i + 1) % n))
            i += 1
        else:
            triangles.append((a, b, last + (j0 + j + 1) % m))
            j += 1
    # seen from the pole outwards the disc lies face down: the fundus points to -z
    return [(a, c, b) for a, b, c in triangles]


def disc_tangents(p: np.ndarray) -> np.ndarray:
    return np.broadcast_to(np.eye(3)[:2], (len(p), 2, 3))
