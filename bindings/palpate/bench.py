# SPDX-License-Identifier: BSD-3-Clause
"""What a step, a query and a tick cost on this machine, beside their naive forms."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import palpate
from palpate.mesh_file import read_mesh_file
from palpate.scene_file import compile_scene
from palpate.scene_parts import HandPart, MaterialPart, ModelPart, SceneFile
from palpate.verb import Refusal, Report

DEFAULT_VERTICES = (600, 2000, 5400)
MATERIAL = MaterialPart(wall_thickness=2e-3)
"""The test bed of the contact laws: 2 kg/m² of wall, so one figure compares with another."""
MASS_SPRING = ModelPart(kind="mass_spring", stiffness=52.0, home_stiffness=3e5, drag=30.0)
MOLECULAR = ModelPart(
    kind="molecular",
    stiffness=52.0,
    bend_stiffness=2e-5,
    stretch_coupling=0.01,
    home_stiffness=3e5,
    drag=30.0,
)
HAND = HandPart(gravity=(0.0, 0.0, 0.0))


def bench_meshes(paths: Sequence[Path], vertices: Sequence[int], budget: float) -> list[Report]:
    """Rows of every work on every mesh; generated ellipsoids where no file is named."""
    meshes = {path.stem: read_mesh_file(path) for path in paths}
    if not meshes or vertices:
        meshes |= generate_meshes(vertices or DEFAULT_VERTICES)
    rows = []
    for name, mesh in meshes.items():
        options = palpate.BenchOptions()
        options.budget = budget
        scenes = [
            compile_scene(SceneFile(organ=None, material=MATERIAL, model=model, hand=HAND), mesh)
            for model in (MASS_SPRING, MOLECULAR)
        ]
        for row in palpate.run_bench(*scenes, options):
            rows.append(
                {
                    "work": row.work,
                    "mesh": name,
                    "vertices": row.vertices,
                    "substeps": row.substeps or None,
                    "median_us": 1e6 * row.median,
                    "p99_us": 1e6 * row.p99,
                    "naive_median_us": 1e6 * row.naive_median,
                    "ratio_to_naive": row.ratio_to_naive,
                    "ns_per_element": row.ns_per_element(),
                    "share_of_bound": row.share_of_bound or None,
                    "simd_target": row.simd_target,
                    "compiler_flags": row.compiler_flags,
                    "physics": row.physics,
                }
            )
    return rows


def generate_meshes(vertices: Sequence[int]) -> dict[str, palpate.SurfaceMesh]:
    try:
        from palpate_meshes.generate import ellipsoid
    except ImportError:
        raise Refusal(
            None,
            "--mesh",
            "no mesh and no generators",
            "--mesh FILE, or palpate-editor installed for generated ones",
        ) from None
    meshes = {}
    for count in vertices:
        if count < 50:
            raise Refusal(None, "--vertices", str(count), "at least 50")
        meshes[f"ellipsoid-{count}"] = palpate.SurfaceMesh(*ellipsoid(vertices=count))
    return meshes
