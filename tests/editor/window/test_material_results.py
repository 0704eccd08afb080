# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Material stage says of the tissue as it is: results, and the offer to an old solid."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hands import child, click, type_into
from palpate_editor.document.files import read_organ
from palpate_editor.edits import SetChoice, SetConstant
from palpate_editor.views.translations import number
from patience import settle

pytestmark = [pytest.mark.window, pytest.mark.landing]


@pytest.fixture
def panel(spleen_window):
    spleen_window.show_stage("material")
    return spleen_window.material_panel


def test_mass_substeps_and_margin_follow_at_once(panel, qtbot):
    window, words = panel.window(), panel.facts.texts
    before = words()

    type_into(child(panel, "material.density"), "2120")
    settle(qtbot, window)

    grams = float(words()["Total mass"].split("\u00a0")[0])
    assert grams == pytest.approx(2 * float(before["Total mass"].split("\u00a0")[0]), rel=1e-3)
    type_into(child(panel, "model.stiffness"), "5000")
    settle(qtbot, window)
    assert int(words()["Substeps a tick"]) > int(before["Substeps a tick"])
    assert words()["Stability margin"].endswith("×")


@pytest.mark.several_places
def test_to_which_depth_the_places_are_validated_stands_among_the_results(panel, qtbot):
    window, words = panel.window(), panel.facts.texts

    depths = panel.context.assessment.tissue.trial.validated
    span = sorted({number(1e3 * depth, 2) for depth in (min(depths), max(depths))}, key=float)
    assert words()["Validated to"] == f"{' – '.join(span)} mm deep, by place"

    window.context.apply(SetConstant("tool", "radius", 12e-3))
    settle(qtbot, window)

    assert words()["Validated to"] == "no depth: only balls of 2 to 8 mm are"


OLD_SOLID = Path(__file__).parents[2] / "scenes" / "published" / "solid_v6.organ"


def test_a_solid_of_an_old_file_is_offered_the_near_field_with_the_forces_of_both_laws(
    window, qtbot
):
    window.session.restore(read_organ(OLD_SOLID), None)
    settle(qtbot, window)
    window.show_stage("material")
    panel = window.material_panel
    offer = panel.offer

    [place] = panel.context.assessment.tissue.trial.offer
    before = offer.texts()
    assert offer.isVisible() and before[0][1:] == ["As on the mesh", "As on tissue"]
    assert before[1][1:] == [f"{number(1e3 * force, 3)}\u00a0mN" for force in place.forces]

    click(offer.button)
    assert not offer.isVisible()
    settle(qtbot, window)
    assert window.session.organ.model.contact_law == "near_field" and not offer.isVisible()

    window.session.history.undo()
    settle(qtbot, window)
    assert offer.isVisible() and offer.texts() == before


@pytest.mark.several_places
@pytest.mark.landing
def test_what_home_springs_carry_and_a_tick_in_touch_takes_stand_among_the_results(panel, qtbot):
    window, words = panel.window(), panel.facts.texts
    window.context.apply(SetConstant("model", "home_stiffness", 1e6))
    settle(qtbot, window)

    trial = panel.context.assessment.tissue.trial
    low, high = (round(100 * share) for share in (min(trial.home_shares), max(trial.home_shares)))
    assert words()["Home springs carry"] == f"{low} – {high} % of the force"
    assert words()["Substeps in touch"] == f"{trial.substeps}"
    assert re.fullmatch(r"about \d+ % of its time", words()["A tick in touch takes"])
    checks = [row.label.text() for row in panel.rows if not row.isHidden()]
    assert any(f"Home springs: {low}% to {high}% of the felt force" in text for text in checks)

    window.menu_actions.use_linear()
    window.context.apply(SetConstant("fill", "tetrahedra", 600))
    settle(qtbot, window)

    assert "Home springs carry" not in words() and "A tick in touch takes" in words()
    checks = [row.label.text() for row in panel.rows if not row.isHidden()]
    assert not any("under a contact radius of 3.0 mm" in text for text in checks)
    window.context.apply(SetChoice("contact_law", "hard"))
    settle(qtbot, window)
    checks = [row.label.text() for row in panel.rows if not row.isHidden()]
    assert any("under a contact radius of 3.0 mm" in text for text in checks)
