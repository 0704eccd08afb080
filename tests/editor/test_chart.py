# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of an organ: its rows, where they run, what is kept of them, and its verb."""

from __future__ import annotations

import json
import signal
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from charted import BALL, list_few, make_block, make_plan, make_truth
from palpate.cli.main import main
from palpate.files.refusal import Refusal
from palpate.study.chart_file import read_chart
from palpate.study.scene_chart import ALARM, LOST, RAN, REFUSED
from palpate.study.track import run_track, set_course
from palpate.study.truth_file import write_truth
from palpate_editor import job_pool
from palpate_editor.chart import compute_key, draw_chart
from palpate_editor.chart_jobs import (
    Converged,
    Job,
    compile_row,
    find_converged,
    list_hand,
    open_document,
    run_job,
)
from palpate_editor.chart_pool import run_here, run_in_processes
from palpate_editor.chart_rerun import rerun_chart
from palpate_editor.chart_store import Store
from palpate_editor.compile import compile_organ
from palpate_editor.configuration import apply_configuration, find_configuration
from palpate_editor.configurations import list_configurations
from palpate_editor.document.files import write_organ


@pytest.fixture(scope="module")
def plan():
    return make_plan()


@pytest.fixture(scope="module")
def chart(plan):
    return draw_chart(plan, configurations=list_few(open_document(plan.organ)))


def without_costs(chart):
    return [replace(row, cost=None) for row in chart.rows]


@pytest.mark.landing
def test_every_row_has_errors_counts_and_a_cost_or_a_reason(chart):
    assert [row.outcome for row in chart.rows] == [RAN, RAN, RAN, RAN, RAN, REFUSED]
    for row in chart.list_ran():
        assert 0.0 < row.total.force_rms <= row.total.force_most
        assert 0.0 <= row.time.force_rms < row.model.force_rms
        assert 0.0 < row.total.displacement < 1.0
        assert row.counts.particles > 0 and row.counts.elements > 0 and row.counts.substeps >= 3
        assert row.cost.least <= row.cost.median <= row.cost.most <= row.cost.p99
        assert row.jump > 0.0 and row.force > 0.0
    assert "wall_thickness" in chart.rows[-1].reason
    assert chart.complete and chart.rows[0].own and not any(row.own for row in chart.rows[1:])


def test_explicit_integrators_evaluate_all_forces_as_often_as_they_are_known_to(chart):
    euler, runge = (
        next(row for row in chart.rows if row.configuration.integrator == name)
        for name in ("symplectic_euler", "runge_kutta_4")
    )

    assert euler.counts.evaluations == pytest.approx(euler.counts.substeps, rel=0.5)
    assert runge.counts.evaluations % 1.0 >= 0.0
    assert runge.counts.evaluations >= 4 * 3


def test_a_run_is_held_against_the_truth_where_the_tool_itself_is(plan):
    """A hand on a soft spring stays behind: the error is that of the tissue all the same."""
    organ = open_document(plan.organ)
    own = find_configuration(organ)
    felt, deepest = [], []
    for coupling in (1000.0, 60.0):
        softer = replace(organ, hand=replace(organ.hand, coupling=coupling))
        scene = compile_row(softer, own)
        course = set_course(scene, plan.truth)
        track = run_track(scene, course, list_hand(plan, scene, course))
        down = slice(0, int(track.depth.argmax()) + 1)
        felt.append(np.interp(0.8e-3, track.depth[down], track.along[down]))
        deepest.append(track.depth.max())

    assert deepest[1] < 0.8 * deepest[0]
    assert felt[1] == pytest.approx(felt[0], rel=0.1)


def test_a_truth_that_is_twice_as_stiff_leaves_half_of_the_force(plan):
    organ = open_document(plan.organ)
    own = find_configuration(organ)
    twice = replace(plan, truth=replace(plan.truth, force=2.0 * plan.truth.force))

    one, other = (run_job(each, Job(0, own)).total for each in (plan, twice))

    signed = 2.0 * other.force_most  # in parts of the same force
    assert signed > one.force_most


@pytest.mark.landing
def test_errors_are_the_same_in_other_processes_and_however_many(plan, chart):
    few = list_few(open_document(plan.organ))[:3]

    found = draw_chart(plan, configurations=few, runner=run_in_processes(2))

    assert without_costs(found) == without_costs(chart)[:3]


@pytest.mark.landing
def test_a_process_that_is_killed_loses_its_own_run_only(plan, chart, tmp_path, monkeypatch):
    started = []

    class Mortal(job_pool.Worker):
        def send(self, what):
            super().send(what)
            if isinstance(what, Job) and what.number == 1 and not what.converges:
                started.append(self.process.pid)
                self.process.send_signal(signal.SIGKILL)

    few = list_few(open_document(plan.organ))[:3]
    key = compute_key(plan)
    with monkeypatch.context() as patch, Store(key, tmp_path) as store:
        patch.setattr(job_pool, "Worker", Mortal)
        found = draw_chart(plan, configurations=few, runner=run_in_processes(2), store=store)

    assert len(started) == 1
    assert [row.outcome for row in found.rows] == [RAN, LOST, RAN]
    assert "signal 9" in found.rows[1].reason
    assert [without_costs(found)[i] for i in (0, 2)] == [without_costs(chart)[i] for i in (0, 2)]
    # a second call tries it again, and nothing else
    with Store(key, tmp_path) as store:
        tried = []
        again = draw_chart(
            plan, configurations=few, store=store, told=lambda step: tried.append(step.stage)
        )
    assert tried == ["rows", "costs"]
    assert without_costs(again) == without_costs(chart)[:3]


def test_what_is_finished_is_on_the_disk_at_once_and_taken_up(plan, chart, tmp_path):
    few = list_few(open_document(plan.organ))[:3]
    key, seen = compute_key(plan), []

    def stop(step):
        seen.append(len((tmp_path / f"rows-{key[:16]}.jsonl").read_bytes().splitlines()))
        if step.stage == "rows" and step.done == 2:
            raise KeyboardInterrupt

    with Store(key, tmp_path) as store:
        part = draw_chart(plan, configurations=few, store=store, told=stop)
    path = next(tmp_path.iterdir())
    with path.open("ab") as file:
        file.write(b'{"configuration": {"kin')  # power went
    with Store(key, tmp_path) as store:
        whole = draw_chart(plan, configurations=few, store=store)

    assert seen == list(range(2, 2 + len(seen)))
    assert not part.complete and len(part.rows) == 2
    assert whole.complete and without_costs(whole) == without_costs(chart)[:3]


@pytest.mark.landing
def test_a_changed_organ_or_path_is_another_chart(plan):
    organ = open_document(plan.organ)
    keys = {compute_key(plan)}
    for change in ({"material": replace(organ.material, young_modulus=6e3)},
                   {"hand": replace(organ.hand, coupling=900.0)},
                   {"fixed": np.roll(organ.fixed, 1)}):  # fmt: skip
        keys.add(compute_key(make_plan(replace(organ, **change))))
    keys.add(compute_key(replace(plan, speed=0.01)))
    keys.add(compute_key(replace(plan, truth=replace(plan.truth, key="another"))))

    assert len(keys) == 6
    assert compute_key(make_plan(replace(organ, title="Another title"))) in keys
    assert len({compute_key(make_plan(replace(organ, title="Another title")))} | keys) == 6


@pytest.mark.parametrize(
    "line", [b"[]\n", b'{"row": 1}\n', b"no JSON\n", b'{"configuration": {}, "row": {}}\n']
)
def test_finished_runs_that_are_damaged_are_refused(plan, tmp_path, line):
    key = compute_key(plan)
    with Store(key, tmp_path):
        pass
    path = next(tmp_path.iterdir())
    path.write_bytes(path.read_bytes() + line)

    with pytest.raises(Refusal, match="line 2"):
        Store(key, tmp_path)


@pytest.mark.landing
def test_one_row_run_again_has_the_same_errors_to_the_bit(plan, chart):
    found = rerun_chart(Path("a.json"), plan, chart, run_here, every=2)

    assert [row["number"] for row in found] == [0, 2, 4]
    assert all(row["same"] and row["largest"] == 0.0 for row in found)
    total = replace(chart.rows[2].total, force_rms=chart.rows[2].total.force_rms + 1e-3)
    wrong = replace(chart, rows=(*chart.rows[:2], replace(chart.rows[2], total=total)))
    assert not rerun_chart(Path("a.json"), plan, wrong, run_here, every=2)[1]["same"]
    with pytest.raises(Refusal, match="key"):
        rerun_chart(Path("a.json"), replace(plan, speed=0.01), chart, run_here)


def test_an_alarm_is_a_row_with_its_reason(plan):
    organ = open_document(plan.organ)
    steep = replace(plan, truth=replace(plan.truth, depth=12.0 * plan.truth.depth))
    linear = replace(find_configuration(organ), kind="linear_solid")

    row = run_job(steep, Job(0, linear, converged=Converged((), None)))

    assert row.outcome == ALARM and "linear solid" in row.reason
    assert row.total is None and row.counts is not None


def test_all_configurations_of_one_model_share_the_run_that_is_converged_in_time(plan):
    organ = open_document(plan.organ)
    configurations = list_configurations(organ)

    solid = [c for c in configurations if c.kind == "solid" and c.tetrahedra == 300]
    linear = [c for c in configurations if c.kind == "linear_solid" and c.tetrahedra == 300]

    assert len({find_converged(c) for c in solid}) == 2  # by the law of contact
    assert len({find_converged(c) for c in linear}) == 3  # and one whose masses swing


def test_enough_configurations_are_tried_and_none_twice(plan):
    solid = open_document(plan.organ)
    wall = replace(solid, material=replace(solid.material, wall_thickness=2e-3),
                   model=replace(solid.model, kind="shell"))  # fmt: skip
    for organ, least in ((solid, 60), (wall, 20)):
        found = list_configurations(organ)
        assert found[0] == find_configuration(organ)
        assert len(set(found)) == len(found) >= least
        assert {c.integrator for c in found} == set(palpate.Integrator.__members__)


def test_a_configuration_can_be_what_an_organ_says(plan):
    organ = open_document(plan.organ)
    for configuration in list_few(organ):
        applied = apply_configuration(organ, configuration)
        assert (
            replace(find_configuration(applied), vertices=configuration.vertices) == configuration
        )
        assert applied.material == organ.material and applied.tool == organ.tool
        assert applied.vertex_count == (configuration.vertices or organ.vertex_count)


def test_the_verb_draws_reruns_and_refuses(plan, chart, tmp_path, capsys, monkeypatch):
    organ, truth = tmp_path / "block.organ", tmp_path / "block.truth"
    write_organ(organ, make_block())
    write_truth(truth, make_truth())
    monkeypatch.setattr("palpate_editor.chart.list_configurations", lambda o: list_few(o)[:2])
    call = ["chart", str(organ), "--truth", str(truth), "--speed", "20mm/s"]
    out = [str(tmp_path / f"a.{kind}") for kind in ("json", "png", "svg")]

    assert main([*call, "-o", out[0], "--png", out[1], "--svg", out[2], "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert without_costs(read_chart(Path(out[0]))) == without_costs(chart)[:2]
    assert report["rows"] == json.loads(
        json.dumps([asdict(r) for r in read_chart(Path(out[0])).rows])
    )
    assert Path(out[1]).read_bytes().startswith(b"\x89PNG") and "<svg" in Path(out[2]).read_text(
        encoding="utf-8"
    )
    assert main([*call, "--rerun", out[0]]) == 0
    assert "the same to the bit" in capsys.readouterr().out
    assert main([*call, "--rerun", out[0], "--png", out[1]]) == 2
    assert main([*call, "--workers", "2", "--scheduler", "tcp://127.0.0.1:1"]) == 2
    assert main([*call, "--speed", "5mm/s", "--rerun", out[0]]) == 1
    assert main(["chart", str(organ), "--truth", str(organ)]) == 1
    assert main([*call, "--path", "pull"]) == 1
    assert "got press, expected pull" in capsys.readouterr().err


def test_a_pull_has_no_force_and_no_displacement_before_it_lifts(plan):
    truth = plan.truth
    pulled = replace(
        truth, path="pull", depth=-truth.depth, force=-truth.force, displacement=-truth.displacement
    )
    course = set_course(compile_organ(open_document(plan.organ)), pulled)

    for depth in (0.0, 5e-4):  # where it takes hold; while it still presses
        assert course.find_force(0.0, depth) == 0.0
        assert not course.find_displacement(0.0, depth).any()
    assert course.find_force(0.0, -1e-3) < 0.0
    assert course.find_displacement(0.0, -1e-3).any()


def test_a_worker_that_fails_is_said_to_have_ended_by_its_own_code(plan):
    worker = job_pool.Worker(fail, plan)

    with pytest.raises(job_pool.WorkerLost, match="with code 1"):
        worker.run(None)


def fail(plan: object, job: object) -> None:
    raise RuntimeError("on purpose")


@pytest.mark.parametrize("speed", ["0mm/s", "-5mm/s"])
def test_a_hand_that_does_not_move_is_refused(tmp_path, capsys, speed):
    organ = tmp_path / "block.organ"
    write_organ(organ, make_block())

    assert main(["chart", str(organ), f"--speed={speed}"]) == 2

    said = capsys.readouterr().err
    assert f"--speed: got {speed.removesuffix('mm/s')} mm/s, expected one above 0" in said


def test_the_truth_of_another_body_is_refused(tmp_path, capsys):
    organ, truth = tmp_path / "block.organ", tmp_path / "other.truth"
    write_organ(organ, make_block())
    other = make_truth()
    write_truth(truth, replace(other, point=other.point + [0.0, 0.0, 0.05]))

    assert main(["chart", str(organ), "--truth", str(truth)]) == 1

    said = capsys.readouterr().err
    assert "other.truth: point: got a place 50 mm off the surface" in said
    assert "expected places of block.organ: it is another body's" in said


def test_the_ball_of_a_truth_is_the_organs(tmp_path, capsys):
    organ, truth = tmp_path / "block.organ", tmp_path / "block.truth"
    write_organ(organ, make_block())
    write_truth(truth, replace(make_truth(), radius=2.0 * BALL))

    assert main(["chart", str(organ), "--truth", str(truth)]) == 1
    assert "radius" in capsys.readouterr().err
