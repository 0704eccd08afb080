# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of brains: GIFTI (.gii), FreeSurfer's (.pial, .white, .inflated ...) and Surfice's
(.mz3) [GIFTI 1.0; FreeSurfer's "surface files"; Surfice's "mz3 format"]."""

from __future__ import annotations

import base64
import binascii
import struct
from pathlib import Path
from xml.etree.ElementTree import Element, ParseError, parse

import numpy as np

from palpate_editor.formats_child.gmsh_values import TextValues
from palpate_editor.formats_child.packed import inflate, unpack
from palpate_editor.formats_child.scene import Part, Refusal, Scene, cut_out

KINDS = {
    "NIFTI_TYPE_UINT8": "u1",
    "NIFTI_TYPE_INT32": "i4",
    "NIFTI_TYPE_FLOAT32": "f4",
    "NIFTI_TYPE_FLOAT64": "f8",
}
POINTS, TRIANGLES = "NIFTI_INTENT_POINTSET", "NIFTI_INTENT_TRIANGLE"


def read_gifti(path: str) -> Scene:
    """In millimetres, z up, as GIFTI says. Raises Refusal."""
    try:
        root = parse(path).getroot()
    except ParseError as problem:
        line = problem.position[0]
        raise Refusal(f"line {line}", f"no XML ({problem.msg})", "a file of GIFTI") from None
    if root.tag != "GIFTI":
        raise Refusal("header", f"<{root.tag[:40]}>", "<GIFTI>")
    arrays = {
        intent: [a for a in root.iter("DataArray") if a.get("Intent") == intent]
        for intent in (POINTS, TRIANGLES)
    }
    if not arrays[POINTS] or not arrays[TRIANGLES]:
        raise Refusal("", "no points and triangles", "a surface of GIFTI: .surf.gii")
    parts = []
    for i, (x, t) in enumerate(zip(arrays[POINTS], arrays[TRIANGLES], strict=False)):
        name = Path(path).stem if i == 0 else f"{Path(path).stem} {i + 1}"
        parts.append(cut_out(name, take_array(x), take_array(t)))
    return Scene(parts, unit="mm", up="z")


def take_array(array: Element) -> np.ndarray:
    """(n, 3)"""
    intent = array.get("Intent", "")
    size = [array.get(f"Dim{i}", "") for i in (0, 1)]
    if not all(word.isdigit() for word in size) or size[1] != "3":
        raise Refusal(intent, f"{' x '.join(size)} numbers", "rows of 3")
    count = 3 * int(size[0])
    data = array.find("Data")
    text = "" if data is None else data.text or ""
    kind = KINDS.get(array.get("DataType", ""))
    if kind is None:
        raise Refusal(intent, f"numbers of {array.get('DataType')}", ", ".join(KINDS))
    values = decode(array, text, kind)
    if len(values) != count:
        raise Refusal(intent, f"{len(values)} numbers", f"{count}, as it says")
    order = "F" if array.get("ArrayIndexingOrder") == "ColumnMajorOrder" else "C"
    return values.reshape((-1, 3), order=order)


def decode(array: Element, text: str, kind: str) -> np.ndarray:
    encoding = array.get("Encoding", "").lower()
    intent = array.get("Intent", "")
    if encoding == "ascii":
        return TextValues(intent, text.encode()).values
    if encoding not in ("base64binary", "gzipbase64binary"):
        raise Refusal(intent, f"encoding {array.get('Encoding')}", "ASCII, Base64Binary or "
                      "GZipBase64Binary")  # fmt: skip
    try:
        content = base64.b64decode("".join(text.split()), validate=True)
    except binascii.Error as problem:
        raise Refusal(intent, f"no base64 ({problem})", "bytes as base64") from None
    if encoding.startswith("gzip"):
        content = inflate(content, intent)
    order = ">" if array.get("Endian") == "BigEndian" else "<"
    of = np.dtype(order + kind)
    if len(content) % of.itemsize:
        raise Refusal(intent, f"{len(content)} bytes", f"numbers of {of.itemsize}")
    return np.frombuffer(content, of)


# ---------------------------------------------------------------- FreeSurfer

SURFACE = b"\xff\xff\xfe"


def read_freesurfer(path: str) -> Scene:
    """Two lines of text, counts of points and triangles, then they, high bytes first; in
    millimetres, z up. Raises Refusal."""
    with open(path, "rb") as file:
        content = file.read()
    if not content.startswith(SURFACE):
        raise Refusal("header", content[:3].hex(" "), SURFACE.hex(" "))
    begin = content.find(b"\n\n", 3, 4096) + 2
    if begin < 2 or len(content) < begin + 8:
        raise Refusal("header", "no counts behind its two lines of text", "a FreeSurfer surface")
    vertices, triangles = struct.unpack_from(">2i", content, begin)
    wanted = 12 * (vertices + triangles)
    if vertices < 0 or triangles < 0 or len(content) - begin - 8 < wanted:
        got = f"{len(content) - begin - 8} bytes"
        raise Refusal("", got, f"{vertices} points and {triangles} triangles")
    x = np.frombuffer(content, ">f4", 3 * vertices, begin + 8).reshape(-1, 3)
    rows = np.frombuffer(content, ">i4", 3 * triangles, begin + 8 + 12 * vertices).reshape(-1, 3)
    return Scene([cut_out(Path(path).name, x, rows)], unit="mm", up="z")


# ---------------------------------------------------------------- mz3


def read_mz3(path: str) -> Scene:
    """A head of 16 bytes, then triangles, points, colours. Raises Refusal."""
    with open(path, "rb") as file:
        content = unpack(file.read())
    if len(content) < 16 or content[:2] != b"MZ":
        raise Refusal("header", content[:2].hex(" "), "4d 5a, which an mz3 begins with")
    has, faces, points, skipped = struct.unpack_from("<H3I", content, 2)
    if not has & 1 or not has & 2:
        raise Refusal("header", "no triangles and points", "a surface")
    begin = 16 + skipped
    if len(content) < begin + 12 * (faces + points):
        got = f"{len(content)} bytes"
        raise Refusal("", got, f"{points} points and {faces} triangles")
    rows = np.frombuffer(content, "<i4", 3 * faces, begin).reshape(-1, 3)
    x = np.frombuffer(content, "<f4", 3 * points, begin + 12 * faces).reshape(-1, 3)
    colours = None
    at = begin + 12 * (faces + points)
    if has & 4 and len(content) >= at + 4 * points:
        colours = np.frombuffer(content, "u1", 4 * points, at).reshape(-1, 4)[:, :3]
    part: Part = cut_out(Path(path).stem, x, rows, colours)
    return Scene([part], up="z")
