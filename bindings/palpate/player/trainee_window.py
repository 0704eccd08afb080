# SPDX-License-Identifier: BSD-3-Clause
"""The window of the trainee: the organ, the tool, the force, the time, and no way to get lost."""

from __future__ import annotations

import enum

from PySide6.QtCore import QEvent, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

import palpate
from palpate import translation
from palpate.command.verb import Report
from palpate.files.refusal import Refusal
from palpate.player.attendance import Attendance
from palpate.player.boards import Board
from palpate.player.device_button import DeviceButton
from palpate.player.device_watch import DeviceWatch
from palpate.player.hand_work import Preparation
from palpate.player.overlays import Overlays
from palpate.player.place_marks import PlaceMarks
from palpate.player.run_view import RunView
from palpate.player.sentences import say_end, translate
from palpate.player.style import build_palette, build_style
from palpate.render.authored_appearance import find_appearance, find_colours
from palpate.runs.live import LiveRun
from palpate.runs.next_attempt import draw_next
from palpate.runs.play import Play
from palpate.runs.play_report import describe_outcome, describe_play, describe_run
from palpate.scene.surfaces import join_rest_surfaces, join_triangles
from palpate.translation.refusals import say_refusal
from palpate.viewport import PointerHands, make_view
from palpate.viewport.application import FRAME_MS, use_language
from palpate.viewport.screen import fit_to_screen

SIZE = QSize(1280, 800)
"""[px] of a window on a screen with room for it."""


class Phase(enum.Enum):
    """Where a trainee is."""

    ready = enum.auto()
    running = enum.auto()
    paused = enum.auto()
    over = enum.auto()


class TraineeWindow(QWidget):
    """Plays a scenario. Space pauses, R starts again, T folds the task, F shows the force as an
    arrow or not, V changes between the room and what a laparoscope sees, F11 fills the screen, Esc
    opens the menu, Enter and the button of the device take what a board offers, and C clears the
    fault of a device that has cut its motors.
    """

    closed = Signal()

    def __init__(self, play: Play, theme: str = "dark", language: str = translation.SOURCE):
        super().__init__()
        self.play, self.scene = play, play.scenario.scene
        play.language = play.language or language
        self.phase = Phase.ready
        self.run: LiveRun | None = None
        self.hand: PointerHands | None = None
        self.theme, self.language = theme, language
        self._watch = DeviceWatch()
        self._costs: palpate.LoopReport | None = None
        self._problem: OSError | None = None
        self.view = make_view(self)
        self.view.wireframe = False
        self.view.use_appearance(find_appearance(play.scenario))
        self.view.show_hard_parts(self.scene)
        self._rest = join_rest_surfaces(self.scene)
        self.view.show_surface(self._rest, join_triangles(self.scene))
        self.view.show_colours(find_colours(play.scenario))
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.addWidget(self.view)
        self.over = Overlays(self.view, play)
        self.marks = PlaceMarks(self.view, play)
        self.attendance = Attendance(self, self)
        self.preparation = Preparation(self, self)
        self.shown = RunView(self, self.attendance)
        self.button = DeviceButton(play.arm, self)
        self._connect()
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(FRAME_MS)
        self._timer.timeout.connect(self.follow)
        self._tell_title()
        fit_to_screen(self, SIZE)
        self.use_theme(theme)
        self.over.start.languages.choose(language)
        self.over.menu.languages.choose(language)
        self.over.who.languages.choose(language)
        self.show_board(self.attendance.admission.first_board())

    def _connect(self) -> None:
        start, menu, end = self.over.start, self.over.menu, self.over.end
        start.start.clicked.connect(self.restart)
        menu.resume.clicked.connect(self.resume)
        for board in (menu, end):
            board.restart.clicked.connect(self.restart)
            board.quit.clicked.connect(self.close)
        menu.full_screen.clicked.connect(self.toggle_full_screen)
        start.languages.chosen.connect(self.use_language)
        menu.languages.chosen.connect(self.use_language)
        menu.themes.chosen.connect(self.use_theme)
        self.button.pressed.connect(self._confirm)

    # ------------------------------------------------------------ the run

    def restart(self) -> None:
        """Ends the run, if there is one, keeps its record, and begins another; not before it is
        known who plays.
        """
        if not self.attendance.may_begin():
            return
        self._finish()
        if self.preparation.start():
            return
        self.button.rest()
        hand = self.play.build_hand()
        try:
            device, others = self.play.build_device(hand), self.play.build_others()
            self.run = self.play.begin(device, self.attendance.begin(), others)
        except OSError as problem:
            self.attendance.give_up()
            self._refuse(problem)
            return
        self.shown.reset()
        self.play.state = None
        self.over.tell_task()
        self._watch = DeviceWatch(device)
        self.over.force.limit = self.play.force_limit()  # known once the device is open
        self.over.reset()
        self._tell_loss()
        self.view.move_surface(self._rest)
        self.view.show_torn(None)
        self.view.move_rigid(self.scene.rigid)
        self.view.show_force(None)
        self.view.show_instruments(())
        self.view.hud.show_rows(())
        pointers = [
            (number, each)
            for number, each in enumerate([hand, *others])
            if isinstance(each, palpate.SurfacePointer)
        ]
        if pointers:
            if self.hand is not None:
                self.hand.deleteLater()
            self.hand = self.view.tool = PointerHands(self.view, pointers, self.scene)
        self.phase = Phase.running
        self.show_board(None)
        self.run.start()
        self._timer.start()

    def _refuse(self, problem: OSError) -> None:
        """Why nothing was started."""
        if isinstance(problem, palpate.DeviceError):
            text = translate("Player", "The device cannot be used, so nothing was started: %1")
        else:
            text = translate("Player", "No record can be written, so nothing was started: %1")
        self.over.alarm.tell(text.replace("%1", say_refusal(str(problem))))
        self.over.place()
        self.show_board(self.over.board())

    def play_another(self) -> None:
        """The same task, with what the next seed draws."""
        try:
            draw_next(self.play)
        except Refusal as problem:
            self.over.alarm.tell(say_refusal(str(problem)))
            self.over.place()
            return
        self.scene = self.play.scenario.scene
        self.attendance.ghost.forget()
        self.restart()

    def pause(self) -> None:
        if self.phase is Phase.running and self.run is not None:
            self.run.pause()
            self.phase = Phase.paused
            self.over.show_pause(True)

    def resume(self) -> None:
        """Not while the device gives no force: the run would rest again at once."""
        if self.phase is Phase.paused and self.run is not None:
            self.show_board(None)
            if self.run.report().fault is not palpate.DeviceFault.none:
                return
            self.over.show_pause(False)
            self.phase = Phase.running
            self.run.resume()

    def open_menu(self) -> None:
        """Pauses too: nobody reads a menu and presses an organ."""
        self.pause()
        if self.phase is Phase.paused:
            self.show_board(self.over.menu)

    def follow(self) -> None:
        """Shows what the haptic thread did since the last frame; ends the run where it ended, and
        pauses with it where its device gives no force any more.
        """
        run = self.run
        if run is None:
            return
        frame = None if self.view.is_busy() else run.take_frame()
        if frame is not None:
            self.shown.show(frame)
        self.over.force.show_force(self.shown.force)
        report = run.report()
        failed = report.fault is not palpate.DeviceFault.none
        if failed:
            self.pause()
        self.over.tell_device(self._watch.say(report.fault))
        self.over.show_pause(self.phase is Phase.paused and not failed)
        alarm = report.alarm.kind is not palpate.AlarmKind.none
        over = alarm or not run.running
        del run  # else it keeps the port of the device
        if over:
            self._end(say_end(report.alarm) if alarm else "")

    def _end(self, trouble: str) -> None:
        frame = None if self.run is None else self.run.take_frame()
        if frame is not None:
            self.shown.show_last(frame)
        self._finish()
        self.phase = Phase.over
        record = str(self.play.records[-1])
        self.over.tell_device("")
        self.over.end.tell(self.shown.time, self.over.force.peak, record, trouble, self.play.state)
        debrief = None if trouble else self.attendance.debrief()
        self.show_board(debrief or self.over.end)

    def _finish(self) -> None:
        """Stops the run and completes its record."""
        self._timer.stop()
        run, self.run = self.run, None
        if run is None:
            return
        self.over.force.rest()
        self.view.hud.show_rows(())
        self.marks.clear()
        self._watch = DeviceWatch()  # else it keeps the port of the device
        self.view.tool = None
        self.view.hint.say(None)
        try:
            self._costs = run.finish()
            self.attendance.end(self.play.records[-1], self._costs)
        except OSError as problem:
            self._problem = problem
            self._tell_loss()

    def _tell_loss(self) -> None:
        """Of a record, until the window is closed: the record may be needed."""
        if self._problem is not None:
            text = translate("Player", "The record could not be completed: %1")
            self.over.alarm.tell(text.replace("%1", say_refusal(str(self._problem))))

    def report(self) -> Report:
        """What was played, for the command line. Raises OSError where a record was lost."""
        if self._problem is not None:
            raise self._problem
        kept = not self.attendance.practising
        records = [str(path) for path in self.play.records if kept]
        report = {**describe_play(self.play), "records": records, "record": None}
        if self._costs is None or not records:
            return report
        last = self.play.records[-1]
        felt = describe_run(self.play, last, self._costs)
        return {**describe_outcome(self._costs), **report, "record": str(last), **felt}

    # ------------------------------------------------------------ how it looks

    def use_theme(self, name: str) -> None:
        """dark or light."""
        self.theme = name
        self.over.menu.themes.choose(name)
        self.view.use_theme(name)
        self.marks.use_theme(name)
        self.setPalette(build_palette(name))
        self._use_letters()

    def use_language(self, code: str) -> None:
        """One of palpate.translation.LANGUAGES."""
        self.language = self.play.language = code
        use_language(code)
        for board in (self.over.start, self.over.menu, self.over.who):
            board.languages.choose(code)
        self.over.say()
        self._tell_title()

    def _tell_title(self) -> None:
        self.setWindowTitle(f"{self.play.title()} \N{EN DASH} Palpate")

    def toggle_full_screen(self) -> None:
        if self.isFullScreen():
            self.showNormal()
        else:
            self.showFullScreen()

    def tell_unexpected(self, problem: BaseException) -> None:
        """A defect of this program, in a sentence."""
        text = translate("Player", "Something went wrong that should not: %1. Press R to restart.")
        self.over.alarm.tell(text.replace("%1", f"{type(problem).__name__}: {problem}"))
        self.over.place()

    def _use_letters(self) -> None:
        """Text grows with the window, so that it is read from where one stands."""
        letter = min(max(self.height() / 46, 13.0), 30.0)
        self.setStyleSheet(build_style(self.theme, letter))
        self.over.use_style(self.theme, letter)

    def show_board(self, board: Board | None) -> None:
        """One of those over the picture, or none of them."""
        self.over.show_board(board)
        if board is None:
            self.button.rest()
            self.view.setFocus()
        else:
            self.button.listen(self._watch.driver)
            board.focus()

    def _press_board(self) -> None:
        board = self.over.board()
        if board is not None:
            board.press()

    def _confirm(self) -> None:
        """What the button of the device does."""
        board = self.over.board()
        if board is not None:
            board.confirm()

    # ------------------------------------------------------------ Qt's events

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = event.key()
        if event.isAutoRepeat():
            return
        if key == Qt.Key.Key_F11:
            self.toggle_full_screen()
        elif key == Qt.Key.Key_Escape:
            if self.attendance.leave():
                pass
            elif self.preparation.running:
                self.preparation.leave()
            elif self.over.menu.isVisible():
                self.resume()
            else:
                self.open_menu()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._press_board()
        elif key == Qt.Key.Key_F:
            self.view.shows_force = not self.view.shows_force
        elif key == Qt.Key.Key_T:
            self.over.task.toggle()
        elif key == Qt.Key.Key_R:
            self.restart()
        elif key == Qt.Key.Key_C:
            self._watch.clear_fault()
        elif key == Qt.Key.Key_Space:
            {Phase.running: self.pause, Phase.paused: self.resume}.get(self.phase, self.restart)()
        else:
            super().keyPressEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._use_letters()

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.LanguageChange:
            self.over.say()
        super().changeEvent(event)

    def closeEvent(self, event: QCloseEvent) -> None:
        self.preparation.stop()
        self.attendance.close()
        self.button.rest()
        self._finish()
        super().closeEvent(event)
        self.closed.emit()
