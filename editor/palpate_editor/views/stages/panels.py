# SPDX-License-Identifier: GPL-3.0-or-later
"""The stages of the window, in their order: to add one is a panel, and its entry here."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

from PySide6.QtWidgets import QWidget

from palpate_editor.views.scenario import ScenarioPanel
from palpate_editor.views.stage import Stages
from palpate_editor.views.stages.decimate_panel import DecimatePanel
from palpate_editor.views.stages.import_panel import ImportPanel
from palpate_editor.views.stages.material_panel import MaterialPanel
from palpate_editor.views.stages.publish_panel import PublishPanel
from palpate_editor.views.stages.repair_panel import RepairPanel
from palpate_editor.views.stages.stage_panel import StagePanel, Workers
from palpate_editor.views.touch import TestPanel

PANELS: tuple[type[StagePanel], ...] = (
    ImportPanel,
    RepairPanel,
    DecimatePanel,
    MaterialPanel,
    TestPanel,
    ScenarioPanel,
    PublishPanel,
)

Panel = TypeVar("Panel", bound=StagePanel)


def list_stages() -> Stages:
    return Stages(PANELS)


def build_panels(workers: Workers, hold: Callable[[str], QWidget]) -> list[StagePanel]:
    """`hold` gives the parent of a stage's panel."""
    return [panel.make(workers, hold(panel.stage)) for panel in PANELS]


def find_panel(panels: Iterable[StagePanel], kind: type[Panel]) -> Panel:
    """The one of this class."""
    return next(panel for panel in panels if isinstance(panel, kind))
