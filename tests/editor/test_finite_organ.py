# SPDX-License-Identifier: GPL-3.0-or-later
"""A shipped organ as a corotated and as a neo-Hookean solid: published, read, pressed."""

from __future__ import annotations

import json

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.cli.main import main
from palpate_editor.document.constants import counts_choice, find_constant
from palpate_editor.edits import SetChoice
from palpate_editor.shipped import find_mesh
from palpate_editor.shipped import make_organ as make_shipped

TABLES = {"corotated": "corotated", "neo-hookean": "neo_hookean"}
"""Kind on the command line -> table of its law."""


@pytest.fixture(scope="module", params=TABLES)
def kind(request):
    return request.param


@pytest.fixture(scope="module")
def published(kind, tmp_path_factory):
    folder = tmp_path_factory.mktemp(kind)
    organ, file = folder / "spleen.organ", folder / "spleen.palpate"
    shipped = find_mesh("spleen").with_suffix(".organ")
    words = ["--kind", kind, "--tetrahedra", "600", "-o", str(organ)]
    assert main(["material", str(shipped), *words]) == 0
    assert main(["publish", str(organ), "-o", str(file), "--title", "Spleen"]) == 0
    return file


def test_a_published_solid_at_finite_strain_has_its_law_and_its_near_field(kind, published):
    body = scenario.read(published).scene.bodies[0]

    table = getattr(body.tissue, TABLES[kind])
    assert len(table.corners) > 300
    assert table.nodal_share == 0.9
    assert np.asarray(table.viscosity).min() > 0.0
    assert len(body.tissue.springs.ends) == 0
    assert body.kernel == palpate.Kernel.reference
    assert body.contact_modulus > 0.0


def test_it_is_pressed_and_pushes_back(published, capsys):
    assert main(["press", str(published), "--depth", "2mm", "--json"]) == 0

    found = json.loads(capsys.readouterr().out)
    assert found["peak_force_N"] > 0.01


def test_what_has_no_effect_on_it_is_not_offered(kind):
    model = SetChoice("kind", f"{TABLES[kind]}_solid")(make_shipped("spleen")).model

    for field in ("relaxation", "relaxation_time", "stiffness", "home_stiffness", "pressure"):
        assert not find_constant("model", field).counts(model)
    assert find_constant("model", "drag").counts(model)
    assert not counts_choice("damping_law", model)
    assert counts_choice("contact_law", model)
