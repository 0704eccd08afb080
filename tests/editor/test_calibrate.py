# SPDX-License-Identifier: GPL-3.0-or-later
"""palpate calibrate: constants found again from the curve of a tissue whose constants are known."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from organs import make_organ
from palpate.cli.main import main
from palpate.runs.press import find_top
from palpate.scene.scene_parts import HandPart, MaterialPart, ModelPart, ToolPart
from palpate.study import indent
from palpate.study.indent import measure_indentation
from palpate_editor.compile import compile_organ
from palpate_editor.document import Organ
from palpate_editor.document.files import read_organ, write_organ

DEPTH = np.linspace(5e-4, 5e-3, 10)


@pytest.fixture(autouse=True)
def few_stops(monkeypatch) -> None:
    """Half as many depths at which the tool comes to rest: the curve and its fit have the same."""
    monkeypatch.setattr(indent, "STOPS", 5)


@pytest.fixture(scope="module")
def organ() -> Organ:
    return replace(
        make_organ(vertices=200, imported=None),
        name="test organ",
        material=MaterialPart(),
        model=ModelPart(stiffness=60.0, home_stiffness=3e5, drag=20.0),
        tool=ToolPart(radius=4e-3),
        hand=HandPart(),
    )


def write_curve(path: Path, organ: Organ, noise: float = 0.0) -> Path:
    """The response of the organ itself, as a bench might have measured it."""
    scene = compile_organ(organ)
    force = measure_indentation(scene, find_top(scene), DEPTH)
    force += noise * force.max() * np.random.default_rng(7).normal(size=len(force))
    rows = [f"{1e3 * d:.3f},{f:.6f}" for d, f in zip(DEPTH, force, strict=True)]
    path.write_text(
        "\n".join(["# synthetic", "depth [mm],force [N]", *rows]) + "\n", encoding="utf-8"
    )
    return path


def calibrate(capsys, *words: object) -> dict:
    assert main(["calibrate", *map(str, words), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_known_constants_are_found_again(tmp_path, organ, capsys):
    write_organ(tmp_path / "guess.organ", organ)
    truth = replace(organ, model=replace(organ.model, stiffness=84.0, home_stiffness=4.2e5))
    curve = write_curve(tmp_path / "curve.csv", truth)

    report = calibrate(
        capsys, tmp_path / "guess.organ", "--curve", curve, "--out", tmp_path / "fitted.organ",
        "--plot", tmp_path / "fit.png",
    )  # fmt: skip

    (found,) = report["factors"]
    assert found["factor"] == pytest.approx(1.4, rel=0.01)
    assert report["after"]["stiffness"] == pytest.approx(84.0, rel=0.01)
    assert report["residual_of_peak"] < 0.005
    assert report["explained"] > 0.999
    fitted = read_organ(tmp_path / "fitted.organ")
    assert fitted.model.stiffness == report["after"]["stiffness"]
    assert fitted.model.home_stiffness == report["after"]["home_stiffness"]
    assert fitted.tool == organ.tool
    assert (tmp_path / "fit.png").read_bytes().startswith(b"\x89PNG")


def test_springs_and_home_springs_are_told_apart(tmp_path, organ, capsys):
    write_organ(tmp_path / "guess.organ", organ)
    truth = replace(organ, model=replace(organ.model, stiffness=90.0, home_stiffness=2e5))
    curve = write_curve(tmp_path / "curve.csv", truth)

    report = calibrate(capsys, tmp_path / "guess.organ", "--curve", curve, "--fit", "both")

    springs, home = report["factors"]
    assert springs["factor"] == pytest.approx(1.5, rel=0.05)
    assert home["factor"] == pytest.approx(2.0 / 3.0, rel=0.05)


def test_youngs_modulus_is_fitted_where_the_constants_come_from_the_tissue(tmp_path, organ, capsys):
    walled = replace(
        organ,
        material=replace(organ.material, wall_thickness=2e-3, young_modulus=4e4),
        model=replace(organ.model, constants="tissue"),
    )
    write_organ(tmp_path / "guess.organ", walled)
    stiff = replace(
        walled,
        material=replace(walled.material, young_modulus=5.2e4),
        model=replace(walled.model, home_stiffness=3.9e5),
    )
    curve = write_curve(tmp_path / "curve.csv", stiff)

    report = calibrate(capsys, tmp_path / "guess.organ", "--curve", curve)

    assert report["after"]["young_modulus"] == pytest.approx(5.2e4, rel=0.01)
    assert report["after"]["home_stiffness"] == pytest.approx(3.9e5, rel=0.01)


def test_a_noisy_curve_gives_an_interval_that_holds_the_truth(tmp_path, organ, capsys):
    write_organ(tmp_path / "guess.organ", organ)
    curve = write_curve(tmp_path / "curve.csv", organ, noise=0.03)

    (found,) = calibrate(capsys, tmp_path / "guess.organ", "--curve", curve)["factors"]

    assert found["low"] < 1.0 < found["high"]
    assert 1.01 < found["high"] / found["low"] < 1.2


def test_a_larger_indenter_is_taken_into_account(tmp_path, organ, capsys):
    write_organ(tmp_path / "guess.organ", organ)
    large = replace(organ, tool=replace(organ.tool, radius=8e-3))
    curve = write_curve(tmp_path / "curve.csv", large)

    right = calibrate(capsys, tmp_path / "guess.organ", "--curve", curve, "--tip-radius", "8mm")
    wrong = calibrate(capsys, tmp_path / "guess.organ", "--curve", curve)

    assert right["factors"][0]["factor"] == pytest.approx(1.0, rel=0.01)
    assert wrong["factors"][0]["factor"] > 1.05


def test_the_report_is_told_in_words(tmp_path, organ, capsys):
    write_organ(tmp_path / "guess.organ", organ)
    curve = write_curve(tmp_path / "curve.csv", organ)

    assert main(["calibrate", str(tmp_path / "guess.organ"), "--curve", str(curve)]) == 0

    words = capsys.readouterr().out
    assert "elastic constants" in words and "(95 %:" in words
    assert "stiffness" in words and "home_stiffness" in words
    assert "mN root mean square" in words and "of 10 points" in words


def test_a_curve_of_another_shape_is_said_to_be_one(tmp_path, organ, capsys):
    write_organ(tmp_path / "guess.organ", organ)
    rows = [f"{1e3 * d:.3f},{1e6 * d**3:.6f}" for d in DEPTH]
    (tmp_path / "curve.csv").write_text(
        "\n".join(["depth [mm],force [N]", *rows]) + "\n", encoding="utf-8"
    )

    call = ["calibrate", str(tmp_path / "guess.organ"), "--curve", str(tmp_path / "curve.csv")]
    assert main(call) == 0

    assert "what is left over is no noise" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "options", "sentence"),
    [
        ("depth,force\n1,2\n", [], "line 1: got depth without a unit"),
        ("depth [mm],force [N]\n1,2\n", [], "got 1 points, expected at least 4"),
        ("whole", ["--out", "fitted.json"], "fitted.json: got a name ending in '.json'"),
    ],
)
def test_a_bad_call_is_refused_in_a_sentence(tmp_path, organ, capsys, text, options, sentence):
    write_organ(tmp_path / "guess.organ", organ)
    curve = tmp_path / "curve.csv"
    if text == "whole":
        write_curve(curve, organ)
    else:
        curve.write_text(text, encoding="utf-8")

    assert main(["calibrate", str(tmp_path / "guess.organ"), "--curve", str(curve), *options]) == 1

    said = capsys.readouterr().err
    assert said.startswith("palpate calibrate: ")
    assert re.search(sentence, said)


def test_a_depth_that_the_hand_is_too_weak_for_is_refused(tmp_path, organ, capsys):
    # crushed by half, as it would be softer, the organ may blow up before
    hard = replace(organ, model=replace(organ.model, stiffness=600.0, home_stiffness=3e6))
    write_organ(tmp_path / "hard.organ", hard)
    curve = tmp_path / "curve.csv"
    rows = "".join(f"{d},{d}\n" for d in range(20, 90, 10))
    curve.write_text("depth [mm],force [N]\n" + rows, encoding="utf-8")

    assert main(["calibrate", str(tmp_path / "hard.organ"), "--curve", str(curve)]) == 1

    said = capsys.readouterr().err
    assert re.search("got the tip comes to .* expected depths that the tool can reach", said)


def test_home_springs_that_are_not_there_cannot_be_fitted(tmp_path, organ, capsys):
    bare = replace(organ, model=replace(organ.model, home_stiffness=0.0))
    write_organ(tmp_path / "bare.organ", bare)
    curve = write_curve(tmp_path / "curve.csv", organ)

    call = ["calibrate", str(tmp_path / "bare.organ"), "--curve", str(curve), "--fit", "home"]
    assert main(call) == 1

    assert "got no home springs, expected a constant above 0" in capsys.readouterr().err
