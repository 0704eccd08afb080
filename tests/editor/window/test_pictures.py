# SPDX-License-Identifier: GPL-3.0-or-later
"""Every stage of the window on a real organ, dark and light, as pictures to look at."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from patience import rest, settle
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

pytestmark = pytest.mark.window


ALL = ("import", "repair", "decimate", "material", "test", "scenario", "publish")


def colours_of(path: Path) -> np.ndarray:
    image = QImage(str(path)).convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def cut_middle(picture):
    """Its middle fifth, each way: a legend may push the organ a little aside."""
    height, width = picture.shape[:2]
    return picture[2 * height // 5 : 3 * height // 5, 2 * width // 5 : 3 * width // 5]


@pytest.mark.parametrize(
    ("theme", "drawn"),
    [
        pytest.param("dark", ALL, marks=[pytest.mark.fine, pytest.mark.landing]),
        ("light", ("material",)),
        pytest.param("light", ALL, marks=[pytest.mark.fine, pytest.mark.verify]),
    ],
    ids=["dark", "light-sample", "light"],
)
def test_every_stage_is_drawn(qtbot, make_editor, spleen, checkout, theme, drawn):
    folder = checkout / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    window = make_editor(theme=theme, language="en").window
    window.files.open(spleen)
    settle(qtbot, window)
    assert tuple(window.stage_bar.steps) == ALL
    for stage in ALL:
        if stage == "decimate":
            window.tasks.decimate(1200)
        if stage == "material":
            window.menu_actions.fix_lowest()
        settle(qtbot, window)
        if stage not in drawn:
            continue
        window.messages.dismiss()
        window.show_stage(stage)
        settle(qtbot, window)
        rest(qtbot, window)
        path = folder / f"editor_{stage}_{theme}.png"
        assert window.grab().save(str(path))

        picture = colours_of(path)
        view = window.view.geometry().translated(window.centralWidget().pos())
        shown = picture[view.top() : view.bottom(), view.left() : view.right()]
        corner, middle = shown[-6, 6], cut_middle(shown)
        assert abs(corner - middle).max() > 40, "nothing stands in the middle of the viewport"
        assert (corner.mean() > 128) == (theme == "light")


def test_the_empty_window_is_drawn_in_turkish(qtbot, make_editor, checkout):
    folder = checkout / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    window = make_editor(theme="dark", language="tr").window
    rest(qtbot, window)

    assert window.grab().save(str(folder / "editor_welcome_tr_dark.png"))
    assert window.welcome.isVisible()
    window.show_palette()
    QApplication.processEvents()
    assert window.palette_dialog.grab().save(str(folder / "editor_palette_tr_dark.png"))
    window.palette_dialog.close()
