# SPDX-License-Identifier: BSD-3-Clause
"""The usual numbers of instruments, as the shipped description has them."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

DESCRIPTIONS = Path(__file__).with_name("instruments.toml")
"""A copy of meshes/tools.toml, which `./run meshes` writes; says what each number follows from."""


@dataclass(frozen=True)
class InstrumentKind:
    """What of an instrument touches."""

    radius: float
    """[m]"""
    length: float
    """[m]"""
    friction: float
    """[-]"""
    jaw_opening: float = 0.0
    """[rad]"""

    @property
    def idle(self) -> tuple[str, ...]:
        """Numbers of an instrument that this has not: of a shaft, or of jaws."""
        of_shaft = () if self.length else ("length",)
        return (*of_shaft, *(() if self.jaw_opening else ("jaw_opening", "grip_force")))


def read_descriptions() -> dict[str, dict[str, Any]]:
    """All that is known of every instrument, in the frame of its mesh: tip at 0, shaft along -z."""
    return tomllib.loads(DESCRIPTIONS.read_text(encoding="utf-8"))


def read_kind(table: Mapping[str, Any]) -> InstrumentKind:
    """What touches of a described instrument: as said, or as its needle, shaft and jaws are."""
    said, needle = table["touches"], table.get("needle", {})
    follows = {**table.get("shapes", [{}])[0], **needle, **said}
    return InstrumentKind(
        radius=follows["radius"],
        length=follows["length"],
        friction=said["friction"],
        jaw_opening=table.get("jaws", {}).get("open", 0.0),
    )


KINDS = {name: read_kind(table) for name, table in read_descriptions().items()}
