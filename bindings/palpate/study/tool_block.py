# SPDX-License-Identifier: BSD-3-Clause
"""The block of the contact references as scenes: 3000 tetrahedra from E and nu, held below."""

from __future__ import annotations

from collections.abc import Callable
from itertools import permutations

import numpy as np

import palpate
from palpate.study.contact_reference import read_contact_reference
from palpate.study.half_space import plane_modulus
from palpate.study.tool import PressedScene

CELLS, EDGE = (10, 10, 5), 10e-3
"""Cubes of this edge [m], each cut into six tetrahedra."""
NODAL_SHARE = 0.9
RADIUS = 3e-3
"""[m] of the ball that most scenes ship with."""
KINDS: dict[str, Callable[..., palpate.TissueModel]] = {
    "springs + volumes": palpate.build_solid,
    "linear solid": palpate.build_linear_solid,
}


def open_blocks(hard: bool = False) -> list[PressedScene]:
    """One scene for every kind of solid, under the near field or under the hard law alone."""
    reference = read_contact_reference("block")
    modulus = 0.0 if hard else plane_modulus(reference.young_modulus, reference.poisson_ratio)
    law = "hard law" if hard else "near field"
    return [
        PressedScene(
            name=f"block, {kind}" + (", hard law" if hard else ""),
            file="",
            kind=f"{kind} under the {law}, {6 * int(np.prod(CELLS))} tetrahedra of {1e3 * EDGE:g} "
            "mm",
            derived=True,
            young_modulus=reference.young_modulus,
            radius=RADIUS,
            reference=reference,
            load=lambda build=build: build_scene(
                build, reference.young_modulus, reference.poisson_ratio, modulus
            ),
        )
        for kind, build in KINDS.items()
    ]


def build_scene(
    build: Callable[..., palpate.TissueModel],
    young_modulus: float,
    poisson_ratio: float,
    contact_modulus: float,
) -> palpate.Scene:
    solid = build_mesh()
    material = palpate.Material(young_modulus=young_modulus, poisson_ratio=poisson_ratio)
    base = np.flatnonzero(np.asarray(solid.vertices)[:, 2] < 1e-9)
    tissue = build(solid, material, palpate.SolidOptions(nodal_share=NODAL_SHARE, fixed=base))
    return palpate.build_scene(
        palpate.Scene(
            bodies=[palpate.SoftBody(tissue=tissue, contact_modulus=contact_modulus)],
            instruments=[palpate.Instrument(tool=palpate.Tool(radius=RADIUS))],
        )
    )


def build_mesh() -> palpate.SolidMesh:
    """Kuhn's six tetrahedra of every cube; the middle of the base is the origin."""
    counts = np.array(CELLS)
    grid = np.stack(np.meshgrid(*map(np.arange, counts + 1), indexing="ij"), axis=-1)
    x = EDGE * (grid.reshape(-1, 3) - np.array([0.5 * counts[0], 0.5 * counts[1], 0.0]))
    strides = np.array([(counts[1] + 1) * (counts[2] + 1), counts[2] + 1, 1])
    cubes = np.stack(np.meshgrid(*map(np.arange, counts), indexing="ij"), axis=-1).reshape(-1, 3)
    cells = []
    for order in permutations(range(3)):
        corners = [cubes]
        for axis in order:
            corners.append(corners[-1] + np.eye(3, dtype=int)[axis])
        cells.append(np.stack([corner @ strides for corner in corners], axis=1))
    t = np.vstack(cells)
    a, b, c = (x[t[:, k]] - x[t[:, 0]] for k in (1, 2, 3))
    turned = np.einsum("ij,ij->i", a, np.cross(b, c)) < 0.0
    t[turned] = t[turned][:, [0, 2, 1, 3]]
    return palpate.SolidMesh(x, t.astype(np.int32))
