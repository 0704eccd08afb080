# SPDX-License-Identifier: BSD-3-Clause
"""What the headers of core/sim declare, read well enough for the house's own style.

Not a C++ parser: it follows braces and semicolons, and takes apart the few kinds of declaration
that ARCHITECTURE allows in a header. What it does not know it refuses, so nothing slips by unseen.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

SKIPPED = re.compile(
    r"(?:template\b|using\b|static_assert\b|explicit\s+operator\b|friend\b|struct\s+\w+$"
    r"|class\s+\w+$|typedef\b)"
)
"""Declarations without a name of their own that Python could mirror."""


@dataclass
class Function:
    name: str
    parameters: list[str]


@dataclass
class Type:
    name: str
    fields: list[str] = field(default_factory=list)
    constants: list[str] = field(default_factory=list)
    values: list[str] = field(default_factory=list)
    functions: list[Function] = field(default_factory=list)
    types: list[Type] = field(default_factory=list)


@cache
def read_header(path: Path) -> Type:
    """Everything a header declares, as one nameless type; namespaces are looked through. The files
    do not change while tests run, and nobody changes what was read."""
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r"^\s*#[^\n]*", "", text, flags=re.MULTILINE)
    whole = Type("")
    read_scope(text, whole, private=False)
    return whole


def split_statements(text: str) -> Iterator[tuple[str, str | None]]:
    """(head, body) of every declaration: body is what stands in its braces, None without."""
    at = start = depth = 0
    while at < len(text):
        letter = text[at]
        if letter == '"':
            at = text.index('"', at + 1) + 1
            continue
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if letter == ";" and depth == 0:
            yield text[start:at].strip(), None
            start = at + 1
        elif letter == "{" and depth == 0:
            end = find_brace(text, at)
            yield text[start:at].strip(), text[at + 1 : end]
            at = start = end
            start += 1
        at += 1


def find_brace(text: str, opening: int) -> int:
    depth = 0
    quoted = False
    for at in range(opening, len(text)):
        quoted ^= text[at] == '"'
        if quoted:
            continue
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return at
    raise ValueError("a brace that is never closed")


def read_scope(text: str, scope: Type, private: bool) -> None:
    initialised = False
    for head, body in split_statements(text):
        if initialised and body is None and "(" not in head:
            # what stands between `}` and `;` of `int count{0};` or `struct {...} scratch;`
            initialised = False
            if re.fullmatch(r"\w+", head) and not private:
                scope.fields.append(head)
            if not head or re.fullmatch(r"\w+", head):
                continue
        initialised = False
        while label := re.match(r"(public|private|protected)\s*:", head):
            private = label[1] != "public"
            head = head[label.end() :].strip()
        if re.match(r"namespace\b", head):
            read_scope(body or "", scope, private)
        elif private or not head or SKIPPED.match(head) and body is None:
            initialised = body is not None
        elif kind := re.match(r"enum class (\w+)", head):
            scope.types.append(Type(kind[1], values=re.findall(r"(?:^|,)\s*(\w+)", body or "")))
            initialised = True
        elif kind := re.match(r"(struct|class) (?:alignas\(\w+\) )?(\w+)", head):
            inner = Type(kind[2])
            read_scope(body or "", inner, private=kind[1] == "class")
            scope.types.append(inner)
            initialised = True
        elif "(" in head and not is_field(head):
            read_function(head, scope)
        elif not SKIPPED.match(head):
            read_fields(head, scope)
            initialised = body is not None


def is_field(head: str) -> bool:
    """`Vec3 position = Vec3::Zero()` has parentheses, but only after the equals sign."""
    return "=" in head.partition("(")[0]


def read_function(head: str, scope: Type) -> None:
    if re.search(r"=\s*delete$", head) or "operator" in head.partition("(")[0] or "~" in head:
        return
    if SKIPPED.match(head):
        return
    match = re.search(r"(\w+)\s*\(", head)
    assert match, head
    end, depth = match.end(), 1
    while depth:
        depth += {"(": 1, ")": -1}.get(head[end], 0)
        end += 1
    parameters = [name_parameter(p) for p in split_parameters(head[match.end() : end - 1])]
    scope.functions.append(Function(match[1], parameters))


def split_parameters(text: str) -> Iterator[str]:
    depth, start = 0, 0
    for at, letter in enumerate(text):
        depth += {"(": 1, "<": 1, "{": 1, ")": -1, ">": -1, "}": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            yield text[start:at]
            start = at + 1
    if text[start:].strip():
        yield text[start:]


def name_parameter(text: str) -> str:
    """The name, or '' for a parameter that has none."""
    match = re.search(r"[&*>\s](\w+)$", text.partition("=")[0].strip())
    return match[1] if match else ""


def read_fields(head: str, scope: Type) -> None:
    """`double low, high = 0.0` declares two fields; constants are told from them."""
    constant = re.match(r"(?:inline |static )*constexpr\b", head)
    names = []
    for part in split_parameters(head):
        match = re.search(r"(\w+)$", part.partition("=")[0].strip())
        assert match, f"not understood: {head}"
        names.append(match[1])
    (scope.constants if constant else scope.fields).extend(names)
