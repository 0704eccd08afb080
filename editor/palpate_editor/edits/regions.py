# SPDX-License-Identifier: GPL-3.0-or-later
"""Naming places of an organ: the hilum, a pole, where it is attached."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from palpate_editor.document import Organ, phrase
from palpate_editor.edits.edit import EditError, check_vertices
from palpate_editor.edits.name import check_text

MOST_NAME_BYTES = 100
MOST_REGIONS = 200
"""A file has room for a few more arrays than these."""


@dataclass(frozen=True, eq=False)
class SetRegion:
    """Give a set of vertices a name, or a name another set."""

    name: str
    vertices: np.ndarray
    """Vertex numbers, (k,), in any order"""

    @property
    def title(self) -> str:
        count = int(np.size(self.vertices))
        return phrase("Region {name}: {count} vertices", name=self.name, count=count)

    def __call__(self, organ: Organ) -> Organ:
        if not self.name.strip():
            raise EditError(phrase("A region needs a name."))
        check_text("name", self.name, MOST_NAME_BYTES)
        if self.name not in organ.regions and len(organ.regions) >= MOST_REGIONS:
            raise EditError(phrase("An organ has at most {most} regions.", most=MOST_REGIONS))
        ids = np.unique(check_vertices(organ, self.vertices))
        return replace(organ, regions={**organ.regions, self.name: ids})


@dataclass(frozen=True)
class RemoveRegion:
    """Forget the name of a region; its vertices stay as they are."""

    name: str

    @property
    def title(self) -> str:
        return phrase("Remove region {name}", name=self.name)

    def __call__(self, organ: Organ) -> Organ:
        if self.name not in organ.regions:
            raise EditError(phrase("There is no region {name}.", name=self.name))
        left = {name: ids for name, ids in organ.regions.items() if name != self.name}
        return replace(organ, regions=left)
