# SPDX-License-Identifier: BSD-3-Clause
"""Instruments in real sizes: tip at the origin, shaft along -z, with what a contact needs."""

from __future__ import annotations

import math
import tomllib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from palpate.files.whole_file import write_whole
from palpate.scene.instrument_kinds import DESCRIPTIONS as SHIPPED
from palpate.scene.mesh_file import read_mesh_file
from palpate_meshes.catalogue import PUBLISHED, freeze
from palpate_meshes.generate.field import Array
from palpate_meshes.generate.loft import lathe, loft

FOLDER = PUBLISHED / "tools"
DESCRIPTIONS = Path(__file__).with_name("tools.toml")
JAW_RADII = (1.35, 2.4)
"""[mm] Of a jaw at its tip and at its root."""
JAW_TIP = (0.03, 0.12, 0.3, 0.6, 0.95, 1.35, 2.0)
JAW_BACK = (22.0, 23.0, 23.8, 24.3)
"""[mm] behind the tip: where its sections are drawn, beside those at the teeth."""
TEETH, TEETH_FROM, TOOTH = 13, 2.6, 1.3
"""How many, where they begin and how long one is [mm]."""
RIDGE, VALLEY = 0.12, 0.62
"""[mm] Above the tool's middle: the tips of the teeth and the ground between them."""
JAW_ARC, JAW_FLAT = 15, 5
"""Vertices of a section on its round and on its flat side."""
VIEW_ANGLE = 0.5773502691896258
"""[-] Tangent of 30 degrees, by which the front lens of the laparoscope is slanted."""

Mesh = tuple[np.ndarray, np.ndarray]
Vector = tuple[float, float, float]


@dataclass(frozen=True)
class CollisionShape:
    """A sphere, or a capsule where `b` is given, that stands for a part in contact."""

    part: str
    a: Vector
    """[m] Centre, or one end of the axis."""
    radius: float
    """[m]"""
    b: Vector | None = None
    """[m] The other end."""


@dataclass(frozen=True)
class Jaws:
    """Parts that turn about one axis."""

    hinge: Vector
    """[m] A point on the axis."""
    axis: Vector
    """[-] Unit."""
    open: float
    """[rad] The farthest that each jaw turns from where it is closed."""
    turns: dict[str, float]
    """Part -> the sense in which it turns about the axis to open, 1 or -1."""


@dataclass(frozen=True)
class Pad:
    """The flat side of a jaw, which holds what it is closed on."""

    part: str
    centre: Vector
    """[m]"""
    normal: Vector
    """[-] Unit, towards the other jaw."""
    length: float
    """[m] Along the shaft."""
    width: float
    """[m] Along the jaws' axis."""


@dataclass(frozen=True)
class ScopeCamera:
    """What an instrument sees by."""

    at: Vector
    """[m] The middle of its front lens."""
    axis: Vector
    """[-] Unit, the way it looks."""
    up: Vector
    """[-] Unit, across the axis."""
    field_of_view: float
    """[rad] From one side of the picture to the other."""


@dataclass(frozen=True)
class Needle:
    """What can be pushed into tissue."""

    axis: Vector
    """[-] Unit, the way it goes in; its point is the origin."""
    length: float
    """[m]"""
    radius: float
    """[m]"""


@dataclass(frozen=True)
class Tool:
    """An instrument, its parts in the frame of the tip."""

    name: str
    title: str
    source: str
    """Where the sizes come from."""
    parts: dict[str, Mesh]
    """Vertices [m] and triangles, jaws closed."""
    shapes: tuple[CollisionShape, ...]
    jaws: Jaws | None = None
    needle: Needle | None = None
    pads: tuple[Pad, ...] = ()
    """Where its jaws are closed."""
    camera: ScopeCamera | None = None
    colours: dict[str, Vector] = field(default_factory=dict)
    """Part -> sRGB, 0 to 1."""


def read_tool(name: str) -> Tool:
    """A shipped instrument. Raises ValueError for another name, OSError where files are missing."""
    tables = read_tables()
    if name not in tables:
        raise ValueError(f"tool: got {name!r}, expected one of {', '.join(tables)}")
    table: dict[str, Any] = freeze(tables[name])
    meshes = {}
    for part in table["parts"]:
        mesh = read_mesh_file(FOLDER / f"{name}_{part}.obj")
        meshes[part] = (np.asarray(mesh.vertices), np.asarray(mesh.triangles))
    return Tool(
        name=name,
        title=table["title"],
        source=table["source"],
        parts=meshes,
        shapes=tuple(CollisionShape(**shape) for shape in table["shapes"]),
        jaws=Jaws(**table["jaws"]) if "jaws" in table else None,
        needle=Needle(**table["needle"]) if "needle" in table else None,
        pads=tuple(Pad(**pad) for pad in table.get("pads", ())),
        camera=ScopeCamera(**table["camera"]) if "camera" in table else None,
        colours=table["colours"],
    )


def read_tool_names() -> list[str]:
    """Those that have meshes."""
    return list(read_tables())


def read_tables() -> dict[str, Any]:
    tables = tomllib.loads(DESCRIPTIONS.read_text(encoding="utf-8"))
    return {name: table for name, table in tables.items() if "parts" in table}


def ship_descriptions() -> None:
    """Puts a copy beside the library, which reads no other file of this folder."""
    write_whole(SHIPPED, DESCRIPTIONS.read_bytes())


def open_jaws(tool: Tool, share: float) -> dict[str, Mesh]:
    """The parts with the jaws opened by a share of their range, 0 closed to 1."""
    if tool.jaws is None:
        raise ValueError(f"{tool.name} has no jaws")
    if not 0.0 <= share <= 1.0:
        raise ValueError(f"share must be 0 to 1, got {share}")
    parts = {}
    for name, (vertices, triangles) in tool.parts.items():
        angle = tool.jaws.turns.get(name, 0.0) * share * tool.jaws.open
        parts[name] = (turn(vertices, tool.jaws.hinge, tool.jaws.axis, angle), triangles)
    return parts


def turn(points: Array, hinge: Vector, axis: Vector, angle: float) -> Array:
    """Points turned about an axis through the hinge (Rodrigues)."""
    k, p = np.asarray(axis), points - np.asarray(hinge)
    along = (p @ k)[:, None] * k
    turned = along + np.cos(angle) * (p - along) + np.sin(angle) * np.cross(k, p)
    return turned + np.asarray(hinge)


# ---------------------------------------------------------------- how they are made


def build_tools() -> dict[str, dict[str, Mesh]]:
    """Every instrument's parts, ready to be written."""
    return {
        "grasper": build_grasper(),
        "laparoscope": build_laparoscope(),
        "syringe": build_syringe(),
    }


def build_grasper() -> dict[str, Mesh]:
    """5 mm across, jaws of 20 mm with teeth, a shaft of 330 mm."""
    upper, triangles = build_jaw()
    # the other jaw is the same one turned half round the shaft
    lower = upper * np.array([-1.0, -1.0, 1.0])
    shaft = lathe(
        [(0.0012, -0.0205), (0.0019, -0.0215), (0.0025, -0.024), (0.0025, -0.30),
         (0.0042, -0.302), (0.0042, -0.330)]
    )  # fmt: skip
    return {"shaft": shaft, "upper_jaw": (upper, triangles), "lower_jaw": (lower, triangles)}


def build_jaw() -> Mesh:
    """Half a tapered rod, round at both ends, with teeth filed across its flat side."""
    teeth = [TEETH_FROM + 0.5 * TOOTH * k for k in range(2 * TEETH + 1)]
    rings = [
        draw_jaw_section(behind, VALLEY if behind in teeth[1::2] else RIDGE)
        for behind in [*JAW_TIP, *teeth, *JAW_BACK]
    ]
    return loft(rings, (rings[0].mean(axis=0), rings[-1].mean(axis=0)))


def draw_jaw_section(behind: float, floor: float) -> np.ndarray:
    """[m] The outline of the upper jaw, (JAW_ARC + JAW_FLAT, 3).

    Args:
        behind: [mm] the tip.
        floor: [mm] How high above the tool's middle its flat side is there.
    """
    tip, root, back = JAW_RADII[0], JAW_RADII[1], JAW_BACK[0]
    taper = tip + (root - tip) * (behind - tip) / (back - tip)
    past = max(tip - behind, behind - back, 0.0)
    radius = math.sqrt((taper if past == 0.0 else tip if behind < tip else root) ** 2 - past**2)
    low = math.asin(floor / radius)
    arc = [low + (math.pi - 2.0 * low) * k / (JAW_ARC - 1) for k in range(JAW_ARC)]
    x = [radius * math.cos(angle) for angle in arc]
    y = [radius * math.sin(angle) for angle in arc]
    flat = np.linspace(x[-1], x[0], JAW_FLAT + 2)[1:-1]
    outline = [*zip(x, y, strict=True), *((across, floor) for across in flat)]
    return 1e-3 * np.array([(across, up, -behind) for across, up in outline])


def build_laparoscope() -> dict[str, Mesh]:
    """10 mm across, 310 mm long, looking 30 degrees aside, with an eyepiece."""
    vertices, triangles = lathe(
        [(0.0050, 0.0), (0.0050, -0.0070), (0.0050, -0.305), (0.0085, -0.309), (0.0085, -0.318),
         (0.0130, -0.330), (0.0130, -0.352), (0.0095, -0.356), (0.0095, -0.372),
         (0.0160, -0.378), (0.0160, -0.384)], 40
    )  # fmt: skip
    front = vertices[:, 2] > -0.003
    slant = np.where(front, VIEW_ANGLE * (vertices[:, 1] - 0.005), 0.0)
    vertices = np.round(vertices + slant[:, None] * np.array([0.0, 0.0, 1.0]), 8)
    shaft = (vertices - np.array([0.0, 0.0, vertices[:, 2].max()]), triangles)
    return {"shaft": shaft}


def build_syringe() -> dict[str, Mesh]:
    """10 ml, with a needle of 21 G (0.8 mm) and 40 mm."""
    barrel = lathe(
        [(0.00004, 0.0), (0.0004, -0.0022), (0.0004, -0.040), (0.0021, -0.0405), (0.0029, -0.050),
         (0.0026, -0.055), (0.0030, -0.057), (0.0079, -0.060), (0.0079, -0.138),
         (0.0135, -0.1385), (0.0135, -0.1405), (0.0079, -0.141)], 32
    )  # fmt: skip
    plunger = lathe([(0.0032, -0.1412), (0.0032, -0.172), (0.0100, -0.1725), (0.0100, -0.1755)], 32)
    return {"barrel": barrel, "plunger": plunger}
