# SPDX-License-Identifier: BSD-3-Clause
"""Which bodies are solved, where they are held, and where they are pressed and pulled."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from bodies import build_block, build_ellipsoid
from fill_organs import CELL_SIZE, FILLED, WALLS
from palpate_editor.truth.tetrahedra import Floats, Ints, find_surface, finish

HELD_PART = 0.2
"""Of the height: the surface triangles below are held."""

FACING = 0.7
"""Cosine between the direction to a place and its normal, at least."""


@dataclass(frozen=True)
class Place:
    """A patch of the surface that is moved as a whole along its normal."""

    name: str
    faces: Ints
    direction: Floats
    """Unit, outward."""
    thickness: float
    """[m] of the body under the patch."""


@dataclass(frozen=True)
class Subject:
    """A body to press."""

    title: str
    source: str
    x: Floats
    t: Ints
    directions: dict[str, tuple[float, float, float]]
    """Name of a place -> where it lies, seen from the middle of the body."""
    patch_radius: float
    """[m]"""
    young_modulus: float = 5e3
    """[Pa]"""
    poisson_ratio: float = 0.45
    wall_thickness: float | None = None
    """[m] of a hollow body, whose mesh is its wall."""
    same_mesh_depths: tuple[float, ...] = ()
    """Of the thickness, for P1 on the same mesh at the first place; the usual three if none."""
    shape: dict[str, str] | None = None
    """File and SHA-256 of the shipped surface that it was made from; None if from a formula."""

    @cached_property
    def faces(self) -> Ints:
        return find_surface(self.t)

    @cached_property
    def surface(self) -> Ints:
        return np.unique(self.faces)

    @cached_property
    def held(self) -> Ints:
        z = self.x[:, 2]
        low = z.min() + HELD_PART * (z[self.surface].max() - z.min())
        return self.faces[(z[self.faces] < low).all(axis=1)]

    @cached_property
    def places(self) -> list[Place]:
        return [find_place(self, name, direction) for name, direction in self.directions.items()]


def find_place(subject: Subject, name: str, direction: tuple[float, float, float]) -> Place:
    """The patch round the surface vertex in that direction, of triangles that face it."""
    x, faces = subject.x, subject.faces
    middle = 0.5 * (x[faces].reshape(-1, 3).min(axis=0) + x[faces].reshape(-1, 3).max(axis=0))
    normal = np.cross(x[faces[:, 1]] - x[faces[:, 0]], x[faces[:, 2]] - x[faces[:, 0]])
    normals = np.zeros_like(x)
    for corner in range(3):
        np.add.at(normals, faces[:, corner], normal)
    ahead = np.array(direction) / np.linalg.norm(direction)
    seen, looks = x[subject.surface] - middle, normals[subject.surface]
    slant = seen @ ahead / np.linalg.norm(seen, axis=1)
    slant[looks @ ahead < FACING * np.linalg.norm(looks, axis=1)] = -1.0
    centre = subject.surface[np.argmax(slant)]
    here = normals[centre] / np.linalg.norm(normals[centre])
    off = x - x[centre]
    beside = np.linalg.norm(off - np.outer(off @ here, here), axis=1) < subject.patch_radius
    near = np.linalg.norm(off, axis=1) < 1.5 * subject.patch_radius
    patch = faces[(beside & near)[faces].all(axis=1) & (normal @ here > 0.0)]
    if len(patch) < 4:
        raise ValueError(f"{subject.title}: patch {name!r} has {len(patch)} triangles, at least 4")
    held = np.intersect1d(patch, subject.held)
    if len(held):
        raise ValueError(f"{subject.title}: patch {name!r} touches the held triangles")
    return Place(name, patch, here, find_thickness(subject, int(centre), here))


def find_thickness(subject: Subject, centre: int, normal: Floats) -> float:
    """[m] along the inward normal of a surface vertex to where the body ends: a hollow one with
    its far wall."""
    x, faces = subject.x, subject.faces
    a, b, c = (x[faces[:, k]] for k in range(3))
    origin = x[centre] - 1e-5 * normal
    edges = np.stack([b - a, c - a, np.broadcast_to(normal, a.shape)], axis=2)
    crossed = np.abs(np.linalg.det(edges)) > 1e-15
    u, v, s = np.linalg.solve(edges[crossed], (origin - a[crossed])[..., None])[..., 0].T
    hit = (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1.0 + 1e-9) & (s > 0.0)
    last = np.min if subject.wall_thickness is None else np.max
    return float(last(s[hit])) + 1e-5


ROUND = {"top": (0.0, 0.0, 1.0), "side": (1.0, 0.0, 0.0), "shoulder": (0.6, 0.5, 0.62)}


def ellipsoid() -> Subject:
    x, t, _ = read_filled("ellipsoid")
    return Subject(
        title="ellipsoid, 100 x 70 x 60 mm",
        source=f"tests/references/fill_organs.py ellipsoid: {describe_cells('ellipsoid')}",
        x=x,
        t=t,
        directions=ROUND,
        patch_radius=0.014,
        same_mesh_depths=(0.03, 0.05, 0.08, 0.10, 0.15, 0.20, 0.25),
    )


def sphere() -> Subject:
    x, t = build_ellipsoid((0.04, 0.04, 0.04), 6)
    return Subject(
        title="sphere of radius 40 mm",
        source="tests/references/bodies.py build_ellipsoid((0.04, 0.04, 0.04), 6)",
        x=x,
        t=t,
        directions=ROUND,
        patch_radius=0.0165,
    )


def block() -> Subject:
    x, t = build_block((0.08, 0.08, 0.04), (8, 8, 4))
    return Subject(
        title="block, 80 x 80 x 40 mm",
        source="tests/references/bodies.py build_block((0.08, 0.08, 0.04), (8, 8, 4))",
        x=x,
        t=t,
        directions={"top": (0.0, 0.0, 1.0), "beside": (0.5, 0.3, 0.75), "side": (1.0, 0.0, 0.1)},
        patch_radius=0.015,
    )


AROUND = {"outside": (0.9, 0.0, 0.3), "front": (0.0, -1.0, 0.2)}
ORGANS = {
    "spleen": ("Spleen", 10e3, 0.013, {"top": (0.0, 0.0, 1.0), **AROUND}),
    "kidney": ("Kidney", 5e3, 0.0125, {"top": (0.0, 0.0, 1.0), **AROUND}),
    "liver": ("Liver", 5e3, 0.024, {"top": (0.0, 0.0, 1.0), **AROUND}),
    "gallbladder": ("Gallbladder, its wall", 250e3, 0.0075, {**AROUND, "back": (0.0, 1.0, 0.2)}),
    "stomach": ("Stomach, its wall", 50e3, 0.0125, {**AROUND, "back": (0.0, 1.0, 0.2)}),
}
"""The shipped organs: title, Young's modulus [Pa] of tissues.toml, patch radius [m], places."""


def describe_cells(name: str) -> str:
    return f"cells of {1e3 * CELL_SIZE[name]:g} mm"


def read_filled(name: str) -> tuple[Floats, Ints, str]:
    """Vertices [m], tetrahedra, and the SHA-256 of the shipped surface; "" where there is none."""
    filled = FILLED / f"{name}.npz"
    if not filled.is_file():
        raise SystemExit(f"{filled} is missing: .venv/bin/python tests/references/fill_organs.py")
    body = np.load(filled)
    return *finish(body["vertices"], body["tetrahedra"]), str(body["sha256"])


def organ(name: str) -> Subject:
    title, young_modulus, patch_radius, directions = ORGANS[name]
    count, wall = WALLS.get(name, (None, None))
    how = describe_cells(name) if wall is None else f"{count} vertices"
    x, t, sha256 = read_filled(name)
    return Subject(
        title=title,
        source=f"tests/references/fill_organs.py {name}: {how}",
        shape={"file": f"{name}.obj", "sha256": sha256},
        x=x,
        t=t,
        directions=directions,
        patch_radius=patch_radius,
        young_modulus=young_modulus,
        wall_thickness=wall,
    )


BODIES: dict[str, Callable[[], Subject]] = {
    "block": block,
    "ellipsoid": ellipsoid,
    "sphere": sphere,
    **{name: partial(organ, name) for name in ORGANS},
}
