# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the chart of the open organ and advises, in a process of its own (chart_process)."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from palpate.study.advice import Targets
from palpate.study.scene_chart import Chart, Configuration
from palpate.system.isolated import build_command
from PySide6.QtCore import QObject, Signal

from palpate_editor.chart_fit import find_difference
from palpate_editor.chart_messages import Done, Refused, Request, Shown, Told
from palpate_editor.document import Organ
from palpate_editor.views.context import Context
from palpate_editor.views.jobs import Cancelled, Job, Progress
from palpate_editor.views.translations import tr

SPARE = 1
"""Processors that are left to the window and whatever else runs."""


class ChartRefused(ValueError):
    """What the process said in the end, in a sentence."""


class ChartWork:
    """Asks the process, and hands on what it says."""

    def __init__(self, organ: Organ, request: Request, show: Callable[[Chart], None]):
        """`request` has no organ yet: packing a large one takes a while."""
        self.organ, self.request, self.show = organ, request, show
        self.process: subprocess.Popen[bytes] | None = None
        self.lock = threading.Lock()
        self.stopped = False

    def __call__(self, progress: Progress) -> Done:
        from palpate_editor.chart_jobs import pack_document  # it loads SciPy

        progress(tr("It begins"), 0.0)
        request = replace(self.request, organ=pack_document(self.organ))
        self.begin()
        assert self.process is not None and self.process.stdin and self.process.stdout
        try:
            with self.process.stdin as asked:
                pickle.dump(request, asked)
            while True:
                said = pickle.load(self.process.stdout)
                if isinstance(said, Told):
                    progress(say_stage(said.stage), said.share)
                elif isinstance(said, Shown):
                    self.show(said.chart)
                elif isinstance(said, Refused):
                    raise ChartRefused(said.sentence)
                else:
                    assert isinstance(said, Done)
                    return said
        except (EOFError, OSError, pickle.UnpicklingError):
            raise self.find_end() from None
        finally:
            self.stop()

    def begin(self) -> None:
        """Raises Cancelled where it is wanted no longer."""
        with self.lock:
            if self.stopped:
                raise Cancelled
            self.process = subprocess.Popen(
                build_command("-m", "palpate_editor.chart_process"),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                start_new_session=True,  # a group of its own, with those that it starts
            )

    def find_end(self) -> Exception:
        """Of a process that said nothing more: it was ended here, or by something else."""
        if self.stopped:
            return Cancelled()
        assert self.process is not None
        code = self.process.wait()
        return ChartRefused(
            tr("The process that draws the chart ended with code {code}.").format(code=code)
        )

    def stop(self) -> None:
        """Ends the process and those that it started, whatever they are at; from any thread. What
        was finished is kept."""
        with self.lock:
            self.stopped = True
            if self.process is not None:
                with suppress(ProcessLookupError):
                    os.killpg(self.process.pid, signal.SIGKILL)
                self.process.wait()


def say_stage(stage: str) -> str:
    """What the process is doing."""
    stages = {
        "mesh": tr("The truth: its mesh"),
        "stiffness": tr("The truth: its stiffness"),
        "factor": tr("The truth: factors"),
        "response": tr("The truth: responses"),
        "converged": tr("Models converged in time"),
        "rows": tr("Configurations run"),
        "costs": tr("Configurations are timed"),
        "choosing": tr("Choosing"),
    }
    if stage in stages:
        return stages[stage]
    return tr("Presses held out from the choice")


class Advisor(QObject):
    """One chart or advice at a time."""

    drawn = Signal(object)
    """A Chart: of what is finished so far, or whole."""
    advised = Signal(object)
    """An Advised of the chart that was drawn last."""
    progressed = Signal(str, float)
    began = Signal()
    ended = Signal()
    """Done, refused or cancelled."""

    def __init__(self, context: Context, parent: QObject | None = None):
        super().__init__(parent)
        self.context = context
        self.chart: Chart | None = None
        """The one that is shown, whole or not."""
        self.work: ChartWork | None = None
        self.job: Job | None = None
        self.cache: Path | None = None
        """The folder of what is kept; the user's own if None."""
        self.configurations: tuple[Configuration, ...] | None = None
        """To try, the organ's own first; all that there are if None."""

    @property
    def is_busy(self) -> bool:
        return self.job is not None

    def use_chart(self, chart: Chart | None) -> None:
        """One that was opened."""
        self.chart = chart

    def draw(self) -> None:
        """The chart of the open organ; what is kept of it is taken."""
        self.begin(tr("Drawing the chart"), None, None)

    def advise(self, targets: Targets) -> None:
        """From the chart that is shown, where it is whole and of this organ; else from its own."""
        organ, chart = self.context.session.organ, self.chart
        fits = chart is not None and chart.complete and find_difference(chart, organ) is None
        self.begin(tr("Advising"), targets, chart if fits else None)

    def begin(self, title: str, targets: Targets | None, chart: Chart | None) -> None:
        organ = self.context.session.organ
        if self.is_busy:
            return
        if organ.surface is None:
            self.context.tell(tr("There is no organ yet: import a mesh first."))
            return
        workers = max(1, (os.cpu_count() or 1) - SPARE)
        request = Request(
            organ=b"",
            file=str(self.context.document()),
            workers=workers,
            chart=chart,
            targets=targets,
            configurations=self.configurations,
            cache=self.cache,
        )
        self.work = ChartWork(organ, request, self.drawn.emit)
        self.job = self.context.jobs.start_unseen(
            title, self.work, self.on_done, self.context.refuse
        )
        if self.job is not None:
            self.job.progressed.connect(self.progressed)
            self.job.ended.connect(self.on_ended)
            self.began.emit()

    def cancel(self) -> None:
        """At once; the next one goes on from what is finished."""
        if self.job is not None and self.work is not None:
            self.job.cancel()
            self.work.stop()

    def on_done(self, done: Done) -> None:
        self.chart = done.chart
        self.drawn.emit(done.chart)
        if done.advised is not None:
            self.advised.emit(done.advised)

    def on_ended(self, job: Job) -> None:
        if job is self.job:
            self.job = self.work = None
            self.ended.emit()
