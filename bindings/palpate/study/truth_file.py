# SPDX-License-Identifier: BSD-3-Clause
"""Truths as files: an archive of a manifest and the arrays it lists, checked against its hash."""

from __future__ import annotations

import hashlib
import io
import json
import math
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from palpate.files.json_part import is_number, is_whole
from palpate.files.read_file import read_file
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole
from palpate.study.reference import LAWS
from palpate.study.truth import Truth

FORMAT, VERSION = "palpate truth", 1
MANIFEST, ARRAYS = "manifest.json", "arrays.bin"
MOST_BYTES = 2**30
MOST_MANIFEST_BYTES = 2**20
PATHS = ("press", "pull", "drag", "script")
SHAPES = {
    "point": ("stations", 3),
    "direction": ("stations", 3),
    "touch": ("stations",),
    "thickness": ("stations",),
    "depth": ("depths",),
    "force": ("stations", "depths"),
    "force_error": ("stations", "depths"),
    "contact_radius": ("stations", "depths"),
    "surface": ("points", 3),
    "displacement": ("stations", "depths", "points", 3),
    "displacement_error": ("stations", "depths"),
}
"""Field -> its shape; the arrays follow each other so, float64, the least byte first."""
PARTS = {
    "key": "text",
    "law": "text",
    "path": "text",
    "radius": "a number above 0",
    "freedoms": "a whole number",
    "tetrahedra": "a whole number",
    "remarks": "a list of texts",
}


def write_truth(path: Path, truth: Truth) -> None:
    """Whole or not at all. Raises OSError."""
    sizes = {
        "stations": len(truth.point),
        "depths": len(truth.depth),
        "points": len(truth.surface),
    }
    data = b"".join(np.asarray(getattr(truth, name), "<f8").tobytes() for name in SHAPES)
    parts = {name: getattr(truth, name) for name in PARTS}
    manifest = {"format": FORMAT, "version": VERSION, "sizes": sizes, "parts": parts}
    manifest["sha256"] = compute_hash(sizes, parts, data)
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_STORED) as archive:
        for name, content in ((MANIFEST, json.dumps(manifest).encode()), (ARRAYS, data)):
            archive.writestr(zipfile.ZipInfo(name), content)
    write_whole(path, whole.getvalue())


def compute_hash(sizes: Any, parts: Any, data: bytes) -> str:
    told = json.dumps([VERSION, sizes, parts], sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(told.encode() + data).hexdigest()


def read_truth(path: Path) -> Truth:
    """Checked field by field and against its hash. Raises Refusal or OSError."""
    manifest, data = read_members(path, read_file(path, MOST_BYTES))
    if not isinstance(manifest, dict):
        raise Refusal(path, MANIFEST, type(manifest).__name__, "an object")
    if (manifest.get("format"), manifest.get("version")) != (FORMAT, VERSION):
        found = f"{manifest.get('format')!r}, version {manifest.get('version')!r}"
        raise Refusal(path, "format", found, f"{FORMAT!r}, version {VERSION}")
    sizes, parts = manifest.get("sizes"), manifest.get("parts")
    found, told = compute_hash(sizes, parts, data), manifest.get("sha256")
    if found != told:
        raise Refusal(path, "sha256", found[:12] + "...", f"{str(told)[:12]}...")
    check_sizes(path, sizes, data)
    check_parts(path, parts)
    arrays = unpack(sizes, data)
    for name, values in arrays.items():
        if not np.isfinite(values).all():
            raise Refusal(path, name, "numbers that are not finite", "finite ones")
    if (np.diff(np.abs(arrays["depth"]), prepend=0.0) <= 0.0).any():
        raise Refusal(path, "depth", "depths that do not rise", "ones rising away from 0")
    return Truth(**{**parts, "remarks": tuple(parts["remarks"])}, **arrays)


def read_members(path: Path, whole: bytes) -> tuple[Any, bytes]:
    """The manifest and the arrays' bytes. Raises Refusal."""
    expected = f"an archive of {MANIFEST} and {ARRAYS}"
    try:
        with zipfile.ZipFile(io.BytesIO(whole)) as archive:
            members = archive.infolist()
            if sorted(member.filename for member in members) != sorted((MANIFEST, ARRAYS)):
                raise Refusal(path, "", "other members", expected)
            # stored as they are, so nothing grows beyond the file in reading
            if any(member.compress_type != zipfile.ZIP_STORED for member in members):
                raise Refusal(path, "", "members that are compressed", "members that are not")
            if archive.getinfo(MANIFEST).file_size > MOST_MANIFEST_BYTES:
                raise Refusal(path, MANIFEST, "more than 1 MiB", "at most 1 MiB")
            return json.loads(archive.read(MANIFEST)), archive.read(ARRAYS)
    except Refusal:
        raise
    except Exception as problem:  # zipfile raises what it meets in a damaged archive
        raise Refusal(path, "", f"a damaged file ({problem})", expected) from None


def check_sizes(path: Path, sizes: Any, data: bytes) -> None:
    names = {name for shape in SHAPES.values() for name in shape if isinstance(name, str)}
    if not isinstance(sizes, dict) or set(sizes) != names:
        raise Refusal(path, "sizes", "other ones", "stations, depths and points")
    for name, size in sizes.items():
        if not is_whole(size) or size < 1:
            raise Refusal(path, f"sizes.{name}", str(size)[:40], "a whole number from 1")
    need = 8 * sum(math.prod(measure_shape(sizes, name)) for name in SHAPES)
    if need != len(data):
        raise Refusal(path, ARRAYS, f"{len(data)} bytes", f"{need} bytes")


def measure_shape(sizes: dict[str, int], name: str) -> tuple[int, ...]:
    return tuple(sizes[part] if isinstance(part, str) else part for part in SHAPES[name])


def check_parts(path: Path, parts: Any) -> None:
    if not isinstance(parts, dict) or set(parts) != set(PARTS):
        raise Refusal(path, "parts", "other ones", ", ".join(PARTS))
    tests = {
        "text": lambda value: isinstance(value, str),
        "a number above 0": lambda value: is_number(value) and value > 0,
        "a whole number": is_whole,
        "a list of texts": lambda value: (
            isinstance(value, list) and all(isinstance(text, str) for text in value)
        ),
    }
    for name, kind in PARTS.items():
        if not tests[kind](parts[name]):
            raise Refusal(path, f"parts.{name}", repr(parts[name])[:40], kind)
    for name, known in (("law", LAWS), ("path", PATHS)):
        if parts[name] not in known:
            raise Refusal(path, f"parts.{name}", repr(parts[name])[:40], ", ".join(known))


def unpack(sizes: dict[str, int], data: bytes) -> dict[str, np.ndarray]:
    arrays, at = {}, 0
    for name in SHAPES:
        shape = measure_shape(sizes, name)
        count = math.prod(shape)
        values = np.frombuffer(data, "<f8", count, at).reshape(shape).astype(np.float64)
        arrays[name], at = values, at + 8 * count
    return arrays
