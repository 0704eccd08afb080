# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball of cells in the files of VTK and Gmsh, in all the ways that other programs write them.

Each way makes the content of one file. All are the same surface, CORNERS of which lie on it.
"""

from __future__ import annotations

import struct
from collections.abc import Callable

import numpy as np
from foreign_files import numbers

Rows = list[tuple[int, np.ndarray]]
"""Type of cell, and corners (k, c)."""
SIDE = 4
"""Cells along each side of the cube that is blown up to a ball."""
TRIANGLES = 6 * SIDE * SIDE * 2


def make_ball() -> tuple[np.ndarray, np.ndarray]:
    """Points [mm] (n, 3) and hexahedra (c, 8) of an ellipsoid."""
    line = np.linspace(-1.0, 1.0, SIDE + 1)
    x = np.stack(np.meshgrid(line, line, line, indexing="ij"), -1).reshape(-1, 3)
    most, length = np.abs(x).max(axis=1), np.linalg.norm(x, axis=1)
    x = x * np.divide(most, length, out=np.zeros_like(most), where=length > 0.0)[:, None]
    ids = np.arange((SIDE + 1) ** 3).reshape([SIDE + 1] * 3)
    low, high = slice(None, -1), slice(1, None)
    places = [(low, low), (high, low), (high, high), (low, high)]
    corners = [ids[a, b, c].ravel() for c in (low, high) for a, b in places]
    return x * [30.0, 22.0, 18.0], np.stack(corners, axis=1)


X, BRICKS = make_ball()
WEDGES = np.concatenate([BRICKS[:, c] for c in ([0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7])])
PATHS = [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]]
TETRAHEDRA = np.concatenate([BRICKS[:, path] for path in PATHS])
HALF = len(TETRAHEDRA) // 2


def find_outside(cells: np.ndarray, faces: list[list[int]]) -> np.ndarray:
    every = np.concatenate([cells[:, face] for face in faces])
    _, which, times = np.unique(
        np.sort(every, axis=1), axis=0, return_inverse=True, return_counts=True
    )
    return every[times[which.ravel()] == 1]


SKIN = find_outside(TETRAHEDRA, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
SQUARES = find_outside(
    BRICKS,
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
)
OWN = X[TETRAHEDRA].reshape(-1, 3)
OWN_CELLS = np.arange(len(OWN)).reshape(-1, 4)


def add_middles(x: np.ndarray, cells: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Quadratic tetrahedra, in the order of VTK."""
    edges = np.sort(cells[:, [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]]], axis=2)
    every, which = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)
    middles = x[every].mean(axis=1)
    return np.vstack([x, middles]), np.hstack([cells, len(x) + which.reshape(-1, 6)])


CURVED, CURVED_CELLS = add_middles(X, TETRAHEDRA)


# ---------------------------------------------------------------- VTK


def vtk_head(kind: str, x: np.ndarray, version: str = "3.0", title: str = "made by a test") -> str:
    points = "\n".join(numbers(p) for p in x)
    head = f"# vtk DataFile Version {version}\n{title}\nASCII\nDATASET {kind}\n"
    return f"{head}POINTS {len(x)} float\n{points}\n"


def vtk_rows(word: str, rows: list) -> str:
    text = "\n".join(f"{len(row)} " + " ".join(map(str, row)) for row in rows)
    return f"{word} {len(rows)} {sum(len(row) + 1 for row in rows)}\n{text}\n"


def vtk_polygons(*more: str, rows: np.ndarray = SKIN, **head: str) -> str:
    return vtk_head("POLYDATA", X, **head) + vtk_rows("POLYGONS", rows.tolist()) + "".join(more)


def vtk_grid(*blocks: tuple[int, np.ndarray], x: np.ndarray = X, more: str = "") -> str:
    rows = [row for _, cells in blocks for row in cells.tolist()]
    types = [str(kind) for kind, cells in blocks for _ in cells]
    text = vtk_head("UNSTRUCTURED_GRID", x) + vtk_rows("CELLS", rows)
    return text + f"CELL_TYPES {len(types)}\n" + "\n".join(types) + "\n" + more


def vtk_strange(word: bytes) -> bytes:
    """With a point that is no number beside the others, as programs for Windows write it."""
    rows = SKIN.tolist()
    text = vtk_head("POLYDATA", np.vstack([X, [[7.25, 7.25, 7.25]]])) + vtk_rows("POLYGONS", rows)
    return text.encode().replace(b"7.25 7.25 7.25", word + b" 0 0")


def vtk_offsets() -> str:
    """As version 5.1 has polygons."""
    ends = " ".join(str(3 * i) for i in range(len(SKIN) + 1))
    corners = " ".join(map(str, SKIN.ravel()))
    return (
        vtk_head("POLYDATA", X, version="5.1")
        + f"\nMETADATA\nINFORMATION 0\n\nPOLYGONS {len(SKIN) + 1} {SKIN.size}\n"
        + f"OFFSETS vtktypeint64\n{ends}\nCONNECTIVITY vtktypeint64\n{corners}\n"
    )


VALUES = "SCALARS s float 1\nLOOKUP_TABLE default\n"
VTK: dict[str, Callable[[], str | bytes]] = {
    "polygons": vtk_polygons,
    "lines of Windows": lambda: vtk_polygons().replace("\n", "\r\n"),
    "version 1": lambda: vtk_polygons(version="1.0"),
    "version 5.1": vtk_offsets,
    "no title": lambda: vtk_polygons(title=""),
    "small letters": lambda: vtk_polygons().replace("POLYDATA", "polydata").replace(
        "POINTS", "points").replace("POLYGONS", "polygons"),
    "quadrilaterals, points and lines": lambda: vtk_polygons(
        vtk_rows("VERTICES", [[0], [1]]), vtk_rows("LINES", [[0, 1, 2]]), rows=SQUARES),
    "strips": lambda: vtk_head("POLYDATA", X) + vtk_rows("TRIANGLE_STRIPS", SKIN.tolist()),
    "values": lambda: vtk_polygons(
        f"POINT_DATA {len(X)}\n{VALUES}{numbers(X[:, 0])}\nNORMALS n float\n{numbers(X)}\n"),
    "too few values": lambda: vtk_polygons(f"POINT_DATA {len(X)}\n{VALUES}1 2 3\n"),
    "values of other points": lambda: vtk_polygons(f"POINT_DATA 3\n{VALUES}1 2 3\n"),
    "values of an unknown kind": lambda: vtk_polygons(f"POINT_DATA {len(X)}\nFORCES f float\n"),
    "an unknown end": lambda: vtk_polygons("SPRINGS 2\n1 2\n"),
    "no number": lambda: vtk_strange(b"-1.#IND"),
    "no number at all": lambda: vtk_strange(b"nan"),
    "tetrahedra": lambda: vtk_grid((10, TETRAHEDRA)),
    "tetrahedra with points of their own": lambda: vtk_grid((10, OWN_CELLS), x=OWN),
    "tetrahedra turned over": lambda: vtk_grid((10, TETRAHEDRA[:, [0, 2, 1, 3]])),
    "flat tetrahedra beside": lambda: vtk_grid((10, np.vstack([TETRAHEDRA, [[0, 0, 1, 2]]]))),
    "values of no points": lambda: vtk_grid((10, TETRAHEDRA), more="POINT_DATA\n"),
    "quadratic tetrahedra": lambda: vtk_grid((24, CURVED_CELLS), x=CURVED),
    "hexahedra": lambda: vtk_grid((12, BRICKS)),
    "voxels": lambda: vtk_grid((11, BRICKS[:, [0, 1, 3, 2, 4, 5, 7, 6]])),
    "wedges": lambda: vtk_grid((13, WEDGES)),
    "triangles": lambda: vtk_grid((5, SKIN)),
    "points, lines, triangles and tetrahedra": lambda: vtk_grid(
        (1, np.array([[0]])), (3, np.array([[0, 1]])), (5, SKIN), (10, TETRAHEDRA)),
}  # fmt: skip


# ---------------------------------------------------------------- Gmsh


def msh_rows(x: np.ndarray, *blocks: tuple[int, tuple[int, ...], np.ndarray],
             first: int = 1, step: int = 1) -> str:  # fmt: skip
    """Nodes and elements of version 2; numbers of nodes may begin anywhere and leave some out."""
    nodes = "\n".join(f"{first + step * i} {numbers(p)}" for i, p in enumerate(x))
    rows = [(kind, tags, row) for kind, tags, cells in blocks for row in cells.tolist()]
    elements = "\n".join(
        " ".join(map(str, (i, kind, len(tags), *tags, *(first + step * v for v in row))))
        for i, (kind, tags, row) in enumerate(rows, 1)
    )
    return (
        f"$Nodes\n{len(x)}\n{nodes}\n$EndNodes\n$Elements\n{len(rows)}\n{elements}\n$EndElements\n"
    )


def msh2(*blocks: tuple[int, tuple[int, ...], np.ndarray], x: np.ndarray = X, head: str = "",
         more: str = "", version: str = "2.2", **numbered: int) -> str:  # fmt: skip
    form = f"$MeshFormat\n{version} 0 8\n$EndMeshFormat\n"
    return head + form + msh_rows(x, *blocks, **numbered) + more


def msh2_binary(order: str, alone: bool = False) -> bytes:
    """Of either order of bytes; a head for each element, or for all of a type."""
    text = b"$MeshFormat\n2.2 1 8\n" + struct.pack(order + "i", 1) + b"\n$EndMeshFormat\n"
    text += b"$Nodes\n%d\n" % len(X)
    text += b"".join(struct.pack(order + "i3d", i, *p) for i, p in enumerate(X, 1))
    cells = [(2, SKIN), (4, TETRAHEDRA)]
    text += b"\n$EndNodes\n$Elements\n%d\n" % sum(len(rows) for _, rows in cells)
    for kind, rows in cells:
        head = struct.pack(order + "3i", kind, 1 if alone else len(rows), 2)
        text += b"" if alone else head
        for row in rows:
            words = struct.pack(f"{order}{3 + len(row)}i", 1, 7, 1, *(row + 1))
            text += head + words if alone else words
    return text + b"\n$EndElements\n"


def msh1(kind: int, cells: np.ndarray) -> str:
    """number type group entity nodes ..."""
    nodes = "\n".join(f"{i} {numbers(p)}" for i, p in enumerate(X, 1))
    rows = "\n".join(
        " ".join(map(str, (i, kind, 1, 1, len(row), *(row + 1)))) for i, row in enumerate(cells, 1)
    )
    return f"$NOD\n{len(X)}\n{nodes}\n$ENDNOD\n$ELM\n{len(cells)}\n{rows}\n$ENDELM\n"


BOX = "-30 -22 -18 30 22 18"


def msh4(version: str, entities: str = "", names: str = "", parametric: bool = False) -> str:
    """The skin on entity 1, and tetrahedra on two more."""
    is_new = version == "4.1"
    many = "0 0 1 2"
    text = f"$MeshFormat\n{version} 0 8\n$EndMeshFormat\n{names}"
    text += f"$Entities\n{many}\n{entities}$EndEntities\n" if entities else ""
    count, ids = len(X), range(1, len(X) + 1)
    head = f"1 {count} 1 {count}" if is_new else f"1 {count}"
    place = "2 1" if is_new else "1 2"
    text += f"$Nodes\n{head}\n{place} {int(parametric)} {count}\n"
    rows = [numbers(p) + (" 0.5 0.5" if parametric else "") for p in X]
    text += "\n".join(map(str, ids)) + "\n" + "\n".join(rows) if is_new else "\n".join(
        f"{i} {row}" for i, row in zip(ids, rows, strict=True))  # fmt: skip
    blocks = [(2, 1, 2, SKIN), (3, 1, 4, TETRAHEDRA[:HALF]), (3, 2, 4, TETRAHEDRA[HALF:])]
    total = sum(len(cells) for *_, cells in blocks)
    head = f"3 {total} 1 {total}" if is_new else f"3 {total}"
    text += f"\n$EndNodes\n$Elements\n{head}\n"
    for dimension, tag, kind, cells in blocks:
        place = f"{dimension} {tag}" if is_new else f"{tag} {dimension}"
        text += f"{place} {kind} {len(cells)}\n"
        text += "".join(f"1 {' '.join(map(str, row + 1))}\n" for row in cells)
    return text + "$EndElements\n"


def entities(*groups: str) -> str:
    """Of one face and two volumes, each with its groups, such as "1 5" for one that is 5."""
    skin, one, two = groups
    return f"1 {BOX} {skin} 0\n1 {BOX} {one} 1 1\n2 {BOX} {two} 1 1\n"


SOLID = (4, (1, 1), TETRAHEDRA)
NODE_DATA = '$NodeData\n1\n"pressure"\n1\n0.0\n3\n0\n1\n2\n1 1.0\n2 1.0\n$EndNodeData\n'
MSH: dict[str, Callable[[], str | bytes]] = {
    "version 1": lambda: msh1(4, TETRAHEDRA),
    "version 1, faces": lambda: msh1(2, SKIN),
    "version 2.0": lambda: msh2(SOLID, version="2"),
    "version 2.2": lambda: msh2(SOLID),
    "faces without groups": lambda: msh2((2, (), SKIN)),
    "faces on partitions": lambda: msh2((2, (1, 1, 2, 1, -2), SKIN)),
    "points, lines, faces and tetrahedra": lambda: msh2(
        (15, (0, 1), np.array([[0]])), (1, (0, 1), np.array([[0, 1]])), (2, (0, 1), SKIN), SOLID),
    "quadrilaterals": lambda: msh2((3, (1, 1), SQUARES)),
    "hexahedra": lambda: msh2((5, (1, 1), BRICKS)),
    "wedges": lambda: msh2((6, (1, 1), WEDGES)),
    "quadratic tetrahedra": lambda: msh2(
        (11, (1, 1), CURVED_CELLS[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]]), x=CURVED),
    "numbers with gaps": lambda: msh2(SOLID, first=11, step=3),
    "lines of Windows": lambda: msh2(SOLID).replace("\n", "\r\n"),
    "comments first": lambda: msh2(SOLID, head="$Comments\nby hand\n$EndComments\n"),
    "empty lines first": lambda: msh2(SOLID, head="\n\n"),
    "no end": lambda: msh2(SOLID).replace("$EndElements\n", ""),
    "values of some nodes": lambda: msh2(SOLID, more=NODE_DATA),
    "tetrahedra with points of their own": lambda: msh2((4, (1, 1), OWN_CELLS), x=OWN),
    "an element without its node": lambda: msh2(
        SOLID, (4, (1, 1), np.array([[0, 1, 2, 99999]]))),
    "binary": lambda: msh2_binary("<"),
    "binary, big end first": lambda: msh2_binary(">"),
    "binary, one by one": lambda: msh2_binary("<", alone=True),
    "version 4.0": lambda: msh4("4.0", entities("0", "1 1", "1 2")),
    "version 4.0 that says 4": lambda: msh4("4", entities("0", "1 1", "1 2")),
    "version 4.1": lambda: msh4("4.1", entities("1 5", "1 1", "1 2")),
    "version 4.1, some in groups": lambda: msh4("4.1", entities("0", "1 1", "0")),
    "version 4.1, no entities": lambda: msh4("4.1"),
    "version 4.1, parameters": lambda: msh4("4.1", parametric=True),
}  # fmt: skip
