# SPDX-License-Identifier: GPL-3.0-or-later
"""The inner face of a wall of prisms: as far below as it is thick, nearer where it must be."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
import pytest
from palpate_editor.authoring import find_self_intersecting_faces
from palpate_editor.check import assess
from palpate_editor.compile import build_organ, surface_of
from palpate_editor.document import EMPTY, Organ
from palpate_editor.edits import SetChoice, SetConstant
from palpate_editor.shipped import make_organ
from palpate_meshes.generate import ellipsoid

LEAST_SHARE = 0.1
"""[-] Of a triangle's area, below which a wall was refused before."""


def make_wall(organ: Organ, thickness: float) -> Organ:
    return SetConstant("material", "wall_thickness", thickness)(SetChoice("kind", "shell")(organ))


def find_faces(organ: Organ) -> tuple[np.ndarray, np.ndarray]:
    """[m] (n, 3) the outer and the inner face of its tissue at rest."""
    x = np.asarray(build_organ(organ).rest_position)
    return x[: organ.vertex_count], x[organ.vertex_count : 2 * organ.vertex_count]


def count_crossings(x: np.ndarray, triangles: np.ndarray) -> int:
    return len(find_self_intersecting_faces(palpate.SurfaceMesh(x, triangles)))


def share_area(outer: np.ndarray, inner: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """[-] (t,) of each triangle's area that is left below it."""
    one, other = (
        np.cross(x[triangles[:, 1]] - x[triangles[:, 0]], x[triangles[:, 2]] - x[triangles[:, 0]])
        for x in (outer, inner)
    )
    return (one * other).sum(axis=1) / (one * one).sum(axis=1)


@pytest.fixture(scope="module")
def kidney() -> Organ:
    return make_organ("kidney")


@pytest.fixture(scope="module")
def plate() -> Organ:
    """An ellipsoid of 6 mm at its thickest."""
    x, triangles = ellipsoid(600, (0.05, 0.04, 0.003), bow=0.0, hollow=0.0, notches=0.0)
    return replace(EMPTY.with_surface(surface_of(palpate.SurfaceMesh(x, triangles))), name="spleen")


def test_a_wall_with_room_is_everywhere_as_thick(kidney):
    wall = make_wall(kidney, 2e-3)

    outer, inner = find_faces(wall)

    assert np.linalg.norm(outer - inner, axis=1) == pytest.approx(2e-3 / np.sqrt(3.0), rel=1e-12)
    assert "reduced_wall" not in {p.key for p in assess(wall).problems}


def test_a_wall_of_the_kidney_that_would_fold_at_its_hilum_is_nearer_there_alone(kidney):
    wall, depth = make_wall(kidney, 5e-3), 5e-3 / np.sqrt(3.0)
    triangles = kidney.surface.triangles
    normals = np.asarray(palpate.compute_vertex_normals(kidney.surface.vertices, triangles))
    folded = kidney.surface.vertices - depth * normals

    outer, inner = find_faces(wall)

    assert share_area(outer, folded, triangles).min() < LEAST_SHARE
    assert share_area(outer, inner, triangles).min() >= LEAST_SHARE
    away = np.linalg.norm(outer - inner, axis=1) / depth
    assert 0.25 <= away.min() < 1.0 and (away < 1.0 - 1e-6).mean() < 0.05
    both = np.concatenate([triangles, triangles[:, ::-1] + len(outer)])
    assert count_crossings(np.concatenate([outer, inner]), both) == 0


@pytest.mark.landing
def test_a_check_says_how_much_is_nearer_and_where(kidney):
    assessment = assess(make_wall(kidney, 5e-3))

    (problem,) = (p for p in assessment.problems if p.key == "reduced_wall")

    tissue = assessment.facts.tissue
    assert problem.severity == "note" and problem.where == "material.wall_thickness"
    assert f"the wall is {tissue.least_depth:.0%} as thick there" in str(problem.got)
    corners = kidney.surface.triangles[problem.faces]
    assert set(tissue.reduced) <= set(corners.ravel().tolist())


def test_walls_of_both_sides_of_a_thin_body_meet_less(plate):
    """Its rim is thinner than two walls, and than its edges are long: there some still cross."""
    x, triangles = plate.surface.vertices, plate.surface.triangles
    normals = np.asarray(palpate.compute_vertex_normals(x, triangles))
    met = x - 2.5e-3 / np.sqrt(3.0) * normals

    outer, inner = find_faces(make_wall(plate, 2.5e-3))

    assert 0 < count_crossings(inner, triangles) < 0.5 * count_crossings(met, triangles)
    assert (np.linalg.norm(outer - inner, axis=1) <= 2.5e-3 / np.sqrt(3.0) * (1.0 + 1e-9)).all()


def test_a_wall_thicker_than_its_body_is_refused_as_before(plate):
    refusal = assess(make_wall(plate, 4e-2)).facts.tissue.refusal

    assert refusal is not None and "inner face" in refusal[1] and "a thinner wall" in refusal[2]


def test_a_turned_wall_has_turned_faces(plate):
    turn = np.linalg.qr(np.random.default_rng(4).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    x, triangles = plate.surface.vertices @ turn.T, plate.surface.triangles
    turned = replace(EMPTY.with_surface(surface_of(palpate.SurfaceMesh(x, triangles))))

    for one, other in zip(
        find_faces(make_wall(plate, 2.5e-3)), find_faces(make_wall(turned, 2.5e-3)), strict=True
    ):
        assert one @ turn.T == pytest.approx(other, abs=1e-9)
