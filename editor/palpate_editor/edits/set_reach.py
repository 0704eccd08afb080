# SPDX-License-Identifier: GPL-3.0-or-later
"""Choosing regions of a filling: where a linear solid can be pushed, where it is finer."""

from __future__ import annotations

from dataclasses import dataclass

from palpate_editor.document import Organ, phrase
from palpate_editor.edits.edit import EditError
from palpate_editor.edits.set_constant import replace_field


@dataclass(frozen=True)
class SetReach:
    """Let a linear solid be pushed on one region of its surface, so that its response is smaller.

    Elsewhere it does not give.
    """

    region: str
    """Empty: all of the surface."""

    @property
    def title(self) -> str:
        if not self.region:
            return phrase("Reach: all of the surface")
        return phrase("Reach: {region}", region=self.region)

    def __call__(self, organ: Organ) -> Organ:
        check_region(organ, self.region)
        return replace_field(organ, "fill", "reach", self.region)


@dataclass(frozen=True)
class SetFineRegion:
    """Fill a solid finer at one region of its surface, where instruments work; there are as many
    tetrahedra as before, so they are larger elsewhere."""

    region: str
    """Empty: as fine everywhere."""

    @property
    def title(self) -> str:
        if not self.region:
            return phrase("Filling: as fine everywhere")
        return phrase("Filling finer at {region}", region=self.region)

    def __call__(self, organ: Organ) -> Organ:
        check_region(organ, self.region)
        changed = replace_field(organ, "fill", "fine_region", self.region)
        return replace_field(changed, "fill", "sizing", "counted") if self.region else changed


def check_region(organ: Organ, region: str) -> None:
    """Raises EditError for a name of no region, or of one without vertices."""
    if region and region not in organ.regions:
        raise EditError(phrase("There is no region {name}.", name=region))
    if region and not organ.regions[region].size:
        raise EditError(phrase("Region {name} has no vertices.", name=region))
