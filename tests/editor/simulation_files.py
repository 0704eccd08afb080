# SPDX-License-Identifier: GPL-3.0-or-later
"""The ball of cell_files in the files of simulations, brains and old scenes, as other programs
write them: FILES has the content of each, and of what lies beside it."""

from __future__ import annotations

import base64
import gzip
import struct
import zlib
from collections.abc import Callable

import numpy as np
from cell_files import BRICKS, SKIN, SQUARES, TETRAHEDRA, WEDGES, X
from foreign_files import numbers

Files = dict[str, str | bytes]
"""Name -> content; the first is the one that is opened."""


def rows(values: np.ndarray, separator: str = " ", lead: str = "", tail: str = "") -> str:
    return "".join(f"{lead}{separator.join(map(str, row))}{tail}\n" for row in values.tolist())


def number(values: np.ndarray, first: int = 1) -> np.ndarray:
    """With a number before each row."""
    return np.column_stack([np.arange(first, first + len(values)), values])


def points(x: np.ndarray, separator: str = " ", numbered: bool = True, tail: str = "") -> str:
    lines = []
    for i, p in enumerate(x, 1):
        lead = f"{i}{separator}" if numbered else ""
        lines.append(f"{lead}{numbers(p, separator)}{tail}")
    return "\n".join(lines) + "\n"


# ---------------------------------------------------------------- Medit, Netgen, TetGen

MEDIT_KINDS = {"Triangles": SKIN, "Quadrilaterals": SQUARES, "Tetrahedra": TETRAHEDRA,
               "Prisms": WEDGES, "Hexahedra": BRICKS}  # fmt: skip


def medit(*kinds: str) -> str:
    text = f"MeshVersionFormatted 2\n# by hand\nDimension\n3\n\nVertices\n{len(X)}\n"
    text += points(X, numbered=False, tail=" 0") + "Corners\n1\n1\n"
    for kind in kinds:
        text += f"{kind}\n{len(MEDIT_KINDS[kind])}\n" + rows(MEDIT_KINDS[kind] + 1, tail=" 7")
    return text + "End\n"


def medit_binary(version: int, order: str = "<") -> bytes:
    place = "q" if version >= 3 else "i"
    whole = "q" if version >= 4 else "i"
    real = "f4" if version == 1 else "f8"
    out = struct.pack(order + "ii", 1, version)

    def add(code: int, body: bytes) -> None:
        nonlocal out
        behind = len(out) + 4 + struct.calcsize(place) + len(body)
        out += struct.pack(f"{order}i{place}", code, behind) + body

    def table(values: np.ndarray, kind: str) -> bytes:
        record = np.dtype(
            [("of", order + kind, values.shape[1:]), ("g", order + f"i{4 + 4 * (version >= 4)}")]
        )
        found = np.zeros(len(values), record)
        found["of"], found["g"] = values, 3
        return struct.pack(order + whole, len(values)) + found.tobytes()

    add(3, struct.pack(order + "i", 3))
    add(4, table(X, real))
    add(99, b"something else ")
    add(8, table(TETRAHEDRA + 1, "i8" if version >= 4 else "i4"))
    return out + struct.pack(f"{order}i{place}", 54, 0)


def netgen() -> str:
    skin = np.column_stack([np.tile([1, 1, 1, 0, 3], (len(SKIN), 1)), SKIN + 1])
    solid = np.column_stack([np.tile([1, 4], (len(TETRAHEDRA), 1)), TETRAHEDRA + 1])
    return (
        "# by Netgen\nmesh3d\ndimension\n3\ngeomtype\n0\n\n# surfnr bcnr domin domout np p1 p2 p3\n"
        f"surfaceelements\n{len(SKIN)}\n{rows(skin)}\n#  matnr np p1 p2 p3 p4\n"
        f"volumeelements\n{len(solid)}\n{rows(solid)}\npoints\n{len(X)}\n"
        f"{points(X, numbered=False)}\nmaterials\n1\n1 liver\nendmesh\n"
    )


def netgen_neutral() -> str:
    solid = np.column_stack([np.ones(len(TETRAHEDRA), int), TETRAHEDRA + 1])
    skin = np.column_stack([np.ones(len(SKIN), int), SKIN + 1])
    body = f"{len(solid)}\n{rows(solid)}{len(skin)}\n{rows(skin)}"
    return f"{len(X)}\n{points(X, numbered=False)}{body}"


def tetgen(first: int) -> Files:
    node = f"# by TetGen\n{len(X)} 3 0 1\n" + "".join(
        f"  {i + first}  {numbers(p)}  1\n" for i, p in enumerate(X)
    )
    cells = number(np.column_stack([TETRAHEDRA + first, np.full(len(TETRAHEDRA), 2)]), first)
    return {"ball.ele": f"{len(cells)} 4 1\n{rows(cells)}# end\n", "ball.node": node}


def tetgen_faces() -> Files:
    skin = number(np.column_stack([SKIN + 1, np.full(len(SKIN), -1)]))
    return {
        "ball.node": f"{len(X)} 3 0 0\n{points(X)}",
        "ball.face": f"{len(skin)} 1\n{rows(skin)}",
    }


def smesh() -> str:
    facets = np.column_stack([np.full(len(SQUARES), 4), SQUARES + 1])
    return f"{len(X)} 3 0 0\n{points(X)}{len(facets)} 0\n{rows(facets)}0\n0\n"


def poly() -> str:
    facets = "".join(f"1 0 1\n3 {a} {b} {c}\n" for a, b, c in (SKIN + 1).tolist())
    return f"{len(X)} 3 0 0\n{points(X)}{len(SKIN)} 1\n{facets}0\n0\n"


def vega(apart: bool) -> Files:
    vertices = f"{len(X)} 3 0 0\n{points(X)}"
    cells = f"{len(TETRAHEDRA)} 4 0\n{rows(number(TETRAHEDRA + 1))}"
    if apart:
        text = "# Vega mesh\n*VERTICES\n*INCLUDE ball.node\n\n*ELEMENTS\nTET\n*INCLUDE ball.ele\n"
        return {"ball.veg": text, "ball.node": vertices, "ball.ele": cells}
    material = "*MATERIAL BODY\nENU, 1000, 10000000, 0.45\n*REGION\nallElements, BODY\n"
    return {"ball.veg": f"*VERTICES\n{vertices}\n*ELEMENTS\nTET\n{cells}\n{material}"}


def carp() -> Files:
    cells = rows(np.column_stack([TETRAHEDRA, np.ones(len(TETRAHEDRA), int)]), lead="Tt ")
    return {"ball.elem": f"{len(TETRAHEDRA)}\n{cells}",
            "ball.pts": f"{len(X)}\n{points(1e3 * X, numbered=False)}"}  # fmt: skip


# ---------------------------------------------------------------- solvers


def abaqus() -> str:
    nodes = points(X, ", ")
    return (
        "*HEADING\nby hand\n** a remark\n*NODE, NSET=ALL\n" + nodes
        + "*Element, type=C3D4, elset=LIVER\n" + rows(number(TETRAHEDRA + 1), ", ")
        + "*ELEMENT, TYPE=T3D2, ELSET=STRING\n9000, 1, 2\n*STEP\n*END STEP\n"
    )  # fmt: skip


def abaqus_parts() -> str:
    """A part that is put in once, turned by 90 degrees about z through (10, 0, 0) once moved; its
    elements of twenty nodes go on in a second line."""
    cells = number(BRICKS + 1)
    lines = "".join(
        ", ".join(map(str, [*row, *row[1:5]]))
        + ",\n"
        + ", ".join(map(str, [*row[1:8], row[1]]))
        + "\n"
        for row in cells.tolist()
    )
    return (
        "*Part, name=Ball\n*Node\n" + points(X, ", ") + "*Element, type=C3D20R\n" + lines
        + "*End Part\n*Assembly, name=A\n*Instance, name=Ball-1, part=Ball\n5., 0., 0.\n"
        + "10., 0., 0., 10., 0., 1., 90.\n*End Instance\n*End Assembly\n"
    )  # fmt: skip


def nastran_small() -> str:
    text = "SOL 101\nCEND\nBEGIN BULK\n$ a remark\n"
    for i, p in enumerate(X, 1):
        text += "GRID    " + f"{i:<8d}" + " " * 8 + "".join(f"{v:<8.4f}" for v in p) + "\n"
    for i, c in enumerate((BRICKS + 1).tolist(), 1):
        words = [f"{w:<8d}" for w in (i, 2, *c)]
        text += "CHEXA   " + "".join(words[:8]) + f"+{i:<7d}\n+{i:<7d}" + "".join(words[8:]) + "\n"
    return text + "ENDDATA\n"


def nastran_large() -> str:
    text = "BEGIN BULK\n"
    for i, p in enumerate(X, 1):
        a, b, c = (write_exponent(v) for v in p)
        text += f"GRID*   {i:<16d}{'':16s}{a:<16s}{b:<16s}*\n*       {c:<16s}\n"
    for i, c in enumerate((SKIN + 1).tolist(), 1):
        text += f"CTRIA3  {i:<8d}{1:<8d}" + "".join(f"{w:<8d}" for w in c) + "\n"
    return text + "ENDDATA\n"


def write_exponent(value: float) -> str:
    """As Nastran does, without an e: 1.5-3."""
    mantissa, exponent = f"{value:.8e}".split("e")
    return f"{mantissa}{int(exponent):+d}"


def nastran_free() -> str:
    text = "BEGIN BULK\n" + "".join(f"GRID,{i},,{numbers(p, ',')}\n" for i, p in enumerate(X, 1))
    for i, c in enumerate((TETRAHEDRA + 1).tolist(), 1):
        text += f"CTETRA,{i},1,{','.join(map(str, c))}\n"
    return text + "ENDDATA\n"


def universal() -> str:
    text = "    -1\n   164\n  1  SI\n    -1\n    -1\n  2411\n"
    for i, p in enumerate(X, 1):
        text += f"{i:10d}{1:10d}{1:10d}{11:10d}\n"
        text += "".join(f"{v:25.16E}" for v in p).replace("E", "D") + "\n"
    text += "    -1\n    -1\n  2412\n" + f"{1:10d}{11:10d}{1:10d}{1:10d}{7:10d}{2:10d}\n"
    text += "         0         0         0\n         1         2\n"
    for i, c in enumerate((TETRAHEDRA + 1).tolist(), 2):
        text += f"{i:10d}{111:10d}{1:10d}{1:10d}{7:10d}{4:10d}\n"
        text += "".join(f"{w:10d}" for w in c) + "\n"
    return text + "    -1\n"


def febio(version: str) -> str:
    nodes = "".join(f'<node id="{i}">{numbers(p, ",")}</node>\n' for i, p in enumerate(X, 1))
    branch = "Mesh" if version >= "3" else "Geometry"
    word, type_ = ("hex8", "") if version == "1.2" else ("elem", ' type="hex8" name="Liver"')
    cells = "".join(
        f'<{word} id="{i}" mat="1">{",".join(map(str, c))}</{word}>\n'
        for i, c in enumerate((BRICKS + 1).tolist(), 1)
    )
    return (
        f'<?xml version="1.0" encoding="ISO-8859-1"?>\n<febio_spec version="{version}">\n'
        f"<{branch}><Nodes>\n{nodes}</Nodes>\n<Elements{type_}>\n{cells}</Elements>\n"
        f'<Surface name="Load"><quad4 id="1">1,2,3,4</quad4></Surface></{branch}>\n</febio_spec>\n'
    )


def dyna() -> str:
    text = "$ by hand\n*KEYWORD\n*PART\nLiver\n         7         1         1\n*NODE\n"
    for i, p in enumerate(X, 1):
        text += f"{i:8d}" + "".join(f"{v:16.9g}" for v in p) + "       0       0\n"
    text += "*ELEMENT_SOLID\n"
    for i, (a, b, c, d) in enumerate((TETRAHEDRA + 1).tolist(), 1):
        text += "".join(f"{w:8d}" for w in (i, 7, a, b, c, d, d, d, d, d)) + "\n"
    return text + "*END\n"


def dyna_shells() -> str:
    text = "*KEYWORD\n*NODE\n" + points(X, ", ") + "*ELEMENT_SHELL\n"
    for i, (a, b, c) in enumerate((SKIN + 1).tolist(), 1):
        text += f"{i},1,{a},{b},{c},{c}\n"
    return text + "*END\n"


# ---------------------------------------------------------------- brains


def gifti(encoding: str) -> str:
    def data(values: np.ndarray) -> str:
        if encoding == "ASCII":
            return numbers(values)
        raw = values.tobytes()
        raw = zlib.compress(raw) if encoding.startswith("GZip") else raw
        return base64.b64encode(raw).decode()

    arrays = ""
    for intent, kind, values in (("POINTSET", "FLOAT32", X.astype("<f4")),
                                 ("TRIANGLE", "INT32", SKIN.astype("<i4"))):  # fmt: skip
        arrays += (
            f'<DataArray Intent="NIFTI_INTENT_{intent}" DataType="NIFTI_TYPE_{kind}" '
            f'ArrayIndexingOrder="RowMajorOrder" Dimensionality="2" Dim0="{len(values)}" Dim1="3" '
            f'Encoding="{encoding}" Endian="LittleEndian"><Data>{data(values)}</Data></DataArray>\n'
        )
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<!DOCTYPE GIFTI SYSTEM "gifti.dtd">\n'
        f'<GIFTI Version="1.0" NumberOfDataArrays="2">\n{arrays}</GIFTI>\n'
    )


def freesurfer() -> bytes:
    head = b"\xff\xff\xfecreated by nobody on a day\n\n" + struct.pack(">2i", len(X), len(SKIN))
    return head + X.astype(">f4").tobytes() + SKIN.astype(">i4").tobytes()


def mz3(packed: bool) -> bytes:
    raw = struct.pack("<2sH3I", b"MZ", 3, len(SKIN), len(X), 0)
    raw += SKIN.astype("<i4").tobytes() + X.astype("<f4").tobytes()
    return gzip.compress(raw) if packed else raw


# ---------------------------------------------------------------- scenes


def vrml2() -> str:
    index = " ".join(f"{a},{b},{c},-1," for a, b, c in SKIN.tolist())
    return (
        "#VRML V2.0 utf8\n# a remark { [\nDEF Top Transform { translation 100 0 0 children [\n"
        " DEF Liver Transform { scale 2 2 2 rotation 0 0 1 1.5707963267948966 children Shape {\n"
        "  appearance Appearance { material DEF Red Material { diffuseColor 0.6 0.2 0.1 } }\n"
        f"  geometry IndexedFaceSet {{ coord Coordinate {{ point [ {numbers(X / 2, ', ')} ] }}\n"
        f"   solid FALSE creaseAngle 0.5 coordIndex [ {index} ] }} }} }}\n"
        " WorldInfo { title \"a # that is no remark\" } ] }\nROUTE A.x TO B.y\n"
    )  # fmt: skip


def vrml1(head: str = "#VRML V1.0 ascii") -> str:
    index = ", ".join(f"{a}, {b}, {c}, {d}, -1" for a, b, c, d in SQUARES.tolist())
    return (
        f"{head}\nSeparator {{\n Separator {{ Translation {{ translation 900 0 0 }} }}\n"
        " Material { diffuseColor [ 0.6 0.2 0.1 ] }\n MaterialBinding { value OVERALL }\n"
        " Transform { scaleFactor 2 2 2 }\n DEF Liver Separator {\n"
        f"  Coordinate3 {{ point [ {numbers(X / 2)} ] }}\n"
        f"  ShapeHints {{ vertexOrdering COUNTERCLOCKWISE }}\n"
        f"  IndexedFaceSet {{ coordIndex [ {index} ] }}\n }}\n}}\n"
    )


def lwo() -> bytes:
    """LWO2, an IFF file: high bytes first."""

    def chunk(name: bytes, body: bytes) -> bytes:
        return name + struct.pack(">I", len(body)) + body + b"\0" * (len(body) % 2)

    polygons = b"FACE" + b"".join(
        struct.pack(">4H", 3, *corners[::-1]) for corners in SKIN.tolist()
    )
    body = b"LWO2" + chunk(b"TAGS", b"red\0")
    body += chunk(b"LAYR", struct.pack(">HH3f", 0, 0, 0, 0, 0) + b"Liver\0")
    body += chunk(b"PNTS", X.astype(">f4").tobytes()) + chunk(b"POLS", polygons)
    return chunk(b"FORM", body)


# ---------------------------------------------------------------- read by VTK


def gambit() -> str:
    kinds = "".join(
        f"{i:8d}{6:3d}{4:3d} " + "".join(f"{w:8d}" for w in c) + "\n"
        for i, c in enumerate((TETRAHEDRA + 1).tolist(), 1)
    )
    ids = [f"{i:8d}" for i in range(1, len(TETRAHEDRA) + 1)]
    groups = "".join("".join(ids[i : i + 10]) + "\n" for i in range(0, len(ids), 10))
    nodes = "".join(
        f"{i:10d}" + "".join(f"{v:20.11e}" for v in p) + "\n" for i, p in enumerate(X, 1)
    )
    return (
        "        CONTROL INFO 2.3.16\n** GAMBIT NEUTRAL FILE\nball\n"
        "PROGRAM:                Gambit     VERSION:  2.3.16\n Jan 2020\n"
        "     NUMNP     NELEM     NGRPS    NBSETS     NDFCD     NDFVL\n"
        f"{len(X):10d}{len(TETRAHEDRA):10d}{1:10d}{0:10d}{3:10d}{3:10d}\nENDOFSECTION\n"
        f"   NODAL COORDINATES 2.3.16\n{nodes}ENDOFSECTION\n"
        f"      ELEMENTS/CELLS 2.3.16\n{kinds}ENDOFSECTION\n"
        f"       ELEMENT GROUP 2.3.16\nGROUP:          1 ELEMENTS:{len(TETRAHEDRA):11d} MATERIAL:"
        f"          2 NFLAGS:          1\n                           Liver\n       0\n{groups}"
        "ENDOFSECTION\n"
    )  # fmt: skip


def fluent() -> str:
    """Faces with the cell on either side, which all numbers are hexadecimal of."""
    from cell_files import find_outside

    order = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    every = np.concatenate([TETRAHEDRA[:, face] for face in order])
    owner = np.tile(np.arange(1, len(TETRAHEDRA) + 1), 4)
    _, first, which, times = np.unique(np.sort(every, axis=1), axis=0, return_index=True,
                                       return_inverse=True, return_counts=True)  # fmt: skip
    faces = {2: [], 3: []}
    for k, (at, many) in enumerate(zip(first, times, strict=True)):
        cells = owner[which.ravel() == k]
        other = int(cells[1]) if many == 2 else 0
        kind = 2 if many == 2 else 3
        words = [*(every[at] + 1).tolist(), int(cells[0]), other]
        faces[kind].append(" ".join(f"{w:x}" for w in words))
    assert len(faces[3]) == len(find_outside(TETRAHEDRA, order))
    text = '(0 "by hand")\n(2 3)\n'
    text += f"(10 (0 1 {len(X):x} 0 3))\n(10 (1 1 {len(X):x} 1 3)(\n{points(X, numbered=False)}))\n"
    text += f"(12 (0 1 {len(TETRAHEDRA):x} 0))\n(12 (2 1 {len(TETRAHEDRA):x} 1 2))\n"
    total = len(faces[2]) + len(faces[3])
    text += f"(13 (0 1 {total:x} 0))\n"
    at = 1
    for kind, zone in ((2, 3), (3, 4)):
        end = at + len(faces[kind]) - 1
        text += f"(13 ({zone} {at:x} {end:x} {kind} 3)(\n" + "\n".join(faces[kind]) + "\n))\n"
        at = end + 1
    return text


def ucd() -> str:
    cells = "".join(
        f"{i} 1 tet {' '.join(map(str, c))}\n" for i, c in enumerate((TETRAHEDRA + 1).tolist(), 1)
    )
    return f"# by hand\n{len(X)} {len(TETRAHEDRA)} 0 0 0\n{points(X)}{cells}"


def xdmf() -> str:
    return (
        '<?xml version="1.0" ?>\n<Xdmf Version="2.0"><Domain><Grid Name="Liver" '
        f'GridType="Uniform"><Topology TopologyType="Tetrahedron" '
        f'NumberOfElements="{len(TETRAHEDRA)}"><DataItem Format="XML" NumberType="Int" '
        f'Dimensions="{len(TETRAHEDRA)} 4">{numbers(TETRAHEDRA)}</DataItem></Topology>'
        f'<Geometry GeometryType="XYZ"><DataItem Format="XML" Dimensions="{len(X)} 3">'
        f"{numbers(X)}</DataItem></Geometry></Grid></Domain></Xdmf>\n"
    )


def vtm() -> Files:
    from foreign_files import data_array

    ends = 3 * np.arange(1, len(SKIN) + 1)
    arrays = data_array("connectivity", "Int64", SKIN) + data_array("offsets", "Int64", ends)
    polygons = (
        '<?xml version="1.0"?><VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">'
        f'<PolyData><Piece NumberOfPoints="{len(X)}" NumberOfVerts="0" NumberOfLines="0" '
        f'NumberOfStrips="0" NumberOfPolys="{len(SKIN)}"><Points><DataArray type="Float64" '
        f'NumberOfComponents="3" format="ascii">{numbers(X)}</DataArray></Points>'
        f"<Polys>{arrays}</Polys></Piece></PolyData></VTKFile>"
    )
    blocks = (
        '<?xml version="1.0"?><VTKFile type="vtkMultiBlockDataSet" version="1.0" '
        'byte_order="LittleEndian"><vtkMultiBlockDataSet>'
        '<DataSet index="0" name="Liver" file="ball/ball_0.vtp"/></vtkMultiBlockDataSet></VTKFile>'
    )
    return {"ball.vtm": blocks, "ball/ball_0.vtp": polygons}


def one(name: str, make: Callable[[], str | bytes]) -> Callable[[], Files]:
    return lambda: {name: make()}


FILES: dict[str, Callable[[], Files]] = {
    "Medit, tetrahedra": one("ball.mesh", lambda: medit("Triangles", "Tetrahedra")),
    "Medit, faces": one("ball.mesh", lambda: medit("Triangles")),
    "Medit, bricks": one("ball.mesh", lambda: medit("Quadrilaterals", "Hexahedra")),
    "Medit, prisms": one("ball.mesh", lambda: medit("Prisms")),
    **{
        f"Medit, binary {v} {order}": one(
            "ball.meshb", lambda v=v, order=order: medit_binary(v, order)
        )
        for v, order in ((1, "<"), (2, "<"), (2, ">"), (3, "<"), (4, "<"))
    },
    "Netgen": one("ball.vol", netgen),
    "Netgen, neutral": one("ball.mesh", netgen_neutral),
    "TetGen from 0": lambda: tetgen(0),
    "TetGen from 1": lambda: tetgen(1),
    "TetGen, faces": tetgen_faces,
    "TetGen, smesh": one("ball.smesh", smesh),
    "TetGen, poly": one("ball.poly", poly),
    "VegaFEM": lambda: vega(apart=False),
    "VegaFEM, apart": lambda: vega(apart=True),
    "openCARP": carp,
    "Abaqus": one("ball.inp", abaqus),
    "Abaqus, parts": one("ball.inp", abaqus_parts),
    "Nastran, small fields": one("ball.bdf", nastran_small),
    "Nastran, large fields": one("ball.nas", nastran_large),
    "Nastran, commas": one("ball.fem", nastran_free),
    "universal": one("ball.unv", universal),
    "FEBio 1.2": one("ball.feb", lambda: febio("1.2")),
    "FEBio 2.5": one("ball.feb", lambda: febio("2.5")),
    "FEBio 4.0": one("ball.feb", lambda: febio("4.0")),
    "LS-DYNA": one("ball.k", dyna),
    "LS-DYNA, shells": one("ball.key", dyna_shells),
    "GIFTI, text": one("ball.surf.gii", lambda: gifti("ASCII")),
    "GIFTI, base64": one("ball.gii", lambda: gifti("Base64Binary")),
    "GIFTI, packed": one("ball.gii", lambda: gifti("GZipBase64Binary")),
    "FreeSurfer": one("lh.pial", freesurfer),
    "FreeSurfer, a name of its own": one("lh.smoothed_by_me", freesurfer),
    "mz3": one("ball.mz3", lambda: mz3(packed=False)),
    "mz3, packed": one("ball.mz3", lambda: mz3(packed=True)),
    "VRML 2": one("ball.wrl", vrml2),
    "VRML 2, packed": one("ball.wrl", lambda: gzip.compress(vrml2().encode())),
    "VRML 1": one("ball.wrl", vrml1),
    "Inventor": one("ball.iv", lambda: vrml1("#Inventor V2.1 ascii")),
    "LightWave": one("ball.lwo", lwo),
    "Gambit": one("ball.neu", gambit),
    "Fluent": one("ball.msh", fluent),
    "AVS UCD": one("ball.inp", ucd),
    "XDMF": one("ball.xdmf", xdmf),
    "VTK, blocks": vtm,
    "no extension, Medit": one("ball", lambda: medit("Tetrahedra")),
    "packed Abaqus": one("ball.inp.gz", lambda: gzip.compress(abaqus().encode())),
}
