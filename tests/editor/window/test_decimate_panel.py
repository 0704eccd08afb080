# SPDX-License-Identifier: GPL-3.0-or-later
"""The Decimate stage finds the count for a distance; the Material stage closes what is open."""

from __future__ import annotations

from dataclasses import replace

import palpate
import pytest
from hands import child, click
from palpate_editor.document import EMPTY, Surface
from palpate_editor.edits import Prepared, SetChoice
from palpate_meshes.generate import ellipsoid, tube
from patience import settle
from PySide6.QtWidgets import QLabel

pytestmark = [pytest.mark.window, pytest.mark.landing]
ERROR = 2e-3


def open_surface(window, made, kind: str = "mass_spring") -> None:
    surface = Surface(*made)
    organ = replace(EMPTY.with_surface(surface), imported=surface, name="spleen")
    organ = organ if kind == organ.model.kind else SetChoice("kind", kind)(organ)
    window.session.apply(Prepared(SetChoice("kind", kind), window.session.organ, organ))


def test_a_distance_finds_its_count_and_undo_takes_it_back(qtbot, make_editor):
    window = make_editor().window
    open_surface(window, ellipsoid(600))
    before = window.session.organ
    window.show_stage("decimate")

    child(window, "target_error").lineEdit().setText("2")
    click(child(window, "decimate_within"))
    settle(qtbot, window)

    done = window.session.organ.decimation
    assert done.max_distance <= ERROR and done.vertices < 600
    (*_, line) = window.session.organ.history.lines
    assert line.values == {"vertices": done.vertices, "error": ERROR, "features": True}
    window.session.history.undo()
    assert window.session.organ is before


def test_what_is_open_is_closed_for_filling_by_a_button(qtbot, make_editor):
    window = make_editor().window
    open_surface(window, tube(300), "solid")
    window.show_stage("material")
    settle(qtbot, window)
    button = child(window, "close_for_filling")
    assert not button.isHidden()

    click(button)
    settle(qtbot, window)

    organ = window.session.organ
    assert palpate.is_closed(organ.surface.triangles) and list(organ.regions) == ["cap"]
    assert button.isHidden()
    texts = {label.text() for label in window.findChildren(QLabel)}
    assert "Smallest angle between faces" in texts
