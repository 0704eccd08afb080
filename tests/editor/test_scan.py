# SPDX-License-Identifier: GPL-3.0-or-later
"""Scans become surfaces where the patient has them, of the volume that the voxels have."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate_editor import authoring
from palpate_editor.from_scan import CUT_ENDS
from palpate_editor.scan import Choice, Series, SeveralSeries, read_range, read_scan, segment_scan
from palpate_editor.scan_child.chosen_part import EDGES
from scans import (
    BOX,
    MIDDLE,
    PLACES,
    PLAIN,
    TILT,
    TILTED,
    UNEVEN,
    VOLUME,
    Made,
    make_scan,
    write_dicom,
    write_scan,
)

BODY = Choice(labels=(3,))
BRIGHT = Choice(low=500.0)


def inspect(found) -> authoring.MeshReport:
    return authoring.inspect_mesh(palpate.SurfaceMesh(found.vertices, found.triangles))


def write_any(folder, ending: str, made: Made):
    if ending == "dicom":
        return write_dicom(folder / "slices", made)
    return write_scan(folder / f"scan{ending}", made)


def assert_is_the_body(found) -> None:
    """Where it is, how large, closed and outward."""
    off = 0.6e-3 * max(1e3 * found.scan.spacing)
    box = np.array([found.vertices.min(axis=0), found.vertices.max(axis=0)])
    assert np.abs(box - 1e-3 * BOX).max() < off
    assert np.abs(found.vertices.mean(axis=0) - 1e-3 * MIDDLE).max() < off
    report = inspect(found)
    assert report.closed and report.outward and report.shells == 1 and report.genus == 0
    assert report.non_manifold_edges == 0
    assert found.volume == pytest.approx(1e-6 * report.volume_ml, rel=1e-9)
    assert abs(found.volume / found.voxel_volume - 1.0) < 0.02
    assert found.voxel_volume == pytest.approx(1e-9 * VOLUME, rel=0.02)


EVERY = [(ending, place) for ending in (".nii.gz", ".nrrd", "dicom") for place in PLACES]
SAMPLE = {(".nii.gz", "tilted"), (".nrrd", "oblique"), ("dicom", "tilted"), ("dicom", "sagittal")}
"""In every test; the rest at a landing."""


@pytest.mark.parametrize(
    ("ending", "place"),
    [row if row in SAMPLE else pytest.param(*row, marks=pytest.mark.landing) for row in EVERY],
)
def test_a_label_is_where_the_patient_has_it(ending, place, tmp_path):
    path = write_any(tmp_path, ending, make_scan(PLACES[place]))

    found = segment_scan(path, BODY)

    assert found.scan.tilt == pytest.approx(TILT if place == "tilted" else 0.0, abs=0.01)
    assert_is_the_body(found)
    assert found.change == pytest.approx(found.volume / found.voxel_volume - 1.0, abs=1e-9)
    assert found.cut_sides == ()


@pytest.mark.parametrize(
    "ending", [pytest.param(".nii", marks=pytest.mark.landing), ".nhdr",
               pytest.param(".mha", marks=pytest.mark.landing), ".mhd", ".vtk"]
)  # fmt: skip
def test_every_format_is_read_alike(ending, tmp_path):
    path = write_any(tmp_path, ending, make_scan(UNEVEN, np.int16))

    scan = read_scan(path, voxels=True)

    assert scan.size == scan.voxels.shape[::-1]
    assert scan.spacing == pytest.approx([1.0e-3, 1.25e-3, 2.5e-3], rel=1e-5)
    assert [row.label for row in scan.labels] == [3]
    assert_is_the_body(segment_scan(path, BODY))


@pytest.mark.landing
def test_a_tilt_that_were_ignored_would_be_seen(tmp_path):
    """Else the test above proves nothing of it: the ends of the body shear by this much."""
    path = write_any(tmp_path, "dicom", make_scan(TILTED))
    found = segment_scan(path, BODY)

    leaning = found.vertices.copy()
    leaning[:, 1] += np.tan(np.radians(TILT)) * (leaning[:, 2] - 1e-3 * MIDDLE[2])

    def find_error(vertices: np.ndarray) -> float:
        scaled = (1e3 * vertices - MIDDLE) / (0.5 * np.ptp(BOX, axis=0))
        return float(np.abs(np.linalg.norm(scaled, axis=1) - 1.0).mean())

    assert find_error(leaning) > 2.0 * find_error(found.vertices)
    assert found.scan.notes == (f"the gantry was tilted by {TILT:.1f} degrees",)


@pytest.mark.landing
def test_smoothing_takes_stairs_away_and_keeps_the_volume(tmp_path):
    path = write_scan(tmp_path / "a.nrrd", make_scan(PLAIN))

    roughness = []
    for smooth in (0.0, 0.8):
        found = segment_scan(path, Choice(labels=(3,), smooth=smooth))
        assert abs(found.volume / found.voxel_volume - 1.0) < 0.02
        x = (found.vertices - 1e-3 * MIDDLE) / (0.5e-3 * np.ptp(BOX, axis=0))
        roughness.append(float(np.linalg.norm(x, axis=1).std()))
    assert roughness[1] < 0.6 * roughness[0]
    assert found.change != 0.0


def test_at_one_half_the_same_smoothing_would_shrink_it(tmp_path):
    """Why the level is looked for: a Gaussian takes from what is convex."""
    scipy = pytest.importorskip("scipy.ndimage")
    made = make_scan(PLAIN)
    mask = (made.voxels == 3).astype(float)

    inside = scipy.gaussian_filter(mask, 1.2) > 0.5

    assert inside.sum() < 0.98 * mask.sum()
    path = write_scan(tmp_path / "a.nrrd", made)
    found = segment_scan(path, Choice(labels=(3,), smooth=1.2))
    assert abs(found.change) < 0.002


def test_a_threshold_on_whole_grey_levels_is_cut_between_them(tmp_path):
    """At the very level voxels lie on the surface, which degenerates there."""
    path = write_scan(tmp_path / "a.nii.gz", make_scan(UNEVEN, np.int16, inside=500, outside=-900))

    found = segment_scan(path, BRIGHT)

    assert found.scan.labels is None
    report = inspect(found)
    assert report.closed and report.non_manifold_edges == 0 and report.genus == 0
    # of 500 against -900 the surface stands at 499.5, close to the voxels inside
    assert 0.5 * VOLUME < 1e9 * found.volume < VOLUME


@pytest.mark.landing
@pytest.mark.parametrize(("low", "high"), [(100.0, None), (100.0, 700.0), (None, None)])
def test_a_range_of_grey_levels_cuts_where_the_body_ends(low, high, tmp_path):
    """A body that fades: its level of one half is its surface to a part of a voxel."""
    made = make_scan(PLAIN)
    i, j, k = np.meshgrid(*map(np.arange, made.voxels.shape[::-1]), indexing="ij")
    x = np.stack([i, j, k], -1) @ made.steps.T + made.origin
    radius = np.linalg.norm((x - MIDDLE) / (0.5 * np.ptp(BOX, axis=0)), axis=-1)
    grey = 100.0 + 400.0 * (1.0 - radius)
    made.voxels = grey.astype(np.float32).transpose(2, 1, 0).copy()
    if low is None:
        made.voxels, low, high = -made.voxels, None, -100.0
    path = write_scan(tmp_path / "a.mha", made)

    found = segment_scan(path, Choice(low=low, high=high))

    assert found.change == 0.0
    assert 1e9 * found.volume == pytest.approx(VOLUME, rel=0.01)
    box = np.array([found.vertices.min(axis=0), found.vertices.max(axis=0)])
    assert np.abs(box - 1e-3 * BOX).max() < 2e-4


@pytest.mark.landing
def test_both_ends_of_a_range_belong_to_it(tmp_path):
    voxels = np.zeros((9, 9, 9), np.int16)
    for k, level in enumerate((10, 20, 30)):
        voxels[3:6, 3:6, 2 * k + 1] = level
    path = write_scan(tmp_path / "a.nrrd", Made(voxels, np.eye(3), np.zeros(3)))

    found = segment_scan(path, Choice(low=10.0, high=20.0))

    assert found.voxel_volume == pytest.approx(18e-9)
    assert inspect(found).shells == 2


def test_a_body_that_the_scan_cuts_is_closed_and_says_so(tmp_path):
    made = make_scan(UNEVEN)
    middle = len(made.voxels) // 2
    path = write_scan(tmp_path / "a.nii", Made(made.voxels[:middle], made.steps, made.origin))

    found = segment_scan(path, BODY)

    assert found.cut_sides == ("top",)
    assert inspect(found).closed
    # the plane is half a voxel above the last slice's middle
    assert found.vertices[:, 2].max() == pytest.approx(
        1e-3 * (made.origin[2] + 2.5 * (middle - 0.5)), abs=1e-3
    )


@pytest.mark.landing
def test_pieces_and_cavities_are_kept_dropped_and_counted(tmp_path):
    voxels = np.zeros((24, 24, 40), np.uint8)
    voxels[4:20, 4:20, 4:20] = 1
    voxels[10:14, 10:14, 10:14] = 0
    voxels[8:12, 8:12, 28:32] = 1
    voxels[2, 2, 36] = 1
    path = write_scan(tmp_path / "a.nrrd", Made(voxels, np.eye(3), np.zeros(3)))

    every = segment_scan(path, Choice(labels=(1,), smooth=0.0))
    large = segment_scan(path, Choice(labels=(1,), smooth=0.0, least_volume=50e-9))
    one = segment_scan(path, Choice(labels=(1,), smooth=0.0, largest=True))

    assert (inspect(every).shells, every.pieces_dropped, every.shells_dropped) == (4, 0, 0)
    assert (inspect(large).shells, large.pieces_dropped) == (3, 1)
    assert (inspect(one).shells, one.pieces_dropped, one.shells_dropped) == (1, 2, 0)
    assert one.voxel_volume == pytest.approx(16.0**3 * 1e-9)


@pytest.mark.landing
def test_several_labels_are_one_organ(tmp_path):
    made = make_scan(PLAIN)
    made.voxels[:, :, made.voxels.shape[2] // 2 :] *= 2
    path = write_scan(tmp_path / "a.nii.gz", made)

    found = segment_scan(path, Choice(labels=(3, 6)))

    assert [row.label for row in found.scan.labels] == [3, 6]
    assert_is_the_body(found)


@pytest.mark.landing
def test_names_of_segments_are_read(tmp_path):
    import SimpleITK
    from scans import make_image

    image = make_image(make_scan(PLAIN))
    image.SetMetaData("Segment0_LabelValue", "3")
    image.SetMetaData("Segment0_Name", "left kidney")
    SimpleITK.WriteImage(image, str(tmp_path / "a.seg.nrrd"))

    scan = read_scan(tmp_path / "a.seg.nrrd")

    assert [(row.label, row.name) for row in scan.labels] == [(3, "left kidney")]


@pytest.mark.parametrize(
    ("text", "ends"),
    [("-150:200.5", (-150.0, 200.5)), ("200:", (200.0, None)), (":-300", (None, -300.0))],
)
def test_a_range_may_have_one_end(text, ends):
    assert read_range(text) == ends


@pytest.mark.parametrize("text", ["", ":", "200", "a:b", "nan:3", "1:inf", "1:2:3"])
def test_a_range_without_ends_is_refused(text):
    with pytest.raises(ValueError, match="expected LOW:HIGH"):
        read_range(text)


@pytest.mark.parametrize(
    "wrong",
    [
        {},
        {"labels": (1,), "low": 0.0},
        {"low": 2.0, "high": 1.0},
        {"labels": (1,), "smooth": 99.0},
        {"labels": (1,), "smooth": float("nan")},
        {"labels": (1,), "least_volume": -1.0},
    ],
)
def test_a_choice_that_means_nothing_is_refused(wrong):
    with pytest.raises(ValueError, match="expected"):
        Choice(**wrong)


def test_a_folder_of_several_series_says_which_there_are(tmp_path):
    made = make_scan(PLAIN, np.int16, 400, -900)
    write_dicom(tmp_path / "slices", made, "1.2.3.1", "abdomen")
    made.voxels = made.voxels[:4]
    write_dicom(tmp_path / "slices", made, "1.2.3.2", "scout")

    with pytest.raises(SeveralSeries) as several:
        read_scan(tmp_path / "slices")

    size = made.voxels.shape[:0:-1]
    rows = {row.title: row for row in several.value.series}
    assert rows["scout"] == Series("1.2.3.2", "scout", 4, size)
    assert rows["abdomen"].slices > 4
    assert several.value.where == "--series" and "2 series" in several.value.got
    assert read_scan(tmp_path / "slices", series="1.2.3.2").size[2] == 4


def test_every_side_at_which_an_organ_is_cut_has_its_note():
    assert set(CUT_ENDS) == set(EDGES)
