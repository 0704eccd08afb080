# SPDX-License-Identifier: GPL-3.0-or-later
"""Choosing where a linear solid can be pushed."""

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
        if self.region and self.region not in organ.regions:
            raise EditError(phrase("There is no region {name}.", name=self.region))
        if self.region and not organ.regions[self.region].size:
            raise EditError(phrase("Region {name} has no vertices.", name=self.region))
        return replace_field(organ, "fill", "reach", self.region)
