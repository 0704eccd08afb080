# SPDX-License-Identifier: BSD-3-Clause
"""What tests of windows ask for; Qt is loaded only where they do."""

from __future__ import annotations

import gc
from pathlib import Path

import pytest

MESHES = Path(__file__).resolve().parents[2] / "meshes"


@pytest.fixture
def shown(qtbot, rough_frames):
    """shown(window) shows it and gives it back; closed and English when all is over.

    Meanwhile reference cycles are not collected: a thread of a hand or device may otherwise end
    widgets of other tests, and what they draw with.
    """
    from palpate import translation
    from PySide6.QtCore import QLocale
    from PySide6.QtWidgets import QApplication

    made = []
    gc.disable()

    def show(window):
        window.resize(960, 640)
        window.show()
        qtbot.waitExposed(window)
        made.append(window)
        return window

    yield show
    for window in made:
        window.close()
        window.deleteLater()
    QApplication.sendPostedEvents(None, 52)
    translation.install(QApplication.instance(), "en")
    QLocale.setDefault(QLocale("en"))
    gc.collect()
    gc.enable()


@pytest.fixture
def open_window(shown, tmp_path):
    """open_window(play or path) is a shown window of the trainee."""
    from palpate.player import TraineeWindow
    from palpate.runs.play import Play, open_play
    from published import publish

    def open_it(play: Play | Path | None = None, **options) -> TraineeWindow:
        if not isinstance(play, Play):
            play = open_play(play or publish(tmp_path))
        return shown(TraineeWindow(play, **options))

    return open_it


@pytest.fixture
def open_device(shown):
    """open_device(...) is a shown device window."""
    from palpate.device_window import DeviceWindow

    return lambda **options: shown(DeviceWindow(**options))


@pytest.fixture
def view(qtbot, monkeypatch):
    """A shown 3D view with the surface of viewports.py in it."""
    from palpate.viewport import canvas, make_view
    from viewports import FACES, SIZE, X

    # frames of one size whatever the machine has to do beside, so that they can be compared
    monkeypatch.setattr(canvas, "QUICK_SIZES", (1.0,) * 5)
    made = make_view()
    qtbot.addWidget(made)
    made.resize(*SIZE)
    made.show_surface(X, FACES)
    made.show()
    qtbot.waitExposed(made)
    yield made
    made.hide()
    gc.collect()


@pytest.fixture(scope="module")
def short_task(tmp_path_factory) -> Path:
    """A patch to be touched, then pressed for a moment, with a limit that a press passes."""
    from palpate import scenario
    from palpate.assessment.publish import read_assessment, with_assessment

    path = MESHES / "scenarios" / "simple_tissue.json"
    assessment = read_assessment(path)
    assessment["steps"] = [step for step in assessment["steps"] if step["id"] in ("touch", "push")]
    assessment["levels"] = ["normal"]
    assessment["parameters"] = {"press": {"unit": "N", "value": 0.3},
                                "limit": {"unit": "N", "value": 0.2},
                                "dwell": {"unit": "s", "uniform": [0.1, 0.3]}}  # fmt: skip
    assessment["steps"][1]["for_s"] = "$dwell"
    organ = scenario.read(MESHES / "published" / "simple_tissue.palpate")
    out = tmp_path_factory.mktemp("task") / "tissue.palpate"
    scenario.write(out, with_assessment(path, assessment, organ))
    return out


@pytest.fixture
def database(tmp_path, monkeypatch) -> Path:
    from palpate.records.store import ENVIRONMENT

    monkeypatch.setenv(ENVIRONMENT, str(tmp_path / "db" / "records.sqlite"))
    return tmp_path / "db" / "records.sqlite"
