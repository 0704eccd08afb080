# SPDX-License-Identifier: BSD-3-Clause
"""Indenters on layers: limits known by hand, and finite elements that were solved offline."""

from __future__ import annotations

from math import inf, pi

import numpy as np
import pytest
from palpate.study import half_space
from palpate.study.half_space import (
    compute_punch_force,
    compute_punch_sink,
    compute_sphere_force,
    layer_compliance,
    plane_modulus,
)
from palpate.study.reference import read_layer

SOFT = (5e3, 0.45)


def test_a_flat_punch_on_a_half_space_feels_twice_radius_modulus_and_depth():
    # 2 * 5 mm * 5 kPa / (1 - 0.45²) * 1 mm
    assert compute_punch_force(1e-3, 5e-3, inf, *SOFT) == pytest.approx(0.0626959, rel=1e-6)


def test_a_sphere_on_a_half_space_feels_what_hertz_says():
    # 4/3 * 5 kPa / (1 - 0.45²) * sqrt(5 mm) * (2 mm)^1.5
    assert compute_sphere_force(2e-3, 5e-3, inf, *SOFT) == pytest.approx(0.0528698, rel=1e-5)


def test_a_point_force_on_a_half_space_sinks_its_surroundings_with_one_over_the_distance():
    near, far = (compute_punch_sink(r, 0.1, 0.0, inf, *SOFT) for r in (0.01, 0.04))

    assert near == pytest.approx(0.1 * (1.0 - 0.45**2) / (pi * 5e3 * 0.01))
    assert far == pytest.approx(near / 4.0)


def test_the_surface_at_the_border_of_a_punch_has_sunk_as_deep_as_the_punch():
    force = compute_punch_force(1e-3, 5e-3, inf, *SOFT)

    assert compute_punch_sink(5e-3, force, 5e-3, inf, *SOFT) == pytest.approx(1e-3)


def test_a_thick_layer_is_a_half_space():
    for compute in (compute_punch_force, compute_sphere_force):
        assert compute(1e-4, 1e-3, 1.0, *SOFT) == pytest.approx(
            compute(1e-4, 1e-3, inf, *SOFT), rel=2e-3
        )


def test_a_thin_layer_under_a_wide_punch_is_a_column_that_cannot_spread():
    young, poisson = 5e3, 0.3
    oedometric = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
    column = oedometric * pi * 0.008**2 * 1e-4 / 1e-3

    force = compute_punch_force(1e-4, 0.008, 1e-3, young, poisson)

    # the border of the contact, a layer wide, carries more than its share
    assert force == pytest.approx(column, rel=0.05)
    assert force > column


def test_under_long_waves_a_layer_sinks_as_a_column_and_under_short_ones_as_a_half_space():
    nu = 0.3
    # a column sinks by h (1 + nu)(1 - 2 nu)/((1 - nu) E), a half space by 2 (1 - nu²)/(q E)
    column = 0.5 * (1.0 - 2.0 * nu) / (1.0 - nu) ** 2

    assert layer_compliance(1e-3, nu) / 1e-3 == pytest.approx(column, rel=1e-5)
    assert layer_compliance(20.0, nu) == pytest.approx(1.0, abs=1e-12)


def test_the_factor_of_the_layer_does_not_depend_on_how_finely_it_is_solved(monkeypatch):
    coarse = compute_punch_force(1e-3, 0.02, 0.01, *SOFT)
    monkeypatch.setattr(half_space, "NODES", 48)

    assert compute_punch_force(1e-3, 0.02, 0.01, *SOFT) == pytest.approx(coarse, rel=1e-8)


def test_finite_elements_agree_with_punch_and_sphere_on_a_layer_within_2_percent():
    layer = read_layer()
    tissue = (layer.thickness, layer.young_modulus, layer.poisson_ratio)

    assert layer.punch_force == pytest.approx(
        compute_punch_force(layer.punch_depth, layer.punch_radius, *tissue), rel=0.02
    )
    for depth, force in zip(layer.sphere_depths, layer.sphere_forces, strict=True):
        expected = compute_sphere_force(depth, layer.sphere_radius, *tissue)
        assert force == pytest.approx(expected, rel=0.02)
        # the correction is no small thing: the sphere is as large as a fifth of the layer
        assert expected > 1.1 * compute_sphere_force(depth, layer.sphere_radius, inf, *tissue[1:])


def test_finite_elements_sink_around_the_punch_as_the_layer_does():
    layer = read_layer()
    tissue = (layer.young_modulus, layer.poisson_ratio)
    near = layer.sink_distances < 0.6 * layer.thickness
    assert near.sum() >= 4

    for distance, sink in zip(layer.sink_distances[near], layer.sinks[near], strict=True):
        push = (distance, layer.punch_force, layer.punch_radius)
        whole = compute_punch_sink(*push, inf, *tissue)
        assert abs(sink - compute_punch_sink(*push, layer.thickness, *tissue)) < 0.02 * whole


def test_a_layer_much_thinner_than_its_contact_is_refused():
    with pytest.raises(ValueError, match="got a radius of 50 mm on a layer of 1 mm"):
        compute_punch_force(1e-4, 0.05, 1e-3, *SOFT)


def test_the_modulus_of_plane_strain_is_that_of_the_half_space():
    assert plane_modulus(3e3, 0.5) == pytest.approx(4e3)
    assert np.isclose(plane_modulus(3e3, 0.0), 3e3)
