# SPDX-License-Identifier: GPL-3.0-or-later
"""What an edit is, and how it refuses."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np

from palpate_editor.document import Organ, Phrase, Surface, phrase


class EditError(Exception):
    """An edit that cannot be done; the organ is what it was."""

    def __init__(self, sentence: Phrase):
        super().__init__(sentence)
        self.sentence = sentence


class Edit(Protocol):
    """A change of an organ, as a value."""

    @property
    def title(self) -> str:
        """What undo and redo call it, in English; windows translate it."""

    def __call__(self, organ: Organ) -> Organ: ...


def find_surface(organ: Organ) -> Surface:
    """The surface an edit works on. Raises EditError where nothing has been imported."""
    if organ.surface is None:
        raise EditError(phrase("There is no organ yet: import a mesh file first."))
    return organ.surface


def check_vertices(organ: Organ, vertices: Any) -> np.ndarray:
    """Vertex numbers as indices. Raises EditError for numbers the surface does not have."""
    find_surface(organ)
    ids = np.asarray(vertices)
    if ids.size == 0:
        raise EditError(phrase("No vertices are selected."))
    if ids.ndim != 1 or not np.issubdtype(ids.dtype, np.integer):
        raise EditError(phrase("Vertices are chosen by whole numbers."))
    if ids.min() < 0 or ids.max() >= organ.vertex_count:
        raise EditError(
            phrase(
                "Vertex numbers: got {low} to {high}, expected 0 to {most}.",
                low=int(ids.min()),
                high=int(ids.max()),
                most=organ.vertex_count - 1,
            )
        )
    return ids
