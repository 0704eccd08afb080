# SPDX-License-Identifier: GPL-3.0-or-later
"""The last resort: another surface around all of it."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np
import palpate
from palpate.scene.scene_parts import LATER

from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.carry import carry_paint
from palpate_editor.edits.dropped import Dropped, list_dropped
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.guarded import GuardedError, run_guarded

FINENESS = 1e-2
"""[-] of the diagonal: the ball that rolls around an organ where nobody says otherwise."""
SMALL_HOLE, PAST_HOLES = 0.025, 1.05
"""[-] of the diagonal: holes that reach no further from their middle are no openings of the organ;
of the largest one's reach: a ball that stays outside of it."""
SECONDS = 60.0
"""[s] A wrap may take: one that is asked for by hand may be much finer."""


def measure_small_holes(surface: Surface) -> float:
    """[m] How far the largest hole that is small reaches from its middle; 0 where there is none."""
    most = SMALL_HOLE * float(palpate.compute_diagonal(surface.vertices))
    radii = [0.0]
    for loop in palpate.find_border_loops(surface.triangles):
        x = surface.vertices[loop]
        radius = float(np.linalg.norm(x - x.mean(axis=0), axis=1).max())
        if radius <= most:
            radii.append(radius)
    return max(radii)


@dataclass(frozen=True, eq=False)
class Wrapped:
    """A surface around another one, and its price."""

    surface: Surface
    volume: float
    """[m³]"""
    to_source: float
    """[m] No point of it is further from what it was put around."""
    from_source: float
    """[m] Nothing that is seen of that from outside is further from it."""
    dropped: tuple[Dropped, ...]
    """What lay inside, the largest first."""


@dataclass(frozen=True)
class Wrap:
    """Put a closed surface that crosses nothing in the place of this one, around all of it.

    What lies inside is gone, and what is narrower than a ball is bridged. It takes the place of the
    imported surface; what was painted is carried over to it, and pieces that are gone are noted.
    """

    title: ClassVar[str] = "Wrap"
    drops_inside: ClassVar[bool] = True
    """So that how far it is from what lay there is no price."""

    alpha: float | None = None
    """[m] The radius of the ball; None for a hundredth of the organ's diagonal."""
    past_holes: bool = field(default=False, metadata={LATER: True})
    """With no radius: one that is larger than the small holes, where that is more. A ball that gets
    in through a tear of a few triangles wraps the inside as well, ten times as many triangles.
    Lines of before have nothing of it."""

    def __call__(self, organ: Organ) -> Organ:
        return self.put(organ, self.find(organ))

    def put(self, organ: Organ, wrapped: Wrapped) -> Organ:
        source = organ.source
        if source is not None and wrapped.dropped:
            source = replace(
                source,
                notes=(*source.notes, list_dropped(wrapped.dropped, "{piece} inside the wrap")),
            )
        changed = carry_paint(organ, wrapped.surface)
        return replace(changed, imported=wrapped.surface, decimation=None, source=source)

    def find(self, organ: Organ) -> Wrapped:
        """Around what was imported. Raises EditError."""
        surface = find_surface(organ) if organ.imported is None else organ.imported
        alpha = self.alpha
        if alpha is None:
            alpha = FINENESS * float(palpate.compute_diagonal(surface.vertices))
            if self.past_holes:
                alpha = max(alpha, PAST_HOLES * measure_small_holes(surface))
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
        told = found.told
        return Wrapped(
            found.surface,
            told["volume"],
            told["to_source"],
            told["from_source"],
            tuple(Dropped(p["triangles"], p["size"], tuple(p["middle"])) for p in told["dropped"]),
        )
