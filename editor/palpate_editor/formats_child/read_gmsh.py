# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the files of Gmsh (.msh 1, 2, 4.0 and 4.1, text or binary)."""

from __future__ import annotations

from palpate_editor.formats_child.cells import CORNERS, Block, CellMesh, build_scene
from palpate_editor.formats_child.gmsh_file import open_gmsh
from palpate_editor.formats_child.scene import Scene

KINDS = {
    **dict.fromkeys((2, 9, 20, 21, 22, 23, 24, 25), "triangle"),
    **dict.fromkeys((3, 10, 16, 36, 37), "quad"),
    **dict.fromkeys((4, 11, 29, 30, 31), "tetra"),
    **dict.fromkeys((5, 12, 17, 92, 93), "hexahedron"),
    **dict.fromkeys((6, 13, 18), "wedge"),
    **dict.fromkeys((7, 14, 19), "pyramid"),
}
"""Type of an element, as Gmsh numbers them -> what it is."""


def read_gmsh(path: str) -> Scene:
    """The outer faces of cells that fill space, where there are some, else the faces; a part for
    each physical group. Raises Refusal."""
    mesh = open_gmsh(path)
    blocks = [
        Block(kind, block.nodes[:, : CORNERS[kind]], block.groups)
        for block in mesh.blocks
        if (kind := KINDS.get(block.type)) is not None and len(block.nodes) > 0
    ]
    return build_scene(path, CellMesh(mesh.points, blocks, mesh.names, mesh.lost))
