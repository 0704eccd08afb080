# SPDX-License-Identifier: GPL-3.0-or-later
"""The start page's gallery: every shipped organ is shown, and one click from being felt."""

from __future__ import annotations

import numpy as np
import pytest
from hands import click, log_of
from palpate_editor.shipped import list_organs
from palpate_editor.views.shipped_organs import name_organs
from patience import settle
from PySide6.QtGui import QImage

pytestmark = [pytest.mark.window, pytest.mark.landing]


def test_every_shipped_organ_has_a_button_with_a_name_and_a_picture(qtbot, window):
    gallery = window.welcome.shipped
    window.resize(1440, 900)  # what it asks for; it opens as small as the screen of the tests
    settle(qtbot, window)

    assert list(gallery.buttons) == [entry.name for entry, _ in list_organs()]
    for name, button in gallery.buttons.items():
        assert button.text() == name_organs()[name]
        picture = button.icon().pixmap(button.iconSize()).toImage()
        shown = picture.convertToFormat(QImage.Format.Format_RGB888)
        rows = np.frombuffer(shown.constBits(), np.uint8)
        assert shown.width() > 80 and rows.std() > 15.0, name


@pytest.mark.landing
def test_the_pictures_follow_the_theme(make_editor):
    brightness = {}
    for theme in ("dark", "light"):
        window = make_editor(theme=theme).window
        button = window.welcome.shipped.buttons["liver"]
        picture = button.icon().pixmap(button.iconSize()).toImage()
        brightness[theme] = picture.pixelColor(picture.width() // 2, 4).lightness()

    assert brightness["light"] > brightness["dark"] + 60


def test_an_organ_that_is_chosen_is_open_whole_and_without_a_file(qtbot, window):
    click(window.welcome.shipped.buttons["kidney_stone"])
    settle(qtbot, window)

    organ = window.session.organ
    assert (organ.name, organ.vertex_count) == ("kidney stone", 120)
    assert organ.fixed.any() and "crown" in organ.regions and organ.appearance is not None
    assert window.session.path is None and not window.isWindowModified()
    assert window.welcome.isHidden()
    assert window.context.stage == "material"
    assert "palpate organs kidney_stone --out kidney_stone.organ" in log_of(window)
