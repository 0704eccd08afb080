# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that a ball is pressed into, and the places where."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from bodies import Floats, Ints, build_block, find_surface
from fill_contacts import CELLS, CONTACTS, WALLS
from graded import Grading, Skin, refine

SIZES = (2.0, 2.8, 4.0)
"""Edges within the radius of the ball, near the place: from the coarsest mesh to the finest."""
SLOPE = (1.1, 0.8, 0.6)
"""By how much edges grow per distance."""
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


@dataclass(frozen=True)
class Subject:
    """A body, its surface, and what of it is held."""

    title: str
    young_modulus: float
    surface: Skin
    spots: tuple[Spot, ...]
    build: Callable[[int], tuple[Floats, Ints]]
    """The mesh of a level, before it is graded."""
    held: Callable[[Floats, Ints], Ints]
    """Of a mesh's boundary facets, those that are held."""
    snapped: bool = True
    """What is new on the surface of the mesh goes to the shipped surface."""
    poisson_ratio: float = 0.45
    shape: dict[str, str] | None = None
    wall_thickness: float | None = None
    held_by: str = ""
    fixed: Ints | None = None
    """Vertices of the shipped surface that the published scene holds."""
    source: str = ""

    def grade(self, spot: Spot, radius: float, depth: float, level: int) -> tuple[Floats, Ints]:
        """The mesh of a level with small tetrahedra where the ball touches."""
        grading = Grading(
            spot.point,
            radius / SIZES[level],
            min(1.1 * radius, 1.5 * float(np.sqrt(radius * depth))),
            SLOPE[level],
        )
        return refine(*self.build(level), grading, self.surface if self.snapped else None)


def build_blocks() -> Subject:
    """The block of 100 x 100 x 50 mm, held below."""
    size = (0.1, 0.1, 0.05)
    x, t = build_block(size, (1, 1, 1))
    up = np.array([0.0, 0.0, 1.0])
    spots = {"middle": (0.0, 0.0), "between": (0.017, 0.011), "near a side": (0.034, -0.008)}
    return Subject(
        title="block, 100 x 100 x 50 mm",
        young_modulus=5e3,
        surface=Skin(x, find_surface(t)),
        spots=tuple(
            Spot(name, np.array([*at, size[2]]), up, size[2]) for name, at in spots.items()
        ),
        build=lambda level: build_block(size, ((8, 8, 4), (10, 10, 5), (12, 12, 6))[level]),
        held=lambda x, faces: faces[(x[faces][:, :, 2] < 1e-6).all(axis=1)],
        snapped=False,
        held_by="the whole base",
        source="tests/references/bodies.py build_block",
    )


def build_layer() -> Subject:
    """A layer of 20 mm, held below: for the formulas that it is checked against."""
    size = (0.1, 0.1, 0.02)
    x, t = build_block(size, (1, 1, 1))
    return Subject(
        title="layer, 100 x 100 x 20 mm",
        young_modulus=5e3,
        surface=Skin(x, find_surface(t)),
        spots=(Spot("middle", np.array([0.0, 0.0, 0.02]), np.array([0.0, 0.0, 1.0]), 0.02),),
        build=lambda level: build_block(size, ((8, 8, 2), (10, 10, 3), (14, 14, 4))[level]),
        held=lambda x, faces: faces[(x[faces][:, :, 2] < 1e-6).all(axis=1)],
        snapped=False,
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
}
"""The shipped organs: title, Young's modulus [Pa] of tissues.toml, where they are pressed."""


def organ(name: str) -> Subject:
    title, young_modulus, directions = ORGANS[name]
    path = CONTACTS / f"{name}.npz"
    if not path.is_file():
        raise SystemExit(f"{path} is missing: .venv/bin/python tests/references/fill_contacts.py")
    data = dict(np.load(path))
    skin = Skin(data["x"], data["triangles"].astype(np.int64))
    fixed, wall = data["fixed"], WALLS.get(name)
    last = len(CELLS[name]) - 1 if name in CELLS else 0
    bodies = [
        (data[f"vertices{k}"], data[f"tetrahedra{k}"].astype(np.int64)) for k in range(last + 1)
    ]
    return Subject(
        title=title,
        young_modulus=young_modulus,
        surface=skin,
        spots=tuple(
            find_spot(skin, fixed, at, direction, wall is not None)
            for at, direction in directions.items()
        ),
        build=lambda level: bodies[min(level, last)],
        held=lambda x, faces: find_held(skin, fixed, x, faces, wall),
        snapped=wall is None,
        shape={"file": f"{name}.obj", "sha256": str(data["sha256"])},
        wall_thickness=wall,
        held_by=f"the {len(fixed)} vertices that the published scene holds",
        fixed=np.sort(fixed),
        source=f"tests/references/fill_contacts.py {name}",
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


def find_thickness(skin: Skin, point: Floats, direction: Floats, hollow: bool) -> float:
    """[m] from the place along the press to where the body ends."""
    a, b, c = (skin.x[skin.triangles[:, k]] for k in range(3))
    origin = point - 1e-5 * direction
    edges = np.stack([b - a, c - a, np.broadcast_to(direction, a.shape)], axis=2)
    crossed = np.abs(np.linalg.det(edges)) > 1e-15
    u, v, s = np.linalg.solve(edges[crossed], (origin - a[crossed])[..., None])[..., 0].T
    hit = (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1.0 + 1e-9) & (s > 0.0)
    return float((np.max if hollow else np.min)(s[hit])) + 1e-5


def find_held(skin: Skin, fixed: Ints, x: Floats, faces: Ints, wall: float | None) -> Ints:
    """Facets over triangles of the surface whose three corners the scene holds.

    A wall is held through its thickness: the inner facets under such triangles too.
    """
    middle = x[faces].mean(axis=1)
    closest, triangle = skin.project(middle)
    on = np.isin(skin.triangles[triangle], fixed).all(axis=1)
    if wall is not None:
        on &= np.linalg.norm(middle - closest, axis=1) < 1.05 * wall
    return faces[on]


SUBJECTS: dict[str, Callable[[], Subject]] = {
    "block": build_blocks,
    "layer": build_layer,
    **{name: (lambda name=name: organ(name)) for name in ORGANS},
}
