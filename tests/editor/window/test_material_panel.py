# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers with units: typed, stepped, refused; and what comes of them at once."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from hands import action, child, click, type_into
from palpate.scene.scene_parts import KINDS, FillPart
from palpate_editor.comparison import COMPARED_KINDS, FRONT_KINDS, say_error
from palpate_editor.compile import build_organ
from palpate_editor.document.constants import CONSTANTS, SHORT_KINDS
from palpate_editor.document.idle import find_idle
from palpate_editor.edits import FixLowest, RemoveRegion, SetChoice, SetConstant, SetRegion
from palpate_editor.views.quantity_box import QuantityBox, read_number, write_number
from patience import settle
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

pytestmark = pytest.mark.window


@pytest.fixture
def panel(spleen_window):
    spleen_window.show_stage("material")
    return spleen_window.material_panel


def test_every_constant_can_be_edited_with_its_unit_beside_it(panel):
    fields = {field.constant.key: field for field in panel.fields if hasattr(field, "constant")}

    assert set(fields) == {constant.key for constant in CONSTANTS}
    for constant in CONSTANTS:
        assert fields[constant.key].unit.text() == constant.unit


def test_a_typed_number_is_in_the_unit_shown(panel):
    type_into(child(panel, "tool.radius"), "4.5")

    assert panel.context.session.organ.tool.radius == pytest.approx(4.5e-3)
    assert "--tool-radius=0.0045m" in panel.window().log.log.toPlainText()


def test_a_number_that_is_refused_stays_in_red_with_a_sentence(panel):
    box = child(panel, "material.density")

    type_into(box, "-5")

    assert panel.context.session.organ.material.density == 1060.0
    assert "Density must be more than 0 kg/m³" in panel.window().messages.text
    assert box.property("refused")
    QTest.keyClick(box, Qt.Key.Key_Escape)
    assert box.lineEdit().text() == "1060"
    assert not box.property("refused")


@pytest.mark.landing
def test_arrow_keys_step_by_a_tenth_of_the_decade(panel):
    box = child(panel, "model.stiffness")
    type_into(box, "150")

    QTest.keyClick(box, Qt.Key.Key_Up)

    assert panel.context.session.organ.model.stiffness == 160.0


@pytest.mark.landing
def test_the_wheel_over_a_field_without_the_cursor_changes_nothing(panel, qtbot):
    from PySide6.QtCore import QPoint, QPointF
    from PySide6.QtGui import QWheelEvent
    from PySide6.QtWidgets import QApplication

    box, before = child(panel, "model.stiffness"), panel.context.session.organ
    middle = QPointF(box.rect().center())
    event = QWheelEvent(
        middle, box.mapToGlobal(middle), QPoint(), QPoint(0, 120), Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(box, event)

    assert panel.context.session.organ is before


@pytest.mark.landing
def test_a_wall_makes_the_organ_hollow_and_lighter(panel, qtbot):
    window, before = panel.window(), panel.facts.texts()["Total mass"]
    field = next(f for f in panel.fields if f.objectName() == "" and hasattr(f, "constant")
                 and f.constant.field == "wall_thickness")  # fmt: skip

    click(field.tick)
    settle(qtbot, window)

    assert window.session.organ.material.wall_thickness == 2e-3
    assert panel.facts.texts()["Total mass"] != before
    window.session.history.undo()
    assert not field.tick.isChecked()


@pytest.mark.landing
def test_fields_of_the_molecular_model_show_with_it_alone(panel):
    bend = child(panel, "model.bend_stiffness")
    assert not bend.isVisible()

    choose(panel, "model.kind", "molecular")

    assert bend.isVisible()
    assert panel.context.session.organ.model.kind == "molecular"


def test_kinds_of_no_shipped_organ_stand_below_a_line_with_their_error(panel):
    texts = [panel.kind.itemText(row) for row in range(panel.kind.count())]
    line = panel.kind.findText("For comparison")
    note = child(panel, "compared_kind")

    assert [v for v in panel.kind.values[:line] if v] == list(FRONT_KINDS)
    assert [v for v in panel.kind.values[line:] if v] == list(COMPARED_KINDS)
    assert not panel.kind.model().item(line).isEnabled() and texts[line - 1] == ""
    before = panel.context.session.organ
    panel.kind.activated.emit(line)
    assert panel.context.session.organ is before
    for kind in KINDS:
        choose(panel, "model.kind", kind)
        error = say_error(kind)
        assert note.isVisible() == (error is not None)
        assert error is None or note.text() == f"For comparison: {error}."
        row = panel.kind.values.index(kind)
        tip = panel.kind.itemData(row, Qt.ItemDataRole.ToolTipRole)
        assert tip == (None if error is None else str(error))


@pytest.mark.landing
def test_a_coupling_that_no_triangle_can_take_says_which_it_can(panel, qtbot):
    window = panel.window()
    window.menu_actions.use_mms()

    type_into(child(panel, "model.stretch_coupling"), "50")
    settle(qtbot, window)

    assert panel.range.isVisible()
    assert "stretch-bend of" in panel.range.text()
    row = next(r for r in panel.rows if r.isVisible() and r.fix is not None)
    click(row.button)
    settle(qtbot, window)
    assert panel.context.assessment.scene is not None


@pytest.mark.landing
def test_a_linear_solid_tells_its_memory_and_asks_for_nothing_that_swings(panel, qtbot):
    window = panel.window()
    window.context.apply(FixLowest(0.2))

    choose(panel, "model.kind", "linear_solid")
    settle(qtbot, window)

    words = panel.facts.texts()
    assert list(words) == [
        "Total mass", "Tetrahedra", "Smallest angle between faces", "Edges", "Its response",
        "A tick in touch takes", "Validated to",
    ]  # fmt: skip
    assert re.fullmatch(r"[\d.]+\u00a0MB for \d+ of \d+ particles", words["Its response"])
    assert not panel.links.isVisible()
    assert "up to 15 % of the thickness" in panel.origin_note.text()
    assert "--kind linear" in window.log.log.toPlainText()


def test_gravity_gives_the_organ_weight(panel):
    click(child(panel, "gravity"))

    assert panel.context.session.organ.hand.gravity == (0.0, 0.0, -9.81)


def test_numbers_are_read_as_people_write_them():
    assert read_number("1,5") == 1.5
    assert read_number("3e7") == 3e7
    assert read_number("12 000") == 12000.0
    assert read_number("−2") == -2.0
    assert read_number("many") is None
    assert read_number("1e999") is None
    assert write_number(3.0e7) == "3e7"
    assert write_number(0.0025) == "0.0025"


def test_a_box_takes_letters_of_numbers_only(qtbot):
    box = QuantityBox("N/m")
    qtbot.addWidget(box)
    box.show_value(50.0)
    got = []
    box.entered.connect(got.append)

    box.lineEdit().selectAll()
    QTest.keyClicks(box.lineEdit(), "a1x2e2")
    QTest.keyClick(box.lineEdit(), Qt.Key.Key_Return)

    assert got == [1200.0]


def test_a_wall_takes_its_constants_from_its_tissue_and_says_how_well(panel, qtbot):
    window = panel.window()
    window.context.apply(SetConstant("material", "wall_thickness", 2e-3))
    window.context.apply(SetConstant("model", "home_stiffness", None))
    type_into(child(panel, "material.young_modulus"), "50")
    window.context.apply(SetChoice("kind", "molecular"))
    settle(qtbot, window)
    before = panel.facts.texts()
    choose(panel, "model.constants", "tissue")
    settle(qtbot, window)

    words = panel.facts.texts()
    assert words["Of the wall's stiffness"] == "1 ×"
    assert words["Stretches like"].startswith("50")
    assert before["Stretches like"] != words["Stretches like"]
    assert not child(panel, "model.stiffness").isVisible()
    assert "--constants tissue" in window.log.log.toPlainText()

    choose(panel, "model.constants", "chosen")
    settle(qtbot, window)

    assert child(panel, "model.stiffness").isVisible()
    assert panel.context.session.organ.model.stiffness == pytest.approx(100.0, rel=0.5)
    window.context.session.history.undo()
    assert panel.context.session.organ.model.constants == "tissue"


@pytest.mark.landing
def test_young_modulus_cannot_be_edited_where_it_does_nothing_and_says_why(panel, qtbot):
    window, modulus = panel.window(), child(panel, "material.young_modulus")
    assert panel.context.session.organ.model.kind == "mass_spring"

    assert not modulus.isEnabled()
    assert "Has no effect here" in modulus.toolTip()
    assert "have no effect" in panel.origin_note.text()
    window.context.apply(SetConstant("material", "wall_thickness", 2e-3))
    window.context.apply(SetConstant("model", "home_stiffness", 1e6))
    assert not modulus.isEnabled() and "home springs take" in modulus.toolTip()
    assert "no effect on the force" in panel.origin_note.text()
    window.context.apply(SetConstant("model", "home_stiffness", None))  # which it then gives
    assert modulus.isEnabled() and "Has no effect" not in modulus.toolTip()
    assert not child(panel, "material.poisson_ratio").isEnabled()
    window.context.apply(SetChoice("constants", "tissue"))
    assert modulus.isEnabled() and child(panel, "material.poisson_ratio").isEnabled()
    for _ in range(4):
        window.session.history.undo()
    window.menu_actions.use_solid()
    assert modulus.isEnabled()


def test_what_has_no_effect_changes_no_number_of_the_tissue(panel):
    organ = panel.context.session.organ
    changed = replace(organ, material=replace(organ.material, young_modulus=9e4))
    for constant in CONSTANTS:
        if constant.key == "material.young_modulus":
            assert find_idle(constant, organ) is not None
    one, other = (build_organ(o) for o in (organ, changed))
    assert np.array_equal(one.springs.stiffness, other.springs.stiffness)
    assert np.array_equal(one.home, other.home)


def test_every_kind_of_tissue_stands_in_the_menu_and_the_one_in_use_is_marked(panel):
    window = panel.window()
    for name, kind in SHORT_KINDS.items():
        action(window, name).trigger()
        assert window.session.organ.model.kind == kind
        assert [n for n in SHORT_KINDS if action(window, n).isChecked()] == [name]


@pytest.mark.landing
def test_the_history_says_which_law_and_which_value(panel):
    window = panel.window()
    window.menu_actions.use_solid()
    type_into(child(panel, "material.young_modulus"), "7.5")

    stack = window.session.history
    texts = [stack.text(k) for k in range(stack.count())]
    assert texts[-2:] == ["Model: Solid (MSS+V)", "Young's modulus: 7.5 kPa"]


@pytest.mark.landing
def test_no_field_moves_when_the_organ_is_looked_at_or_refused(panel, qtbot):
    window = panel.window()
    settle(qtbot, window)
    before = {f.objectName(): places(panel) for f in (panel.kind,)}["model.kind"]
    view = window.view.mapTo(window, window.view.rect().topLeft()), window.view.size()

    type_into(child(panel, "model.stiffness"), "5000")
    settle(qtbot, window)
    type_into(child(panel, "material.density"), "-5")
    assert window.messages.text
    window.context.apply(SetConstant("model", "home_stiffness", 0.0))
    settle(qtbot, window)

    assert places(panel) == before
    assert (window.view.mapTo(window, window.view.rect().topLeft()), window.view.size()) == view


def places(panel) -> dict[str, int]:
    """Where each field stands in the form, from above."""
    boxes = [*panel.findChildren(QuantityBox), *panel.findChildren(QPushButton, "fix_lowest")]
    return {
        box.objectName(): box.mapTo(panel, box.rect().topLeft()).y()
        for box in boxes
        if box.isVisible()
    }


def choose(panel, name: str, value: str) -> None:
    box = child(panel, name)
    box.activated.emit(box.values.index(value))


def test_a_solid_is_filled_as_its_designer_says(panel, qtbot):
    window, filling = panel.window(), panel.filling
    assert not filling.isVisible()
    choose(panel, "model.kind", "solid")
    settle(qtbot, window)
    assert filling.isVisible() and not filling.reach.isVisible()
    before = panel.facts.texts()["Tetrahedra"]

    type_into(child(panel, "fill.tetrahedra"), "1500")
    type_into(child(panel, "fill.nodal_share"), "0.5")
    settle(qtbot, window)

    assert panel.facts.texts()["Tetrahedra"] != before
    assert "--tetrahedra=1500" in window.log.log.toPlainText()
    assert panel.context.assessment.scene.bodies[0].tissue.volumes.nodal_share == 0.5
    type_into(child(panel, "fill.tetrahedra"), "12.5")
    assert "Tetrahedra must be a whole number of 100 to 40000" in window.messages.text
    window.session.history.undo()
    window.session.history.undo()
    assert window.session.organ.fill == FillPart()


@pytest.mark.landing
def test_a_linear_solid_is_reached_where_a_region_says(panel, qtbot):
    window, reach, said = panel.window(), panel.filling.reach, []
    window.context.apply(FixLowest(0.2))
    window.context.apply(SetConstant("fill", "tetrahedra", 800))
    x = window.session.organ.surface.vertices
    window.context.apply(SetRegion("top", np.flatnonzero(x[:, 2] > np.median(x[:, 2]))))
    window.context.assessor.said.connect(said.append)
    choose(panel, "model.kind", "linear_solid")
    settle(qtbot, window)
    whole = panel.facts.texts()["Its response"]

    reach.setCurrentIndex(reach.findText("top"))
    reach.activated.emit(reach.currentIndex())
    settle(qtbot, window)

    part = panel.facts.texts()["Its response"]
    assert window.session.organ.fill.reach == "top"
    assert read_number(part.split("\u00a0")[0]) < read_number(whole.split("\u00a0")[0])
    assert said == [f"{words}, being solved for" for words in (whole, part)]
    assert "--reach=top" in window.log.log.toPlainText()
    window.context.apply(RemoveRegion("top"))
    settle(qtbot, window)
    row = next(r for r in panel.rows if r.isVisible() and r.fix is not None)
    assert reach.currentText() == "top" and "region of the organ" in row.label.text()
    click(row.button)
    assert window.session.organ.fill.reach == "" and reach.currentText() == "All of the surface"
