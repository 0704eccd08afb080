# SPDX-License-Identifier: GPL-3.0-or-later
"""What a designer works on, as values: an organ, its surface, where it came from.

Nothing here changes once made. An edit makes a new organ that shares with the old one whatever it
left alone, so to undo is to remember. No Qt and no simulation.
"""

from __future__ import annotations

from palpate_editor.document.far_field import FarField
from palpate_editor.document.history import Line
from palpate_editor.document.organ import (
    EMPTY,
    Assembly,
    Decimation,
    History,
    Organ,
    Repairs,
    Segmentation,
    Source,
    Translation,
    is_language,
)
from palpate_editor.document.phrase import Phrase, phrase
from palpate_editor.document.surface import Filling, Surface, freeze
from palpate_editor.document.tissue import AppliedTissue

__all__ = [
    "EMPTY",
    "AppliedTissue",
    "Assembly",
    "Decimation",
    "FarField",
    "Filling",
    "History",
    "Line",
    "Organ",
    "Phrase",
    "Repairs",
    "Segmentation",
    "Source",
    "Surface",
    "Translation",
    "freeze",
    "is_language",
    "phrase",
]
