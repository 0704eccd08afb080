# SPDX-License-Identifier: GPL-3.0-or-later
"""What the viewport shows of the document: its surface, and one property of it as colours."""

from __future__ import annotations

import numpy as np
from palpate.render import build_appearance
from PySide6.QtCore import QObject, Signal

from palpate_editor.document import Organ
from palpate_editor.views.context import Context
from palpate_editor.views.stage import Stage
from palpate_editor.views.touch.colours import show_fixed, show_stiffness
from palpate_editor.views.translations import tr

COLOURINGS = ("auto", "plain", "stiffness", "distance")


class Display(QObject):
    """Draws the document whenever it, the stage or the choice of colours changes."""

    colouring_changed = Signal(str)

    def __init__(self, context: Context, parent: QObject | None = None):
        super().__init__(parent)
        self.context = context
        self.colouring = "auto"
        self.with_distance = True
        self.held = False
        """While the organ is being felt it belongs to the run."""
        self.drawn: Organ | None = None
        self.left = 0
        """[px] kept free for the legend."""
        context.session.changed.connect(self.on_changed)
        context.stage_shown.connect(self.on_stage)
        context.assessed.connect(self.refresh_values)
        context.distance_wanted.connect(self.use_distance)

    @property
    def stage(self) -> Stage:
        """The one that is shown."""
        return self.context.stages.by_name[self.context.stage]

    def on_changed(self, before: Organ, after: Organ) -> None:
        del before, after
        self.refresh()

    def on_stage(self, stage: str) -> None:
        del stage
        self.refresh_values()

    def use_colouring(self, colouring: str) -> None:
        """auto follows the stage."""
        self.colouring = colouring
        self.colouring_changed.emit(colouring)
        self.refresh_values()

    def use_distance(self, on: bool) -> None:
        self.with_distance = on
        self.refresh_values()

    def hold(self, held: bool) -> None:
        """A run takes the viewport, or gives it back."""
        self.held = held
        if not held:
            self.drawn = None
            self.refresh()

    # ------------------------------------------------------------ drawing

    def refresh(self) -> None:
        """Draws what the document says."""
        if self.held:
            return
        organ, view = self.context.session.organ, self.context.view
        before = self.drawn
        if organ.surface is None:
            if before is None or before.surface is not None:
                view.show_surface(np.zeros((0, 3)), np.zeros((0, 3), np.int32))
        elif before is None or before.surface is not organ.surface:
            view.show_surface(organ.surface.vertices, organ.surface.triangles)
            view.show_colours(organ.surface.colours)
        if before is None or before.appearance != organ.appearance:
            view.use_appearance(
                None if organ.appearance is None else build_appearance(organ.appearance)
            )
        self.drawn = organ
        self.refresh_values()

    def refresh_values(self) -> None:
        """Draws the colours and what is fixed."""
        organ, view = self.context.session.organ, self.context.view
        if self.held or organ.surface is None or self.drawn is not organ:
            return
        shown = self.choose()
        if shown == "stiffness":
            show_stiffness(view, organ.stiffness_scale, always=True)
        elif shown == "distance":
            assessment = self.context.assessment
            assert assessment is not None and assessment.comparison is not None
            view.show_values(
                1e3 * assessment.comparison.distances, tr("Distance to the source [mm]")
            )
        else:
            view.show_values(None)
        if self.stage.shows_fixed:
            show_fixed(view, organ.fixed, None)
        else:
            view.show_selection(None)
        if view.tool is not None and hasattr(view.tool, "show_organ"):
            view.tool.show_organ(organ)  # a selection, or a stroke that goes on
        self.make_room()

    def make_room(self) -> None:
        """The organ stands beside the legend, not under it, until a person turns it."""
        legend = self.context.view.legend
        left = 0 if legend.isHidden() else legend.geometry().right()
        if left != self.left:
            self.left = left
            self.context.view.keep_free(left=left)

    def choose(self) -> str:
        """Which property is shown now."""
        organ, assessment = self.context.session.organ, self.context.assessment
        painted = bool((organ.stiffness_scale != 1.0).any())
        known = (
            assessment is not None
            and assessment.organ.surface is organ.surface
            and assessment.organ.imported is organ.imported
            and assessment.comparison is not None
            and assessment.comparison.distances is not None
        )
        wanted = self.colouring
        if wanted == "auto":
            wanted = self.stage.colouring
            there = {"plain": True, "stiffness": painted, "distance": self.with_distance}
            wanted = wanted if there[wanted] else "plain"
        return "plain" if wanted == "distance" and not known else wanted
