# SPDX-License-Identifier: GPL-3.0-or-later
"""The window of scans: what is drawn is what is chosen, and what is imported is what was drawn."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from hands import child, click
from palpate_editor.scan import Choice, find_chosen
from palpate_editor.views.scan.outlines import cut_surface, outline
from patience import settle
from PySide6.QtCore import Qt

sys.path.append(str(Path(__file__).resolve().parents[1]))
from scans import BOX, MIRRORED, PLAIN, make_scan, write_dicom, write_scan  # noqa: E402

pytestmark = [pytest.mark.window, pytest.mark.landing]
WAIT = 60_000
"""[ms]"""


def open_scan(qtbot, window, path):
    window.context.scan_wanted.emit(path)
    qtbot.waitUntil(
        lambda: window.scans.dialog is not None and window.scans.dialog.scan is not None,
        timeout=WAIT,
    )
    return window.scans.dialog


def tick(dialog, row: int) -> None:
    dialog.chooser.list.item(row).setCheckState(Qt.CheckState.Checked)


def lines_of(curve) -> np.ndarray:
    x, y = curve.getData()
    return np.empty((0, 2)) if x is None else np.column_stack([x, y])


def test_an_outline_goes_round_the_voxels_that_are_chosen():
    mask = np.zeros((4, 5), bool)
    mask[1:3, 2] = True

    lines = outline(mask).reshape(-1, 2, 2)

    assert np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1).sum() == 6.0
    assert (lines.min(axis=(0, 1)), lines.max(axis=(0, 1))) == (
        pytest.approx([0.5, 1.5]),
        pytest.approx([2.5, 2.5]),
    )
    assert outline(np.zeros((3, 3), bool)).shape == (0, 2)
    assert find_chosen(np.arange(4), Choice(low=1.0, high=2.0)).tolist() == [0, 1, 1, 0]


def test_a_slice_meets_a_tetrahedron_in_a_triangle():
    places = np.array([[0.0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]])
    triangles = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])

    lines = cut_surface(places, triangles, 0, 1, (1, 2)).reshape(-1, 2, 2)

    assert len(lines) == 3
    assert np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1).sum() == pytest.approx(
        2.0 + np.sqrt(2.0), rel=1e-4
    )
    assert len(cut_surface(places, triangles, 0, 5, (1, 2))) == 0


def test_a_label_is_outlined_previewed_and_imported(qtbot, window, tmp_path):
    dialog = open_scan(qtbot, window, write_scan(tmp_path / "scan.nii.gz", make_scan(MIRRORED)))
    use = child(dialog, "import_scan")
    assert not use.isEnabled()

    tick(dialog, 0)
    axial = next(view for view in dialog.views if view.name == "Axial")
    assert len(lines_of(axial.chosen)) > 20 and len(lines_of(axial.cut)) == 0
    click(child(dialog, "preview_scan"))
    qtbot.waitUntil(lambda: dialog.found is not None, timeout=WAIT)
    # what is drawn over the slice is the body's own width, whichever way the axes run
    width = np.ptp(lines_of(axial.cut), axis=0)
    assert width == pytest.approx(np.ptp(BOX[:, :2], axis=0), abs=2.5)
    assert "Smoothing changes the volume by" in child(dialog, "scan_facts").text()
    assert len(dialog.preview.corners) > 100
    click(use)
    settle(qtbot, window)

    organ = window.session.organ
    assert organ.segmentation.labels == (3,)
    assert np.abs(organ.surface.vertices.mean(axis=0) - 1e-3 * BOX.mean(axis=0)).max() < 1.5e-3
    assert window.import_panel.parts_section.isHidden()


@pytest.mark.landing
def test_another_choice_takes_the_preview_away(qtbot, window, tmp_path):
    dialog = open_scan(qtbot, window, write_scan(tmp_path / "scan.nrrd", make_scan(PLAIN)))
    tick(dialog, 0)
    click(child(dialog, "preview_scan"))
    qtbot.waitUntil(lambda: dialog.found is not None, timeout=WAIT)

    child(dialog, "scan_smooth").setValue(1.2)

    assert dialog.found is None and len(dialog.preview.corners) == 0
    assert all(len(lines_of(view.cut)) == 0 for view in dialog.views)


@pytest.mark.landing
def test_slices_of_a_folder_are_chosen_by_grey_level_and_shown_by_window_and_level(
    qtbot, window, tmp_path
):
    folder = write_dicom(tmp_path / "slices", make_scan(PLAIN, np.int16, 400, -900))
    dialog = open_scan(qtbot, window, next(folder.iterdir()))

    assert dialog.scan.path == folder and child(dialog, "scan_labels").isHidden()
    assert child(dialog, "level_preset").currentText() == "Soft tissue"
    assert dialog.views[0].image.getLevels().tolist() == [-160.0, 240.0]
    child(dialog, "window").setValue(1000.0)
    assert dialog.views[0].image.getLevels().tolist() == [-460.0, 540.0]
    child(dialog, "scan_low").setValue(100.0)
    assert dialog.choice() == Choice(low=100.0, smooth=0.0, largest=True)


@pytest.mark.landing
def test_a_scan_that_cannot_be_read_is_told_in_a_sentence(qtbot, window, tmp_path):
    (tmp_path / "a.nii").write_text("the notes of a year", encoding="utf-8")

    window.context.scan_wanted.emit(tmp_path / "a.nii")

    qtbot.waitUntil(lambda: window.context.jobs.current is None, timeout=WAIT)
    qtbot.waitUntil(lambda: "a.nii" in window.messages.text, timeout=WAIT)
    assert window.scans.dialog.isHidden()


def test_reading_a_scan_can_be_cancelled(qtbot, window, tmp_path):
    path = write_scan(tmp_path / "scan.nrrd", make_scan(PLAIN))
    window.context.scan_wanted.emit(path)
    job = window.context.jobs.current
    assert job is not None

    window.context.jobs.cancel()

    qtbot.waitUntil(lambda: job not in window.context.jobs.alive, timeout=WAIT)
    assert window.scans.dialog.scan is None


def write_two_series(folder: Path) -> dict[str, str]:
    """Title -> UID: grey levels as a scanner has them, and a few slices that were planned by."""
    made = make_scan(PLAIN, np.int16, 400, -900)
    uids = {"abdomen": "1.2.826.0.1.3680043.2.1125.1", "scout": "1.2.826.0.1.3680043.2.1125.2"}
    write_dicom(folder, made, uids["abdomen"], "abdomen")
    few = make_scan(PLAIN, np.int16, 400, -900)
    few.voxels = few.voxels[:4]
    write_dicom(folder, few, uids["scout"], "scout")
    return uids


@pytest.mark.landing
def test_of_several_series_the_largest_is_shown_and_another_can_be_chosen(
    qtbot, window, tmp_path, checkout
):
    uids = write_two_series(tmp_path / "slices")
    dialog = open_scan(qtbot, window, tmp_path / "slices")
    row = dialog.series

    assert row.isVisible() and row.list.count() == 2
    assert row.uid() == uids["abdomen"] and dialog.scan.size[2] > 4
    assert row.list.currentText().startswith("abdomen: ")
    folder = checkout / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    assert dialog.grab().save(str(folder / "editor_series.png"))
    child(dialog, "scan_low").setValue(100.0)
    click(child(dialog, "import_scan"))
    settle(qtbot, window)
    assert window.session.organ.segmentation.series == uids["abdomen"]

    row.list.setCurrentIndex(row.list.findData(uids["scout"]))
    row.list.activated.emit(row.list.currentIndex())
    qtbot.waitUntil(lambda: dialog.scan is not None and dialog.scan.size[2] == 4, timeout=WAIT)
    assert row.uid() == uids["scout"]


@pytest.mark.landing
def test_a_folder_of_one_series_asks_for_none(qtbot, window, tmp_path):
    folder = write_dicom(tmp_path / "slices", make_scan(PLAIN, np.int16, 400, -900))

    dialog = open_scan(qtbot, window, folder)

    assert not dialog.series.isVisible() and dialog.series.uid() is None
