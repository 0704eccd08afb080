# SPDX-License-Identifier: GPL-3.0-or-later
"""The Test stage: the organ in the real 1 kHz loop, under the mouse or a scripted press."""

from __future__ import annotations

import shlex

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QPushButton,
    QTabBar,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.document import Organ
from palpate_editor.document.problems import Problem
from palpate_editor.views.budget_bar import BudgetBar
from palpate_editor.views.context import Context
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.stages.stage_panel import StagePanel
from palpate_editor.views.theme import fixed_font
from palpate_editor.views.touch.force_plot import ForcePlot
from palpate_editor.views.touch.live_costs import LiveCosts
from palpate_editor.views.touch.meant_press import judge_press
from palpate_editor.views.touch.place_tool import PlaceTool
from palpate_editor.views.touch.press_form import PressForm, write_command
from palpate_editor.views.touch.results import Outcome
from palpate_editor.views.touch.results_box import ResultsBox
from palpate_editor.views.touch.runner import HandRequest, PressRequest, Runner, find_target
from palpate_editor.views.translations import tr

HAND, PRESS = 0, 1
"""Tabs."""


class TestPanel(StagePanel):
    """Starts, pauses and ends runs, and says what they felt."""

    __test__ = False
    stage = "test"
    shows_fixed = True
    dock = "force"
    run_changed = Signal(bool)
    """A run has begun, is paused, goes on or has ended; whether there is one."""

    @staticmethod
    def title() -> str:
        return tr("Test")

    @staticmethod
    def lead() -> str:
        return tr("Feel the organ in the loop a device will run, 1000 times a second.")

    @staticmethod
    def help() -> list[str]:
        return [
            tr("The loop that a haptic device will run, with your mouse as the hand. The left "
               "button presses, the right one takes hold, the wheel goes deeper."),
            tr("A scripted press gives numbers that can be compared from one day to the next."),
        ]  # fmt: skip

    def __init__(self, context: Context, parent: QWidget | None = None):
        self.plot, self.costs = ForcePlot(), LiveCosts()
        self._marked = False
        super().__init__(context, parent)
        self.runner = Runner(context, self.plot, self.costs, self)
        self.runner.changed.connect(self._show_state)
        self.runner.ended.connect(self._take_outcome)
        self.runner.measured.connect(self.budget.show_budget)
        self._place_tool = PlaceTool(context.session.organ.tool.radius, self)
        self._place_tool.picked.connect(self._take_place)
        self._place_tool.left.connect(self._end_pick)
        context.session.changed.connect(self._on_changed)
        context.stage_shown.connect(self._on_stage)
        context.theme_changed.connect(self.plot.use_theme)
        self.plot.use_theme(context.theme)
        self.plot.failed.connect(context.tell)
        self.plot.said.connect(self._say)
        self.press_form.refused.connect(context.tell)
        self.press_form.changed.connect(self._show_marker)
        self.press_form.changed.connect(self.show_checks)
        context.assessed.connect(self._show_marker)
        self._show_command()
        self._show_state()

    # ------------------------------------------------------------ looks

    def build(self) -> None:
        self.tabs = QTabBar(self)
        self.tabs.setObjectName("test_tabs")
        self.tabs.setExpanding(False)
        self.tabs.setDrawBase(False)
        self.pages = [self._build_hand(), self._build_press()]
        for title in (tr("By hand"), tr("Scripted press")):
            self.tabs.addTab(title)
        self.tabs.currentChanged.connect(self._on_tab)
        self.form.addWidget(self.tabs)
        for page in self.pages:
            self.form.addWidget(page)
        self._show_page(HAND)
        self.form.addLayout(self._build_buttons())
        self.state = write_label("", "lead", self)
        self.state.setWordWrap(True)
        self.form.addWidget(self.state)
        costs = self.section(tr("Cost of a tick"))
        self.budget = costs.add(BudgetBar(tr("Measured while the organ is felt."), self))
        results = self.section(tr("Last run"))
        self.results = results.add(ResultsBox(self.context, self))

    def is_known(self) -> bool:
        """Only once it has been felt."""
        return self.context.session.is_tested

    def _build_hand(self) -> QWidget:
        page = QWidget(self)
        column = QVBoxLayout(page)
        column.setContentsMargins(0, 2, 0, 4)
        text = write_label(
            tr(
                "The mouse is the hand: move over the organ, hold the left button to press, and "
                "turn the wheel to press deeper. The right button, or Ctrl, takes hold and pulls."
            ),
            "lead",
            page,
        )
        text.setWordWrap(True)
        column.addWidget(text)
        return page

    def _build_press(self) -> QWidget:
        page = QWidget(self)
        column = QVBoxLayout(page)
        column.setContentsMargins(0, 2, 0, 4)
        self.press_form = PressForm(page)
        self.press_form.changed.connect(self._show_command)
        self.press_form.pick_toggled.connect(self._on_pick)
        column.addWidget(self.press_form)
        self.command = write_label("", "note", page)
        self.command.setObjectName("press_command")
        self.command.setWordWrap(True)
        self.command.setFont(fixed_font(self.font()))
        self.command.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.command.setToolTip(tr("The same press from a command line, once published"))
        column.addWidget(self.command)
        return page

    def _build_buttons(self) -> QHBoxLayout:
        self.start_button = self.main_button(tr("Start"), "start_test")
        self.start_button.clicked.connect(self._on_start)
        self.pause_button = QPushButton(tr("Pause"), self)
        self.pause_button.setObjectName("pause_test")
        self.pause_button.clicked.connect(self._on_pause)
        self.reset_button = QPushButton(tr("Reset"), self)
        self.reset_button.setObjectName("reset_test")
        self.reset_button.setToolTip(tr("The same run again, from rest"))
        self.reset_button.clicked.connect(self.reset)
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(self.start_button, 2)
        row.addWidget(self.pause_button, 1)
        row.addWidget(self.reset_button, 1)
        return row

    # ------------------------------------------------------------ what keys and buttons do

    @property
    def running(self) -> bool:
        return self.runner.running

    @property
    def outcome(self) -> Outcome | None:
        """The last run that is over."""
        return self.results.outcome

    def toggle(self) -> None:
        """Starts what is chosen; pauses it and goes on when it runs."""
        if self.runner.running:
            self.runner.toggle_pause()
        elif not self.runner.waiting:
            self.start()

    def start(self) -> None:
        """Begins with what the tab in front says."""
        if self.tabs.currentIndex() == PRESS:
            self.press()
        else:
            self._end_pick()
            self.runner.start(HandRequest())

    def press(self) -> None:
        """Begins the scripted press."""
        self._end_pick()
        self.tabs.setCurrentIndex(PRESS)
        form = self.press_form
        self.runner.start(PressRequest(form.script(), form.place))

    def reset(self) -> None:
        """The same run from the beginning."""
        self.runner.reset()

    def stop(self) -> None:
        """Ends the run; before the window closes, and when another organ comes."""
        self._end_pick()
        self.runner.stop()

    def choose_record(self) -> None:
        """Asks for a file and keeps the last run in it."""
        self.results.choose_record()

    def _on_start(self) -> None:
        if self.runner.running or self.runner.waiting:
            self.stop()
        else:
            self.start()

    def _on_pause(self) -> None:
        self.runner.toggle_pause()

    def _on_tab(self, index: int) -> None:
        self.stop()
        self._show_page(index)
        self._show_marker()
        self.show_checks()

    def _show_page(self, shown: int) -> None:
        # not a stack of pages: that would be as high as the highest of them
        for i, page in enumerate(self.pages):
            page.setVisible(i == shown)

    def _on_stage(self, stage: str) -> None:
        if stage != self.stage:
            self.stop()
        self._show_marker()

    def _on_changed(self, before: Organ, after: Organ) -> None:
        if before.surface is not after.surface:
            self.press_form.show_place(None)
            self.budget.wait(tr("Measured while the organ is felt."))
        self._show_command()

    def good_news(self) -> list[str]:
        felt = [tr("The organ was felt as it is now.")] if self.context.session.is_tested else []
        return felt + self._judge_press()[1]

    def problems(self) -> list[Problem]:
        """Those of the organ, and whether the script goes deeper than what is validated."""
        return super().problems() + self._judge_press()[0]

    def _judge_press(self) -> tuple[list[Problem], list[str]]:
        if self.tabs.currentIndex() != PRESS:
            return [], []
        return judge_press(self.context.assessment, self.press_form)

    # ------------------------------------------------------------ the place

    def _on_pick(self, on: bool) -> None:
        view = self.context.view
        if on:
            self.runner.stop()
            self._place_tool.radius = self.context.session.organ.tool.radius
            self._place_tool.take(view)
            self.context.set_hint(tr("Click on the organ where the tip shall press, Esc to leave"))
        else:
            self._place_tool.give_back(view)
            self.context.set_hint("")
            self._show_marker()

    def _take_place(self, point: np.ndarray) -> None:
        self.press_form.show_place(point)

    def _end_pick(self) -> None:
        self.press_form.pick.setChecked(False)

    def _show_marker(self) -> None:
        """A ring where the script would press, while nothing else has the mouse."""
        context, found = self.context, self.context.assessment
        wanted = (
            context.stage == self.stage
            and self.tabs.currentIndex() == PRESS
            and not self.runner.running
            and context.view.tool is None
            and found is not None
            and found.scene is not None
            and found.organ is context.session.organ
        )
        if wanted:
            place = find_target(found.scene, self.press_form.place)
            context.view.show_ring(
                place.point, place.outward, found.scene.instruments[0].tool.radius
            )
        elif self._marked and context.view.tool is None:
            context.view.show_ring(None)
        self._marked = wanted

    # ------------------------------------------------------------ what is said

    def _say(self, sentence: str) -> None:
        self.context.tell(sentence, "info")

    def _command_arguments(self) -> list[str]:
        session, form = self.context.session, self.press_form
        stem = session.path.stem if session.path else session.organ.name or "organ"
        return write_command(f"{stem}.palpate", form.script(), form.place)

    def _show_command(self) -> None:
        self.command.setText(shlex.join(self._command_arguments()))

    def _show_state(self) -> None:
        runner = self.runner
        busy = runner.running or runner.waiting
        self.start_button.setText(tr("Stop") if busy else tr("Start"))
        self.pause_button.setText(tr("Go on") if runner.paused else tr("Pause"))
        self.pause_button.setEnabled(runner.running)
        self.reset_button.setEnabled(runner.running)
        text = (
            tr("Compiling the organ…")
            if runner.waiting
            else tr("Paused: Space goes on.")
            if runner.paused
            else tr("Running: Space pauses, R restarts.")
            if runner.running
            else tr("Space starts.")
        )
        self.state.setText(text)
        self.run_changed.emit(runner.running)
        self._show_marker()

    def _take_outcome(self, outcome: Outcome) -> None:
        self.results.show_outcome(outcome)
        if outcome.device == "script":
            self.context.log_command(self._command_arguments())
