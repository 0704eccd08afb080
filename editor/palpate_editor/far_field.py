# SPDX-License-Identifier: GPL-3.0-or-later
"""Solving the far field of the organ on the desk, as an edit."""

from __future__ import annotations

from dataclasses import dataclass

from palpate_editor.document import Organ, phrase
from palpate_editor.document.far_compliance import compute_key, wants_far_field
from palpate_editor.edits import EditError, SetFarField


@dataclass(frozen=True)
class SolveFarField:
    """Solve on a finer mesh how the organ gives way beyond the ball.

    Some seconds: beside the window (prepare).
    """

    title = phrase("Far field of a finer mesh")

    def __call__(self, organ: Organ) -> Organ:
        # it loads the solver, which may not be installed
        from palpate_editor.truth.far_field import solve_far_field
        from palpate_editor.truth.progress import TruthError

        if not wants_far_field(organ):
            raise EditError(
                phrase("Only a solid with contact as on tissue, without a wall, has a far field.")
            )
        if organ.far_field is not None and organ.far_field.key == compute_key(organ):
            raise EditError(phrase("The far field is that of a finer mesh already."))
        try:
            found = solve_far_field(organ)
        except TruthError as problem:
            raise EditError(phrase("{problem}", problem=str(problem))) from None
        return SetFarField(found)(organ)
