# SPDX-License-Identifier: GPL-3.0-or-later
"""Even triangles of a chosen size, smaller in one region."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from palpate_editor.document import Decimation, Organ, Surface, phrase
from palpate_editor.edits.carry import carry_paint
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.repair import find_crowded, find_disagreeing
from palpate_editor.guarded import Found, GuardedError, run_guarded

GROWTH = 0.3
"""[m/m] Edges grow by so much of the distance from the region that is fine."""
SECONDS = 60.0


@dataclass(frozen=True)
class Remesh:
    """Make the triangles of the surface even, with edges about as long as is asked for.

    Always from the imported surface, which stays, so that trying several lengths costs no quality.
    Sharp edges and borders stay where they are; what was painted is carried over.
    """

    edge_length: float
    """[m] Of most edges."""
    region: str = ""
    """Where they are shorter; empty for nowhere."""
    region_edge_length: float | None = None
    """[m] There; they grow with the distance from it."""

    @property
    def title(self) -> str:
        if not self.region:
            return phrase("Remesh to edges of {edge:.3g} mm", edge=1e3 * self.edge_length)
        return phrase(
            "Remesh to edges of {edge:.3g} mm, {fine:.3g} mm in {region}",
            edge=1e3 * self.edge_length,
            fine=1e3 * (self.region_edge_length or 0.0),
            region=self.region,
        )

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        self.check(organ)
        source = surface if organ.imported is None else organ.imported
        if len(find_crowded(source.triangles)) or len(find_disagreeing(source.triangles)):
            raise EditError(phrase("It cannot be remeshed before its surface is repaired."))
        fine = surface.vertices[organ.regions[self.region]] if self.region else np.zeros((0, 3))
        numbers = {
            "edge_length": self.edge_length,
            "fine": fine.tolist(),
            "fine_length": self.region_edge_length,
            "growth": GROWTH,
        }
        made = self.remesh(source, numbers)
        changed = carry_paint(organ, made.surface)
        return replace(changed, imported=source, decimation=describe(source, made))

    def check(self, organ: Organ) -> None:
        """Raises EditError."""
        if not self.edge_length > 0.0:
            raise EditError(
                phrase(
                    "Edges must be longer than 0 mm, got {got:g} mm.", got=1e3 * self.edge_length
                )
            )
        if not self.region and self.region_edge_length is None:
            return
        if self.region not in organ.regions:
            raise EditError(phrase("The organ has no region '{name}'.", name=self.region))
        fine = self.region_edge_length
        if fine is None:
            raise EditError(phrase("How long edges are in the region was not said."))
        if not 0.0 < fine < self.edge_length:
            raise EditError(
                phrase(
                    "Edges in a region: got {got:g} mm, expected more than 0 mm and less than "
                    "{most:g} mm, those of the rest.",
                    got=1e3 * fine,
                    most=1e3 * self.edge_length,
                )
            )

    def remesh(self, surface: Surface, numbers: dict[str, object]) -> Found:
        try:
            found = run_guarded("remesh", surface, numbers, SECONDS)
        except GuardedError as problem:
            raise EditError(phrase("It cannot be remeshed: {why}", why=str(problem))) from None
        if found is None:
            raise EditError(
                phrase("Remeshing was not finished in {seconds:g} s: longer edges take less.",
                       seconds=SECONDS)
            )  # fmt: skip
        if found.told["crossing"]:
            raise EditError(
                phrase(
                    "With edges of {edge:.3g} mm {count} triangles would cross others: take "
                    "shorter ones, or remove crossings first.",
                    edge=1e3 * self.edge_length,
                    count=found.told["crossing"],
                )
            )
        return found


def describe(source: Surface, made: Found) -> Decimation:
    """What the document keeps of a surface that stands in the place of the imported one."""
    return Decimation(
        vertices_before=len(source.vertices),
        triangles_before=len(source.triangles),
        vertices=len(made.surface.vertices),
        triangles=len(made.surface.triangles),
        smallest_angle_deg=made.told["smallest_angle_deg"],
        mean_distance=made.told["mean_distance"],
        max_distance=made.told["max_distance"],
    )
