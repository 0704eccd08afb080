# SPDX-License-Identifier: BSD-3-Clause
"""How a simulated hand is. All numbers are invented, and none is of a person."""

from __future__ import annotations

import random
from dataclasses import dataclass, fields, replace


@dataclass(frozen=True)
class Skill:
    """How a hand is."""

    delay: float
    """[s] between what it feels or sees and what it does"""
    tremor: float
    """[m] root mean square, at some 9 Hz"""
    error: float
    """[-] of a force or depth that it aims at, standard deviation"""
    stiffness_error: float
    """[-] of the logarithm of the stiffness it expects, standard deviation"""
    gain: float
    """[1/s] with which it corrects a force"""
    pause: float
    """[s] before each step"""
    speed: float
    """[m/s] through the air"""
    lapses: float
    """[1/s] in which it slips, and goes 12 mm too far"""

    def vary(self, draw: random.Random) -> Skill:
        """Another person of the same skill: each number 20 % off, log-normal."""
        return replace(
            self,
            **{f.name: getattr(self, f.name) * draw.lognormvariate(0.0, 0.2) for f in fields(self)},
        )


CAREFUL = Skill(0.16, 6e-5, 0.03, 0.15, 2.2, 0.25, 0.12, 0.0)
CLUMSY = Skill(0.24, 1.3e-4, 0.15, 0.45, 2.5, 0.5, 0.10, 0.15)
