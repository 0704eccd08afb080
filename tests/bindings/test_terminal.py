# SPDX-License-Identifier: BSD-3-Clause
"""What files say is printed, and never obeyed by a terminal."""

from __future__ import annotations

import pytest
from palpate.cli.main import main
from palpate.command.terminal import make_harmless
from published import publish, write_press

HOSTILE = "\x1b]0;owned\x07\x1b[2J\x9b31m\x00\x7f\r\u202e\u2066\ufeff"
STEERING = {letter for letter in HOSTILE if not letter.isprintable()}


def test_what_a_terminal_would_obey_is_written_out_and_the_rest_stays():
    assert make_harmless("a\x1b[2Jb") == "a\\x1b[2Jb"
    assert make_harmless("\u202eevil\udc80") == "\\u202eevil\\udc80"
    for text in ("Dalak: itme ve çekme\n\t1,5 N", "肝臓 🫀", "a\\x1b"):
        assert make_harmless(text) == text


@pytest.mark.parametrize("letter", [chr(code) for code in (*range(32), *range(127, 160))])
def test_no_control_character_passes_but_tab_and_the_end_of_a_line(letter):
    assert (make_harmless(letter) == letter) == (letter in "\t\n")


def test_the_title_of_a_published_file_does_not_steer_the_terminal(tmp_path, capsys):
    file = publish(tmp_path, title=f"Spleen{HOSTILE}")
    words = ["play", str(file), "--headless", "--device", f"script:{write_press(tmp_path)}"]

    assert main([*words, "--record", str(tmp_path / "run.prec")]) == 0

    out = capsys.readouterr()
    assert "Spleen\\x1b]0;owned\\x07" in out.out
    assert not STEERING & set(out.out + out.err)


def test_a_refusal_that_repeats_what_a_file_says_does_not_either(tmp_path, capsys):
    script = tmp_path / "a.json"
    script.write_text(
        '{"format": "' + "x\\u001b[2J\\u009b" + '", "version": 1, "frames": []}', encoding="utf-8"
    )
    words = ["play", str(publish(tmp_path)), "--headless", "--device", f"script:{script}"]

    assert main(words) == 1

    out = capsys.readouterr()
    assert not STEERING & set(out.out + out.err)
    assert "\x1b" not in out.err


def test_a_file_name_with_escape_codes_is_written_out(tmp_path, capsys):
    assert main(["replay", str(tmp_path / "a\x1b[2J.prec")]) == 1

    assert "\\x1b[2J.prec" in capsys.readouterr().err
