# SPDX-License-Identifier: BSD-3-Clause
"""How the organ of a published file takes the light, as its designer chose it."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.files.json_part import read_part
from palpate.files.refusal import Refusal
from palpate.render.part import Appearance, build_appearance
from palpate.scenario import Scenario
from palpate.scene.scene_parts import AppearancePart

LAYOUT = "palpate layout"
"""Format of the document of several organs, whose appearance is the first one's."""
RENAMED = 5
"""Version of the document that calls the look appearance, and its softness subsurface."""


def find_appearance(scenario: Scenario) -> Appearance | None:
    """How the organ takes the light; None where nothing was said, or nothing one can understand.

    An appearance is nothing to train with, so a strange one is no reason to refuse the file.
    """
    try:
        document = json.loads(scenario.authored)
        version = RENAMED if document["format"] == LAYOUT else document["version"]
        part = find_part(document["content"], version)
        return build_appearance(read_part("", "appearance", AppearancePart, part, whole=True))
    except (ValueError, LookupError, TypeError, RecursionError, Refusal):
        return None


def find_colours(scenario: Scenario) -> NDArray[np.uint8] | None:
    """(n, 3) uint8, sRGB, of the scene's vertices, where its designer's surface has some: those
    that are not on it, as inside of a solid, have the mean. None where it has none, or where the
    document is of another surface than the scene."""
    if len(scenario.scene.bodies) > 1:
        return find_colours_of_several(scenario)
    bodies = [np.asarray(body.tissue.rest_position) for body in scenario.scene.bodies]
    count = sum(map(len, bodies))
    for name in ("surface", "imported"):
        vertices = scenario.authored_arrays.get(f"{name}/vertices")
        if vertices is None:
            continue
        colours = scenario.authored_arrays.get(f"{name}/colours")
        of = len(vertices)
        fits = bodies and len(bodies[0]) >= of and np.array_equal(bodies[0][:of], vertices)
        if colours is None or not fits or colours.dtype != np.uint8 or colours.shape != (of, 3):
            return None
        mean = np.rint(colours.mean(axis=0))
        return np.vstack([colours, np.tile(mean, (count - of, 1))]).astype(np.uint8)
    return None


def find_colours_of_several(scenario: Scenario) -> NDArray[np.uint8] | None:
    """Those of a layout, which has them for the surfaces of all bodies."""
    colours = scenario.authored_arrays.get("colours")
    tissues = [body.tissue for body in scenario.scene.bodies]
    count = sum(len(palpate.compute_surface(each, each.rest_position)) for each in tissues)
    if colours is None or colours.dtype != np.uint8 or colours.shape != (count, 3):
        return None
    return np.array(colours)


def find_part(content: dict[str, Any], version: int) -> object:
    """The appearance of a designer's document of any version."""
    if version >= RENAMED:
        return content["appearance"]
    part = dict(content["look"])
    part["subsurface"] = part.pop("softness")
    return part
