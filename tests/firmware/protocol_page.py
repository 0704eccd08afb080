# SPDX-License-Identifier: BSD-3-Clause
"""What firmware/protocol/PROTOCOL.md says, parsed: nothing of the protocol is written down here."""

from __future__ import annotations

import math
import re
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

PAGE = Path(__file__).resolve().parents[2] / "firmware" / "protocol" / "PROTOCOL.md"
SIZES = {"u8": "B", "u16": "H", "u32": "I", "i16": "h", "i32": "i"}
FIELD = re.compile(r"(?:and )?([a-z_][a-z_ 0-9+]*?) (u8|u16|u32|i16|i32)(?:\[(\d+)\])?")


@dataclass(frozen=True)
class Field:
    name: str
    code: str
    """Of struct."""
    count: int

    def size(self) -> int:
        return struct.calcsize("<" + self.code) * self.count


def read_fields(text: str) -> list[Field]:
    return [Field(name, SIZES[kind], int(count or 1)) for name, kind, count in FIELD.findall(text)]


def pack(fields: list[Field], values: dict[str, Any]) -> bytes:
    """Every value of the fields, and no other: what is missing is a KeyError."""
    data = b""
    for field in fields:
        value = values[field.name]
        row = value if field.count > 1 else [value]
        data += struct.pack(f"<{field.count}{field.code}", *row)
    return data


def unpack(fields: list[Field], data: bytes) -> dict[str, Any]:
    values: dict[str, Any] = {}
    at = 0
    for field in fields:
        row = struct.unpack_from(f"<{field.count}{field.code}", data, at)
        values[field.name] = row if field.count > 1 else row[0]
        at += field.size()
    return values


@dataclass(frozen=True)
class Message:
    code: int
    fields: list[Field]
    more: list[Field]
    """That a COMMAND has with flag bit 0."""


class Page:
    """The tables and formulas of the page."""

    def __init__(self) -> None:
        self.text = PAGE.read_text(encoding="utf-8")
        self.messages = dict(self._read_messages())
        self.numbers = {
            row[0]: float(row[1]) if "." in row[1] else int(row[1], 0)
            for row in self._rows("Numbers")
            if row[0] != "name"
        }
        modes = [row[0].split() for row in self._rows("Modes") if row[0][:1].isdigit()]
        self.modes = {name: int(number) for number, name in modes}
        faults = [row for row in self._rows("Torque, and its end") if row[0].isdigit()]
        self.faults = {row[1]: int(row[0]) for row in faults}
        told = re.search(r"Results of ANSWER: (.*?)\.", self.text, re.DOTALL)
        assert told
        pairs = re.findall(r"(\d+) ([^,]+)", " ".join(told[1].split()))
        self.results = {words: int(number) for number, words in pairs}
        self.calibration = dict(self._read_calibration())

    def _section(self, title: str) -> str:
        return self.text.split(f"\n## {title}\n")[1].split("\n## ")[0]

    def _rows(self, title: str) -> list[list[str]]:
        lines = [
            line
            for line in self._section(title).splitlines()
            if line.startswith("|") and "---" not in line
        ]
        return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]

    def _read_messages(self):
        for title in ("To the device", "From the device"):
            last = None
            for code, name, body, size in self._rows(title):
                if code.startswith("0x"):
                    fields = read_fields(body)
                    assert 2 + sum(field.size() for field in fields) == int(size), name
                    last = Message(int(code, 16), fields, [])
                    yield name, last
                elif name.startswith("with"):
                    last.more.extend(read_fields(body))
                    size_of_all = sum(field.size() for field in (*last.fields, *last.more))
                    assert 2 + size_of_all == int(size), name

    def _read_calibration(self):
        """(offset, fields, how many of them in a row) by the first field's name."""
        for offset, what, _ in self._rows("Calibration"):
            if not offset.isdigit():
                continue
            repeat = re.match(r"(\w+) \[(\d+)\] of \d+ bytes: (.*)", what)
            if repeat:
                yield repeat[1], (int(offset), read_fields(repeat[3]), int(repeat[2]))
            else:
                fields = read_fields(what)
                yield fields[0].name, (int(offset), fields, 1)

    def read_calibration(self, data: bytes) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for name, (offset, fields, count) in self.calibration.items():
            size = sum(field.size() for field in fields)
            rows = [unpack(fields, data[offset + k * size :]) for k in range(count)]
            found[name] = rows if count > 1 else rows[0][name]
        return found

    def formula(self, name: str, names: dict[str, Any]) -> Any:
        """What the line NAME = ... under "From counts to newtons" gives."""
        line = re.search(rf"^    {re.escape(name)} = (.*)$", self.text, re.MULTILINE)
        assert line, name
        words = line[1].split("), ")[0] + ")" if "), " in line[1] else line[1]
        functions = {"cos": math.cos, "sin": math.sin, "rad": 1.0}
        return eval(to_python(words), {"__builtins__": {}}, functions | names)


TOKEN = re.compile(r"\d[\d.e-]*|[A-Za-z_]\w*(?:\[\w+\])?|[-+/(),]")


def to_python(words: str) -> str:
    """Formulas as people write them: what stands side by side is multiplied."""
    made = ""
    before = ""
    call = False
    for token in TOKEN.findall(words):
        begins = token[0].isalnum() or token == "("
        if begins and before and (before[-1].isalnum() or before[-1] in ")]"):
            made += "" if call else "*"
        if call:
            made += f"({token})"
            call, before = False, ")"
            continue
        made += token
        call = token in ("cos", "sin")
        before = token
    return made
