# SPDX-License-Identifier: BSD-3-Clause
"""Text is read and written as UTF-8 by name: what the locale says is another on other machines, and
a library that a process imports may change it (GDCM, by way of SimpleITK, sets it to "C")."""

from __future__ import annotations

import ast

import pytest
from tree import read, source_files

RUNS = ("run", "Popen", "check_output", "check_call")


def find_keyword(call: ast.Call, *names: str) -> ast.expr | None:
    return next((word.value for word in call.keywords if word.arg in names), None)


def is_text_mode(mode: ast.expr | None) -> bool:
    """Whether it is a literal mode of open() without b."""
    text = mode.value if isinstance(mode, ast.Constant) else None
    return isinstance(text, str) and set(text) <= set("rwaxt+")


def takes_locale(call: ast.Call) -> bool:
    """Whether what it reads or writes is encoded as the locale says."""
    function = call.func
    name = getattr(function, "attr", getattr(function, "id", ""))
    of_a_thing = isinstance(function, ast.Attribute)
    if find_keyword(call, "encoding") or any(word.arg is None for word in call.keywords):
        return False
    if name in ("read_text", "write_text"):
        return of_a_thing and len(call.args) == (name == "write_text")
    if name == "open":
        given = call.args[0 if of_a_thing else 1 :]
        mode = given[0] if given else find_keyword(call, "mode")
        return is_text_mode(mode) or mode is None and not of_a_thing
    if name in RUNS:
        return find_keyword(call, "text", "universal_newlines") is not None
    return False


def find_faults(source: str) -> list[int]:
    """Lines of the calls that take the locale's encoding."""
    calls = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)]
    return [call.lineno for call in calls if takes_locale(call)]


def test_what_is_read_and_written_as_text_names_its_encoding():
    names = [name for name in source_files() if name.endswith((".py", ".pyi"))]
    assert [f"{name}:{line}" for name in names for line in find_faults(read(name))] == []


@pytest.mark.parametrize(
    "fault",
    ["a.read_text()", "a.write_text(b)", "open(a)", 'open(a, "w")',
     'a.open("w")', 'open(a, mode="a")',
     "subprocess.run(a, text=True)"],
)  # fmt: skip
def test_the_rule_finds(fault):
    assert find_faults(fault) == [1]


@pytest.mark.parametrize(
    "right",
    ['a.read_text(encoding="utf-8")', 'a.write_text(b, encoding="utf-8")',
     'open(a, "rb")', "a.open()",
     'a.open("wb")', "subprocess.run(a)", 'subprocess.run(a, encoding="utf-8")', "open(a, **how)"],
)  # fmt: skip
def test_the_rule_lets_pass(right):
    assert find_faults(right) == []
