# SPDX-License-Identifier: BSD-3-Clause
"""What is timed: surfaces of springs, those of shipped organs and generated ones of any size.

Particles are renumbered once, before anything is timed (reverse Cuthill-McKee), so that the naive
form has the order that suits it best and no ratio comes from a file's numbering.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.files.refusal import Refusal
from palpate.runs.press import take_surface
from palpate.scene.mesh_file import read_mesh_file
from palpate.scene.scene_file import compile_scene
from palpate.scene.scene_parts import HandPart, MaterialPart, ModelPart, SceneFile

SIZES = (20_000, 100_000, 500_000)
"""Vertices of the generated surfaces."""
HALF_AXES = (0.05, 0.035, 0.03)
"""[m] of their ellipsoid: that of the work compared with other engines."""
FEWEST = 50

MATERIAL = MaterialPart(wall_thickness=2e-3)
"""The test bed of the contact laws: 2 kg/m² of wall, so one figure compares with another."""
MODEL = ModelPart(
    stiffness=52.0, bend_stiffness=2e-5, stretch_coupling=0.01, home_stiffness=3e5, drag=30.0
)
TEST_BED = "test bed"
BED = SceneFile(organ=None, material=MATERIAL, model=MODEL, hand=HandPart(gravity=(0.0, 0.0, 0.0)))


@dataclass(frozen=True)
class BenchMesh:
    """One surface under both laws."""

    name: str
    vertices: int
    triangles: int
    constants: str
    """Whose, in words."""
    build: Callable[[], tuple[palpate.Scene, palpate.Scene]]
    """The mass-spring and the molecular scene; takes seconds on large meshes."""


def read_shipped(names: Sequence[str] = ()) -> list[BenchMesh]:
    """Every organ that ships, or those named: see read_published."""
    folder = find_published()
    meshes = sorted(path.stem for path in folder.glob("*.obj"))
    unknown = sorted(set(names) - set(meshes))
    if unknown:
        raise Refusal(None, "--organ", unknown[0], "one of " + ", ".join(meshes))
    return [read_published(folder / f"{name}.palpate") for name in names or meshes]


def find_published() -> Path:
    """Where the organs are. Raises Refusal where only the simulator is installed."""
    try:
        from palpate_meshes.catalogue import PUBLISHED
    except ImportError:
        raise Refusal(
            None,
            "the shipped organs",
            "no palpate-editor, which brings them",
            "palpate-editor installed, or --mesh FILE",
        ) from None
    return PUBLISHED


def is_organ(path: Path) -> bool:
    """Whether a published file is of one organ, with the constants that its designer chose."""
    published = palpate.scenario.read(path)
    try:
        return "model" in json.loads(published.authored)["content"]
    except (ValueError, LookupError, TypeError, RecursionError):
        return len(published.scene.bodies) == 1  # read_published says what is wrong


def read_published(path: Path) -> BenchMesh:
    """A published file's surface of springs, with its constants, painted stiffness and what of it
    is fixed.

    Solids and walls of prisms are timed as bodies (palpate.bench.bodies); here the surface that was
    imported for them is, in the test bed.
    """
    # loads what draws, which every other command does without
    from palpate.scene.authored import read_constants

    scenario = palpate.scenario.read(path)
    scene, arrays = read_constants(path, scenario), scenario.authored_arrays
    if scene.model.kind not in ("mass_spring", "molecular"):
        surface = take_surface(scenario.scene, 0)
        if "imported/vertices" in arrays:
            surface = arrays["imported/vertices"], arrays["imported/triangles"]
        return prepare(path.stem, palpate.SurfaceMesh(*surface), BED, TEST_BED)
    scale = np.asarray(arrays.get("stiffness_scale", ()), dtype=float)
    model = replace(
        scene.model,
        fixed=tuple(np.asarray(arrays.get("fixed", ())).tolist()),
        stiffness_scale=tuple(scale.tolist()) if (scale != 1.0).any() else (),
    )
    mesh = palpate.SurfaceMesh(*take_surface(scenario.scene, 0))
    kind = scene.model.kind.replace("_", "-")
    return prepare(path.stem, mesh, replace(scene, model=model), f"published ({kind})")


def read_surface(path: Path) -> BenchMesh:
    """An OBJ in metres, in the test bed of the contact laws."""
    return prepare(path.stem, read_mesh_file(path), BED, TEST_BED)


def generate_meshes(sizes: Sequence[int] = SIZES) -> list[BenchMesh]:
    """Ellipsoids of exactly so many vertices, in the test bed. Raises Refusal."""
    return [generate_mesh(size) for size in sizes]


def generate_mesh(size: int) -> BenchMesh:
    if size < FEWEST:
        raise Refusal(None, "--vertices", str(size), f"at least {FEWEST}")
    return prepare(f"ellipsoid-{size}", generate_ellipsoid(size), BED, TEST_BED)


def generate_ellipsoid(size: int) -> palpate.SurfaceMesh:
    """A closed surface of so many vertices, spread along a spiral."""
    try:
        from palpate_meshes.generate.ellipsoid import hull_triangles, spread_over_sphere
    except ImportError:
        raise Refusal(
            None,
            "--vertices",
            "no palpate-editor, which brings the generators",
            "palpate-editor installed, or --mesh FILE",
        ) from None
    points = spread_over_sphere(size, 0)
    triangles = hull_triangles(points).astype(np.int32)
    return palpate.SurfaceMesh(np.asarray(HALF_AXES) * points, triangles)


def prepare(name: str, mesh: palpate.SurfaceMesh, scene: SceneFile, constants: str) -> BenchMesh:
    def build() -> tuple[palpate.Scene, palpate.Scene]:
        ordered, parts = renumber(mesh, scene)
        kinds = ("mass_spring", "molecular")
        return tuple(
            compile_scene(replace(parts, model=replace(parts.model, kind=kind)), ordered)
            for kind in kinds
        )

    return BenchMesh(name, len(mesh.vertices), len(mesh.triangles), constants, build)


def renumber(mesh: palpate.SurfaceMesh, scene: SceneFile) -> tuple[palpate.SurfaceMesh, SceneFile]:
    """The same tissue with neighbours side by side in memory."""
    order = find_order(np.asarray(mesh.triangles), len(mesh.vertices))
    place = np.empty(len(order), dtype=np.int32)
    place[order] = np.arange(len(order), dtype=np.int32)
    triangles = place[np.asarray(mesh.triangles)]
    triangles = triangles[np.argsort(triangles.min(axis=1), kind="stable")]
    model = scene.model
    scale = np.asarray(model.stiffness_scale)
    model = replace(
        model,
        fixed=tuple(sorted(place[list(model.fixed)].tolist())),
        stiffness_scale=tuple(scale[order].tolist()) if len(scale) else (),
    )
    ordered = palpate.SurfaceMesh(np.asarray(mesh.vertices)[order], triangles)
    return ordered, replace(scene, model=model)


def find_order(cells: NDArray[np.int32], count: int) -> NDArray[np.int32]:
    """Old numbers in their new sequence [CuthillMcKee69], from triangles or tetrahedra."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import reverse_cuthill_mckee

    rows, columns = cells.ravel(), np.roll(cells, -1, axis=1).ravel()
    graph = coo_matrix((np.ones(len(rows), dtype=np.int8), (rows, columns)), (count, count))
    return reverse_cuthill_mckee((graph + graph.T).tocsr(), symmetric_mode=True)
