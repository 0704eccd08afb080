# SPDX-License-Identifier: BSD-3-Clause
"""What the verb `scene` changes of a layout: what is in it, where that stands, what may touch."""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from palpate.assessment.publish import read_assessment
from palpate.command.verb import WrongCall
from palpate.layout import document, ranges
from palpate.layout.document import (
    Layout,
    LayoutError,
    Placed,
    PlacedBody,
    PlacedScenery,
    PlacedStone,
    SceneTool,
    TouchingPair,
)
from palpate.layout.gaps import Surface
from palpate.layout.hard_parts import scale_mesh
from palpate.layout.placed import build_body, find_region, find_surface, read_organ, read_placed
from palpate.layout.ranges import Range
from palpate.layout.snap import measure_patch, snap
from palpate.layout.task import set_task
from palpate.scene.instrument_kinds import KINDS as TOOLS
from palpate.scene.mesh_file import read_mesh_file
from palpate.scene.scene_file import hash_file

ORGAN = "organ"
KINDS: dict[str, type] = {ORGAN: PlacedBody, "stone": PlacedStone, "scenery": PlacedScenery}
UNITS = {"m": 1.0, "mm": 1e-3}
"""[m] of a mesh's unit."""
OF_KIND = {"density": (PlacedStone,), "spheres": (PlacedStone,),
           "friction": (PlacedStone, PlacedScenery)}  # fmt: skip
"""Options that only some of what is placed have."""
OF_BODIES = {"fold": "may_fold", "weightless": "weightless"}
"""Options that only organs have, and what they say of them."""


def change_add(layout: Layout, call: argparse.Namespace) -> Layout:
    part: Placed = KINDS[call.kind](
        call.organ.stem if call.name is None else call.name,
        Path(os.path.relpath(call.organ.resolve(), call.file.resolve().parent)).as_posix(),
        "",
    )
    if not isinstance(part, PlacedBody):
        part = replace(part, scale=UNITS[call.unit])
    elif call.unit != "m":
        raise WrongCall(
            "--unit: got one for an organ, expected it for a mesh: an organ has its own"
        )
    read_again(part, call.organ)
    return document.add_part(layout, place(replace(part, sha256=hash_file(call.organ)), call))


def read_again(part: Placed, file: Path) -> None:
    """Raises Refusal for a file that it cannot be made of."""
    if isinstance(part, PlacedBody):
        read_organ(file)
    else:
        scale_mesh(file, read_mesh_file(file), part)


def change_place(layout: Layout, call: argparse.Namespace) -> Layout:
    if call.remove:
        return document.remove_part(layout, call.name)
    if bool(call.snap) != bool(call.onto):
        raise WrongCall("--snap, --onto: got one, expected both: a region of it and BODY/REGION")
    changed = document.change_part(layout, call.name, lambda part: place(part, call))
    if call.renew:
        part = changed.find_part(call.name)
        file = call.file.parent / part.file
        read_again(part, file)
        changed = document.change_part(
            changed, call.name, lambda part: replace(part, sha256=hash_file(file))
        )
    return snap_body(changed, call) if call.snap else changed


def place(part: Any, call: argparse.Namespace) -> Any:
    if call.at is not None:
        part = replace(part, position=tuple(1e-3 * x for x in call.at))
    if getattr(call, "by", None) is not None:
        moved = np.asarray(part.position) + 1e-3 * np.asarray(call.by)
        part = replace(part, position=tuple(map(float, moved)))
    if call.turn is not None:
        turn = Rotation.from_euler("xyz", call.turn, degrees=True).as_rotvec()
        part = replace(part, rotation=tuple(map(float, turn)))
    if call.tool_friction is not None:
        part = replace(part, tool_friction=call.tool_friction)
    for option, name in OF_BODIES.items():
        told = getattr(call, option, None)
        if told is None:
            continue
        if not isinstance(part, PlacedBody):
            raise LayoutError(
                f"{part.name}: got --{option}, expected it for a body: this keeps its shape"
            )
        part = replace(part, **{name: told})
    return set_numbers(part, call)


def set_numbers(part: Any, call: argparse.Namespace) -> Any:
    """Of a stone or scenery. Raises LayoutError for one that it has not, or out of range."""
    for name, kinds in OF_KIND.items():
        value = getattr(call, name)
        if value is None:
            continue
        if not isinstance(part, kinds):
            raise LayoutError(f"{part.name}: got --{name}, which it has not")
        require_option(name, value, ranges.PARTS[name])
        part = replace(part, **{name: value})
    return part


def require_option(name: str, value: float, range: Range) -> None:
    """Raises LayoutError."""
    if not range.holds(value):
        option = name.replace("_", "-")
        raise LayoutError(f"--{option}: got {range.say(value)}, expected {range}")


def snap_body(layout: Layout, call: argparse.Namespace) -> Layout:
    require_option("gap", call.gap, ranges.GAP)
    other, slash, region = call.onto.partition("/")
    if not slash or other == call.name:
        raise WrongCall(f"--onto: got {call.onto!r}, expected BODY/REGION of another body")
    for name in (call.name, other):
        if not isinstance(layout.find_part(name), PlacedBody):
            raise LayoutError(f"{name}: got no organ, expected one, which has regions")
    surfaces, patches = [], []
    for name, where in ((call.name, call.snap), (other, region)):
        placed = layout.bodies[layout.find(name)]
        organ = read_placed(call.file, placed)
        surfaces.append(Surface(*find_surface(build_body(organ, placed, touches=False))))
        try:
            patches.append(measure_patch(surfaces[-1], find_region(organ, where)))
        except ValueError as problem:
            raise WrongCall(f"{name}/{where}: {problem}") from None
    return document.change_part(
        layout,
        call.name,
        lambda body: snap(body, surfaces[0], patches[0], surfaces[1], patches[1], call.gap),
    )


def change_pair(layout: Layout, call: argparse.Namespace) -> Layout:
    if call.remove:
        return document.remove_pair(layout, call.first, call.second)
    pair = TouchingPair(
        call.first, call.second, call.thickness, call.stiffness, call.damping, call.friction
    )
    return document.set_pair(layout, pair)


def change_tool(layout: Layout, call: argparse.Namespace) -> Layout:
    """Raises LayoutError for numbers out of range, or of what the instrument has not."""
    if call.remove:
        return replace(layout, tools=())
    usual = TOOLS[call.kind]
    said = {name: getattr(call, name) for name in ranges.TOOLS}
    said = {name: value for name, value in said.items() if value is not None}
    for name, value in said.items():
        if name in usual.idle:
            option = name.replace("_", "-")
            raise LayoutError(
                f"--{option}: got one for a {call.kind}, on which it has no effect, expected none"
            )
        require_option(name, value, ranges.TOOLS[name])
    trocar = () if call.trocar is None else tuple(1e-3 * x for x in call.trocar)
    if trocar and not said.get("length", usual.length) > 0.0:
        raise LayoutError("--trocar: got one for a ball, expected a shaft")
    return replace(layout, tools=(SceneTool(call.kind, **{**vars(usual), **said}, trocar=trocar),))


def change_task(layout: Layout, call: argparse.Namespace) -> Layout:
    if (call.assessment is None) != call.remove:
        raise WrongCall("task: got FILE and --remove, or none of both, expected one of them")
    return set_task(layout, None if call.remove else read_assessment(call.assessment))


def change_words(layout: Layout, call: argparse.Namespace) -> Layout:
    """What a scene has beside what is placed in it; what is not told stays."""
    names = ("title", "task", "title_tr", "task_tr", "gravity", "fluid")
    told = {name: getattr(call, name, None) for name in names}
    told = {name: value for name, value in told.items() if value is not None}
    if call.action == "set" and not told:
        raise WrongCall("set: got nothing to keep, expected one at least of its options")
    return replace(layout, **told)


CHANGES: dict[str, Callable[[Layout, argparse.Namespace], Layout]] = {
    "add": change_add,
    "place": change_place,
    "pair": change_pair,
    "tool": change_tool,
    "set": change_words,
    "task": change_task,
}
