# SPDX-License-Identifier: BSD-3-Clause
"""Documents of a head and many rows as readable JSON, a line for each row, with their hash."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from palpate.files.json_document import read_document
from palpate.files.json_part import json_kind
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole

Json = dict[str, Any]
Fault = tuple[str, str, str]
"""Where, what was got, what was expected."""
AROUND = ("format", "version", "sha256")


def write_rows(path: Path, content: Json, format: str, version: int) -> None:
    """Writes whole or not at all. Raises OSError.

    Args:
        path: Of the file.
        content: What is kept; its `rows` last.
        format: What kind of document it is.
        version: Of that kind.
    """
    head = {"format": format, "version": version, "sha256": hash_content(content)} | content
    rows = head.pop("rows")
    lines = [f"  {json.dumps(name)}: {dump(value)}" for name, value in head.items()]
    table = ",\n    ".join(map(dump, rows))
    lines.append(f'  "rows": [\n    {table}\n  ]' if rows else '  "rows": []')
    write_whole(path, ("{\n" + ",\n".join(lines) + "\n}\n").encode())


def dump(value: Any) -> str:
    return json.dumps(value, allow_nan=False, ensure_ascii=False)


def hash_content(content: Json) -> str:
    """SHA-256 of all but format, version and itself."""
    whole = json.dumps(content, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(whole.encode()).hexdigest()


def read_rows(
    path: Path, format: str, version: int, what: str, most_bytes: int, most_rows: int
) -> tuple[Json, Any]:
    """The content, in which `rows` is a list, and the hash that the file tells of it.

    Raises Refusal or OSError.
    """
    data = read_document(path, format=format, version=version, what=what, most_bytes=most_bytes)
    content = {name: data[name] for name in data if name not in AROUND}
    rows = content.get("rows")
    if not isinstance(rows, list) or len(rows) > most_rows:
        got = f"{len(rows)} rows" if isinstance(rows, list) else json_kind(rows)
        raise Refusal(path, "rows", got, f"a list of at most {most_rows}")
    return content, data.get("sha256")


def check_rows(path: Path, content: Json, told: Any, faults: Iterable[Fault]) -> None:
    """Raises Refusal for the first fault, or for another hash than the file tells."""
    for where, got, expected in faults:
        raise Refusal(path, where, got, expected)
    hashed = hash_content(content)
    if told != hashed:
        raise Refusal(path, "sha256", json_kind(told), f'"{hashed}", of what stands in the file')
