# SPDX-License-Identifier: BSD-3-Clause
"""Where a user's data and what can be made again lie, as the system would have it."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from palpate.system.data_folder import find_cache_folder, find_data_folder

FOLDERS = {
    "XDG_DATA_HOME": (find_data_folder, ".local/share"),
    "XDG_CACHE_HOME": (find_cache_folder, ".cache"),
}


@pytest.mark.parametrize("name", FOLDERS)
def test_a_folder_is_where_the_user_says_and_else_where_the_system_has_it(name, monkeypatch):
    find, usual = FOLDERS[name]
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv(name, "/somewhere")
    assert find() == Path("/somewhere/palpate")
    # a relative one counts as none [XDG Base Directory Specification 0.8]
    for value in ("", "beside"):
        monkeypatch.setenv(name, value)
        assert find() == Path.home() / usual / "palpate"
