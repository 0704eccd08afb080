# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes one surface in every format the importer reads, as other programs would.

Each writer takes vertices (n, 3) with z up and triangles (t, 3). Where a format states unit or axes
these are millimetres and its own axes, so reading must turn and scale them back.
"""

from __future__ import annotations

import json
import struct
from pathlib import Path

import numpy as np

# no side like another, so that every turn, mirror and mix-up of axes would show; millimetres
TETRAHEDRON = np.array([[0.0, 0, 0], [100, 0, 0], [0, 60, 0], [0, 0, 40]])
TETRAHEDRON_FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def numbers(values: np.ndarray, separator: str = " ") -> str:
    return separator.join(f"{value:.9g}" for value in np.ravel(values))


def write_obj(path: Path, v: np.ndarray, t: np.ndarray) -> None:
    lines = [f"v {numbers(x)}" for x in v] + [f"f {i} {j} {k}" for i, j, k in t + 1]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_off(path: Path, v: np.ndarray, t: np.ndarray) -> None:
    lines = ["OFF", f"{len(v)} {len(t)} 0"]
    lines += [numbers(x) for x in v] + [f"3 {i} {j} {k}" for i, j, k in t]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_stl(path: Path, v: np.ndarray, t: np.ndarray, trailing: int = 0) -> None:
    records = b"".join(
        struct.pack("<12fH", *np.zeros(3), *v[corners].astype(np.float32).ravel(), 0)
        for corners in t
    )
    path.write_bytes(b"made by a scanner".ljust(80) + struct.pack("<I", len(t)) + records
                     + b"\0" * trailing)  # fmt: skip


def write_text_stl(path: Path, v: np.ndarray, t: np.ndarray) -> None:
    lines = ["solid organ"]
    for corners in t:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += [f"vertex {numbers(v[c])}" for c in corners]
        lines += ["endloop", "endfacet"]
    path.write_text("\n".join([*lines, "endsolid organ", ""]), encoding="utf-8")


def write_ply(path: Path, v: np.ndarray, t: np.ndarray) -> None:
    head = ["ply", "format ascii 1.0", f"element vertex {len(v)}"]
    head += [f"property float {axis}" for axis in "xyz"]
    head += [f"element face {len(t)}", "property list uchar int vertex_indices", "end_header"]
    lines = head + [numbers(x) for x in v] + [f"3 {i} {j} {k}" for i, j, k in t]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def to_y_up(v: np.ndarray) -> np.ndarray:
    return np.stack([v[:, 0], v[:, 2], -v[:, 1]], axis=1)


def write_glb(
    path: Path, v: np.ndarray, t: np.ndarray, matrix: np.ndarray | None = None, scale: float = 1e-3
) -> None:
    """glTF is in metres, y up; `matrix` is the node's, for points as columns."""
    points = (scale * to_y_up(v)).astype("<f4")
    indices = t.astype("<u4")
    binary = points.tobytes() + indices.tobytes()
    node: dict = {"mesh": 0, "name": "organ"}
    if matrix is not None:
        node["matrix"] = matrix.T.ravel().tolist()
    content = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [node],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(binary)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": points.nbytes},
            {"buffer": 0, "byteOffset": points.nbytes, "byteLength": indices.nbytes},
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": len(v),
                "type": "VEC3",
                "min": points.min(axis=0).tolist(),
                "max": points.max(axis=0).tolist(),
            },
            {"bufferView": 1, "componentType": 5125, "count": indices.size, "type": "SCALAR"},
        ],
    }
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(binary), b"BIN\0") + binary
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


def write_3ds(path: Path, v: np.ndarray, t: np.ndarray) -> None:
    def chunk(kind: int, body: bytes) -> bytes:
        return struct.pack("<HI", kind, 6 + len(body)) + body

    points = struct.pack("<H", len(v)) + v.astype("<f4").tobytes()
    faces = struct.pack("<H", len(t)) + b"".join(struct.pack("<4H", *c, 7) for c in t)
    mesh = chunk(0x4100, chunk(0x4110, points) + chunk(0x4120, faces))
    path.write_bytes(chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, b"organ\0" + mesh))))


def write_dae(path: Path, v: np.ndarray, t: np.ndarray) -> None:
    path.write_text(
        f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="organ"><mesh>
<source id="p"><float_array id="a" count="{v.size}">{numbers(v)}</float_array>
<technique_common><accessor source="#a" count="{len(v)}" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="{len(t)}"><input semantic="VERTEX" source="#v" offset="0"/>
<p>{" ".join(map(str, t.ravel()))}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="organ">
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
""",
        encoding="utf-8",
    )


def write_fbx(path: Path, v: np.ndarray, t: np.ndarray) -> None:
    closed = t.copy()
    closed[:, 2] = -closed[:, 2] - 1
    path.write_text(
        f"""; FBX 7.4.0 project file
FBXHeaderExtension:  {{
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}}
GlobalSettings:  {{
	Version: 1000
	Properties70:  {{
		P: "UpAxis", "int", "Integer", "",2
		P: "UpAxisSign", "int", "Integer", "",1
		P: "FrontAxis", "int", "Integer", "",1
		P: "FrontAxisSign", "int", "Integer", "",-1
		P: "CoordAxis", "int", "Integer", "",0
		P: "CoordAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",0.1
	}}
}}
Definitions:  {{
	Version: 100
	Count: 2
}}
Objects:  {{
	Geometry: 10, "Geometry::", "Mesh" {{
		Vertices: *{v.size} {{
			a: {numbers(v, ",")}
		}}
		PolygonVertexIndex: *{t.size} {{
			a: {",".join(map(str, closed.ravel()))}
		}}
		GeometryVersion: 124
	}}
	Model: 20, "Model::organ", "Mesh" {{
		Version: 232
	}}
}}
Connections:  {{
	C: "OO",20,0
	C: "OO",10,20
}}
""",
        encoding="utf-8",
    )


def write_vtk(path: Path, v: np.ndarray, t: np.ndarray, binary: bool = True) -> None:
    """Legacy VTK polygons: big-endian where binary."""
    words = "BINARY" if binary else "ASCII"
    cells = np.column_stack([np.full(len(t), 3), t])
    head = f"# vtk DataFile Version 3.0\nmade by a test\n{words}\nDATASET POLYDATA\n"
    with path.open("wb") as file:
        file.write(f"{head}POINTS {len(v)} double\n".encode())
        file.write(v.astype(">f8").tobytes() if binary else numbers(v).encode())
        file.write(f"\nPOLYGONS {len(t)} {cells.size}\n".encode())
        file.write(cells.astype(">i4").tobytes() if binary else numbers(cells).encode())
        file.write(b"\n")


def write_xml(path: Path, v: np.ndarray, kind: str, counts: str, cells: str) -> None:
    path.write_text(
        f"""<?xml version="1.0"?>
<VTKFile type="{kind}" version="0.1" byte_order="LittleEndian"><{kind}>
<Piece NumberOfPoints="{len(v)}" {counts}>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{numbers(v)}</DataArray>
</Points>{cells}</Piece></{kind}></VTKFile>
""",
        encoding="utf-8",
    )


def data_array(name: str, kind: str, values: np.ndarray) -> str:
    return f'<DataArray type="{kind}" Name="{name}" format="ascii">{numbers(values)}</DataArray>'


def write_vtp(path: Path, v: np.ndarray, t: np.ndarray) -> None:
    ends = 3 * np.arange(1, len(t) + 1)
    arrays = data_array("connectivity", "Int64", t) + data_array("offsets", "Int64", ends)
    counts = f'NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{len(t)}"'
    write_xml(path, v, "PolyData", counts, f"<Polys>{arrays}</Polys>")


def write_vtu(path: Path, v: np.ndarray, cells: np.ndarray) -> None:
    """Triangles or, of four corners each, tetrahedra."""
    size = cells.shape[1]
    arrays = data_array("connectivity", "Int64", cells)
    arrays += data_array("offsets", "Int64", size * np.arange(1, len(cells) + 1))
    arrays += data_array("types", "UInt8", np.full(len(cells), 5 if size == 3 else 10))
    counts = f'NumberOfCells="{len(cells)}"'
    write_xml(path, v, "UnstructuredGrid", counts, f"<Cells>{arrays}</Cells>")


def write_msh(path: Path, v: np.ndarray, cells: np.ndarray, binary: bool = False) -> None:
    """Gmsh 2.2: triangles or, of four corners each, tetrahedra, all in the group "organ"."""
    kind, dimension = (2, 2) if cells.shape[1] == 3 else (4, 3)
    with path.open("wb") as file:
        file.write(f"$MeshFormat\n2.2 {int(binary)} 8\n".encode())
        file.write(struct.pack("<i", 1) + b"\n" if binary else b"")
        file.write(b"$EndMeshFormat\n$PhysicalNames\n1\n")
        file.write(f'{dimension} 7 "organ"\n$EndPhysicalNames\n'.encode())
        file.write(f"$Nodes\n{len(v)}\n".encode())
        for i, x in enumerate(v, 1):
            file.write(struct.pack("<i3d", i, *x) if binary else f"{i} {numbers(x)}\n".encode())
        file.write(f"\n$EndNodes\n$Elements\n{len(cells)}\n".encode())
        file.write(struct.pack("<3i", kind, len(cells), 2) if binary else b"")
        for i, corners in enumerate(cells + 1, 1):
            words = (i, 7, 1, *corners) if binary else (i, kind, 2, 7, 1, *corners)
            file.write(
                struct.pack(f"<{len(words)}i", *words)
                if binary
                else (" ".join(map(str, words)) + "\n").encode()
            )
        file.write(b"\n$EndElements\n")


def write_msh4(path: Path, v: np.ndarray, cells: np.ndarray, binary: bool = False) -> None:
    """Gmsh 4.1: one entity, which is the group "organ"."""
    kind, dimension = (2, 2) if cells.shape[1] == 3 else (4, 3)
    counts = [1 if d == dimension else 0 for d in range(4)]
    box = [*v.min(axis=0), *v.max(axis=0)]

    def pack(form: str, *values: float) -> bytes:
        text = " ".join(f"{value:.17g}" for value in values) + "\n"
        return struct.pack("<" + form, *values) if binary else text.encode()

    with path.open("wb") as file:
        file.write(f"$MeshFormat\n4.1 {int(binary)} 8\n".encode())
        file.write(struct.pack("<i", 1) + b"\n" if binary else b"")
        file.write(b"$EndMeshFormat\n$PhysicalNames\n1\n")
        file.write(f'{dimension} 7 "organ"\n$EndPhysicalNames\n$Entities\n'.encode())
        file.write(pack("4Q", *counts) + pack("i6dQiQ", 1, *box, 1, 7, 0))
        file.write(b"\n$EndEntities\n$Nodes\n")
        file.write(pack("4Q", 1, len(v), 1, len(v)) + pack("3iQ", dimension, 1, 0, len(v)))
        for i in range(1, len(v) + 1):
            file.write(pack("Q", i))
        for x in v:
            file.write(pack("3d", *x))
        file.write(b"\n$EndNodes\n$Elements\n")
        file.write(pack("4Q", 1, len(cells), 1, len(cells)))
        file.write(pack("3iQ", dimension, 1, kind, len(cells)))
        for i, corners in enumerate(cells + 1, 1):
            file.write(pack(f"{1 + len(corners)}Q", i, *corners))
        file.write(b"\n$EndElements\n")


WRITERS = {
    "obj": write_obj,
    "off": write_off,
    "stl": write_stl,
    "ply": write_ply,
    "glb": write_glb,
    "3ds": write_3ds,
    "dae": write_dae,
    "fbx": write_fbx,
}
"""Extension -> writer."""

LIBRARY_WRITERS = {"vtk": write_vtk, "vtp": write_vtp, "vtu": write_vtu, "msh": write_msh}
"""The same for the formats that VTK and meshio read."""
