# SPDX-License-Identifier: GPL-3.0-or-later
"""Text that is read by lines: numbers of them, and where one is that is none."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import numpy as np

from palpate_editor.formats_child.gmsh_values import TextValues
from palpate_editor.formats_child.scene import Refusal

Line = tuple[int, str]
"""Its number in the file, counted from 1, and what stands in it."""


def read_lines(path: str, comment: str = "") -> list[Line]:
    """The lines that are not empty, without what follows a comment's sign."""
    with open(path, "rb") as file:
        content = file.read()
    lines = []
    for number, raw in enumerate(content.decode("latin-1").splitlines(), 1):
        text = raw.split(comment, 1)[0] if comment else raw
        if text.strip():
            lines.append((number, text.rstrip()))
    return lines


def parse_reals(words: Sequence[str], where: Line | int) -> list[float]:
    """Raises Refusal. Fortran's exponents, as in 1.0D-3, are numbers too."""
    number = where if isinstance(where, int) else where[0]
    try:
        return [float(word) for word in words]
    except ValueError:
        return [parse_real(word, number) for word in words]


def parse_real(word: str, line: int) -> float:
    """With the exponents of Fortran and Nastran: 1.0D-3, 1.0-3."""
    plain = re.sub(r"(?<=[\d.])[dD](?=[-+\d])", "e", word.strip())
    plain = re.sub(r"(?<=[\d.])(?=[-+]\d+$)", "e", plain)
    try:
        return float(plain)
    except ValueError:
        raise Refusal(f"line {line}", f"'{word.strip()[:40]}'", "a number") from None


def parse_ints(words: Sequence[str], where: Line | int) -> list[int]:
    """Raises Refusal."""
    try:
        return [int(word) for word in words]
    except ValueError:
        number = where if isinstance(where, int) else where[0]
        wrong = next(word for word in words if not re.fullmatch(r"\s*[-+]?\d+\s*", word))
        got = f"'{wrong.strip()[:40]}'"
        raise Refusal(f"line {number}", got, "a whole number") from None


def take_table(lines: list[Line], columns: int, what: str) -> np.ndarray:
    """(n, columns) Numbers of lines that all have at least so many. Raises Refusal."""
    if not lines:
        return np.empty((0, columns))
    text = "\n".join(text for _, text in lines).replace(",", " ")
    try:
        values = TextValues("", text.encode()).values
        if len(values) % len(lines) == 0 and len(values) >= columns * len(lines):
            table = values.reshape(len(lines), -1)
            if is_even(lines, table.shape[1]):
                return table[:, :columns]
    except Refusal:
        pass  # the lines below say which of them it is
    return np.array([take_row(line, columns, what) for line in lines])


def is_even(lines: list[Line], width: int) -> bool:
    return all(len(text.replace(",", " ").split()) == width for _, text in lines)


def take_row(line: Line, columns: int, what: str) -> list[float]:
    words = line[1].replace(",", " ").split()
    if len(words) < columns:
        raise Refusal(f"line {line[0]}", f"{len(words)} numbers", f"{columns} of {what}")
    return parse_reals(words[:columns], line)


def take_whole(lines: list[Line], columns: int, what: str) -> np.ndarray:
    """The same of whole numbers."""
    return TextValues(where_of(lines), b"").to_whole(take_table(lines, columns, what), what)


def where_of(lines: list[Line]) -> str:
    return f"lines {lines[0][0]} to {lines[-1][0]}" if lines else ""


def count_columns(line: Line) -> int:
    return len(line[1].replace(",", " ").split())


def split_blocks(lines: list[Line], mark: str) -> Iterator[tuple[Line, list[Line]]]:
    """Each line that begins with `mark`, and those up to the next. What stands before the first is
    passed over."""
    head: Line | None = None
    block: list[Line] = []
    for line in lines:
        if line[1].startswith(mark):
            if head is not None:
                yield head, block
            head, block = line, []
        else:
            block.append(line)
    if head is not None:
        yield head, block
