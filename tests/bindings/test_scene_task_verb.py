# SPDX-License-Identifier: BSD-3-Clause
"""`palpate scene task`: a layout keeps its judged task, and what it publishes has it."""

from __future__ import annotations

import json
from pathlib import Path

import palpate
import pytest
from palpate.cli.main import main
from test_layout import write_organ
from test_scene_verb import say


@pytest.fixture
def task(tmp_path, capsys) -> tuple[Path, Path]:
    """A layout of two organs apart, and a task of touching the second."""
    organ, path = write_organ(tmp_path), tmp_path / "two.layout.json"
    say(capsys, "new", "-o", path, "--title", "Two")
    say(capsys, "add", path, organ, "--name", "low")
    say(capsys, "add", path, organ, "--name", "high", "--at", "0,0,100")
    scene, made = tmp_path / "two.palpate", tmp_path / "two.task.json"
    assert say(capsys, "publish", path, "-o", scene)["code"] == 0
    assert main(["scenario", "new", str(scene), "--title", "Touch it", "-o", str(made)]) == 0
    words = ["--add", "touch", "--at", "region:high/top"]
    assert main(["scenario", "step", str(made), *words]) == 0
    capsys.readouterr()
    return path, made


def test_a_layout_takes_a_task_publishes_it_and_gives_it_back(task, tmp_path, capsys):
    layout, made = task
    assessment = json.loads(made.read_text(encoding="utf-8"))

    told = say(capsys, "task", layout, made)

    assert told["assessment"] == assessment
    out, back = tmp_path / "judged.palpate", tmp_path / "back.task.json"
    assert say(capsys, "publish", layout, "-o", out)["code"] == 0
    found = palpate.scenario.read(out)
    assert json.loads(found.assessment)["steps"] == assessment["steps"]
    assert found.title == "Touch it"
    assert main(["scenario", "check", str(out)]) == 0
    capsys.readouterr()
    before = layout.read_bytes()
    say(capsys, "undo", layout)
    say(capsys, "redo", layout)
    assert main(["scene", "task", str(layout), "--write", str(back)]) == 0
    assert json.loads(back.read_text(encoding="utf-8")) == assessment
    assert layout.read_bytes() == before
    capsys.readouterr()
    assert say(capsys, "task", layout, "--remove")["assessment"] is None


def test_what_is_wrong_with_a_task_is_told_with_the_scene(task, capsys):
    layout, made = task
    say(capsys, "task", layout, made)
    say(capsys, "place", layout, "high", "--remove")

    told = say(capsys, "check", layout, "--quick")

    assert told["code"] == 1
    (problem,) = [each for each in told["problems"] if each["where"].startswith("task: ")]
    assert problem["severity"] == "error"
    assert "high" in problem["message"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], "expected one of them"),
        (["two.task.json", "--remove"], "expected one of them"),
        (["--write", "new.json"], "task: got none"),
        (["two.task.json", "--write", "new.json"], "expected one or the other"),
        (["two.layout.json"], "no palpate_scenario"),
    ],
    ids=["none", "both", "nothing to write", "write and change", "no assessment"],
)
def test_what_cannot_be_done_with_a_task_is_refused(words, said, task, capsys, monkeypatch):
    layout, _ = task
    monkeypatch.chdir(layout.parent)
    before = layout.read_bytes()

    assert main(["scene", "task", str(layout), *words]) != 0

    assert said in capsys.readouterr().err
    assert layout.read_bytes() == before
