# SPDX-License-Identifier: BSD-3-Clause
"""Refusals of the core, said in the language of a window."""

from __future__ import annotations

import errno
import os
import re

import palpate
import pytest
from core_sentences import build_templates, find_sentences
from palpate import translation
from palpate.translation.refusals import CONTEXT, build_pattern, say_refusal
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication

WORDS = {
    source: said
    for (context, source), said in translation.read_words("palpate.translation", "tr").items()
    if context == CONTEXT
}
SYSTEM = (
    *(errno.ENOENT, errno.EACCES, errno.EISDIR, errno.ENOTDIR, errno.ENOSPC, errno.EROFS),
    *(errno.EEXIST, errno.EBUSY, errno.EIO, errno.ENOTTY, errno.ENODEV),
)
FRAME = "%1: found %2, expected %3"


@pytest.fixture
def turkish(qapp: QApplication):
    translation.install(qapp, "tr")
    yield
    translation.install(qapp, "en")
    QLocale.setDefault(QLocale("en"))


def test_every_refusal_of_what_a_window_opens_has_its_turkish_and_none_is_left_over():
    sentences = find_sentences()

    assert len(sentences) > 60
    assert set(WORDS) == sentences | {os.strerror(code) for code in SYSTEM} | {FRAME}


def test_the_places_of_a_translation_are_those_of_the_english():
    for source, said in WORDS.items():
        assert sorted(re.findall(r"%\d", said)) == sorted(re.findall(r"%\d", source)), source
        places = re.findall(r"%\d", source)
        assert places == [f"%{place}" for place in range(1, len(places) + 1)], source


def test_templates_are_read_from_the_code_of_the_core():
    def read(expression: str) -> list[str]:
        return list(build_templates(expression))

    assert read('"a mesh file"') == ["a mesh file"]
    assert read('std::to_string(size) + " bytes"') == ["%1 bytes"]
    assert read('twice ? "one" : "a whole one"') == ["one", "a whole one"]
    assert read('std::string("content (") + strsignal(signal) + ")"') == ["content (%1)"]
    assert read('"two "\n  "lines"') == ["two lines"]


def test_a_file_that_is_refused_is_refused_in_turkish(turkish, tmp_path):
    path = tmp_path / "cut.palpate"
    path.write_bytes(b"PK" + bytes(100))
    with pytest.raises(palpate.FileError) as refused:
        palpate.scenario.read(path)

    said = say_refusal(str(refused.value))

    assert said.startswith(f"{path}: bulunan: bozuk bir zip arşivi (")
    assert said.endswith("; beklenen: sağlam bir arşiv")


def test_a_port_that_is_not_there_is_said_in_turkish(turkish):
    with pytest.raises(palpate.DeviceError) as refused:
        palpate.SerialTransport("/dev/nowhere", 1_000_000)

    assert say_refusal(str(refused.value)) == (
        "/dev/nowhere: böyle bir dosya ya da klasör yok; "
        "beklenen: 1000000 bit/s hızını alan bir seri kapı"
    )


def test_a_silent_device_is_said_in_turkish_behind_its_name(turkish):
    sentence = "serial:/dev/ttyUSB0: does not answer: expected a Palpate device that is switched on"

    assert say_refusal(sentence) == (
        "serial:/dev/ttyUSB0: yanıt vermiyor; beklenen: açık bir Palpate aygıtı"
    )


def test_the_words_of_another_library_are_not_taken_apart(turkish):
    said = say_refusal("found: content assimp refuses (OBJ: vertex index out of range)")

    assert said.endswith("assimp'in kabul etmediği içerik (OBJ: vertex index out of range)")


def test_what_nobody_translated_stays_as_it_is(turkish):
    assert say_refusal("a.obj: moon: something new") == "a.obj: moon: something new"
    assert say_refusal("") == ""
    assert build_pattern("%1 bytes").fullmatch("7 bits") is None


def test_in_english_a_refusal_stays_as_it_is(qapp):
    translation.install(qapp, "en")

    for sentence in ("a.obj: found 0 bytes, expected a mesh file", "b: part 'x', vertex 3: no"):
        assert say_refusal(sentence) == sentence
