# SPDX-License-Identifier: BSD-3-Clause
"""PLY 1.0, as text and binary of either byte order: vertex and face, others are passed over."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from palpate.error import FileError
from palpate.mesh_files.rows import fan, quote, require_finite

TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2",
    "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8",
}  # fmt: skip
ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
CORNERS = ("vertex_indices", "vertex_index")


@dataclass
class Property:
    name: str
    type: str
    count_type: str = ""
    """Of a list, what its length is stored as; else empty."""


@dataclass
class Element:
    name: str
    count: int
    properties: list[Property] = field(default_factory=list)


@dataclass
class Body:
    """What follows the header, and how far it has been read."""

    file: str
    content: bytes
    order: str
    at: int
    line: int

    def refuse(self, where: str, found: str, expected: str) -> FileError:
        return FileError(self.file, where, found, expected)


def read_ply(file: str, content: bytes) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Vertices, shape (n, 3), and triangles, shape (t, 3). Raises FileError, naming the place."""
    elements, body = read_header(file, content)
    read = read_tokens if body.order == "" else read_binary
    tables = {element.name: read(body, element) for element in elements}
    for name, wanted in (("vertex", ("x", "y", "z")), ("face", CORNERS)):
        missing = name not in tables or not any(key in tables[name] for key in wanted)
        if missing or (name == "vertex" and not all(key in tables[name] for key in wanted)):
            found = ", ".join(
                f"{e.name} ({', '.join(p.name for p in e.properties)})" for e in elements
            )
            raise FileError(
                file,
                "header",
                found or "no elements",
                f"an element {name} with {', '.join(wanted)}",
            )
    axes = [np.asarray(tables["vertex"][axis], dtype=np.float64) for axis in "xyz"]
    vertices = np.column_stack(axes).reshape(-1, 3)
    require_finite(file, vertices, "vertex")
    faces = next(tables["face"][name] for name in CORNERS if name in tables["face"])
    return vertices, read_faces(file, faces, len(vertices))


def read_header(file: str, content: bytes) -> tuple[list[Element], Body]:
    elements: list[Element] = []
    order, at, number = None, 0, 0
    while True:
        end = content.find(b"\n", at)
        if end < 0:
            raise FileError(file, f"line {number + 1}", "the end of the file", "end_header")
        number += 1
        line = content[at:end].decode("ascii", errors="replace").strip()
        at = end + 1
        tokens = line.split()
        if number == 1 and line != "ply":
            raise FileError(file, "line 1", quote(line), "ply")
        if line == "end_header":
            break
        if tokens[:1] == ["format"] and len(tokens) == 3 and tokens[1] in ORDERS:
            order = ORDERS[tokens[1]]
        elif tokens[:1] == ["element"] and len(tokens) == 3 and tokens[2].isdecimal():
            elements.append(Element(tokens[1], int(tokens[2])))
        elif tokens[:1] == ["property"] and elements and (new := read_property(tokens)):
            elements[-1].properties.append(new)
        elif number > 1 and tokens[:1] not in (["comment"], ["obj_info"], []):
            expected = "format, element, property of a known type, comment or end_header"
            raise FileError(file, f"line {number}", quote(line), expected)
    if order is None:
        raise FileError(file, "header", "no format", "format " + ", ".join(ORDERS))
    return elements, Body(file, content, order, at, number)


def read_property(tokens: list[str]) -> Property | None:
    if len(tokens) == 3 and tokens[1] in TYPES:
        return Property(tokens[2], TYPES[tokens[1]])
    if len(tokens) == 5 and tokens[1] == "list" and tokens[2] in TYPES and tokens[3] in TYPES:
        count = TYPES[tokens[2]]
        return Property(tokens[4], TYPES[tokens[3]], count) if count[0] != "f" else None
    return None


def read_tokens(body: Body, element: Element) -> dict[str, list[Any]]:
    """One line for each row of an element."""
    columns: dict[str, list[Any]] = {each.name: [] for each in element.properties}
    for _ in range(element.count):
        end = body.content.find(b"\n", body.at)
        end = len(body.content) if end < 0 else end
        line = body.content[body.at : end].decode("ascii", errors="replace")
        where = f"line {body.line + 1}"
        if body.at >= len(body.content):
            raise body.refuse(where, "the end of the file", f"{element.count} of {element.name}")
        body.at, body.line = end + 1, body.line + 1
        tokens = iter(line.split())
        try:
            for each in element.properties:
                if each.count_type:
                    columns[each.name].append([int(next(tokens)) for _ in range(int(next(tokens)))])
                else:
                    columns[each.name].append(float(next(tokens)))
            done = next(tokens, None) is None
        except (ValueError, StopIteration, RuntimeError):
            done = False
        if not done:
            names = ", ".join(each.name for each in element.properties)
            raise body.refuse(where, quote(line), f"a row of {element.name}: {names}")
    return columns


def read_binary(body: Body, element: Element) -> dict[str, Any]:
    """Rows of one length are read at once, others one by one."""
    if element.count == 0:
        return {each.name: [] for each in element.properties}
    lengths = [peek_length(body, element, each) for each in element.properties]
    shaped = [
        (f"{k}", body.order + each.type, (length,))
        if each.count_type
        else (f"{k}", body.order + each.type)
        for k, (each, length) in enumerate(zip(element.properties, lengths, strict=True))
    ]
    return read_alike(body, element, shaped) or read_rows(body, element)


def peek_length(body: Body, element: Element, wanted: Property) -> int:
    """How many entries a list has in the first row; 0 for what is no list."""
    at = body.at
    for each in element.properties:
        if each.count_type:
            length = int(take(body, element, at, each.count_type, 1, 0)[0])
            if each is wanted:
                return length
            at += np.dtype(each.count_type).itemsize + max(length, 0) * np.dtype(each.type).itemsize
        else:
            at += np.dtype(each.type).itemsize
    return 0


def read_alike(body: Body, element: Element, shaped: list[tuple]) -> dict[str, Any] | None:
    """All rows at once where every list is as long as in the first row, else None."""
    fields: list[tuple] = []
    for each, column in zip(element.properties, shaped, strict=True):
        if each.count_type:
            if column[2][0] < 0:
                return None
            fields.append((f"n{column[0]}", body.order + each.count_type))
        fields.append(column)
    row = np.dtype(fields)
    size = element.count * row.itemsize
    if body.at + size > len(body.content):
        return None
    table = np.frombuffer(body.content, dtype=row, count=element.count, offset=body.at)
    for k, each in enumerate(element.properties):
        if each.count_type and not (table[f"n{k}"] == shaped[k][2][0]).all():
            return None
    body.at += size
    return {each.name: table[f"{k}"] for k, each in enumerate(element.properties)}


def read_rows(body: Body, element: Element) -> dict[str, list[Any]]:
    columns: dict[str, list[Any]] = {each.name: [] for each in element.properties}
    for row in range(element.count):
        for each in element.properties:
            length = 1
            if each.count_type:
                length = int(take(body, element, body.at, each.count_type, 1, row)[0])
                body.at += np.dtype(each.count_type).itemsize
            values = take(body, element, body.at, each.type, length, row)
            body.at += length * np.dtype(each.type).itemsize
            columns[each.name].append(values.tolist() if each.count_type else values[0])
    return columns


def take(body: Body, element: Element, at: int, kind: str, count: int, row: int) -> NDArray[Any]:
    dtype = np.dtype(body.order + kind)
    if count < 0 or at + count * dtype.itemsize > len(body.content):
        found = f"{count} entries" if count < 0 else "the end of the file"
        expected = f"{element.count} rows of {element.name}"
        raise body.refuse(f"{element.name} {row + 1}, byte {at}", found, expected)
    return np.frombuffer(body.content, dtype=dtype, count=count, offset=at)


def read_faces(file: str, faces: Any, vertex_count: int) -> NDArray[np.int64]:
    if isinstance(faces, np.ndarray) and faces.ndim == 2 and faces.shape[1] == 3:
        triangles, rows = faces.astype(np.int64), None
    else:
        fans = [fan([int(i) for i in corners]) for corners in faces]
        short = [row for row, each in enumerate(fans) if not each]
        if short:
            found = f"{len(faces[short[0]])} corners"
            raise FileError(file, f"face {short[0] + 1}", found, "three or more")
        rows = [row for row, each in enumerate(fans) for _ in each]
        triangles = np.array([t for each in fans for t in each], dtype=np.int64).reshape(-1, 3)
    wrong = np.flatnonzero(((triangles < 0) | (triangles >= vertex_count)).any(axis=1))
    if len(wrong) > 0:
        row = wrong[0] if rows is None else rows[wrong[0]]
        found = f"vertex {triangles[wrong[0]].tolist()}"
        raise FileError(file, f"face {row + 1}", found, f"0 to {vertex_count - 1}")
    return triangles
