# SPDX-License-Identifier: BSD-3-Clause
"""What a player may use of the designer's document in a published file; nothing depends on it."""

from __future__ import annotations

import json
from typing import get_type_hints

from palpate.json_part import read_part
from palpate.render import Look, build_look
from palpate.scenario import Scenario
from palpate.scene_parts import LookPart, SceneFile
from palpate.verb import Refusal


def find_look(scenario: Scenario) -> Look | None:
    """How the organ takes the light; None where nothing was said, or nothing one can understand.

    A look is nothing to train with, so a strange one is no reason to refuse the file.
    """
    try:
        content = json.loads(scenario.authored)["content"]
        return build_look(read_part("", "look", LookPart, content["look"], whole=True))
    except (ValueError, LookupError, TypeError, RecursionError, Refusal):
        return None


def read_constants(file: object, scenario: Scenario) -> SceneFile:
    """Material, model, tool and hand as the designer chose them; no organ, nothing painted.

    Raises Refusal, which calls the file `file`.
    """
    kinds = get_type_hints(SceneFile)
    try:
        content = json.loads(scenario.authored)["content"]
        sections = {name: content[name] for name in ("material", "model", "tool", "hand")}
    except (ValueError, LookupError, TypeError, RecursionError):
        raise Refusal(file, "authored", "no constants", "what `palpate publish` writes") from None
    painted = ("fixed", "stiffness_scale")
    parts = {
        name: read_part(
            file, name, kinds[name], section, without=painted if name == "model" else ()
        )
        for name, section in sections.items()
    }
    return SceneFile(organ=None, **parts)
