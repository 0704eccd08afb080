# SPDX-License-Identifier: GPL-3.0-or-later
"""How a solid organ gives way beyond the ball: a table of a finer mesh, or its own."""

from __future__ import annotations

from dataclasses import dataclass, replace

from palpate_editor.document import Organ, phrase
from palpate_editor.document.far_compliance import wants_far_field
from palpate_editor.document.far_field import FarField
from palpate_editor.edits.edit import EditError, find_surface


@dataclass(frozen=True)
class SetFarField:
    """Keep a far field that was solved (palpate_editor.truth.far_field), or none."""

    far_field: FarField | None

    @property
    def title(self) -> str:
        if self.far_field is None:
            return phrase("Far field of the mesh")
        return phrase("Far field of a finer mesh")

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if self.far_field is None:
            if organ.far_field is None:
                raise EditError(phrase("The far field is that of the mesh already."))
            return replace(organ, far_field=None)
        if not wants_far_field(organ):
            raise EditError(
                phrase("Only a solid with contact as on tissue, without a wall, has a far field.")
            )
        if len(self.far_field.softness) != 6 * len(surface.vertices):
            raise EditError(
                phrase(
                    "The far field has {got} numbers, expected {count}, six per vertex.",
                    got=len(self.far_field.softness),
                    count=6 * len(surface.vertices),
                )
            )
        return replace(organ, far_field=self.far_field)
