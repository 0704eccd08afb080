# SPDX-License-Identifier: BSD-3-Clause
"""The check of the device in the trainee's window: what is to be done, step by step."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

import palpate
from palpate.command.verb import WrongCall
from palpate.player.check_sentences import say_stage
from palpate.player.sentences import translate
from palpate.render import Appearance
from palpate.render.authored_appearance import find_appearance, find_colours
from palpate.render.shapes import build_sphere
from palpate.runs.device_check import TARGETS, DeviceCheck, Stage, build_wall, is_broken
from palpate.runs.live import LiveRun
from palpate.runs.play import find_driver
from palpate.scene.surfaces import join_positions, join_rest_surfaces, join_triangles
from palpate.translation.refusals import say_refusal
from palpate.viewport import PointerHand
from palpate.viewport.application import FRAME_MS
from palpate.viewport.instruments import see_instruments

if TYPE_CHECKING:
    from palpate.player.host import Host

WATCHED = 3.0
"""[s] that a device without force is watched."""
CLEAR_EVERY = 0.2
"""[s] between two tries to bring the motors back"""
SILENT = 0.5
"""[s] without a frame after which a run is taken to rest: its motors were cut and came back between
two pictures."""
MARK = Appearance((0.98, 0.72, 0.25), gloss=0.2, subsurface=0.0, casts_shadow=False)
WALL = Appearance((0.45, 0.52, 0.60), gloss=0.3, subsurface=0.0)
MARK_RADIUS = 0.003


class CheckRun(QObject):
    """One run on the wall, at most 25 s long, with a record that goes when it is over."""

    found = Signal(object)
    """Report; None where it was left."""

    def __init__(self, window: Host, parent: QObject):
        super().__init__(parent)
        self.window, self.over = window, window.over
        self.run: LiveRun | None = None
        self.check: DeviceCheck | None = None
        self.device: palpate.HapticDevice | None = None
        self.with_force = False
        self._hand: PointerHand | None = None
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._frames, self._began, self._cleared, self._seen = 0, 0.0, 0.0, 0.0
        self._timer = QTimer(self, interval=FRAME_MS)
        self._timer.timeout.connect(self.follow)

    @property
    def busy(self) -> bool:
        return self.run is not None

    def start(self) -> None:
        """Raises nothing: a device that cannot be opened is told of as of a run."""
        if self.busy:
            return
        play, window = self.window.play, self.window
        wall = build_wall(window.scene)
        window.button.rest()
        try:
            hand = play.build_hand(wall)
            self.device = play.build_device(hand)
            self._begin_run(wall)
        except (OSError, WrongCall) as problem:
            text = translate("Player", "The device cannot be checked: %1")
            self.over.alarm.tell(text.replace("%1", say_refusal(str(problem))))
            self._put_back()
            self.found.emit(None)
            return
        self.with_force = bool(play.arm)
        if isinstance(hand, palpate.SurfacePointer):
            self._hand = window.view.tool = PointerHand(window.view, hand, wall)
        window.marks.clear()
        window.view.use_appearance(WALL)
        window.view.show_surface(join_rest_surfaces(wall), join_triangles(wall))
        window.view.frame_all()
        window.show_board(None)
        assert self.run is not None
        self._frames, self._began = 0, time.monotonic()
        self._cleared = self._seen = 0.0
        self.run.start()
        self._timer.start()

    def _begin_run(self, wall: palpate.Scene) -> None:
        assert self.device is not None
        driver = find_driver(self.device)
        self.check = DeviceCheck(wall, None if driver is None else self._read_status)
        self._folder = tempfile.TemporaryDirectory(prefix="palpate-check-")
        options = palpate.LoopOptions(
            safety=self.window.play.find_safety(self.device), on_fault=palpate.FaultResponse.pause
        )
        record = Path(self._folder.name) / "check.prec"
        device = self.window.play.join_devices(self.device, [])
        self.run = LiveRun(wall, device, record=record, options=options)

    def _read_status(self) -> palpate.DeviceStatus:
        assert self.device is not None
        driver = find_driver(self.device)
        assert driver is not None
        driver.take_status()
        return driver.status()

    def leave(self) -> None:
        """Esc: nothing is found."""
        if self.busy:
            self._end()
            self.found.emit(None)

    def close(self) -> None:
        if self.busy:
            self._end()

    def follow(self) -> None:
        """Once a frame."""
        run, check = self.run, self.check
        if run is None or check is None:
            return
        self._frames += 1
        clock = time.monotonic() - self._began
        fault = run.report().fault
        cut = fault is palpate.DeviceFault.motors_cut
        frame = None if self.window.view.is_busy() else run.take_frame()
        if frame is not None or self.window.view.is_busy():
            self._seen = clock
        # the run may rest on although the motors are back
        silent = clock - self._seen > SILENT
        rests = cut or silent or (check.stopped and frame is None)
        if rests and clock - self._cleared > CLEAR_EVERY:
            self._cleared = clock
            self._bring_back(run)
        if frame is not None:
            view = self.window.view
            view.move_surface(join_positions(frame.positions))
            view.show_instruments(see_instruments(check.scene, frame))
            view.show_force(frame.tool_position, frame.force)
            self.over.force.show_force(float(np.linalg.norm(frame.force)))
            check.take(frame, clock, cut)
        elif rests:
            check.take_rest(clock)
        self._tell(clock)
        if (
            check.over
            or is_broken(fault)
            or not run.running
            or (not self.with_force and clock > WATCHED)
        ):
            self._finish(clock)

    def _bring_back(self, run: LiveRun) -> None:
        """The stop button may be out again: the motors are asked for, and the run goes on."""
        assert self.device is not None
        driver = find_driver(self.device)
        if driver is not None:
            driver.clear_fault()
            run.resume()

    def _tell(self, clock: float) -> None:
        assert self.check is not None
        text = say_stage(self.check, self.with_force)
        if text != self.over.warning.sentence:
            self.over.warning.tell(text)
            self.over.place()
        view, stage = self.window.view, self.check.stage
        at = self.check.middle if stage is Stage.wall else None
        if stage is Stage.targets and self.check.target < len(TARGETS):
            at = self.check.place(self.check.target)
        shown = at is not None and self.with_force
        view.show_part("target", build_sphere(at, MARK_RADIUS) if shown else None, MARK)
        self.over.clock.show_time(clock)

    def _finish(self, clock: float) -> None:
        run, check, folder = self.run, self.check, self._folder
        assert run is not None and check is not None and run.record is not None
        fps, with_force = self._frames / max(clock, 1e-3), self.with_force
        self._timer.stop()
        costs = run.finish()
        report = check.describe(palpate.read_record(str(run.record)), costs, fps, with_force)
        self._end()
        del folder
        self.found.emit({**report, "duration_s": clock})

    def _end(self) -> None:
        self._timer.stop()
        run, self.run = self.run, None
        if run is not None:
            run.finish()
        self.check = self.device = None
        if self._folder is not None:
            self._folder.cleanup()
            self._folder = None
        self._put_back()

    def _put_back(self) -> None:
        view, scene = self.window.view, self.window.scene
        view.tool = None
        if self._hand is not None:
            self._hand.deleteLater()
            self._hand = None
        view.hint.say(None)
        view.show_part("target", None, MARK)
        view.show_force(None)
        view.show_instruments(())
        view.use_appearance(find_appearance(self.window.play.scenario))
        view.show_surface(join_rest_surfaces(scene), join_triangles(scene))
        view.show_colours(find_colours(self.window.play.scenario))
        view.frame_all()
        self.window.marks.show_first()
        self.over.force.rest()
        self.over.reset()
        self.over.place()
