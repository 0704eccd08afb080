# SPDX-License-Identifier: GPL-3.0-or-later
"""Volumes of one file: NIfTI, NRRD, MetaImage, legacy VTK, and DICOM of several frames."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import SimpleITK

from palpate_editor.scan_child.label_names import find_label_names
from palpate_editor.scan_child.nifti_header import (
    NiftiHeader,
    check_nifti,
    find_nifti_places,
    read_nifti_header,
)
from palpate_editor.scan_child.refused import Refused
from palpate_editor.scan_child.volume import Volume, check_places, check_size
from palpate_editor.scan_child.vtk_voxels import check_vtk

FORMATS = {
    "NiftiImageIO": "NIfTI",
    "NrrdImageIO": "NRRD",
    "MetaImageIO": "MetaImage",
    "GDCMImageIO": "DICOM",
    "VTKImageIO": "VTK",
}
"""What SimpleITK calls its readers -> what people call the format."""
EXPECTED = (
    "a volume as .nii, .nii.gz, .nrrd, .mha, .mhd, .vtk (structured points) or a folder of DICOM "
    "slices"
)
NIFTI = (".nii", ".nii.gz")
CORRECTED = "ITK_sform_corrected"
HEADER_TEXT = 65536
"""[bytes] Of a header of text that are looked at."""
ELSEWHERE = re.compile(rb"^(?:ElementDataFile\s*=|data ?file:)\s*(.+?)\s*$", re.M | re.I)
ALSO_BESIDE = {b"LOCAL", b"LIST"}
"""Words in the place of a name: the data follow, or their names do."""


def read_volume_file(path: Path) -> Volume:
    """Raises Refused."""
    name = SimpleITK.ImageFileReader.GetImageIOFromFileName(str(path))
    is_nifti = path.name.lower().endswith(NIFTI)
    if name not in FORMATS or (FORMATS[name] == "NIfTI") != is_nifti:
        got = "a picture or volume of another format" if name else "no volume"
        raise Refused("", got, EXPECTED)
    check_beside(path)
    reader = SimpleITK.ImageFileReader()
    reader.SetFileName(str(path))
    reader.SetImageIO(name)
    try:
        reader.ReadImageInformation()
    except RuntimeError as problem:
        raise Refused("header", shorten(problem), EXPECTED) from None
    size = tuple(reader.GetSize())
    check_size(size)
    if reader.GetNumberOfComponents() != 1:
        many = f"{reader.GetNumberOfComponents()} numbers in each voxel"
        raise Refused("voxels", many, "1: a grey level or a label")
    if FORMATS[name] == "VTK":
        check_vtk(path, size, count_bytes(reader))
    header = read_nifti_header(path) if is_nifti else None
    if header is not None:
        check_nifti(path, header, size)
    steps, origin = find_places(header, reader, len(size))
    check_places(steps, origin)
    voxels = read_voxels(reader, size)
    names = find_label_names(
        path, {key: reader.GetMetaData(key) for key in reader.GetMetaDataKeys()}
    )
    return Volume(voxels, steps, origin, FORMATS[name], names)


def count_bytes(reader: SimpleITK.ImageFileReader) -> int:
    """Of one voxel."""
    one = SimpleITK.Image([1] * reader.GetDimension(), reader.GetPixelID())
    return one.GetSizeOfPixelComponent()


def check_beside(path: Path) -> None:
    """A header of text names the file with its voxels: it may be beside it or below, not elsewhere.

    Raises Refused.
    """
    if path.suffix.lower() not in (".mhd", ".nhdr", ".mha", ".nrrd"):
        return
    with path.open("rb") as file:
        found = ELSEWHERE.search(file.read(HEADER_TEXT))
    if found is None or found[1].split()[0].upper() in ALSO_BESIDE:
        return
    name = Path(found[1].decode(errors="replace"))
    if name.is_absolute() or ".." in name.parts:
        raise Refused("data file", str(name), "a file beside the header, or below")
    if "%" not in name.name and not (path.parent / name).is_file():
        raise Refused("data file", f"no file {name}", "the voxels beside the header")


def read_voxels(reader: SimpleITK.ImageFileReader, size: tuple[int, ...]) -> np.ndarray:
    """(d, h, w). Raises Refused where the file ends before its voxels do."""
    shown = " x ".join(map(str, size))
    if len(size) > 3:
        reader.SetExtractSize([*size[:3], *(0 for _ in size[3:])])
    try:
        image = reader.Execute()
    except RuntimeError as problem:
        raise Refused("voxels", shorten(problem), f"{shown} voxels, as the header says") from None
    voxels = SimpleITK.GetArrayFromImage(image)
    if voxels.shape != size[2::-1]:
        raise Refused("voxels", f"an array of shape {voxels.shape}", f"{shown} voxels")
    if np.iscomplexobj(voxels):
        raise Refused("voxels", "complex numbers", "grey levels or labels")
    return voxels


def find_places(
    header: NiftiHeader | None, reader: SimpleITK.ImageFileReader, dimensions: int
) -> tuple[np.ndarray, np.ndarray]:
    """Steps and origin [mm] of a Volume.

    SimpleITK makes the axes of a NIfTI file perpendicular where they are not, as those of a tilted
    gantry, and says so: then the header's own matrix counts.
    """
    keys = reader.GetMetaDataKeys()
    corrected = CORRECTED in keys and reader.GetMetaData(CORRECTED) == "YES"
    if corrected and header is not None and header.matrix is not None:
        return find_nifti_places(header, np.array(reader.GetSpacing()[:3]))
    direction = np.reshape(reader.GetDirection(), (dimensions, dimensions))[:3, :3]
    return direction * np.array(reader.GetSpacing()[:3]), np.array(reader.GetOrigin()[:3])


def shorten(problem: Exception) -> str:
    """What SimpleITK says is wrong, without the places in its own sources."""
    lines = [line.strip() for line in str(problem).splitlines() if line.strip()]
    said = [
        line for line in lines if not line.startswith(("Exception thrown", "File:", "/", "sitk"))
    ]
    if "Reason: Success" in said:
        return "data that end too soon"
    text = (said or lines or ["nothing that can be read"])[-1]
    text = re.sub(r"^(?:ITK ERROR|sitk::ERROR):?\s*", "", text)
    text = re.sub(r"^(?:\w+\(0x[0-9a-f]+\)|\[nrrd\] \w+):\s*", "", text)
    return re.sub(r"\s+", " ", text)[:200].rstrip(" .!")
