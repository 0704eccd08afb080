# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of a tool that a truth can be asked for."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Press:
    """A ball at one place, deeper and deeper."""

    near: tuple[float, float, float] | None = None
    """[m] The place is the closest point of the surface; None for where a check presses first."""


Path = Press
