# SPDX-License-Identifier: GPL-3.0-or-later
"""All that can be repaired of a surface, as one edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from palpate_editor.document import Organ, phrase
from palpate_editor.edits.edit import EditError
from palpate_editor.edits.ladder import climb


@dataclass(frozen=True)
class RepairAll:
    """Climb the ladder of repairs: from cleaning to, where nothing else helps, a wrap."""

    title: ClassVar[str] = "Repair all"

    def __call__(self, organ: Organ) -> Organ:
        found = climb(organ)
        if not found.rungs:
            raise EditError(phrase("There is nothing to repair that can be."))
        return found.organ
