# SPDX-License-Identifier: GPL-3.0-or-later
"""What a new organ is made of: the constants of demo.toml, the one place where they stand.

Chosen so that a surface feels like an organ at the first press; not derived from tissue.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

from palpate.scene.scene_parts import FillPart, HandPart, MaterialPart, ModelPart, ToolPart

CONSTANTS = Path(__file__).parents[1] / "demo.toml"
"""The file, with the words for every number."""

TABLES = tomllib.loads(CONSTANTS.read_text(encoding="utf-8"))

WALL_THICKNESS: float = TABLES["material"]["wall_thickness"]
"""[m] of a hollow organ or a sheet, once it is told to be one."""
FIXED_SHARE: float = TABLES["surroundings"]["fix_lowest"]
"""[-] of the height that rests on a table."""

MATERIAL = MaterialPart(**TABLES["material"] | {"wall_thickness": None})
MODEL = ModelPart(
    drag=TABLES["surroundings"]["drag"],
    # the constants of the molecular model are kept beside those of the springs, which an
    # organ may change to; where both have one, the springs' counts
    **TABLES["mms"] | TABLES["mss"],
)
FILL = FillPart()
TOOL = ToolPart(**TABLES["tool"])
HAND = HandPart(**TABLES["hand"])
