# SPDX-License-Identifier: BSD-3-Clause
"""The instruments of a scene as an assessment names them: their shape, trocar, friction, grip."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from copy import copy
from typing import Any

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate import scenario
from palpate.files.refusal import Refusal
from palpate.scene.instrument_kinds import KINDS
from palpate.scene.pair_friction import exchange_own
from palpate.scene.scene_file import build_tool, find_trocar
from palpate.scene.scene_parts import ToolPart

SHAPES = {
    *("radius_m", "length_m", "friction", "jaw_opening_rad", "grip_force_N"),
    *("trocar_height_m", "trocar_side_m", "trocar_m", "force_max_N", "fulcrum_m"),
}
"""What an assessment may say of a tool's shape, its trocar and its hand."""
SHAPED = ("ball", "laparoscope", "syringe")
"""Kinds that have a shape where none is said; a probe or a grasper is what the organ has."""
MOST_INSTRUMENTS = 16
"""Of a scene."""


def shape_tools(file: object, assessment: Mapping[str, Any], scene: palpate.Scene) -> palpate.Scene:
    """The scene with the tools that the assessment describes; itself where it describes none.

    Raises Refusal for a tool that cannot touch what there is.
    """
    tools = assessment.get("tools")
    if isinstance(tools, dict):
        scene = add_instruments(tools.values(), scene)
    for name, said in tools.items() if isinstance(tools, dict) else ():
        if not isinstance(said, dict) or not has_shape(said):
            continue
        row = said.get("instrument", 0)
        if not isinstance(row, int) or not 0 <= row < len(scene.instruments):
            continue  # what is wrong with it says the reader
        try:
            scene = shape_tool(said, row, scene)
        except (TypeError, ValueError) as problem:
            raise Refusal(
                file, f"tools.{name}", str(problem), "a tool that can touch this organ"
            ) from None
    return scene


def require_effect(file: object, assessment: Mapping[str, Any], scene: palpate.Scene) -> None:
    """Raises Refusal for a number of jaws of a tool that has none in the `scene` of shape_tools."""
    tools = assessment.get("tools")
    for name, said in tools.items() if isinstance(tools, dict) else ():
        row = said.get("instrument", 0) if isinstance(said, dict) else None
        if not isinstance(row, int) or not 0 <= row < len(scene.instruments):
            continue  # what is wrong with it says the reader
        tool = scene.instruments[row].tool
        where = f"tools.{name}"
        if not tool.capsules and said.get("jaw_opening_rad"):
            raise Refusal(
                file,
                f"{where}.jaw_opening_rad",
                f"{said['jaw_opening_rad']!r}, which has no effect here: a ball has no jaws",
                "a length above 0, or none of it",
            )
        if tool.jaws is None and "grip_force_N" in said:
            raise Refusal(
                file,
                f"{where}.grip_force_N",
                f"{said['grip_force_N']!r}, which has no effect here: what has no jaws closes on "
                "nothing",
                "jaws that open, or none of it",
            )


def has_shape(said: Mapping[str, Any]) -> bool:
    return bool(SHAPES & set(said)) or said.get("kind") in SHAPED


def add_instruments(tools: Iterable[object], scene: palpate.Scene) -> palpate.Scene:
    """The scene with as many instruments as tools are numbered, those beyond its own as the first
    is; itself where it has them."""
    rows = [said.get("instrument", 0) for said in tools if isinstance(said, dict)]
    count = max((row + 1 for row in rows if isinstance(row, int)), default=1)
    if not len(scene.instruments) < count <= MOST_INSTRUMENTS:
        return scene  # what is wrong with it says the reader
    first = scene.instruments[0]
    more = [copy(first) for _ in range(count - len(scene.instruments))]
    return palpate.build_scene(
        palpate.Scene(
            bodies=list(scene.bodies),
            rigid=list(scene.rigid),
            scenery=list(scene.scenery),
            fluid=scene.fluid,
            instruments=[*scene.instruments, *more],
            body_pairs=list(scene.body_pairs),
            gravity=scene.gravity,
            rate=scene.rate,
            exchange_rate=scene.exchange_rate,
        )
    )


def shape_tool(said: Mapping[str, Any], row: int, scene: palpate.Scene) -> palpate.Scene:
    """The scene with one tool as an assessment describes it. Raises ValueError or TypeError."""
    part = read_part(said, scene.instruments[row].tool)
    changed = copy(scene)
    instrument = changed.instruments[row]
    instrument.pair_friction = exchange_own(instrument, part.friction)
    instrument.tool = build_tool(part)
    instrument.trocar = place_trocar(said, part, scene.bodies[0].tissue)
    if "force_max_N" in said:
        instrument.coupling = palpate.Coupling(
            stiffness=instrument.coupling.stiffness, force_max=float(said["force_max_N"])
        )
    scenario.check_ranges(changed)
    return palpate.build_scene(changed)


def read_part(said: Mapping[str, Any], before: palpate.Tool) -> ToolPart:
    """What an assessment says of a tool, the rest as its kind has it, or as it was before."""
    kind = KINDS.get(str(said.get("kind"))) if said.get("kind") in SHAPED else None
    length = before.capsules[0].to[2] if before.capsules else 0.0
    opening = before.jaws.open if before.jaws else 0.0
    grip = before.jaws.grip if before.jaws else ToolPart.grip_force
    return ToolPart(
        radius=float(said.get("radius_m", kind.radius if kind else before.radius)),
        stiffness=before.stiffness,
        friction=float(said.get("friction", kind.friction if kind else before.friction)),
        length=float(said.get("length_m", kind.length if kind else length)),
        trocar_height=float(said.get("trocar_height_m", ToolPart.trocar_height)),
        jaw_opening=float(said.get("jaw_opening_rad", kind.jaw_opening if kind else opening)),
        grip_force=float(said.get("grip_force_N", grip)),
    )


def place_trocar(
    said: Mapping[str, Any], part: ToolPart, tissue: palpate.TissueModel
) -> NDArray[np.float64] | None:
    """[m] (3,) Where an assessment has it, or over the organ's middle; None for a ball, and for a
    tool that the device turns. Raises ValueError or TypeError."""
    trocar = find_trocar(part, tissue)
    if trocar is None:
        return None
    if "trocar_m" not in said:
        return trocar + np.array([float(said.get("trocar_side_m", 0.0)), 0.0, 0.0])
    for other in ("trocar_height_m", "trocar_side_m"):
        if other in said:
            raise ValueError(f"{other}: got {said[other]!r}, expected none of it beside trocar_m")
    place = said["trocar_m"]
    numbers = isinstance(place, list) and len(place) == 3
    if not numbers or not all(type(at) in (int, float) and np.isfinite(at) for at in place):
        raise ValueError(f"trocar_m: got {place!r}, expected 3 numbers")
    return np.array([float(at) for at in place])


def find_handle(published: scenario.Scenario, instrument: int) -> float:
    """[m] From the tip of an instrument to the handle that a device shall be; 0: it is the tip."""
    if not published.assessment:
        return 0.0
    tools = json.loads(published.assessment)["tools"].values()
    said = (tool for tool in tools if tool.get("instrument", 0) == instrument)
    return float(next(said, {}).get("fulcrum_m", 0.0))
