# SPDX-License-Identifier: GPL-3.0-or-later
"""Constants that are wrong by a factor of 1000: told, with the nearest value that works, and
repaired by that."""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.files.refusal import Refusal
from palpate.runs.cause import run_trial
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.run import read_scene
from palpate.scene.nearest import USUAL, find_nearest, put, read
from palpate.scene.scene_file import read_scene_file, write_scene_file
from palpate.scene.scene_parts import OrganPart, SceneFile
from palpate_editor.check import assess
from palpate_editor.compile import build_organ, compile_organ, parts_of
from palpate_editor.document import Organ
from palpate_editor.document.files import write_organ
from palpate_editor.document.problems import Problem
from palpate_editor.edits import SetConstant
from palpate_editor.open_organ import open_organ
from tiers import keep_everyday

SPRINGS = Path(__file__).resolve().parents[1] / "scenes" / "springs"
NONE = palpate.AlarmKind.none
WRONG = {
    "model.stiffness": 1e4,
    "model.home_stiffness": 1e6,
    "material.damping_ratio": 1e3,
    "model.drag": 1e5,
    "material.density": 1e-4,
    "tool.stiffness": 1e3,
    "model.pressure": 1e3,
}
"""How many times too much: 1000, or more where this organ bears that."""
BORNE = ("model.stiffness", "hand.coupling", "hand.hold_stiffness")
"""Of which it bears 1000 times as much."""


@pytest.fixture(scope="module")
def organ() -> Organ:
    organ = open_organ(SPRINGS / "spleen.palpate")
    return replace(organ, model=replace(organ.model, pressure=20.0))


def make_wrong(organ: Organ, key: str) -> Organ:
    part, field = key.split(".")
    value = WRONG[key] * getattr(getattr(organ, part), field)
    return SetConstant(part, field, value)(organ)


def bears_presses(organ: Organ, seconds: float) -> bool:
    """Whether a press of 3 mm and a pull, again and again, raise no alarm."""
    scene = compile_organ(organ)
    frames, times = write_script(
        find_top(scene), scene.instruments[0].tool.radius, PressScript(3e-3, 2e-3, 0.1, 0.1)
    )
    count = int(np.ceil(seconds / times.end))
    again = [
        palpate.KeyFrame(frame.time + k * times.end, frame.position, frame.buttons)
        for k in range(count)
        for frame in frames[(k > 0) :]
    ]
    return run_trial(scene, palpate.ScriptedDevice(again), seconds) is NONE


def find_told(organ: Organ, key: str) -> Problem:
    """The problem that names a constant."""
    kinds = ("hard_constant", "blown")
    [problem] = [p for p in assess(organ).problems if p.where == key and p.key in kinds]
    return problem


AT_LANDING = list(WRONG)[::4]
"""Of these a minute is simulated at a landing, of the others by verify alone."""


@pytest.mark.parametrize("key", keep_everyday(WRONG, list(WRONG)[:2]))
def test_a_wrong_constant_is_named_with_the_nearest_value_that_works(organ, key):
    wrong = make_wrong(organ, key)

    problem = find_told(wrong, key)

    part, field = key.split(".")
    assert (problem.fix.part, problem.fix.field) == (part, field)
    was = getattr(getattr(wrong, part), field)
    assert (problem.fix.value > was) == (key == "material.density")
    repaired = problem.fix(wrong)
    left = [p for p in assess(repaired).problems if p.severity == "error"]
    assert [p for p in left if p.stage == "material"] == []
    assert bears_presses(repaired, 2.0)


@pytest.mark.parametrize("key", BORNE)
def test_a_thousand_times_what_is_borne_ends_no_run(organ, key):
    part, field = key.split(".")
    value = min(1e6, 1e3 * getattr(getattr(organ, part), field))

    assert bears_presses(SetConstant(part, field, value)(organ), 1.0)


@pytest.mark.parametrize(
    "key",
    [
        pytest.param(k, marks=pytest.mark.landing if k in AT_LANDING else pytest.mark.verify)
        for k in WRONG
    ],
)
def test_what_was_mended_runs_for_a_minute_without_an_alarm(organ, key):
    wrong = make_wrong(organ, key)

    assert bears_presses(find_told(wrong, key).fix(wrong), 60.0)


def test_the_value_that_is_offered_is_the_farthest_that_fits(organ):
    wrong = make_wrong(organ, "model.stiffness")

    def build(parts: SceneFile) -> palpate.TissueModel:
        return build_organ(replace(wrong, material=parts.material, model=parts.model))

    parts = parts_of(wrong)
    for most in (12, 40, 90):
        found = find_nearest(parts, build, most)

        assert found.key == "model.stiffness" and found.needed > most == found.most
        substeps = [
            1e-3 / palpate.stable_step(build(put(parts, found.key, times * found.limit)))
            for times in (1.0, 1.2)
        ]
        assert substeps[0] <= most < substeps[1]
        assert found.excess > 0.0


def test_a_sound_organ_has_no_nearest_and_a_constant_of_0_is_no_suspect(organ):
    parts = parts_of(organ)
    build = lambda each: build_organ(replace(organ, material=each.material, model=each.model))  # noqa: E731

    assert find_nearest(parts, build, 10_000) is None
    assert find_nearest(parts, build, 0) is None
    still = put(make_parts(organ, "model.stiffness"), "model.drag", 0.0)
    assert find_nearest(still, build, 12).key == "model.stiffness"
    assert set(USUAL) >= {found for found in WRONG if found in USUAL}
    assert read(parts, "model.home_stiffness") > 0.0


def make_parts(organ: Organ, key: str) -> SceneFile:
    return parts_of(make_wrong(organ, key))


def run(capsys, *words) -> tuple[int, str, str]:
    code = main([*map(str, words)])
    said = capsys.readouterr()
    return code, said.out, said.err


def test_the_verbs_open_press_explain_and_repair_it(organ, tmp_path, capsys):
    file, repaired = tmp_path / "wrong.organ", tmp_path / "repaired.organ"
    write_organ(file, make_wrong(organ, "tool.stiffness"))

    code, out, _ = run(capsys, "check", file, "--json")
    [problem] = [p for p in json.loads(out)["problems"] if p["problem"] == "blown"]
    assert code == 1 and problem["where"] == "tool.stiffness"
    assert problem["expected"].startswith("at most ") and problem["fix"]

    code, _, err = run(capsys, "repair", file, "--problem", "blown", "--out", repaired)
    assert code == 0, err
    code, out, _ = run(capsys, "check", repaired, "--json")
    assert "blown" not in {p["problem"] for p in json.loads(out)["problems"]}


def test_a_scene_file_that_no_machine_has_time_for_is_refused_with_what_would_do(organ, tmp_path):
    mesh = tmp_path / "ball.obj"
    x, t = organ.surface.vertices, organ.surface.triangles
    lines = [*(f"v {a!r} {b!r} {c!r}" for a, b, c in x.tolist()),
             *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in t.tolist())]  # fmt: skip
    mesh.write_text("\n".join(lines) + "\n", encoding="utf-8")
    path = tmp_path / "wrong.scene.json"
    parts = parts_of(make_wrong(organ, "model.stiffness"))
    part = OrganPart("ball", "ball.obj", hashlib.sha256(mesh.read_bytes()).hexdigest())
    hard = put(replace(parts, organ=part), "model.stiffness", 1e10)
    write_scene_file(path, hard)

    with pytest.raises(Refusal) as refusal:
        read_scene(path)

    assert refusal.value.where == "model.stiffness"
    limit = float(refusal.value.expected.split()[2].rstrip(","))
    write_scene_file(path, put(read_scene_file(path), "model.stiffness", limit))
    assert read_scene(path).bodies[0].substeps > 1
