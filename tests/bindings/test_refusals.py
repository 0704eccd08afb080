# SPDX-License-Identifier: BSD-3-Clause
"""Refusals of the core, said in the language of a window."""

from __future__ import annotations

import errno
import os
import re

import core_sentences
import palpate
import pytest
import python_sentences
from core_sentences import build_templates
from english import say_in_turkish
from hostile_scenarios import set_in, with_manifest
from palpate import translation
from palpate.files import file_kind
from palpate.layout.document import Layout, LayoutError
from palpate.layout.task import find_task
from palpate.translation.refusals import CONTEXT, build_pattern, say_note, say_refusal
from published import publish

WORDS = {
    source: said
    for (context, source), said in translation.read_translations(
        "palpate.translation", "tr"
    ).items()
    if context == CONTEXT
}
SYSTEM = (
    *(errno.ENOENT, errno.EACCES, errno.EISDIR, errno.ENOTDIR, errno.ENOSPC, errno.EROFS),
    *(errno.EEXIST, errno.EBUSY, errno.EIO, errno.ENOTTY, errno.ENODEV),
)
FRAMES = {
    "%1: got %2, expected %3", "got %1, expected %2",
    *("X,Y,Z of up to %1 %2 each", "text that UTF-8 can say"),
    *(f"{place} %1" for place in ("row", "line", "face", "byte", "vertex", "triangle")),
}  # fmt: skip
"""What sentences are made of: what stands between, what is expected of a layout's options, and
places within a file."""

FILES = {
    kind for name, kind in vars(file_kind).items() if name.isupper() and isinstance(kind, str)
} - {file_kind.NOTHING, file_kind.OTHER, file_kind.NO_FILE}
"""What a file is found to be, where it is none of those that are read."""


@pytest.fixture(scope="module")
def published(tmp_path_factory) -> bytes:
    return publish(tmp_path_factory.mktemp("published")).read_bytes()


def test_every_refusal_of_what_a_window_opens_has_its_turkish_and_none_is_left_over():
    of_core, of_python = core_sentences.find_sentences(), python_sentences.find_sentences()
    sentences = of_core | of_python | FILES

    assert len(of_core) > 250 and len(of_python) > 70
    assert sorted(sentences - set(WORDS)) == []
    system = {os.strerror(code) for code in SYSTEM}
    assert sorted(set(WORDS) - sentences - system - FRAMES) == []


def test_sentences_are_read_from_python_too(tmp_path):
    file = tmp_path / "reader.py"
    file.write_text(
        "LIMIT = 5\n"
        "def read(path, n, odd):\n"
        '    expected = "text" if n else f"at most {LIMIT} parts"\n'
        '    raise Refusal(path, "where", f"{n} bytes", expected)\n'
        '    raise ValueError(f"n: got {n}, expected {LIMIT} or so")\n'
        '    raise OSError(5, f"{odd}: not a folder", path)\n',
        encoding="utf-8",
    )

    assert set(python_sentences.read_file(file)) == {
        "%1 bytes", "text", "at most %1 parts", "%1", "%1 or so", "%1: not a folder",
    }  # fmt: skip


def test_a_range_needs_a_number_so_no_name_of_a_file_is_taken_apart(turkish):
    assert say_refusal("0.1 to 0.5") == "0,1 ile 0,5 arası"
    assert say_refusal("liver to send: moon") == "liver to send: moon"


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


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        ("content|scene|rate", "fast", 'bulunan: "fast"; beklenen: bir sayı'),
        ("content|scene|rate", -1, "bulunan: -1; beklenen: 1 ile 20000 Hz arası"),
        ("content|title", 5, "bulunan: 5; beklenen: metin"),
        ("content|moon", 5, 'bulunan: bilinmeyen "moon" üyesi; beklenen: böyle girdi olmaması'),
        (
            "content|scene|bodies|0|tissue|damping_law",
            "sticky",
            'bulunan: "sticky"; beklenen: şunlardan biri: axis, isotropic',
        ),
        (
            "arrays|scene/bodies/0/tissue/mass|shape",
            [],
            "bulunan: 0 öğelik bir liste; beklenen: 1 ile 4",
        ),
    ],
)
def test_a_damaged_field_is_refused_in_turkish(turkish, published, tmp_path, path, value, said):
    (tmp_path / "bad.palpate").write_bytes(with_manifest(published, set_in(path, value)))
    with pytest.raises(palpate.FileError) as refused:
        palpate.scenario.read(tmp_path / "bad.palpate")

    assert said in say_in_turkish(str(refused.value))


def test_a_layout_whose_task_is_damaged_is_refused_in_turkish(turkish):
    with pytest.raises(LayoutError) as refused:
        find_task(Layout(assessment="{}"))

    assert "bulunan: değerlendirme yok; beklenen: " in say_in_turkish(str(refused.value))


def test_a_port_that_is_not_there_is_said_in_turkish(turkish):
    with pytest.raises(palpate.DeviceError) as refused:
        palpate.SerialTransport("/dev/nowhere", 1_000_000)

    assert say_refusal(str(refused.value)) == (
        "/dev/nowhere: böyle bir dosya ya da klasör yok; "
        "beklenen: 1000000 bit/s hızını alan bir seri kapı"
    )


def test_what_came_of_asking_a_port_for_low_latency_is_said_in_turkish(turkish):
    note = (
        'driver refused low latency; latency timer 16 ms: a udev rule with ATTR{latency_timer}="1" '
        "would make the loop 15 ms shorter"
    )

    assert say_note(note) == (
        "sürücü düşük gecikmeyi kabul etmedi; gecikme sayacı 16 ms: "
        'ATTR{latency_timer}="1" içeren bir udev kuralı döngüyü 15 ms kısaltır'
    )
    assert say_note("nothing here keeps bytes back") == "burada baytları bekleten bir şey yok"


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

    for sentence in ("a.obj: got 0 bytes, expected a mesh file", "b: part 'x', vertex 3: no"):
        assert say_refusal(sentence) == sentence
