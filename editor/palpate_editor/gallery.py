# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the organs and tools that come with Palpate, alone and on one sheet."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import palpate
from palpate.render import Appearance, Camera, build_appearance, draw_picture
from palpate.render.overlay import Overlay
from palpate.render.studio import Shot, Thing, take_picture
from palpate.render.theme import THEMES
from palpate_meshes.catalogue import Entry, Tissue, read_organ_mesh
from palpate_meshes.tools import Tool, open_jaws, read_tool, read_tool_names

from palpate_editor.shipped import list_organs

TILE = (400, 340)
"""[px]"""
THUMBNAIL = (232, 192)
"""[px] Twice what the start page gives it, for dense screens."""
MARGIN = (16, 40, 16, 22)
"""[px] Left, above, right and below of what is drawn in a tile; in proportion elsewhere."""
BARE_MARGIN = (14, 14, 14, 22)
"""[px] Of a tile without a title."""
COLUMNS = 5
JAWS_SHOWN = 0.6
"""[-] How far a grasper stands open in its picture."""
TOOL_VIEW = (-118.0, 16.0)
"""[degree] Azimuth and elevation."""
SHAFT_SHOWN = {"grasper": 0.045}
"""[m] Of a tool that is known by its tip; the others are shown whole."""
CREASE = 0.77
"""[-] Cosine of the angle, 40 degrees, from which an edge is sharp."""

Pixels = np.ndarray


def draw_organ(
    entry: Entry,
    tissue: Tissue,
    size: tuple[int, int] = TILE,
    theme: str = "light",
    named: bool = True,
) -> Pixels:
    """A shipped organ as it is known at a glance, (h, w, 3), with name and counts or without."""
    vertices, triangles = read_organ_mesh(entry.name)
    return draw_picture(
        vertices,
        triangles,
        camera=aim(entry.view, vertices, size, MARGIN if named else BARE_MARGIN),
        size=size,
        theme=theme,
        wireframe=False,
        appearance=build_appearance(tissue.appearance),
        title=f"{entry.title}, {entry.vertices} / {entry.triangles}" if named else "",
    )


def aim(
    view: tuple[float, float],
    points: np.ndarray,
    size: tuple[int, int],
    margin: tuple[int, int, int, int] = MARGIN,
) -> Camera:
    """From an azimuth and an elevation [degree], as near as leaves a margin around points [m]."""
    camera = Camera(math.radians(view[0]), math.radians(view[1]))
    scale = size[1] / TILE[1]
    left, above, right, below = (scale * side for side in margin)
    camera.fit(points, size, (left, above, size[0] - right, size[1] - below))
    return camera


def draw_tool(tool: Tool, size: tuple[int, int] = TILE, theme: str = "light") -> Pixels:
    """The front of an instrument, its jaws open, (h, w, 3)."""
    parts = open_jaws(tool, JAWS_SHOWN) if tool.jaws else tool.parts
    things, front = [], []
    for name, (vertices, triangles) in parts.items():
        # lying on the table, tip to the left
        x = vertices @ np.array([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]])
        things.append(
            crease(x, triangles, Appearance(tool.colours[name], gloss=0.9, subsurface=0.0))
        )
        front.append(x[x[:, 0] < SHAFT_SHOWN.get(tool.name, np.inf)])
    shown = np.concatenate(front)
    overlay = Overlay(size, THEMES[theme])
    overlay.add_title(tool.title)
    camera = aim(TOOL_VIEW, shown, size)
    floor = min(float(thing.vertices[:, 2].min()) for thing in things)
    return overlay.blend(take_picture(things, Shot(camera, size, 2, THEMES[theme], None, floor)))


def crease(vertices: np.ndarray, triangles: np.ndarray, appearance: Appearance) -> Thing:
    """A surface whose edges stay sharp: each corner has the normal of what is smooth with it."""
    x = vertices[triangles].reshape(-1, 3)
    alone = np.arange(len(x), dtype=np.int32).reshape(-1, 3)
    flat = np.asarray(palpate.compute_vertex_normals(x, alone))
    normals = flat.copy()
    corners = triangles.ravel()
    for vertex in np.unique(corners):
        here = np.flatnonzero(corners == vertex)
        smooth = flat[here] @ flat[here].T > CREASE
        normals[here] = smooth @ flat[here]
    return Thing(x, normals / np.linalg.norm(normals, axis=1)[:, None], alone, appearance)


def list_thumbnails() -> list[str]:
    """The files of draw_thumbnails, in its order."""
    return [f"{entry.name}_{theme}.png" for entry, _ in list_organs() for theme in THEMES]


def draw_thumbnails() -> Iterator[tuple[str, Pixels]]:
    """A small picture of every organ in both themes, each with the name of its file."""
    drawn = (
        draw_organ(entry, tissue, THUMBNAIL, theme, named=False)
        for entry, tissue in list_organs()
        for theme in THEMES
    )
    yield from zip(list_thumbnails(), drawn, strict=True)


def draw_contact_sheet(theme: str = "light") -> Pixels:
    """All organs and tools beside each other, (h, w, 3)."""
    tiles = [draw_organ(entry, tissue, theme=theme) for entry, tissue in list_organs()]
    tiles += [draw_tool(read_tool(name), theme=theme) for name in read_tool_names()]
    while len(tiles) % COLUMNS:
        tiles.append(np.full_like(tiles[0], 255))
    rows = [np.hstack(tiles[i : i + COLUMNS]) for i in range(0, len(tiles), COLUMNS)]
    return np.vstack(rows)
