# SPDX-License-Identifier: GPL-3.0-or-later
"""The ball that an object is taken out of or carried into, in numbers."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget

from palpate_editor.views.layout.number_grid import NumberGrid
from palpate_editor.views.layout.scene_draft import SceneDraft
from palpate_editor.views.translations import tr

NAMES = ("x", "y", "z", "radius")


class SpaceForm(NumberGrid):
    """Of the step that is looked at; hidden where that moves nothing."""

    def __init__(self, draft: SceneDraft, parent: QWidget | None = None):
        super().__init__(parent)
        self.draft = draft
        for name, words in zip(
            NAMES,
            (tr("Space at x"), tr("Space at y"), tr("Space at z"), tr("Radius of the space")),
            strict=True,
        ):
            self.add(f"space_{name}", words, "mm", 1e-3)
        self.entered.connect(self._set)
        draft.shown.connect(self.show_draft)

    def show_draft(self) -> None:
        space = self.draft.find_space()
        self.setVisible(space is not None)
        for name, value in zip(NAMES, space or (), strict=False):
            self.show_value(f"space_{name}", value)

    def _set(self, name: str, value: float) -> None:
        space = self.draft.find_space()
        if space is None:
            return
        if name == "space_radius" and not value > 0.0:
            self.show_draft()
            self.draft.tell(tr("A space has a radius above 0."))
            return
        space[NAMES.index(name.removeprefix("space_"))] = value
        self.draft.set_space(space)
