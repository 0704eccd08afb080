# SPDX-License-Identifier: BSD-3-Clause
"""Stones and scenery of a layout, from their meshes to what a scene has of them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import palpate
from palpate.files.refusal import Refusal
from palpate.layout.document import Layout, PlacedMesh, PlacedScenery, PlacedStone
from palpate.layout.placed import move_points
from palpate.layout.stone import Hull, fit_hull, measure_mass
from palpate.scene.mesh_file import read_mesh_file
from palpate.scene.scene_file import hash_file

SHORTEST_STONE, LONGEST_STONE = 5e-4, 0.3
SHORTEST_SCENERY, LONGEST_SCENERY = 1e-3, 5.0
"""[m] Beyond these a unit was mistaken."""


@dataclass(frozen=True)
class Stone:
    """A stone as it stands."""

    body: palpate.RigidBody
    hull: Hull
    """In the frame of the mesh."""
    length: float
    """[m] the longest side of the mesh."""


def read_part_mesh(path: Path, part: PlacedMesh) -> palpate.SurfaceMesh:
    """[m] The mesh of a part of the layout at `path`, in its own frame. Raises Refusal or OSError,
    for a file that has changed as well."""
    file = path.parent / part.file
    mesh = read_mesh_file(file)
    if hash_file(file) != part.sha256:
        raise Refusal(
            file, "", "another file than was added to the layout",
            f"that one; `palpate scene place {path.name} {part.name} --renew` takes this one",
        )  # fmt: skip
    return scale_mesh(file, mesh, part)


def scale_mesh(file: Path, mesh: palpate.SurfaceMesh, part: PlacedMesh) -> palpate.SurfaceMesh:
    """[m] Refused where it is open, for a stone, or far too long or too short."""
    x = part.scale * np.asarray(mesh.vertices)
    length = float(np.ptp(x, axis=0).max())
    is_stone = isinstance(part, PlacedStone)
    least = SHORTEST_STONE if is_stone else SHORTEST_SCENERY
    if not length >= least:
        expected = f"{1e3 * least:g} mm or more; a file in metres is added with --unit m"
        raise Refusal(file, "", f"{1e3 * length:.3g} mm from side to side", expected)
    most = LONGEST_STONE if is_stone else LONGEST_SCENERY
    if not length <= most:
        expected = f"up to {most:g} m; a file in millimetres is added with --unit mm"
        raise Refusal(file, "", f"{length:g} m from side to side", expected)
    if is_stone and len(palpate.find_border_loops(mesh.triangles)):
        raise Refusal(file, "", "an open surface", "a closed one, as a stone has")
    return palpate.SurfaceMesh(x, mesh.triangles)


def build_stone(mesh: palpate.SurfaceMesh, placed: PlacedStone) -> Stone:
    """In the frame of its principal axes, filled with one density. Raises ValueError."""
    whole, hull = measure_mass(mesh), fit_hull(mesh, placed.spheres)
    to_frame = whole.axes.T
    turned = Rotation.from_rotvec(placed.rotation) * Rotation.from_matrix(whole.axes)
    body = palpate.RigidBody(
        (hull.centres - whole.centre) @ to_frame.T,
        hull.radii,
        mass=placed.density * whole.volume,
        inertia=placed.density * whole.inertia,
        position=move_points(placed, whole.centre[None])[0],
        orientation=turned.as_quat(),
        mesh=palpate.SurfaceMesh(
            (np.asarray(mesh.vertices) - whole.centre) @ to_frame.T, mesh.triangles
        ),
        friction=placed.friction,
    )
    return Stone(body, hull, float(np.ptp(mesh.vertices, axis=0).max()))


def build_scenery(
    layout: Layout, mesh: palpate.SurfaceMesh, placed: PlacedScenery
) -> palpate.Scenery:
    """Where it stands, and the numbers of the bodies that it stops."""
    x = move_points(placed, np.asarray(mesh.vertices))
    stops = sorted(layout.find(name) for name in placed.stops)
    return palpate.Scenery(palpate.SurfaceMesh(x, mesh.triangles), stops, friction=placed.friction)
