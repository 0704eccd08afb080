# SPDX-License-Identifier: GPL-3.0-or-later
"""Working files of older versions: what makes of each one of the next."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import Field, fields
from typing import Any

import numpy as np
from palpate.files.json_part import json_kind
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import FILLED, FillPart, HandPart, MaterialPart, ModelPart, ToolPart

NUMBERS = {
    "material": MaterialPart,
    "model": ModelPart,
    "fill": FillPart,
    "tool": ToolPart,
    "hand": HandPart,
}
"""Parts of numbers that every file has."""

Json = dict[str, Any]
Arrays = dict[str, np.ndarray]


def choose_constants(content: Json, arrays: Arrays) -> tuple[Json, Arrays]:
    """Version 2 can have constants from tissue, and let it sleep; before, nothing did."""
    content["model"] |= {"constants": "chosen", "spring_rule": "van_gelder"}
    content["hand"] |= {"force_error": 0.0}
    return content, arrays


def choose_filling(content: Json, arrays: Arrays) -> tuple[Json, Arrays]:
    """Version 3 says how a solid is filled; before, all were filled alike."""
    content["fill"] = {"tetrahedra": 3000, "nodal_share": 0.9, "reach": ""}
    return content, arrays


def choose_substeps(content: Json, arrays: Arrays) -> tuple[Json, Arrays]:
    """Version 4 can ask for more substeps than the tissue needs; before, nothing did."""
    content["hand"] |= {"substeps": 0}
    return content, arrays


def name_appearance(content: Json, arrays: Arrays) -> tuple[Json, Arrays]:
    """Version 5 has the terms of renderers: the look is the appearance, its softness subsurface."""
    rename_field(content, "", "look", "appearance")
    if content["appearance"] is not None:
        rename_field(content["appearance"], "look.", "softness", "subsurface")
    return content, arrays


def rename_field(part: Any, place: str, old: str, new: str) -> None:
    """Refuses what is no object with the old name, and one that has the new one already."""
    if not isinstance(part, dict):
        raise Refusal("", place.rstrip("."), json_kind(part), "an object")
    if new in part:
        raise Refusal("", place + new, "an unknown field", old)
    if old not in part:
        raise Refusal("", place + old, "nothing", "a field of this name")
    part[new] = part.pop(old)


def keep_hard_contact(content: Json, arrays: Arrays) -> tuple[Json, Arrays]:
    """Version 7 has a law of contact; before, solids were felt as their mesh gives way."""
    if content["model"].get("kind") in FILLED:
        content["model"] |= {"contact_law": "hard"}
    return content, arrays


def keep_filling(content: Json, arrays: Arrays) -> tuple[Json, Arrays]:
    """Version 9 counts tetrahedra; before, one size was estimated, and solids keep theirs."""
    if content["model"].get("kind") in FILLED and isinstance(content.get("fill"), dict):
        content["fill"] |= {"sizing": "estimated"}
    return content, arrays


def keep_hard_walls(content: Json, arrays: Arrays) -> tuple[Json, Arrays]:
    """Version 10 has the near field of walls; before, they were felt by the hard law, whatever the
    file said."""
    if content["model"].get("kind") == "shell":
        content["model"] |= {"contact_law": "hard"}
    return content, arrays


MIGRATIONS: dict[int, Callable[[Json, Arrays], tuple[Json, Arrays]]] = {
    1: choose_constants,
    2: choose_filling,
    3: choose_substeps,
    4: name_appearance,
    6: keep_hard_contact,
    8: keep_filling,
    9: keep_hard_walls,
}
"""Version -> what makes of a document of that version one of the next, beside the new fields."""


def list_new_fields() -> list[tuple[int, str, Field[Any]]]:
    """(version, part, field) of every number that came after version 1 with its usual value."""
    return [
        (field.metadata["since"], name, field)
        for name, kind in NUMBERS.items()
        for field in fields(kind)
        if "since" in field.metadata
    ]


VERSION = max(
    *(version + 1 for version in MIGRATIONS), *(version for version, _, _ in list_new_fields()), 0
)
"""The newest: of a migration, or of a field."""


def migrate(step: int, content: Json, arrays: Arrays) -> tuple[Json, Arrays]:
    """What makes of a document of version `step` one of the next."""
    if step in MIGRATIONS:
        content, arrays = MIGRATIONS[step](content, arrays)
    for version, name, field in list_new_fields():
        if version == step + 1 and isinstance(content.get(name), dict):
            content[name] = {field.name: field.default} | content[name]
    return content, arrays


def migrate_begin(step: int, content: Json, file: str) -> None:
    """The same for what a history begins with."""
    history = content.get("history")
    begin = history.get("begin") if isinstance(history, dict) else None
    if isinstance(begin, dict):
        check_parts(begin.get("content"), file)
        begin["content"], _ = migrate(step, begin["content"], {})


def check_parts(content: Any, file: str) -> None:
    """Refuses what no migration can begin with."""
    if not isinstance(content, dict):
        raise Refusal(file, "", json_kind(content), "an object")
    for name in ("model", "hand"):
        if not isinstance(content.get(name), dict):
            raise Refusal(file, name, json_kind(content.get(name)), "an object")
