# SPDX-License-Identifier: BSD-3-Clause
"""What is written over the trainee's picture, and where it stands."""

from __future__ import annotations

import math
from copy import copy

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QFrame

from palpate.device.names import find_port
from palpate.player.boards import Board, EndBoard, MenuBoard, StartBoard
from palpate.player.cards import Banner, ClockCard, KeyLine, Notice, TaskCard
from palpate.player.check_board import CheckBoard
from palpate.player.debrief import DebriefBoard
from palpate.player.force_bar import ForceBar
from palpate.player.history_board import HistoryBoard
from palpate.player.people_boards import ConsentBoard, WhoBoard
from palpate.player.sentences import say_keys, translate
from palpate.runs.play import Play
from palpate.viewport import View, navigation
from palpate.viewport.pointer_hand import find_means

EDGE = 20
"""[px] to the sides of the window."""
GAP = 8
"""[px] between panels that must not touch."""
LEAST_BANNER = 18.0
"""[-] width of a sentence, in heights of a letter."""
SMALL = 0.85
"""[-] height of the letters of numbers beside the picture, in heights of a letter."""
SIDE = 9.4
"""[-] width of what stands on the right, in heights of a letter."""


class Overlays(QObject):
    """All panels of the window. They are children of the view and let the mouse through."""

    def __init__(self, view: View, play: Play):
        super().__init__(view)
        self._view, self._play = view, play
        self.task = TaskCard(view)
        self.clock = ClockCard(view)
        self.force = ForceBar(view, play.force_limit())
        self.notice = Notice(view)
        self.keys = KeyLine(view, say_keys)
        self.warning, self.alarm = Banner(view, "warning"), Banner(view, "alarm")
        self.pause, self.device = Banner(view, "warning"), Banner(view, "alarm")
        self.caption = Banner(view, "signal")
        instruments = play.scenario.scene.instruments
        means = find_means(instruments[0], 2 if len(instruments) > 1 else 0)
        self.start = StartBoard(view, play.record_folder(), bool(find_port(play.arm)), means)
        self.menu, self.end = MenuBoard(view), EndBoard(view)
        self.who, self.consent = WhoBoard(view), ConsentBoard(view)
        self.check, self.debrief = CheckBoard(view), DebriefBoard(view)
        self.history = HistoryBoard(view)
        self.boards: tuple[Board, ...] = (
            *(self.start, self.menu, self.end), *(self.who, self.consent, self.debrief),
            *(self.check, self.history),
        )  # fmt: skip
        self._letter = 16.0
        self._free = (0, 0, 0, 0)
        self.tell_task()
        self.task.folded.connect(self.place)
        self.reset()
        view.installEventFilter(self)

    def tell_task(self) -> None:
        """Title and task, in the language of the window where the scenario has it."""
        title, task = self._play.title(), self._play.translation().task
        self.task.tell(title, task)
        self.start.tell(title, task)

    def board(self) -> Board | None:
        """The one that is shown."""
        return next((b for b in self.boards if not b.isHidden()), None)

    def reset(self) -> None:
        """As before a run."""
        self.clock.show_time(0.0)
        self.force.reset()
        self.alarm.tell("")
        self.warning.tell("")
        self.device.tell("")
        self.caption.tell("")
        self.show_pause(False)

    def tell_device(self, sentence: str) -> None:
        """Why the device gives no force; nothing where it gives its force."""
        if sentence != self.device.sentence:
            self.device.tell(sentence)
            self.place()

    def show_pause(self, paused: bool) -> None:
        text = translate("Player", "Paused. Space goes on.") if paused else ""
        if text != self.pause.sentence:
            self.pause.tell(text)
            self.pause.setVisible(bool(text) and self.board() is None)
            self.place()

    def show_board(self, board: Board | None) -> None:
        """One of the boards, or none; what else there is to read steps back for it."""
        for other in self.boards:
            other.setVisible(other is board)
        self.task.setVisible(board is None or board in (self.end, self.debrief))
        self.pause.setVisible(board is None and bool(self.pause.sentence))
        self.place()

    def use_style(self, theme: str, letter: float) -> None:
        self._letter = letter
        # no wider than a letter: on a small screen the clock needs the room
        self.clock.rows.setContentsMargins(round(letter), 16, round(letter), 16)
        self.force.use_style(theme, letter)
        self._view.hud.use_letter(SMALL * letter)
        self.place()

    def say(self) -> None:
        """Sets all texts, in the language of the program."""
        paused = bool(self.pause.sentence)
        for panel in (self.clock, self.notice, self.keys, *self.boards):
            panel.say()
        self.tell_task()
        self.force.update()
        self.show_pause(paused)
        self.show_board(self.board())

    def place(self) -> None:
        """Everything to where it belongs, for the size the window has now."""
        width, height, m = self._view.width(), self._view.height(), self._letter
        notice_top = height - EDGE - self.notice.sizeHint().height()
        self.notice.adjustSize()
        self.notice.move(EDGE, notice_top)
        wide = round(min(22.0 * m, 0.28 * width))
        high = self.task.fit(wide, notice_top - GAP - EDGE)
        self.task.setGeometry(EDGE, EDGE, wide, high)
        self._put(self.clock, SIDE * m, width - EDGE - SIDE * m, EDGE)
        top = self.clock.geometry().bottom() + 12
        self.force.setGeometry(
            round(width - EDGE - SIDE * m),
            top,
            round(SIDE * m),
            max(0, min(round(24.0 * m), height - EDGE - top)),
        )
        self._keep_free(width, height, notice_top)
        self._place_keys(width, notice_top)
        self._place_banners(width, m)
        for board in self.boards:
            self._centre(board, round(min(34.0 * m, 0.9 * width)), notice_top - GAP)
        shown = self.board()
        if shown is not None and shown in (self.end, self.debrief):  # read whole, or not at all
            self.task.setVisible(not shown.geometry().intersects(self.task.geometry()))

    def _keep_free(self, width: int, height: int, notice_top: int) -> None:
        """The organ stands beside the task or below it, wherever it is seen larger."""
        right, bottom = round(SIDE * self._letter) + EDGE + GAP, height - notice_top + GAP
        task = self.task.geometry()
        beside = (task.right() + GAP, 0, right, bottom)
        below = (right // 3, task.bottom() + GAP, right, bottom)

        free = min(beside, below, key=self._find_distance)
        if free != self._free:
            self._free = free
            self._view.keep_free(*free)

    def _find_distance(self, free: tuple[int, int, int, int]) -> float:
        """[m] from which the organ is seen where it has to leave so much free."""
        left, top, right, bottom = free
        size = self._view.width(), self._view.height()
        if size[0] - left - right < size[0] / 4 or size[1] - top - bottom < size[1] / 4:
            return math.inf
        camera = copy(self._view.camera)
        navigation.fit(camera, self._view.scenery.points(), size, free)
        return camera.distance

    def _place_keys(self, width: int, top: int) -> None:
        """In the middle where there is room, else beside the notice; those that have no room, the
        menu tells of."""
        beside = self.notice.geometry().right() + 2 * EDGE
        fits = self.keys.fit(width - EDGE - beside)
        x = max(beside, (width - self.keys.width()) // 2)
        self.keys.move(x, top + (self.notice.height() - self.keys.height()) // 2)
        self.keys.setVisible(fits)

    def _place_banners(self, width: int, m: float) -> None:
        """On top, between what stands left and right; under the task where that is too narrow."""
        left = self.task.geometry().right() if self.task.isVisible() else 0
        right, y = width - EDGE - SIDE * m, EDGE
        if right - left < LEAST_BANNER * m:
            left, y = 0, self.task.geometry().bottom() + EDGE // 2
        room = right - left - 2 * EDGE
        for banner in (self.alarm, self.device, self.warning, self.pause, self.caption):
            if not banner.sentence:
                continue
            banner.ensurePolished()
            banner.label.ensurePolished()
            text = banner.label.fontMetrics().horizontalAdvance(banner.sentence)
            wide = min(room, text + 4 * m)
            x = left + EDGE + (room - wide) / 2
            self._put(banner, wide, x, y)
            hud = self._view.hud
            if not hud.isHidden() and banner.geometry().intersects(hud.geometry()):
                self._put(banner, wide, x, hud.geometry().bottom() + EDGE // 2)
            y = banner.geometry().bottom() + EDGE // 2
            banner.raise_()

    def _put(self, panel: QFrame, width: float, x: float, y: float) -> None:
        """At a place, as wide as said and as high as its text needs."""
        panel.ensurePolished()
        layout = panel.layout()
        layout.activate()
        high = layout.totalHeightForWidth(round(width)) if layout.hasHeightForWidth() else -1
        high = high if high > 0 else panel.sizeHint().height()
        panel.setGeometry(round(x), round(y), round(width), high)

    def _centre(self, board: Board, wide: int, bottom: int) -> None:
        """In the middle of the window, and nowhere on the notice; scrolled where it is too high."""
        high = board.fit(wide, bottom - GAP)
        y = min((self._view.height() - high) // 2, bottom - high)
        board.setGeometry((self._view.width() - wide) // 2, max(GAP, y), wide, high)
        board.raise_()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self.place()
        return super().eventFilter(watched, event)
