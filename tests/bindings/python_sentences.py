# SPDX-License-Identifier: BSD-3-Clause
"""Sentences that the Python packages refuse with, found in their sources as templates with %1.

Every file is read but for those that no window comes to: a new file is read until it is named here.
"""

from __future__ import annotations

import ast
import itertools
from collections.abc import Iterator
from pathlib import Path

import palpate
from core_sentences import divide, has_words

PACKAGES = (Path(palpate.__file__).parent, Path(__file__).resolve().parents[2] / "editor")
COMMAND_LINE = (
    *("bench/", "study/", "verbs/", "cli/", "command/", "device/link.py", "device/names.py"),
    *(
        "runs/play.py",
        "runs/press.py",
        "runs/replay.py",
        "runs/run.py",
        "runs/script_file.py",
        "system/display.py",
    ),
    *("demo.py", "kinds.py", "argument_text.py", "draw_windows.py"),
)
"""Refuse what is typed, before a window opens or without one."""
PROGRAMS = (
    *("render/", "viewport/scenery.py", "refused_call.py", "translation/", "runs/live.py"),
    *("views/touch/force_trace.py", "document/surface.py", "document/organ.py", "app/settings.py"),
    *("app/session.py", "appearance.py", "python_device.py"),
)
"""Refuse arguments that only a program can get wrong: the windows never hand them over."""
PLACED = ("Refusal", "EditRefusal", "FileError", "NotDurable", "BadValue")
"""Take file, where, found and expected."""
PLAIN = ("ValueError", "RuntimeError", "OSError", "WrongCall")
NOTED = (
    *("list_changes", "describe_cells", "describe_tetrahedra", "describe_own"),
    *("describe_refilled", "find_fault"),
)
"""Functions that give notes, as do calls of notes.append()."""
TOLD = ("find_appearance_fault",)
"""Functions that give where, found and expected."""
REASONS = ("unit_reason", "up_reason")
"""Arguments that say why a unit or an axis was chosen."""
CHECKED = "layout"
"""The folder whose checks give a `Problem` of how bad, where and what ..."""
DESCRIBED = ("describe", "describe_slow_press")
"""... or, of these names, part of it."""
KINDS = "KINDS"
"""The table of json_part.py that says what a field takes."""
CUT_ENDS = "CUT_ENDS"
"""The table of from_scan.py with a note for each side."""
Scope = dict[str, list[ast.expr]]
"""Name -> what is assigned to it."""


def find_sentences() -> set[str]:
    found = {text for file in list_files() for text in read_file(file)}
    return {text for text in found if has_words(text)}


def list_files() -> Iterator[Path]:
    for package in PACKAGES:
        for file in sorted(package.rglob("*.py")):
            name = file.relative_to(package).as_posix().removeprefix("palpate_editor/")
            if not name.startswith(COMMAND_LINE + PROGRAMS):
                yield file


def read_file(file: Path) -> Iterator[str]:
    tree = ast.parse(file.read_text(encoding="utf-8"))
    constants = collect(tree.body)
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            scope = constants | collect(list(ast.walk(node)))
            for call in find_raised(node):
                yield from read_call(call, scope)
            if file.parent.name == CHECKED:
                for told in find_problems(node):
                    yield from build(expand(told, scope), scope)
            for part in find_faults(node):
                yield from build(part, scope)
            if node.name in TOLD:
                for told in find_told(node):
                    yield from (text for part in told[-2:] for text in build(part, scope))
            if "palpate_editor" in file.parts:
                for note in find_noted(node):
                    yield from build(note, scope)
    for node in ast.walk(tree):
        if isinstance(node, ast.keyword) and node.arg in REASONS:
            yield from (text for text in build(node.value, constants) if text != "%1")
    for table in constants.get(CUT_ENDS, []):
        if isinstance(table, ast.Dict):
            yield from (text for value in table.values for text in build(value, {}))
    for table in constants.get(KINDS, []):
        if isinstance(table, ast.Dict):
            rows = [row.elts[0] for row in table.values if isinstance(row, ast.Tuple)]
            yield from (text for row in rows for text in build(row, {}))


def collect(nodes: list[ast.AST] | list[ast.stmt]) -> Scope:
    scope: Scope = {}
    for node in nodes:
        targets = node.targets if isinstance(node, ast.Assign) else []
        if isinstance(node, ast.AnnAssign) and node.value is not None:
            targets = [node.target]
        for target in targets:
            if isinstance(target, ast.Name):
                scope.setdefault(target.id, []).append(node.value)
            elif isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple):
                for name, value in zip(target.elts, node.value.elts, strict=True):
                    if isinstance(name, ast.Name):
                        scope.setdefault(name.id, []).append(value)
    return scope


def find_raised(function: ast.FunctionDef) -> Iterator[ast.Call]:
    for node in ast.walk(function):
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
            yield node.exc


def find_noted(function: ast.FunctionDef) -> Iterator[ast.expr]:
    for node in ast.walk(function):
        if isinstance(node, ast.Return | ast.Yield) and function.name in NOTED and node.value:
            yield node.value
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "notes.append":
            yield node.args[0]


def find_faults(function: ast.FunctionDef) -> Iterator[ast.expr]:
    """Found and expected of a layout's."""
    for node in ast.walk(function):
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "Fault":
            yield from node.args[1:]


def find_problems(function: ast.FunctionDef) -> Iterator[ast.expr]:
    for node in ast.walk(function):
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "Problem":
            yield node.args[2]
        if isinstance(node, ast.Return) and function.name in DESCRIBED and node.value:
            yield node.value


def expand(node: ast.expr, scope: Scope) -> ast.expr:
    """With names that stand for texts in place of their values in an f-string."""
    if isinstance(node, ast.Name) and len(scope.get(node.id, ())) == 1:
        return expand(scope[node.id][0], scope)
    if not isinstance(node, ast.JoinedStr):
        return node
    texts = ast.JoinedStr | ast.IfExp
    values = []
    for part in node.values:
        named = part.value if isinstance(part, ast.FormattedValue) else None
        found = scope.get(named.id, ()) if isinstance(named, ast.Name) else ()
        values.append(found[0] if len(found) == 1 and isinstance(found[0], texts) else part)
    return ast.JoinedStr(values)


def find_told(function: ast.FunctionDef) -> Iterator[list[ast.expr]]:
    for node in ast.walk(function):
        if isinstance(node, ast.Return) and isinstance(node.value, ast.Tuple):
            yield node.value.elts


def read_call(call: ast.Call, scope: Scope) -> Iterator[str]:
    name = getattr(call.func, "id", getattr(call.func, "attr", ""))
    if name in PLACED:
        parts = [part for part in call.args[2:] if not isinstance(part, ast.Starred)]
        yield from (text for part in parts for text in build(part, scope))
    elif name in PLAIN and call.args:
        # OSError(number, text, file)
        told = call.args[1 if name == "OSError" and len(call.args) > 1 else 0]
        for template in build(told, scope):
            yield from divide(template)


def build(node: ast.expr, scope: Scope) -> Iterator[str]:
    """What an expression may say: f"{n} bytes" comes as %1 bytes."""
    for parts in spell(node, scope):
        template, place = "", 0
        for part in parts:
            place += part is None
            template += f"%{place}" if part is None else part
        yield template


def spell(node: ast.expr, scope: Scope) -> Iterator[list[str | None]]:
    """Texts, and None where a value stands."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield [node.value]
    elif isinstance(node, ast.JoinedStr):
        choices = [list(spell(part, scope)) for part in node.values]
        yield from (list(itertools.chain(*chosen)) for chosen in itertools.product(*choices))
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        for left in spell(node.left, scope):
            yield from (left + right for right in spell(node.right, scope))
    elif isinstance(node, ast.IfExp):
        yield from spell(node.body, scope)
        yield from spell(node.orelse, scope)
    elif isinstance(node, ast.Name) and node.id in scope and node.id != "FORMAT":
        yield from itertools.chain(*(spell(value, {}) for value in scope[node.id]))
    else:
        yield [None]
