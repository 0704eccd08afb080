# SPDX-License-Identifier: GPL-3.0-or-later
"""A stage of your own in the editor: how large the organ is. One panel, and one entry."""

from __future__ import annotations

import numpy as np
import palpate
from palpate_editor.compile import mesh_of
from palpate_editor.document import Organ
from palpate_editor.views.stages.facts import Facts
from palpate_editor.views.stages.stage_panel import StagePanel
from palpate_editor.views.translations import quantity, tr


class MeasurePanel(StagePanel):
    """Measures the surface; all that the window says of the stage is asked of this class."""

    stage = "measure"

    @staticmethod
    def title() -> str:
        return tr("Measure")

    @staticmethod
    def lead() -> str:
        return tr("How large the organ is. Compare it with the book before you go on.")

    @staticmethod
    def help() -> list[str]:
        return [
            tr("Sizes are those of the box around the organ, along the axes of the viewport."),
            tr("Only a closed surface has a volume."),
        ]

    def build(self) -> None:
        """The form, once."""
        self.facts = self.section(tr("Sizes")).add(Facts(self))

    def show_organ(self, organ: Organ) -> None:
        """After every change of the organ; what takes long belongs into `context.jobs`."""
        if organ.surface is None:
            self.facts.show_facts([])
            return
        mesh = mesh_of(organ.surface)
        sizes = 1e3 * np.ptp(organ.surface.vertices, axis=0)
        rows = [("xyz"[axis], quantity(sizes[axis], "mm", 3)) for axis in range(3)]
        rows.append((tr("Area"), quantity(1e4 * palpate.compute_area(mesh), "cm²", 3)))
        self.facts.show_facts(rows)

    def show_assessment(self) -> None:
        """A little after every change, when the surface has been inspected in a thread."""

    def good_news(self) -> list[str]:
        """What holds; the stage's problems (`Problem.stage`) stand beside it by themselves."""
        assessment = self.context.assessment
        if assessment is None or assessment.report is None or assessment.report.border_loops:
            return []
        volume = 1e6 * palpate.compute_volume(mesh_of(assessment.organ.surface))
        return [tr("It encloses {volume}.").format(volume=quantity(volume, "mL", 3))]
