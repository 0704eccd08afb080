# SPDX-License-Identifier: BSD-3-Clause
"""A layout and its past as a file, which layout.schema.json describes."""

from __future__ import annotations

import json
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

from palpate.files.json_document import read_document
from palpate.files.json_part import read_part
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole
from palpate.layout.document import FORMAT, VERSION, History, Layout
from palpate.layout.stone import FEWEST, MOST
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


AT_LEAST = dict.fromkeys(("friction", "thickness", "stiffness", "damping", "length"), 0.0)
ABOVE = dict.fromkeys(("scale", "density", "radius"), 0.0)


def require_ranges(path: Path, where: str, row: object) -> None:
    """Of numbers that no scene could have. Raises Refusal."""
    for name, least in (AT_LEAST | ABOVE).items():
        value = getattr(row, name, None)
        if value is None or value > least or (value == least and name in AT_LEAST):
            continue
        expected = f"{least:g} or more" if name in AT_LEAST else f"more than {least:g}"
        raise Refusal(path, f"{where}.{name}", f"{value:g}", expected)
    count = getattr(row, "spheres", FEWEST)
    if not FEWEST <= count <= MOST:
        raise Refusal(path, f"{where}.spheres", f"{count}", f"{FEWEST} to {MOST}")


def require_sound(path: Path, layout: Layout) -> None:
    """What no edit would have made. Raises Refusal."""
    names = [part.name for part in layout.parts]
    for index, part in enumerate(layout.parts):
        where = f"{part.name or index}"
        if not part.name or part.name in names[:index]:
            raise Refusal(path, f"{where}.name", repr(part.name), "a name of its own")
        for field in ("position", "rotation"):
            count = len(getattr(part, field))
            if count != 3:
                raise Refusal(path, f"{where}.{field}", f"{count} numbers", "3")
        if len(part.tool_friction) > 1:
            raise Refusal(path, f"{where}.tool_friction", f"{len(part.tool_friction)} numbers",
                          "one, or none")  # fmt: skip
        if any(not mu >= 0.0 for mu in part.tool_friction):
            raise Refusal(path, f"{where}.tool_friction", f"{part.tool_friction[0]:g}", "0 or more")
        require_ranges(path, where, part)
    if len(layout.gravity) not in (0, 3):
        raise Refusal(path, "gravity", f"{len(layout.gravity)} numbers", "3, or none")
    if len(layout.fluid) not in (0, 2):
        raise Refusal(path, "fluid", f"{len(layout.fluid)} numbers", "2, or none")
    if any(number < 0.0 for number in layout.fluid):
        raise Refusal(path, "fluid", f"{min(layout.fluid):g}", "0 or more")
    if len(layout.tools) > 1:
        raise Refusal(path, "tools", f"{len(layout.tools)}", "one, or none")
    for tool in layout.tools:
        require_ranges(path, "tools[0]", tool)
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
        require_ranges(path, f"pairs[{index}]", pair)
    for index, scenery in enumerate(layout.scenery):
        if not set(scenery.stops) <= bodies or len(set(scenery.stops)) < len(scenery.stops):
            raise Refusal(path, f"scenery[{index}].stops", ", ".join(scenery.stops),
                          "names of bodies, each once")  # fmt: skip


def write_layout(path: Path, history: History) -> None:
    """Writes whole or not at all. Raises OSError."""
    data = {"format": FORMAT, "version": VERSION}
    data |= {each.name: convert(getattr(history, each.name)) for each in fields(history)}
    write_whole(path, (json.dumps(data, indent=1, ensure_ascii=False) + "\n").encode())


def convert(value: Layout | tuple[Layout, ...]) -> object:
    return asdict(value) if isinstance(value, Layout) else [asdict(each) for each in value]
