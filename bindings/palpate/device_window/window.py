# SPDX-License-Identifier: BSD-3-Clause
"""The device window: connect, watch, calibrate, test."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QEvent, QLocale, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QResizeEvent
from PySide6.QtWidgets import QWidget

import palpate
from palpate import translation
from palpate.command.verb import Report, WrongCall
from palpate.device.link import Link, build_link
from palpate.device_window.arm_scene import ArmScene
from palpate.device_window.calibrate_page import CalibratePage
from palpate.device_window.cards import Card
from palpate.device_window.job import Job
from palpate.device_window.lay_out import EDGE, Pages, lay_out
from palpate.device_window.monitor_page import MonitorPage
from palpate.device_window.mouse_hand import MouseHand
from palpate.device_window.selftest_page import SelftestPage
from palpate.device_window.sentences import translate
from palpate.device_window.strip import Strip
from palpate.device_window.style import Painted, build_style
from palpate.device_window.top_bar import TopBar
from palpate.player.cards import Banner, Notice
from palpate.player.device_sentences import say_advice, say_state
from palpate.player.style import build_palette
from palpate.translation.refusals import say_refusal
from palpate.viewport import make_view
from palpate.viewport.application import FRAME_MS, use_language

DRAW_EVERY = 2
"""Frames for each time that the plots are drawn: they cost more than they change."""
TABS = ("monitor", "calibrate", "selftest")


class DeviceWindow(QWidget):
    """Everything there is to see of a device and to ask of it. The device lives in a thread of its
    own; the window looks at it 60 times a second.
    """

    def __init__(
        self,
        theme: str = "dark",
        language: str = translation.SOURCE,
        build: Callable[[str], Link] = build_link,
        with_language: bool = True,
    ):
        """`build` makes a link of a device's name; without `with_language` the language is that of
        the program around the window.
        """
        super().__init__()
        self.setObjectName("device")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.theme, self.language = theme, language
        self.link: Link | None = None
        self.last_device: str | None = None
        self._build_link = build
        self._opening: Job | None = None
        self._frame = 0
        self._fill(with_language)
        self._connect_parts()
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(FRAME_MS)
        self._timer.timeout.connect(self.follow)
        self._timer.start()
        self.resize(1320, 860)
        self.use_theme(theme)
        self.say()
        self._show_link()
        self.bar.go.setFocus()

    def _fill(self, with_language: bool) -> None:
        self.bar = TopBar(self, with_language)
        self.view = make_view(self)
        self.scene = ArmScene(self.view, self.theme)
        self.hand = MouseHand(self.scene)
        self.view.tool = self.hand
        self.alarm, self.notice = Banner(self.view, "alarm"), Notice(self.view)
        self.plot_card = Card(self)
        self.strip = Strip(self.plot_card)
        self.plot_card.rows.addWidget(self.strip)
        self.monitor, self.calibrate, self.selftest = MonitorPage(), CalibratePage(), SelftestPage()
        self.pages = Pages(self, dict(zip(TABS, self._all_pages(), strict=True)))
        lay_out(self, self.bar, (self.view, self.plot_card), self.pages)

    def _all_pages(self) -> tuple[MonitorPage, CalibratePage, SelftestPage]:
        return self.monitor, self.calibrate, self.selftest

    def _connect_parts(self) -> None:
        self.bar.asked.connect(self.ask)
        self.bar.theme_asked.connect(self.change_theme)
        self.bar.language_asked.connect(self.use_language)
        self.calibrate.goal_changed.connect(self.scene.show_goal)
        self.calibrate.written.connect(self._read_arm)

    # ------------------------------------------------------------ the device

    def ask(self, name: str) -> None:
        """Connects to a device by name; an empty one lets it go."""
        if name:
            self.connect_to(name)
        else:
            self.disconnect_device()

    def connect_to(self, name: str) -> None:
        """Greets a device, which may take seconds; a sentence says what came of it."""
        if self._opening is not None:
            return
        self.disconnect_device()
        self.bar.choose(name)
        build = self._build_link

        def greet() -> Link:
            link = build(name)
            link.begin(live=True)
            return link

        self._opening = Job(greet)
        self.bar.show_connection(False, waiting=True)
        self.bar.show_state(translate("Device", "Greeting"), "plain")

    def disconnect_device(self) -> None:
        """Motors off, then nothing is said to it any more."""
        link, self.link = self.link, None
        self._tell("")
        if link is not None:
            link.interrupt()
        # whatever is at work with the device ends before its motors are switched off for good
        self._show_link()
        if link is not None:
            link.end()

    def follow(self) -> None:
        """Shows what the device did since the last frame."""
        self._end_opening()
        link = self.link
        if link is None:
            return
        status = link.status()
        if link.is_lost():
            self._lose()
            return
        self._frame += 1
        self.calibrate.follow()
        self.selftest.follow()
        busy = self.calibrate.busy or self.selftest.busy
        self.monitor.show_status(status, busy)
        self.bar.show_state(*say_state(status))
        faulted = status.mode is palpate.DeviceMode.faulted and not self.selftest.busy
        self._tell(f"{say_state(status)[0]}. {say_advice(status)}" if faulted else "")
        if status.link is palpate.LinkState.ready:
            self.scene.show_pose(status.joints, status.gimbal)
            self.scene.show_forces(status.force_commanded, status.force_applied)
            self.strip.add(status.time, status.force_commanded, status.force_applied)
            if self._frame % DRAW_EVERY == 0:
                self.strip.update()

    def _end_opening(self) -> None:
        job = self._opening
        if job is None or not job.done:
            return
        self._opening = None
        if job.problem is None:
            self.link = job.result
            self.last_device = self.link.name
            self.view.setFocus()
            self._read_arm()
        elif isinstance(job.problem, WrongCall | OSError):
            text = translate("Device", "It cannot be connected to: %1.")
            self._tell(text.replace("%1", say_refusal(str(job.problem))))
        else:
            self.tell_unexpected(job.problem)
        self._show_link()
        if self.link and self.link.status().link is palpate.LinkState.uncalibrated:
            self.pages.open("calibrate")

    def _lose(self) -> None:
        self.disconnect_device()
        self.bar.show_state(translate("Device", "Gone"), "bad")
        self._tell(
            translate(
                "Device",
                "The device is gone: its cable is out, or it has fallen silent. Plug it in and "
                "connect again.",
            )
        )

    def _show_link(self) -> None:
        link = self.link
        self.bar.show_connection(link is not None, waiting=False)
        if link is None:
            self.bar.show_state(translate("Device", "Not connected"), "plain")
            self.scene.show_forces(np.zeros(3), np.zeros(3))
        self.hand.link = link if link is not None and link.arm is not None else None
        self.hand.holds = False
        self.strip.clear()
        for page in self._all_pages():
            page.show_link(link)

    def _read_arm(self) -> None:
        """The links and ranges of the device, by its own calibration."""
        if self.link is None:
            return
        try:
            self.scene.use_arm(palpate.find_arm(self.link.driver.calibration()))
        except palpate.DeviceError:
            self.scene.use_arm(palpate.Arm())
        self.monitor.show_link(self.link)

    def report(self) -> Report:
        """For the command line."""
        return {"closed": True, "device": self.last_device}

    # ------------------------------------------------------------ how it looks

    def change_theme(self) -> None:
        self.use_theme("light" if self.theme == "dark" else "dark")

    def use_theme(self, name: str) -> None:
        """dark or light."""
        self.theme = name
        self.setPalette(build_palette(name))
        self.setStyleSheet(build_style(name))
        self.scene.use_theme(name)
        for part in self.findChildren(Painted):
            part.use_theme(name)
        self.bar.say(name, self.language)

    def use_language(self, code: str) -> None:
        """One of palpate.translation.LANGUAGES."""
        self.language = code
        use_language(code)
        self.say()

    def say(self) -> None:
        """Sets all texts, in the language of the program."""
        self.setLocale(QLocale())
        self.setWindowTitle(translate("Device", "Device \N{EN DASH} Palpate"))
        self.bar.say(self.theme, self.language)
        self.bar.show_connection(self.link is not None, self._opening is not None)
        if self.link is None:
            self.bar.show_state(translate("Device", "Not connected"), "plain")
        self.plot_card.title.setText(translate("Device", "FORCES"))
        self.pages.say(
            translate("Device", "Monitor"),
            translate("Device", "Calibrate"),
            translate("Device", "Self-test"),
        )
        for page in self._all_pages():
            page.say()
        self.notice.say()
        self._place()

    def tell_unexpected(self, problem: BaseException) -> None:
        """A defect of this program, in a sentence."""
        text = translate("Device", "Something went wrong that should not: %1.")
        self._tell(text.replace("%1", f"{type(problem).__name__}: {problem}"))

    def _tell(self, sentence: str) -> None:
        if sentence != self.alarm.label.text():
            self.alarm.tell(sentence)
            self._place()

    def _place(self) -> None:
        """The banner on top of the picture, the notice at its foot."""
        wide = min(620, self.view.width() - 2 * EDGE)
        self.alarm.ensurePolished()
        layout = self.alarm.layout()
        high = layout.totalHeightForWidth(wide) if layout.hasHeightForWidth() else 48
        self.alarm.setGeometry((self.view.width() - wide) // 2, EDGE, wide, high)
        self.alarm.raise_()
        self.notice.adjustSize()
        self.notice.move(EDGE, self.view.height() - self.notice.height() - EDGE)

    # ------------------------------------------------------------ Qt's events

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place()

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.LanguageChange:
            self.say()
        super().changeEvent(event)

    def closeEvent(self, event: QCloseEvent) -> None:
        self._timer.stop()
        opening, self._opening = self._opening, None
        if opening is not None:
            opening.wait()
            if opening.done and opening.problem is None:
                opening.result.end()
        self.disconnect_device()
        super().closeEvent(event)
