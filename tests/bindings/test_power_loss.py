# SPDX-License-Identifier: BSD-3-Clause
"""A disk loses power after any step of a save, a publish or a record: what was promised is kept.

The steps are those the programs really take, traced at the border to the system. Ordinary tests try
a sample of what the disk may hold then; `-m verify` tries all of it.
"""

from __future__ import annotations

import random
import sys
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.files.whole_file import write_whole
from power_work import SAVES, make_material
from simulated_disk import (
    Disk,
    File,
    Loss,
    Step,
    build_shim,
    list_contents,
    list_losses,
    put_back,
    read_steps,
    run_traced,
)

WORK = Path(__file__).with_name("power_work.py")
SAMPLE = 150
"""Losses that an ordinary run tries, of some hundreds to thousands."""
OLDER = b"what stood there before " * 40


@pytest.fixture(scope="module")
def shim(tmp_path_factory) -> Path:
    return build_shim(tmp_path_factory.mktemp("shim"))


def run(shim: Path, folder: Path, kind: str, material: Path, fail: str = "") -> None:
    search = f"{WORK.parent}:{WORK.parents[1]}"
    program = f"import sys, runpy; sys.path[:0] = {search!r}.split(':'); sys.argv = sys.argv[1:]; "
    program += "runpy.run_path(sys.argv[0], run_name='__main__')"
    command = [sys.executable, "-P", "-c", program, WORK, kind, folder, material]
    done = run_traced(shim, folder, command, fail)
    assert done.returncode == 0, done.stderr


def choose(losses: list[Loss], whole: bool) -> list[Loss]:
    """All losses, or a sample with the last of them in it."""
    if whole or len(losses) <= SAMPLE:
        return losses
    return [*random.Random(16).sample(losses, SAMPLE), losses[-1]]


WHOLE = pytest.mark.parametrize(
    "whole", [False, pytest.param(True, marks=pytest.mark.verify)], ids=["sample", "whole"]
)


@WHOLE
@pytest.mark.parametrize("older", [True, False], ids=["over-an-older-file", "under-a-new-name"])
@pytest.mark.parametrize("kind", SAVES)
def test_a_save_that_was_acknowledged_is_there_after_a_loss_of_power_and_none_is_half(
    kind, older, whole, shim, tmp_path
):
    folder, material = tmp_path / "disk", tmp_path / "material"
    folder.mkdir()
    before = {"work": OLDER} if older else {}
    for name, content in before.items():
        (folder / name).write_bytes(content)
    make_material(kind, material)
    one, two = (material / version for version in ("one", "two"))
    run(shim, folder, kind, material)
    versions = [before.get("work"), one.read_bytes(), two.read_bytes()]
    assert (folder / "work").read_bytes() == versions[2]

    losses = list(list_losses(read_steps(folder), before))

    assert {loss.promises for loss in losses} >= {(), ("one",), ("one", "two")}
    for loss in choose(losses, whole):
        found = loss.folder.get("work")
        assert found in versions[len(loss.promises) :], (loss.after, loss.promises)


@pytest.mark.parametrize("kind", SAVES)
def test_the_next_save_removes_what_a_loss_of_power_left(kind, shim, tmp_path):
    folder, material = tmp_path / "disk", tmp_path / "material"
    folder.mkdir()
    make_material(kind, material)
    run(shim, folder, kind, material)
    losses = list(list_losses(read_steps(folder), {}))
    left = [loss for loss in losses if set(loss.folder) - {"work"}]
    assert left

    for loss in (left[0], left[-1]):
        put_back(loss, tmp_path / "again")
        SAVES[kind](tmp_path / "again" / "work", material / "one")

        assert [file.name for file in (tmp_path / "again").iterdir()] == ["work"]


@WHOLE
def test_a_record_that_lost_power_has_all_that_was_synced_and_a_beginning_of_the_rest(
    whole, shim, tmp_path
):
    folder = tmp_path / "disk"
    folder.mkdir()
    run(shim, folder, "live", tmp_path)
    truth = palpate.read_record(folder / "work")
    assert truth.complete
    steps = read_steps(folder)
    synced = count_synced_ticks(steps, tmp_path)
    assert 0 < synced[len(steps) - 4] <= len(truth.hand)

    kept = set()
    for loss in choose(list(list_losses(steps, {})), whole):
        put_back(loss, tmp_path / "again")
        least = synced[loss.after]
        if not loss.promises and least == 0:
            refuse_or_read(tmp_path / "again" / "work")
            continue
        back = palpate.read_record(tmp_path / "again" / "work")
        require_beginning(back, truth)
        assert len(back.hand) >= least, (loss.after, loss.promises)
        if "finished" in loss.promises:
            assert back.complete
            assert len(back.hand) == len(truth.hand)
        kept.add(len(back.hand))
    assert len(kept) > 3


def count_synced_ticks(steps: list[Step], folder: Path) -> list[int]:
    """After each number of steps, the ticks in blocks that were written before the last sync."""
    disk, counts, sure = Disk(), [0], folder / "sure"
    for step in steps:
        disk.take(step, {})
        counts.append(counts[-1])
        if step.kind == "sync":
            sure.write_bytes(disk.files[int(step.words[0])].sure)
            counts[-1] = len(palpate.read_record(sure).hand)
    return counts


def refuse_or_read(path: Path) -> None:
    """Of what was never promised: read, or refused in a sentence."""
    try:
        palpate.read_record(path)
    except palpate.FileError as refused:
        assert refused.got


def require_beginning(back: palpate.Record, truth: palpate.Record) -> None:
    for table in ("hand", "felt"):
        part, whole = getattr(back, table), getattr(truth, table)
        for name in part.dtype.names:
            assert np.array_equal(part[name], whole[name][: len(part)])


@pytest.mark.parametrize("kind", SAVES)
def test_a_sync_that_a_signal_interrupts_is_begun_again(kind, shim, tmp_path):
    folder, material = tmp_path / "disk", tmp_path / "material"
    folder.mkdir()
    make_material(kind, material)

    run(shim, folder, kind, material, fail="interrupt-sync")

    assert (folder / "work").read_bytes() == (material / "two").read_bytes()
    kinds = [step.kind for step in read_steps(folder)]
    assert kinds.count("sync") >= 2
    assert kinds.count("sync-folder") == 2


@pytest.mark.parametrize("kind", SAVES)
def test_a_folder_that_cannot_be_synced_is_told_as_saved_but_not_durable(kind, shim, tmp_path):
    folder, material = tmp_path / "disk", tmp_path / "material"
    folder.mkdir()
    make_material(kind, material)

    with pytest.raises(AssertionError, match="the file is saved, but a loss of power may") as told:
        run(shim, folder, kind, material, fail="folder-sync")

    assert "NotDurable" in str(told.value)
    assert (folder / "work").read_bytes() == (material / "one").read_bytes()
    assert [file.name for file in folder.iterdir()] == ["work"]


def test_a_recorder_does_not_begin_where_the_name_of_its_file_cannot_be_kept(shim, tmp_path):
    folder = tmp_path / "disk"
    folder.mkdir()

    with pytest.raises(AssertionError, match="a folder that the disk syncs"):
        run(shim, folder, "live", tmp_path, fail="folder-sync")


# ---------------------------------------------------------------- the disk itself


def test_the_disk_keeps_what_was_synced_and_may_lose_the_rest():
    file = File(b"old", [(0, b"new"), (3, b"er")])

    contents = set(list_contents(file))

    assert {b"old", b"new", b"newer", b"newe", b"new\0r", b"new\0\0"} <= contents


def test_the_disk_loses_a_name_without_a_sync_of_the_folder():
    steps = [
        Step("create", ("0", "a")),
        Step("write", ("0", "0", "4"), b"data"),
        Step("sync", ("0",)),
        Step("promise", ("saved",)),
    ]
    lost = [loss for loss in list_losses(steps, {}) if loss.promises and "a" not in loss.folder]
    kept = list(list_losses([*steps[:3], Step("sync-folder"), steps[3]], {}))

    assert lost
    assert all(loss.folder == {"a": b"data"} for loss in kept if loss.promises)


def test_the_disk_finds_a_save_that_does_not_sync(tmp_path):
    """Renamed before its content is on the disk, a file may be empty under its name."""
    steps = [
        Step("create", ("0", ".part")),
        Step("write", ("0", "0", "4"), b"data"),
        Step("rename", (".part", "a")),
        Step("sync-folder"),
        Step("promise", ("saved",)),
    ]

    found = {loss.folder["a"] for loss in list_losses(steps, {"a": b"old"}) if loss.promises}

    assert b"" in found
    assert b"data" in found


def test_a_container_that_the_disk_tore_is_refused_in_a_sentence(tmp_path):
    """Not that a save could leave one: were it there, it would not be taken for an organ."""
    make_material("container", tmp_path / "material")
    good = (tmp_path / "material" / "one").read_bytes()
    torn = tmp_path / "torn.organ"
    for content in list_contents(File(b"", [(0, good)])):
        if content == good:
            continue
        write_whole(torn, content)
        with pytest.raises(palpate.FileError):
            scenario.read_container(torn, "organ", 3)
