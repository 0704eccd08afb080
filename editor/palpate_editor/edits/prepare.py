# SPDX-License-Identifier: GPL-3.0-or-later
"""Doing the work of an edit beside the window, before it is applied."""

from __future__ import annotations

from dataclasses import dataclass

from palpate_editor.document import Organ
from palpate_editor.edits.edit import Edit


@dataclass(frozen=True, eq=False)
class Prepared:
    """An edit whose work has been done for one organ."""

    edit: Edit
    before: Organ
    after: Organ

    @property
    def title(self) -> str:
        return self.edit.title

    def __call__(self, organ: Organ) -> Organ:
        # on any other organ the work must be done after all
        return self.after if organ is self.before else self.edit(organ)


def prepare(edit: Edit, organ: Organ) -> Prepared:
    """Does the work, on any thread. Raises EditError."""
    return Prepared(edit, organ, edit(organ))
