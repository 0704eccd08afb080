# SPDX-License-Identifier: GPL-3.0-or-later
"""The atlas of a small organ: where its steps fail, kept, taken up again, and run again."""

from __future__ import annotations

import json
import signal
from dataclasses import replace
from pathlib import Path

import palpate
import pytest
from charted import make_block
from palpate.cli.main import main
from palpate.files.file_kind import ATLAS, PICTURE, SVG, find_kind
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import EXPLICIT, INTEGRATORS
from palpate.study.atlas import AT_REST, LIMITED, LOST, NEVER, REFUSED, UNLIMITED, Spot
from palpate.study.atlas_file import read_atlas, write_atlas
from palpate.study.step_limit import LIMIT_SHARE
from palpate_editor import job_pool
from palpate_editor.atlas import compute_key, draw_atlas, find_present, run_tissues
from palpate_editor.atlas_jobs import Plan, run_job
from palpate_editor.atlas_rerun import choose_rows, rerun_atlas
from palpate_editor.atlas_spots import build_tissue, list_points, make_organ
from palpate_editor.atlas_store import Store
from palpate_editor.chart_jobs import pack_document
from palpate_editor.document.files import write_organ
from palpate_editor.edits import EditError
from palpate_editor.job_pool import run_here

HERE = run_here(run_job)
OWN = Spot("solid", 1.0, "own", "own")
FEW = [
    (OWN, EXPLICIT),
    (replace(OWN, stiffness=100.0), ("symplectic_euler",)),
    (replace(OWN, damping="none"), ("symplectic_euler", "midpoint")),
    (Spot("molecular", 1.0, "own", "half"), ("symplectic_euler", "implicit_euler", "xpbd")),
    (Spot("linear_solid", 1.0, "own", "own"), ("symplectic_euler",)),
    (Spot("molecular", 1.0, "own", "double"), ("symplectic_euler",)),
]


@pytest.fixture(scope="module")
def plan():
    return Plan(pack_document(make_block()))


@pytest.fixture(scope="module")
def atlas(plan):
    return draw_atlas(plan, runner=HERE, points=FEW, command="palpate stability ellipsoid.organ")


def test_every_limit_lies_where_it_is_foretold_or_beyond(atlas):
    limited = [row for row in atlas.rows if row.outcome == LIMITED]

    assert len(limited) == 8
    for row in limited:
        assert row.measured >= 0.98 * row.predicted, row
        most = 1.02 if row.integrator == "symplectic_euler" else 2.5
        assert row.measured <= most * row.predicted, row


def test_a_row_says_what_becomes_of_its_method(atlas):
    outcomes = {(row.spot, row.integrator): row.outcome for row in atlas.rows}

    assert outcomes[FEW[2][0], "midpoint"] == NEVER
    assert outcomes[FEW[3][0], "implicit_euler"] == UNLIMITED
    assert outcomes[FEW[4][0], "symplectic_euler"] == AT_REST
    assert outcomes[FEW[5][0], "symplectic_euler"] == REFUSED
    assert "came with" in atlas.rows[-1].reason


def test_a_hundred_times_the_stiffness_is_a_tenth_of_the_limit(atlas):
    own, stiff = (atlas.find_row(spot, "symplectic_euler") for spot in (OWN, FEW[1][0]))

    assert stiff.measured == pytest.approx(0.1 * own.measured, rel=0.03)


def test_the_scene_is_where_it_steps(atlas):
    present = atlas.present

    assert present.step == pytest.approx(1e-3 / present.substeps)
    assert present.step <= LIMIT_SHARE * present.predicted
    assert present.measured == atlas.find_row(OWN, "symplectic_euler").measured


def test_what_follows_at_rest_or_is_implicit_has_no_limit():
    for model in ({"kind": "linear_solid"}, {"integrator": "implicit_euler"}):
        organ = make_block()
        present = find_present(replace(organ, model=replace(organ.model, **model)))

        assert present.predicted is None


def test_every_kind_is_tried_under_every_integrator_that_there_is():
    points = list_points(make_block())
    tried = {(spot.kind, name) for spot, names in points for name in names}

    kinds = {spot.kind for spot, _ in points}
    assert {"solid", "mass_spring", "molecular", "linear_solid", "neo_hookean_solid"} < kinds
    assert tried == {(kind, name) for kind in kinds for name in INTEGRATORS}
    assert len(points) == len({spot for spot, _ in points})


def test_a_wall_can_be_of_prisms_and_a_solid_cannot():
    organ = make_block()
    wall = replace(organ, material=replace(organ.material, wall_thickness=2e-3))

    assert "shell" in {spot.kind for spot, _ in list_points(wall)}
    assert "shell" not in {spot.kind for spot, _ in list_points(organ)}


@pytest.mark.parametrize("kind", ["solid", "mass_spring"])
def test_an_organ_becomes_what_a_spot_says(kind):
    organ = make_block()
    one = make_organ(organ, Spot(kind, 1.0, "own", "own"))
    made = make_organ(organ, Spot(kind, 4.0, "none", "half"))

    assert made.model.kind == kind
    assert made.material.young_modulus == 4.0 * organ.material.young_modulus
    assert made.model.stiffness == 4.0 * one.model.stiffness
    assert made.material.damping_ratio == made.model.drag == 0.0
    assert (
        palpate.estimate_spectrum(build_tissue(organ, Spot(kind, 4.0, "none", "half"))).damping
        == 0.0
    )
    if kind == "solid":
        assert made.fill.tetrahedra == organ.fill.tetrahedra // 2
    else:
        assert made.vertex_count == organ.vertex_count // 2
        with pytest.raises(EditError):
            make_organ(organ, Spot(kind, 1.0, "own", "double"))


def test_what_is_finished_is_not_run_again(plan, atlas, tmp_path):
    tried = []
    key = compute_key(plan)
    with Store(key, tmp_path) as store:
        part = draw_atlas(
            plan, runner=HERE, points=FEW[:3], store=store, asked=lambda: True, told=tried.append
        )
    assert not part.complete
    assert len(tried) == 1

    with Store(key, tmp_path) as store:
        whole = draw_atlas(plan, runner=HERE, points=FEW[:3], store=store, told=tried.append)

    assert whole.complete
    assert len(tried) == 3
    assert whole.rows == atlas.rows[: len(EXPLICIT) + 3]


def test_a_process_that_is_killed_loses_its_own_tissue_only(plan, atlas, monkeypatch):
    class Mortal(job_pool.Worker):
        def send(self, what):
            super().send(what)
            if getattr(what, "spot", None) == FEW[1][0]:
                self.process.send_signal(signal.SIGKILL)

    monkeypatch.setattr(job_pool, "Worker", Mortal)
    found = draw_atlas(plan, runner=run_tissues(1), points=FEW[1:3])

    assert found.rows[0].outcome == LOST
    assert "signal 9" in found.rows[0].reason
    assert [replace(row, number=0) for row in found.rows[1:]] == [
        replace(row, number=0) for row in atlas.rows[len(EXPLICIT) + 1 : len(EXPLICIT) + 3]
    ]


def test_a_tenth_is_run_again_and_what_differs_is_said(plan, atlas):
    file = Path("a.json")
    assert all(row["same"] for row in rerun_atlas(file, plan, atlas, HERE, part=0.3))

    chosen = choose_rows(atlas, 1.0, 0)[0]
    wrong = replace(chosen, held=1.1 * chosen.held, failed=1.1 * chosen.failed)
    other = replace(atlas, rows=(wrong,))
    [row] = rerun_atlas(file, plan, other, HERE, part=1.0)
    assert not row["same"]
    assert row["largest"] == pytest.approx(0.1 / 1.1, rel=0.01)
    with pytest.raises(Refusal, match="of this organ"):
        rerun_atlas(file, plan, replace(atlas, key="0"), HERE)


def test_the_same_rows_are_chosen_for_the_same_seed(atlas):
    assert choose_rows(atlas, 0.3, 1) == choose_rows(atlas, 0.3, 1)
    assert len(choose_rows(atlas, 0.1, 1)) == 1


def test_the_key_is_that_of_what_limits_depend_on(plan):
    organ = make_block()
    tool = replace(organ, tool=replace(organ.tool, radius=7e-3), title="Another")
    stiff = replace(organ, material=replace(organ.material, young_modulus=9e3))

    assert compute_key(Plan(pack_document(tool))) == compute_key(plan)
    assert compute_key(Plan(pack_document(stiff))) != compute_key(plan)


def test_the_verb_draws_keeps_and_runs_again(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("palpate_editor.atlas.list_points", lambda organ: FEW[:2])
    organ, out = tmp_path / "ellipsoid.organ", tmp_path / "out"
    write_organ(organ, make_block())

    assert main(["stability", str(organ), "--out", str(out), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    atlas = read_atlas(out / "ellipsoid.json")

    assert len(report["rows"]) == len(atlas.rows) == len(EXPLICIT) + 1
    kinds = {"json": ATLAS, "png": PICTURE, "svg": SVG}
    assert {e: find_kind(out / f"ellipsoid.{e}") for e in kinds} == kinds
    assert main(["stability", str(organ), "--rerun", str(out / "ellipsoid.json")]) == 0
    assert "the same to the bit" in capsys.readouterr().out
    spoilt = tuple(
        replace(row, held=1.2 * row.held, failed=1.2 * row.failed, predicted=row.predicted)
        for row in atlas.rows
    )
    write_atlas(out / "ellipsoid.json", replace(atlas, rows=spoilt))
    assert main(["stability", str(organ), "--rerun", str(out / "ellipsoid.json")]) == 1
    assert "off by" in capsys.readouterr().out


def test_the_verb_refuses_what_is_no_atlas_and_what_has_no_effect(tmp_path, capsys):
    organ = tmp_path / "ellipsoid.organ"
    write_organ(organ, make_block())

    assert main(["stability", str(organ), "--rerun", str(organ)]) == 1
    call = ["stability", str(organ), "--rerun", "a.json", "--out", str(tmp_path)]
    assert main(call) == 2
    assert "no effect" in capsys.readouterr().err
