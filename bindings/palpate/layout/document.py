# SPDX-License-Identifier: BSD-3-Clause
"""Which organs, stones and scenery stand where in a scene, and which may touch: a JSON file that
remembers its past.

A layout is a value. Every change makes another one, and the file keeps those before it, so that a
change can be undone after the program that made it has ended.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

from palpate.layout import ranges
from palpate.layout.ranges import Fault

FORMAT, VERSION = "palpate layout", 7
MOST_STEPS = 100
"""Changes that can be undone; older ones are forgotten."""


@dataclass(frozen=True)
class Placed:
    """A file, and where what it holds stands."""

    name: str
    """In this layout; each is another."""
    file: str
    """Path relative to the layout: of a body's .palpate, else of a mesh."""
    sha256: str
    """Of that file, when it was added."""
    position: tuple[float, ...] = (0.0, 0.0, 0.0)
    """[m] of the file's own origin."""
    rotation: tuple[float, ...] = (0.0, 0.0, 0.0)
    """[rad] rotation vector about that origin."""
    tool_friction: tuple[float, ...] = ()
    """[-] (1,) Coulomb's coefficient of instruments on it. None: that of the instrument."""


@dataclass(frozen=True)
class PlacedBody(Placed):
    """A published organ."""

    may_fold: bool = False
    """Whether parts of its surface may touch others of it."""
    weightless: bool = False
    """Whether its shape is the one under its weight, as of a scan: gravity does not act on it."""


@dataclass(frozen=True)
class PlacedMesh(Placed):
    """What keeps its shape."""

    scale: float = 1.0
    """[m] of a unit of the mesh."""


@dataclass(frozen=True)
class PlacedStone(PlacedMesh):
    """A closed mesh that moves; placed where it is at the start."""

    density: float = 2000.0
    """[kg/m³] of all of it: its mass and inertia follow."""
    friction: float = 0.3
    """[-] on tissue, scenery and other stones."""
    spheres: int = 14
    """Of its hull, which is fitted into the mesh."""


@dataclass(frozen=True)
class PlacedScenery(PlacedMesh):
    """A mesh that never moves."""

    friction: float = 0.0
    """[-] of the bodies that stop at it."""
    stops: tuple[str, ...] = ()
    """Names of these bodies; others pass through it. Instruments and stones never do."""


@dataclass(frozen=True)
class TouchingPair:
    """Two bodies that may touch."""

    first: str
    second: str
    thickness: float = 0.0
    """[m] 0: chosen from the bodies."""
    stiffness: float = 0.0
    """[N/m³] 0: chosen from the bodies."""
    damping: float = 0.3
    """[-] of critical."""
    friction: float = 0.0
    """[-] Coulomb's coefficient; 0: they slide. Wet serosa has some hundredths."""


@dataclass(frozen=True)
class SceneTool:
    """An instrument in place of that of the first body's organ."""

    kind: str
    """Of palpate.scene.instrument_kinds, whose numbers these are where nothing else is said."""
    radius: float
    """[m]"""
    length: float
    """[m] of the shaft that touches, or of the jaws; 0: a ball."""
    jaw_opening: float
    """[rad] of each jaw; 0: what touches is rigid."""
    friction: float
    """[-] on all whose `tool_friction` says nothing else."""
    grip_force: float = 5.0
    """[N] with which each jaw closes at most, at its middle."""
    trocar: tuple[float, ...] = ()
    """[m] (3,) where its shaft passes the wall. None: the device turns it."""


@dataclass(frozen=True)
class Layout:
    """What a designer decided about a scene of several organs."""

    title: str = ""
    task: str = ""
    title_tr: str = ""
    task_tr: str = ""
    bodies: tuple[PlacedBody, ...] = ()
    pairs: tuple[TouchingPair, ...] = ()
    stones: tuple[PlacedStone, ...] = ()
    scenery: tuple[PlacedScenery, ...] = ()
    gravity: tuple[float, ...] = ()
    """[m/s²] (3,) None: that of the first body's organ."""
    fluid: tuple[float, ...] = ()
    """[kg/m³], [Pa s] (2,) What the stones are in: 1000, 0.001 of water. None: nothing."""
    tools: tuple[SceneTool, ...] = ()
    """One, or none: that of the first body's organ."""
    assessment: str = ""
    """The judged task, the JSON that `palpate scenario` writes; none: a scene to feel."""

    @property
    def parts(self) -> tuple[Placed, ...]:
        """All that is placed."""
        return (*self.bodies, *self.stones, *self.scenery)

    def find_part(self, name: str) -> Placed:
        """Raises LayoutError."""
        for part in self.parts:
            if part.name == name:
                return part
        known = ", ".join(part.name for part in self.parts) or "none yet"
        raise LayoutError(f"{name}: got nothing of this name, expected one of {known}")

    def find(self, name: str) -> int:
        """The number of a body. Raises LayoutError."""
        for index, body in enumerate(self.bodies):
            if body.name == name:
                return index
        known = ", ".join(body.name for body in self.bodies) or "none yet"
        raise LayoutError(f"{name}: got no body of this name, expected one of {known}")


@dataclass(frozen=True)
class History:
    """A layout with those before it and those that were undone."""

    now: Layout
    before: tuple[Layout, ...] = ()
    """The oldest first."""
    undone: tuple[Layout, ...] = ()
    """What is done again first stands last."""


class LayoutError(Exception):
    """A change that cannot be made; says what was got and what was expected."""


def apply(history: History, changed: Layout) -> History:
    """A layout that differs is a step; what was undone before is forgotten."""
    if changed == history.now:
        return history
    return History(changed, (*history.before, history.now)[-MOST_STEPS:])


def undo(history: History) -> History:
    """Raises LayoutError where nothing was done."""
    if not history.before:
        raise LayoutError("undo: got no change before this, expected one")
    *before, last = history.before
    return History(last, tuple(before), (*history.undone, history.now))


def redo(history: History) -> History:
    """Raises LayoutError where nothing was undone."""
    if not history.undone:
        raise LayoutError("redo: got nothing that was undone, expected a change")
    *undone, last = history.undone
    return History(last, (*history.before, history.now), tuple(undone))


# ---------------------------------------------------------------- changes


KINDS: dict[type, str] = {PlacedBody: "bodies", PlacedStone: "stones", PlacedScenery: "scenery"}
"""What is placed -> the field of a layout that has it."""


def require(where: str, faults: Iterable[Fault]) -> None:
    """Raises LayoutError for the first of them."""
    for fault in faults:
        raise LayoutError(f"{where}{fault.field}: got {fault.got}, expected {fault.expected}")


def add_part(layout: Layout, part: Placed) -> Layout:
    """Raises LayoutError."""
    require("", ranges.find_name_faults(part.name))
    require(f"{part.name}: ", ranges.find_part_faults(part))
    if any(other.name == part.name for other in layout.parts):
        raise LayoutError(f"{part.name}: got a name that is taken, expected a new one")
    rows = getattr(layout, KINDS[type(part)])
    return replace(layout, **{KINDS[type(part)]: (*rows, part)})


def remove_part(layout: Layout, name: str) -> Layout:
    """A body with the pairs it is in, and no longer stopped by any scenery."""
    field = KINDS[type(layout.find_part(name))]
    left = replace(
        layout,
        **{field: tuple(part for part in getattr(layout, field) if part.name != name)},
        pairs=tuple(pair for pair in layout.pairs if name not in (pair.first, pair.second)),
    )
    return replace(
        left,
        scenery=tuple(
            replace(each, stops=tuple(body for body in each.stops if body != name))
            for each in left.scenery
        ),
    )


def change_part(layout: Layout, name: str, change: Callable[[Any], Placed]) -> Layout:
    """Raises LayoutError."""
    part = layout.find_part(name)
    field = KINDS[type(part)]
    changed = change(part)
    require(f"{name}: ", ranges.find_part_faults(changed))
    rows = tuple(changed if row is part else row for row in getattr(layout, field))
    return replace(layout, **{field: rows})


def is_of(pair: TouchingPair, first: str, second: str) -> bool:
    return {pair.first, pair.second} == {first, second}


def set_pair(layout: Layout, pair: TouchingPair) -> Layout:
    """In place of one of the same two bodies, if there is one; a body and a scenery: that stops
    it."""
    if pair.first == pair.second:
        raise LayoutError(
            f"{pair.first}: got a body with itself, expected two; --fold lets it fold"
        )
    require("", ranges.find_faults(pair, ranges.PAIRS))
    stopped = find_stopped(layout, pair.first, pair.second)
    if stopped is not None:
        scenery, body = stopped
        if pair.friction:
            raise LayoutError(
                f"{scenery.name}: got a friction of its pair with {body}, expected none: a scenery "
                "has one for all that it stops"
            )
        stops = tuple(dict.fromkeys((*scenery.stops, body)))
        return change_part(layout, scenery.name, lambda each: replace(each, stops=stops))
    others = tuple(p for p in layout.pairs if not is_of(p, pair.first, pair.second))
    return replace(layout, pairs=(*others, pair))


def find_stopped(layout: Layout, first: str, second: str) -> tuple[PlacedScenery, str] | None:
    """The scenery and the name of the body, of two that are these; None for two bodies. Raises
    LayoutError for all else."""
    parts = [layout.find_part(name) for name in (first, second)]
    for part in parts:
        if isinstance(part, PlacedStone):
            raise LayoutError(
                f"{part.name}: got a stone, expected bodies and scenery: a stone touches all"
            )
    scenery = [part for part in parts if isinstance(part, PlacedScenery)]
    if not scenery:
        return None
    if len(scenery) == 2:
        raise LayoutError(f"{first}, {second}: got two that never move, expected a body")
    return scenery[0], second if scenery[0].name == first else first


def remove_pair(layout: Layout, first: str, second: str) -> Layout:
    stopped = find_stopped(layout, first, second)
    if stopped is not None and stopped[1] in stopped[0].stops:
        scenery, body = stopped
        stops = tuple(name for name in scenery.stops if name != body)
        return change_part(layout, scenery.name, lambda each: replace(each, stops=stops))
    others = tuple(pair for pair in layout.pairs if not is_of(pair, first, second))
    if len(others) == len(layout.pairs):
        raise LayoutError(f"{first}, {second}: got no pair of these, expected one that may touch")
    return replace(layout, pairs=others)
