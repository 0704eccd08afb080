# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that makes an organ of a scan, from the file to the document."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate_editor import from_scan
from palpate_editor.document.files import pack_organ, read_organ, unpack_organ
from palpate_editor.scan import Choice, hash_scan
from scans import BOX, PLAIN, UNEVEN, make_scan, write_dicom, write_scan


def report_of(capsys, *words: object) -> dict:
    assert main([*map(str, words), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


@pytest.fixture
def labels(tmp_path) -> Path:
    return write_scan(tmp_path / "scan.nii.gz", make_scan(UNEVEN))


def test_label_1_of_the_slab_becomes_a_spleen_of_600_that_the_doctor_passes(
    shared_data, tmp_path, capsys
):
    slab = shared_data("volumes/ts_example_seg.nii.gz")
    organ = tmp_path / "spleen.organ"

    made = report_of(
        capsys, "segment", slab, "--label", 1, "--largest", "--vertices", 600, "-o", organ
    )

    mesh, done = made["mesh"], made["segmentation"]
    assert (mesh["vertices"], mesh["triangles"], mesh["shells"]) == (600, 1196, 1)
    assert mesh["closed"] and mesh["outward"] and mesh["genus"] == 0
    assert mesh["non_manifold_edges"] == 0 and mesh["self_intersecting_faces"] == 0
    assert mesh["smallest_angle_deg"] > 20.0
    assert 1e6 * done["voxel_volume"] == pytest.approx(9452 * 27e-3)
    assert abs(done["volume_change"]) < 0.002
    assert mesh["volume_ml"] == pytest.approx(1e6 * done["voxel_volume"], rel=0.02)
    found = read_organ(organ)
    assert (found.name, found.source.parts) == ("spleen", ("label 1",))
    # a spleen is on the patient's left; the slab cuts it at both ends
    assert found.surface.vertices[:, 0].min() > 0.0
    assert made["cut_sides"] == ["bottom", "top"]


@pytest.mark.usefixtures("little_sky")
@pytest.mark.landing
def test_what_was_cut_out_of_a_scan_can_be_pressed(shared_data, tmp_path, capsys):
    slab, organ = shared_data("volumes/ts_example_seg.nii.gz"), tmp_path / "spleen.organ"
    words = ["segment", slab, "--label", 1, "--largest", "--vertices", 600, "-o", organ]
    report_of(capsys, *words)
    solid, published = tmp_path / "solid.organ", tmp_path / "spleen.palpate"

    report_of(capsys, "material", organ, "--kind", "solid", "--fix-lowest", 0.1, "-o", solid)
    report_of(capsys, "publish", solid, "--title", "Spleen", "-o", published)
    pressed = report_of(capsys, "press", published, "--depth", "4mm")

    assert pressed["peak_force_N"] > 0.01


def test_the_document_says_what_was_done_to_which_scan(labels, tmp_path, capsys):
    out = tmp_path / "a.organ"

    report_of(capsys, "segment", labels, "--label", 3, "--smooth", 1.0, "-o", out)

    organ = read_organ(out)
    done = organ.segmentation
    assert (done.labels, done.low, done.high, done.smooth) == ((3,), None, None, 1.0)
    assert done.spacing == pytest.approx((1.0e-3, 1.25e-3, 2.5e-3), rel=1e-5)
    assert organ.source.sha256 == hash_scan(labels)
    assert (organ.source.file, organ.source.folder) == ("scan.nii.gz", str(tmp_path))
    assert (organ.source.format, organ.source.unit) == ("NIfTI", "mm")
    assert organ.name == "scan"


def test_a_mesh_that_is_imported_after_a_scan_has_no_segmentation(labels):
    edit, _ = from_scan.import_scan(labels, Choice(labels=(3,)))
    from palpate_editor.document import EMPTY
    from palpate_editor.edits import ImportMesh

    organ = edit(EMPTY)
    again = ImportMesh("mesh", organ.source, organ.surface)(organ)

    assert organ.segmentation is not None and again.segmentation is None


@pytest.mark.landing
def test_without_a_choice_the_verb_says_what_the_scan_holds(labels, capsys):
    report = report_of(capsys, "segment", labels)

    assert (report["format"], report["type"]) == ("NIfTI", "uint8")
    assert report["spacing_mm"] == pytest.approx([1.0, 1.25, 2.5], rel=1e-5)
    assert [row["label"] for row in report["labels"]] == [3]
    assert main(["segment", str(labels)]) == 0
    assert "label 3: 13.68 ml" in capsys.readouterr().out


@pytest.mark.landing
def test_a_folder_of_slices_is_cut_by_grey_levels(tmp_path, capsys):
    folder = write_dicom(tmp_path / "slices", make_scan(UNEVEN, np.int16, 400, -100))
    out = tmp_path / "a.obj"

    made = report_of(capsys, "segment", folder, "--threshold", "150:", "-o", out)

    assert made["segmentation"]["low"] == 150.0
    lines = out.read_text(encoding="utf-8").splitlines()
    points = np.array(
        [[float(x) for x in line.split()[1:]] for line in lines if line.startswith("v ")]
    )
    assert np.abs(np.array([points.min(0), points.max(0)]) - 1e-3 * BOX).max() < 1.6e-3


@pytest.mark.landing
def test_a_unit_that_is_given_is_the_unit_used(labels, tmp_path, capsys):
    plain = report_of(capsys, "segment", labels, "--label", 3)
    given = report_of(
        capsys, "segment", labels, "--label", 3, "--unit", "cm", "-o", tmp_path / "a.organ"
    )

    assert given["mesh"]["size_mm"] == pytest.approx([10 * s for s in plain["mesh"]["size_mm"]])
    assert given["segmentation"]["volume"] == pytest.approx(1e3 * plain["segmentation"]["volume"])
    assert read_organ(tmp_path / "a.organ").source.unit_reason == "as asked"


@pytest.mark.parametrize(
    "words", [["--smooth", "1"], ["--largest"], ["--vertices", "80"], ["-o", "a.organ"],
              ["--unit", "cm"], ["--least-volume", "1ml"]]
)  # fmt: skip
def test_an_option_without_a_choice_is_refused(words, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)

    assert main(["segment", "none.nii", *words]) == 2

    assert "needs --label or --threshold" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--threshold", "a"], "expected LOW:HIGH"),
        (["--threshold", "3:1"], "expected the lower end first"),
        (["--label", "1", "--smooth", "9"], "expected 0 to 4"),
        (["--label", "1", "--threshold", "1:2"], "not allowed with"),
        (["--label", "1", "--least-volume", "5"], "expected a number with a unit"),
    ],
)
def test_a_choice_that_means_nothing_is_a_wrong_call(words, sentence, capsys):
    assert main(["segment", "none.nii", *words]) == 2

    assert sentence in capsys.readouterr().err


def test_a_label_that_is_not_there_is_refused_in_words_and_json(labels, capsys):
    assert main(["segment", str(labels), "--label", "9", "--json"]) == 1

    error = json.loads(capsys.readouterr().out)["error"]
    assert error["file"] == str(labels) and error["where"] == "--label"


@pytest.mark.parametrize(
    ("segmentation", "words"),
    [
        ([], "segmentation: got []"),
        ({"labels": [1]}, "segmentation: got no"),
        ({"labels": ["1"]}, "segmentation.labels: got"),
        ({"voxels": 3}, "segmentation.voxels: got an unknown field"),
    ],
)
def test_a_damaged_segmentation_is_refused(segmentation, words):
    from organs import make_organ
    from palpate_editor.document.files import VERSION

    content, arrays = pack_organ(make_organ())
    content = json.loads(json.dumps(content)) | {"segmentation": segmentation}

    with pytest.raises(palpate.FileError) as refused:
        unpack_organ(content, arrays, VERSION, "a.organ")

    assert words in str(refused.value)


@pytest.mark.landing
def test_the_name_of_a_labelled_part_names_the_organ(tmp_path):
    path = write_scan(tmp_path / "left lung.nrrd", make_scan(PLAIN))

    edit, _ = from_scan.import_scan(path, Choice(labels=(3,)))

    assert edit.name == "left lung"
