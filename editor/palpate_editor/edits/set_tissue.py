# SPDX-License-Identifier: GPL-3.0-or-later
"""Giving an organ, or a region of it, a tissue of the library."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from palpate_editor.document import AppliedTissue, Organ, phrase
from palpate_editor.edits.edit import EditError
from palpate_editor.edits.paint import PaintStiffness
from palpate_editor.edits.set_constant import SetConstant

OF_MATERIAL = ("young_modulus", "poisson_ratio", "density", "wall_thickness")


@dataclass(frozen=True)
class SetTissue:
    """Take the constants of a tissue.

    Of all of the organ: its material. Of a region: its stiffness beside that of the rest, as if it
    were painted; density and Poisson's ratio are one for all of an organ. Regions that have a
    tissue keep its stiffness where that of the rest changes.
    """

    tissue: AppliedTissue

    @property
    def title(self) -> str:
        if self.tissue.region:
            return phrase(
                "Tissue of {region}: {tissue}", region=self.tissue.region, tissue=self.tissue.title
            )
        return phrase("Tissue: {tissue}", tissue=self.tissue.title)

    def __call__(self, organ: Organ) -> Organ:
        tissue, region = self.tissue, self.tissue.region
        if region and region not in organ.regions:
            raise EditError(phrase("There is no region {name}.", name=region))
        if region and not organ.regions[region].size:
            raise EditError(phrase("Region {name} has no vertices.", name=region))
        kept = tuple(t for t in organ.tissues if t.region != region)
        changed = replace(organ, tissues=tuple(sorted((*kept, tissue), key=find_region)))
        if region:
            return scale_region(changed, tissue)
        for field in OF_MATERIAL:
            value = getattr(tissue, field)
            if value is not None:
                changed = SetConstant("material", field, value)(changed)
        for other in kept:
            if other.region in changed.regions:
                changed = scale_region(changed, other)
        return changed


def find_region(tissue: AppliedTissue) -> str:
    return tissue.region


def scale_region(organ: Organ, tissue: AppliedTissue) -> Organ:
    """The region's stiffness beside that of the organ. Raises EditError."""
    ids = organ.regions[tissue.region]
    factor = tissue.young_modulus / organ.material.young_modulus
    if np.all(organ.stiffness_scale[ids] == factor):
        return organ
    return PaintStiffness(ids, factor)(organ)
