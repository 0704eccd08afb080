# SPDX-License-Identifier: GPL-3.0-or-later
"""Organs out of every file that has one: working files, published ones, scene files."""

from __future__ import annotations

import json
import os
from pathlib import Path

from palpate import FileError, scenario
from palpate.files.refusal import Refusal
from palpate.layout.document import FORMAT as LAYOUT_FORMAT

from palpate_editor.document import Organ
from palpate_editor.document.files import FORMAT, VERSION, read_organ, unpack_organ
from palpate_editor.scene_files import read_scene


def open_organ(path: Path) -> Organ:
    """Reads an .organ, a .palpate with its designer's document inside, or a scene file.

    Raises FileError, Refusal or OSError.
    """
    if path.suffix == ".organ":
        return read_organ(path)
    if path.suffix == ".palpate":
        return read_authored(path)
    if path.suffix == ".json":
        return read_scene(path)
    raise Refusal(
        path,
        "",
        f"a name ending in {path.suffix!r}",
        ".organ, .palpate or .scene.json; foreign meshes come in by `palpate import`",
    )


def read_authored(path: Path) -> Organ:
    """The document a published file was made from. Raises FileError."""
    found = scenario.read(os.fspath(path))
    authored = json.loads(found.authored)
    if authored.get("format") == LAYOUT_FORMAT:
        raise FileError(
            str(path),
            "authored",
            "a scene of several parts that a layout places",
            "a single organ; `palpate scene` checks and changes layouts",
        )
    if authored.get("format") != FORMAT:
        raise FileError(
            str(path), "authored", "no document of an editor", "a file that `palpate publish` wrote"
        )
    version = authored.get("version")
    if type(version) is not int or not 1 <= version <= VERSION:  # true is no version
        raise FileError(
            str(path),
            "authored.version",
            f"{version}",
            f"at most {VERSION}, what this editor knows",
        )
    return unpack_organ(authored.get("content"), found.authored_arrays, version, str(path))
