# SPDX-License-Identifier: GPL-3.0-or-later
"""What contact references are made by: the ball on a condensed body, and a disc under a ball.

The disc is solved by elements of its own; it is held against formulas, and the references that ship
are held against it.
"""

from __future__ import annotations

import sys
from math import inf, pi
from pathlib import Path

import numpy as np
import pytest
from half_spaces import SOFT, build_half_space
from palpate.study.contact_reference import Case, read_contact_reference
from palpate.study.half_space import compute_sphere_force, plane_modulus

sys.path.insert(0, str(Path(__file__).parents[2] / "references"))

from axisymmetric import build_disc, press
from palpate_editor.truth.contact import PENALTY, find_gap, find_touch, press_ball

UP = np.array([0.0, 0.0, 1.0])
BLOCK_RADIUS, BLOCK_HEIGHT = 0.1 / np.sqrt(pi), 0.05
"""[m] The disc of the block's area and height."""


def test_a_ball_on_a_condensed_half_space_feels_what_hertz_says():
    radius, depths = 5e-3, np.array([1e-3, 2e-3])
    patch = build_half_space(radius, 4e-3, 31)

    found = press_ball(patch, depths, PENALTY * plane_modulus(*SOFT) / radius)

    for contact in found:
        hertz = compute_sphere_force(contact.depth, radius, inf, *SOFT)
        assert contact.force == pytest.approx(hertz, rel=0.01)
        assert contact.radius == pytest.approx(np.sqrt(radius * contact.depth), rel=0.05)


def test_no_point_of_a_contact_is_pulled_and_none_is_pushed_through():
    radius, depth = 5e-3, 1e-3
    patch = build_half_space(radius, 4e-3, 15)
    stiffness = PENALTY * plane_modulus(*SOFT) / radius

    force = press_ball(patch, np.array([depth]), stiffness)[0].force
    shallow = press_ball(patch, np.array([0.5 * depth, depth]), stiffness)[1].force

    # the answer is of the depth, not of the way there
    assert force == pytest.approx(shallow, rel=1e-6)


def test_a_ball_touches_a_level_facet_one_radius_over_it():
    square = np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * 0.05
    triangles = np.array([[0, 1, 2], [0, 2, 3]])

    assert find_touch(square, triangles, np.zeros(3), UP, 3e-3) == pytest.approx(3e-3)


def test_a_ball_touches_a_tilted_facet_before_its_tip_is_there():
    slope = np.tan(np.radians(30.0))
    square = np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * 0.05
    square[:, 2] = slope * square[:, 0]
    triangles = np.array([[0, 1, 2], [0, 2, 3]])

    found = find_touch(square, triangles, np.zeros(3), UP, 3e-3)

    assert found == pytest.approx(3e-3 / np.cos(np.radians(30.0)), rel=1e-9)


def test_a_ball_touches_a_ridge_beside_its_axis():
    # a roof along y whose ridge is 1 mm to the side and 2 mm over the place
    x = np.array(
        [[-0.05, -0.05, -0.1], [-0.05, 0.05, -0.1], [1e-3, -0.05, 2e-3], [1e-3, 0.05, 2e-3]]
    )
    triangles = np.array([[0, 2, 1], [1, 2, 3]])

    found = find_touch(x, triangles, np.zeros(3), UP, 3e-3)

    assert found == pytest.approx(2e-3 + np.sqrt(3e-3**2 - 1e-3**2), rel=1e-3)


def test_the_gap_under_a_ball_is_its_height_over_its_lowest_point():
    offset = np.array([[0.0, 0.0, 0.0], [2e-3, 0.0, 0.0], [2e-3, 0.0, 1e-3], [6e-3, 0.0, 0.0]])

    gap = find_gap(offset, UP, 5e-3, 5e-3)

    lift = 5e-3 - np.sqrt(5e-3**2 - 2e-3**2)
    assert gap == pytest.approx([0.0, lift, lift - 1e-3, inf])


def test_a_disc_that_is_large_feels_what_hertz_says():
    disc = build_disc(0.3, 0.3, 3e-3, *SOFT, fine=20.0, flat=0.4)

    shallow = press(disc, 3e-3, np.array([0.06e-3]), linear=True, step=1.0)[0]

    assert shallow.force == pytest.approx(compute_sphere_force(0.06e-3, 3e-3, inf, *SOFT), rel=0.01)


def test_a_disc_that_is_wide_feels_what_a_layer_says():
    radius, depth = 20e-3, 1e-3
    disc = build_disc(0.3, 0.01, radius, *SOFT, fine=24.0, flat=0.4)

    found = press(disc, radius, np.array([depth]), linear=True, step=1.0)[0]

    # the layer's indenter is a paraboloid, and the ball rises a little faster
    assert found.force == pytest.approx(compute_sphere_force(depth, radius, 0.01, *SOFT), rel=0.02)


@pytest.mark.landing
def test_a_shallow_press_is_the_same_in_a_linear_and_a_neo_hookean_disc():
    disc = build_disc(BLOCK_RADIUS, BLOCK_HEIGHT, 3e-3, *SOFT, fine=20.0, flat=0.4)
    depths = np.array([0.03e-3])

    line, curve = (press(disc, 3e-3, depths, linear, 0.01)[0].force for linear in (True, False))

    assert curve == pytest.approx(line, rel=0.01)


def press_beside(case: Case, step: float) -> tuple[np.ndarray, np.ndarray]:
    """Forces [N] of the disc and of a case on the block."""
    disc = build_disc(BLOCK_RADIUS, BLOCK_HEIGHT, case.radius, *SOFT)
    depths = np.array([result.depth for result in case.results])
    found = press(disc, case.radius, depths, case.law == "linear", step)
    return np.array([f.force for f in found]), np.array([r.force for r in case.results])


def find_middle(law: str, radius: float) -> Case:
    block = read_contact_reference("block")
    return next(
        case for case in block.list_cases(law) if case.place == "middle" and case.radius == radius
    )


@pytest.mark.landing
def test_the_block_that_ships_is_the_disc_of_its_area():
    disc, block = press_beside(find_middle("linear", 3e-3), 1.0)

    assert block == pytest.approx(disc, rel=0.01)


MIDDLE = [case for case in read_contact_reference("block").cases if case.place == "middle"]


@pytest.mark.verify
@pytest.mark.parametrize("case", MIDDLE, ids=lambda case: f"{case.law} {1e3 * case.radius:g} mm")
def test_the_block_is_the_disc_for_every_ball_and_law(case):
    disc, block = press_beside(case, 0.15)

    assert block == pytest.approx(disc, rel=0.015)


def dimitriadis(depth: float, radius: float, thickness: float) -> float:
    """[N] on a paraboloid and a thin bonded layer, a series in sqrt(R d)/h [Dimitriadis02]."""
    young, nu = SOFT
    x = np.sqrt(radius * depth) / thickness
    a = -(1.2876 - 1.4678 * nu + 1.3442 * nu**2) / (1.0 - nu)
    b = (0.6387 - 1.0277 * nu + 1.5164 * nu**2) / (1.0 - nu)
    series = (
        1.0
        - 2.0 * a / pi * x
        + 4.0 * a**2 / pi**2 * x**2
        - 8.0 / pi**3 * (a**3 + 4.0 * pi**2 / 15.0 * b) * x**3
        + 16.0 * a / pi**4 * (a**3 + 3.0 * pi**2 / 5.0 * b) * x**4
    )
    return 4.0 / 3.0 * plane_modulus(young, nu) * np.sqrt(radius) * depth**1.5 * float(series)


def test_the_layer_that_ships_feels_what_the_formulas_say():
    """[Hayes72]; its paraboloid is the ball as long as the depth is a small part of the radius."""
    layer = read_contact_reference("layer")

    for case in layer.list_cases("linear"):
        for result in case.results:
            if result.depth <= 0.13 * case.radius:
                formula = compute_sphere_force(result.depth, case.radius, 0.02, *SOFT)
                assert result.force == pytest.approx(formula, rel=0.015)
                series = dimitriadis(result.depth, case.radius, 0.02)
                assert result.force == pytest.approx(series, rel=0.015)
