# SPDX-License-Identifier: GPL-3.0-or-later
"""The last resort: another surface around all of it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import palpate

from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.carry import carry_paint
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.guarded import GuardedError, run_guarded

FINENESS = 1e-2
"""[-] of the diagonal: the ball that rolls around an organ where nobody says otherwise."""
SECONDS = 60.0
"""[s] A wrap may take: one that is asked for by hand may be much finer."""


@dataclass(frozen=True)
class Wrap:
    """Put a closed surface that crosses nothing in the place of this one, around all of it.

    What lies inside is gone, and what is narrower than a ball is bridged. It takes the place of the
    imported surface; what was painted is carried over to it.
    """

    title: ClassVar[str] = "Wrap"

    alpha: float | None = None
    """[m] The radius of the ball; None for a hundredth of the organ's diagonal."""

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        whole = surface if organ.imported is None else organ.imported
        wrapped = self.wrap(whole)
        changed = carry_paint(organ, wrapped)
        return replace(changed, imported=wrapped, decimation=None)

    def wrap(self, surface: Surface) -> Surface:
        alpha = self.alpha
        if alpha is None:
            alpha = FINENESS * float(palpate.compute_diagonal(surface.vertices))
        try:
            found = run_guarded("wrap", surface, {"alpha": alpha}, SECONDS)
        except GuardedError as problem:
            raise EditError(phrase("It cannot be wrapped: {why}", why=str(problem))) from None
        if found is None:
            raise EditError(
                phrase(
                    "A wrap by a ball of {alpha:.3g} mm was not finished in {seconds:g} s: take a "
                    "larger one.",
                    alpha=1e3 * alpha,
                    seconds=SECONDS,
                )
            )
        return found.surface
