# SPDX-License-Identifier: GPL-3.0-or-later
"""An organ made again from its original, by the lines of its history."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from palpate.files.json_part import json_kind
from palpate.files.refusal import Refusal

from palpate_editor.document import EMPTY, History, Organ
from palpate_editor.document.files import pack_organ
from palpate_editor.edits import LINES, Edit, EditError, ImportMesh, import_file, read_line
from palpate_editor.edits.import_mesh import BESIDE, Assembling
from palpate_editor.from_scan import import_scan
from palpate_editor.scan import Choice

ASKED = "as asked"
"""The reason of a unit or an axis that a person chose."""


@dataclass(frozen=True)
class Step:
    """A line of the history, as an edit."""

    place: str
    edit: Edit

    @property
    def title(self) -> str:
        return self.edit.title


def require_history(organ: Organ, file: Path) -> History:
    """Raises Refusal where nobody wrote down what was done."""
    if organ.history is None:
        raise Refusal(
            file,
            "history",
            "no line",
            "an .organ in which what was done is written down: this one is as it was read, or was "
            "made before its steps were kept",
        )
    return organ.history


def read_steps(organ: Organ, file: Path) -> list[Step]:
    """What was done, the first first. Raises Refusal, with its place, for a line that no edit has
    written."""
    lines = require_history(organ, file).lines
    places = [f"history.lines[{row}]" for row in range(len(lines))]
    return [
        Step(place, read_line(line, LINES, file, place))
        for place, line in zip(places, lines, strict=True)
    ]


def rebuild(organ: Organ, steps: Sequence[Step], file: Path) -> Organ:
    """The organ after these of its steps. Raises Refusal for one that cannot be done."""
    history = require_history(organ, file)
    made = replace(history.begin, history=replace(history, lines=()))
    for step in steps:
        try:
            made = step.edit(made)
        except EditError as refused:
            expected = "a step that can be done"
            raise Refusal(file, step.place, f"{step.title}: {refused}", expected) from None
        except (ValueError, IndexError, KeyError, TypeError, AttributeError) as wrong:
            # values that no edit would have taken, since each checks what it is given
            expected = "values that this step can be done with"
            raise Refusal(
                file, step.place, f"{type(step.edit).__name__}: {wrong}", expected
            ) from None
    # the very lines that were done: an edit that has got another value since would write it down
    return replace(made, history=replace(history, lines=history.lines[: len(steps)]))


def read_again(steps: Sequence[Step], original: Path, file: Path) -> list[Step]:
    """The steps with their import read from the file itself. Raises what reading a file does, and
    Refusal for a file that does not give the surface that the organ keeps."""
    rows = [row for row, step in enumerate(steps) if isinstance(step.edit, ImportMesh)]
    if not rows:
        raise Refusal(file, "--original", "an organ that was not imported", "no original beside it")
    step = steps[rows[-1]]
    kept: Any = step.edit
    found = import_again(kept, original)
    if found.source.sha256 != kept.source.sha256:
        raise Refusal(
            original, "", "another file", f"the one whose SHA-256 is {kept.source.sha256}"
        )
    for name in ("vertices", "triangles"):
        if not is_same(getattr(found.surface, name), getattr(kept.surface, name)):
            where, expected = f"{step.place}.surface.{name}", "what the organ keeps of it"
            raise Refusal(file, where, f"other {name} of {original.name}", expected)
    again = replace(kept, surface=found.surface)
    return [*steps[: rows[-1]], replace(step, edit=again), *steps[rows[-1] + 1 :]]


def import_again(kept: ImportMesh, original: Path) -> ImportMesh:
    """Parts, unit and axis as they were asked for."""
    source, done = kept.source, kept.segmentation
    unit = source.unit if source.unit_reason == ASKED else None
    if done is None:
        parts = source.parts if source.parts != source.parts_available else ()
        up = source.up if source.up_reason == ASKED else None
        together = kept.assembly
        assembling = BESIDE
        if together is not None:
            assembling = Assembling(
                together.weld, together.unite, together.subtracted, together.regions
            )
        return import_file(original, parts=parts, unit=unit, up=up, assembling=assembling)
    choice = Choice(done.labels, done.low, done.high, done.smooth, done.largest, done.least_volume)
    return import_scan(original, choice, series=done.series or None, unit=unit)[0]


def is_same(one: np.ndarray, other: np.ndarray) -> bool:
    """Bit for bit."""
    alike = one.dtype == other.dtype and one.shape == other.shape
    return alike and one.tobytes() == other.tobytes()


def find_difference(made: Organ, kept: Organ) -> tuple[str, str, str] | None:
    """Where two organs differ as files, what the first has there, and what the second."""
    content, arrays = pack_organ(replace(made, history=None))
    other, others = pack_organ(replace(kept, history=None))
    for name in sorted({*arrays, *others}):
        if name not in arrays or name not in others:
            has = ["an array" if name in every else "nothing" for every in (arrays, others)]
            return name, has[0], has[1]
        if not is_same(arrays[name], others[name]):
            return name, *say_difference(arrays[name], others[name])
    return compare(content, other)


def say_difference(one: np.ndarray, other: np.ndarray) -> tuple[str, str]:
    if one.shape != other.shape:
        return f"shape {one.shape}", f"shape {other.shape}"
    differ = np.flatnonzero((one != other).reshape(len(one), -1).any(axis=1))
    row = int(differ[0]) if differ.size else 0
    return f"row {row}: {one[row]}", f"{other[row]} ({len(differ)} rows differ)"


def compare(one: Any, other: Any, place: str = "") -> tuple[str, str, str] | None:
    """The first place at which two values of JSON differ."""
    if isinstance(one, dict) and isinstance(other, dict) and set(one) == set(other):
        rows = ((f"{place}.{key}".lstrip("."), one[key], other[key]) for key in one)
        return next(filter(None, (compare(a, b, at) for at, a, b in rows)), None)
    return None if one == other else (place, json_kind(one), json_kind(other))


def describe_begin(history: History) -> str:
    """What the steps begin with."""
    begin = history.begin
    if history.folded:
        return f"the organ after {history.folded} steps of which no line is kept"
    if begin.surface is None:
        same = compare(pack_organ(begin)[0], pack_organ(EMPTY)[0]) is None
        return "nothing" if same else "constants without a surface"
    return f"the organ {begin.name!r} of {begin.vertex_count} vertices, as it was read"
