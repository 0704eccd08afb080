# SPDX-License-Identifier: GPL-3.0-or-later
"""One live run in the window: the 1 kHz loop in C++, and its newest frame in every picture."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

import numpy as np
import palpate
from palpate.runs.alarms import advise_design, say_alarm, say_element
from palpate.runs.cause import Cause
from palpate.runs.element import Element
from palpate.runs.live import Frame, LiveRun
from palpate.runs.pinch import Pinch, find_pinches, list_wrong, tell_rows
from palpate.runs.stretch import StretchGauge
from palpate.scene.surfaces import join_torn
from palpate.translation.numbers import say_digits
from palpate.viewport import View, see_instruments
from PySide6.QtCore import QCoreApplication, QObject, QTimer, Signal

from palpate_editor.document.constants import LAW_NAMES, find_constant
from palpate_editor.views.stages.material_panel import MaterialPanel
from palpate_editor.views.translations import fill, number, say, tr

FRAME = 16
"""[ms] between two readings of the loop's newest frame."""
SMALLEST_FORCE = 0.01
"""[N] Less is noise of a tip that slides along, and gets no arrow."""
ARROW, LONGEST = 0.25, 0.75
"""[-] of the organ's diagonal that the arrow of 1 N is long, and that any is at most."""
LEAST_TOP = 1e-3
"""[m] displacement at the top of the legend of an organ that hardly moves."""
TOPS = (1.0, 2.0, 5.0, 10.0)


class Trial(QObject):
    """Runs a scene with a hand, and shows the tissue, the tool and the force in the view."""

    framed = Signal(object)
    """A palpate.runs.live.Frame has been shown."""
    ended = Signal(object)
    """The LoopReport of a run that ended by itself: a script's end, an alarm, a fault."""

    def __init__(
        self,
        view: View,
        scene: palpate.Scene,
        devices: Sequence[palpate.HapticDevice],
        record: Path,
        duration: float = 0.0,
        parent: QObject | None = None,
    ):
        """`devices` are one for each instrument; `duration` [s] ends the run, 0 for never."""
        super().__init__(parent)
        self.view, self.scene, self.record = view, scene, record
        self.device = devices[0]
        options = palpate.LoopOptions()
        options.duration, options.measures_costs = duration, True
        driven = list(devices) if len(devices) > 1 else self.device
        self.run = LiveRun(scene, driven, record=record, options=options)
        self.report: palpate.LoopReport | None = None
        self.problem: OSError | None = None
        """Why the record is not whole."""
        # the inner face of a wall, which is not shown, stands behind the outer one
        shown = int(np.max(scene.bodies[0].tissue.triangles)) + 1
        self._rest = palpate.compute_surface(
            scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position
        )[:shown]
        self._top = LEAST_TOP
        self._gauge = StretchGauge(scene)
        diagonal = float(palpate.compute_diagonal(self._rest))
        view.force_scale = ARROW * diagonal
        self._most = LONGEST / ARROW
        self._timer = QTimer(self, interval=FRAME)
        self._timer.timeout.connect(self._poll)

    def start(self) -> None:
        self.run.start()
        self.view.show_selection(None)
        self._timer.start()

    @property
    def paused(self) -> bool:
        return bool(self.run.paused)

    def pause(self) -> None:
        self.run.pause()

    def resume(self) -> None:
        self.run.resume()

    def finish(self) -> palpate.LoopReport:
        """Stops the loop and its recorder; what is left stands in the record."""
        self._timer.stop()
        if self.report is None:
            try:
                self.report = self.run.finish()
            except OSError as problem:  # a full disk: the run itself was good
                self.problem, self.report = problem, self.run.report()
        return self.report

    def clear_view(self) -> None:
        """The organ at rest again, without tool and arrow."""
        self.view.move_surface(self._rest)
        self.view.show_torn(None)
        self.view.show_values(None)
        self.view.show_instruments(())
        self.view.show_force(None)
        self.view.hud.show_rows(())

    def _poll(self) -> None:
        frame = None if self.view.is_busy() else self.run.take_frame()
        if frame is not None:
            self._show(frame)
            self.framed.emit(frame)
        # after an alarm or a fault the loop goes on with no force until it is stopped
        if not self.run.running or describe_end(self.run.report()) is not None:
            self.ended.emit(self.finish())

    def _show(self, frame: Frame) -> None:
        position = np.asarray(frame.positions[0])[: len(self._rest)]
        moved = np.linalg.norm(position - self._rest, axis=1)
        self._top = max(self._top, round_up(float(moved.max(initial=0.0))))
        self.view.move_surface(position)
        self.view.show_torn(join_torn(frame.torn[:1], frame.positions[:1]))
        self.view.show_values(1e3 * moved, tr("displacement [mm]"), (0.0, 1e3 * self._top))
        self.view.show_instruments(see_instruments(self.scene, frame))
        size = float(np.linalg.norm(frame.force))
        self._show_force(frame, size)
        share = frame.cost * self.scene.rate
        pinches = find_pinches(frame, gauge=self._gauge)
        several = len(frame.instruments) > 1
        rows = [
            *name_forces(frame, pinches),
            (tr("Time"), say_digits(f"{frame.time:.1f} s")),
            (tr("Tick"), f"{100 * share:.0f} %"),
        ]
        if (held := name_safeguard(max(frame.safeguards))) is not None:
            rows.append((tr("Safeguard"), held))
        self.view.hud.show_rows(rows, list_wrong(pinches, *name_rows(several)))

    def _show_force(self, frame: Frame, size: float) -> None:
        """The arrow begins at the tip's skin, not inside it, and stays in sight."""
        if size < SMALLEST_FORCE:
            self.view.show_force(None)
            return
        away = frame.force / size
        self.view.show_force(
            frame.tool_position + away * self.scene.instruments[0].tool.radius,
            away * min(size, self._most),
        )


def name_forces(frame: Frame, pinches: Mapping[int, Pinch]) -> list[tuple[str, str]]:
    """The force on the hand of each instrument, how hard its jaws press, and whether tissue keeps
    it from turning as its hand does."""
    several = len(frame.instruments) > 1
    rows, names = [], name_rows(several)
    for index, one in enumerate(frame.instruments):
        name = fill(tr("Force {number}"), number=index + 1) if several else tr("Force")
        rows.append((name, say_digits(f"{float(np.linalg.norm(one.force)):.2f} N")))
        rows += [(row, say_digits(told)) for row, told in tell_rows(index, pinches, *names)]
        if one.turn_limited:
            turns = fill(tr("Turning {number}"), number=index + 1) if several else tr("Turning")
            rows.append((turns, tr("held by tissue")))
    return rows


def name_jaws(index: int, several: bool) -> str:
    """Of which instrument they are, where there are several."""
    return fill(tr("Jaws {number}"), number=index + 1) if several else tr("Jaws")


def name_stretch(index: int, several: bool) -> str:
    """Of what the jaws of which instrument hold."""
    return fill(tr("Stretch {number}"), number=index + 1) if several else tr("Stretch")


def name_rows(several: bool) -> tuple[Callable[[int], str], Callable[[int], str]]:
    """What names the rows of an instrument's jaws, and of what is about them."""
    return partial(name_jaws, several=several), partial(name_stretch, several=several)


def name_safeguard(safeguard: palpate.Safeguard) -> str | None:
    """What holds the organ together where it would blow up; None where nothing has to."""
    return {
        palpate.Safeguard.half_steps: tr("half steps"),
        palpate.Safeguard.quarter_steps: tr("quarter steps"),
        palpate.Safeguard.implicit_damping: tr("implicit damping"),
        palpate.Safeguard.implicit_euler: tr("implicit Euler"),
    }.get(safeguard)


def say_short(value: float) -> str:
    """Three digits that count."""
    return number(value, 3)


def round_up(value: float) -> float:
    """The smallest of 1, 2 or 5 times a power of ten that is not less."""
    if not value > 0.0 or not np.isfinite(value):
        return LEAST_TOP
    power = 10.0 ** np.floor(np.log10(value))
    return float(next(top * power for top in TOPS if top * power >= value * (1 - 1e-9)))


def name_field(key: str) -> str:
    """Where in the window a constant or a law is set: its stage and the label of its field."""
    part, field = key.split(".")
    constant = find_constant(part, field)
    label = LAW_NAMES[field] if constant is None else constant.label
    return f"{MaterialPanel.title()} \N{SINGLE RIGHT-POINTING ANGLE QUOTATION MARK} {say(label)}"


def describe_end(report: palpate.LoopReport) -> str | None:
    """Why a run did not end well, in a sentence; None where it did."""
    if report.alarm.kind != palpate.AlarmKind.none:
        return fill(
            tr("The run was stopped after {time:.2f} s: {what}."),
            time=report.alarm.time,
            what=say_alarm(report.alarm, QCoreApplication.translate, say_short),
        )
    if report.fault != palpate.DeviceFault.none:
        return tr("The device failed ({what}): the run was stopped.").format(
            what=report.fault.name.replace("_", " ")
        )
    return None


def describe_averted(report: palpate.LoopReport) -> str | None:
    """What would have ended a run that safeguards held together; None where none was needed."""
    if report.averted.kind == palpate.AlarmKind.none:
        return None
    return fill(
        tr(
            "The run would have been stopped after {time:.2f} s: {what}. Shorter or implicit "
            "steps held the organ together."
        ),
        time=report.averted.time,
        what=say_alarm(report.averted, QCoreApplication.translate, say_short),
    )


def advise(report: palpate.LoopReport, cause: Cause | None, element: Element | None = None) -> str:
    """Why a run ended in an alarm, or would have, where, and what to change in the organ."""
    ended = report.alarm.kind != palpate.AlarmKind.none
    alarm = report.alarm if ended else report.averted
    advice = advise_design(alarm, cause, QCoreApplication.translate, name_field, say_short)
    told = describe_end(report) if ended else describe_averted(report)
    where = say_element(element, QCoreApplication.translate, say_short)
    return " ".join(filter(None, [told, where, advice]))
