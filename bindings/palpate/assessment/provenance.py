# SPDX-License-Identifier: BSD-3-Clause
"""What is known of a published task beside the task itself: how hands fared, and who looked at it.

Both stand in the assessment, and neither counts for its hash. Each says of which content it is: the
assessment without them, and the scene. After a change of either they are void, and said to be.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable
from copy import copy
from datetime import UTC, datetime
from importlib.metadata import version
from typing import Any

import numpy as np

from palpate import scenario
from palpate.assessment.selfplay import Attempt, judge_hands

SELFPLAY, REVIEWS = "selfplay", "reviews"
REVIEWED = ("anatomy", "feel", "task", "translation")
"""What a review may be of."""
MOST_REVIEWS = 100

Json = dict[str, Any]


def hash_content(published: scenario.Scenario) -> str:
    """SHA-256 of the assessment without self-play and reviews, and of all tables of the scene
    with its pairs of bodies, rigid bodies and scenery."""
    found = hashlib.sha256(scenario.draw_task(published).sha256.encode())
    packed = scenario.pack(published)
    scene, arrays = json.loads(packed.content)["scene"], packed.arrays
    if scene["body_pairs"]:  # without any, a hash is what it was before there were some
        found.update(json.dumps(scene["body_pairs"], sort_keys=True).encode())
    if scene["rigid"] or scene["scenery"]:  # likewise
        hard = {name: scene[name] for name in ("rigid", "scenery", "fluid")}
        found.update(json.dumps(hard, sort_keys=True).encode())
    for name in sorted(arrays):
        if name.startswith("scene/"):
            found.update(name.encode() + b"\n" + np.asarray(arrays[name]).tobytes())
    return found.hexdigest()


def now() -> str:
    return datetime.now(UTC).isoformat(timespec="seconds")


def describe_selfplay(published: scenario.Scenario, played: Iterable[Attempt]) -> Json:
    """The report of a self-play, as it travels in a package."""
    rows = list(played)
    return {
        "made_by": f"palpate {version('palpate')}",
        "date": now(),
        "content_sha256": hash_content(published),
        "hands_are": "simulated; all their numbers are invented, and they are no evidence of what "
        "the task teaches or measures",
        "attempts": [row.describe() for row in rows],
        "problems": judge_hands(rows),
    }


def with_selfplay(published: scenario.Scenario, report: Json) -> scenario.Scenario:
    return with_member(published, SELFPLAY, report)


def with_review(
    published: scenario.Scenario, of: str, by: str, role: str, date: str = ""
) -> scenario.Scenario:
    """With one more review, of one of REVIEWED, of the content as it is now."""
    if of not in REVIEWED:
        raise ValueError(f"of: got {of!r}, expected one of {', '.join(REVIEWED)}")
    if not by.strip() or not role.strip():
        raise ValueError("by, role: got nothing, expected who reviewed it, and as what")
    reviews = json.loads(published.assessment).get(REVIEWS, [])
    row = {"of": of, "by": by, "role": role, "date": date or now(),
           "content_sha256": hash_content(published)}  # fmt: skip
    return with_member(published, REVIEWS, [*reviews, row][-MOST_REVIEWS:])


def with_member(published: scenario.Scenario, name: str, value: object) -> scenario.Scenario:
    assessment = json.loads(published.assessment)
    assessment[name] = value
    made = copy(published)
    made.assessment = json.dumps(assessment, ensure_ascii=False)
    return made


def find_void(published: scenario.Scenario) -> list[str]:
    """What is of another content than the file has now: `selfplay`, `reviews[0]` ..."""
    assessment = json.loads(published.assessment)
    rows = [(SELFPLAY, assessment[SELFPLAY])] if SELFPLAY in assessment else []
    rows += [(f"{REVIEWS}[{k}]", row) for k, row in enumerate(assessment.get(REVIEWS, []))]
    if not rows:
        return []
    content = hash_content(published)
    return [where for where, row in rows if row.get("content_sha256") != content]
