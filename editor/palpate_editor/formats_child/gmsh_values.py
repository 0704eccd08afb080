# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers in a section of a file of Gmsh, one after the other, text or binary."""

from __future__ import annotations

import re
import warnings
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from palpate_editor.formats_child.scene import Refusal

NOWHERE = rb"[-+]?(?:1\.#(?:QNAN|SNAN|IND|INF)\w*|nan\(\w*\))"
"""How programs for Windows write what is no number."""


@dataclass(frozen=True)
class Sections:
    """Opens the sections of a file by their names."""

    content: bytes
    is_text: bool
    order: str
    """Of the bytes: < or >."""
    size: int
    """[bytes] of a count."""

    def find(self, *names: str) -> Values | None:
        """The first of these sections that is there."""
        for name in names:
            start = re.search(rf"\${name}[ \t]*\r?\n".encode(), self.content)
            if start:
                return self.open(name, start.end())
        return None

    def __call__(self, *names: str) -> Values:
        """Raises Refusal."""
        found = self.find(*names)
        if found is None:
            raise Refusal("", f"no ${names[0]}", f"${names[0]}, which a mesh of Gmsh has")
        return found

    def open(self, name: str, start: int) -> Values:
        if not self.is_text:
            return BinaryValues(f"${name}", self.content, start, self.order, self.size)
        end = self.content.find(b"$", start)
        return TextValues(f"${name}", self.content[start : end if end >= 0 else len(self.content)])


def open_values(content: bytes, is_text: bool, order: str = "<", size: int = 8) -> Sections:
    return Sections(content, is_text, order, size)


class Values(ABC):
    """Takes numbers from the front. All raise Refusal where there are too few."""

    def __init__(self, section: str):
        self.section = section

    @abstractmethod
    def take_count(self, what: str) -> int:
        """A line that says how many there are, of versions 1 and 2."""

    @abstractmethod
    def take_ints(self, count: int, what: str) -> np.ndarray:
        """Whole numbers of four bytes."""

    @abstractmethod
    def take_sizes(self, count: int, what: str) -> np.ndarray:
        """Whole numbers of as many bytes as a count has."""

    @abstractmethod
    def take_reals(self, count: int, what: str) -> np.ndarray:
        """Numbers of eight bytes."""

    @abstractmethod
    def take_records(
        self, count: int, what: str, ints: int, reals: int
    ) -> tuple[np.ndarray, np.ndarray]:
        """Rows of so many whole numbers and so many others: (count, ints) and (count, reals)."""

    @abstractmethod
    def count_left(self) -> int:
        """Numbers that may follow, at most."""

    def check(self, count: int, each: int, what: str) -> None:
        """Refuses a count that the rest of the file cannot hold, before memory is taken for it."""
        if count < 0 or count * each > self.count_left():
            self.refuse_end(f"{count} {what}")

    def refuse_end(self, expected: str) -> None:
        raise Refusal(self.section, "its end", expected)


class TextValues(Values):
    def __init__(self, section: str, text: bytes):
        super().__init__(section)
        self.at = 0
        self.values = self.parse(text)

    def parse(self, text: bytes) -> np.ndarray:
        if b"#" in text or b"(" in text:
            text = re.sub(NOWHERE, b"nan", text, flags=re.IGNORECASE)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                return np.fromstring(text, sep=" ")
            except (ValueError, DeprecationWarning):
                word, line = find_no_number(text)
                where = f"{self.section}, line {line} of it" if self.section else f"line {line}"
                raise Refusal(where, f"'{word[:40]}'", "a number") from None

    def count_left(self) -> int:
        return len(self.values) - self.at

    def take_reals(self, count: int, what: str) -> np.ndarray:
        if count < 0 or self.count_left() < count:
            self.refuse_end(f"more {what}")
        self.at += count
        return self.values[self.at - count : self.at]

    def take_ints(self, count: int, what: str) -> np.ndarray:
        return self.to_whole(self.take_reals(count, what), what)

    def to_whole(self, values: np.ndarray, what: str) -> np.ndarray:
        wrong = ~(np.abs(values) < 2.0**53) | (values != np.floor(values))
        if wrong.any():
            got = float(values[wrong].flat[0])
            raise Refusal(self.section, f"{got:g}", f"whole numbers of {what}")
        return values.astype(np.int64)

    take_sizes = take_ints

    def take_count(self, what: str) -> int:
        count = int(self.take_ints(1, what)[0])
        self.check(count, 3, what)
        return count

    def take_records(
        self, count: int, what: str, ints: int, reals: int
    ) -> tuple[np.ndarray, np.ndarray]:
        self.check(count, ints + reals, what)
        rows = self.take_reals(count * (ints + reals), what).reshape(count, ints + reals)
        return self.to_whole(rows[:, :ints], what), rows[:, ints:]

    def peek(self, count: int, what: str) -> np.ndarray:
        """The next numbers, which stay."""
        found = self.take_ints(count, what)
        self.at -= count
        return found

    def take_like(self, size: int, lead: int, most: int, what: str) -> np.ndarray:
        """As many rows of `size` numbers as begin like the first: the numbers after the first, up
        to `lead`, say what kind of row it is."""
        whole = min(most, self.count_left() // size)
        if whole == 0:
            self.refuse_end(f"more {what}")
        first = self.values[self.at + 1 : self.at + lead]
        found = 0
        for chunk in double(64, whole):
            rows = self.values[self.at + found * size : self.at + chunk * size].reshape(-1, size)
            other = np.flatnonzero((rows[:, 1:lead] != first).any(axis=1))
            found += int(other[0]) if len(other) else len(rows)
            if len(other):
                break
        return self.take_ints(found * size, what).reshape(found, size)


def double(first: int, last: int) -> Iterator[int]:
    """first, twice that, ... and last."""
    while first < last:
        yield first
        first *= 2
    yield last


def find_no_number(text: bytes) -> tuple[str, int]:
    """The first word that is no number, and its line, counted from 1."""
    for number, line in enumerate(text.splitlines(), 1):
        for word in line.split():
            try:
                float(word)
            except ValueError:
                return word.decode(errors="replace"), number
    return "", 1


class BinaryValues(Values):
    def __init__(self, section: str, content: bytes, start: int, order: str, size: int):
        super().__init__(section)
        self.content, self.at = content, start
        self.int, self.real = np.dtype(order + "i4"), np.dtype(order + "f8")
        self.size = np.dtype(f"{order}u{size}")

    def count_left(self) -> int:
        return (len(self.content) - self.at) // 4

    def take(self, kind: np.dtype, count: int, what: str) -> np.ndarray:
        if count < 0 or (len(self.content) - self.at) < count * kind.itemsize:
            self.refuse_end(f"more {what}")
        found = np.frombuffer(self.content, kind, count, self.at)
        self.at += count * kind.itemsize
        return found

    def take_ints(self, count: int, what: str) -> np.ndarray:
        return self.take(self.int, count, what).astype(np.int64)

    def take_sizes(self, count: int, what: str) -> np.ndarray:
        return self.take(self.size, count, what).astype(np.int64)

    def take_reals(self, count: int, what: str) -> np.ndarray:
        return self.take(self.real, count, what).astype(float)

    def take_count(self, what: str) -> int:
        """It stands in text even here."""
        line = re.compile(rb"[ \t]*(\d{1,15})[ \t]*\r?\n").match(self.content, self.at)
        if line is None:
            raise Refusal(self.section, "no number", f"how many {what} there are")
        self.at = line.end()
        count = int(line.group(1))
        self.check(count, 3, what)
        return count

    def take_records(
        self, count: int, what: str, ints: int, reals: int
    ) -> tuple[np.ndarray, np.ndarray]:
        self.check(count, ints + 2 * reals, what)
        kind = np.dtype([("ints", self.int, (ints,)), ("reals", self.real, (reals,))])
        rows = self.take(kind, count, what)
        return rows["ints"].astype(np.int64), rows["reals"].astype(float)
