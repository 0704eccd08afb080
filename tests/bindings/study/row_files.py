# SPDX-License-Identifier: BSD-3-Clause
"""What tests of charts and of atlases, which are files of rows, share."""

from __future__ import annotations

import json
from dataclasses import fields
from pathlib import Path
from types import ModuleType
from typing import Any

from palpate.study.row_file import hash_content

HEAD = ("format", "version", "sha256")


def spoil(path: Path, change, *, hashed: bool = True) -> None:
    """Changes a written file; with a new hash, as an edit by hand might."""
    data = json.loads(path.read_text(encoding="utf-8"))
    change(data)
    if hashed:
        data["sha256"] = hash_content({k: v for k, v in data.items() if k not in HEAD})
    path.write_text(json.dumps(data), encoding="utf-8")


def check_schema_fields(schema: dict[str, Any], module: ModuleType, whole: type) -> None:
    """That a schema has every field of the dataclasses of a module, and of the whole file."""
    for name, described in schema["$defs"].items():
        assert list(described["properties"]) == [f.name for f in fields(getattr(module, name))]
        assert described["required"] == list(described["properties"])
    expected = [*HEAD, *(f.name for f in fields(whole))]
    assert list(schema["properties"]) == schema["required"] == expected
