# SPDX-License-Identifier: BSD-3-Clause
"""How the organ of a published file takes the light, as its designer chose it."""

from __future__ import annotations

import json

from palpate.files.json_part import read_part
from palpate.files.refusal import Refusal
from palpate.render.part import Look, build_look
from palpate.scenario import Scenario
from palpate.scene.scene_parts import LookPart


def find_look(scenario: Scenario) -> Look | None:
    """How the organ takes the light; None where nothing was said, or nothing one can understand.

    A look is nothing to train with, so a strange one is no reason to refuse the file.
    """
    try:
        content = json.loads(scenario.authored)["content"]
        return build_look(read_part("", "look", LookPart, content["look"], whole=True))
    except (ValueError, LookupError, TypeError, RecursionError, Refusal):
        return None
