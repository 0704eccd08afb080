# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever an edit makes of the organ's surfaces has the colours of those that were there."""

from __future__ import annotations

from dataclasses import replace

from palpate_editor.document import Organ, Surface
from palpate_editor.vertex_colours import carry_colours


def keep_colours(before: Organ, after: Organ) -> Organ:
    """`after` in the colours of `before`, where it has surfaces that it had not.

    An edit that moves vertices or takes colours off says so by a surface that has the colours
    already, or the very vertices of before.
    """
    source = find_coloured(before)
    if source is None or after.surface is None:
        return after
    surface = dress(after.surface, before, source)
    imported = after.imported
    if imported is after.surface:
        imported = surface
    elif imported is not None:
        imported = dress(imported, before, source)
    if surface is after.surface and imported is after.imported:
        return after
    return replace(after, surface=surface, imported=imported)


def find_coloured(organ: Organ) -> Surface | None:
    """The finer of the organ's surfaces first."""
    for surface in (organ.imported, organ.surface):
        if surface is not None and surface.colours is not None:
            return surface
    return None


def dress(surface: Surface, before: Organ, source: Surface) -> Surface:
    """The surface itself where it is not a new one."""
    known = [each.vertices for each in (before.surface, before.imported) if each is not None]
    if surface.colours is not None or any(surface.vertices is x for x in known):
        return surface
    return carry_colours(surface, source)
