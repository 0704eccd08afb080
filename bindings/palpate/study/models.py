# SPDX-License-Identifier: BSD-3-Clause
"""The kinds of tissue model that are held against the references, each built from the material."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.study.reference import Place, Reference
from palpate.study.statics import Press

SOLID, WALL = "solid", "wall"
"""What a body is: full of tissue, or hollow."""
MEMBRANE, SHELL = 3e-3, 4e-3
"""[m] of the wall that a surface model of a solid is given: a choice, for it has none."""


@dataclass(frozen=True)
class Built:
    """A model of a reference's body."""

    model: palpate.TissueModel
    particle: NDArray[np.int32]
    """(n,) of every vertex of the reference; -1 where the model has none."""

    def press(self, place: Place) -> Press:
        return Press(self.model, self.particle[place.vertices], place.direction)


@dataclass(frozen=True)
class Kind:
    """One row of the table."""

    name: str
    build: Callable[[Reference], Built]
    deep: str = ""
    """Of which bodies it is worth pressing deep, "solid" or "wall"; "" where small presses are
    far from the truth already."""


def form_of(reference: Reference) -> str:
    return SOLID if reference.wall_thickness is None else WALL


def solid_of(reference: Reference) -> palpate.SolidMesh:
    return palpate.SolidMesh(reference.vertices, reference.tetrahedra)


def material_of(reference: Reference, wall: float | None = None) -> palpate.Material:
    return palpate.Material(
        young_modulus=reference.young_modulus,
        poisson_ratio=reference.poisson_ratio,
        wall_thickness=wall,
    )


def build_volumes(reference: Reference, nodal_share: float) -> Built:
    """Springs of the right shear modulus and true volumes (MSS+V)."""
    options = palpate.SolidOptions(nodal_share=nodal_share, fixed=reference.held)
    model = palpate.build_solid(solid_of(reference), material_of(reference), options)
    return Built(model, np.arange(len(reference.vertices), dtype=np.int32))


def build_linear(reference: Reference, nodal_share: float) -> Built:
    """Linear elasticity on the mesh, its volumes averaged by so much."""
    options = palpate.SolidOptions(nodal_share=nodal_share, fixed=reference.held)
    model = palpate.build_linear_solid(solid_of(reference), material_of(reference), options)
    return Built(model, np.arange(len(reference.vertices), dtype=np.int32))


def build_springs(reference: Reference, uniform: bool) -> Built:
    """Springs along the edges alone: k = E sum V/L² [VanGelder98], or one k of the same energy."""
    whole = np.arange(len(reference.vertices), dtype=np.int32)
    bare = palpate.build_solid(solid_of(reference), material_of(reference))
    springs = bare.springs
    ends, length = np.asarray(springs.ends), np.asarray(springs.rest_length)
    volume = compute_volumes(reference.vertices, reference.tetrahedra)
    if uniform:
        stiffness = np.full(len(ends), 6.0 * reference.young_modulus * volume.sum())
        stiffness /= (length**2).sum()
    else:
        stiffness = reference.young_modulus * sum_around_edges(reference, ends, volume) / length**2
    model = palpate.TissueModel(
        rest_position=reference.vertices,
        mass=bare.mass,
        fixed=reference.held,
        springs=palpate.Links(ends, length, stiffness, np.zeros(len(ends))),
        triangles=bare.triangles,
    )
    return Built(model, whole)


def compute_volumes(x: NDArray[np.float64], tetrahedra: NDArray[np.int32]) -> NDArray[np.float64]:
    """[m³] of every tetrahedron, negative where it is turned inside out."""
    a, b, c, d = (x[tetrahedra[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6.0


def sum_around_edges(
    reference: Reference, ends: NDArray[np.int32], values: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Of every edge, the sum of a value of the tetrahedra that have it."""
    count = len(reference.vertices)
    keys = ends[:, 0].astype(np.int64) * count + ends[:, 1]
    order = np.argsort(keys)
    total = np.zeros(len(ends))
    for i in range(4):
        for j in range(i + 1, 4):
            pair = np.sort(reference.tetrahedra[:, [i, j]], axis=1).astype(np.int64)
            found = np.searchsorted(keys[order], pair[:, 0] * count + pair[:, 1])
            np.add.at(total, order[found], values)
    return total


def find_outside(reference: Reference) -> NDArray[np.int32]:
    """Triangles of the surface that is felt; of a wall its outer face, whose vertices are first."""
    triangles = np.asarray(palpate.find_boundary(solid_of(reference)))
    if reference.wall_thickness is None:
        return triangles
    return triangles[(triangles < len(reference.vertices) // 2).all(axis=1)]


def surface_of(reference: Reference) -> tuple[palpate.SurfaceMesh, NDArray[np.int32], list[int]]:
    """The outside alone, the number of each vertex in it, and which of those are held."""
    triangles = find_outside(reference)
    outside = np.unique(triangles)
    number = np.full(len(reference.vertices), -1, dtype=np.int32)
    number[outside] = np.arange(len(outside))
    mesh = palpate.SurfaceMesh(reference.vertices[outside], number[triangles])
    held = number[reference.held]
    return mesh, number, sorted(held[held >= 0].tolist())


def build_membrane_springs(reference: Reference) -> Built:
    mesh, number, held = surface_of(reference)
    options = palpate.SurfaceOptions(fixed=held, home_stiffness=0.0)
    material = material_of(reference, reference.wall_thickness or MEMBRANE)
    return Built(palpate.build_membrane_springs(mesh, material, options=options), number)


def build_membrane_molecular(reference: Reference) -> Built:
    mesh, number, held = surface_of(reference)
    options = palpate.SurfaceOptions(fixed=held, home_stiffness=0.0)
    material = material_of(reference, reference.wall_thickness or MEMBRANE)
    return Built(palpate.build_membrane_molecular(mesh, material, options=options), number)


def build_shell(reference: Reference) -> Built:
    """Of a wall; a solid's is 4 mm thick, where its surface allows that."""
    mesh, number, held = surface_of(reference)
    options = palpate.SurfaceOptions(fixed=held)
    material = material_of(reference, reference.wall_thickness or SHELL)
    return Built(palpate.build_shell(mesh, material, options), number)


KINDS = (
    Kind("springs, one stiffness", lambda reference: build_springs(reference, True)),
    Kind("springs, van Gelder", lambda reference: build_springs(reference, False), SOLID),
    Kind("springs + volumes, each", lambda reference: build_volumes(reference, 0.0), SOLID),
    Kind("springs + volumes, 0.9 nodal", lambda reference: build_volumes(reference, 0.9), SOLID),
    Kind("springs + volumes, nodal", lambda reference: build_volumes(reference, 1.0)),
    Kind("linear solid, 0.9 nodal", lambda reference: build_linear(reference, 0.9), SOLID),
    Kind("surface springs (MSS)", build_membrane_springs),
    Kind("surface molecules (MMS), exact", build_membrane_molecular),
    Kind("shell of prisms", build_shell, WALL),
)
