# SPDX-License-Identifier: GPL-3.0-or-later
"""Which tissue of the library an organ, or a region of it, was given."""

from __future__ import annotations

from dataclasses import dataclass

STATUSES = ("checked", "recalled", "unknown")
"""Read in its source; quoted or from memory; a number that nobody has published."""
MOST_TISSUES = 65
"""Of an organ: one for all of it, one for each region."""


@dataclass(frozen=True)
class AppliedTissue:
    """A tissue with the constants that were taken from it. Its status is that of the stiffness."""

    name: str
    """In the library, such as "heart_muscle"."""
    title: str
    region: str
    """Empty for all of the organ."""
    young_modulus: float
    """[Pa]"""
    poisson_ratio: float | None
    """None where the organ's own was kept, as a region does."""
    density: float | None
    """[kg/m³]"""
    wall_thickness: float | None
    """[m]"""
    status: str
    """One of STATUSES."""
    source: str
    """Of Young's modulus; empty where it is the designer's own."""
