# SPDX-License-Identifier: GPL-3.0-or-later
"""Calibration of solids: what theory says a sphere feels on a layer, and the one factor to it."""

from __future__ import annotations

import json

import numpy as np
import pytest
from layers import THICKNESS, make_layer_organ
from palpate.cli.main import main
from palpate.runs.press import find_top
from palpate.study import indent
from palpate.study.calibrate import fit_factors
from palpate.study.curve import Curve
from palpate.study.half_space import compute_sphere_force
from palpate.study.indent import measure_indentation
from palpate_editor.compile import compile_organ
from palpate_editor.document.files import write_organ
from palpate_editor.edits import SetConstant

SPHERE = 0.02
"""[m]"""


def find_theory(depths: np.ndarray, young_modulus: float) -> np.ndarray:
    return np.array(
        [compute_sphere_force(d, SPHERE, THICKNESS, young_modulus, 0.45) for d in depths]
    )


@pytest.mark.landing
def test_one_factor_near_one_makes_a_solid_organ_feel_as_theory_says(monkeypatch):
    """Tool, skin and tetrahedra as in a session, beside [Hertz82] on a layer [Hayes72]."""
    monkeypatch.setattr(indent, "STOPS", 5)
    depths = np.linspace(1e-3, 4e-3, 7)
    scene = compile_organ(make_layer_organ(4e-3, SPHERE))
    felt = measure_indentation(scene, find_top(scene), depths)

    fit = fit_factors(
        Curve(depths, find_theory(depths, 5e3)), ("correction",), lambda f: f[0] * felt
    )

    assert fit.factors[0] == pytest.approx(1.15, abs=0.05)
    assert fit.high[0] < 1.2 * fit.low[0]
    assert fit.residual < 0.05 * fit.force.max()


@pytest.mark.landing
def test_the_modulus_of_a_solid_is_found_again_from_a_noisy_curve(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(indent, "STOPS", 5)
    organ = SetConstant("fill", "tetrahedra", 600)(make_layer_organ(5e-3, SPHERE))
    write_organ(tmp_path / "layer.organ", organ)
    depths = np.linspace(1e-3, 3e-3, 8)
    scene = compile_organ(organ)
    felt = 1.3 * measure_indentation(scene, find_top(scene), depths)
    felt += 0.02 * felt.max() * np.random.default_rng(11).normal(size=len(felt))
    rows = [f"{1e3 * d:.3f},{1e3 * f:.4f}" for d, f in zip(depths, felt, strict=True)]
    (tmp_path / "curve.csv").write_text(
        "\n".join(["depth [mm],force [mN]", *rows]) + "\n", encoding="utf-8"
    )

    call = [str(tmp_path / "layer.organ"), "--curve", str(tmp_path / "curve.csv"), "--json"]
    assert main(["calibrate", *call, "--plot", str(tmp_path / "fit.png")]) == 0

    report = json.loads(capsys.readouterr().out)
    (found,) = report["factors"]
    # contact gives way beside the tissue, so the factor is not quite that of the force
    assert found["low"] < 1.32 and found["high"] > 1.3
    assert report["after"]["young_modulus"] == pytest.approx(1.3 * 5e3, rel=0.05)
    assert report["residual_of_peak"] < 0.04
    assert not report["misses_shape"]
    assert (tmp_path / "fit.png").read_bytes().startswith(b"\x89PNG")
