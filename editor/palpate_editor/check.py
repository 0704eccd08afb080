# SPDX-License-Identifier: GPL-3.0-or-later
"""All problems of a scene as values: the window shows them, the command line prints them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
from palpate.mesh_file import read_mesh_file
from palpate.scene_file import compile_scene, hash_file, read_scene_file
from palpate.verb import Report

from palpate_editor import authoring
from palpate_editor.demo import describe_model

ANGLE_LEAST = 15.0
"""[degree] Needles make a model stiff and its stretch-bend range collapse (SCIENCE 1.7)."""
EDGES_PER_RADIUS = 0.5
"""[-] A tip much smaller than the triangles it touches feels the mesh, not the tissue."""
SUBSTEPS_MOST = 16
"""More substeps than this leave no time in a millisecond on the reference machine."""


def problem(severity: str, where: str, found: str, expected: str) -> Report:
    return {"severity": severity, "where": where, "found": found, "expected": expected}


def check_scene(path: Path) -> Report:
    """Everything wrong or doubtful about a scene file. Raises Refusal where it cannot be read."""
    scene = read_scene_file(path)
    mesh_path = path.parent / scene.organ.mesh
    mesh = read_mesh_file(mesh_path)
    report: Report = {"scene": str(path), "description": "cannot be built", "problems": []}
    problems = report["problems"]
    if hash_file(mesh_path) != scene.organ.sha256:
        problems.append(
            problem(
                "error",
                "organ.sha256",
                "another mesh than the scene was made with",
                "the same bytes, or a new scene file",
            )
        )
    problems += check_mesh(mesh, scene.tool.radius)
    try:
        compiled = compile_scene(scene, mesh)
    except ValueError as refusal:
        problems.append(problem("error", "model", str(refusal), "a tissue that can be built"))
        return report
    report["description"] = describe_model(compiled)
    if compiled.substeps > SUBSTEPS_MOST:
        problems.append(
            problem(
                "warning",
                "model",
                f"{compiled.substeps} substeps a tick",
                f"at most {SUBSTEPS_MOST}: softer links, more mass or fewer vertices",
            )
        )
    loose = scene.model.home_stiffness == 0.0 and not scene.model.fixed
    if loose:
        problems.append(
            problem(
                "warning",
                "model",
                "neither home springs nor fixed vertices",
                "something that holds the organ in its place",
            )
        )
    return report


def check_mesh(mesh: palpate.SurfaceMesh, tool_radius: float) -> list[Report]:
    found = authoring.inspect_mesh(mesh)
    problems = []
    if found.self_intersecting_faces:
        problems.append(
            problem(
                "warning",
                "mesh",
                f"{found.self_intersecting_faces} self-intersecting faces",
                "none",
            )
        )
    if found.smallest_angle_deg is not None and found.smallest_angle_deg < ANGLE_LEAST:
        problems.append(
            problem(
                "warning",
                "mesh",
                f"a smallest angle of {found.smallest_angle_deg:.1f} degrees",
                f"at least {ANGLE_LEAST:g}: decimate anew",
            )
        )
    if found.outward is False:
        problems.append(problem("error", "mesh", "triangles that face inwards", "outwards"))
    x, triangles = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    edges = np.linalg.norm(x[triangles] - x[np.roll(triangles, 1, axis=1)], axis=2)
    if tool_radius < EDGES_PER_RADIUS * edges.mean():
        problems.append(
            problem(
                "warning",
                "tool.radius",
                f"{1e3 * tool_radius:.1f} mm",
                f"at least half the mean edge of {1e3 * edges.mean():.1f} mm",
            )
        )
    return problems
