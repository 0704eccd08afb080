# SPDX-License-Identifier: BSD-3-Clause
"""Colours of the room around the organ, and how strong its light is."""

from __future__ import annotations

from dataclasses import dataclass

Colour = tuple[float, float, float]
"""sRGB, each 0 to 1."""

TISSUE: Colour = (0.72, 0.33, 0.29)
"""An organ without a colour map."""
STEEL: Colour = (0.80, 0.83, 0.86)
FORCE: Colour = (0.90, 0.16, 0.13)
"""The arrow that shows what the hand feels."""
SELECTED: Colour = (1.0, 0.55, 0.0)


@dataclass(frozen=True)
class Theme:
    """One look for pictures, plots and windows."""

    backdrop: Colour
    """The background behind the organ."""
    corner: Colour
    """The background at its darkest."""
    text: Colour
    faint: Colour
    """Text of less weight, frames."""
    panel: Colour
    """Behind text that must be read over anything."""
    alarm: Colour
    """Of what went wrong."""
    shadow: Colour
    shadow_strength: float
    """[-] of the shadow on the floor."""
    ambient: float
    """[-] light from all around."""


DARK = Theme(
    backdrop=(0.33, 0.355, 0.39),
    corner=(0.10, 0.11, 0.13),
    text=(0.94, 0.95, 0.96),
    faint=(0.66, 0.69, 0.73),
    panel=(0.07, 0.08, 0.095),
    alarm=(1.0, 0.38, 0.33),
    shadow=(0.02, 0.025, 0.035),
    shadow_strength=0.62,
    ambient=0.56,
)
LIGHT = Theme(
    backdrop=(0.985, 0.987, 0.99),
    corner=(0.83, 0.85, 0.875),
    text=(0.11, 0.13, 0.16),
    faint=(0.38, 0.42, 0.47),
    panel=(1.0, 1.0, 1.0),
    alarm=(0.80, 0.13, 0.10),
    shadow=(0.30, 0.33, 0.40),
    shadow_strength=0.50,
    ambient=0.58,
)

THEMES = {"dark": DARK, "light": LIGHT}
