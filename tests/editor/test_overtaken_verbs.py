# SPDX-License-Identifier: GPL-3.0-or-later
"""Verbs that write over the file they read, while another program writes it too."""

from __future__ import annotations

from dataclasses import replace

import pytest
from organs import make_organ, same
from palpate.cli.main import main
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.verbs import files

OTHERS = replace(make_organ(50), name="theirs")

CALLS = {
    "decimate": ["--vertices", "80"],
    "material": ["--stiffness", "60N/m"],
    "repair": ["--problem", "up_guessed"],
}


@pytest.fixture
def document(tmp_path):
    path = tmp_path / "mine.organ"
    write_organ(path, make_organ())
    return path


@pytest.fixture
def overtaken(document, monkeypatch):
    """As soon as a verb has read the document another program writes it."""
    read = files.open_organ

    def read_and_lose(path):
        organ = read(path)
        write_organ(document, OTHERS)
        return organ

    monkeypatch.setattr(files, "open_organ", read_and_lose)
    return document


@pytest.mark.parametrize("verb", CALLS)
def test_a_verb_does_not_overwrite_what_it_has_not_read(overtaken, capsys, verb):
    code = main([verb, str(overtaken), *CALLS[verb], "-o", str(overtaken)])

    assert code == 1
    said = capsys.readouterr().err
    assert "mine.organ" in said and "another program wrote" in said
    assert same(read_organ(overtaken), OTHERS)


@pytest.mark.parametrize("verb", CALLS)
def test_a_verb_writes_another_file_all_the_same(overtaken, tmp_path, verb):
    out = tmp_path / "new.organ"

    assert main([verb, str(overtaken), *CALLS[verb], "-o", str(out)]) == 0
    assert out.is_file() and same(read_organ(overtaken), OTHERS)


@pytest.mark.parametrize("verb", CALLS)
def test_a_verb_writes_over_the_file_it_read(document, verb):
    before = document.read_bytes()

    assert main([verb, str(document), *CALLS[verb], "-o", str(document)]) == 0
    assert document.read_bytes() != before
