# SPDX-License-Identifier: GPL-3.0-or-later
"""Every input that a fuzzer once found, on every landing."""

from __future__ import annotations

from pathlib import Path

import pytest
from fuzz_organ import try_organ, write_seed

CORPUS = Path(__file__).resolve().parents[1] / "fuzz" / "corpus" / "organ"


@pytest.mark.parametrize("path", sorted(CORPUS.iterdir()), ids=lambda path: path.name)
def test_whatever_a_fuzzer_found_is_an_organ_or_refused(path):
    try_organ(path.read_bytes())


def test_the_fuzzer_begins_with_an_organ():
    assert try_organ(write_seed())
