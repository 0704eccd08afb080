# SPDX-License-Identifier: BSD-3-Clause
"""Assessments written step by step, as functions and from the command line."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import palpate
import pytest
from palpate import scenario
from palpate.assessment import author, author_tools, author_values
from palpate.assessment.author import AuthorError
from palpate.assessment.check import find_problems
from palpate.assessment.check_parts import find_all_problems
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.cli.main import main
from palpate.files.refusal import Refusal

PUBLISHED = Path(__file__).resolve().parents[2] / "meshes" / "published"
TITLES = {"en": "Mine", "tr": "Benim"}
OF_OBJECTS = ("loose", "out_of_view", "object_force")
"""Measures of scenes with stones and cameras (test_object_tasks)."""
OF_GRASPERS = ("pad_pressure", "torn")


def made() -> author.Json:
    new = author.new_assessment("simple tissue", TITLES)
    new, middle = author.add_place(new, "middle", {"region": "simple-tissue/middle"})
    new, _ = author.add_step(new, "touch", middle)
    new, _ = author.add_step(new, "hold", middle)
    new, _ = author.add_limit(new, "force")
    return new


def test_what_is_written_can_be_judged_and_has_no_problems():
    organ = scenario.read(PUBLISHED / "simple_tissue.palpate")

    published = with_assessment("mine", made(), organ)

    assert find_problems(published) == []
    assert scenario.draw_task(published).steps == ["touch", "hold"]
    assert json.loads(published.assessment)["texts"]["tr"]["step-touch"] == "Dokunun: middle"


def test_every_verb_and_measure_is_taken_by_the_reader():
    organ = scenario.read(PUBLISHED / "simple_tissue.palpate")
    new = made()
    new, line = author.add_place(new, "line", {"organ": "simple-tissue",
                                               "path": [[0, 0, 0], [0.01, 0, 0]]})  # fmt: skip
    new, ball = author.add_place(new, "spot", {"organ": "simple-tissue", "ball": [0, 0, 0, 0.01]})
    verbs = [verb for verb in author.VERBS if verb not in (*author.SPACES, *author.SEEING)]
    for verb in verbs:
        at = line if verb == "trace" else None if verb == "release" else "middle"
        new, _ = author.add_step(new, verb, at)
    places = {"contact": "middle", "clearance": ball, "path.off": line}
    measures = [each for each in author.MEASURES if each not in (*OF_OBJECTS, *OF_GRASPERS)]
    for measure in measures:
        values = {"place": places[measure]} if measure in places else {}
        new, _ = author.add_limit(new, measure, values)

    drawn = scenario.draw_task(with_assessment("mine", new, organ))

    assert len(drawn.steps) == 2 + len(verbs)
    assert len(drawn.limits) == 1 + len(measures)


def test_a_task_watches_the_jaws_of_a_grasper_and_whether_tissue_has_torn():
    organ = scenario.read(PUBLISHED / "gallbladder.palpate")
    new = read_assessment(PUBLISHED.parent / "scenarios" / "gallbladder_grasp.json")
    for measure in OF_GRASPERS:
        new, _ = author.add_limit(new, measure)
    assert [limit["when"] for limit in new["limits"][-2:]] == [
        {"measure": "pad_pressure", "above": 330e3},
        {"measure": "torn"},
    ]

    with pytest.raises(Refusal, match="no tissue of the scene has a tear_stretch"):
        with_assessment("mine", new, organ)
    organ.scene.bodies[0].tear_stretch = 1.6
    drawn = scenario.draw_task(with_assessment("mine", new, organ))

    measures = [limit.measure for limit in drawn.task.limits[-2:]]
    assert measures == [palpate.TaskMeasure.pad_pressure, palpate.TaskMeasure.torn]


def test_no_change_changes_what_it_began_with():
    before = made()
    kept = copy.deepcopy(before)
    author.change_step(before, "hold", {"force_N": [0.2, 0.3]})
    author.duplicate_step(before, "hold")
    author.move_step(before, "hold", 0)
    author.mute_step(before, "touch", True)
    author.remove_step(before, "touch")
    author.change_limit(before, "force", {"above": 2.0})
    author.remove_limit(before, "force")
    author.set_text(before, "title", "en", "Other")

    assert before == kept


def test_a_default_sentence_follows_its_step_until_the_author_replaces_it():
    new = author.change_step(made(), "hold", {"force_N": [0.2, 0.35]})
    assert new["texts"]["en"]["step-hold"] == "Press and hold: middle, 0.2 to 0.35 N, for 2 s"
    assert new["texts"]["tr"]["step-hold"].endswith("0,2 ile 0,35 N arası, 2 s boyunca")

    new = author.set_text(new, "step-hold", "en", "Lightly")
    new = author.change_step(new, "hold", {"force_N": [0.1, 0.2]})
    assert new["texts"]["en"]["step-hold"] == "Lightly"


def test_steps_are_ordered_duplicated_muted_and_removed():
    new, again = author.duplicate_step(made(), "hold")
    assert [step["id"] for step in new["steps"]] == ["touch", "hold", again]
    new = author.move_step(new, again, 0)
    new = author.change_step(new, "touch", {"after": ["hold"]})
    new = author.mute_step(new, "hold", True)
    published = author.without_muted(new)
    assert [step["id"] for step in published["steps"]] == [again, "touch"]
    assert published["steps"][1]["after"] == []
    assert "muted" not in json.dumps(published)
    new = author.remove_step(new, again)
    assert f"step-{again}" not in new["texts"]["en"]
    with pytest.raises(AuthorError, match="expected one of touch, hold"):
        author.remove_step(new, again)


def test_another_verb_asks_for_what_is_usual_of_it():
    new = author.change_step(made(), "hold", {"do": "push"})
    step = new["steps"][1]
    assert step["do"] == "push"
    assert "force_N" not in step
    assert step["depth_m"] == author.USUAL["push"]["depth_m"]


def test_the_verbs_write_a_scenario_that_can_be_published(tmp_path, capsys):
    organ, task = PUBLISHED / "spleen.palpate", tmp_path / "task.json"
    out = tmp_path / "task.palpate"

    def call(*arguments: str) -> int:
        return main(["scenario", *arguments])

    assert call("new", str(organ), "-o", str(task), "--title", "Mine", "--title-tr", "Benim") == 0
    assert "lower pole" in capsys.readouterr().out
    step = ["step", str(task)]
    assert call(*step, "--add", "push", "--at", "region:lower pole", "--depth", "4mm..7mm") == 0
    assert call(*step, "--duplicate", "push") == 0
    assert call(*step, "--change", "push-2", "--force", "0.2N..", "--say", "Harder") == 0
    assert call(*step, "--move", "push-2", "--to", "1") == 0
    assert call(*step, "--mute", "push") == 0
    assert call("limit", str(task), "--add", "force", "--above", "2.5") == 0
    assert call("limit", str(task), "--add", "contact", "--at", "region:hilum",
                "--then", "warn") == 0  # fmt: skip
    assert call("publish", str(organ), str(task), "-o", str(out)) == 0
    drawn = scenario.draw_task(scenario.read(out))
    assert drawn.steps == ["push-2"]
    assert drawn.task.steps[0].force.least == 0.2
    assert drawn.task.limits[0].bound == 2.5
    assert read_assessment(task)["texts"]["en"]["step-push-2"] == "Harder"

    before = task.read_bytes()
    assert call(*step, "--change", "nobody") == 2
    assert call(*step, "--add", "push") == 2
    assert call(*step, "--add", "push", "--at", "nowhere") == 2
    assert call(*step, "--move", "push") == 2
    assert task.read_bytes() == before


def test_a_self_play_and_a_review_travel_with_the_file_and_are_void_after_a_change(
    tmp_path, capsys, monkeypatch
):
    organ = scenario.read(PUBLISHED / "simple_tissue.palpate")
    plain, played, reviewed = (tmp_path / f"{n}.palpate" for n in ("plain", "played", "reviewed"))
    scenario.write(plain, with_assessment("mine", made(), organ))
    monkeypatch.setattr("palpate.assessment.selfplay.HANDS", ("idle",))
    assert main(["scenario", "selfplay", str(plain), "--seeds", "1", "-o", str(played)]) == 0
    assert main(["scenario", "review", str(played), "--of", "task", "--by", "A. B.",
                 "--role", "surgeon", "-o", str(reviewed)]) == 0  # fmt: skip
    read = scenario.read(reviewed)
    kept = json.loads(read.assessment)
    assert kept["selfplay"]["attempts"][0]["outcome"] == "timed_out"
    assert kept["reviews"][0]["content_sha256"] == kept["selfplay"]["content_sha256"]
    # neither changes what is judged, nor what a record is held against
    before = scenario.draw_task(scenario.read(plain))
    assert scenario.draw_task(read).sha256 == before.sha256
    assert find_problems(read) == []

    changed = author.change_step(kept, "hold", {"for_s": 1.0})
    problems = find_problems(with_assessment("mine", changed, organ))
    assert {(p.severity, p.where) for p in problems} == {
        ("warning", "selfplay"), ("warning", "reviews[0]"),
    }  # fmt: skip


def test_a_scenario_without_a_limit_can_be_judged():
    organ = scenario.read(PUBLISHED / "simple_tissue.palpate")
    never, at = author.add_place(author.new_assessment("simple tissue", TITLES), "middle",
                                 {"region": "simple-tissue/middle"})  # fmt: skip
    never, _ = author.add_step(never, "touch", at)
    for new in (never, author.remove_limit(made(), "force")):
        assert scenario.draw_task(with_assessment("mine", new, organ)).limits == []


def test_levels_and_parameters_are_drawn_as_they_were_set():
    organ = scenario.read(PUBLISHED / "simple_tissue.palpate")
    new = made()
    for level in ("normal", "hard"):
        new = author_values.add_level(new, level)
    new = author_values.set_parameter(new, "least", {"unit": "N", "value": 0.2})
    new = author_values.set_level_value(new, "least", "hard", 0.3)
    new = author_values.set_parameter(new, "bound", {"unit": "N", "uniform": [1.0, 2.0]})
    new = author_values.use_in_step(new, "hold", "force_N", 0, "least")
    new = author_values.use_in_limit(new, "force", "bound", "N")
    made_of = with_assessment("mine", new, organ)

    normal, hard = (scenario.draw_task(made_of, level) for level in ("normal", "hard"))

    assert (normal.task.steps[1].force.least, hard.task.steps[1].force.least) == (0.2, 0.3)
    bounds = [scenario.draw_task(made_of, "hard", seed).task.limits[0].bound for seed in range(9)]
    assert len(set(bounds)) == 9 and 1.0 <= min(bounds) < max(bounds) <= 2.0


def test_what_is_used_cannot_be_taken_away():
    new = author_values.set_parameter(made(), "least", {"unit": "N", "value": 0.2})
    new = author_values.use_in_step(new, "hold", "force_N", 0, "least")
    with pytest.raises(AuthorError, match="used by step hold"):
        author_values.remove_parameter(new, "least")
    with pytest.raises(AuthorError, match="that of step touch"):
        author_values.remove_place(new, "middle")
    freed = author.change_step(new, "hold", {"force_N": [0.1, 0.4]})
    assert "parameters" not in author_values.remove_parameter(freed, "least")


@pytest.mark.parametrize(
    ("act", "said"),
    [
        (lambda a: author_values.set_parameter(a, "x", {"unit": "kg", "value": 1.0}), "unit"),
        (lambda a: author_values.set_parameter(a, "x", {"unit": "N"}), "no value"),
        (lambda a: author_values.set_parameter(a, "X Y", {"unit": "N", "value": 1.0}), "small"),
        (lambda a: author_values.set_level_value(a, "p", "hard", 1.0), "none yet"),
        (lambda a: author_values.use_in_step(a, "hold", "depth_m", 0, "p"), "unit N, expected m"),
        (lambda a: author_values.add_level(author_values.add_level(a, "x"), "x"), "once more"),
        (lambda a: author_values.remove_level(a, "x"), "none yet"),
        (lambda a: author_values.remove_parameter(a, "q"), "expected one of p"),
        (lambda a: author_values.set_time(a, 0.0), "more than 0"),
        (lambda a: author_values.set_time(a, float("nan")), "more than 0"),
    ],
)
def test_a_value_that_cannot_be_is_refused(act, said):
    new = author_values.set_parameter(made(), "p", {"unit": "N", "value": 0.2})
    with pytest.raises(AuthorError, match=said):
        act(new)


def test_a_level_goes_with_its_values():
    new = author_values.add_level(made(), "hard")
    new = author_values.set_parameter(new, "p", {"unit": "N", "value": 0.2})
    new = author_values.set_level_value(new, "p", "hard", 0.3)
    gone = author_values.remove_level(new, "hard")
    assert "levels" not in gone and gone["parameters"]["p"] == {"unit": "N", "value": 0.2}


def test_every_action_of_the_stage_is_a_verb(tmp_path, capsys):
    organ, task = PUBLISHED / "simple_tissue.palpate", tmp_path / "task.json"
    out = tmp_path / "task.palpate"
    record = tmp_path / "run.prec"

    def call(*arguments: str) -> int:
        return main(["scenario", *map(str, arguments)])

    assert call("new", organ, "-o", task, "--title", "Mine", "--title-tr", "Benim") == 0
    assert call("place", task, "--set", "spot", "--at", "region:middle") == 0
    assert call("step", task, "--add", "hold", "--at", "spot") == 0
    assert call("level", task, "--add", "normal") == 0
    assert call("level", task, "--add", "hard") == 0
    assert call("parameter", task, "--set", "most", "--unit", "N", "--value", "1.5",
                "--level", "hard=1") == 0  # fmt: skip
    assert call("limit", task, "--add", "force", "--above", "$most") == 0
    assert call("step", task, "--change", "hold", "--force", "0.1N..$most") == 0
    assert call("time", task, "45s") == 0
    assert call("text", task, "title", "Başlık", "--in", "tr") == 0
    assert call("publish", organ, task, "-o", out) == 0
    drawn = scenario.draw_task(scenario.read(out), "hard")
    assert (drawn.task.time_limit, drawn.task.limits[0].bound) == (45.0, 1.0)
    assert drawn.task.steps[0].force.most == 1.0
    assert read_assessment(task)["texts"]["tr"]["title"] == "Başlık"

    script = tmp_path / "press.json"
    keys = [(0.0, 0.02), (0.5, 0.006), (1.5, 0.006), (2.0, 0.02)]
    top = scenario.read(organ).scene.bodies[0].tissue.rest_position[:, 2].max()
    frames = [{"time": time, "position": [0.0, 0.0, top + height]} for time, height in keys]
    script.write_text(
        json.dumps({"format": "palpate script", "version": 1, "frames": frames}), encoding="utf-8"
    )
    assert main(["play", str(organ), "--headless", "--device", f"script:{script}",
                 "--record", str(record)]) == 0  # fmt: skip
    assert call("record", task, "hold", record, organ) == 0
    least, most = read_assessment(task)["steps"][0]["force_N"]
    assert most == pytest.approx(1.5 * least, rel=0.01)

    before = task.read_bytes()
    assert call("record", task, "nothing", record, organ) == 2
    assert call("place", task, "--remove", "spot") == 2
    assert call("place", task, "--set", "spot") == 2
    assert call("text", task, "nothing", "x") == 2
    assert call("parameter", task, "--set", "most", "--level", "easy=1") == 2
    assert task.read_bytes() == before

    assert call("tool", task, "--set", "second", "--kind", "probe") == 0
    second = author_tools.give_step(read_assessment(task), "hold", "second")
    task.write_text(json.dumps(second), encoding="utf-8")
    capsys.readouterr()
    assert call("record", task, "hold", record, organ) == 2  # the band would be the first's
    assert "expected number 2, with which the step is done" in capsys.readouterr().err


def test_check_lists_what_is_wrong_with_every_part_at_once(tmp_path, capsys):
    organ = scenario.read(PUBLISHED / "simple_tissue.palpate")
    new = made()
    new["steps"][0]["at"] = "nowhere"
    new["steps"][1]["force_N"] = [0.4, 0.1]
    new["steps"].append({"id": "odd", "do": "carve", "at": "middle", "say": "title"})
    new["steps"].append({**new["steps"][1], "force_N": [0.1, 0.4], "after": ["nobody"]})
    new["limits"][0]["when"]["above"] = "$unknown"
    del new["texts"]["tr"]["step-touch"]

    found = find_all_problems("mine", new, organ)

    where = [each.where for each in found]
    for part in ("steps[0]", "steps[1]", "steps[2]", "steps[3].after", "steps[3].id", "limits[0]",
                 "texts.tr.step-touch"):  # fmt: skip
        assert any(each.startswith(part) for each in where), (part, where)
    path = tmp_path / "task.json"
    path.write_text(json.dumps(new), encoding="utf-8")
    call = ["scenario", "check", str(path), "--organ", str(PUBLISHED / "simple_tissue.palpate")]
    assert main(call) == 1
    assert capsys.readouterr().out.count("error:") >= 6
    assert find_all_problems("mine", made(), organ) == []


def problems_of(new: author.Json) -> list[str]:
    organ = scenario.read(PUBLISHED / "simple_tissue.palpate")
    found = find_problems(with_assessment("mine", new, organ))
    return [f"{each.severity} {each.where}: {each.message}" for each in found]


def test_a_place_where_no_hand_gets_is_a_problem():
    new, far = author.add_place(made(), "far", {"organ": "simple-tissue",
                                                "ball": [0, 0, 0.2, 0.01]})  # fmt: skip
    new, line = author.add_place(new, "line", {"organ": "simple-tissue",
                                               "path": [[0, 0, 0], [0, 0, 0.1]]})  # fmt: skip
    new, _ = author.add_step(new, "touch", far)
    new, _ = author.add_step(new, "trace", line)
    said = problems_of(new)
    assert any(row.startswith("error steps.touch-2: its ball lies") for row in said)
    assert any(row.startswith("error steps.trace: its path lies") for row in said)
    assert any(row.startswith("warning steps.touch-2: its place lies") for row in said)


def test_a_limit_beyond_the_coupling_and_a_step_overdue_at_once_are_problems():
    new = author.change_limit(made(), "force", {"above": 5.0})
    new = author.change_step(new, "hold", {"within_s": 1.0, "for_s": 2.0})
    new["goals"].append({"metric": "time", "at_most": 60.0, "basis": {"kind": "designer"}})
    said = problems_of(new)
    assert "error limits.force: is at 5 N, and the coupling gives 5 N at most" in said
    assert "error steps.hold: lasts 2 s, and is an error after 1 s" in said
    assert any(row.startswith("warning goals[1]: is at most 60 s") for row in said)
