# SPDX-License-Identifier: BSD-3-Clause
"""Every input that a fuzzer once found, on every landing."""

from __future__ import annotations

from pathlib import Path

import pytest
from fuzz_json import try_scene_file, try_script

CORPUS = Path(__file__).resolve().parents[1] / "fuzz" / "corpus"


def kept(reader: str) -> list[Path]:
    return sorted((CORPUS / reader).iterdir())


@pytest.mark.parametrize("path", kept("script"), ids=lambda path: path.name)
def test_whatever_a_fuzzer_found_is_a_script_or_refused(path):
    try_script(path.read_bytes())


@pytest.mark.parametrize("path", kept("scene_file"), ids=lambda path: path.name)
def test_whatever_a_fuzzer_found_is_a_scene_file_or_refused(path):
    try_scene_file(path.read_bytes())


def test_the_fuzzers_begin_with_what_is_accepted():
    assert try_script((CORPUS / "script" / "press").read_bytes())
    assert try_scene_file((CORPUS / "scene_file" / "octahedron").read_bytes())
