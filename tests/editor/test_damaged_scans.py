# SPDX-License-Identifier: GPL-3.0-or-later
"""Every scan that cannot be used is refused with a sentence: where, what was got, what expected."""

from __future__ import annotations

import gzip
import shutil
from pathlib import Path

import numpy as np
import palpate
import pytest
import SimpleITK
from hostile_names import list_run, make_hostile_folder
from palpate_editor.scan import (
    Cancelled,
    Choice,
    Limits,
    MissingExtra,
    hash_scan,
    read_scan,
    segment_scan,
)
from scans import PLAIN, UNEVEN, Made, make_scan, write_dicom, write_scan
from tiers import keep_everyday


def plain(kind: type = np.int16) -> Made:
    return make_scan(PLAIN, kind)


def cut_off(path: Path, share: float = 0.6) -> Path:
    data = path.read_bytes()
    path.write_bytes(data[: int(share * len(data))])
    return path


def write_grid(path: Path, shape: tuple[int, ...], kind: type = np.int16) -> Path:
    image = SimpleITK.GetImageFromArray(np.ones(shape, kind), isVector=False)
    SimpleITK.WriteImage(image, str(path))
    return path


def truncated_nifti(folder: Path) -> Path:
    return cut_off(write_scan(folder / "a.nii", plain()))


def truncated_gzip(folder: Path) -> Path:
    made = plain()
    made.voxels = np.random.default_rng(1).integers(0, 9, made.voxels.shape).astype(np.int16)
    return cut_off(write_scan(folder / "a.nii.gz", made))


def truncated_nrrd(folder: Path) -> Path:
    return cut_off(write_scan(folder / "a.nrrd", plain()), 0.8)


def truncated_meta(folder: Path) -> Path:
    path = folder / "a.mha"
    SimpleITK.WriteImage(SimpleITK.GetImageFromArray(plain().voxels), str(path), False)
    return cut_off(path)


def truncated_vtk(folder: Path, binary: bool = True) -> Path:
    path = folder / "a.vtk"
    image = SimpleITK.GetImageFromArray(plain().voxels)
    if binary:
        SimpleITK.WriteImage(image, str(path), False)
        return cut_off(path)
    size = " ".join(map(str, image.GetSize()))
    path.write_text(
        f"# vtk DataFile Version 3.0\na\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS {size}\n"
        "ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 3\nSCALARS a short 1\nLOOKUP_TABLE default\n"
        "1 2 3\n",
        encoding="utf-8",
    )
    return path


def short_raw(folder: Path) -> Path:
    path = folder / "a.mhd"
    SimpleITK.WriteImage(SimpleITK.GetImageFromArray(plain().voxels), str(path), False)
    cut_off(folder / "a.raw")
    return path


def wrong_extents(folder: Path) -> Path:
    path = write_scan(folder / "a.nii", plain())
    data = bytearray(path.read_bytes())
    data[40:48] = np.array([3, 900, 90, 900], "<i2").tobytes()
    path.write_bytes(data)
    return path


def huge_extents(folder: Path) -> Path:
    path = write_scan(folder / "a.nii", plain())
    data = bytearray(path.read_bytes())
    data[40:48] = np.array([3, 30000, 30000, 30000], "<i2").tobytes()
    path.write_bytes(data)
    return path


def negative_extents(folder: Path) -> Path:
    path = write_scan(folder / "a.nii", plain())
    data = bytearray(path.read_bytes())
    data[40:48] = np.array([3, -5, 20, 20], "<i2").tobytes()
    path.write_bytes(data)
    return path


def not_a_number(folder: Path) -> Path:
    made = plain(np.float32)
    made.voxels[3, 4, 5] = np.nan
    made.voxels[4, 4, 5] = np.inf
    return write_scan(folder / "a.nrrd", made)


def no_spacing(folder: Path) -> Path:
    path = write_scan(folder / "a.nii", plain())
    data = bytearray(path.read_bytes())
    data[76:92] = np.zeros(4, "<f4").tobytes()
    data[252:256] = bytes(4)
    path.write_bytes(data)
    return path


def nan_places(folder: Path) -> Path:
    path = write_scan(folder / "a.nii", plain())
    data = bytearray(path.read_bytes())
    data[280:296] = np.full(4, np.nan, "<f4").tobytes()
    path.write_bytes(data)
    return path


def flat_axes(folder: Path) -> Path:
    path = folder / "a.nhdr"
    write_scan(path, plain())
    lines = path.read_text(encoding="utf-8").split("\n")
    flat = "space directions: (1,0,0) (0,1,0) (1,1,0)"
    path.write_text(
        "\n".join(flat if "directions" in line else line for line in lines), encoding="utf-8"
    )
    return path


def voxels_elsewhere(folder: Path) -> Path:
    (folder / "inner").mkdir()
    path = write_scan(folder / "inner" / "a.mhd", plain())
    text = path.read_text(encoding="utf-8")
    name = text.partition("ElementDataFile = ")[2].strip()
    shutil.move(folder / "inner" / name, folder / name)
    path.write_text(text.replace(name, f"../{name}"), encoding="utf-8")
    return path


def voxels_gone(folder: Path) -> Path:
    path = write_scan(folder / "a.nhdr", plain())
    for name in folder.glob("a.raw*"):
        name.unlink()
    return path


def slice_gone(folder: Path) -> Path:
    made = write_dicom(folder / "slices", make_scan(UNEVEN))
    next(path for path in made.iterdir() if path.name.endswith("-4.dcm")).unlink()
    return made


def slice_twice(folder: Path) -> Path:
    made = write_dicom(folder / "slices", make_scan(UNEVEN))
    shutil.copy(sorted(made.iterdir())[3], made / "again.dcm")
    return made


def slice_damaged(folder: Path) -> Path:
    made = write_dicom(folder / "slices", make_scan(UNEVEN))
    cut_off(sorted(made.iterdir())[3], 0.9)
    return made


def two_series(folder: Path) -> Path:
    made = write_dicom(folder / "slices", make_scan(UNEVEN))
    return write_dicom(made, make_scan(UNEVEN), "1.2.826.0.1.3680043.2.1125.2", "thorax")


def one_slice(folder: Path) -> Path:
    made = write_dicom(folder / "slices", make_scan(UNEVEN))
    for path in sorted(made.iterdir())[1:]:
        path.unlink()
    return made


def slices_of_two_sizes(folder: Path) -> Path:
    made = write_dicom(folder / "slices", make_scan(UNEVEN))
    smaller = make_scan(UNEVEN)
    other = Made(smaller.voxels[:1, :-1], smaller.steps, smaller.origin - 2.5 * np.eye(3)[2])
    return write_dicom(made, other, title="first")


def no_dicom(folder: Path) -> Path:
    (folder / "slices").mkdir()
    (folder / "slices" / "notes.txt").write_text("the notes of a year", encoding="utf-8")
    return folder / "slices"


def text(folder: Path, words: str | bytes = b"the notes of a year") -> Path:
    (folder / "a.nii").write_bytes(words if isinstance(words, bytes) else words.encode())
    return folder / "a.nii"


def picture(folder: Path) -> Path:
    return write_grid(folder / "a.png", (20, 20), np.uint8)


def colours(folder: Path) -> Path:
    image = SimpleITK.GetImageFromArray(np.ones((5, 6, 7, 3), np.uint8), isVector=True)
    SimpleITK.WriteImage(image, str(folder / "a.mha"))
    return folder / "a.mha"


DAMAGED = {
    "NIfTI that ends too soon": (truncated_nifti, "voxels", "as the header says"),
    "gzip that ends too soon": (truncated_gzip, "voxels", "as the header says"),
    "NRRD that ends too soon": (truncated_nrrd, "voxels", "as the header says"),
    "MetaImage that ends too soon": (truncated_meta, "voxels", "as the header says"),
    "VTK that ends too soon": (truncated_vtk, "voxels", "as the header says"),
    "VTK in text that ends too soon": (
        lambda f: truncated_vtk(f, False), "voxels", "as the header says"
    ),
    "voxels that end too soon beside their header": (short_raw, "voxels", "as the header says"),
    "a header of a larger volume": (wrong_extents, "voxels", "for 900 x 90 x 900 voxels"),
    "a header of a huge volume": (huge_extents, "size", "30000 x 30000 x 30000 voxels"),
    "a header of a negative volume": (negative_extents, "header", "expected a volume as"),
    "NaN": (not_a_number, "voxel 5, 4, 3", "1 more that are no numbers"),
    "4-D": (lambda f: write_grid(f / "a.nii", (3, 4, 5, 6)), "size", "6 x 5 x 4 x 3"),
    "2-D": (lambda f: write_grid(f / "a.mha", (9, 8)), "size", "a picture of 8 x 9 voxels"),
    "one slice": (lambda f: write_grid(f / "a.nrrd", (1, 9, 8)), "size", "8 x 9 x 1 voxels"),
    "no spacing": (no_spacing, "spacing", "none (pixdim of 0)"),
    "a matrix of NaN": (nan_places, "", "expected"),
    "axes in one plane": (flat_axes, "", "expected"),
    "voxels in another folder": (voxels_elsewhere, "data file", "beside the header, or below"),
    "no voxels beside the header": (voxels_gone, "data file", "no file a.raw"),
    "colours": (colours, "voxels", "3 numbers in each voxel"),
    "a picture": (picture, "", "another format"),
    "text": (text, "", "expected a volume as .nii"),
    "nothing": (lambda f: text(f, b""), "", "expected a volume as .nii"),
    "random bytes": (
        lambda f: text(f, np.random.default_rng(3).bytes(4096)), "", "expected a volume as .nii"
    ),
    "gzip of nothing": (
        lambda f: write_bytes(f / "a.nii.gz", gzip.compress(b"")), "", "expected a volume as .nii"
    ),
    "a missing slice": (slice_gone, "between", "slices are missing or uneven"),
    "a slice twice": (slice_twice, "again.dcm", "two slices at one place"),
    "a damaged slice": (slice_damaged, "abdomen-", "expected"),
    "two series": (two_series, "--series", "thorax"),
    "one slice of a series": (one_slice, "", "one slice"),
    "slices of two sizes": (slices_of_two_sizes, ".dcm", "of the same spacing"),
    "a folder without slices": (no_dicom, "", "none of them DICOM"),
}  # fmt: skip
SAMPLE = {
    "VTK that ends too soon",
    "gzip that ends too soon",
    "NaN",
    "4-D",
    "2-D",
    "a missing slice",
    "text",
}
"""In every test; the rest at a landing."""


def write_bytes(path: Path, data: bytes) -> Path:
    path.write_bytes(data)
    return path


@pytest.mark.parametrize("name", keep_everyday(DAMAGED, SAMPLE))
def test_a_damaged_scan_is_refused_with_a_sentence(name, tmp_path):
    make, where, words = DAMAGED[name]
    path = make(tmp_path)

    with pytest.raises(palpate.FileError) as refused:
        segment_scan(path, Choice(labels=(3,)))

    said = str(refused.value)
    assert said.startswith(f"{path}: ") and where in refused.value.where and words in said
    assert "broke its reader" not in said and "\n" not in said and len(said) < 700
    assert not [word for word in ("ITK ERROR", "itk::", "0x", ".cxx", "Traceback") if word in said]


def test_an_empty_label_names_those_there_are(tmp_path):
    path = write_scan(tmp_path / "a.nii.gz", plain())

    with pytest.raises(palpate.FileError) as refused:
        segment_scan(path, Choice(labels=(7,)))

    assert "--label: got 7, which no voxel has, expected one that there is: 3" in str(refused.value)


@pytest.mark.landing
@pytest.mark.parametrize(
    ("choice", "words"),
    [
        (Choice(low=5000.0), "--threshold: got 5000:, within which no voxel is, expected a range"),
        (Choice(labels=(3,), least_volume=1.0), "--least-volume"),
    ],
)
def test_a_choice_of_nothing_says_what_there_is(choice, words, tmp_path):
    made = plain()
    made.voxels[0, 0, 0] = 3  # a second piece
    path = write_scan(tmp_path / "a.nrrd", made)

    with pytest.raises(palpate.FileError) as refused:
        segment_scan(path, choice)

    assert words in str(refused.value)


@pytest.mark.landing
def test_smoothing_that_would_eat_the_organ_is_refused(tmp_path):
    voxels = np.zeros((20, 20, 20), np.uint8)
    voxels[5:15, 10, 5:15] = 1
    path = write_scan(tmp_path / "a.nrrd", Made(voxels, np.eye(3), np.zeros(3)))

    with pytest.raises(palpate.FileError, match="expected at most 2 %: smooth less"):
        segment_scan(path, Choice(labels=(1,), smooth=4.0))


@pytest.mark.landing
def test_one_series_of_two_is_read_when_it_is_named(tmp_path):
    path = two_series(tmp_path)

    scan = read_scan(path, series="1.2.826.0.1.3680043.2.1125.2")

    assert [row.label for row in scan.labels] == [3]


def test_a_scan_that_is_gone_is_a_file_that_is_gone(tmp_path):
    with pytest.raises(FileNotFoundError):
        read_scan(tmp_path / "none.nii")


def test_a_reader_that_takes_too_long_is_ended(tmp_path):
    path = write_scan(tmp_path / "a.nrrd", plain())

    with pytest.raises(palpate.FileError, match="longer to read, expected at most 0.01 s"):
        read_scan(path, limits=Limits(time=0.01))


@pytest.mark.landing
def test_a_reader_that_takes_too_much_memory_is_refused(tmp_path):
    path = write_grid(tmp_path / "a.nrrd", (400, 400, 400), np.float32)

    with pytest.raises(palpate.FileError, match="expected"):
        segment_scan(path, Choice(low=0.5), limits=Limits(memory=1_000_000_000))


def test_a_scan_that_is_no_longer_wanted_is_left_at_once(tmp_path):
    path = write_scan(tmp_path / "a.nrrd", plain())
    asked = []

    def stopped() -> bool:
        asked.append(True)
        return True

    with pytest.raises(Cancelled):
        read_scan(path, stopped=stopped)

    assert asked == [True]


def test_what_to_install_is_said_where_the_reader_is_missing(tmp_path, monkeypatch):
    path = write_scan(tmp_path / "a.nrrd", plain())
    hidden = tmp_path / "hidden"
    hidden.mkdir()
    (hidden / "SimpleITK.py").write_text(
        "raise ModuleNotFoundError(\"No module named 'SimpleITK'\", name='SimpleITK')",
        encoding="utf-8",
    )
    monkeypatch.setenv("PYTHONPATH", str(hidden))

    with pytest.raises(MissingExtra, match=r"no SimpleITK .* pip install 'palpate-editor\[scan\]'"):
        read_scan(path)


def test_the_reader_imports_nothing_from_the_current_folder(tmp_path, monkeypatch):
    path = write_scan(tmp_path / "a.nrrd", plain())
    hostile = make_hostile_folder(tmp_path / "organs")
    monkeypatch.chdir(hostile)

    assert read_scan(path).format == "NRRD"
    assert list_run(hostile) == ""


def test_the_hash_of_a_folder_is_that_of_its_files_whatever_their_order(tmp_path):
    for folder, order in (("a", (0, 1)), ("b", (1, 0))):
        (tmp_path / folder).mkdir()
        for k in order:
            (tmp_path / folder / f"{k}.dcm").write_bytes(bytes([k]))

    assert hash_scan(tmp_path / "a") == hash_scan(tmp_path / "b")
    (tmp_path / "a" / "1.dcm").write_bytes(b"other")
    assert hash_scan(tmp_path / "a") != hash_scan(tmp_path / "b")
