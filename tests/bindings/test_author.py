# SPDX-License-Identifier: BSD-3-Clause
"""Assessments written step by step, as functions and from the command line."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import pytest
from palpate import scenario
from palpate.assessment import author
from palpate.assessment.author import AuthorError
from palpate.assessment.check import find_problems
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.cli.main import main

PUBLISHED = Path(__file__).resolve().parents[2] / "meshes" / "published"
TITLES = {"en": "Mine", "tr": "Benim"}


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
    for verb in author.VERBS:
        at = line if verb == "trace" else None if verb == "release" else "middle"
        new, _ = author.add_step(new, verb, at)
    places = {"contact": "middle", "clearance": ball, "path.off": line}
    for measure in author.MEASURES:
        values = {"place": places[measure]} if measure in places else {}
        new, _ = author.add_limit(new, measure, values)

    drawn = scenario.draw_task(with_assessment("mine", new, organ))

    assert len(drawn.steps) == 2 + len(author.VERBS)
    assert len(drawn.limits) == 1 + len(author.MEASURES)


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
