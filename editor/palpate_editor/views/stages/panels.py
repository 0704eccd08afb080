# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels of all stages, in their order."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtWidgets import QWidget

from palpate_editor.views.context import Context
from palpate_editor.views.publishing import Publishing
from palpate_editor.views.stages.decimate_panel import DecimatePanel
from palpate_editor.views.stages.import_panel import ImportPanel
from palpate_editor.views.stages.material_panel import MaterialPanel
from palpate_editor.views.stages.publish_panel import PublishPanel
from palpate_editor.views.stages.repair_panel import RepairPanel
from palpate_editor.views.stages.stage_panel import StagePanel
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.touch import TestPanel
from palpate_editor.views.translations import tr


@dataclass(frozen=True)
class Panels:
    """One for each stage."""

    importing: ImportPanel
    repair: RepairPanel
    decimate: DecimatePanel
    material: MaterialPanel
    test: TestPanel
    publish: PublishPanel

    def in_order(self) -> list[StagePanel]:
        return [self.importing, self.repair, self.decimate, self.material, self.test, self.publish]


def build_panels(context: Context, tasks: Tasks, publishing: Publishing, parent: QWidget) -> Panels:
    return Panels(
        ImportPanel(context, tr("Bring in a surface and say what its numbers mean."), parent),
        RepairPanel(
            context,
            tasks,
            tr("A tissue needs a clean surface. Holes stay open until you fill them."),
            parent,
        ),
        DecimatePanel(
            context,
            tasks,
            tr("Fewer vertices tick faster. The shape shown is what will be felt."),
            parent,
        ),
        MaterialPanel(
            context,
            tr("Chosen by hand to feel like an organ, or given by what the tissue is made of."),
            parent,
        ),
        TestPanel(context, parent),
        PublishPanel(
            context, publishing, tr("Write one file that a trainee can open and feel."), parent
        ),
    )
