# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that verbs take and make: what one writes the next can read."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from palpate.files.file_kind import OBJ, ORGAN, STL
from palpate.files.refusal import Refusal
from palpate.scene.mesh_file import read_mesh_file

from palpate_editor import authoring
from palpate_editor.compile import mesh_of, surface_of
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.file_state import is_changed, read_state
from palpate_editor.document.files import write_organ
from palpate_editor.edits import Edit, EditError
from palpate_editor.edits.wall import settle_wall
from palpate_editor.open_organ import open_organ

MESHES = (".obj", ".stl")
"""What authoring.write_mesh makes."""
OUTPUTS = {".organ": ORGAN, ".obj": OBJ, ".stl": STL}
"""What write_any makes."""


def open_any(path: Path) -> Organ:
    """Every file that open_organ takes, and OBJ files of ours, whose organ is a bare surface."""
    if path.suffix != ".obj":
        return open_organ(path)
    surface = surface_of(read_mesh_file(path))
    organ = replace(EMPTY.with_surface(surface), name=path.stem, imported=surface)
    return settle_wall(organ, EMPTY)


def write_any(path: Path, organ: Organ) -> None:
    """A working file where the name ends in .organ, else the surface alone."""
    if path.suffix == ".organ":
        write_organ(path, organ)
        return
    if path.suffix.lower() not in MESHES:
        expected = f".organ, or {' or '.join(MESHES)} for the surface alone"
        raise Refusal(path, "", f"a name ending in {path.suffix!r}", expected)
    assert organ.surface is not None
    authoring.write_mesh(path, mesh_of(organ.surface))


@dataclass(frozen=True)
class ReadFile:
    """A file as it was before a verb read it."""

    path: Path
    state: str | None

    @classmethod
    def of(cls, path: Path) -> ReadFile:
        return cls(path, read_state(path))

    def check(self, out: Path) -> None:
        """Refuses to write over the file where it has changed since. Raises Refusal."""
        if out.resolve() == self.path.resolve() and is_changed(self.path, self.state):
            raise Refusal(
                out,
                "--out",
                "what another program wrote while this one was at work",
                "the file that was read; nothing is written: give the command again, or another "
                "name",
            )


def describe_loops(sizes: Sequence[int]) -> str:
    """Holes by their number of edges, the largest first: 1 hole of 48 edges, 200 of 3."""
    counts = sorted(Counter(sizes).items(), reverse=True)
    rows = [f"{number} of {size}" for size, number in counts]
    if not rows:
        return "no hole"
    size, number = counts[0]
    rows[0] = f"{number} hole{'s' if number > 1 else ''} of {size} edges"
    return ", ".join(rows)


class EditRefusal(Refusal):
    """An edit that cannot be done, in the edit's own words."""

    def __init__(self, file: Path, where: str, sentence: str):
        super().__init__(file, where, sentence, "an edit that can be done")
        self.args = (f"{file}: {where}: {sentence}",)


def apply(edit: Edit, organ: Organ, file: Path, where: str) -> Organ:
    """The edit done, or refused as a verb refuses."""
    try:
        return edit(organ)
    except EditError as refused:
        raise EditRefusal(file, where, str(refused)) from None
