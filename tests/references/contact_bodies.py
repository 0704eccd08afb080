# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that a ball is pressed into, and the places where."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from bodies import build_block
from fill_contacts import CELLS, CONTACTS, SURFACES, WALLS
from palpate_editor.truth.contact import find_touch
from palpate_editor.truth.graded import Skin
from palpate_editor.truth.levels import Station
from palpate_editor.truth.subject import Subject, find_held, find_thickness
from palpate_editor.truth.tetrahedra import Floats, Ints, find_surface

POISSON_RATIO = 0.45
AROUND_PLACE = 5e-3
"""[m] The direction of a press is the mean normal of the surface this far around the place."""
FROM_HELD = 0.012
"""[m] A place is at least this far from what is held."""
FACING = 0.7


@dataclass(frozen=True)
class Spot:
    """Where a ball is pressed, and from where."""

    name: str
    point: Floats
    direction: Floats
    thickness: float
    """[m] of the body under the place; a hollow one with its far wall."""

    def stand(self, subject: Subject, radius: float) -> Station:
        """A ball of a radius [m] at the place."""
        skin = subject.surface
        touch = find_touch(skin.x, skin.triangles, self.point, self.direction, radius)
        return Station(self.point, self.direction, touch, self.thickness)


@dataclass(frozen=True)
class Pressed:
    """A body, where it is pressed, and what is told of it."""

    title: str
    subject: Subject
    spots: tuple[Spot, ...]
    held_by: str
    source: str
    fixed: Ints | None = None
    """Vertices of the shipped surface that the published scene holds; None for a formula's body."""
    shape: dict[str, str] | None = None


def build_blocks() -> Pressed:
    """The block of 100 x 100 x 50 mm, held below."""
    size = (0.1, 0.1, 0.05)
    spots = {"middle": (0.0, 0.0), "between": (0.017, 0.011), "near a side": (0.034, -0.008)}
    cells = ((8, 8, 4), (10, 10, 5), (12, 12, 6))
    return press_box("block, 100 x 100 x 50 mm", size, spots, cells)


def build_layer() -> Pressed:
    """A layer of 20 mm, held below: for the formulas that it is checked against."""
    cells = ((8, 8, 2), (10, 10, 3), (14, 14, 4))
    return press_box("layer, 100 x 100 x 20 mm", (0.1, 0.1, 0.02), {"middle": (0.0, 0.0)}, cells)


def press_box(
    title: str,
    size: tuple[float, float, float],
    spots: dict[str, tuple[float, float]],
    cells: tuple[tuple[int, int, int], ...],
) -> Pressed:
    """A box on its base, pressed from above; `cells` of every level."""
    x, t = build_block(size, (1, 1, 1))
    up = np.array([0.0, 0.0, 1.0])
    subject = Subject(
        surface=Skin(x, find_surface(t)),
        young_modulus=5e3,
        poisson_ratio=POISSON_RATIO,
        build=lambda level: build_block(size, cells[level]),
        held=lambda x, faces: faces[(x[faces][:, :, 2] < 1e-6).all(axis=1)],
        fixed=np.flatnonzero(x[:, 2] < 1e-6),
        is_snapped=False,
    )
    return Pressed(
        title=title,
        subject=subject,
        spots=tuple(
            Spot(name, np.array([*at, size[2]]), up, size[2]) for name, at in spots.items()
        ),
        held_by="the whole base",
        source="tests/references/bodies.py build_block",
    )


AROUND = {"outside": (0.9, 0.0, 0.3), "front": (0.0, -1.0, 0.2)}
TOP = {"top": (0.0, 0.0, 1.0)}
ORGANS = {
    "spleen": ("Spleen", 10e3, {**TOP, **AROUND}),
    "kidney": ("Kidney", 5e3, {**TOP, **AROUND}),
    "liver": ("Liver", 5e3, {**TOP, **AROUND}),
    "gallbladder": ("Gallbladder, its wall", 250e3, {**AROUND, "inside": (-0.9, -0.3, 0.1)}),
    "stomach": ("Stomach, its wall", 50e3, {**AROUND, "back": (0.0, 1.0, 0.2)}),
    "wall_2mm": ("Gallbladder, a wall of 2 mm", 250e3, {"outside": AROUND["outside"]}),
}
"""The shipped organs: title, Young's modulus [Pa] of tissues.toml, where they are pressed; and the
wall that other engines are compared on."""


def organ(name: str) -> Pressed:
    title, young_modulus, directions = ORGANS[name]
    path = CONTACTS / f"{name}.npz"
    if not path.is_file():
        raise SystemExit(f"{path} is missing: .venv/bin/python tests/references/fill_contacts.py")
    data = dict(np.load(path))
    skin = Skin(data["x"], data["triangles"].astype(np.int64))
    fixed, wall = data["fixed"].astype(np.int64), WALLS.get(name)
    last = len(CELLS[name]) - 1 if name in CELLS else 0
    bodies = [
        (data[f"vertices{k}"], data[f"tetrahedra{k}"].astype(np.int64)) for k in range(last + 1)
    ]
    subject = Subject(
        surface=skin,
        young_modulus=young_modulus,
        poisson_ratio=POISSON_RATIO,
        build=lambda level: bodies[min(level, last)],
        held=lambda x, faces: find_held(skin, fixed, x, faces, wall),
        fixed=fixed,
        wall_thickness=wall,
        is_snapped=wall is None,
    )
    return Pressed(
        title=title,
        subject=subject,
        spots=tuple(
            find_spot(skin, fixed, at, direction, wall is not None)
            for at, direction in directions.items()
        ),
        held_by=f"the {len(fixed)} vertices that the published scene holds",
        source=f"tests/references/fill_contacts.py {name}",
        fixed=np.sort(fixed),
        shape={"file": f"{SURFACES.get(name, name)}.obj", "sha256": str(data["sha256"])},
    )


def find_spot(skin: Skin, fixed: Ints, name: str, toward: tuple, hollow: bool) -> Spot:
    """The middle of the triangle that lies in that direction and faces it, away from the held."""
    x, triangles = skin.x, skin.triangles
    corners = x[triangles]
    centre = corners.mean(axis=1)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    unit = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    ahead = np.array(toward) / np.linalg.norm(toward)
    seen = centre - 0.5 * (x.min(axis=0) + x.max(axis=0))
    slant = seen @ ahead / np.linalg.norm(seen, axis=1)
    slant[unit @ ahead < FACING] = -1.0
    off = np.linalg.norm(centre[:, None] - x[fixed], axis=2).min(axis=1)
    slant[off < FROM_HELD] = -1.0
    at = int(slant.argmax())
    around = np.linalg.norm(centre - centre[at], axis=1) < AROUND_PLACE
    around &= unit @ unit[at] > 0.5
    direction = normal[around].sum(axis=0)
    direction /= np.linalg.norm(direction)
    return Spot(name, centre[at], direction, find_thickness(skin, centre[at], direction, hollow))


SUBJECTS: dict[str, Callable[[], Pressed]] = {
    "block": build_blocks,
    "layer": build_layer,
    **{name: (lambda name=name: organ(name)) for name in ORGANS},
}
