# SPDX-License-Identifier: BSD-3-Clause
"""The section "To add ..." of CONTRIBUTING.md lists files, and they are there."""

from __future__ import annotations

import re
from collections.abc import Sequence

from tree import read, source_files

NAMED = re.compile(r"`([\w.<>/-]+/[\w.<>/-]+|[\w-]+\.md)`")
PARTS = ("A law", "An integrator", "A device", "An edit", "An editor stage", "Less than that")


def read_section() -> str:
    """From its heading to the next of its rank."""
    after = read("CONTRIBUTING.md").partition("\n## To add ...\n")[2]
    return after.partition("\n## ")[0]


def list_parts(section: str) -> dict[str, str]:
    """Heading -> text."""
    texts = re.split(r"^### (.*)$", section, flags=re.MULTILINE)[1:]
    return dict(zip(texts[::2], texts[1::2], strict=True))


def find_missing(section: str, files: Sequence[str]) -> list[str]:
    """What is named and not there; with `<name>` in it, where there is none of the kind."""
    missing = []
    for named in NAMED.findall(section):
        pattern = re.escape(named).replace("<name>", r"[a-z_]+")
        if not any(re.fullmatch(pattern, file) for file in files):
            missing.append(named)
    return missing


def test_every_file_that_is_named_where_something_is_added_is_there():
    assert find_missing(read_section(), source_files()) == []


def test_a_file_that_is_not_there_is_missed():
    section = "`core/sim/model/tissue_model.h`, `core/sim/no_law.h`, `core/<name>_no.h`, `NO.md`"

    assert find_missing(section, source_files()) == [
        "core/sim/no_law.h",
        "core/<name>_no.h",
        "NO.md",
    ]


def test_each_part_names_its_files_and_its_proof():
    parts = list_parts(read_section())

    assert tuple(parts) == PARTS
    for heading, text in parts.items():
        assert NAMED.findall(text), heading
        assert "Proof: " in text or heading == "Less than that", heading
