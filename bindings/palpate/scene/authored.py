# SPDX-License-Identifier: BSD-3-Clause
"""The constants in the designer's document of a published file."""

from __future__ import annotations

import json
from typing import get_type_hints

from palpate.files.json_part import read_part
from palpate.files.refusal import Refusal
from palpate.scenario import Scenario
from palpate.scene.scene_parts import SceneFile


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
