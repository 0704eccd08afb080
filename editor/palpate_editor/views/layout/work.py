# SPDX-License-Identifier: GPL-3.0-or-later
"""What the window of scenes does beside itself: reading, checking, changing, publishing."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from palpate.layout.check import Checked, check
from palpate.layout.document import Layout
from palpate.layout.write import write_checked

from palpate_editor.layout_changes import Words, change
from palpate_editor.layout_shapes import Key, PartShape, read_shapes
from palpate_editor.views.jobs import Progress
from palpate_editor.views.translations import tr


@dataclass(frozen=True, eq=False)
class ReadWork:
    """Reads what is placed, but for what is known."""

    path: Path
    layout: Layout
    known: dict[Key, PartShape]

    def __call__(self, progress: Progress) -> tuple[Layout, dict[Key, PartShape]]:
        progress(tr("Reading the scene"), 0.1)
        return self.layout, read_shapes(self.path, self.layout, self.known)


@dataclass(frozen=True)
class ChangeWork:
    """Makes a change that reads files."""

    path: Path
    layout: Layout
    words: Words

    def __call__(self, progress: Progress) -> tuple[Layout, Words, Layout]:
        progress(tr("Changing the scene"), 0.1)
        return self.layout, self.words, change(self.path, self.layout, self.words)


@dataclass(frozen=True)
class CheckWork:
    """Finds all that is wrong, and what pairs cost where it `measures`."""

    path: Path
    layout: Layout
    measures: bool

    def __call__(self, progress: Progress) -> tuple[Layout, Checked]:
        progress(tr("Pressing each pair") if self.measures else tr("Checking the scene"), 0.1)
        return self.layout, check(self.path, self.layout, self.measures)


@dataclass(frozen=True)
class PublishWork:
    """Checks, and writes the file where there is nothing that forbids it."""

    path: Path
    layout: Layout
    out: Path

    def __call__(self, progress: Progress) -> tuple[Layout, Checked, Path]:
        progress(tr("Publishing {file}").format(file=self.out.name), 0.1)
        checked = check(self.path, self.layout)
        write_checked(self.out, self.layout, checked)
        return self.layout, checked, self.out
