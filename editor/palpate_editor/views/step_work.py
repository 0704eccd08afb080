# SPDX-License-Identifier: GPL-3.0-or-later
"""A step of repair done beside the window, to be looked at before it is applied."""

from __future__ import annotations

from dataclasses import dataclass

from palpate_editor.document import Organ, Phrase
from palpate_editor.edits import Edit, EditError, Prepared, RepairAll
from palpate_editor.edits.change import find_change, say_change
from palpate_editor.edits.ladder import Climb, Rung, climb
from palpate_editor.guarded import stopping
from palpate_editor.views.jobs import Progress
from palpate_editor.views.translations import say_title


@dataclass(frozen=True, eq=False)
class Step:
    """What an edit would make of an organ."""

    edit: Prepared
    rungs: tuple[Rung, ...]
    """One, or those of the ladder."""
    left: tuple[Phrase, ...] = ()
    """What is still wrong after all of them."""


@dataclass(frozen=True, eq=False)
class StepWork:
    """Does a step and measures what it would change; cancelled, it ends the processes it began."""

    organ: Organ
    edit: Edit

    def __call__(self, progress: Progress) -> Step:
        progress(say_title(self.edit.title), 0.1)
        with stopping(progress.stop.is_set):
            if isinstance(self.edit, RepairAll):
                return self.climb(progress)
            after = self.edit(self.organ)
            progress(say_title(self.edit.title), 0.8)
            change = find_change(self.edit, self.organ, after)
        did = () if change is None else tuple(say_change(change))
        return Step(Prepared(self.edit, self.organ, after), (Rung(self.edit.title, did),))

    def climb(self, progress: Progress) -> Step:
        found: Climb = climb(self.organ, lambda title: progress(say_title(title), 0.5))
        if not found.rungs:
            # says so in the words of the edit
            self.edit(self.organ)
            raise EditError(found.left[0])
        return Step(Prepared(self.edit, self.organ, found.organ), found.rungs, found.left)
