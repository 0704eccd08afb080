# SPDX-License-Identifier: BSD-3-Clause
"""From the OpenSCAD sources to printable parts, and to a picture of the whole device.

    python firmware/mechanics/build_parts.py --out build/mechanics [--picture FILE.png]

Parts whose sources have not changed since they were written are left as they are.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ROOM = Path(__file__).parent
SOURCES = ("parameters.scad", "shapes.scad", "parts.scad")
NAMES = tuple(
    re.findall(
        r'^(?:else )?if \(part == "(\w+)"\)',
        (ROOM / "parts.scad").read_text(encoding="utf-8"),
        re.M,
    )
)
HOME = (0.0, 30.0, 30.0)
"""[degrees] Yaw, elevation, forearm from straight down."""
CLEARANCE = 0.02
"""[mm] Between parts that are screwed together, so that a test sees no overlap in them."""


@dataclass(frozen=True)
class Solid:
    """A printed part: corners [mm] (n, 3) and triangles (t, 3), outward."""

    vertices: Array
    triangles: NDArray[np.int32]


def read_parameters() -> dict[str, float]:
    """Every single number of parameters.scad, by name."""
    text = (ROOM / "parameters.scad").read_text(encoding="utf-8")
    return {k: float(v) for k, v in re.findall(r"^(\w+) = (-?[\d.]+);", text, re.M)}


def build_part(name: str, out: Path) -> Path:
    """Writes NAME.stl into a folder, unless it is there and made of the same sources.

    Raises SystemExit with OpenSCAD's words where it fails.
    """
    key = hashlib.sha256(b"".join((ROOM / source).read_bytes() for source in SOURCES)).hexdigest()
    target, mark = out / f"{name}.stl", out / f"{name}.sha256"
    if target.exists() and mark.exists() and mark.read_text(encoding="utf-8") == key:
        return target
    out.mkdir(parents=True, exist_ok=True)
    new = out / f"{name}.new.stl"
    try:
        done = subprocess.run(
            ["openscad", "-q", "-D", f'part="{name}"', "-o", new, ROOM / "parts.scad"],
            capture_output=True,
            encoding="utf-8",
            env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        )
    except FileNotFoundError:
        sys.exit("openscad is not installed; it is a Debian package (packages.txt)")
    if done.returncode != 0 or not new.exists():
        sys.exit(f"{name}: openscad could not make it\n{done.stderr}")
    os.replace(new, target)
    mark.write_text(key, encoding="utf-8")
    return target


def read_solid(path: Path) -> Solid:
    """The text STL that OpenSCAD writes, corners joined where they are the same."""
    corners = re.findall(r"vertex (\S+) (\S+) (\S+)", path.read_text(encoding="ascii"))
    vertices, ids = np.unique(np.array(corners, dtype=float), axis=0, return_inverse=True)
    return Solid(vertices, ids.reshape(-1, 3).astype(np.int32))


# ------------------------------------------------------------------ how they stand together


def shift(x: float, y: float, z: float) -> Array:
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def turn(axis: str, degrees: float) -> Array:
    """About x, y or z, counter-clockwise seen from the axis's end."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    matrix = np.eye(4)
    matrix[i, i], matrix[i, j], matrix[j, i], matrix[j, j] = c, -s, s, c
    return matrix


def place_parts(
    yaw: float, elevation: float, forearm: float, gimbal: tuple[float, float] = (0.0, -60.0)
) -> dict[str, tuple[str, Array]]:
    """Where each part stands [mm, degrees]: name of the place -> part, and its (4, 4) matrix.

    The frame: z up from the table, x to the user, the yaw axis through the origin. Flat parts lie
    in a plane that stands up: their z points to -y.
    """
    k = read_parameters()
    deck = k["base_plate"] + k["column_height"] + 2 * CLEARANCE
    floor = deck + k["deck_plate"] + 4 + k["gap"] + k["plate"] + k["floor_plate"]
    turret = turn("z", yaw)
    axle = turret @ shift(0, 0, floor + k["axle_over_floor"])
    upright = turn("x", 90)
    side = k["gap"] + k["plate"] / 2
    arm, crank = turn("z", elevation), turn("z", forearm + 90)
    elbow = axle @ upright @ arm @ shift(k["upper_arm"], 0, 0) @ turn("z", forearm - 90 - elevation)
    tip = elbow @ shift(k["forearm"], 0, 0)
    cross = axle @ upright @ crank @ shift(k["crank_length"], 0, 0)
    pulley = k["sector_radius"] + k["cable"] + k["pulley_radius"]
    angle = np.radians(k["motor_angle"])
    motor = axle @ shift(pulley * np.cos(angle), 0, pulley * np.sin(angle))
    reach = side + k["plate"] + k["pulley_flange"] + 0.5
    along = tip @ turn("y", 90) @ turn("z", 90) @ turn("z", gimbal[0])
    yoke = along @ shift(0, 0, -30.0)
    ring = along @ turn("x", gimbal[1])
    return {
        "base": ("base", shift(0, 0, 0)),
        "column": ("column", shift(0, 0, k["base_plate"] + CLEARANCE)),
        "deck": ("deck", shift(0, 0, deck)),
        "turret": ("turret", turret @ shift(0, 0, floor - k["plate"] - k["floor_plate"])),
        "upper_arm": (
            "upper_arm",
            axle @ shift(0, side + k["plate"], 0) @ upright @ arm @ turn("z", 40),
        ),
        "crank": ("crank", axle @ shift(0, -side, 0) @ upright @ crank),
        "coupler": (
            "coupler",
            cross
            @ turn("z", elevation - forearm - 90)
            @ shift(0, 0, side + k["plate"] + k["gap"] + 8)
            @ turn("x", 180),
        ),
        "forearm": ("forearm", elbow @ shift(0, 0, -k["plate"] / 2)),
        "yoke": ("yoke", yoke),
        "ring": ("ring", ring @ shift(0, 0, -7)),
        "stylus": ("stylus", ring @ shift(0, 0, -38)),
        "pulley_elevation": ("pulley", motor @ shift(0, reach, 0) @ turn("x", 90)),
        "pulley_forearm": ("pulley", motor @ shift(0, -reach, 0) @ turn("x", -90)),
        "pulley_yaw": ("pulley", shift(-pulley, 0, deck + k["deck_plate"] + 1.5)),
    }


def assemble(solids: dict[str, Solid], *pose: float) -> dict[str, Solid]:
    """Every part where it stands at a pose [degrees], by the name of its place."""
    placed = {}
    for place, (name, matrix) in place_parts(*pose).items():
        solid = solids[name]
        placed[place] = Solid(solid.vertices @ matrix[:3, :3].T + matrix[:3, 3], solid.triangles)
    return placed


# ------------------------------------------------------------------ the picture

COLOURS = {
    "base": (0.30, 0.32, 0.36),
    "column": (0.36, 0.38, 0.43),
    "deck": (0.30, 0.32, 0.36),
    "turret": (0.62, 0.65, 0.70),
    "upper_arm": (0.90, 0.48, 0.18),
    "crank": (0.25, 0.52, 0.78),
    "coupler": (0.25, 0.52, 0.78),
    "forearm": (0.90, 0.48, 0.18),
    "yoke": (0.93, 0.83, 0.42),
    "ring": (0.62, 0.65, 0.70),
    "stylus": (0.22, 0.24, 0.27),
}
BRASS = (0.80, 0.65, 0.30)


def draw_device(solids: dict[str, Solid], path: Path, size: tuple[int, int] = (1200, 900)) -> None:
    """The whole device at its home pose, by palpate's own renderer."""
    from palpate.render import Appearance, Camera, write_png
    from palpate.render.studio import Shot, Thing, take_picture
    from palpate.render.theme import THEMES

    things = []
    for place, solid in assemble(solids, *HOME).items():
        corners = 1e-3 * solid.vertices[solid.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
        soup = corners.reshape(-1, 3)
        appearance = Appearance(COLOURS.get(place, BRASS), gloss=0.25, subsurface=0.0)
        faces = np.arange(len(soup), dtype=np.int32).reshape(-1, 3)
        things.append(Thing(soup, np.repeat(normals, 3, axis=0), faces, appearance))
    camera = Camera(azimuth=np.radians(-58), elevation=np.radians(18))
    points = np.concatenate([thing.vertices for thing in things])
    camera.fit(points, size, (60, 50, size[0] - 60, size[1] - 50))
    shot = Shot(camera, size, 2, THEMES["light"], None, 0.0)
    write_png(path, take_picture(things, shot))


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=Path("build/mechanics"))
    parser.add_argument("--picture", type=Path, metavar="FILE.png")
    options = parser.parse_args(arguments)
    solids = {}
    for name in NAMES:
        solids[name] = read_solid(build_part(name, options.out))
        low, high = solids[name].vertices.min(axis=0), solids[name].vertices.max(axis=0)
        print(f"{name:14} {' x '.join(f'{x:.0f}' for x in high - low):>15} mm")
    if options.picture:
        draw_device(solids, options.picture)


if __name__ == "__main__":
    main()
