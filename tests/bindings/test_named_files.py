# SPDX-License-Identifier: BSD-3-Clause
"""Files that a user or another file names: only plain ones, of a stated size, are ever opened."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.files.read_file import read_file
from palpate.runs.run import describe_build
from published import publish, write_press
from surfaces import organ_scene, press_frames, run_frames


def write_record_of(folder: Path, scene: object, ticks: int | None = None) -> Path:
    """A finished record whose header names `scene`."""
    record = run_frames(organ_scene(0), press_frames())
    record.header = json.dumps({"scene": scene, "scene_sha256": "0" * 64})
    path = folder / "run.prec"
    palpate.write_record(path, record)
    return path


def refuse(words: list[str], capsys) -> str:
    """The sentence that the command refuses with."""
    assert main(words) == 1
    said = capsys.readouterr().err
    assert "Traceback" not in said
    assert said.count("\n") == 1
    return said


def make_pipe(folder: Path) -> str:
    os.mkfifo(folder / "pipe")
    return str(folder / "pipe")


@pytest.mark.parametrize(
    "place", ["/dev/zero", "/dev/stdin", "pipe", "a\0b", "\ud800", ".", "none"]
)
@pytest.mark.parametrize("verb", ["replay", "render"])
def test_the_scene_that_a_record_names_is_a_plain_file_or_refused(place, verb, tmp_path, capsys):
    make_pipe(tmp_path)
    record = write_record_of(tmp_path, place)
    words = [verb, str(record)] + (["-o", str(tmp_path / "a.png")] if verb == "render" else [])

    said = refuse(words, capsys)

    assert "something other than a file" in said or "no file can have" in said or "--scene" in said


@pytest.mark.parametrize("place", ["/dev/zero", "pipe", "organ"])
def test_a_script_is_a_plain_file_or_refused(place, tmp_path, capsys):
    make_pipe(tmp_path)
    (tmp_path / "organ").mkdir()
    script = tmp_path / place  # an absolute name stays as it is
    words = ["play", str(publish(tmp_path)), "--headless", "--device", f"script:{script}"]

    assert "something other than a file" in refuse(words, capsys)


@pytest.mark.parametrize("mesh", ["/dev/zero", "pipe.obj", "a\0b.obj"])
def test_the_mesh_that_a_scene_file_names_is_a_plain_file_or_refused(mesh, tmp_path, capsys):
    os.mkfifo(tmp_path / "pipe.obj")
    organ = {"name": "a", "mesh": mesh, "sha256": "0" * 64}
    scene = tmp_path / "a.scene.json"
    scene.write_text(
        json.dumps({"format": "palpate scene", "version": 1, "organ": organ}), encoding="utf-8"
    )

    said = refuse(["press", str(scene)], capsys)

    assert "got" in said


def test_a_file_larger_than_its_reader_allows_is_not_read(tmp_path):
    path = tmp_path / "large"
    with path.open("wb") as file:
        file.truncate(2**40)  # takes no room: what is read of it would

    with pytest.raises(palpate.FileError, match="1099511627776 bytes, expected at most"):
        read_file(path)
    path.write_bytes(b"abc")
    assert read_file(path, 3) == b"abc"
    with pytest.raises(palpate.FileError, match="3 bytes, expected at most 2"):
        read_file(path, 2)


def test_a_moved_scene_is_missed_with_the_option_that_names_it(tmp_path, capsys):
    scene = publish(tmp_path)
    words = ["play", str(scene), "--headless", "--device", f"script:{write_press(tmp_path)}"]
    record = tmp_path / "run.prec"
    assert main([*words, "--record", str(record)]) == 0
    capsys.readouterr()
    moved = scene.rename(tmp_path / "moved.palpate")

    said = refuse(["replay", str(record)], capsys)

    assert f"no file {scene}" in said
    assert "--scene spleen.palpate" in said
    assert main(["replay", str(record), "--scene", str(moved)]) == 0
    assert "the same bits" in capsys.readouterr().out


# ---------------------------------------------------------------- records


def write_true_record(folder: Path) -> tuple[Path, palpate.Record]:
    scene = publish(folder, subdivisions=0)
    record = run_frames(palpate.scenario.read(scene).scene, press_frames())
    path = folder / "run.prec"
    record.header = json.dumps(describe_build(organ_scene(0), scene, path, "scripted"))
    return path, record


@pytest.mark.parametrize(
    ("table", "name"),
    [("hand", "time"), ("hand", "position"), ("hand", "orientation"), ("hand", "velocity")]
    + [("hand", "grip"), ("felt", "force"), ("felt", "position")],
)
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_record_with_a_row_that_is_no_number_is_refused(table, name, value, tmp_path, capsys):
    path, record = write_true_record(tmp_path)
    getattr(record, table)[name][17] = value
    palpate.write_record(path, record)

    assert f"tick 17: {name}" in refuse(["replay", str(path)], capsys)


def test_a_record_of_no_ticks_is_not_the_same_bits(tmp_path, capsys):
    path, record = write_true_record(tmp_path)
    palpate.write_record(path, record)
    whole = path.read_bytes()
    header = 16 + int.from_bytes(whole[12:16], "little") + 4
    path.write_bytes(whole[:header])

    said = refuse(["replay", str(path)], capsys)

    assert "no ticks, expected a record of at least one" in said
    assert "no ticks" in refuse(["render", str(path), "-o", str(tmp_path / "a.png")], capsys)


def test_a_record_that_was_cut_off_says_so_beside_the_same_bits(tmp_path, capsys):
    path, record = write_true_record(tmp_path)
    palpate.write_record(path, record)
    path.write_bytes(path.read_bytes()[:-100])

    assert main(["replay", str(path)]) == 0

    assert "the same bits; the record ends before the run did" in capsys.readouterr().out


def test_a_record_with_a_gap_is_refused_in_a_sentence(tmp_path, capsys):
    path, record = write_true_record(tmp_path)
    gap = palpate.Event(tick=9, kind=palpate.EventKind.record_gap, index=3)
    rows = {"hand": record.hand, "felt": record.felt, "events": [gap]}
    palpate.write_record(path, palpate.Record(header=record.header, **rows))

    assert "lost 3 ticks" in refuse(["replay", str(path)], capsys)
