# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts are welded across, united and taken away by hand, in the tree and the form beside it."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from hands import child, click, log_of, type_into
from palpate_editor.authoring import inspect_mesh
from palpate_editor.edits.inspected import mesh_of
from palpate_editor.views.tasks import ImportWork
from patience import rest, settle
from PySide6.QtWidgets import QComboBox, QLineEdit

sys.path.append(str(Path(__file__).resolve().parents[1]))
from part_files import ball, write_parts  # noqa: E402

pytestmark = [pytest.mark.window, pytest.mark.landing]

RADIUS, GAP = 40.0, 0.3
"""[mm]"""


def write_halves(path: Path) -> Path:
    """A ball cut in two along edges, its halves a gap apart."""
    x, t = ball(RADIUS)
    above = x[t].mean(axis=1)[:, 2] > 0.0
    return write_parts(
        path, {"lower": (x, t[~above]), "upper": (x + np.array([0.0, 0.0, GAP]), t[above])}
    )


def write_crossing(path: Path) -> Path:
    return write_parts(
        path, {"liver": ball(RADIUS), "tumour": ball(0.5 * RADIUS, (RADIUS, 0.0, 0.0))}
    )


def open_file(qtbot, window, path: Path):
    window.tasks.on_read(ImportWork(path)(lambda words, share: None))
    settle(qtbot, window)
    return window.import_panel


def import_again(qtbot, window):
    click(window.import_panel.import_button)
    settle(qtbot, window)
    rest(qtbot, window)
    return inspect_mesh(mesh_of(window.session.organ.surface))


def keep_picture(window, checkout: Path, name: str) -> None:
    folder = checkout / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    assert window.grab().save(str(folder / f"editor_{name}.png"))


def test_halves_that_do_not_quite_meet_are_welded_by_typing_how_far_apart_they_are(
    qtbot, window, tmp_path, checkout
):
    panel = open_file(qtbot, window, write_halves(tmp_path / "halves.obj"))
    assert len(inspect_mesh(mesh_of(window.session.organ.surface)).border_loops) == 2

    type_into(child(window, "weld").findChild(QLineEdit), "0.5")
    found = import_again(qtbot, window)

    assert (found.closed, found.shells) == (True, 1)
    assert found.volume_ml == pytest.approx(4e-3 / 3.0 * np.pi * RADIUS**3, rel=0.04)
    assert window.session.organ.assembly.weld == pytest.approx(5e-4)
    assert "--weld=0.5mm" in log_of(window)
    assert any("welded across parts" in note for note in window.session.organ.source.notes)
    assert panel.chooser.assembling().weld == pytest.approx(5e-4)
    keep_picture(window, checkout, "welded_parts")


def test_a_gap_wider_than_the_tolerance_stays_open(qtbot, window, tmp_path):
    open_file(qtbot, window, write_halves(tmp_path / "halves.obj"))

    type_into(child(window, "weld").findChild(QLineEdit), "0.2")
    found = import_again(qtbot, window)

    assert not found.closed and len(found.border_loops) == 2


def test_parts_that_cross_are_united_or_one_is_taken_away_by_hand(
    qtbot, window, tmp_path, checkout
):
    panel = open_file(qtbot, window, write_crossing(tmp_path / "liver.obj"))
    whole = 4e-3 / 3.0 * np.pi * RADIUS**3

    child(window, "assembling", QComboBox).setCurrentIndex(1)
    united = import_again(qtbot, window)

    assert (united.closed, united.shells, united.self_intersecting_faces) == (True, 1, 0)
    assert 1.02 * whole < united.volume_ml < 1.125 * whole
    assert "--unite" in log_of(window)
    keep_picture(window, checkout, "united_parts")

    tumour = next(i for i in panel.parts.items() if i.text(0).startswith("tumour"))
    panel.parts.build_menu(tumour).actions()[2].trigger()
    rest(qtbot, window)
    bitten = import_again(qtbot, window)

    assert (bitten.closed, bitten.shells, bitten.self_intersecting_faces) == (True, 1, 0)
    assert bitten.volume_ml < 0.97 * whole
    assert window.session.organ.assembly.subtracted == ("tumour",)
    assert "--subtract tumour" in log_of(window)
    keep_picture(window, checkout, "subtracted_part")
