# SPDX-License-Identifier: GPL-3.0-or-later
"""Another unit, another axis up: the numbers of a file understood otherwise, without the file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from palpate_editor.document import Filling, Organ, Source, phrase
from palpate_editor.edits.edit import EditError, find_surface

METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "in": 0.0254, "ft": 0.3048}
"""Of 1 in each unit, as the reader of mesh files knows them."""

X, Y, Z = np.eye(3)
TURNS = {
    "z": (X, Y, Z),
    "y": (X, Z, -Y),
    "x": (Z, Y, -X),
    "-z": (X, -Y, -Z),
    "-y": (X, -Z, Y),
    "-x": (-Z, Y, X),
}
"""Where x, y and z of a file go when this axis of it points up, as the reader turns them."""


def find_source(organ: Organ) -> Source:
    find_surface(organ)
    if organ.source is None:
        raise EditError(phrase("This organ was not read from a file."))
    return organ.source


def map_surfaces(organ: Organ, move: Callable[[np.ndarray], np.ndarray]) -> Organ:
    """Both surfaces and the file's filling moved alike; surfaces that are one object stay one."""
    surface = find_surface(organ)
    moved = replace(surface, vertices=move(surface.vertices))
    imported = organ.imported
    if imported is surface:
        imported = moved
    elif imported is not None:
        imported = replace(imported, vertices=move(imported.vertices))
    filling = organ.filling
    if filling is not None:
        filling = Filling(move(filling.vertices), filling.tetrahedra)
    return replace(organ, surface=moved, imported=imported, filling=filling)


@dataclass(frozen=True)
class SetUnit:
    """Take 1 in the file to be another length."""

    unit: str

    @property
    def title(self) -> str:
        return phrase("Unit of the file: {unit}", unit=self.unit)

    def __call__(self, organ: Organ) -> Organ:
        source = find_source(organ)
        if self.unit not in METRES or source.unit not in METRES:
            raise EditError(
                phrase("The unit must be one of {known}, got {got}.",
                       known=", ".join(METRES), got=self.unit)
            )  # fmt: skip
        ratio = METRES[self.unit] / METRES[source.unit]
        source = replace(source, unit=self.unit, unit_guessed=False, unit_reason="as asked")
        changed = replace(map_surfaces(organ, lambda x: ratio * x), source=source)
        if organ.decimation is None:
            return changed
        decimation = replace(
            organ.decimation,
            mean_distance=ratio * organ.decimation.mean_distance,
            max_distance=ratio * organ.decimation.max_distance,
        )
        return replace(changed, decimation=decimation)


@dataclass(frozen=True)
class SetUp:
    """Take another axis of the file to point up."""

    up: str

    @property
    def title(self) -> str:
        return phrase("Axis that points up: {up}", up=self.up)

    def __call__(self, organ: Organ) -> Organ:
        source = find_source(organ)
        if self.up not in TURNS or source.up not in TURNS:
            raise EditError(
                phrase("The axis must be one of {known}, got {got}.",
                       known=", ".join(TURNS), got=self.up)
            )  # fmt: skip
        turn = np.column_stack(TURNS[self.up]) @ np.column_stack(TURNS[source.up]).T
        source = replace(source, up=self.up, up_guessed=False, up_reason="as asked")
        return replace(map_surfaces(organ, lambda x: x @ turn.T), source=source)
