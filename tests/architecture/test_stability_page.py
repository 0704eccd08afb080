# SPDX-License-Identifier: BSD-3-Clause
"""core/STABILITY.md names tests that exist, and has every row of the failure catalogue."""

from __future__ import annotations

import re

from tree import CHECKOUT, read

PAGE = "core/STABILITY.md"
FILE = re.compile(r"`(tests/[\w/]+\.(?:cpp|py))`")
WAITING: set[str] = set()


def list_rows(head: str) -> list[list[str]]:
    """Cells of the table under a heading."""
    text = read(PAGE).partition(f"\n## {head}\n")[2].partition("\n## ")[0]
    rows = [line for line in text.splitlines() if line.startswith("| ")]
    return [[cell.strip() for cell in row.strip("|").split(" | ")] for row in rows[1:]]


def split_tests(cell: str) -> list[tuple[str, str]]:
    """File and name of each test: `file`: name; name; `file`: name."""
    found, file = [], ""
    for part in cell.split("; "):
        named = FILE.match(part)
        if named is not None:
            file = named[1]
        name = part[named.end() :].removeprefix(":").strip() if named is not None else part.strip()
        found.append((file, name))
    return found


def list_names(file: str) -> set[str]:
    text = read(file)
    if file.endswith(".py"):
        return set(re.findall(r"^def (test_\w+)", text, re.MULTILINE))
    cases = re.findall(r'TEST_CASE\(\s*((?:"[^"\n]*"\s*)+)', text)
    return {"".join(re.findall(r'"([^"]*)"', case)) for case in cases}


def test_every_law_has_a_prediction_and_a_test_of_that_name():
    rows = list_rows("Law by law")
    wrong = []
    for _, prediction, cell in rows:
        assert prediction
        wrong += [test for test in split_tests(cell) if test[1] not in list_names(test[0])]

    assert len(rows) > 20
    assert wrong == []


def test_every_failure_has_its_scene_or_says_what_it_waits_for():
    rows = list_rows("Failures that others are known for")

    assert [row[0] for row in rows] == [f"F{number}" for number in range(1, 19)]
    for number, _, here, *cells in rows:
        scenes = FILE.findall(" ".join(cells))
        assert (number in WAITING) == (not scenes), number
        assert (number in WAITING) == here.startswith("**waits** for "), number
        for name in scenes:
            assert (CHECKOUT / name).is_file(), name
        if scenes:
            begins = f"tests/scenes/test_f{int(number[1:]):02d}_"
            assert scenes[0].startswith(begins)
            assert f"def test_f{int(number[1:])}_" in read(scenes[0])
