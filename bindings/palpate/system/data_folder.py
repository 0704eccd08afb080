# SPDX-License-Identifier: BSD-3-Clause
"""Where a user's own data of Palpate lie, and what can be made again. Knows no Qt."""

from __future__ import annotations

import os
import sys
from pathlib import Path


def find_data_folder() -> Path:
    """Palpate's folder among the data of the user, which need not exist yet.

    $XDG_DATA_HOME or ~/.local/share [XDG Base Directory Specification 0.8], ~/Library/Application
    Support on macOS, %LOCALAPPDATA% on Windows.
    """
    if sys.platform == "win32":
        home = os.environ.get("LOCALAPPDATA") or str(Path.home() / "AppData" / "Local")
    elif sys.platform == "darwin":
        home = str(Path.home() / "Library" / "Application Support")
    else:
        home = os.environ.get("XDG_DATA_HOME", "")
        if not os.path.isabs(home):  # as the specification asks for
            home = str(Path.home() / ".local" / "share")
    return Path(home) / "palpate"


def find_config_folder() -> Path:
    """Palpate's folder among what a user has set, which need not exist yet.

    $XDG_CONFIG_HOME or ~/.config [XDG Base Directory Specification 0.8], elsewhere the data folder.
    """
    if sys.platform in ("win32", "darwin"):
        return find_data_folder()
    home = os.environ.get("XDG_CONFIG_HOME", "")
    if not os.path.isabs(home):  # as the specification asks for
        home = str(Path.home() / ".config")
    return Path(home) / "palpate"


def find_cache_folder() -> Path:
    """Palpate's folder among what can be made again, which need not exist yet.

    $XDG_CACHE_HOME or ~/.cache [XDG Base Directory Specification 0.8], ~/Library/Caches on macOS,
    %LOCALAPPDATA% on Windows.
    """
    if sys.platform == "win32":
        return find_data_folder() / "cache"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "palpate"
    home = os.environ.get("XDG_CACHE_HOME", "")
    if not os.path.isabs(home):  # as the specification asks for
        home = str(Path.home() / ".cache")
    return Path(home) / "palpate"


def find_record_folder() -> Path:
    """Where runs are recorded unless a name is given; need not exist yet."""
    return find_data_folder() / "records"
