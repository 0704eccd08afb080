# SPDX-License-Identifier: BSD-3-Clause
import os
import stat

import pytest
from palpate.whole_file import write_whole


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
