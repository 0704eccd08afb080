# SPDX-License-Identifier: GPL-3.0-or-later
"""The main job from mesh file to felt force, on our own organ and on real ones."""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
from pathlib import Path

import palpate
import pytest
from palpate.cli.main import main
from palpate.render import openness
from palpate.runs.pictures import picture_of_record
from palpate_editor import demo as demo_module
from palpate_editor.document.defaults import CONSTANTS
from palpate_editor.open_organ import open_organ

FIELDS = {
    "tick_median_us",
    "tick_p99_us",
    "lateness_p99_us",
    "missed_ticks",
    "peak_force_N",
    "pull_force_N",
    "patch_stiffness_N_per_m",
    "replay_equal",
}


PICTURE_SIZE = {"size": (320, 180), "supersample": 1}


def demo(out: Path, *words: str) -> dict:
    """Its summary. The picture is as small and as roughly lit as one can be that is only told from
    others; test_render.py looks at pictures as they are."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(openness, "DIRECTIONS", 8)
        patch.setattr(
            demo_module,
            "picture_of_record",
            lambda out, record, time, options, title: picture_of_record(
                out, record, time, options | PICTURE_SIZE, title
            ),
        )
        assert main(["demo", "--no-window", "--out", str(out), *words]) == 0
    return json.loads((out / "summary.json").read_text(encoding="utf-8"))


def run_here(verb: str, *arguments: object) -> dict:
    """As run_elsewhere, but in this process, which has imported everything: where the demo ran in
    processes of their own before, on another organ."""
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        assert main([verb, *map(str, arguments), "--json"]) == 0
    return json.loads(said.getvalue())


@pytest.fixture
def in_one_process(monkeypatch) -> None:
    monkeypatch.setattr(demo_module, "run_elsewhere", run_here)


@pytest.fixture(scope="module")
def own(tmp_path_factory):
    out = tmp_path_factory.mktemp("demo_own")
    return out, demo(out)


@pytest.fixture(scope="module")
def spleen(tmp_path_factory, shared_data):
    out = tmp_path_factory.mktemp("demo_spleen")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(demo_module, "run_elsewhere", run_here)
        return out, demo(out, "--mesh", str(shared_data("organs/VH_F_Spleen.glb")))


def check_summary(out: Path, summary: dict) -> None:
    assert {"organ", "vertices", "triangles", "picture", "force_plot"} <= set(summary)
    for key in ("picture", "force_plot"):
        assert (out / summary[key]).read_bytes().startswith(b"\x89PNG")
    for kind in ("mss", "mms"):
        assert set(summary[kind]) >= FIELDS
        assert summary[kind]["replay_equal"] is True
        assert 0.1 <= summary[kind]["peak_force_N"] <= 3.0
        assert 50.0 <= summary[kind]["patch_stiffness_N_per_m"] <= 400.0
        assert summary[kind]["pull_force_N"] > 0.02
        assert (out / summary[kind]["record"]).is_file()
    check_published(out, summary)


def check_published(out: Path, summary: dict) -> None:
    """The demo goes to the end: the file a trainee gets was played, and feels like the press."""
    published = out / summary["published"]
    assert (published.name, published.suffix) == (summary["published"], ".palpate")
    assert hashlib.sha256(published.read_bytes()).hexdigest() == summary["published_sha256"]
    assert len(palpate.scenario.read(published).scene.bodies[0].tissue.mass) == summary["vertices"]
    assert open_organ(out / summary["working"]).title == open_organ(published).title != ""
    assert summary["play"]["replay_equal"] is True
    assert (out / summary["play"]["record"]).is_file()
    pressed, pulled = summary["mss"]["peak_force_N"], summary["mss"]["pull_force_N"]
    assert summary["play"]["peak_force_N"] == pytest.approx(max(pressed, pulled), rel=0.02)


def test_the_demo_leaves_its_pictures_records_and_a_summary(own):
    out, summary = own

    check_summary(out, summary)
    assert summary["vertices"] == 600
    assert summary["triangles"] == 1196


@pytest.mark.landing
def test_the_demo_runs_the_whole_way_on_a_real_spleen(spleen):
    out, summary = spleen

    check_summary(out, summary)
    assert (summary["vertices"], summary["triangles"]) == (600, 1196)
    assert summary["border_loops"] == []


@pytest.mark.landing
def test_the_demo_keeps_the_hole_of_a_real_pancreas_exported_as_an_stl_and_says_so(
    tmp_path, shared_data, capsys, in_one_process
):
    source = shared_data("organs/VH_F_Pancreas.glb")
    stl = tmp_path / "pancreas.stl"
    assert main(["import", str(source), "-o", str(stl)]) == 0

    summary = demo(tmp_path / "stl", "--mesh", str(stl), "--unit", "m", "--up", "z")

    check_summary(tmp_path / "stl", summary)
    assert summary["vertices"] == 600
    assert "1 hole(s) kept open" in capsys.readouterr().err
    assert len(summary["border_loops"]) == 1


def test_two_organs_give_different_forces_pictures_and_files(own, spleen):
    (own_out, one), (spleen_out, other) = own, spleen

    for kind in ("mss", "mms"):
        assert one[kind]["peak_force_N"] != other[kind]["peak_force_N"]
    for name in ("picture.png", "force_plot.png", "organ.obj", "mss.prec", "mms.prec", "play.prec"):
        digests = {
            hashlib.sha256((out / name).read_bytes()).hexdigest() for out in (own_out, spleen_out)
        }
        assert len(digests) == 2, name


def test_doubling_the_stiffness_raises_the_peak_force_by_at_least_40_percent(
    own, tmp_path, monkeypatch
):
    # only what is pressed counts here: nothing is drawn, replayed or published
    monkeypatch.setattr(demo_module, "draw", lambda *words: None)
    monkeypatch.setattr(demo_module, "replay_elsewhere", lambda record: {"equal": True})
    played = {key: own[1][key] for key in ("published", "play")}
    monkeypatch.setattr(demo_module, "hand_over", lambda *words: played)
    lines = []
    for line in CONSTANTS.read_text(encoding="utf-8").splitlines():
        key, _, rest = line.partition("=")
        if key.strip() in ("stiffness", "home_stiffness", "bend_stiffness", "stretch_coupling"):
            value, _, comment = rest.partition("#")
            if float(value) < 1e7:  # not the contact law's k_A: the tool stays as it is
                line = f"{key}= {2 * float(value)!r} # {comment}"
        lines.append(line)
    stiff = tmp_path / "stiff.toml"
    stiff.write_text("\n".join(lines), encoding="utf-8")

    summary = demo(tmp_path / "stiff", "--constants", str(stiff))

    for kind in ("mss", "mms"):
        assert summary[kind]["peak_force_N"] >= 1.4 * own[1][kind]["peak_force_N"]


def test_one_changed_sample_makes_the_replay_differ(own, tmp_path, capsys):
    out, _ = own
    record = palpate.read_record(str(out / "mss.prec"))
    hand = record.hand  # a view
    hand["position"][len(hand) // 3, 2] += 1e-9
    for name in ("organ.obj", "mss.scene.json"):
        (tmp_path / name).write_bytes((out / name).read_bytes())
    palpate.write_record(str(tmp_path / "changed.prec"), record)

    assert main(["replay", str(tmp_path / "changed.prec"), "--json"]) == 1

    report = json.loads(capsys.readouterr().out)
    assert report["equal"] is False
    assert report["first_difference"] >= len(hand) // 3


def test_a_record_of_another_scene_is_refused(own, tmp_path, capsys):
    out, _ = own

    code = main(["replay", str(out / "mss.prec"), "--scene", str(out / "mms.scene.json"), "--json"])

    assert code == 1
    assert "SHA-256" in json.loads(capsys.readouterr().out)["error"]["got"]


def test_a_mesh_the_demo_cannot_take_is_refused_with_a_sentence(tmp_path, capsys):
    empty = tmp_path / "empty.stl"
    empty.write_bytes(b"")

    assert main(["demo", "--mesh", str(empty), "--out", str(tmp_path / "out"), "--json"]) == 1

    error = json.loads(capsys.readouterr().out)["error"]
    assert error["file"].endswith("empty.stl")
    assert not (tmp_path / "out" / "summary.json").exists()


def test_constants_with_an_unknown_name_are_refused(tmp_path, capsys):
    constants = tmp_path / "bad.toml"
    constants.write_text(
        CONSTANTS.read_text(encoding="utf-8").replace("depth", "dept", 1), encoding="utf-8"
    )

    assert (
        main(["demo", "--constants", str(constants), "--out", str(tmp_path / "o"), "--json"]) == 1
    )

    assert json.loads(capsys.readouterr().out)["error"]["where"] == "[script]"


def test_a_constant_that_is_no_number_is_refused(tmp_path, capsys):
    constants = tmp_path / "bad.toml"
    constants.write_text(
        CONSTANTS.read_text(encoding="utf-8").replace("drag = 8.0", 'drag = "8"'), encoding="utf-8"
    )

    assert (
        main(["demo", "--constants", str(constants), "--out", str(tmp_path / "o"), "--json"]) == 1
    )

    assert json.loads(capsys.readouterr().out)["error"]["where"] == "[surroundings] drag"


@pytest.mark.parametrize(("display", "words", "opened"), [
    (":0", [], ["spleen.organ"]), (":0", ["--no-window"], []), ("", [], []),
])  # fmt: skip
def test_the_editor_opens_on_the_result_where_there_is_a_display(
    own, tmp_path, monkeypatch, capsys, display, words, opened
):
    out, summary = own
    seen = []
    monkeypatch.setenv("DISPLAY", display)
    monkeypatch.setenv("WAYLAND_DISPLAY", "")
    monkeypatch.setattr("palpate_editor.verbs.demo.run_demo", lambda *_: summary)
    monkeypatch.setattr(demo_module.subprocess, "Popen", lambda words, **_: seen.append(words))

    assert main(["demo", "--out", str(out), *words]) == 0

    assert [Path(call[-1]).name for call in seen] == opened
    assert all(call[1:5] == ["-P", "-m", "palpate", "editor"] for call in seen)
    assert summary["published"] in capsys.readouterr().out
