# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of a glTF file: its JSON, its buffers, its accessors [Khronos glTF 2.0]."""

from __future__ import annotations

import base64
import binascii
import json
import struct
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from palpate_editor.formats_child.scene import Refusal

GLB_MAGIC, JSON_CHUNK, BIN_CHUNK = b"glTF", 0x4E4F534A, 0x004E4942
KINDS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
MOST_BYTES = 600_000_000
"""Of one accessor, whose count a damaged file may say as it likes."""


class GltfFile:
    """What a .gltf or a .glb holds. Raises Refusal, as do its functions."""

    def __init__(self, path: str):
        self.folder = Path(path).resolve().parent
        content = Path(path).read_bytes()
        self._binary = b""
        text = self._split(content) if content[:4] == GLB_MAGIC else content
        try:
            found = json.loads(text)
        except (ValueError, RecursionError) as problem:
            raise Refusal("", f"no JSON ({str(problem)[:80]})", "a glTF") from None
        if not isinstance(found, dict):
            raise Refusal("", f"a {type(found).__name__}", "a glTF's object")
        self.content: dict[str, Any] = found
        self._buffers: dict[int, bytes] = {}

    def _split(self, content: bytes) -> bytes:
        """The JSON of a .glb, whose binary chunk is kept."""
        text, at = b"", 12
        while at + 8 <= len(content):
            size, kind = struct.unpack_from("<2I", content, at)
            body = content[at + 8 : at + 8 + size]
            if len(body) < size:
                raise Refusal(f"byte {at}", f"a chunk of {size} bytes", f"at most {len(body)}")
            if kind == JSON_CHUNK and not text:
                text = body
            elif kind == BIN_CHUNK and not self._binary:
                self._binary = body
            at += 8 + size
        return text

    def rows(self, name: str) -> list[dict[str, Any]]:
        """One of its lists; empty where there is none."""
        found = self.content.get(name, [])
        if not isinstance(found, list) or not all(isinstance(row, dict) for row in found):
            raise Refusal(name, "something else", "a list of objects")
        return found

    def row(self, name: str, index: object) -> dict[str, Any]:
        rows = self.rows(name)
        if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(rows):
            raise Refusal(name, f"number {index}", f"one of {len(rows)}")
        return rows[index]

    # ------------------------------------------------------------ bytes

    def read_view(self, index: object) -> tuple[bytes, int]:
        """The bytes of a bufferView, and its stride; 0 for none."""
        view = self.row("bufferViews", index)
        buffer = self._read_buffer(view.get("buffer"))
        start, size = int(view.get("byteOffset", 0)), int(view.get("byteLength", 0))
        if start < 0 or size < 0 or start + size > len(buffer):
            got = f"bytes {start} to {start + size}"
            raise Refusal(f"bufferView {index}", got, f"a buffer's {len(buffer)}")
        return buffer[start : start + size], int(view.get("byteStride", 0))

    def _read_buffer(self, index: object) -> bytes:
        buffer = self.row("buffers", index)
        assert isinstance(index, int)
        if index not in self._buffers:
            uri = buffer.get("uri")
            self._buffers[index] = self._binary if uri is None else self.read_uri(str(uri))
        return self._buffers[index]

    def read_uri(self, uri: str) -> bytes:
        """What lies beside the file, or is written in it."""
        if uri.startswith("data:"):
            try:
                return base64.b64decode(uri.partition(",")[2], validate=True)
            except (binascii.Error, ValueError):
                raise Refusal("uri", "no base64", "data") from None
        path = (self.folder / unquote(uri)).resolve()
        if not path.is_relative_to(self.folder):
            raise Refusal("uri", unquote(uri)[:200], "a file beside it")
        try:
            return path.read_bytes()
        except OSError as problem:
            raise Refusal("uri", f"{unquote(uri)[:200]}: {problem.strerror}", "a file") from None

    # ------------------------------------------------------------ numbers

    def read_accessor(self, index: object) -> np.ndarray:
        """(n, width) As it is stored; of integers that stand for parts of 1, those parts."""
        accessor = self.row("accessors", index)
        kind, width = (
            KINDS.get(accessor.get("componentType", 0)),
            WIDTHS.get(accessor.get("type", "")),
        )
        where, count = f"accessor {index}", accessor.get("count")
        if kind is None or width is None or not isinstance(count, int) or count < 0:
            raise Refusal(where, "another kind of numbers", "vectors of plain numbers")
        size = np.dtype(kind).itemsize * width
        if count * size > MOST_BYTES:
            raise Refusal(where, f"{count} rows", f"at most {MOST_BYTES // 1_000_000} MB")
        start = int(accessor.get("byteOffset", 0))
        if "bufferView" in accessor:
            values = self._take(accessor["bufferView"], start, where, kind, width, count)
        else:
            values = np.zeros((count, width), kind)
        if isinstance(accessor.get("sparse"), dict):
            values = self._put(values, accessor["sparse"], where)
        return spread(values) if accessor.get("normalized") else values

    def _take(
        self, view: object, start: int, where: str, kind: str, width: int, count: int
    ) -> np.ndarray:
        content, stride = self.read_view(view)
        size = np.dtype(kind).itemsize * width
        stride = stride or size
        end = start + stride * (count - 1) + size if count else start
        if start < 0 or stride < size or end > len(content):
            raise Refusal(where, f"{end} bytes", f"a bufferView's {len(content)}")
        return np.ndarray((count, width), kind, content, start, (stride, np.dtype(kind).itemsize))

    def _put(self, values: np.ndarray, sparse: dict[str, Any], where: str) -> np.ndarray:
        """With the rows that are told one by one."""
        count, at, new = sparse.get("count"), sparse.get("indices"), sparse.get("values")
        if not isinstance(count, int) or not isinstance(at, dict) or not isinstance(new, dict):
            raise Refusal(where, "a sparse accessor without its rows", "indices and values")
        kind = KINDS.get(at.get("componentType", 0), "<u4")
        rows = self._take(
            at.get("bufferView"), int(at.get("byteOffset", 0)), where, kind, 1, count
        ).ravel()
        if len(rows) and int(rows.max()) >= len(values):
            raise Refusal(where, f"row {rows.max()}", f"one of {len(values)}")
        told = self._take(new.get("bufferView"), int(new.get("byteOffset", 0)), where,
                          values.dtype.str, values.shape[1], count)  # fmt: skip
        values = values.copy()
        values[rows] = told
        return values


def spread(values: np.ndarray) -> np.ndarray:
    """Integers as parts of 1: 0 to 1 without sign, -1 to 1 with."""
    if values.dtype.kind == "f":
        return values
    return np.maximum(values / np.iinfo(values.dtype).max, -1.0)
