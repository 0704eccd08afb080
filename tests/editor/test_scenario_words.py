# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Scenario stage does, its log says as a verb that does the very same to a file."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from palpate.assessment import author, author_tools, author_values
from palpate.cli.main import main
from palpate_editor.views.scenario.verb_words import (
    SAYINGS,
    find_words,
    list_new_places,
    say_place,
)


def made() -> author.Json:
    new = author.new_assessment("organ", {"en": "Mine", "tr": "Benim"})
    new, at = author.add_place(new, "middle", {"region": "organ/middle"})
    new, _ = author.add_step(new, "touch", at)
    new, _ = author.add_step(new, "hold", at)
    new, _ = author.add_limit(new, "force")
    new = author_tools.set_kind(new, "left", "probe")
    new = author_tools.set_kind(new, "right", "grasper")
    new = author_values.add_level(new, "hard")
    new = author_values.set_parameter(new, "most", {"unit": "N", "value": 1.0})
    return author_values.set_level_value(new, "most", "hard", 0.7)


CHANGES = [
    (author.change_step, "hold", {"force_N": [0.2, 0.6], "for_s": 1.5}),
    (author.change_step, "hold", {"force_N": [None, "$most"], "for_s": None}),
    (author.change_step, "hold", {"depth_m": [0.004, None], "force_N": None}),
    (author.change_step, "touch", {"do": "push"}),
    (author.duplicate_step, "hold"),
    (author.move_step, "hold", 0),
    (author.mute_step, "hold", True),
    (author.mute_step, "hold", False),
    (author.remove_step, "touch"),
    (author.change_limit, "force", {"above": 2.25}),
    (author.change_limit, "force", {}, "end"),
    (author.remove_limit, "force"),
    (author.set_text, "title", "tr", "Başka"),
    (author_tools.set_kind, "right", "ball"),
    (author_tools.set_tool, "right", {"friction": 0.6, "grip_force_N": 4.0}),
    (author_tools.remove_tool, "right"),
    (author_tools.give_step, "touch", "right"),
    (author_values.set_time, 42.5),
    (author_values.add_level, "easy"),
    (author_values.remove_level, "hard"),
    (author_values.set_parameter, "deep", {"unit": "m", "value": 0.005}),
    (author_values.set_parameter, "most", {"uniform": [0.5, 1.25]}),
    (author_values.set_parameter, "most", {"choose": [0.5, 1.25]}),
    (author_values.set_level_value, "most", "hard", 0.25),
    (author_values.set_level_value, "most", "hard", None),
    (author_values.remove_parameter, "most"),
    (author_values.rename_parameter, "most", "peak"),
    (author_values.use_in_limit, "force", "most", "N"),
]


def test_every_change_that_has_words_is_tried_here():
    assert {change[0] for change in CHANGES} == set(SAYINGS)


@pytest.mark.parametrize("change", CHANGES, ids=lambda change: f"{change[0].__name__} {change[1:]}")
def test_the_verb_does_what_the_stage_does(change, tmp_path):
    act, *arguments = change
    before = made()
    after = act(before, *arguments)
    after = after[0] if isinstance(after, tuple) else after
    path = tmp_path / "task.json"
    path.write_text(json.dumps(before), encoding="utf-8")

    verb, *words = find_words(act, tuple(arguments))

    assert main(["scenario", verb, str(path), *map(str, words)]) == 0
    assert json.loads(path.read_text(encoding="utf-8")) == after


@pytest.mark.parametrize(
    "place",
    [
        {"region": "organ/lower pole"},
        {"organ": "organ", "ball": [0.01, -0.02, 0.003, 0.01]},
        {"organ": "organ", "path": [[0.01, 0.0, 0.0], [-0.02, 1e-05, 0.0]]},
    ],
)
def test_a_new_place_is_said_before_the_step_that_is_there(place, tmp_path: Path):
    before = made()
    after, name = author.add_place(before, "new", place)
    path = tmp_path / "task.json"
    path.write_text(json.dumps(before), encoding="utf-8")

    ((said, row),) = list_new_places(before, after)

    assert (said, row) == (name, place)
    at = f"--at={say_place(place)}"
    assert main(["scenario", "place", str(path), "--set", said, at]) == 0
    assert json.loads(path.read_text(encoding="utf-8")) == after
