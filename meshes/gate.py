# SPDX-License-Identifier: BSD-3-Clause
"""What a mesh must be before it ships; every fault is a sentence."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import palpate
from palpate.scene.scene_file import build_tissue
from palpate.scene.scene_parts import MaterialPart, ModelPart, SceneFile
from palpate_editor.authoring import inspect_mesh
from palpate_meshes.anatomy import ATTACHMENT
from palpate_meshes.catalogue import Entry, Tissue
from palpate_meshes.generate.relax import compute_angles

SMALLEST_ANGLE, LARGEST_ANGLE = 30.0, 110.0
"""[degree] Beyond these a triangle makes a tissue stiffer in one direction than in another."""


def find_faults(
    entry: Entry,
    tissue: Tissue,
    vertices: np.ndarray,
    triangles: np.ndarray,
    regions: dict[str, np.ndarray],
) -> list[str]:
    """All that keeps a mesh from being shipped as `entry`, made of `tissue`; best nothing."""
    mesh = palpate.SurfaceMesh(vertices, triangles)
    faults = [
        *find_count_faults(entry, mesh),
        *find_surface_faults(entry, mesh),
        *find_shape_faults(entry, mesh),
        *find_region_faults(entry, tissue, regions),
        *find_tissue_faults(tissue, mesh),
    ]
    return [f"{entry.name}: {fault}" for fault in faults]


def find_count_faults(entry: Entry, mesh: palpate.SurfaceMesh) -> Iterator[str]:
    for what, found, expected in (
        ("vertices", len(mesh.vertices), entry.vertices),
        ("triangles", len(mesh.triangles), entry.triangles),
    ):
        if found != expected:
            yield f"got {found} {what}, expected {expected}"


def find_surface_faults(entry: Entry, mesh: palpate.SurfaceMesh) -> Iterator[str]:
    report = inspect_mesh(mesh)
    if report.shells != 1:
        yield f"got {report.shells} pieces, expected one"
    if report.non_manifold_edges:
        yield f"got {report.non_manifold_edges} edges with more than two triangles"
    euler = palpate.compute_euler_number(mesh.triangles)
    if euler != 2 - len(entry.border):
        yield f"got an Euler number of {euler}, expected {2 - len(entry.border)}"
    if sorted(report.border_loops) != sorted(entry.border):
        yield f"got border loops of {list(report.border_loops)}, expected {list(entry.border)}"
    if report.self_intersecting_faces != 0:
        yield f"got {report.self_intersecting_faces} triangles that cross others"
    if compute_closed_volume(mesh) <= 0.0 and entry.volume_ml is not None:
        yield "got triangles that face inwards"
    angles = np.degrees(compute_angles(np.asarray(mesh.vertices), np.asarray(mesh.triangles)))
    if angles.min() < SMALLEST_ANGLE:
        yield f"got an angle of {angles.min():.1f} degrees, expected {SMALLEST_ANGLE:g} or more"
    if angles.max() > LARGEST_ANGLE:
        yield f"got an angle of {angles.max():.1f} degrees, expected {LARGEST_ANGLE:g} or less"


def find_shape_faults(entry: Entry, mesh: palpate.SurfaceMesh) -> Iterator[str]:
    """Is it as large as the organ of a healthy adult?"""
    size = 1e3 * np.ptp(np.asarray(mesh.vertices), axis=0)
    for axis, found, (least, most) in zip("xyz", size, entry.size_mm, strict=True):
        if not least <= found <= most:
            yield f"is {found:.1f} mm along {axis}, expected {least:g} to {most:g}"
    if entry.volume_ml is None:
        return
    volume = 1e6 * compute_closed_volume(mesh)
    least, most = entry.volume_ml
    if not least <= volume <= most:
        yield f"holds {volume:.2f} ml, expected {least:g} to {most:g}"


def compute_closed_volume(mesh: palpate.SurfaceMesh) -> float:
    """[m³] With every border loop closed by a fan around its middle."""
    x, triangles = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    for loop in palpate.find_border_loops(mesh.triangles):
        ring = np.asarray(loop)
        middle = np.full(len(ring), len(x))
        x = np.concatenate([x, x[ring].mean(axis=0)[None]])
        lid = np.stack([np.roll(ring, -1), ring, middle], axis=1)
        # where a triangle runs along the border the same way as the lid, the lid is upside down
        sides = np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)])
        if (sides == lid[0, :2]).all(axis=1).any():
            lid = lid[:, [1, 0, 2]]
        triangles = np.concatenate([triangles, lid])
    a, b, c = (x[triangles[:, i]] for i in range(3))
    return float((a * np.cross(b, c)).sum() / 6.0)


def find_region_faults(
    entry: Entry, tissue: Tissue, regions: dict[str, np.ndarray]
) -> Iterator[str]:
    if ATTACHMENT not in regions:
        yield "has no region by which the body holds it"
    for name, ids in regions.items():
        if len(ids) == 0:
            yield f"has no vertex in its region {name!r}"
        elif ids.min() < 0 or ids.max() >= entry.vertices or (np.diff(ids) <= 0).any():
            yield f"has other numbers in its region {name!r} than its vertices', ascending"
    held = len(regions.get(ATTACHMENT, ()))
    if tissue.kind == "rigid" and held < entry.vertices:
        yield f"is rigid, but only {held} of its vertices are held"
    if tissue.kind != "rigid" and held >= entry.vertices:
        yield "is held everywhere, so nothing of it can move"


def find_tissue_faults(tissue: Tissue, mesh: palpate.SurfaceMesh) -> Iterator[str]:
    """Both laws of surfaces must take its triangles (the MMS test per triangle), at their usual
    constants where the tissue is no surface of springs."""
    material = MaterialPart(**tissue.material)
    for kind in ("mass_spring", "molecular"):
        model = replace(ModelPart(**tissue.model), kind=kind)
        scene = SceneFile(organ=None, material=material, model=model)  # type: ignore[arg-type]
        try:
            build_tissue(scene, mesh)
        except ValueError as refusal:
            yield f"as {kind} of {tissue.title}: {refusal}"
