# SPDX-License-Identifier: BSD-3-Clause
"""Makes the scene of a kidney stone: `python -m palpate_meshes.stone_scene`.

The kidney lies as in a supine patient, its access tract nearly level; the stone lies
in the lower calyx, and a tray stands beneath the way by which it is drawn out.
"""

from __future__ import annotations

import sys

import numpy as np
from palpate.cli.main import main as palpate
from palpate.scene.mesh_file import read_mesh_file
from palpate_meshes.catalogue import PUBLISHED
from palpate_meshes.generate import write_obj
from palpate_meshes.generate.collecting_system import ENTRY, MOUTH
from scipy.spatial.transform import Rotation

SCENES = PUBLISHED.parent / "scenes"
NAME, STONE = "kidney_stone_removal", "stone.obj"
RISE = np.radians(12.0)
"""Of the tract, from the calyx to its mouth."""
STONE_SIZE = 0.8
"""[-] Of the stone that ships, which is 10.4 mm long; then 8.4 x 7.3 x 6.1 mm and 0.3 g."""
STONE_AT, STONE_TURN = "12.984,-17.714,-3.865", "17.165,7.087,-6.455"
"""[mm] and [degree] As it comes to rest where it is let fall from 0.7 mm higher in the
weightless kidney."""
TRAY, TRAY_HALF, TRAY_DEPTH, TRAY_WALL = (0.085, -0.017, -0.025), 0.02, 0.006, 0.002
"""[m] The middle of its floor, half a side, the height of its rim over the floor, its thickness."""
PORT = 0.08
"""[m] Along the tract from its mouth: where the shaft passes the skin."""
WORDS = {
    "title": "Kidney stone",
    "task": "Go in through the tract, take the stone between the jaws, draw it out and put it "
            "into the tray.",
    "title-tr": "Böbrek taşı",
    "task-tr": "Giriş yolundan girin, taşı çenelerin arasına alın, dışarı çekip kaba bırakın.",
}  # fmt: skip

Array = np.ndarray


def find_turn() -> Rotation:
    """From the organ's frame to the scene's, where z is up and the tract goes towards x."""
    along = np.subtract(MOUTH, ENTRY) / np.linalg.norm(np.subtract(MOUTH, ENTRY))
    level = np.array([0.0, 1.0, 0.0]) - along[1] * along  # towards the muscles of the back
    down = np.cos(RISE) * level / np.linalg.norm(level) - np.sin(RISE) * along
    outwards = along - (along @ down) * down
    outwards /= np.linalg.norm(outwards)
    return Rotation.from_matrix(np.stack([outwards, np.cross(-down, outwards), -down]))


def make_tray() -> tuple[Array, Array]:
    """A square dish with a floor, four walls and a rim: vertices [m] and triangles, closed."""
    outer, inner = TRAY_HALF, TRAY_HALF - TRAY_WALL
    rings = [(outer, -TRAY_WALL), (outer, TRAY_DEPTH), (inner, TRAY_DEPTH), (inner, 0.0)]
    x = [(a * s, a * t, z) for a, z in rings for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    triangles = [(0, 2, 1), (0, 3, 2)]  # from below
    for ring in range(3):
        for k in range(4):
            a, b = 4 * ring + k, 4 * ring + (k + 1) % 4
            triangles += [(a, b, b + 4), (a, b + 4, a + 4)]
    triangles += [(12, 13, 14), (12, 14, 15)]
    return np.array(x) + TRAY, np.array(triangles)


def say(point: Array) -> str:
    return ",".join(f"{1e3 * x:.3f}" for x in point)


def main() -> int:
    """Writes the tray, the layout and what is published of it."""
    layout, stone, tray = (
        SCENES / name for name in (f"{NAME}.layout.json", "stone.obj", "tray.obj")
    )
    turn = find_turn()
    calyx, mouth = 1e-3 * turn.apply(ENTRY), 1e-3 * turn.apply(MOUTH)
    port = mouth + PORT * (mouth - calyx) / np.linalg.norm(mouth - calyx)
    write_obj(tray, *make_tray())
    shipped = read_mesh_file(PUBLISHED / "kidney_stone.obj")
    write_obj(stone, STONE_SIZE * np.asarray(shipped.vertices), np.asarray(shipped.triangles))
    angles = ",".join(f"{a:.6f}" for a in turn.as_euler("xyz", degrees=True))
    words = [word for name, text in WORDS.items() for word in (f"--{name}", text)]
    steps = [
        ["new", "-o", layout, *words, "--gravity=0,0,-9.81", "--fluid", "1000,0.001"],
        ["add", layout, PUBLISHED / "collecting_system.palpate", "--name", "kidney",
         f"--turn={angles}", "--weightless"],
        ["add", layout, stone, "--as", "stone", "--name", "stone",
         "--at", STONE_AT, "--turn", STONE_TURN],
        ["add", layout, tray, "--as", "scenery", "--name", "tray"],
        ["tool", layout, "--kind", "grasper", "--radius", "1.2mm", "--length", "10mm",
         "--jaw-opening", "0.4", "--friction", "0.6", "--grip-force", "3N",
         f"--trocar={say(port)}"],
        ["publish", layout, "-o", SCENES / f"{NAME}.palpate"],
    ]  # fmt: skip
    for step in steps:
        code = palpate(["scene", *map(str, step)])
        if code:
            return code
    return 0


if __name__ == "__main__":
    sys.exit(main())
