# SPDX-License-Identifier: BSD-3-Clause
"""The usual numbers of instruments, as meshes/published/tools draws them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class InstrumentKind:
    """What of an instrument touches."""

    radius: float
    """[m]"""
    length: float
    """[m]"""
    friction: float
    """[-] Smooth metal on wet serosa has 0.05 to 0.15, profiled jaws 0.3 to 0.8
    (core/CONTACT.md)."""
    jaw_opening: float = 0.0
    """[rad]"""


KINDS = {
    "ball": InstrumentKind(3e-3, 0.0, 0.0),
    "probe": InstrumentKind(2.5e-3, 0.02, 0.1),
    "laparoscope": InstrumentKind(5e-3, 0.02, 0.1),
    "grasper": InstrumentKind(1.2e-3, 0.02, 0.5, 0.52),
    "syringe": InstrumentKind(4e-4, 0.04, 0.1),
}
