# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate advise`: a choice from a chart, in words, scored on held-out presses, and applied."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from organs import make_organ
from palpate.cli.main import main
from palpate.study.advice import Targets
from palpate.study.chart_file import write_chart
from palpate.study.held_out import read_held_out
from palpate_editor import advise
from palpate_editor.advice_words import describe_advised
from palpate_editor.advise import AdviseError, advise_organ, find_steps, require_chart_of
from palpate_editor.compile import compile_organ
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits.configure import find_configuration

sys.path.append(str(Path(__file__).resolve().parent / "window"))
from charts_of import make_chart, make_row  # noqa: E402

LOOSE = Targets(0.5, 0.5, 1000.0)


@pytest.fixture(scope="module")
def organ():
    return replace(make_organ(), title="Ellipsoid")


@pytest.fixture
def files(tmp_path, organ):
    """An organ and a chart of it, whose numbers are made up."""
    write_organ(tmp_path / "a.organ", organ)
    write_chart(tmp_path / "a.chart.json", make_chart(organ))
    return tmp_path / "a.organ", tmp_path / "a.chart.json"


def call(files, *options, capsys) -> dict:
    code = main(["advise", str(files[0]), "--chart", str(files[1]), *options, "--json"])
    return {"code": code} | json.loads(capsys.readouterr().out)


def test_the_choice_is_said_with_its_margins_and_its_neighbours(files, capsys):
    report = call(files, "--force-error", "0.2", "--displacement-error", "0.1", "--no-score",
                  capsys=capsys)  # fmt: skip

    assert report["code"] == 0 and report["fits"] and not report["keeps_own"]
    said = "\n".join(report["said"])
    assert "The cheapest that meets every target:" in said
    assert "Validated to 3.0 mm deep" in said
    assert "of the longest stable one" in said or "stable at any length" in said
    assert "binds" in said and "Next cheaper:" in said and "Next better:" in said
    assert all(need["met"] for need in report["choice"]["needs"])
    assert report["choice"]["total"]["force_rms"] + 0.02 <= 0.2
    assert report["score"] is None and report["written"] is None


def test_apply_writes_the_choice_into_the_organ_and_nothing_else(files, organ, capsys):
    report = call(files, "--force-error", "0.2", "--displacement-error", "0.1", "--no-score",
                  "--apply", capsys=capsys)  # fmt: skip

    after = read_organ(files[0])
    wanted = report["choice"]["configuration"]
    assert report["written"] == str(files[0])
    assert vars(replace(find_configuration(after), vertices=wanted["vertices"])) == wanted
    for part in ("material", "tool", "name", "title"):
        assert getattr(after, part) == getattr(organ, part)


@pytest.mark.landing
def test_what_meets_no_target_is_the_nearest_miss_and_is_not_applied(files, capsys):
    tight = "--force-error", "0.01", "--no-score"
    report = call(files, *tight, capsys=capsys)
    assert report["code"] == 0 and not report["fits"], report
    assert report["said"][0].startswith("None of the ") and "Nearest:" in report["said"][0]
    assert report["binding"] == "truth" or report["binding"] == "force"

    before = files[0].read_bytes()
    code = main(["advise", str(files[0]), "--chart", str(files[1]), *tight, "--apply"])
    assert code == 1 and "no configuration that meets every target" in capsys.readouterr().err
    assert files[0].read_bytes() == before


@pytest.mark.parametrize(
    ("options", "code", "said"),
    [
        (["--rate", "500"], 1, "expected 1000 Hz, at which the chart was drawn"),
        (["--rate", "0"], 2, "expected above 0"),
        (["--force-error", "0"], 2, "expected above 0 and at most 1"),
        (["--force-error", "nan"], 2, "expected above 0 and at most 1"),
        (["--displacement-error", "1.5"], 2, "expected above 0 and at most 1"),
        (["--workers", "2"], 2, "no effect on a --chart"),
        (["--workers", "0"], 2, "a whole number of 1 to 256"),
    ],
)
def test_what_does_not_fit_is_refused(files, options, code, said, capsys):
    arguments = ["advise", str(files[0]), "--chart", str(files[1]), "--no-score", *options]
    try:
        got = main(arguments)
    except SystemExit as ended:
        got = ended.code

    assert got == code and said in capsys.readouterr().err


def test_a_chart_of_another_organ_is_refused(files, organ, capsys):
    stiffer = replace(organ, material=replace(organ.material, young_modulus=9e3))
    write_organ(files[0], stiffer)
    assert main(["advise", str(files[0]), "--chart", str(files[1])]) == 1
    assert "Young's modulus" in capsys.readouterr().err

    chart = make_chart(organ)
    first = replace(chart.rows[0], counts=replace(chart.rows[0].counts, particles=99))
    with pytest.raises(AdviseError, match="a surface of 99 vertices, expected 60"):
        advise_organ(organ, replace(chart, rows=(first, *chart.rows[1:])), LOOSE)


def test_only_an_organ_file_is_written_to(files, tmp_path, capsys):
    published = tmp_path / "a.palpate"
    published.write_bytes(b"")

    assert main(["advise", str(published), "--chart", str(files[1]), "--apply"]) == 1
    assert "expected .organ" in capsys.readouterr().err


def test_the_limit_of_a_step_is_that_of_its_integrator(organ):
    own = find_configuration(organ)
    solid = replace(own, kind="solid", constants="tissue", tetrahedra=300)

    euler = find_steps(organ, make_row(organ, 1, solid))
    scene = advise.compile_choice(organ, solid)
    longest = palpate.stable_step(scene.bodies[0].tissue)
    assert euler.limit == pytest.approx(longest / 0.9)
    assert euler.count == scene.bodies[0].substeps
    rk4 = find_steps(organ, make_row(organ, 1, replace(solid, integrator="runge_kutta_4")))
    assert np.isfinite(rk4.limit) and rk4.limit != euler.limit
    for free in (replace(solid, integrator="implicit_euler", substeps=1),
                 replace(solid, kind="linear_solid")):  # fmt: skip
        assert find_steps(organ, make_row(organ, 1, free)).limit == np.inf


def test_what_no_longer_builds_is_a_sentence(organ):
    row = make_row(organ, 1, replace(find_configuration(organ), vertices=10_000))

    with pytest.raises(AdviseError, match="cannot be built any more"):
        find_steps(organ, row)


def test_the_held_out_path_is_the_one_that_was_committed_before_the_advisor():
    path = read_held_out(advise.HELD_OUT)

    assert (path.presses, path.speed_m_per_s) == (2, 0.015)
    assert [step.part_of_depth for step in path.steps] == [0.35, 0.85, 0.5]
    assert path.directions[0] == (-0.55, 0.62, 0.56) and len(path.directions) == 6


@pytest.mark.landing
def test_a_chart_is_drawn_kept_and_its_choice_scored(tmp_path):
    from charted import list_few, make_block
    from palpate_editor.chart_session import draw_kept_chart

    block = make_block()
    few, shown, stages = list_few(block), [], []
    chart = draw_kept_chart(block, 1, "a.organ", lambda stage, share: stages.append(share),
                            shown=shown.append, cache=tmp_path, configurations=few)  # fmt: skip
    assert chart.complete and len(chart.rows) == len(few)
    assert stages == sorted(stages) and stages[-1] == 1.0
    assert [len(part.rows) for part in shown] == sorted(len(part.rows) for part in shown)

    advised = advise_organ(block, chart, LOOSE, cache=tmp_path / "truths")
    score = advised.score
    assert advised.advice.fits and score.presses
    assert 0.0 < score.errors.force_rms < 1.0 and score.p99 > 0.0
    assert score.presses[0].depth == pytest.approx(0.1 * score.presses[0].thickness)
    said = "\n".join(describe_advised(advised, chart, block))
    assert "held out from the choice" in said

    other = replace(block, model=replace(block.model, contact_law="hard"))
    again = draw_kept_chart(other, 1, "a.organ", cache=tmp_path,
                            configurations=[few[1], few[0], *few[2:]])  # fmt: skip
    assert again.key == chart.key  # whatever it is simulated as
    assert again.rows[0].total == chart.rows[1].total and again.rows[0].cost == chart.rows[1].cost


@pytest.mark.landing
def test_a_shipped_solid_is_charted_with_its_far_field_and_without(tmp_path):
    from palpate_editor.chart_session import draw_kept_chart
    from palpate_editor.shipped import make_organ

    spleen = make_organ("spleen")
    own = find_configuration(spleen)
    assert own.far_field == "fine"

    chart = draw_kept_chart(
        spleen, 1, "a.organ", cache=tmp_path, configurations=[own, replace(own, far_field="mesh")]
    )

    fine, mesh = (row.total for row in chart.rows)
    assert fine.force_rms < 0.7 * mesh.force_rms < 0.1


def test_a_chart_of_another_solid_is_refused_though_all_its_constants_are_the_same(organ):
    solid = replace(
        organ,
        model=replace(organ.model, kind="solid", constants="tissue"),
        fill=replace(organ.fill, tetrahedra=300),
    )
    own = make_row(solid, 0, find_configuration(solid))
    chart = replace(make_chart(solid, 1), rows=(own,))
    count = len(compile_organ(solid).bodies[0].tissue.mass)

    require_chart_of(with_particles(chart, count), solid)
    with pytest.raises(AdviseError, match=f"filled with {count + 7} particles, expected one of"):
        require_chart_of(with_particles(chart, count + 7), solid)


def with_particles(chart, count: int):
    [row] = chart.rows
    return replace(chart, rows=(replace(row, counts=replace(row.counts, particles=count)),))
