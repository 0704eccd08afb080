# SPDX-License-Identifier: BSD-3-Clause
"""The constants of a tissue with a stiff spot in it: a ball that is so many times as stiff.

Laws in the bulk, springs, bonds and tetrahedra, are scaled by the part of them that lies inside the
ball. A near field takes the tissue under a tool to be alike everywhere, so what it lacks goes into
the far field: the compliance under a disc of 8 mm, which the far field is defined by, falls by

    dC = -sum over the ball of (a_k K tr(e)² + 2 a_m mu e':e') dV / F²

with e the strains that the load F on the disc would make without the ball [Johnson85, 3.19], and
a = (t - 1) / (1 + b (t - 1)) of a sphere t times as stiff in an infinite body [Eshelby57], with
b_k = (1 + nu) / (3 (1 - nu)) for the bulk and b_m = 2 (4 - 5 nu) / (15 (1 - nu)) for shear. An
estimate: the surface above the ball and what varies within it are left out.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate import scenario

PATCH = 0.008
"""[m] Radius of the disc that a far field is of."""
EDGE = 0.25
"""[-] of the ball's radius, over which its stiffness fades."""
POISSON = 0.45
"""Where the designer's document says none."""
REACH = 0.03
"""[m] beyond the ball's radius; farther away it is not felt."""
SPRING_POINTS, GRID, RINGS, DIVISIONS = 17, 9, 3, 4

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Inclusion:
    """A ball of the tissue at rest."""

    centre: Floats
    """[m]"""
    radius: float
    """[m]"""
    stiffness: float
    """[-] how many times as stiff it is"""

    def find_factor(self, points: Floats) -> Floats:
        """(n,) of stiffness, on the mean of points (n, k, 3) [m]."""
        distance = np.linalg.norm(points - self.centre, axis=-1)
        inside = (self.radius * (1.0 + 0.5 * EDGE) - distance) / (self.radius * EDGE)
        mean = np.clip(inside, 0.0, 1.0).mean(axis=1)
        return np.asarray(1.0 + (self.stiffness - 1.0) * mean)


def gather_constants(
    assessment: Mapping[str, Any], published: scenario.Scenario
) -> dict[str, Floats]:
    """By name of the array: the constants of every place that has an inclusion. What is wrong with
    one is left for the reader to say.
    """
    places, organs = assessment.get("places"), assessment.get("organs")
    gathered: dict[str, Floats] = {}
    for name, place in places.items() if isinstance(places, dict) else ():
        told = place.get("inclusion") if isinstance(place, dict) else None
        inclusion = read_inclusion(told)
        if inclusion is None:
            continue
        organ = str(place.get("organ", str(place.get("region", "")).partition("/")[0]))
        members = organs.get(organ) if isinstance(organs, dict) else None
        number = members.get("body", 0) if isinstance(members, dict) else 0
        if not isinstance(number, int) or not 0 <= number < len(published.scene.bodies):
            continue
        body = published.scene.bodies[number]
        for table, rows in find_constants(published, body, inclusion).items():
            gathered[f"constants/{name}/{table}"] = rows
    return gathered


def read_inclusion(told: object) -> Inclusion | None:
    """None for what is none, or is written wrong."""
    try:
        ball, times = told["ball"], float(told["stiffness"])  # type: ignore[index]
        x, y, z, radius = (float(number) for number in ball)
    except (TypeError, ValueError, LookupError):
        return None
    numbers = np.array([x, y, z, radius, times])
    if not np.isfinite(numbers).all() or radius <= 0.0 or times <= 0.0:
        return None
    return Inclusion(np.array([x, y, z]), radius, times)


def find_constants(
    published: scenario.Scenario, body: palpate.SoftBody, inclusion: Inclusion
) -> dict[str, Floats]:
    """The tables of a body that the inclusion changes, by their names in a file."""
    tissue = body.tissue
    x = np.asarray(tissue.rest_position)
    along = np.linspace(0.0, 1.0, SPRING_POINTS)[:, None]
    found: dict[str, Floats] = {}

    def scale(table: str, column: str, factor: Floats) -> None:
        rows = np.asarray(getattr(getattr(tissue, table), column))
        if len(rows) and not np.array_equal(factor, np.ones_like(factor)):
            found[f"tissue/{table}/{column}"] = rows * factor

    for table in ("springs", "bonds"):
        ends = np.asarray(getattr(tissue, table).ends)
        factor = inclusion.find_factor(
            x[ends[:, None, 0]] * (1 - along) + x[ends[:, None, 1]] * along
        )
        scale(table, "stiffness", factor)
        scale(table, "damping", np.sqrt(factor))  # as damped as before
    points = spread_points()
    columns = {"volumes": ("bulk",), "elastic": ("lame", "shear"),
               "corotated": ("lame", "shear"), "neo_hookean": ("lame", "shear")}  # fmt: skip
    for table, names in columns.items():
        corners = np.asarray(getattr(tissue, table).corners).reshape(-1, 4)
        factor = inclusion.find_factor(np.einsum("pk,tkd->tpd", points, x[corners]))
        for column in names:
            scale(table, column, factor)
    if body.contact_modulus > 0.0 and len(np.asarray(tissue.prisms.corners)) == 0:
        found["contact/far_compliance"] = find_far_compliance(published, body, inclusion)
    return found


def spread_points() -> Floats:
    """(k, 4) Barycentric coordinates of points all over a tetrahedron."""
    n = DIVISIONS
    counts = range(n + 1)
    rows = [(a, b, c, n - a - b - c) for a in counts for b in counts for c in counts]
    rows = [row for row in rows if row[3] >= 0]
    return np.array(rows, dtype=float) / n


def find_far_compliance(
    published: scenario.Scenario, body: palpate.SoftBody, inclusion: Inclusion
) -> Floats:
    """[m/N] (n, 6) That of the body, less what the inclusion takes away around it."""
    tissue = body.tissue
    x = np.asarray(palpate.compute_surface(tissue, tissue.rest_position))
    normals = np.asarray(palpate.compute_vertex_normals(x, np.asarray(tissue.triangles)))
    far = np.array(body.far_compliance, dtype=float).reshape(-1, 6)
    if len(far) == 0:
        plain = np.asarray(body.near_field.far_compliance)
        far = plain[:, None] * np.array([1.0, 1.0, 1.0, 0.0, 0.0, 0.0])
    side = inclusion.centre - x
    near = np.flatnonzero(np.linalg.norm(side, axis=1) < inclusion.radius + REACH)
    depth = -(side[near] * normals[near]).sum(axis=1)
    aside = np.sqrt(np.maximum((side[near] ** 2).sum(axis=1) - depth**2, 0.0))
    poisson = find_poisson_ratio(published)
    young = body.contact_modulus * (1.0 - poisson**2)
    n = normals[near]
    squares = np.concatenate([n * n, n * np.roll(n, -1, axis=1)], axis=1)
    loss = [find_loss(inclusion, a, d, young, poisson) for a, d in zip(aside, depth, strict=True)]
    far[near] -= np.array(loss)[:, None] * squares
    return far


def find_poisson_ratio(published: scenario.Scenario) -> float:
    try:
        found = float(json.loads(published.authored)["content"]["material"]["poisson_ratio"])
    except (ValueError, LookupError, TypeError, RecursionError):
        return POISSON
    return found if 0.0 <= found < 0.5 else POISSON


def find_loss(
    inclusion: Inclusion, aside: float, depth: float, young: float, poisson: float
) -> float:
    """[m/N] by which a disc gives way less with the inclusion so far aside and so deep [m]."""
    steps = np.linspace(-1.0 + 1.0 / GRID, 1.0 - 1.0 / GRID, GRID)
    grid = np.stack(np.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 3)
    grid = grid[(grid**2).sum(axis=1) < 1.0] * inclusion.radius
    cell = 4.0 / 3.0 * np.pi * inclusion.radius**3 / len(grid)
    points = grid + np.array([aside, 0.0, depth])
    points = points[points[:, 2] > 0.0]
    stress = find_stress(points[:, None] - spread_load(PATCH)[None], poisson).mean(axis=1)
    trace = stress[:, :3].sum(axis=1)
    deviator = stress[:, :3] - trace[:, None] / 3.0
    shear_squared = (deviator**2).sum(axis=1) + 2.0 * (stress[:, 3:] ** 2).sum(axis=1)
    bulk, shear = young / (3.0 * (1.0 - 2.0 * poisson)), young / (2.0 * (1.0 + poisson))
    more = inclusion.stiffness - 1.0
    of_bulk = more / (1.0 + more * (1.0 + poisson) / (3.0 * (1.0 - poisson)))
    of_shear = more / (1.0 + more * 2.0 * (4.0 - 5.0 * poisson) / (15.0 * (1.0 - poisson)))
    energy = of_bulk * trace**2 / (9.0 * bulk) + of_shear * shear_squared / (2.0 * shear)
    return float(energy.sum() * cell)


def spread_load(radius: float) -> Floats:
    """[m] (k, 3) Points of a disc with equal areas."""
    points = [(0.0, 0.0, 0.0)]
    count = 3 * RINGS * (RINGS + 1) + 1
    for ring in range(1, RINGS + 1):
        at = radius * np.sqrt((3 * ring * ring + 1) / count)
        for angle in 2.0 * np.pi * np.arange(6 * ring) / (6 * ring):
            points.append((at * np.cos(angle), at * np.sin(angle), 0.0))
    return np.array(points)


def find_stress(points: Floats, poisson: float) -> Floats:
    """[1/m²] (..., 6) xx, yy, zz, xy, yz, zx at points below a half space's surface, z inwards,
    under a unit force along z at the origin [Johnson85, 3.19].
    """
    x, y, z = points[..., 0] + 1e-9, points[..., 1] + 1e-9, points[..., 2]
    flat, far = x * x + y * y, np.sqrt(x * x + y * y + z * z)
    part, lid = (1.0 - 2.0 * poisson) / flat, 1.0 - z / far
    xx = part * (lid * (x * x - y * y) / flat + z * y * y / far**3) - 3.0 * z * x * x / far**5
    yy = part * (lid * (y * y - x * x) / flat + z * x * x / far**3) - 3.0 * z * y * y / far**5
    zz = -3.0 * z**3 / far**5
    xy = part * (lid * x * y / flat - x * y * z / far**3) - 3.0 * x * y * z / far**5
    yz, zx = -3.0 * y * z * z / far**5, -3.0 * x * z * z / far**5
    return np.asarray(np.stack([xx, yy, zz, xy, yz, zx], axis=-1) / (2.0 * np.pi))
