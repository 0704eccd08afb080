# SPDX-License-Identifier: GPL-3.0-or-later
"""A shipped organ as a solid: filled, published, pressed through the live loop, played again."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from organs import make_organ
from palpate import scenario
from palpate.cli.main import main
from palpate_editor.check import assess
from palpate_editor.compile import compile_organ
from palpate_editor.document import Surface
from palpate_editor.document.constants import find_constant
from palpate_editor.document.files import write_organ
from palpate_editor.edits import SetChoice
from palpate_editor.fill import build_filled, fill_organ, fill_surface, find_nearest
from palpate_editor.shipped import find_mesh
from palpate_editor.shipped import make_organ as make_shipped


def run(capsys, *words: object, code: int = 0) -> dict:
    assert main([*map(str, words), "--json"]) == code
    return json.loads(capsys.readouterr().out)


@pytest.fixture(scope="module")
def spleen():
    return SetChoice("kind", "solid")(make_shipped("spleen"))


def test_a_filled_organ_keeps_its_surface_its_volume_and_its_weight(spleen):
    tissue = build_filled(spleen)
    surface = palpate.compute_surface(tissue, tissue.rest_position)
    mesh = palpate.SurfaceMesh(spleen.surface.vertices, spleen.surface.triangles)

    assert np.abs(surface - spleen.surface.vertices).max() < 1e-9
    assert 2000 < len(tissue.volumes.corners) < 4500
    mass = spleen.material.density * palpate.compute_volume(mesh)
    assert palpate.compute_total_mass(tissue) == pytest.approx(mass, rel=0.05)
    assert np.asarray(tissue.skin.weights).sum(axis=1) == pytest.approx(1.0)


def test_what_is_painted_on_the_surface_is_carried_inside(spleen):
    high = spleen.surface.vertices[:, 2] > np.median(spleen.surface.vertices[:, 2])
    painted = replace(spleen, stiffness_scale=np.where(high, 3.0, 1.0), fixed=~high)

    plain, tissue = build_filled(spleen), build_filled(painted)

    stiffer = np.asarray(tissue.volumes.bulk) / np.asarray(plain.volumes.bulk)
    assert stiffer.min() == pytest.approx(1.0) and stiffer.max() == pytest.approx(3.0)
    nearest = find_nearest(np.asarray(tissue.rest_position), spleen.surface.vertices)
    outside = np.unique(palpate.find_boundary(fill_organ(spleen)))
    assert set(np.asarray(tissue.fixed)) == set(outside) & set(np.flatnonzero(~high[nearest]))


def test_the_same_surface_is_filled_alike(spleen):
    once = fill_surface(Surface(spleen.surface.vertices, spleen.surface.triangles), 800)
    again = fill_surface(Surface(spleen.surface.vertices, spleen.surface.triangles), 800)

    assert once is not again
    assert (np.asarray(once.vertices) == np.asarray(again.vertices)).all()
    assert (np.asarray(once.tetrahedra) == np.asarray(again.tetrahedra)).all()


def test_an_open_or_hollow_organ_is_no_solid_and_is_told_so(spleen):
    opened = spleen.with_surface(Surface(spleen.surface.vertices, spleen.surface.triangles[:-1]))
    hollow = replace(spleen, material=replace(spleen.material, wall_thickness=2e-3))
    soft = replace(spleen, material=replace(spleen.material, poisson_ratio=0.2))

    with pytest.raises(ValueError, match="fill: surface: got an open one, with 1 hole"):
        compile_organ(opened)
    for organ, where in ((opened, "material.wall_thickness"), (hollow, "material: wall_thickness")):
        assert where in {p.where for p in assess(organ).errors}
    (problem,) = assess(soft).errors
    assert (problem.where, str(problem.got)) == ("material: poisson_ratio", "0.2")
    assert "0.25 to 0.49" in str(problem.expected)


def test_constants_of_surfaces_are_not_those_of_solids():
    assert "solid" not in find_constant("model", "stiffness").kinds
    assert "solid" not in find_constant("model", "home_stiffness").kinds
    assert "solid" in find_constant("material", "young_modulus").kinds


def test_a_solid_needs_a_working_file(tmp_path, capsys, spleen):
    path = tmp_path / "ball.organ"
    write_organ(path, make_organ())

    main(["material", str(path), "--kind", "solid", "-o", str(tmp_path / "ball.scene.json")])

    assert "a scene file has no tetrahedra" in capsys.readouterr().err


@pytest.mark.landing
def test_a_filled_spleen_is_published_pressed_in_the_live_loop_and_replayed(tmp_path, capsys):
    organ, file = tmp_path / "spleen.organ", tmp_path / "spleen.palpate"
    record = tmp_path / "press.prec"

    made = run(capsys, "material", shipped_file(), "--kind", "solid", "-o", organ)
    run(capsys, "publish", organ, "-o", file, "--title", "Spleen, filled")
    press = run(capsys, "press", file, "--depth", "8mm", "--record", record)
    again = run(capsys, "replay", record)

    assert made["tetrahedra"] > 1000
    assert len(scenario.read(file).scene.bodies[0].tissue.volumes.corners) == made["tetrahedra"]
    assert press["peak_force_N"] > 0.2
    assert again["equal"]


def shipped_file() -> Path:
    return find_mesh("spleen").with_suffix(".organ")
