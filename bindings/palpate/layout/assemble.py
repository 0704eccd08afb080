# SPDX-License-Identifier: BSD-3-Clause
"""From a layout to a scene that ticks, with what had to be done to it on the way."""

from __future__ import annotations

import copy
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import palpate
from palpate.layout.document import Layout, PlacedStone
from palpate.layout.gaps import Surface
from palpate.layout.hard_parts import Stone, build_scenery, build_stone, read_part_mesh
from palpate.layout.placed import Organ, build_body, build_instruments, find_surface, read_organs
from palpate.layout.separate import Neighbour, Separation, separate
from palpate.scene.scene_file import build_tool
from palpate.scene.scene_parts import ToolPart

APART = 10.0
"""[m] Between bodies while the barriers of their pairs are chosen, before any is where it stands.
"""


@dataclass(frozen=True)
class Assembly:
    """A layout with its organs read."""

    layout: Layout
    organs: list[Organ]
    pairs: list[palpate.BodyPair]
    """As the layout's, thickness and stiffness chosen."""
    bodies: list[palpate.SoftBody]
    """Where they stand; moved apart by separate_bodies()."""
    surfaces: list[Surface]
    """Of the bodies where the layout has them."""
    stones: list[Stone]
    scenery: list[palpate.Scenery]


def read_assembly(path: Path, layout: Layout) -> Assembly:
    """Raises Refusal, FileError, and ValueError for bodies of which none can touch another."""
    organs = read_organs(path, layout)
    touching = list_touching(layout)
    bodies = [
        build_body(organ, placed, placed.name in touching)
        for organ, placed in zip(organs, layout.bodies, strict=True)
    ]
    surfaces = [Surface(*find_surface(body)) for body in bodies]
    return Assembly(
        layout,
        organs,
        choose_barriers(layout, bodies),
        bodies,
        surfaces,
        [read_stone(path, placed) for placed in layout.stones],
        [build_scenery(layout, read_part_mesh(path, placed), placed) for placed in layout.scenery],
    )


def read_stone(path: Path, placed: PlacedStone) -> Stone:
    """Raises Refusal, and ValueError for a mesh that cannot be one."""
    mesh = read_part_mesh(path, placed)
    try:
        return build_stone(mesh, placed)
    except ValueError as problem:
        raise ValueError(f"{placed.name}: {problem}") from None


def list_touching(layout: Layout) -> set[str]:
    """The bodies that may touch others, or themselves, or what is hard."""
    names = {body.name for body in layout.bodies if body.may_fold or layout.stones}
    names |= {name for scenery in layout.scenery for name in scenery.stops}
    for pair in layout.pairs:
        names |= {pair.first, pair.second}
    return names


def choose_barriers(layout: Layout, bodies: list[palpate.SoftBody]) -> list[palpate.BodyPair]:
    """The pairs with the constants that build_scene chooses. Raises ValueError."""
    made = []
    for row in layout.pairs:
        first, second = layout.find(row.first), layout.find(row.second)
        away = copy.copy(bodies[second].tissue)
        np.asarray(away.rest_position)[:, 0] += APART
        two = [palpate.SoftBody(tissue=tissue) for tissue in (bodies[first].tissue, away)]
        pair = palpate.BodyPair(
            thickness=row.thickness,
            stiffness=row.stiffness,
            damping=row.damping,
            friction=row.friction,
        )
        try:
            chosen = palpate.build_scene(palpate.Scene(bodies=two, body_pairs=[pair]))
        except ValueError as problem:
            raise ValueError(f"{row.first} and {row.second}: {problem}") from None
        pair = chosen.body_pairs[0]
        made.append(
            palpate.BodyPair(
                first,
                second,
                thickness=pair.thickness,
                stiffness=pair.stiffness,
                damping=pair.damping,
                friction=pair.friction,
            )
        )
    return made


def separate_bodies(assembly: Assembly) -> list[Separation]:
    """Moves bodies that begin nearer than half a thickness, each away from those before it."""
    found = []
    for index in range(1, len(assembly.bodies)):
        neighbours = [
            Neighbour(other, assembly.surfaces[other], pair.thickness)
            for pair in assembly.pairs
            for other in (min(pair.first, pair.second),)
            if max(pair.first, pair.second) == index and other != index
        ]
        separation = separate(index, assembly.surfaces[index], neighbours)
        if separation is None:
            continue
        found.append(separation)
        if separation.shift is not None:
            placed = assembly.layout.bodies[index]
            moved = replace(placed, position=tuple(placed.position + separation.shift))
            assembly.bodies[index] = build_body(assembly.organs[index], moved, touches=True)
            assembly.surfaces[index] = Surface(*find_surface(assembly.bodies[index]))
    return found


def build_tools(assembly: Assembly) -> list[palpate.Instrument]:
    """The layout's, with the hand of the first of those of the first body's organ; without one,
    all of that organ's."""
    made = build_instruments(assembly.organs[0], assembly.layout.bodies[0])
    for said in assembly.layout.tools:
        first = made[0]
        part = ToolPart(
            radius=said.radius,
            stiffness=first.tool.stiffness,
            friction=said.friction,
            length=said.length,
            jaw_opening=said.jaw_opening,
            grip_force=said.grip_force,
        )
        first.tool = build_tool(part)
        first.trocar = np.array(said.trocar) if said.trocar else None
        made = [first]
    for instrument in made:
        instrument.pair_friction = list_pair_friction(assembly.layout, instrument.tool.friction)
    return made


def list_pair_friction(layout: Layout, own: float) -> list[float]:
    """[-] Of an instrument with each surface of the scene, in the order that it has them; none
    where all are its own."""
    surfaces = (*layout.bodies, *layout.scenery, *layout.stones)
    if not any(part.tool_friction for part in surfaces):
        return []
    return [part.tool_friction[0] if part.tool_friction else own for part in surfaces]


def build(assembly: Assembly) -> palpate.Scene:
    """A scene with the instruments and the gravity of the first body's organ where the layout has
    none. Raises ValueError."""
    first = assembly.organs[0].published.scene
    return palpate.build_scene(
        palpate.Scene(
            bodies=assembly.bodies,
            instruments=build_tools(assembly),
            body_pairs=assembly.pairs,
            rigid=[stone.body for stone in assembly.stones],
            scenery=assembly.scenery,
            gravity=assembly.layout.gravity or first.gravity,
            fluid=palpate.Fluid(*assembly.layout.fluid),
            rate=first.rate,
            exchange_rate=first.exchange_rate,
        )
    )
