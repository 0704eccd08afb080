# SPDX-License-Identifier: GPL-3.0-or-later
"""An organ with a task is published once hands have played it, with what they came to."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from palpate import scenario
from palpate.assessment import author, author_values
from palpate.assessment.author import Json
from palpate.assessment.provenance import find_void
from palpate.assessment.selfplay import SEEDS, Attempt
from palpate.cli.main import main
from palpate_editor.check import assess
from palpate_editor.document import Organ
from palpate_editor.document.files import write_organ
from palpate_editor.open_organ import open_organ
from palpate_editor.publish import PublishError, publish

TISSUE = Path(__file__).resolve().parents[2] / "meshes" / "published" / "simple_tissue.organ"


def touch_it() -> Json:
    """The middle is touched, without pressing hard."""
    made = author.new_assessment("organ", {"en": "Mine", "tr": "Benim"})
    made, at = author.add_place(made, "middle", {"region": "organ/middle"})
    made, _ = author.add_step(made, "hold", at, {"force_N": [0.1, 0.5], "for_s": 0.2})
    made, _ = author.add_limit(made, "force", {"above": 1.0})
    return author_values.set_time(made, 4.0)


def with_task(made: Json) -> Organ:
    return replace(open_organ(TISSUE), assessment=json.dumps(made))


@pytest.mark.landing
def test_the_report_of_the_hands_travels_in_the_file_and_is_not_made_twice(tmp_path):
    organ, played = with_task(touch_it()), []

    publish(organ, tmp_path / "a.palpate", tell=played.append)

    made = scenario.read(tmp_path / "a.palpate")
    tried = json.loads(made.assessment)["selfplay"]
    assert len(played) == len(tried["attempts"]) == 3 * SEEDS + 1
    assert find_void(made) == []
    again: list[Attempt] = []
    publish(organ, tmp_path / "b.palpate", tried=tried, tell=again.append)
    assert again == []
    assert json.loads(scenario.read(tmp_path / "b.palpate").assessment)["selfplay"] == tried

    changed = with_task(author_values.set_time(touch_it(), 4.5))
    publish(changed, tmp_path / "c.palpate", tried=tried, tell=again.append)
    assert len(again) == len(played)


@pytest.mark.landing
def test_what_a_careful_hand_cannot_finish_is_not_published(tmp_path, capsys):
    made = author.change_step(touch_it(), "hold", {"force_N": [0.70, 0.71], "for_s": 1.0})
    organ = with_task(made)
    with pytest.raises(PublishError) as refused:
        publish(organ, tmp_path / "a.palpate", assess(organ))
    assert {problem.stage for problem in refused.value.problems} == {"scenario"}
    assert "careful hand should finish" in str(refused.value)
    assert not (tmp_path / "a.palpate").exists()

    write_organ(tmp_path / "a.organ", organ)
    out = tmp_path / "b.palpate"
    assert main(["publish", str(tmp_path / "a.organ"), "-o", str(out)]) == 1
    assert "careful hand should finish" in capsys.readouterr().out
    assert not out.exists()


def test_an_organ_without_a_task_is_played_by_nobody(tmp_path):
    played: list[Attempt] = []
    publish(open_organ(TISSUE), tmp_path / "a.palpate", tell=played.append)
    assert played == []
    assert not scenario.read(tmp_path / "a.palpate").assessment
