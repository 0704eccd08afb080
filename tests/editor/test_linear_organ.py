# SPDX-License-Identifier: GPL-3.0-or-later
"""A shipped organ as a linear solid: published, pressed through the live loop, played again."""

from __future__ import annotations

import contextlib
import io
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.cli.main import main
from palpate_editor.check import assess
from palpate_editor.document.constants import counts_choice, find_constant
from palpate_editor.edits import SetChoice
from palpate_editor.shipped import find_mesh
from palpate_editor.shipped import make_organ as make_shipped


def run(capsys, *words: object, code: int = 0) -> dict:
    assert main([*map(str, words), "--json"]) == code
    return json.loads(capsys.readouterr().out)


def shipped_file() -> Path:
    return find_mesh("spleen").with_suffix(".organ")


@pytest.fixture(scope="module")
def organ_file(tmp_path_factory) -> Path:
    return tmp_path_factory.mktemp("linear") / "spleen.organ"


@pytest.fixture(scope="module")
def said(organ_file) -> dict:
    """What `palpate material` reports of the organ it writes."""
    words = ["material", str(shipped_file()), "--kind", "linear", "-o", str(organ_file), "--json"]
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        assert main(words) == 0
    return json.loads(out.getvalue())


@pytest.fixture(scope="module")
def published(said, organ_file) -> Path:
    del said  # the organ is written by then
    file = organ_file.with_suffix(".palpate")
    assert main(["publish", str(organ_file), "-o", str(file), "--title", "Spleen, linear"]) == 0
    return file


@pytest.mark.landing
def test_its_memory_is_said_when_it_is_built(said, published):
    size = palpate.measure_response(scenario.read(published).scene.bodies[0].tissue)

    assert said["response_bytes"] == size.bytes > 1e6
    assert f"a response of {1e-6 * size.bytes:.1f} MB" in said["description"]
    assert said["tetrahedra"] > 1000


@pytest.mark.landing
def test_a_published_linear_solid_is_pressed_in_the_live_loop_and_replayed(
    published, tmp_path, capsys
):
    record = tmp_path / "press.prec"

    press = run(capsys, "press", published, "--depth", "3mm", "--record", record)
    again = run(capsys, "replay", record)

    assert press["peak_force_N"] > 0.05
    assert again["equal"]
    assert json.loads(palpate.read_record(record).header)["kernel"] == "response"


@pytest.mark.landing
def test_a_published_linear_solid_comes_back_with_its_response(published):
    scene = scenario.read(published).scene

    assert scene.bodies[0].kernel is palpate.Kernel.response
    assert len(scene.bodies[0].tissue.elastic.corners) > 1000
    assert scene.bodies[0].response.compliance.shape == (3 * scene.bodies[0].response.size.pushed,
                                               3 * scene.bodies[0].response.size.moved)  # fmt: skip


def test_a_press_that_is_too_deep_for_it_is_told(published, capsys):
    assert main(["press", str(published), "--depth", "12mm"]) == 1

    assert "there a linear solid is good for" in capsys.readouterr().err


def test_an_organ_that_nothing_holds_is_told_so():
    organ = SetChoice("kind", "linear_solid")(make_shipped("spleen"))
    loose = replace(organ, fixed=np.zeros_like(organ.fixed))

    errors = [p for p in assess(loose).errors if p.where == "linear solid: fixed"]

    assert len(errors) == 1
    assert "particles held" in str(errors[0].expected)


def test_constants_that_have_no_effect_on_it_are_not_asked_for():
    model = SetChoice("kind", "linear_solid")(make_shipped("spleen")).model

    assert find_constant("material", "young_modulus").counts(model)
    assert find_constant("material", "damping_ratio").counts(model)
    for part, field in (("model", "drag"), ("model", "home_stiffness"), ("hand", "force_error")):
        assert not find_constant(part, field).counts(model)
    assert not counts_choice("damping_law", model)
