# SPDX-License-Identifier: BSD-3-Clause
"""Every text of the device window that a person may read, found in its sources."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import palpate

PACKAGE = Path(palpate.__file__).parent
CONTEXT = "Device"


def find_spoken() -> set[tuple[str, str]]:
    """(context, English text)"""
    files = [*(PACKAGE / "device_window").glob("*.py"), *(PACKAGE / "device").glob("*.py")]
    return {said for file in files for said in read_calls(file)}


def read_calls(file: Path) -> Iterator[tuple[str, str]]:
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.Call):
            continue
        name = getattr(node.func, "id", getattr(node.func, "attr", ""))
        texts = [a.value if isinstance(a, ast.Constant) else None for a in node.args]
        if name == "translate" and len(texts) == 2 and None not in texts:
            yield texts[0], texts[1]
        elif name in ("sentence", "PoorData") and texts and texts[0] is not None:
            yield CONTEXT, texts[0]
