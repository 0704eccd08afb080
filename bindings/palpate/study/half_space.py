# SPDX-License-Identifier: BSD-3-Clause
"""What an elastic half space, or a layer of it on a rigid base, does to a rigid indenter.

The layer is bonded to its base, the indenter is smooth, strains are small. Far from the indenter
the surface sinks as under a point force.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import quad_vec
from scipy.special import j0

Floats = NDArray[np.float64]

NODES = 24
"""Gauss points over the contact: the factor is then right to eight digits for a/h <= 2."""
WIDEST = 10.0
"""Of the thickness: the widest contact; the factor is right to a 1e-5 part up to there."""
REACH = 40.0
"""Of the depth: where the layer's compliance has long become the half space's."""


def plane_modulus(young_modulus: float, poisson_ratio: float) -> float:
    """[Pa] E* = E/(1 - nu²)."""
    return young_modulus / (1.0 - poisson_ratio**2)


def compute_punch_force(
    depth: float, radius: float, thickness: float, young_modulus: float, poisson_ratio: float
) -> float:
    """[N] on a flat punch: 2 a E* d [Sneddon65], times what the base adds [Hayes72].

    Args:
        depth: [m]
        radius: [m] a
        thickness: [m] of the layer; infinite for a half space.
        young_modulus: [Pa]
        poisson_ratio: [-]
    """
    force = 2.0 * radius * plane_modulus(young_modulus, poisson_ratio) * depth
    one, _, weights = solve_layer(radius, thickness, poisson_ratio)
    return force * float(weights @ one) / radius


def compute_sphere_force(
    depth: float, radius: float, thickness: float, young_modulus: float, poisson_ratio: float
) -> float:
    """[N] on a sphere: 4/3 E* sqrt(R) d^1.5 [Hertz82], times what the base adds [Hayes72].

    The contact is as wide as makes the pressure vanish at its border; found by halving. Arguments
    as compute_punch_force, `radius` being the sphere's.
    """
    # Hertz has sqrt(R d), and nothing is beyond where the sphere cuts the surface at rest
    low, high = 0.5 * np.sqrt(radius * depth), np.sqrt(2.0 * radius * depth)
    for _ in range(60):
        contact = 0.5 * (low + high)
        needed = find_sphere_depth(contact, radius, thickness, poisson_ratio)[0]
        low, high = (contact, high) if needed < depth else (low, contact)
    total = find_sphere_depth(contact, radius, thickness, poisson_ratio)[1]
    return 2.0 * plane_modulus(young_modulus, poisson_ratio) * total


def find_sphere_depth(
    contact: float, radius: float, thickness: float, poisson_ratio: float
) -> tuple[float, float]:
    """[m] that a sphere sinks for a contact of this radius, and [m²] the mean of its moments."""
    one, square, weights = solve_layer(contact, thickness, poisson_ratio)
    # the density is depth * one - square / R, and vanishes at the border, the last point
    depth = square[-1] / one[-1] / radius
    return float(depth), float(weights @ (depth * one - square / radius))


def solve_layer(
    contact: float, thickness: float, poisson_ratio: float
) -> tuple[Floats, Floats, Floats]:
    """Densities under a flat and under a parabolic indenter, at Gauss points and at the border.

    The pressure's Abel transform phi obeys a Fredholm equation of the second kind,

        phi(t) - (2/pi) int_0^a phi(s) K(t, s) ds = w(t),
        K(t, s) = int_0^inf (1 - L(x h)) cos(x t) cos(x s) dx,

    with w = 1 and w = t²: the response of a half space, L = 1 [Hayes72].

    Returns:
        phi for w = 1, phi for w = t² [m²], and the weights [m] of the integral from 0 to a; the
        border's weight is 0.

    Raises:
        ValueError: where the contact is wider than WIDEST of the layer.
    """
    if contact > WIDEST * thickness:
        raise ValueError(
            f"contact: got a radius of {1e3 * contact:g} mm on a layer of {1e3 * thickness:g} mm, "
            f"expected at most {WIDEST:g} of the layer"
        )
    points, weights = np.polynomial.legendre.leggauss(NODES)
    t = np.append(0.5 * contact * (points + 1.0), contact)
    weights = np.append(0.5 * contact * weights, 0.0)
    matrix = np.eye(len(t))
    if np.isfinite(thickness):
        kernel = quad_vec(
            lambda x: (
                (1.0 - layer_compliance(x, poisson_ratio))
                * (np.cos(x * t / thickness)[:, None] * np.cos(x * t / thickness))
            ),
            1e-9,
            REACH,
        )[0]
        matrix -= 2.0 / np.pi / thickness * kernel * weights
    one, square = np.linalg.solve(matrix, np.stack([np.ones_like(t), t**2], axis=1)).T
    return one, square, weights


def layer_compliance(x: float, poisson_ratio: float) -> float:
    """[-] How far the surface of a bonded layer sinks under cos(x r/h), beside a half space."""
    k = 3.0 - 4.0 * poisson_ratio
    fall = np.exp(-2.0 * x)
    # sinh and cosh of 2x over exp(2x), so that nothing overflows
    upper = k * (1.0 - fall**2) - 4.0 * x * fall
    lower = k * (1.0 + fall**2) + (1.0 + k**2 + 4.0 * x**2) * fall
    return upper / lower


def compute_punch_sink(
    distance: float,
    force: float,
    radius: float,
    thickness: float,
    young_modulus: float,
    poisson_ratio: float,
) -> float:
    """[m] that the surface sinks at a distance [m] from a flat punch that pushes with a force [N].

    F/(pi a E*) asin(a/r) [Sneddon65], F/(pi E* r) for a point [Boussinesq85], less what the base
    of a layer holds back under the half space's pressure.
    """
    sink = np.arcsin(radius / distance) / radius if radius > 0.0 else 1.0 / distance
    if np.isfinite(thickness):
        sink -= quad_vec(
            lambda x: (1.0 - layer_compliance(x, poisson_ratio))
            * j0(x * distance / thickness)
            * np.sinc(x * radius / thickness / np.pi),
            1e-9,
            REACH,
        )[0] / thickness  # fmt: skip
    return force * float(sink) / (np.pi * plane_modulus(young_modulus, poisson_ratio))
