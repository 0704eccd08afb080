# SPDX-License-Identifier: BSD-3-Clause
"""Which organs stand where in a scene, and which may touch: a JSON file that remembers its past.

A layout is a value. Every change makes another one, and the file keeps those before it, so that a
change can be undone after the program that made it has ended.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path

from palpate.files.json_document import read_document
from palpate.files.json_part import read_part
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole

FORMAT, VERSION = "palpate layout", 1
MOST_BYTES = 16 * 2**20
MOST_STEPS = 100
"""Changes that can be undone; older ones are forgotten."""


@dataclass(frozen=True)
class PlacedBody:
    """A published organ, and where it stands."""

    name: str
    """In this layout; each is another."""
    file: str
    """Path of the .palpate, relative to the layout."""
    sha256: str
    """Of that file, when it was added."""
    position: tuple[float, ...] = (0.0, 0.0, 0.0)
    """[m] of the organ's own origin."""
    rotation: tuple[float, ...] = (0.0, 0.0, 0.0)
    """[rad] rotation vector about that origin."""
    may_fold: bool = False
    """Whether parts of its surface may touch others of it."""


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


@dataclass(frozen=True)
class Layout:
    """What a designer decided about a scene of several organs."""

    title: str = ""
    task: str = ""
    title_tr: str = ""
    task_tr: str = ""
    bodies: tuple[PlacedBody, ...] = ()
    pairs: tuple[TouchingPair, ...] = ()

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


def add_body(layout: Layout, body: PlacedBody) -> Layout:
    if any(other.name == body.name for other in layout.bodies):
        raise LayoutError(f"{body.name}: got a name that another body has, expected a new one")
    return replace(layout, bodies=(*layout.bodies, body))


def remove_body(layout: Layout, name: str) -> Layout:
    """With the pairs it is in."""
    layout.find(name)
    return replace(
        layout,
        bodies=tuple(body for body in layout.bodies if body.name != name),
        pairs=tuple(pair for pair in layout.pairs if name not in (pair.first, pair.second)),
    )


def change_body(layout: Layout, name: str, change: Callable[[PlacedBody], PlacedBody]) -> Layout:
    bodies = list(layout.bodies)
    index = layout.find(name)
    bodies[index] = change(bodies[index])
    return replace(layout, bodies=tuple(bodies))


def is_of(pair: TouchingPair, first: str, second: str) -> bool:
    return {pair.first, pair.second} == {first, second}


def set_pair(layout: Layout, pair: TouchingPair) -> Layout:
    """In place of one of the same two bodies, if there is one."""
    if pair.first == pair.second:
        raise LayoutError(
            f"{pair.first}: got a body with itself, expected two; --fold lets it fold"
        )
    for name in (pair.first, pair.second):
        layout.find(name)
    others = tuple(p for p in layout.pairs if not is_of(p, pair.first, pair.second))
    return replace(layout, pairs=(*others, pair))


def remove_pair(layout: Layout, first: str, second: str) -> Layout:
    others = tuple(pair for pair in layout.pairs if not is_of(pair, first, second))
    if len(others) == len(layout.pairs):
        raise LayoutError(f"{first}, {second}: got no pair of these, expected one that may touch")
    return replace(layout, pairs=others)


# ---------------------------------------------------------------- the file


def read_layout(path: Path) -> History:
    """Raises Refusal or OSError."""
    data = read_document(
        path, format=FORMAT, version=VERSION, what="a layout", most_bytes=MOST_BYTES
    )
    section = {key: value for key, value in data.items() if key not in ("format", "version")}
    history: History = read_part(path, "layout", History, section, whole=True)
    for layout in (history.now, *history.before, *history.undone):
        require_sound(path, layout)
    return history


def require_sound(path: Path, layout: Layout) -> None:
    """What no edit would have made. Raises Refusal."""
    names = [body.name for body in layout.bodies]
    for index, body in enumerate(layout.bodies):
        where = f"bodies[{index}]"
        if not body.name or body.name in names[:index]:
            raise Refusal(path, f"{where}.name", repr(body.name), "a name of its own")
        for field in ("position", "rotation"):
            count = len(getattr(body, field))
            if count != 3:
                raise Refusal(path, f"{where}.{field}", f"{count} numbers", "3")
    known: list[set[str]] = []
    for index, pair in enumerate(layout.pairs):
        both = {pair.first, pair.second}
        if len(both) != 2 or not both <= set(names) or both in known:
            got = f"{pair.first!r} and {pair.second!r}"
            raise Refusal(path, f"pairs[{index}]", got, "two of the bodies, each pair once")
        known.append(both)


def write_layout(path: Path, history: History) -> None:
    """Writes whole or not at all. Raises OSError."""
    data = {"format": FORMAT, "version": VERSION}
    data |= {each.name: convert(getattr(history, each.name)) for each in fields(history)}
    write_whole(path, (json.dumps(data, indent=1, ensure_ascii=False) + "\n").encode())


def convert(value: Layout | tuple[Layout, ...]) -> object:
    return asdict(value) if isinstance(value, Layout) else [asdict(each) for each in value]
