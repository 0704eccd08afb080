# SPDX-License-Identifier: BSD-3-Clause
import os
import stat

import palpate
import pytest
from palpate.files.whole_file import create_beside, write_whole
from power_work import SAVES, make_material


def test_a_whole_file_holds_the_bytes_and_nothing_is_left_beside_it(tmp_path):
    path = tmp_path / "organ.bin"

    write_whole(path, b"one")
    write_whole(path, b"two")

    assert path.read_bytes() == b"two"
    assert list(tmp_path.iterdir()) == [path]


def test_a_write_that_fails_leaves_the_old_file_and_no_other(tmp_path):
    path = tmp_path / "organ.bin"
    write_whole(path, b"old")

    with pytest.raises(TypeError):
        write_whole(path, "text is not bytes")

    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_rename_that_is_refused_leaves_nothing_behind(tmp_path):
    path = tmp_path / "folder"
    path.mkdir()

    with pytest.raises(OSError):
        write_whole(path, b"data")

    assert list(tmp_path.iterdir()) == [path]


def test_a_missing_folder_is_an_error_of_the_system(tmp_path):
    path = tmp_path / "nowhere" / "organ.bin"

    with pytest.raises(FileNotFoundError) as missing:
        write_whole(path, b"data")

    assert missing.value.filename == str(path)


def test_a_whole_file_has_the_permissions_of_any_new_file(tmp_path):
    plain, whole = tmp_path / "plain", tmp_path / "whole"
    before = os.umask(0o027)
    try:
        plain.write_bytes(b"data")
        write_whole(whole, b"data")
    finally:
        os.umask(before)

    assert stat.S_IMODE(whole.stat().st_mode) == stat.S_IMODE(plain.stat().st_mode) == 0o640


def test_a_link_is_followed_not_replaced(tmp_path):
    target, link = tmp_path / "target", tmp_path / "link"
    target.write_bytes(b"old")
    link.symlink_to(target)

    write_whole(link, b"new")

    assert link.is_symlink()
    assert target.read_bytes() == b"new"


@pytest.mark.parametrize("kind", SAVES)
def test_a_link_planted_under_a_temporary_name_is_not_followed(kind, tmp_path):
    """Names that others can foresee, of this process or without a number, lead to a victim."""
    make_material(kind, tmp_path / "material")
    folder, victim = tmp_path / "saved", tmp_path / "victim"
    folder.mkdir()
    victim.write_bytes(b"precious")
    for number in range(60):
        (folder / f".work.part-{os.getpid()}-{number}").symlink_to(victim)
        (folder / f"work.part-{os.getpid()}-{number}").symlink_to(victim)

    SAVES[kind](folder / "work", tmp_path / "material" / "one")

    assert victim.read_bytes() == b"precious"
    assert (folder / "work").read_bytes() == (tmp_path / "material" / "one").read_bytes()


@pytest.mark.parametrize("kind", SAVES)
def test_what_a_killed_save_left_is_removed_and_what_a_living_one_writes_is_not(kind, tmp_path):
    make_material(kind, tmp_path / "material")
    folder = tmp_path / "saved"
    folder.mkdir()
    target = folder / "work"
    left, handle = create_beside(target)
    os.close(handle)  # as the system does for a process that is killed
    living, held = create_beside(target)
    other = folder / ".other.part-0123456789abcdef"
    other.write_bytes(b"of another file")

    SAVES[kind](target, tmp_path / "material" / "one")

    os.close(held)
    assert not left.exists()
    assert {file.name for file in folder.iterdir()} == {"work", living.name, other.name}


@pytest.mark.parametrize("kind", SAVES)
def test_what_is_no_file_is_not_replaced(kind, tmp_path):
    make_material(kind, tmp_path / "material")
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)

    with pytest.raises(OSError, match="not a plain file|something other than a file"):
        SAVES[kind](pipe, tmp_path / "material" / "one")

    assert stat.S_ISFIFO(pipe.stat().st_mode)


@pytest.mark.parametrize("kind", SAVES)
def test_a_long_name_leaves_room_for_the_temporary_one(kind, tmp_path):
    make_material(kind, tmp_path / "material")
    path = tmp_path / ("n" * 250)

    SAVES[kind](path, tmp_path / "material" / "one")

    assert path.read_bytes() == (tmp_path / "material" / "one").read_bytes()


def test_a_recorder_writes_into_no_pipe(tmp_path):
    os.mkfifo(tmp_path / "run.prec")

    with pytest.raises(OSError):
        palpate.Recorder(tmp_path / "run.prec", "{}")
