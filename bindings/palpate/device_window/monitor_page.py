# SPDX-License-Identifier: BSD-3-Clause
"""What a device does now, and the switches of its motors."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDoubleSpinBox, QHBoxLayout, QWidget

import palpate
from palpate.command.sentence import Sentence
from palpate.device.link import DRIVING, Link
from palpate.device.poses import PLACES
from palpate.device_window.cards import Facts, Page, build_button
from palpate.device_window.gauges import Dial, Histogram, MotorBars
from palpate.device_window.sentences import number, say, say_joint, translate
from palpate.player.device_sentences import say_advice, say_state
from palpate.translation.refusals import say_note

STIFFNESS = 80.0
"""[N/m] of the spring at first."""
STIFFEST = 200.0
DASH = "\N{EN DASH}"


class MonitorPage(Page):
    """Live numbers of the device, and what may be asked of it."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.link: Link | None = None
        self._build_state()
        self._build_joints()
        self._build_forces()
        self._build_link()
        self._build_mishaps()
        self.column.addStretch(1)
        self.say()
        self.show_link(None)

    def _build_state(self) -> None:
        self.state_card = card = self.add_card()
        self.headline, self.advice = card.add("headline", wrap=True), card.add("faint", wrap=True)
        self.motors, self.clear = build_button(card, checkable=True), build_button(card)
        card.add_row(self.motors, self.clear)
        self.spring = build_button(card, checkable=True)
        self.stiffness = QDoubleSpinBox(card)
        self.stiffness.setRange(10.0, STIFFEST)
        self.stiffness.setDecimals(0)
        self.stiffness.setSingleStep(10.0)
        self.stiffness.setValue(STIFFNESS)
        self.stiffness.setSuffix(" N/m")
        self.stiffness.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        card.add_row(self.spring, self.stiffness)
        self.motors.clicked.connect(self.switch_motors)
        self.clear.clicked.connect(self.clear_fault)
        self.spring.clicked.connect(self.switch_spring)
        self.stiffness.valueChanged.connect(self.change_spring)

    def _build_joints(self) -> None:
        self.joints_card = card = self.add_card()
        self.dials = [Dial(card) for _ in range(3)]
        row = QHBoxLayout()
        for dial in self.dials:
            row.addWidget(dial)
        card.rows.addLayout(row)
        self.gimbal = Facts(card, 3, columns=3)
        card.rows.addWidget(self.gimbal)

    def _build_forces(self) -> None:
        self.forces_card = card = self.add_card()
        self.places = Facts(card, 3, columns=1)
        card.rows.addWidget(self.places)
        self.bars = MotorBars(card)
        card.rows.addWidget(self.bars)

    def _build_link(self) -> None:
        self.link_card = card = self.add_card()
        self.facts = Facts(card, 8)
        card.rows.addWidget(self.facts)
        self.histogram_title = card.add("faint")
        self.histogram = Histogram(card)
        card.rows.addWidget(self.histogram)
        self.note = card.add("faint", wrap=True)

    def _build_mishaps(self) -> None:
        self.mishaps = card = self.add_card()
        self.stop, self.wire = (
            build_button(card, checkable=True),
            build_button(card, checkable=True),
        )
        self.cable = build_button(card)
        card.add_row(self.stop, self.wire, self.cable)
        self.stop.clicked.connect(self.press_stop)
        self.wire.clicked.connect(self.cut_wire)
        self.cable.clicked.connect(self.pull_cable)

    # ------------------------------------------------------------ what is asked

    def show_link(self, link: Link | None) -> None:
        """Whose device it is; None for none."""
        self.link = link
        self.mishaps.setVisible(link is not None and link.arm is not None)
        self._heat_full = np.full(3, 1.0)
        for button in (self.motors, self.spring, self.stop, self.wire):
            button.setChecked(False)
        arm = palpate.Arm()
        self._say_note()
        if link is not None:
            arm = self._find_arm(link)
        low, high = np.degrees(arm.joint_min), np.degrees(arm.joint_max)
        for dial, lower, upper in zip(self.dials, low, high, strict=True):
            dial.range = (float(lower), float(upper))
        if link is None:
            self._show_nothing()

    def _find_arm(self, link: Link) -> palpate.Arm:
        try:
            calibration = link.driver.calibration()
        except palpate.DeviceError:
            return palpate.Arm()
        self._heat_full = np.maximum(1.0, np.array(calibration.continuous_duty, float) ** 2)
        return palpate.find_arm(calibration)

    def switch_motors(self, on: bool) -> None:
        if self.link is not None:
            if not on:
                self.switch_spring(False)
            self.link.driver.enable(on)

    def clear_fault(self) -> None:
        """The device forgets its fault; its motors stay off until they are asked for again."""
        if self.link is not None:
            self.link.driver.enable(False)
            self.link.push()
            self.link.driver.clear_fault()

    def switch_spring(self, on: bool) -> None:
        """Begins where the stylus is, so with no force."""
        self.spring.setChecked(on)
        if self.link is None:
            return
        if on:
            self._rest = np.array(self.link.status().tip)
            self.link.draw(self.stiffness.value(), self._rest)
        else:
            self.link.push()

    def change_spring(self, stiffness: float) -> None:
        if self.link is not None and self.spring.isChecked():
            self.link.draw(stiffness, self._rest)

    def press_stop(self, pressed: bool) -> None:
        if self.link is not None and self.link.arm is not None:
            self.link.arm.press_stop(pressed)

    def cut_wire(self, cut: bool) -> None:
        if self.link is not None and self.link.arm is not None:
            self.link.arm.cut_sensor(1, cut)

    def pull_cable(self) -> None:
        if self.link is not None and self.link.arm is not None:
            self.link.arm.pull_cable()

    # ------------------------------------------------------------ what is shown

    def show_status(self, status: palpate.DeviceStatus, busy: bool) -> None:
        """`busy` while a test or a calibration has the motors."""
        state, tone = say_state(status)
        self._set(self.headline, state)
        self._set(self.advice, say_advice(status))
        ready = status.link is palpate.LinkState.ready
        faulted = status.mode is palpate.DeviceMode.faulted
        driving = status.mode in DRIVING
        self.motors.setEnabled(ready and not busy and not faulted)
        self.motors.setChecked(driving)
        self.clear.setEnabled(faulted and not busy)
        self.spring.setEnabled(driving and not busy)
        self.stiffness.setEnabled(driving and not busy)
        if self.spring.isChecked() and not driving:
            self.switch_spring(False)
        self._show_joints(status, ready)
        self._show_forces(status, ready)
        self._show_rates(status)

    def _show_joints(self, status: palpate.DeviceStatus, known: bool) -> None:
        for dial, angle, count in zip(self.dials, status.joints, status.counts, strict=False):
            dial.show_angle(float(np.degrees(angle)) if known else None, count)
        self.gimbal.show_values(
            *(f"{number(float(np.degrees(a)), 1)}°" if known else DASH for a in status.gimbal)
        )

    def _show_forces(self, status: palpate.DeviceStatus, known: bool) -> None:
        rows = (
            (1e3 * status.tip, "mm", 1), (status.force_commanded, "N", 2),
            (status.force_applied, "N", 2),
        )  # fmt: skip
        self.places.show_values(
            *(
                f"{'   '.join(number(float(x), digits) for x in row)}  {unit}" if known else DASH
                for row, unit, digits in rows
            )
        )
        heat = np.array(status.counters[:3], dtype=float) / self._heat_full
        self.bars.show_motors(status.duty, [float(share) for share in heat])

    def _show_rates(self, status: palpate.DeviceStatus) -> None:
        missed = 0 if self.link is None else self.link.missed_ticks()
        self.facts.show_values(
            f"{number(status.report_rate, 0)} Hz",
            str(status.reports),
            str(status.lost_reports),
            str(status.damaged_frames),
            f"{number(1e3 * status.round_trip_median, 1)} ms",
            f"{number(1e3 * status.round_trip_p99, 1)} ms",
            f"{number(1e3 * status.jitter_p99, 2)} ms",
            str(missed),
        )
        self.histogram.show_counts(status.round_trips)

    def _show_nothing(self) -> None:
        self._set(self.headline, translate("Device", "Not connected"))
        self._set(
            self.advice,
            translate("Device", "Choose a device above and connect. The simulated one is always "
                      "there."),
        )  # fmt: skip
        for button in (self.motors, self.clear, self.spring, self.stiffness):
            button.setEnabled(False)
        for dial in self.dials:
            dial.show_angle(None, 0)
        for facts in (self.gimbal, self.places, self.facts):
            facts.show_values(*(DASH for _ in facts.values))
        self.bars.show_motors((0, 0, 0), (0.0, 0.0, 0.0))
        self.histogram.show_counts(np.zeros(40))

    def _set(self, label, text: str) -> None:
        if label.text() != text:
            label.setText(text)

    def _say_note(self) -> None:
        note = "" if self.link is None else self.link.note
        self.note.setText(say(note) if isinstance(note, Sentence) else say_note(note))
        self.note.setVisible(bool(note))

    def say(self) -> None:
        """Sets all texts."""
        self._say_note()
        self.state_card.title.setText(translate("Device", "STATE"))
        self.motors.setText(translate("Device", "Motors on"))
        self.clear.setText(translate("Device", "Clear the fault"))
        self.spring.setText(translate("Device", "Feel a spring here"))
        self.joints_card.title.setText(translate("Device", "JOINTS"))
        for dial, name in zip(self.dials, PLACES, strict=False):
            dial.name = say_joint(name)
            dial.update()
        self.gimbal.call(
            translate("Device", "stylus yaw"),
            translate("Device", "pitch"),
            translate("Device", "roll"),
        )
        self.forces_card.title.setText(translate("Device", "TIP AND MOTORS"))
        self.places.call(
            translate("Device", "Tip (right, away, up)"),
            translate("Device", "Force asked for"),
            translate("Device", "Force given"),
        )
        self.bars.names = tuple(say_joint(name) for name in PLACES[:3])
        self.bars.update()
        self.link_card.title.setText(translate("Device", "LINK"))
        self.facts.call(
            translate("Device", "Report rate"),
            translate("Device", "Reports"),
            translate("Device", "Lost"),
            translate("Device", "Damaged"),
            translate("Device", "Round trip, median"),
            translate("Device", "99 % within"),
            translate("Device", "Jitter, 99 %"),
            translate("Device", "Late ticks here"),
        )
        self.histogram_title.setText(translate("Device", "How long commands took there and back"))
        self.mishaps.title.setText(translate("Device", "WHAT CAN HAPPEN (SIMULATED)"))
        self.stop.setText(translate("Device", "Stop button"))
        self.wire.setText(translate("Device", "Wire off"))
        self.cable.setText(translate("Device", "Cable out"))
        if self.link is None:
            self._show_nothing()
