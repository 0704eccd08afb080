# SPDX-License-Identifier: BSD-3-Clause
"""The same task once more, with what another seed draws."""

from __future__ import annotations

import json

from palpate.assessment.publish import take_attempt
from palpate.files.refusal import Refusal
from palpate.runs.play import Play, draw_attempt


def has_next(play: Play) -> bool:
    """Whether a seed draws anything of the task."""
    if play.drawn is None or play.published is None:
        return False
    rows = json.loads(play.published.assessment).get("parameters", {})
    return any("uniform" in row or "choose" in row for row in rows.values())


def draw_next(play: Play) -> None:
    """The next seed: another task, and where a lump is hidden another scene. Raises Refusal, and
    leaves the play as it was.
    """
    assert play.drawn is not None and play.published is not None
    drawn = draw_attempt(play.path, play.published, play.drawn.level, play.drawn.seed + 1)
    try:
        scenario = take_attempt(play.published, drawn)
    except ValueError as problem:
        what = "an inclusion that can be built"
        raise Refusal(play.path, "assessment", str(problem), what) from None
    play.drawn, play.scenario = drawn, scenario
    play.state, play.samples = None, []
