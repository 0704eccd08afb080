# SPDX-License-Identifier: BSD-3-Clause
"""Our own kinds of JSON file: an object that says its format and version first."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from palpate.files.file_kind import NO_FILE, NOTHING, OTHER, find_kind
from palpate.files.json_part import json_kind
from palpate.files.read_file import read_file
from palpate.files.refusal import Refusal


def read_document(
    path: Path,
    *,
    format: str,
    version: int,
    what: str,
    most_bytes: int,
    older: tuple[int, ...] = (),
) -> dict[str, Any]:
    """The whole object, its format and version checked. Raises Refusal or OSError.

    Args:
        path: Of the file.
        format: The value of its field `format` ...
        version: ... and of its field `version`, the one that is known here.
        what: Is expected, in words: `a script`.
        most_bytes: A longer file is refused.
        older: Versions before that one that are read too; the caller asks which it is.
    """
    try:
        data = json.loads(read_file(path, most_bytes))
    except (ValueError, RecursionError) as problem:
        refuse_other_kind(path, what)
        raise Refusal(path, "", f"text that is not JSON ({problem})", what) from None
    if not isinstance(data, dict) or data.get("format") != format:
        refuse_other_kind(path, what)
        found = json_kind(data.get("format")) if isinstance(data, dict) else "no object"
        raise Refusal(path, "format", found, f'"{format}"')
    told = data.get("version")
    if told not in (version, *older) or isinstance(told, bool):
        raise Refusal(path, "version", json_kind(told), f"{version}, the one known here")
    return data


def refuse_other_kind(path: Path, what: str) -> None:
    """Where it is a file of ours of another kind. Raises Refusal or OSError."""
    kind = find_kind(path)
    if kind not in (OTHER, NOTHING, NO_FILE, what):
        raise Refusal(path, "", kind, what)
