# SPDX-License-Identifier: GPL-3.0-or-later
"""What asks for a truth meets: the cache, the refusals, the verb."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.scene.scene_parts import MaterialPart
from palpate.study.half_space import compute_punch_force
from palpate.study.truth_file import read_truth
from palpate_editor.document import EMPTY, Surface
from palpate_editor.document.files import write_organ
from palpate_editor.edits import FixLowest
from palpate_editor.truth import (
    Drag,
    Press,
    Pull,
    Script,
    TruthError,
    find_truth,
    levels,
    solve,
    solve_truth,
    subject,
)
from palpate_meshes.generate import ellipsoid

BALL = 8e-3


def make_organ(vertices=150, **changes):
    surface = Surface(*ellipsoid(vertices, (50e-3, 35e-3, 30e-3), bow=0.0, hollow=0.0, notches=0.0))
    organ = FixLowest(0.3)(EMPTY.with_surface(surface))
    return replace(organ, material=MaterialPart(young_modulus=10e3), **changes)


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(autouse=True)
def coarse(monkeypatch):
    """Fewer tetrahedra than a truth needs, so that it takes seconds."""
    monkeypatch.setattr(subject, "COARSEST", 200)
    monkeypatch.setattr(levels, "SIZES", (1.2, 1.6, 2.0))
    monkeypatch.setattr(levels, "SLOPE", (1.5, 1.3, 1.1))
    monkeypatch.setattr(solve, "CHANGE", 1.0)


def ask(cache, organ=None, path=None, **options):
    options = {"radius": BALL, "depths": [1e-3, 2e-3], "cache": cache, **options}
    return solve_truth(organ or make_organ(), path, **options)


def refuse_to_solve(*arguments, **options):
    raise AssertionError("solved a second time")


def test_a_second_call_takes_what_was_kept(cache, monkeypatch):
    first = ask(cache)
    monkeypatch.setattr("palpate_editor.truth.solve.solve_way", refuse_to_solve)

    again = ask(cache)

    assert again.key == first.key
    assert (again.force == first.force).all()
    assert (again.displacement == first.displacement).all()
    assert again.remarks == first.remarks


def test_what_a_truth_depends_on_is_in_its_key_and_what_it_does_not_is_not(cache, monkeypatch):
    """Another key asks for a solution, which is refused here."""
    ask(cache)
    monkeypatch.setattr("palpate_editor.truth.solve.solve_way", refuse_to_solve)
    organ = make_organ()
    ask(cache, replace(organ, title="Another", tool=replace(organ.tool, radius=2e-3)))

    stiffer = organ.stiffness_scale * 2.0
    changed = [
        {"organ": replace(organ, material=replace(organ.material, young_modulus=11e3))},
        {"organ": replace(organ, stiffness_scale=stiffer)},
        {"organ": FixLowest(0.5)(organ)},
        {"path": Press((0.05, 0.0, 0.0))},
        {"radius": 7e-3},
        {"depths": [1e-3]},
    ]
    for change in changed:
        with pytest.raises(AssertionError, match="solved a second time"):
            ask(cache, **change)


def test_a_damaged_file_in_the_cache_is_solved_again_and_said(cache):
    first = ask(cache)
    (file,) = cache.glob("*.truth")
    whole = file.read_bytes()
    file.write_bytes(whole[:-200] + bytes(200))

    again = ask(cache)

    assert (again.force == first.force).all()
    assert again.remarks[-1].startswith("what was kept could not be read and was solved again: ")
    assert read_truth(file).key == first.key


def test_a_cache_that_cannot_be_written_is_said(tmp_path):
    (tmp_path / "file").write_text("no folder", encoding="utf-8")

    truth = ask(tmp_path / "file")

    assert truth.force.shape == (1, 2)
    assert any(remark.startswith("it could not be kept: ") for remark in truth.remarks)


def test_twice_the_stiffness_painted_gives_twice_the_force(cache, tmp_path):
    organ = make_organ()

    once, twice = ask(cache), ask(
        tmp_path, replace(organ, stiffness_scale=2.0 * np.ones(organ.vertex_count))
    )  # fmt: skip

    # the penalty of the contact stays that of the material
    assert twice.force == pytest.approx(2.0 * once.force, rel=2e-3)


def test_a_pull_feels_about_what_a_tied_punch_of_the_grip_does(cache):
    truth = ask(cache, path=Pull(), depths=[2e-3, 4e-3])

    slope = np.diff(truth.force[0]) / np.diff(truth.depth)
    punch = compute_punch_force(1.0, truth.contact_radius[0, 0], np.inf, 10e3, 0.45)

    assert truth.path == "pull" and (truth.depth < 0.0).all() and (truth.force < 0.0).all()
    # less at its border than a punch has, more for what is behind it
    assert slope == pytest.approx(punch, rel=0.25)
    nearest = np.linalg.norm(truth.surface - truth.point[0], axis=1).argmin()
    assert truth.displacement[0, 1, nearest] @ truth.direction[0] > 1e-3


@pytest.mark.landing
def test_a_drag_begins_as_a_press_and_a_script_over_it_feels_the_same(cache):
    organ = make_organ(800)
    places = (0.0, 0.0, 0.03), (0.05, 0.0, 0.03)
    drag = ask(cache, organ, Drag(*places, length=10e-3))
    press = ask(cache, organ, Press(places[0]))
    height = BALL - 2e-3
    ends = [drag.point[k] + height * drag.direction[k] for k in (0, -1)]
    frames = [palpate.KeyFrame(float(k), end, 0) for k, end in enumerate(ends)]
    script = ask(cache, organ, Script(frames))

    assert len(drag.point) >= 3
    assert drag.force[0] == pytest.approx(press.force[0], rel=0.05)
    # nothing turns or thins there much
    assert (drag.force.max(axis=0) < 1.15 * drag.force.min(axis=0)).all()
    assert script.path == "script" and len(script.point) >= 2
    assert script.force.mean(axis=0) == pytest.approx(drag.force.mean(axis=0), rel=0.05)


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"organ": EMPTY}, "got an organ without a surface"),
        ({"organ": replace(make_organ(), fixed=np.zeros(150, bool))}, "no triangle is held"),
        ({"radius": 0.0}, "radius: got 0.0 m, expected one above 0"),
        ({"radius": float("nan")}, "radius: got nan m"),
        ({"depths": [7e-3]}, r"depths: got 7 mm, expected at most .* 10% of the thickness"),
        ({"depths": []}, r"depths: got \[\] m, expected some above 0"),
        ({"depths": [-1e-3]}, r"depths: got \[-0.001\] m, expected some above 0"),
        ({"path": Press((0.0, 0.0, -0.03))}, "that is held, expected one that gives way"),
    ],
)  # fmt: skip
def test_what_cannot_be_solved_is_refused_in_a_sentence(options, sentence, tmp_path):
    with pytest.raises(TruthError, match=sentence):
        ask(tmp_path, **options)


def test_without_the_extra_it_says_what_to_install(monkeypatch, tmp_path):
    monkeypatch.setattr(find_truth, "SOLVER", ("skfem", "no_such_solver"))

    with pytest.raises(TruthError, match="got no no_such_solver, expected the solver: pip install"):
        ask(tmp_path)


def test_the_verb_writes_a_truth_and_says_its_forces(tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    write_organ(tmp_path / "a.organ", make_organ())
    words = ["--radius", "8mm", "--depth", "2mm", "--depth", "1mm", "--place", "0,0,30"]
    files = ["--output", str(tmp_path / "a.truth")]
    call = ["truth", str(tmp_path / "a.organ"), *words, *files, "--json"]

    assert main(call) == 0

    report = json.loads(capsys.readouterr().out)
    truth = read_truth(tmp_path / "a.truth")
    rows = report["stations"][0]["results"]
    assert [row["depth_m"] for row in rows] == [1e-3, 2e-3]
    assert [row["force_N"] for row in rows] == truth.force[0].tolist()
    assert truth.point[0, 2] > 0.028
    assert main(call[:-1]) == 0
    assert f"{1e3 * truth.force[0, 1]:.2f} mN" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--path", "jump"], "--path: got 'jump', expected press, pull, drag, or FILE.json"),
        (["--path", "no.json"], "no.json"),
        (["--path", "a.json", "--place", "0,0,0"], "expected none: a script has its own"),
    ],
)
def test_a_path_that_is_none_is_refused_by_the_verb(words, sentence, tmp_path, capsys):
    write_organ(tmp_path / "a.organ", make_organ())

    assert main(["truth", str(tmp_path / "a.organ"), *words]) == 1

    assert sentence in capsys.readouterr().err


def test_the_verb_refuses_in_the_words_of_the_solver(tmp_path, capsys):
    write_organ(tmp_path / "a.organ", make_organ())

    assert main(["truth", str(tmp_path / "a.organ"), "--depth", "20mm"]) == 1

    assert "depths: got 20 mm, expected at most 4.5 mm" in capsys.readouterr().err
