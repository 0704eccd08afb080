# SPDX-License-Identifier: GPL-3.0-or-later
"""What a surface is like, measured once: a surface never changes."""

from __future__ import annotations

from weakref import WeakKeyDictionary

import palpate

from palpate_editor import authoring
from palpate_editor.document import Surface

reports: WeakKeyDictionary[Surface, authoring.MeshReport] = WeakKeyDictionary()


def mesh_of(surface: Surface) -> palpate.SurfaceMesh:
    return palpate.SurfaceMesh(surface.vertices, surface.triangles)


def inspect_surface(surface: Surface) -> authoring.MeshReport:
    """A second for 200 000 triangles the first time."""
    if surface not in reports:
        reports[surface] = authoring.inspect_mesh(mesh_of(surface))
    return reports[surface]
