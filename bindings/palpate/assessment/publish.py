# SPDX-License-Identifier: BSD-3-Clause
"""Puts an assessment, written as JSON, into a published scenario."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from palpate import scenario
from palpate.assessment.author import make_ids, without_muted
from palpate.assessment.inclusion import gather_constants
from palpate.assessment.instruments import require_effect, shape_tools
from palpate.files.read_file import read_file
from palpate.files.refusal import Refusal, split_sentence

MOST_BYTES = 4 * 2**20

Json = dict[str, Any]


def read_assessment(path: Path) -> Json:
    """The object in a file. Raises Refusal or OSError."""
    try:
        data = json.loads(read_file(path, MOST_BYTES))
    except (ValueError, RecursionError) as problem:
        raise Refusal(path, "", f"text that is not JSON ({problem})", "an assessment") from None
    if not isinstance(data, dict) or "palpate_scenario" not in data:
        found = "no palpate_scenario" if isinstance(data, dict) else "no object"
        raise Refusal(path, "", found, "an assessment, which says palpate_scenario first")
    return data


def find_regions(file: object, published: scenario.Scenario) -> dict[str, NDArray[np.int32]]:
    """The vertices of the surface of each region that the designer named.

    Raises Refusal, which calls the file `file`.
    """
    try:
        names = json.loads(published.authored)["content"]["regions"]
        arrays = published.authored_arrays
        return {
            name: np.asarray(arrays[f"regions/{number}"], dtype=np.int32)
            for number, name in enumerate(names)
        }
    except (ValueError, LookupError, TypeError, RecursionError):
        raise Refusal(file, "authored", "no regions", "what `palpate publish` writes") from None


def list_bodies(published: scenario.Scenario) -> list[str]:
    """The ids of the bodies of a scene that `palpate scene publish` wrote, as its regions have
    them; of all else none."""
    return list_placed(published, "bodies")


def list_stones(published: scenario.Scenario) -> list[str]:
    """Likewise of its stones, which are objects of an assessment."""
    return list_placed(published, "stones")


def list_placed(published: scenario.Scenario, kind: str) -> list[str]:
    try:
        placed = json.loads(published.authored)["content"]["layout"][kind]
        return make_ids(str(each["name"]) for each in placed)
    except (ValueError, LookupError, TypeError, RecursionError):
        return []


def gather_places(
    file: object, assessment: Mapping[str, Any], published: scenario.Scenario
) -> dict[str, NDArray[np.int32]]:
    """By name of the array: the vertices of every place that is a region.

    Raises Refusal for a region that the organ has not.
    """
    gathered: dict[str, NDArray[np.int32]] = {}
    places = assessment.get("places")
    for name, place in places.items() if isinstance(places, dict) else ():
        said = place.get("region") if isinstance(place, dict) else None
        if not isinstance(said, str):
            continue  # what is wrong with it says the reader
        regions = find_regions(file, published)
        # a scene of several organs has them with the organ's name
        region = said if said in regions else said.partition("/")[2]
        if region not in regions:
            known = ", ".join(regions)
            raise Refusal(file, f"places.{name}.region", repr(said), f"organ/region, of {known}")
        gathered[f"places/{name}"] = regions[region]
    return gathered


def with_assessment(
    file: object, assessment: Mapping[str, Any], published: scenario.Scenario
) -> scenario.Scenario:
    """The published scenario with the assessment in it, its title and languages those of its texts.

    Raises Refusal, which calls the assessment `file`, for all that cannot be judged.
    """
    assessment = without_muted(dict(assessment))
    texts = assessment.get("texts")
    key = assessment.get("title")
    titles: dict[str, str] = {}
    for code, words in texts.items() if isinstance(texts, dict) else ():
        if isinstance(words, dict) and isinstance(key, str) and isinstance(words.get(key), str):
            titles[code] = words[key]
    scene = shape_tools(file, assessment, published.scene)
    require_effect(file, assessment, scene)
    made = scenario.Scenario(
        scene=scene,
        title=titles.get("en", published.title),
        task=published.task,
        authored=published.authored,
        authored_arrays=published.authored_arrays,
        languages={
            code: scenario.Words(title, scenario.find_words(published, code).task)
            for code, title in titles.items()
            if code != "en"
        },
        assessment=json.dumps(assessment, ensure_ascii=False),
        assessment_arrays={
            **gather_places(file, assessment, published),
            **gather_constants(assessment, published),
        },
    )
    try:
        for level in ["", *scenario.list_levels(made)]:
            scenario.draw_task(made, level)
    except ValueError as problem:
        raise refuse(file, str(problem)) from None
    return made


def take_attempt(
    published: scenario.Scenario, drawn: scenario.DrawnTask | None
) -> scenario.Scenario:
    """The scenario with the scene of an attempt: its own, where no inclusion was drawn.

    Raises ValueError for constants that cannot be built.
    """
    if drawn is None or not drawn.inclusion:
        return published
    return scenario.Scenario(
        scene=scenario.draw_scene(published, drawn),
        title=published.title,
        task=published.task,
        authored=published.authored,
        authored_arrays=published.authored_arrays,
        languages=published.languages,
        assessment=published.assessment,
        assessment_arrays=published.assessment_arrays,
    )


def refuse(file: object, sentence: str) -> Refusal:
    """A sentence of the library, "where: got this, expected that", as a Refusal of a file."""
    parts = split_sentence(sentence)
    if parts is None:
        return Refusal(file, "", sentence, "an assessment that can be judged")
    where, got, expected = parts
    where = where.replace("manifest.json: content.assessment", "").lstrip(".")
    return Refusal(file, where, got, expected)


def require_assessment(path: Path, published: scenario.Scenario) -> Json:
    """The assessment of a published scenario. Raises Refusal where there is none."""
    if not published.assessment:
        raise Refusal(path, "assessment", "none", "a scenario with a task that can be judged")
    read: Json = json.loads(published.assessment)
    return read
