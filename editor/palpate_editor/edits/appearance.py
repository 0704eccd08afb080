# SPDX-License-Identifier: GPL-3.0-or-later
"""How the organ looks: nothing of it is felt."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import ClassVar

from palpate.scene.scene_parts import AppearancePart, find_appearance_fault

from palpate_editor.appearance import make_appearance, read_styles
from palpate_editor.document import Organ, phrase
from palpate_editor.edits.edit import EditError
from palpate_editor.edits.history import LATER


def drop_colours(organ: Organ) -> Organ:
    """The organ with the same surfaces in one colour; surfaces that are one object stay one."""
    surface, imported = organ.surface, organ.imported
    plain = surface and (surface if surface.colours is None else replace(surface, colours=None))
    if imported is surface:
        whole = plain
    else:
        has_colours = imported is not None and imported.colours is not None
        whole = replace(imported, colours=None) if imported and has_colours else imported
    return replace(organ, surface=plain, imported=whole)


@dataclass(frozen=True)
class SetAppearance:
    """Give the organ one of the appearances that ship, in its own colour or another, or in those
    that its file gave its vertices."""

    title: ClassVar[str] = "Set the appearance"

    style: str | None
    """Of palpate_editor.appearance.read_styles; None for plain tissue."""
    colour: tuple[float, ...] | None = None
    """sRGB, 0 to 1; None for the style's own."""
    of_vertices: bool = field(default=False, metadata={LATER: True})
    """Keep the colours of the vertices; else they go. Lines of before have no such colours."""

    def __call__(self, organ: Organ) -> Organ:
        made = replace(organ, appearance=self.find_appearance())
        return made if self.of_vertices else drop_colours(made)

    def find_appearance(self) -> AppearancePart | None:
        if self.style is None:
            return None
        if self.style not in read_styles():
            raise EditError(
                phrase(
                    "The style must be one of {known}, got {got}.",
                    known=", ".join(read_styles()),
                    got=self.style,
                )
            )
        if self.colour is not None:
            wrong = len(self.colour) != 3 or not all(0.0 <= part <= 1.0 for part in self.colour)
            if wrong:
                raise EditError(
                    phrase(
                        "A colour is three numbers of 0 to 1, got {got}.",
                        got=", ".join(f"{part:g}" for part in self.colour),
                    )
                )
        appearance = make_appearance(self.style, self.colour)
        assert find_appearance_fault(appearance) is None
        return appearance
