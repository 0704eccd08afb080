# SPDX-License-Identifier: GPL-3.0-or-later
"""The dock of the stages: one panel at a time, and over it the options of the tool in use."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize
from PySide6.QtWidgets import QScrollArea, QSizePolicy, QStackedWidget, QVBoxLayout, QWidget

from palpate_editor.views.context import Context
from palpate_editor.views.stage_bar import Verdict
from palpate_editor.views.stages.stage_panel import StagePanel
from palpate_editor.views.touch.tools import Tool

SCROLL_BAR = 14
"""[px]"""


class OptionsArea(QScrollArea):
    """No higher than the options are, and lower where panel and options share a small screen."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)

    def sizeHint(self) -> QSize:
        """Of the options there are: QScrollArea keeps that of the first ones it was asked for."""
        edge = 2 * self.frameWidth()
        return self.widget().sizeHint() + QSize(edge, edge)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().eventFilter(watched, event)


class StageDock(QWidget):
    """Holds all panels and keeps the one that is seen up to date."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.panels: dict[str, StagePanel] = {}
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.options = QVBoxLayout()
        self.options.setContentsMargins(16, 10, 16, 4)
        self.options_holder = QWidget(self)
        self.options_holder.setLayout(self.options)
        self.options_holder.setAutoFillBackground(True)
        self.options_area = OptionsArea(self)
        self.options_area.setWidget(self.options_holder)
        self.options_area.hide()
        column.addWidget(self.options_area)
        self.stack = QStackedWidget(self)
        column.addWidget(self.stack, 1)
        self.areas = {stage: self.build_area() for stage in context.stages.names}
        self.shown_options: QWidget | None = None

    def build_area(self) -> QScrollArea:
        area = QScrollArea(self.stack)
        area.setWidgetResizable(True)
        self.stack.addWidget(area)
        return area

    def hold(self, stage: str) -> QWidget:
        """The parent of a stage's panel; see Docks.hold."""
        return self.areas[stage].viewport()

    def fill(self, panels: list[StagePanel]) -> None:
        """Takes the panels of all stages."""
        self.panels = {panel.stage: panel for panel in panels}
        for stage, panel in self.panels.items():
            self.areas[stage].setWidget(panel)
        self.fit()

    def fit(self) -> None:
        """As wide as the widest panel needs to be, and its scroll bar."""
        widest = max(panel.minimumSizeHint().width() for panel in self.panels.values())
        self.setMinimumWidth(widest + SCROLL_BAR)

    def show_stage(self, stage: str) -> None:
        self.stack.setCurrentIndex(list(self.panels).index(stage))

    def show_tool(self, tool: Tool | None) -> None:
        """Shows a tool's options, or none."""
        if self.shown_options is not None:
            self.options.removeWidget(self.shown_options)
            self.shown_options.hide()
            self.shown_options = None
        options = tool.options() if tool is not None else None
        if options is not None:
            self.options.addWidget(options)
            options.show()
            self.shown_options = options
        self.options_area.setVisible(options is not None)

    def show_organ(self) -> None:
        for panel in self.panels.values():
            panel.show_organ(self.context.session.organ)

    def show_assessment(self) -> None:
        for panel in self.panels.values():
            panel.show_assessment()
            panel.show_checks()

    def verdict(self, stage: str) -> Verdict:
        """How a stage stands."""
        assessment = self.context.assessment
        if assessment is None or assessment.organ.surface is None:
            return Verdict()
        found = assessment.of_stage(stage)
        errors = sum(problem.severity == "error" for problem in found)
        warnings = sum(problem.severity == "warning" for problem in found)
        return Verdict(errors, warnings, self.panels[stage].is_known())
