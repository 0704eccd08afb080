# SPDX-License-Identifier: GPL-3.0-or-later
"""Every text of the editor that a person may read, found in its sources."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import palpate_editor
from palpate_editor.document.constants import CONSTANTS, LAW_NAMES, VALUE_NAMES
from palpate_editor.edits import EVERY_EDIT
from palpate_editor.shipped import list_tissues
from palpate_editor.tissue_library import read_library

SOURCES = Path(palpate_editor.__file__).parent
Spoken = set[tuple[str, str]]
"""(context, English text)."""


def text_of(node: ast.expr) -> str | None:
    """A literal, also one that is put together of several."""
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def name_of(call: ast.Call) -> str:
    function = call.func
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def read_calls(node: ast.AST, owner: str = "") -> Iterator[tuple[str, str]]:
    """(context, text) of every call that translates, within a class or not."""
    for child in ast.iter_child_nodes(node):
        inside = child.name if isinstance(child, ast.ClassDef) else owner
        if isinstance(child, ast.Call) and child.args:
            name, text = name_of(child), text_of(child.args[0])
            is_method = isinstance(child.func, ast.Attribute)
            if name == "tr" and text is not None:
                yield (inside if is_method else "Editor"), text
            elif name == "phrase" and text is not None:
                yield "phrases", text
            elif name == "translate" and text is not None and len(child.args) > 1:
                said = text_of(child.args[1])
                if said is not None:
                    yield text, said
        if (
            isinstance(child, ast.Assign)
            and isinstance(child.value, ast.Constant | ast.IfExp)
            and any(
                isinstance(target, ast.Name) and target.id == "template" for target in child.targets
            )
        ):
            literals = (text_of(part) for part in ast.walk(child) if isinstance(part, ast.Constant))
            yield from (("phrases", text) for text in literals if text is not None)
        yield from read_calls(child, inside)


def find_titles() -> Iterator[str]:
    """What edits are called in the history."""
    for edit in EVERY_EDIT:
        if isinstance(vars(edit).get("title"), str):
            yield edit.title


def find_spoken() -> Spoken:
    found: Spoken = set()
    for file in sorted(SOURCES.rglob("*.py")):
        found |= set(read_calls(ast.parse(file.read_text(encoding="utf-8"))))
    found |= {("edits", title) for title in find_titles()}
    for constant in CONSTANTS:
        found.add(("constants", constant.label))
        if constant.absent:
            found.add(("constants", constant.absent))
    for name in (*LAW_NAMES.values(), *VALUE_NAMES.values(), "none"):
        found.add(("constants", name))
    for tissue in list_tissues():
        for text in (tissue.note, *(value.method for value in tissue.published)):
            found.add(("tissues", " ".join(text.split())))
    for tissue in read_library(own=False):
        texts = [tissue.note] if tissue.shipped else [tissue.note, tissue.title]
        texts += [t for v in tissue.values for t in (v.method, v.setting, v.rate) if t != "unknown"]
        found |= {("tissues", " ".join(text.split())) for text in texts if text}
    return found
