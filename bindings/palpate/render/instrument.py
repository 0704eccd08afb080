# SPDX-License-Identifier: BSD-3-Clause
"""What is seen of an instrument of capsules: its tip, or its jaws, its shaft, and its trocar."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.render.instrument_meshes import MESHES, InstrumentMesh, read_part
from palpate.render.part import Appearance
from palpate.render.shapes import Shape, build_capsule, turn
from palpate.render.theme import STEEL, Colour

SHAFT = 0.25
"""[m] of a probe's shaft that is drawn: instruments for the abdomen are a little longer."""
SHAFT_PART = 0.8
"""[-] Of the radius: what is drawn only is thinner than what touches."""
WIDE = 3.2e-3
"""[m] A shaft of this radius or more is drawn as a laparoscope, a thinner one as a probe."""
NEEDLE = 0.8e-3
"""[m] A shaft of this radius or less, of 16 G, is drawn as a syringe's needle."""
SAME = 1e-6
"""[m] Vertices of a mesh are one where they are nearer than this."""
INSULATED: Colour = (0.36, 0.39, 0.44)
PORT: Colour = (0.30, 0.52, 0.66)
# their shadow is that of InstrumentShade
METAL = Appearance(STEEL, gloss=1.0, subsurface=0.0, seen_through=True, casts_shadow=False)
DARK_SHAFT = Appearance(INSULATED, gloss=0.7, subsurface=0.0, seen_through=True, casts_shadow=False)
TROCAR = Appearance(PORT, gloss=0.5, subsurface=0.0, casts_shadow=False)


@dataclass(frozen=True)
class DrawnPart:
    """A part of an instrument, in the tool's frame or where it is."""

    shape: Shape
    appearance: Appearance
    turns: float = 0.0
    """[-] 1 or -1 for a jaw: the sense in which it opens about x."""


@dataclass(frozen=True)
class DrawnInstrument:
    """An instrument in the tool's frame [m], its jaws closed."""

    parts: tuple[DrawnPart, ...]
    hinge: float = 0.0
    """[m] Along z: where the axis of the jaws, which is along x, crosses the shaft."""


def name_look(tool: palpate.Tool) -> str:
    """What an instrument is drawn as, by what touches: a kind of instrument."""
    if getattr(tool, "jaws", None):
        return "grasper"
    if not tool.capsules:
        return "ball"
    if tool.radius <= NEEDLE:
        return "syringe"
    return "laparoscope" if tool.radius >= WIDE else "probe"


def build_instrument(tool: palpate.Tool) -> DrawnInstrument | None:
    """As wide as what touches; None for a ball, which has no shaft. A grasper is as wide as its
    jaws and as long as they are."""
    look = name_look(tool)
    if look == "ball":
        return None
    if look in MESHES:
        return fit_mesh(MESHES[look], tool)
    tip = [build_capsule(part.from_, part.to, tool.radius) for part in tool.capsules]
    end = np.array(tool.capsules[-1].to)
    parts = [DrawnPart(join_shapes(tip), METAL)]
    if end[2] < SHAFT:
        shaft = build_capsule(end, [end[0], end[1], SHAFT], SHAFT_PART * tool.radius)
        parts.append(DrawnPart(shaft, DARK_SHAFT))
    return DrawnInstrument(tuple(parts))


def fit_mesh(mesh: InstrumentMesh, tool: palpate.Tool) -> DrawnInstrument:
    """A shipped mesh whose tip lies where the axis of the first capsule begins; jaws and needles
    are as long as those that touch, and what is behind them as it is."""
    jaws = getattr(tool, "jaws", None)
    start = float(np.asarray(tool.capsules[0].from_)[2])
    hinge = 0.0 if jaws is None else float(np.asarray(jaws.hinge)[2])
    parts = []
    for part in mesh.parts:
        shape = read_part(part.name)
        x = shape.vertices.copy()
        if jaws is not None:
            x[:, :2] *= np.float32(tool.radius / mesh.jaw_radius)
            x[:, 2] = stretch_front(x[:, 2], mesh.hinge, hinge)
        elif mesh.needle > 0.0:
            end = float(np.asarray(tool.capsules[-1].to)[2])
            x[x[:, 2] < mesh.needle + SAME, :2] *= np.float32(tool.radius / mesh.radius)
            x[:, 2] = stretch_front(x[:, 2], mesh.needle, end - start + mesh.tip)
            x[:, 2] += np.float32(start - mesh.tip)
        else:
            x[:, :2] *= np.float32(tool.radius / mesh.radius)
            x[:, 2] += np.float32(start - mesh.tip)
        look = replace(METAL, colour=part.colour)
        parts.append(DrawnPart(Shape(x, shape.normals, shape.triangles), look, part.turns))
    return DrawnInstrument(tuple(parts), hinge)


def stretch_front(z: NDArray[np.float32], front: float, wanted: float) -> NDArray[np.float32]:
    """[m] Along the shaft: what is before `front` as long as `wanted`, the rest moved with it."""
    return np.where(z < front, z * np.float32(wanted / front), z + np.float32(wanted - front))


def build_trocar(trocar: ArrayLike, tip: ArrayLike, radius: float) -> Shape:
    """The port in the abdominal wall [m], a short tube round the shaft of that radius [m]."""
    at = np.asarray(trocar, dtype=float)
    inner, outer, rim = 1.25 * radius, 1.9 * radius + 1e-3, 3.0 * radius + 2e-3
    profile = [(inner, 0.03), (outer, 0.03), (outer, 0.0), (rim, 0.0), (rim, -0.006)]
    profile += [(inner, -0.006), (inner, 0.03)]
    points = np.repeat(np.array(profile), 2, axis=0)[1:-1]
    edges = np.diff(points[::2].tolist() + [points[-1].tolist()], axis=0)
    slopes = np.repeat(np.column_stack([edges[:, 1], -edges[:, 0]]), 2, axis=0)[: len(points)]
    slopes /= np.linalg.norm(slopes, axis=1, keepdims=True)
    return turn(points, slopes, at, np.asarray(tip, dtype=float) - at, 32)


def join_shapes(shapes: Sequence[Shape]) -> Shape:
    """One after the other."""
    counts = np.cumsum([0] + [len(shape.vertices) for shape in shapes[:-1]])
    return Shape(
        np.concatenate([shape.vertices for shape in shapes]),
        np.concatenate([shape.normals for shape in shapes]),
        np.concatenate(
            [shape.triangles + np.uint32(k) for shape, k in zip(shapes, counts, strict=True)]
        ),
    )


def place_instrument(
    drawn: DrawnInstrument, position: ArrayLike, orientation: ArrayLike, opening: float = 0.0
) -> tuple[DrawnPart, ...]:
    """Where the tool is [m], turned by a unit quaternion (x, y, z, w), each jaw open by an angle
    [rad]."""
    held = find_rotation(orientation)
    at, hinge = np.asarray(position, dtype=np.float32), np.float32([0.0, 0.0, drawn.hinge])
    placed = []
    for part in drawn.parts:
        x, normals = part.shape.vertices, part.shape.normals
        if part.turns and opening:
            jaw = turn_about_x(part.turns * opening)
            x, normals = (x - hinge) @ jaw.T + hinge, normals @ jaw.T
        shape = Shape(x @ held.T + at, normals @ held.T, part.shape.triangles)
        placed.append(DrawnPart(shape, part.appearance))
    return tuple(placed)


def turn_about_x(angle: float) -> NDArray[np.float32]:
    """The matrix (3, 3) of an angle [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]], dtype=np.float32)


def find_rotation(orientation: ArrayLike) -> NDArray[np.float32]:
    """The matrix (3, 3) of a unit quaternion (x, y, z, w)."""
    x, y, z, w = np.asarray(orientation, dtype=float)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ],
        dtype=np.float32,
    )
