# SPDX-License-Identifier: BSD-3-Clause
"""Bodies and hands of the failure catalogue, core/STABILITY.md: one file for each of its rows."""

from __future__ import annotations

import itertools
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import numpy as np
import palpate
from palpate.runs.press import Place, find_top
from palpate.runs.run import read_scene

CHECKOUT = Path(__file__).resolve().parents[2]
sys.path.append(str(CHECKOUT / "tests" / "bindings"))
from surfaces import ellipsoid  # noqa: E402

PUBLISHED, SPRINGS = CHECKOUT / "meshes" / "published", Path(__file__).with_name("springs")
WALL = palpate.Material(damping_ratio=0.2, wall_thickness=3e-3, young_modulus=5e4)
NONE = palpate.AlarmKind.none
HOME = 1e5
"""[N/m³]"""
TICK = 1e-3
"""[s]"""


def make_ball(subdivisions: int = 2, radii: tuple[float, float, float] = (0.03, 0.025, 0.02)):
    """A closed ellipsoid around the origin: an icosahedron divided `subdivisions` times."""
    return ellipsoid(radii, subdivisions)


def make_block(cells: tuple[int, int, int] = (3, 3, 2), sides=(0.06, 0.06, 0.04)):
    """A box around the origin, its cells cut into six tetrahedra each."""
    nx, ny, nz = cells
    at = np.array(list(itertools.product(range(nz + 1), range(ny + 1), range(nx + 1))))[:, ::-1]
    points = (at / cells - 0.5) * sides

    def number(p: np.ndarray) -> int:
        return int((p[2] * (ny + 1) + p[1]) * (nx + 1) + p[0])

    tetrahedra = []
    for cell in itertools.product(range(nx), range(ny), range(nz)):
        for way in itertools.permutations(range(3)):
            corner = np.array(cell)
            row = [number(corner)]
            for axis in way:
                corner = corner + np.eye(3, dtype=int)[axis]
                row.append(number(corner))
            a, b, c, d = points[row]
            if np.dot(np.cross(b - a, c - a), d - a) < 0.0:
                row[1], row[2] = row[2], row[1]
            tetrahedra.append(row)
    return palpate.SolidMesh(points, tetrahedra)


def hold_lowest(points: np.ndarray, share: float = 0.2) -> list[int]:
    z = np.asarray(points)[:, 2]
    return np.flatnonzero(z < z.min() + share * np.ptp(z)).tolist()


def make_options(mesh: palpate.SurfaceMesh, fixed: list[int] | None) -> palpate.SurfaceOptions:
    """Held where it is lowest unless vertices are given."""
    held = hold_lowest(mesh.vertices) if fixed is None else fixed
    # a builder's own home springs follow from the box around a body, which turns with it
    return palpate.SurfaceOptions(fixed=held, drag=8.0, home_stiffness=HOME)


def make_springs(mesh: palpate.SurfaceMesh, fixed: list[int] | None = None):
    return palpate.build_mass_spring(mesh, WALL, 60.0, make_options(mesh, fixed))


def make_molecules(
    mesh: palpate.SurfaceMesh, fixed: list[int] | None = None, law=palpate.AngleLaw.gradient
):
    gradient = law == palpate.AngleLaw.gradient
    constants = palpate.MolecularConstants(
        bond_stiffness=60.0,
        bend_stiffness=1e-4 if gradient else 0.02,
        stretch_coupling=1e-2 if gradient else 0.0,
        angle_law=law,
    )
    return palpate.build_molecular(mesh, WALL, constants, make_options(mesh, fixed))


def make_wall(mesh: palpate.SurfaceMesh, fixed: list[int] | None = None):
    """Held at its outer face."""
    options = make_options(mesh, fixed)
    options.home_stiffness = 0.0
    return palpate.build_shell(mesh, WALL, options)


def make_solid(
    build: Callable[..., palpate.TissueModel],
    solid: palpate.SolidMesh,
    fixed: list[int] | None = None,
):
    held = hold_lowest(solid.vertices) if fixed is None else fixed
    options = palpate.SolidOptions(fixed=held, drag=8.0)
    return build(solid, palpate.Material(damping_ratio=0.2), options)


SURFACES = {
    "springs": make_springs,
    "molecules": make_molecules,
    "molecules of Eq 10": partial(make_molecules, law=palpate.AngleLaw.eq10),
    "a wall of prisms": make_wall,
}
"""Law -> builds it on a surface."""
SOLIDS = {
    "springs and volumes": palpate.build_solid,
    "corotated": palpate.build_corotated_solid,
    "neo-Hookean": palpate.build_neo_hookean_solid,
    "linear": palpate.build_linear_solid,
}
"""Law -> builds it of tetrahedra."""


def make_scene(tissue: palpate.TissueModel, rate: float = 1000.0, **body: object) -> palpate.Scene:
    soft = palpate.SoftBody(tissue=tissue)
    for name, value in body.items():
        setattr(soft, name, value)
    return palpate.build_scene(palpate.Scene(bodies=[soft], rate=rate))


def open_organ(name: str) -> palpate.Scene:
    return read_scene(PUBLISHED / f"{name}.palpate")


def open_springs(name: str) -> palpate.Scene:
    return read_scene(SPRINGS / f"{name}.palpate")


@dataclass
class Hand:
    """A hand at a place of a scene's first body, and what it felt tick by tick."""

    scene: palpate.Scene
    place: Place | None = None
    force: list[np.ndarray] = field(default_factory=list)
    """[N] (3,)"""

    def __post_init__(self) -> None:
        self.world = palpate.World(self.scene, recovers=False)
        self.place = self.place or find_top(self.scene)
        self.time = 0.0

    def stay(self, depth: float, seconds: float, aside: float = 0.0, dt: float | None = None):
        """Holds the tip `depth` [m] deep in the surface at rest."""
        self.go(depth, depth, seconds, aside, dt)
        return self

    def go(self, start: float, end: float, seconds: float, aside: float = 0.0, dt=None):
        """From one depth to another, evenly. Raises RuntimeError for an alarm."""
        assert self.place is not None
        dt = 1.0 / self.scene.rate if dt is None else dt
        radius = self.scene.instruments[0].tool.radius
        along = np.cross(self.place.outward, [0.31, 0.53, 0.79])
        count = max(1, round(seconds / dt))
        for k in range(1, count + 1):
            depth = start + (end - start) * k / count
            sample = palpate.HapticSample()
            sample.time = self.time
            sample.position = (
                self.place.point + (radius - depth) * self.place.outward + aside * along
            )
            self.time += dt
            self.force.append(np.array(palpate.tick(self.scene, sample, dt, self.world).force))
            if self.world.alarm.kind != NONE:
                raise RuntimeError(f"{self.world.alarm.kind.name} at {self.time:.3f} s")
        return self

    def mean(self, ticks: int) -> float:
        """[N] outwards, over the last ticks."""
        assert self.place is not None
        return float(np.mean(np.array(self.force[-ticks:]) @ self.place.outward))
