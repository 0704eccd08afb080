# SPDX-License-Identifier: BSD-3-Clause
"""Fits: known factors are found again, noise is owned up to, and nothing is made up."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.runs.press import find_top
from palpate.scene.scene_file import compile_scene
from palpate.scene.scene_parts import HandPart, MaterialPart, ModelPart, SceneFile, ToolPart
from palpate.study.calibrate import NotFitted, fit_factors
from palpate.study.curve import Curve
from palpate.study.fit_plot import save_fit_plot
from palpate.study.indent import OutOfReach, measure_indentation
from round_surfaces import ball

DEPTH = np.linspace(5e-4, 6e-3, 12)


def made_of(linear: float, square: float) -> np.ndarray:
    """[N] of a tissue that stiffens: linear in one factor, square in the other."""
    return 20.0 * linear * DEPTH + 5e3 * square * DEPTH**2


def test_known_factors_are_found_again():
    curve = Curve(DEPTH, made_of(1.7, 0.4))

    fit = fit_factors(curve, ("one", "two"), lambda factors: made_of(*factors))

    assert fit.factors == pytest.approx((1.7, 0.4), rel=1e-4)
    assert fit.residual < 1e-5
    assert fit.explained == pytest.approx(1.0)
    assert fit.force == pytest.approx(curve.force, abs=1e-5)


def test_a_single_factor_is_found_from_far_away():
    curve = Curve(DEPTH, made_of(80.0, 80.0))

    fit = fit_factors(curve, ("all",), lambda factors: made_of(factors[0], factors[0]))

    assert fit.factors == pytest.approx((80.0,), rel=1e-5)


def test_the_confidence_interval_holds_the_truth_about_as_often_as_it_says():
    held = np.zeros(2)
    widths = []
    for seed in range(200):
        noise = np.random.default_rng(seed).normal(0.0, 2e-3, len(DEPTH))
        fit = fit_factors(
            Curve(DEPTH, made_of(1.0, 1.0) + noise), ("one", "two"), lambda f: made_of(*f)
        )
        held += (np.array(fit.low) < 1.0) & (np.array(fit.high) > 1.0)
        widths.append(np.array(fit.high) / np.array(fit.low))

    # 190 of 200 expected, each with a standard deviation of 3
    assert (np.abs(held - 190) < 12).all()
    assert (np.mean(widths, axis=0) > 1.01).all()


def test_more_noise_widens_the_interval_and_shows_in_the_residual():
    noise = np.random.default_rng(3).normal(0.0, 1e-3, len(DEPTH))

    quiet, loud = (
        fit_factors(
            Curve(DEPTH, made_of(1.0, 1.0) + part * noise), ("all",), lambda f: made_of(f[0], f[0])
        )
        for part in (1.0, 5.0)
    )

    assert loud.residual == pytest.approx(5.0 * quiet.residual, rel=0.01)
    assert np.log(loud.high[0] / loud.low[0]) == pytest.approx(
        5.0 * np.log(quiet.high[0] / quiet.low[0]), rel=0.05
    )


def test_a_model_whose_curve_has_another_shape_is_told_from_one_that_is_only_noisy():
    noise = np.random.default_rng(3).normal(0.0, 4e-3, len(DEPTH))

    noisy, bent = (
        fit_factors(Curve(DEPTH, force), ("all",), lambda f: made_of(f[0], f[0]))
        for force in (made_of(1.0, 1.0) + noise, made_of(0.2, 2.0))
    )

    assert bent.residual > noisy.residual > 0.01 * noisy.force.max()
    assert bent.misses_shape() is True  # and no bool of numpy, which JSON does not know
    assert noisy.misses_shape() is False


def test_factors_that_the_curve_cannot_tell_apart_are_refused():
    with pytest.raises(NotFitted, match="cannot tell one and two apart: fit one of them"):
        fit_factors(Curve(DEPTH, made_of(1, 1)), ("one", "two"), lambda f: made_of(f[0] * f[1], 0))


def test_a_model_that_feels_nothing_is_refused():
    with pytest.raises(NotFitted, match="pushes back nowhere"):
        fit_factors(Curve(DEPTH, made_of(1, 1)), ("one",), lambda f: np.zeros(len(DEPTH)))


def test_a_factor_that_runs_away_is_refused():
    with pytest.raises(NotFitted, match="one: the best factor is beyond"):
        fit_factors(Curve(DEPTH, made_of(1, 1)), ("one",), lambda f: made_of(1e-6 * f[0], 0))


def test_fewer_points_than_factors_are_refused():
    with pytest.raises(NotFitted, match="2 points cannot tell 2 factors"):
        fit_factors(Curve(DEPTH[:2], DEPTH[:2]), ("one", "two"), lambda f: DEPTH[:2])


def make_scene(stiffness: float, home: float, coupling: float = 1000.0) -> palpate.Scene:
    model = ModelPart(stiffness=stiffness, home_stiffness=home, drag=20.0)
    parts = SceneFile(
        organ=None,
        material=MaterialPart(),
        model=model,
        tool=ToolPart(radius=4e-3),
        hand=HandPart(coupling=coupling),
    )
    return compile_scene(parts, palpate.SurfaceMesh(*ball(600, 0.03)))


def test_a_tissue_pushes_back_more_the_deeper_the_tool_stands():
    scene = make_scene(60.0, 3e5)

    force = measure_indentation(scene, find_top(scene), DEPTH)

    assert (np.diff(force) > 0.0).all()
    assert force[0] > 0.0


def test_a_tissue_twice_as_stiff_pushes_back_twice_as_hard():
    soft, hard = make_scene(60.0, 3e5), make_scene(120.0, 6e5)

    one, two = (measure_indentation(s, find_top(s), DEPTH[4:]) for s in (soft, hard))

    # the contact gives way a little, and no more for the harder one
    assert two == pytest.approx(2.0 * one, rel=0.06)
    assert (two < 2.0 * one).all()


def test_what_the_tool_feels_does_not_depend_on_the_spring_of_the_hand():
    scenes = make_scene(60.0, 3e5, 500.0), make_scene(60.0, 3e5, 2000.0)

    one, two = (measure_indentation(s, find_top(s), DEPTH[2:]) for s in scenes)

    assert one == pytest.approx(two, rel=0.01)


def test_a_hand_too_soft_to_come_so_deep_is_refused():
    scene = make_scene(60.0, 3e7, 20.0)

    with pytest.raises(OutOfReach, match=r"the tip comes to .* mm of 6.0 mm"):
        measure_indentation(scene, find_top(scene), DEPTH)


def test_the_fitted_curve_is_drawn(tmp_path):
    noise = np.random.default_rng(1).normal(0.0, 3e-3, len(DEPTH))
    curve = Curve(DEPTH, made_of(1.2, 1.2) + noise)
    fit = fit_factors(curve, ("all",), lambda f: made_of(f[0], f[0]))

    save_fit_plot(tmp_path / "fit.png", curve, fit, "liver: curve.csv")

    assert (tmp_path / "fit.png").read_bytes().startswith(b"\x89PNG")
