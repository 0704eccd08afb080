# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from VRML 1 and 2 (.wrl) and Open Inventor (.iv) as text: sets of faces and strips, with
their transforms and the colours of their materials."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from palpate_editor.formats_child.scene import Part, Refusal, Scene, cut_out
from palpate_editor.formats_child.vrml_file import Node, open_vrml

FACES = ("IndexedFaceSet", "IndexedTriangleStripSet", "IndexedTriangleSet", "FaceSet")
SOLIDS = ("Box", "Cone", "Cube", "Cylinder", "ElevationGrid", "Extrusion", "Sphere", "Text")
"""Shapes that have no faces of their own."""
MOVES = ("Transform", "Translation", "Rotation", "Scale", "MatrixTransform")
"""Of VRML 1: they move what follows."""
MOST_PARTS = 20_000


@dataclass(frozen=True, eq=False)
class State:
    """What a node is in: VRML 1 changes it for those that follow, VRML 2 for those below."""

    place: np.ndarray = field(default_factory=lambda: np.eye(4))
    """For points as columns."""
    points: np.ndarray = field(default_factory=lambda: np.empty((0, 3)))
    colour: tuple[float, ...] = ()
    name: str = ""


class Walk:
    def __init__(self, stem: str, is_two: bool):
        self.stem, self.is_two = stem, is_two
        self.names: Counter[str] = Counter()
        self.parts: list[Part] = []
        self.passed_over: dict[str, int] = {}

    def visit(self, nodes: list[Node], state: State) -> State:
        """The state behind them."""
        for node in nodes:
            state = self.enter(node, state)
        return state

    def enter(self, node: Node, state: State) -> State:
        named = replace(state, name=node.name or state.name)
        kind = node.type
        if kind in FACES:
            self.add_faces(node, named)
        elif kind in ("Coordinate3", "Coordinate"):
            return replace(state, points=take_points(node, "point"))
        elif kind == "VertexProperty":
            return replace(state, points=take_points(node, "vertex"))
        elif kind in ("Material", "BaseColor"):
            return replace(state, colour=take_colour(node) or state.colour)
        elif kind == "Shape":
            self.enter_shape(node, named)
        elif kind == "Switch":
            self.enter_switch(node, named)
        elif kind in ("LOD", "LevelOfDetail"):
            self.visit((list_below(node) or [])[:1], named)
        elif kind in SOLIDS or kind in ("Inline", "WWWInline", "File"):
            self.passed_over[kind] = self.passed_over.get(kind, 0) + 1
        elif list_below(node):
            below = named
            if kind == "Transform":
                below = replace(named, place=state.place @ build_place(node, "scale"))
            after = self.visit(list_below(node), below)
            if kind == "Group":  # of VRML 1, which leaves its state behind
                return replace(after, name=state.name)
        elif kind in MOVES and not self.is_two:
            return replace(state, place=state.place @ build_place(node, "scaleFactor"))
        return state

    def enter_shape(self, node: Node, state: State) -> None:
        look = node.fields.get("appearance")
        material = look.fields.get("material") if isinstance(look, Node) else None
        if isinstance(material, Node):
            state = replace(state, colour=take_colour(material))
        geometry = node.fields.get("geometry")
        if isinstance(geometry, Node):
            self.enter(geometry, replace(state, name=geometry.name or state.name))

    def enter_switch(self, node: Node, state: State) -> None:
        which = node.fields.get("whichChoice", node.fields.get("whichChild"))
        chosen = int(which[0]) if isinstance(which, np.ndarray) and len(which) else -1
        choices = list_below(node)
        shown = choices if chosen == -3 else choices[chosen : chosen + 1] if chosen >= 0 else []
        self.visit(shown, state)

    def add_faces(self, node: Node, state: State) -> None:
        points = state.points
        for name, of in (("coord", "point"), ("vertexProperty", "vertex")):
            inner = node.fields.get(name)
            if isinstance(inner, Node):
                points = take_points(inner, of)
        triangles = list_triangles(node, len(points))
        if len(triangles) == 0:
            return
        if len(self.parts) == MOST_PARTS:
            raise Refusal("", f"more than {MOST_PARTS} sets of faces", "an organ")
        placed = points @ state.place[:3, :3].T + state.place[:3, 3]
        if np.linalg.det(state.place[:3, :3]) < 0.0:
            triangles = triangles[:, ::-1]
        name = state.name or self.stem
        self.names[name] += 1
        if self.names[name] > 1:
            name += f" ({self.names[name]})"
        self.parts.append(replace(cut_out(name, placed, triangles), colour=state.colour))


def read_vrml(path: str) -> Scene:
    """Raises Refusal."""
    head, nodes = open_vrml(path)
    walk = Walk(Path(path).stem, head.startswith(("#VRML V2", "#X3D")))
    walk.visit(nodes, State())
    told = [f"{count} {kind}" for kind, count in sorted(walk.passed_over.items())]
    if not walk.parts:
        got = f"no faces, but {', '.join(told)}" if told else "no faces"
        raise Refusal("", got, "IndexedFaceSet, a surface made of triangles or polygons")
    notes = [f"nodes without faces of their own were passed over: {', '.join(told)}"]
    return Scene(walk.parts, notes if told else [])


def list_below(node: Node) -> list[Node]:
    found = list(node.children)
    for name in ("children", "level", "choice", "child"):
        value = node.fields.get(name)
        found += value if isinstance(value, list) else [value] if isinstance(value, Node) else []
    return found


def take_points(node: Node, name: str) -> np.ndarray:
    values = node.fields.get(name)
    if not isinstance(values, np.ndarray):
        return np.empty((0, 3))
    if len(values) % 3:
        raise Refusal(node.type, f"{len(values)} numbers", "x y z of each point")
    return values.reshape(-1, 3)


def take_colour(node: Node) -> tuple[float, ...]:
    """The mean of its colours, where they are not all white."""
    values = node.fields.get("diffuseColor", node.fields.get("rgb"))
    if not isinstance(values, np.ndarray) or len(values) < 3 or len(values) % 3:
        return ()
    mean = np.clip(values.reshape(-1, 3).mean(axis=0), 0.0, 1.0)
    return () if (mean > 0.998).all() else tuple(mean.tolist())


def list_triangles(node: Node, count: int) -> np.ndarray:
    """(t, 3) Fans of polygons, or strips, that end with -1."""
    if node.type == "FaceSet":
        sizes = node.fields.get("numVertices", np.empty(0))
        assert isinstance(sizes, np.ndarray)
        rows, at = [], 0
        for size in sizes.astype(int):
            size = count - at if size < 0 else int(size)
            rows.append(np.arange(at, at + size))
            at += size
    else:
        name = "index" if node.type == "IndexedTriangleSet" else "coordIndex"
        values = node.fields.get(name, np.empty(0))
        if not isinstance(values, np.ndarray):
            raise Refusal(node.type, f"a {name} that is no list of numbers", "corners of faces")
        index = values.astype(np.int64)
        if node.type == "IndexedTriangleSet":
            return index[: len(index) // 3 * 3].reshape(-1, 3)
        if (
            len(index) % 4 == 0
            and (index[3::4] == -1).all()
            and (index.reshape(-1, 4)[:, :3] >= 0).all()
        ):
            return turn(node, index.reshape(-1, 4)[:, :3])
        rows = [row[row >= 0] for row in np.split(index, np.flatnonzero(index < 0))]
    is_strip = node.type == "IndexedTriangleStripSet"
    found = [cut_strip(row) if is_strip else cut_fan(row) for row in rows if len(row) >= 3]
    return turn(node, np.concatenate(found)) if found else np.empty((0, 3), np.int64)


def turn(node: Node, triangles: np.ndarray) -> np.ndarray:
    is_clockwise = node.fields.get("ccw") == "FALSE"
    return triangles[:, ::-1] if is_clockwise else triangles


def cut_fan(row: np.ndarray) -> np.ndarray:
    return np.stack([np.full(len(row) - 2, row[0]), row[1:-1], row[2:]], axis=1)


def cut_strip(row: np.ndarray) -> np.ndarray:
    """Every second triangle is the other way round."""
    found = np.stack([row[:-2], row[1:-1], row[2:]], axis=1)
    found[1::2] = found[1::2][:, [1, 0, 2]]
    return found


def build_place(node: Node, scale: str) -> np.ndarray:
    """T C R S -C, as VRML has it; scaleOrientation is that of an even scale."""
    matrix = node.fields.get("matrix")
    if isinstance(matrix, np.ndarray) and len(matrix) == 16:
        return matrix.reshape(4, 4).T
    centre = take_three(node, "center", 0.0)
    shift = take_three(node, "translation", 0.0)
    factor = np.diag(take_three(node, scale, 1.0))
    oriented = take_turn(node, "scaleOrientation")
    linear = take_turn(node, "rotation") @ oriented @ factor @ oriented.T
    place = np.eye(4)
    place[:3, :3] = linear
    place[:3, 3] = shift + centre - linear @ centre
    return place


def take_three(node: Node, name: str, usual: float) -> np.ndarray:
    value = node.fields.get(name)
    is_there = isinstance(value, np.ndarray) and len(value) == 3
    return np.asarray(value) if is_there else np.full(3, usual)


def take_turn(node: Node, name: str) -> np.ndarray:
    """[Rodrigues] Of an axis and an angle [rad]."""
    value = node.fields.get(name)
    if not isinstance(value, np.ndarray) or len(value) != 4:
        return np.eye(3)
    length = float(np.linalg.norm(value[:3]))
    if not length > 0.0:
        return np.eye(3)
    x, y, z = value[:3] / length
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(value[3]) * cross + (1.0 - np.cos(value[3])) * cross @ cross
