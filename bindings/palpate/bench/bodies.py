# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that are timed beside surfaces: filled organs and walls, as the accuracy study has them.

They come from its references, which ship with the library, so no filling is needed here; their
constants follow from Young's modulus and Poisson's ratio alone.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

import palpate
from palpate.bench.meshes import find_order

if TYPE_CHECKING:
    from palpate.study.reference import Reference

NODAL_SHARE = 0.9
"""Of solids: what a new organ has."""
NAMES = {
    "solid": ("spleen", "kidney", "liver"),
    "linear": ("spleen", "kidney", "liver"),
    "shell": ("gallbladder", "stomach"),
}
"""Kind -> the shipped organs that are of it."""


@dataclass(frozen=True)
class BenchBody:
    """One organ as one kind of body."""

    name: str
    kind: str
    """shell, solid or linear: what its works begin with."""
    build: Callable[[], palpate.Scene]
    """Takes up to seconds."""

    @property
    def works(self) -> list[str]:
        """Those that there is a row for, in their order."""
        return [work for work in palpate.bench_body_works() if work.startswith(f"{self.kind}_")]


def list_bodies(names: Sequence[str] = ()) -> list[BenchBody]:
    """All of them, or those of the named organs, solids before walls."""
    return [
        BenchBody(name, kind, make_builder(name, kind))
        for kind, organs in NAMES.items()
        for name in organs
        if not names or name in names
    ]


def make_builder(name: str, kind: str) -> Callable[[], palpate.Scene]:
    def build() -> palpate.Scene:
        from palpate.study import models
        from palpate.study.reference import read_reference

        reference = renumber(read_reference(name))
        builders = {"solid": models.build_volumes, "linear": models.build_linear}
        if kind in builders:
            built = builders[kind](reference, NODAL_SHARE)
        else:
            built = models.build_shell(reference)
        return palpate.build_scene(palpate.make_scene(built.model))

    return build


def renumber(reference: Reference) -> Reference:
    """The same body with neighbours side by side in memory, the outer face of a wall still first.

    Presses and results are dropped: it has the old numbers.
    """
    from palpate.study.models import find_outside

    count = len(reference.vertices)
    if reference.wall_thickness is None:
        order = find_order(reference.tetrahedra, count)
    else:
        outer = find_order(find_outside(reference), count // 2)
        order = np.concatenate([outer, np.arange(count // 2, count, dtype=np.int32)])
    place = np.empty(count, dtype=np.int32)
    place[order] = np.arange(count, dtype=np.int32)
    tetrahedra = place[reference.tetrahedra]
    return replace(
        reference,
        vertices=reference.vertices[order],
        tetrahedra=tetrahedra[np.argsort(tetrahedra.min(axis=1), kind="stable")],
        surface=np.sort(place[reference.surface]),
        held=np.sort(place[reference.held]),
        places=(),
    )
