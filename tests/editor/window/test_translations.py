# SPDX-License-Identifier: GPL-3.0-or-later
"""The window speaks English and Turkish, whole."""

from __future__ import annotations

import json
import re
import sys
from dataclasses import asdict, replace
from pathlib import Path
from string import Formatter

import numpy as np
import pytest
from hands import action, child, click
from palpate.files.refusal import Refusal
from palpate.translation import read_translations
from palpate.translation.refusals import say_refusal
from palpate_editor.compile import compile_organ
from palpate_editor.document import EMPTY, phrase
from palpate_editor.edits import EditError, PaintStiffness, SetConstant
from palpate_editor.own_values import FORMAT, VERSION, OwnValue, read_own_values
from palpate_editor.views.quantity_box import QuantityBox, write_number
from palpate_editor.views.sentences import sentence_of
from palpate_editor.views.translations import fill, number, quantity, say, say_problems
from patience import settle
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QAbstractButton, QLabel
from spoken import find_spoken

sys.path.append(str(Path(__file__).resolve().parents[1]))
from organs import make_organ  # noqa: E402

pytestmark = pytest.mark.window

TURKISH = read_translations("palpate_editor", "tr")


def test_every_text_of_the_editor_has_its_turkish():
    missing = sorted(find_spoken() - set(TURKISH))

    assert missing == []


def test_no_turkish_is_left_of_a_text_that_is_gone():
    assert sorted(set(TURKISH) - find_spoken()) == []


def fields_of(text: str) -> list[str]:
    """Names and formats of what is filled in, %1 too."""
    named = [f"{name}:{spec}" for _, name, spec, _ in Formatter().parse(text) if name]
    return sorted(named + re.findall(r"%\d", text))


def test_a_translation_fills_in_what_the_english_does():
    wrong = [said for said, words in TURKISH.items() if fields_of(words) != fields_of(said[1])]

    assert wrong == []


def test_a_sentence_of_an_edit_is_said_in_turkish(make_editor):
    make_editor(language="tr")
    with pytest.raises(EditError) as refused:
        SetConstant("material", "density", -1.0)(EMPTY)

    sentence = sentence_of(refused.value)

    assert sentence == "Yoğunluk: olması gereken 0 kg/m³ değerinden büyük; verilen -1 kg/m³."


def test_every_kind_of_refusal_is_said_in_turkish(make_editor, tmp_path):
    make_editor(language="tr")
    path = tmp_path / "values.json"
    value = OwnValue("liver", "density", 1000.0, 900.0, "", "Someone 2020")
    rows = {"format": FORMAT, "version": VERSION, "values": [asdict(value)]}
    path.write_text(json.dumps(rows), encoding="utf-8")
    with pytest.raises(Refusal) as refused:
        read_own_values(path)

    said = sentence_of(refused.value)

    assert said.endswith("; beklenen: yayımlanmış bir değer") and "values[0]: bulunan: " in said
    assert "The range" not in said and "1000" in said
    assert sentence_of(RuntimeError("socketpair: No space left on device")) == (
        "socketpair: " + say_refusal("No space left on device")
    )
    with pytest.raises(ValueError) as unbuilt:
        compile_organ(EMPTY)
    assert sentence_of(unbuilt.value) == (
        "organ: bulunan: yüzey yok; beklenen: içe aktarılmış bir ağ"
    )


def test_a_phrase_within_a_phrase_is_translated_too(make_editor):
    make_editor(language="tr")

    assert "Henüz organ yok" in sentence_of(
        EditError(phrase("There is no organ yet: import a mesh file first."))
    )


def test_why_a_unit_or_an_axis_was_chosen_is_said_in_turkish(qtbot, make_editor):
    window = make_editor(language="tr").window
    window.files.open_shipped("spleen")
    settle(qtbot, window)
    assert window.import_panel.unit_reason.text() == "Palpate ile gelir"

    size = "120.4 units from corner to corner: above 60, so millimetres"
    organ = replace(make_organ(), source=replace(make_organ().source, unit_reason=size))
    window.import_panel.show_organ(organ)

    why = "köşeden köşeye 120,4 birim: 60'ın üstünde, demek ki milimetre"
    assert window.import_panel.unit_reason.text() == f"Tahmin: {why}"
    assert say(phrase("{unit}, guessed ({why})", unit="mm", why=size)) == f"mm, tahmin ({why})"


def test_the_window_is_turkish_and_back_with_the_same_organ(qtbot, make_editor):
    editor = make_editor(language="tr")
    window, session = editor.window, editor.session
    assert window.menuBar().actions()[0].text() == "&Dosya"
    assert window.stage_bar.steps["decimate"].text() == "Sadeleştir"
    window.show_stage("material")

    action(window, "language_en").trigger()
    qtbot.waitUntil(lambda: editor.window is not window)

    assert editor.window.menuBar().actions()[0].text() == "&File"
    assert editor.window.session is session
    assert editor.window.context.stage == "material"
    assert editor.settings.language == "en"


@pytest.mark.landing
def test_a_turkish_window_says_in_turkish_how_published_values_were_measured(
    qtbot, make_editor, spleen
):
    window = make_editor(language="tr").window
    window.files.open(spleen)
    settle(qtbot, window)
    window.show_stage("material")
    click(child(window.material_panel, "show_published"))
    dialog = window.material_panel.published.dialog

    dialog.tissue.setCurrentIndex([t.name for t in dialog.tissues].index("liver"))
    table = dialog.table
    measured = {table.item(row, 2).text() for row in range(table.rowCount())}
    assert "canlıda bastırma, domuz" in measured
    assert not any("in vivo" in words for words in measured)
    assert dialog.note.text().startswith("Sağlıklı")


def test_no_text_is_cut_off_in_either_language(qtbot, make_editor):
    for language in ("en", "tr"):
        window = make_editor(language=language).window
        window.resize(1280, 800)
        for stage in window.stage_bar.steps:
            window.show_stage(stage)
            qtbot.wait(1)
            panel = window.stage_dock.panels[stage]
            room = window.stage_dock.stack.currentWidget().viewport().width()
            assert panel.width() <= room, (language, stage)
            for widget in [*panel.findChildren(QLabel), *panel.findChildren(QAbstractButton)]:
                if widget.isVisible() and not (isinstance(widget, QLabel) and widget.wordWrap()):
                    assert widget.width() >= widget.minimumSizeHint().width(), (
                        language, stage, widget.text(),
                    )  # fmt: skip


def test_problems_are_counted_in_plain_words(make_editor):
    assert say_problems(2, 1) == "2 errors to fix, 1 warning"
    assert say_problems(1, 0) == "1 error to fix"
    assert say_problems(0, 3) == "3 warnings"

    make_editor(language="tr")

    assert say_problems(2, 1) == "düzeltilecek 2 hata, 1 uyarı"


def test_numbers_are_written_for_people():
    QLocale.setDefault(QLocale("en"))
    assert number(12345.678) == "12\u202f346"
    assert number(0.00250) == "0.0025"
    assert number(-3.5) == "−3.5"
    assert number(3.0e7) == "3×10⁷"
    assert number(-2.5e-7) == "−2.5×10⁻⁷"
    assert number(float("nan")) == "–"
    assert quantity(0.05, "N/m") == "0.05\u00a0N/m"
    assert quantity(None, "g") == "–"


def test_turkish_numbers_have_a_comma_in_every_window_and_a_point_on_the_command_line(
    qtbot, make_editor
):
    window = make_editor(language="tr").window
    window.session.apply(SetConstant("material", "young_modulus", 4321.5))
    window.show_stage("material")

    assert number(0.0025) == "0,0025" and number(-2.5e-7) == "−2,5×10⁻⁷"
    assert number(12345.678) == "12\u202f346"
    assert write_number(0.0025) == "0,0025"
    assert window.session.history.undoText() == "Young modülü: 4,3215 kPa"
    box = window.findChild(QuantityBox, "tool.radius")
    for typed in ("4,5", "4.5"):
        box.lineEdit().setText(typed)
        box.enter()
        assert window.session.organ.tool.radius == pytest.approx(4.5e-3)
        window.session.history.undo()
    window.menu_actions.use_solid()
    box.lineEdit().setText("3,5")
    box.enter()
    assert "--tool-radius=0.0035m" in window.log.log.toPlainText()
    assert window.material_panel.share.text() == "10,0\N{NO-BREAK SPACE}%"
    axis = window.test_panel.plot._plot.getAxis("left")
    assert axis.tickStrings([0.5, 1.0], 1.0, 0.5) == ["0,5", "1,0"]
    assert fill("{x:.2f} N", x=0.63) == "0,63 N"


def test_turkish_refusals_have_turkish_numbers(make_editor):
    make_editor(language="tr")
    with pytest.raises(EditError) as refused:
        PaintStiffness(np.array([0]), 0.001)(make_organ())

    assert sentence_of(refused.value).endswith("verilen 0,001.")
