# SPDX-License-Identifier: BSD-3-Clause
"""The guided calibration, step by step, beside the picture that shows where to bring the arm."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QDoubleSpinBox, QWidget

import palpate
from palpate.command.sentence import PoorData
from palpate.device.calibration import Calibration, Reading, Stage, Work
from palpate.device.link import Ended, Link
from palpate.device_window.calibrate_sentences import (
    say_buttons,
    say_results,
    say_stage,
    say_step,
)
from palpate.device_window.cards import Page, build_button
from palpate.device_window.job import Job
from palpate.device_window.results import Results
from palpate.device_window.sentences import say, translate
from palpate.device_window.steps import Steps
from palpate.translation.refusals import say_refusal


class CalibratePage(Page):
    """A wizard: one thing to do at a time, and what came of it."""

    goal_changed = Signal(object)
    """(3,) joints [rad] that the arm is to be brought to, or None."""
    written = Signal()
    """The device has another calibration."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.link: Link | None = None
        self.run: Calibration | None = None
        self.job: Job | None = None
        self._problem = ""
        card = self.card = self.add_card()
        self.steps = Steps(card)
        card.rows.addWidget(self.steps)
        self.headline, self.explained = card.add("headline", wrap=True), card.add("", wrap=True)
        self.explained.setMinimumHeight(70)
        self.scale = QDoubleSpinBox(card)
        self.scale.setRange(-20.0, 20.0)
        self.scale.setDecimals(3)
        self.scale.setSingleStep(0.01)
        self.scale.setSuffix(" N")
        self.scale.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        self.scale_name = card.add("faint", wrap=True)
        card.rows.addWidget(self.scale)
        self.problem = card.add("warn", wrap=True)
        self.go, self.back, self.leave = (
            build_button(card, main=True), build_button(card), build_button(card),
        )  # fmt: skip
        card.add_row(self.go)
        card.add_row(self.back, self.leave)
        self.results_card = self.add_card()
        self.results = Results(self.results_card)
        self.results_card.rows.addWidget(self.results)
        self.column.addStretch(1)
        self.go.clicked.connect(self.go_on)
        self.back.clicked.connect(self.go_back)
        self.leave.clicked.connect(self.give_up)
        self.show_link(None)

    @property
    def busy(self) -> bool:
        """Whether the device is in the hands of a calibration."""
        return self.run is not None and self.run.stage not in (Stage.begin, Stage.done)

    @property
    def working(self) -> bool:
        return self.job is not None

    def show_link(self, link: Link | None) -> None:
        if link is None and self.job is not None:
            self.job.wait()
        self.link, self.job, self._problem = link, None, ""
        self.run = None if link is None else Calibration(link)
        self.say()

    # ------------------------------------------------------------ what is done

    def go_on(self) -> None:
        """The main button: does what the step asks for."""
        run = self.run
        if run is None or self.working:
            return
        self._problem = ""
        try:
            if run.stage is Stage.begin:
                run.start()
            elif run.stage is Stage.poses or run.stage is Stage.done:
                self._begin(run.read())
            elif run.stage is Stage.angles:
                self._begin(run.write_angles())
            elif run.stage is Stage.motors:
                self._begin(run.write_motors())
            elif run.force:
                self._begin(run.read())
            else:
                self._begin(run.push())
        except (palpate.DeviceError, PoorData) as problem:
            self._tell(problem)
        self.say()

    def go_back(self) -> None:
        """To the pose before; without one, to the beginning."""
        run = self.run
        if run is None or self.working:
            return
        self._problem = ""
        if run.stage in (Stage.poses, Stage.angles) and run.guide.counts:
            run.go_back()
            self.say()
        else:
            self.give_up()

    def give_up(self) -> None:
        """Nothing more is done; in the force check, what was written stays."""
        if self.link is None or self.run is None or self.working:
            return
        self._problem = ""
        if self.run.stage in (Stage.forces, Stage.motors):
            self.run.leave_forces()
        else:
            self.link.driver.enable(False)
            self.run = Calibration(self.link)
        self.say()

    def follow(self) -> None:
        """Goes on with what takes its time."""
        run = self.run
        if run is None:
            return
        try:
            self._end_job(run)
            self._watch_scale(run)
        except (palpate.DeviceError, PoorData, ValueError) as problem:
            self._tell(problem)
            self.say()

    def _end_job(self, run: Calibration) -> None:
        job = self.job
        if job is None or not job.done:
            return
        self.job = None
        if isinstance(job.problem, Ended):
            return
        if job.problem is not None:
            run.rest()
            raise job.problem
        if isinstance(job.result, Reading):
            self._take(run, job.result)
        elif isinstance(job.result, palpate.Calibration):
            try:
                run.end_writing(job.result)
            finally:
                self.written.emit()
        self.say()

    def _take(self, run: Calibration, reading: Reading) -> None:
        if run.stage is Stage.poses:
            run.take_pose(reading.gather)
        elif run.stage is Stage.done:
            run.take_home(reading.gather)
        elif run.stage is Stage.forces:
            scale = self.scale.value() if reading.scale is None else reading.scale
            try:
                work = run.take_push(reading.gather, scale)
            except PoorData:
                run.rest()
                raise
            self._begin(work or run.push())

    def _watch_scale(self, run: Calibration) -> None:
        """A simulated hand knows what it holds against."""
        arm = run.link.arm
        if arm is not None and run.stage is Stage.forces and run.force:
            self.scale.setValue(-float(np.asarray(arm.hand_force()) @ run.unit_vector()))

    def _begin(self, work: Work) -> None:
        self.job = Job(work)

    def _tell(self, problem: Exception) -> None:
        known = isinstance(problem, PoorData)
        self._problem = say(problem.sentence) if known else say_refusal(str(problem))

    # ------------------------------------------------------------ what is shown

    def say(self) -> None:
        """Sets everything by where the calibration stands."""
        run = self.run
        self.card.title.setText(translate("Device", "CALIBRATION"))
        self.steps.show_step(say_stage(), 0 if run is None else find_step(run))
        title, text = say_step(run)
        self.headline.setText(title)
        self.explained.setText(text)
        self.problem.setText(self._problem)
        self.problem.setVisible(bool(self._problem))
        asks = run is not None and run.stage is Stage.forces and run.force > 0.0
        by_hand = asks and run is not None and run.link.arm is None
        self.scale.setVisible(asks)
        self.scale.setReadOnly(not by_hand)
        self.scale_name.setVisible(asks)
        self.scale_name.setText(translate("Device", "The scale reads"))
        go, back, leave = say_buttons(run, self.job is not None)
        for button, label in ((self.go, go), (self.back, back), (self.leave, leave)):
            button.setText(label)
            button.setVisible(bool(label))
        for button in (self.go, self.back, self.leave):
            button.setEnabled(run is not None and not self.working)
        rows = [] if run is None else say_results(run)
        self.results_card.setVisible(bool(rows))
        self.results_card.title.setText(translate("Device", "WHAT CAME OUT"))
        self.results.show_rows(rows)
        self._show_goal()

    def _show_goal(self) -> None:
        run = self.run
        pose = run.guide.pose if run is not None and run.stage is Stage.poses else None
        self.goal_changed.emit(None if pose is None else pose.joints())


def find_step(run: Calibration) -> int:
    """Of the words of say_stage."""
    if run.stage is Stage.poses:
        return 0 if not run.guide.counts else 1
    return {
        Stage.begin: 0,
        Stage.angles: 2,
        Stage.forces: 3,
        Stage.motors: 3,
    }.get(run.stage, 4 if run.home_offset is None else 5)
