# SPDX-License-Identifier: BSD-3-Clause
"""A layout and its past as a file, which layout.schema.json describes."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import asdict, fields, replace
from pathlib import Path
from typing import Any

from palpate.files.json_document import read_document
from palpate.files.json_part import read_part
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole
from palpate.layout import ranges
from palpate.layout.document import FORMAT, VERSION, History, Layout, LayoutError
from palpate.layout.ranges import Fault
from palpate.layout.task import require_task
from palpate.scene.instrument_kinds import KINDS

MOST_BYTES = 16 * 2**20
ADDED = {1: ("stones", "scenery", "gravity", "fluid", "tools", "assessment"),
         2: ("fluid", "tools", "assessment"), 3: ("assessment",), 4: (), 5: (), 6: ()}  # fmt: skip
"""What a layout of an older version had not."""
OF_PARTS: dict[str, tuple[int, tuple[str, ...], object]] = {
    "weightless": (5, ("bodies",), False),
    "tool_friction": (6, ("bodies", "stones", "scenery"), []),
    "friction": (7, ("pairs",), 0.0),
}
"""What the rows of these lists have since this version; before, all are as if they had this."""


def read_layout(path: Path) -> History:
    """Raises Refusal or OSError."""
    data = read_document(
        path,
        format=FORMAT,
        version=VERSION,
        what="a layout",
        most_bytes=MOST_BYTES,
        older=tuple(ADDED),
    )  # fmt: skip
    section = {key: value for key, value in data.items() if key not in ("format", "version")}
    if data["version"] in ADDED:
        version = int(data["version"])
        section = {key: add_missing(path, value, version) for key, value in section.items()}
    history: History = read_part(path, "layout", History, section, whole=True)
    for layout in (history.now, *history.before, *history.undone):
        require_sound(path, layout)
    return history


def add_missing(path: Path, value: Any, version: int) -> Any:
    """A layout, or a list of them, of an older version as one of today's. Raises Refusal."""
    if isinstance(value, list):
        return [add_missing(path, each, version) for each in value]
    if not isinstance(value, dict):
        return value  # refused by the reader
    for name in ADDED[version]:
        if name in value:
            raise Refusal(path, name, f"some in a layout of version {version}", "none")
    whole = {**value, **{name: "" if name == "assessment" else [] for name in ADDED[version]}}
    for name, (since, lists, usual) in OF_PARTS.items():
        for parts in lists if version < since else ():
            if isinstance(whole.get(parts), list):
                whole[parts] = [
                    add_to_part(path, part, f"{parts}.{name}", usual, version)
                    for part in whole[parts]
                ]
    return whole


def add_to_part(path: Path, part: Any, where: str, usual: object, version: int) -> Any:
    """Raises Refusal."""
    if not isinstance(part, dict):
        return part  # refused by the reader
    name = where.partition(".")[2]
    if name in part:
        raise Refusal(path, where, f"one in a layout of version {version}", "none")
    return {**part, name: usual}


def require(path: Path | None, where: str, faults: Iterable[Fault]) -> None:
    """Raises Refusal for the first of them."""
    for fault in faults:
        raise Refusal(path, f"{where}{fault.field}", fault.got, fault.expected)


def require_sound(path: Path | None, layout: Layout) -> None:
    """What no edit would have made. Raises Refusal."""
    names = [part.name for part in layout.parts]
    for index, part in enumerate(layout.parts):
        where = f"{part.name or index}"
        if part.name in names[:index]:
            raise Refusal(path, f"{where}.name", repr(part.name), "a name of its own")
        for field in ("position", "rotation"):
            count = len(getattr(part, field))
            if count != 3:
                raise Refusal(path, f"{where}.{field}", f"{count} numbers", "3")
        if len(part.tool_friction) > 1:
            raise Refusal(path, f"{where}.tool_friction", f"{len(part.tool_friction)} numbers",
                          "one, or none")  # fmt: skip
        require(path, f"{where}.", ranges.find_part_faults(part))
    if len(layout.gravity) not in (0, 3):
        raise Refusal(path, "gravity", f"{len(layout.gravity)} numbers", "3, or none")
    if len(layout.fluid) not in (0, 2):
        raise Refusal(path, "fluid", f"{len(layout.fluid)} numbers", "2, or none")
    require(path, "", ranges.find_scene_faults(layout))
    if len(layout.tools) > 1:
        raise Refusal(path, "tools", f"{len(layout.tools)}", "one, or none")
    for tool in layout.tools:
        require(path, "tools[0].", ranges.find_tool_faults(tool))
        if tool.kind not in KINDS:
            raise Refusal(path, "tools[0].kind", repr(tool.kind), f"one of {', '.join(KINDS)}")
        if len(tool.trocar) not in (0, 3):
            raise Refusal(path, "tools[0].trocar", f"{len(tool.trocar)} numbers", "3, or none")
    require_task(path, layout.assessment)
    bodies = {body.name for body in layout.bodies}
    known: list[set[str]] = []
    for index, pair in enumerate(layout.pairs):
        both = {pair.first, pair.second}
        if len(both) != 2 or not both <= bodies or both in known:
            got = f"{pair.first!r} and {pair.second!r}"
            raise Refusal(path, f"pairs[{index}]", got, "two of the bodies, each pair once")
        known.append(both)
        require(path, f"pairs[{index}].", ranges.find_faults(pair, ranges.PAIRS))
    for index, scenery in enumerate(layout.scenery):
        if not set(scenery.stops) <= bodies or len(set(scenery.stops)) < len(scenery.stops):
            raise Refusal(path, f"scenery[{index}].stops", ", ".join(scenery.stops),
                          "names of bodies, each once")  # fmt: skip


def write_layout(path: Path, history: History) -> None:
    """Writes whole or not at all what `read_layout` reads; of more steps than a file has room for
    the older half is forgotten. Raises LayoutError or OSError."""
    try:
        for layout in (history.now, *history.before, *history.undone):
            require_sound(None, layout)
        text = encode(history)
        while len(text) > MOST_BYTES and history.before:
            history = replace(history, before=history.before[(len(history.before) + 1) // 2 :])
            text = encode(history)
    except Refusal as refusal:
        raise LayoutError(str(refusal)) from None
    except UnicodeEncodeError as problem:
        got = repr(problem.object[problem.start : problem.end])
        raise LayoutError(f"layout: got {got}, expected text that UTF-8 can say") from None
    if len(text) > MOST_BYTES:
        raise LayoutError(f"layout: got {len(text)} bytes, expected at most {MOST_BYTES}")
    write_whole(path, text)


def encode(history: History) -> bytes:
    data = {"format": FORMAT, "version": VERSION}
    data |= {each.name: convert(getattr(history, each.name)) for each in fields(history)}
    return (json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False) + "\n").encode()


def convert(value: Layout | tuple[Layout, ...]) -> object:
    return asdict(value) if isinstance(value, Layout) else [asdict(each) for each in value]
