# SPDX-License-Identifier: GPL-3.0-or-later
"""Published values of tissues, at the top of the Material stage: read, used, added and removed."""

from __future__ import annotations

import numpy as np
import pytest
from hands import child, click
from palpate_editor.edits import SetRegion
from palpate_editor.own_values import read_own_values
from palpate_editor.tissue_library import find_own_file
from palpate_editor.views.stages.published_dialog import PublishedDialog

OWN = """
[tongue]
title = "tongue"
kind = "solid"
words = ["dil"]

[[tongue.published]]
quantity = "young_modulus"
low = 2e3
high = 8e3
method = "indentation"
setting = "ex vivo"
rate = "1 mm/s"
source = "our own laboratory, 2026"
status = "checked"
"""

pytestmark = [pytest.mark.window, pytest.mark.landing]


@pytest.fixture
def panel(spleen_window):
    spleen_window.show_stage("material")
    return spleen_window.material_panel


def table_of(dialog) -> list[tuple[str, ...]]:
    table = dialog.table
    return [
        tuple(table.item(row, column).text() for column in range(4))
        for row in range(table.rowCount())
    ]


def test_published_values_are_in_reach_at_the_top_of_the_form_and_can_be_used(panel, qtbot):
    panel.window().resize(1280, 720)
    published = panel.published
    published.box.setCurrentIndex([t.name for t in published.tissues].index("gallbladder"))
    area = panel.window().stage_dock.stack.currentWidget().viewport()
    button = child(panel, "show_published")
    assert area.rect().contains(button.mapTo(area, button.rect().bottomRight()))

    click(button)
    rows = table_of(published.dialog)
    modulus = next(row for row in rows if row[0] == "Young's modulus" and "Karimi" in row[3])
    assert modulus[1] == "230 – 280\N{NO-BREAK SPACE}kPa"
    click(child(panel, "use_tissue"))

    organ = panel.context.session.organ
    assert organ.material.young_modulus == 2.5e5
    assert organ.material.wall_thickness == 2.5e-3
    assert panel.context.session.history.undoText() == "Material of gallbladder wall"


def test_the_tissue_of_an_organ_is_chosen_by_its_name_and_another_one_stays(panel):
    published = panel.published
    assert published.chosen().name == "spleen"

    published.box.setCurrentIndex([t.name for t in published.tissues].index("pancreas"))
    panel.context.apply(SetRegion("rim", np.arange(12)))

    assert published.chosen().name == "pancreas"


def test_a_designer_adds_a_published_value_and_removes_it_again(panel, user_data):
    click(child(panel, "show_published"))
    dialog = panel.published.dialog
    before = table_of(dialog)
    dialog.table.selectRow(0)
    assert not dialog.remove_button.isEnabled()  # what ships stays
    dialog.low.lineEdit().setText("4.5")
    dialog.high.lineEdit().setText("7")
    dialog.method.setText("indentation")
    click(dialog.add_button)
    assert "needs its source" in panel.window().messages.text
    dialog.source.setText("Doe et al., J Biomech 2024")
    click(dialog.add_button)

    added = ("Young's modulus", "4.5 – 7\N{NO-BREAK SPACE}kPa", "indentation")
    assert table_of(dialog) == [*before, (*added, "Doe et al., J Biomech 2024")]
    again = PublishedDialog(panel.context, panel)
    again.show_tissue(panel.published.known.index(panel.published.chosen()))
    assert table_of(again) == table_of(dialog)
    kept = read_own_values(user_data / "palpate" / "published_values.json")
    assert [(value.low, value.high) for value in kept] == [(4500.0, 7000.0)]

    dialog.table.selectRow(len(before))
    click(dialog.remove_button)
    assert table_of(dialog) == before
    assert read_own_values(user_data / "palpate" / "published_values.json") == ()


def choose(panel, name: str) -> None:
    published = panel.published
    published.box.setCurrentIndex([t.name for t in published.tissues].index(name))


def test_a_tissue_is_found_by_its_words_and_used(panel):
    words = child(panel, "tissue_words")
    words.setText("pancre")
    assert [t.name for t in panel.published.tissues] == ["pancreas"]
    assert "checked in its source" in child(panel, "tissue_status").text()

    click(child(panel, "use_tissue"))

    organ = panel.context.session.organ
    assert organ.material.young_modulus == 6.4e3
    assert [t.name for t in organ.tissues] == ["pancreas"]
    assert panel.context.session.history.undoText() == "Tissue: pancreas"
    words.setText("zzz")
    assert len(panel.published.tissues) > 20 and words.property("tone") == "bad"


def test_a_recalled_stiffness_is_used_only_when_that_is_said_and_an_unknown_one_never(panel):
    accept, use = child(panel, "accept_recalled"), child(panel, "use_tissue")
    choose(panel, "brain")
    assert accept.isVisible() and not use.isEnabled()
    accept.setChecked(True)
    click(use)
    assert panel.context.session.organ.tissues[0].status == "recalled"

    choose(panel, "vein")
    assert not accept.isVisible() and not use.isEnabled()
    choose(panel, "brain")
    assert not accept.isChecked()


def test_a_region_is_given_a_tissue_of_its_own(panel):
    session = panel.context.session
    session.apply(SetRegion("hilum", np.array([3, 5, 8])))
    choose(panel, "muscle")
    region = child(panel, "tissue_region")
    region.setCurrentIndex(region.findData("hilum"))

    click(child(panel, "use_tissue"))

    organ = session.organ
    felt = organ.material.young_modulus * organ.stiffness_scale[[3, 5, 8]]
    assert felt == pytest.approx([organ.tissues[0].young_modulus] * 3)
    assert (organ.stiffness_scale != 1.0).sum() == 3


@pytest.fixture
def own_tissue(tmp_path, monkeypatch):
    """A designer's own file, as `palpate tissues --library` reads one."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    find_own_file().parent.mkdir(parents=True)
    find_own_file().write_text(OWN, encoding="utf-8")


def test_a_tissue_of_the_designers_own_file_is_found_and_used(own_tissue, spleen_window):
    spleen_window.show_stage("material")
    panel = spleen_window.material_panel
    child(panel, "tissue_words").setText("dil")
    assert [t.name for t in panel.published.tissues] == ["tongue"]

    click(child(panel, "use_tissue"))

    organ = panel.context.session.organ
    assert (organ.material.young_modulus, organ.tissues[0].name) == (4e3, "tongue")


def test_what_is_recalled_is_said_so_in_the_table(panel):
    choose(panel, "artery")
    click(child(panel, "show_published"))
    table = panel.published.dialog.table

    rows = {table.item(row, 0).text(): table.item(row, 5).text() for row in range(table.rowCount())}
    assert rows["Young's modulus"] == "recalled"
    assert table.item(0, 4).text() == "ex vivo, static"
