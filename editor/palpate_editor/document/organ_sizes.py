# SPDX-License-Identifier: GPL-3.0-or-later
"""How large organs are, by the word that names them: for telling a wrong unit from a right one.

From corner to corner of the box around an adult's. Recalled from general anatomy and generous, as a
unit is wrong by ten or more; `tests/editor/test_organ_sizes.py` holds them to the organs that ship
and to those of the shared data.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

LEAST, MOST = 5e-3, 0.6
"""[m] No organ is smaller or larger."""
SIZES = {
    "kidney": (0.08, 0.22),
    "liver": (0.15, 0.45),
    "spleen": (0.07, 0.25),
    "pancreas": (0.09, 0.28),
    "gallbladder": (0.04, 0.18),
    "bladder": (0.04, 0.25),
    "stomach": (0.12, 0.40),
    "heart": (0.08, 0.25),
    "lung": (0.15, 0.45),
    "brain": (0.12, 0.28),
    "colon": (0.15, 0.80),
    "intestine": (0.15, 0.80),
    "bowel": (0.15, 0.80),
    "uterus": (0.05, 0.22),
    "prostate": (0.025, 0.10),
    "thyroid": (0.03, 0.12),
}
"""Word -> [m]."""
OF_ORGANS = {
    *(
        "stone",
        "stones",
        "valve",
        "artery",
        "arteries",
        "vein",
        "veins",
        "vessel",
        "vessels",
        "duct",
    ),
    *("lobe", "segment", "capsule", "pyramid", "cortex", "tumor", "tumour", "cyst", "ventricle"),
    *("atrium", "wall", "muscle", "piece", "part"),
}
"""Words that say it is something in or of an organ, which may be smaller."""
UNITS = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "um": 1e-6}
"""[m] That a file may be in without saying so, the likeliest first."""


def find_word(names: Iterable[str]) -> str | None:
    """The first word, as it is written there, that says which organ it is; None of a part."""
    words = [word for name in names for word in re.findall(r"[^\W\d_]+", name)]
    if any(word.lower() in OF_ORGANS for word in words):
        return None
    return next((word for word in words if word.lower() in SIZES), None)


def find_range(word: str | None) -> tuple[float, float]:
    """[m] Between which such an organ is; any organ for None."""
    return (LEAST, MOST) if word is None else SIZES[word.lower()]


def find_fitting_unit(diagonal: float, word: str | None) -> str | None:
    """The one unit in which something `diagonal` units long is an organ of that name; None where
    none is, or several are."""
    least, most = find_range(word)
    fitting = [unit for unit, size in UNITS.items() if least <= diagonal * size <= most]
    return fitting[0] if len(fitting) == 1 else None
