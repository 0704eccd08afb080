# SPDX-License-Identifier: BSD-3-Clause
"""How the organ of a published file takes the light, as its designer chose it."""

from __future__ import annotations

import json
from typing import Any

from palpate.files.json_part import read_part
from palpate.files.refusal import Refusal
from palpate.render.part import Appearance, build_appearance
from palpate.scenario import Scenario
from palpate.scene.scene_parts import AppearancePart

RENAMED = 5
"""Version of the document that calls the look appearance, and its softness subsurface."""


def find_appearance(scenario: Scenario) -> Appearance | None:
    """How the organ takes the light; None where nothing was said, or nothing one can understand.

    An appearance is nothing to train with, so a strange one is no reason to refuse the file.
    """
    try:
        document = json.loads(scenario.authored)
        part = find_part(document["content"], document["version"])
        return build_appearance(read_part("", "appearance", AppearancePart, part, whole=True))
    except (ValueError, LookupError, TypeError, RecursionError, Refusal):
        return None


def find_part(content: dict[str, Any], version: int) -> object:
    """The appearance of a designer's document of any version."""
    if version >= RENAMED:
        return content["appearance"]
    part = dict(content["look"])
    part["subsurface"] = part.pop("softness")
    return part
