# SPDX-License-Identifier: GPL-3.0-or-later
"""What is asked of a trainee and judged: the whole of it is one value of the organ."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace

from palpate_editor.document import Organ, phrase
from palpate_editor.edits.edit import EditError

MOST_ASSESSMENT_BYTES = 400_000
"""So that a line of the history holds it."""
CHANGES = {
    "new": phrase("Begin a scenario"),
    "step": phrase("Add a step"),
    "change": phrase("Change a step"),
    "tool": phrase("Change an instrument"),
    "order": phrase("Order the steps"),
    "duplicate": phrase("Duplicate a step"),
    "mute": phrase("Mute a step"),
    "remove": phrase("Remove a step"),
    "place": phrase("Draw a place"),
    "record": phrase("Record a step from a hand"),
    "limit": phrase("Change the limits"),
    "text": phrase("Change a text"),
    "level": phrase("Change the levels"),
    "parameter": phrase("Change a parameter"),
    "finish": phrase("Change the time limit"),
}


@dataclass(frozen=True)
class SetAssessment:
    """Take an assessment, written as JSON; an empty text for none."""

    assessment: str
    change: str = "change"
    """What was done to it, one of CHANGES."""

    @property
    def title(self) -> str:
        return CHANGES.get(self.change, CHANGES["change"])

    def __call__(self, organ: Organ) -> Organ:
        if self.assessment:
            check_assessment(self.assessment)
        elif not organ.assessment:
            raise EditError(phrase("There is no scenario to take away."))
        return replace(organ, assessment=self.assessment)


def check_assessment(text: str) -> None:
    """Whether a file can keep it; whether it can be judged is for the checks to say."""
    if len(text.encode(errors="replace")) > MOST_ASSESSMENT_BYTES:
        raise EditError(
            phrase("The scenario has more than {most} bytes.", most=MOST_ASSESSMENT_BYTES)
        )
    try:
        found = json.loads(text, parse_constant=refuse_constant)
        text.encode()
    except (ValueError, RecursionError):
        raise EditError(phrase("The scenario is not JSON that a file can keep.")) from None
    if not isinstance(found, dict) or "palpate_scenario" not in found:
        raise EditError(phrase("The scenario does not say palpate_scenario."))


def refuse_constant(name: str) -> float:
    """NaN and infinity, which are no JSON."""
    raise ValueError(name)
