# SPDX-License-Identifier: BSD-3-Clause
"""Sentences that the C++ core refuses with, found in its sources as templates with %1 to %9."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

CORE = Path(__file__).resolve().parents[2] / "core"
FILES = (
    *("authoring/read_mesh.cpp", "authoring/import_mesh.cpp", "authoring/run_reader.cpp"),
    *("authoring/read_mesh_child/read_binary_stl.cpp", "authoring/read_mesh_child/main.cpp"),
    *("authoring/read_mesh_child/read_with_assimp.cpp", "authoring/units.cpp"),
    *("scenario/archive.cpp", "scenario/whole_file.cpp", "sim/base/whole_file.cpp"),
    *("sim/haptics/serial_transport.cpp", "sim/haptics/serial_device.cpp"),
    *("sim/haptics/serial_link_status.cpp", "sim/haptics/pty_device.cpp"),
)
"""Where what a window opens is read: meshes, organs, published files, devices."""
CALL = re.compile(r"\b(?:throw FileError|throw NotDurable|throw DeviceError|(?<!void )refuse)\(")
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
TOLD = re.compile(
    r"std::string (?:SerialLink::explain_silence\(\) const|name_end\(int status\)) \{(.*?)\n\}",
    re.DOTALL,
)
"""Functions that give what was found."""
ADVICE = re.compile(r'\? "(; [^"]*)"')


def find_sentences() -> set[str]:
    """Of all FILES, where they have words of their own."""
    found = {text for name in FILES for text in read_file(CORE / name)}
    return {text for text in found if re.search(r"[a-z]{2}", text)}


def read_file(path: Path) -> Iterator[str]:
    source = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
    for call in CALL.finditer(source):
        arguments = split(close(source[call.end() :]), ",")
        # of (file, where, found, expected) and (where, found, expected) the last two are words
        for argument in arguments[-2:] if len(arguments) > 1 else arguments:
            yield from build_templates(argument)
    for body in TOLD.findall(source):
        for told in re.findall(r"return (.*?);", body, re.DOTALL):
            yield from build_templates(told)
    yield from ADVICE.findall(source)


def close(text: str) -> str:
    """Up to the bracket that closes what is open."""
    depth = 1
    for place, _ in outside_literals(text):
        depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return text[:place]
    raise AssertionError(f"no end of {text[:60]!r}")


def split(text: str, mark: str) -> list[str]:
    """At the marks that stand in no bracket."""
    parts, start, depth = [], 0, 0
    for place, letter in outside_literals(text):
        depth += {"(": 1, "{": 1, "[": 1, ")": -1, "}": -1, "]": -1}.get(letter, 0)
        if letter == mark and depth == 0:
            parts.append(text[start:place])
            start = place + 1
    return [*parts, text[start:]]


def outside_literals(text: str) -> Iterator[tuple[int, str]]:
    inside = [False] * len(text)
    for literal in re.finditer(r"\"(?:[^\"\\]|\\.)*\"|'(?:[^'\\]|\\.)+'", text):
        inside[literal.start() : literal.end()] = [True] * len(literal.group())
    return ((k, letter) for k, letter in enumerate(text) if not inside[k])


def build_templates(expression: str) -> Iterator[str]:
    """What an expression may say: "5 bytes" comes of `std::to_string(n) + " bytes"` as %1 bytes."""
    for branch in split_branches(expression):
        text, place = "", 0
        for part in split(branch, "+"):
            bare = re.sub(r"^std::string\((.*)\)$", r"\1", part.strip(), flags=re.DOTALL)
            said = "".join(LITERAL.findall(bare))
            if re.sub(LITERAL, "", bare).strip() == "":
                text += said.replace('\\"', '"')
            else:
                place += 1
                text += f"%{place}"
        yield text


def split_branches(expression: str) -> list[str]:
    """Both answers of a question."""
    asked = split(expression, "?")
    if len(asked) == 1:
        return [expression]
    answers = "?".join(asked[1:])
    # the mark of a scope is no colon of a question
    parts = split(answers.replace("::", "\0\0"), ":")
    return [part.replace("\0\0", "::") for part in parts]
