# SPDX-License-Identifier: BSD-3-Clause
"""A body so fine that it is far from moving with the hand, felt beside its full model without a
clock; tests/bench/feel_slow_body.py is the same at any size, and in real time [stability: slow
tissue]."""

from __future__ import annotations

import palpate
import pytest
from palpate.bench.meshes import generate_mesh
from palpate.runs.press import find_top
from palpate.study.multirate import (
    HandWay,
    compare,
    feel_in_full,
    feel_slowly,
    find_jump,
    find_margin,
    list_samples,
)

DEPTH, SLIP, TICKS = 3e-3, 2e-3, 20
MOST_ERROR, MOST_JUMP = 0.05, 10e-3
"""[-] rms of force; [N] of a tick, or twice that of the full model."""


@pytest.mark.parametrize(
    "vertices",
    [
        pytest.param(20_000, marks=pytest.mark.landing),
        pytest.param(100_000, marks=pytest.mark.verify),
    ],
)
def test_a_fine_body_is_felt_by_its_local_stiffness_within_5_percent(vertices):
    """Of 100 000 vertices 200 particles are a patch of a few millimetres, and what is measured
    around them alone was wrong by 18 %."""
    scene, _ = generate_mesh(vertices).build()
    scene.bodies[0].force_error = 1e-3
    scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0
    scene = palpate.build_scene(scene)
    way = HandWay(find_top(scene), scene.instruments[0].tool.radius, DEPTH, SLIP)
    samples = list_samples(way, scene.rate)

    full = feel_in_full(scene, samples)
    felt = feel_slowly(scene, samples, TICKS, "local_stiffness")

    row = compare("local_stiffness", TICKS, scene, samples, felt, full)
    assert row.rms <= MOST_ERROR
    assert row.jump <= max(MOST_JUMP, 2.0 * find_jump(full))
    assert row.margin > find_margin(samples, full) - 0.01
