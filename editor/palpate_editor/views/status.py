# SPDX-License-Identifier: GPL-3.0-or-later
"""The status bar: what the tool does, what is under the pointer, how fast, how much, how safe."""

from __future__ import annotations

from datetime import datetime

from palpate.translation.numbers import say_digits
from PySide6.QtCore import QElapsedTimer, QPointF, QTimer
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QPushButton, QStatusBar, QWidget

from palpate_editor.document import Organ
from palpate_editor.views.context import Context
from palpate_editor.views.elided_label import ElidedLabel
from palpate_editor.views.jobs import Job
from palpate_editor.views.translations import count, tr

SOON = 500
"""[ms] work that is done by then shows no progress."""
PICK_EVERY = 40
"""[ms] between two checks of what is under the pointer."""
SECOND = 1000
STILL = 5.0
"""[1/s] fewer frames than that are a picture being refined, not a motion."""


class Busy(QWidget):
    """Progress and cancel of the work under way."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        row = QHBoxLayout(self)
        row.setContentsMargins(4, 0, 4, 0)
        row.setSpacing(8)
        self.label, self.bar = ElidedLabel(self), QProgressBar(self)
        self.bar.setFixedWidth(150)
        self.bar.setRange(0, 100)
        self.bar.setTextVisible(False)
        self.button = QPushButton(tr("Cancel"), self)
        self.button.setObjectName("cancel_job")
        self.button.setProperty("small", True)
        self.button.clicked.connect(self.cancel)
        row.addWidget(self.label)
        row.addWidget(self.bar)
        row.addWidget(self.button)
        self.timer = QTimer(self, singleShot=True, interval=SOON)
        self.timer.timeout.connect(self.show)
        context.jobs.started.connect(self.begin)
        context.jobs.stopped.connect(self.end)
        self.hide()

    def begin(self, job: Job) -> None:
        self.label.setText(job.title)
        self.bar.setValue(0)
        job.progressed.connect(self.tell)
        self.timer.start()

    def tell(self, text: str, share: float) -> None:
        self.label.setText(text)
        self.bar.setValue(round(100 * share))

    def end(self, job: Job) -> None:
        del job
        self.timer.stop()
        self.hide()

    def cancel(self) -> None:
        job = self.context.jobs.current
        self.context.jobs.cancel()
        if job is not None:
            self.context.tell(
                tr("{work}: cancelled, nothing has changed.").format(work=job.title), "info"
            )


class Status(QStatusBar):
    """Fills the bar under the window."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.setSizeGripEnabled(False)
        self.hint = ElidedLabel(self)
        self.hint.setObjectName("hint")
        self.hint.setMinimumWidth(80)
        self.addWidget(self.hint, 1)
        self.busy = Busy(context, self)
        self.addPermanentWidget(self.busy)
        self.place, self.counts, self.rate = (ElidedLabel(self) for _ in range(3))
        self.unit, self.saved = QLabel("mm", self), ElidedLabel(self)
        self.unit.setToolTip(tr("Lengths are shown in millimetres"))
        for label in (self.place, self.counts, self.rate, self.unit, self.saved):
            self.addPermanentWidget(label)
        self.frames, self.clock = 0, QElapsedTimer()
        self.clock.start()
        self.pointer: QPointF | None = None
        self.picker = QTimer(self, singleShot=True, interval=PICK_EVERY)
        self.picker.timeout.connect(self.pick)
        self.second = QTimer(self, interval=SECOND)
        self.second.timeout.connect(self.show_rate)
        self.second.start()
        context.hinted.connect(self.hint.setText)
        context.view.hover.connect(self.on_hover)
        context.view.frame_drawn.connect(self.on_frame)
        context.session.changed.connect(self.on_changed)
        self.show_counts(context.session.organ)

    def on_changed(self, before: Organ, after: Organ) -> None:
        del before
        self.show_counts(after)

    def show_counts(self, organ: Organ) -> None:
        if organ.surface is None:
            self.counts.setText("")
            self.place.setText("")
            return
        self.counts.setText(
            tr("{vertices} vertices · {triangles} triangles").format(
                vertices=count(organ.vertex_count), triangles=count(len(organ.surface.triangles))
            )
        )

    def on_hover(self, point: QPointF) -> None:
        self.pointer = point
        if not self.picker.isActive():
            self.picker.start()

    def pick(self) -> None:
        """What is under the pointer now."""
        if self.pointer is None or self.context.session.organ.surface is None:
            return
        found = self.context.view.pick(self.pointer)
        if found is None:
            self.place.setText("")
            return
        x, y, z = (say_digits(f"{1e3 * value:.1f}").replace("-", "−") for value in found.point)
        self.place.setText(
            tr("triangle {number}   x {x}  y {y}  z {z} mm").format(
                number=found.triangle, x=x, y=y, z=z
            )
        )

    def on_frame(self) -> None:
        self.frames += 1

    def show_rate(self) -> None:
        """Frames of the last second; nothing is drawn where nothing moves."""
        elapsed = self.clock.restart()
        rate = self.frames * 1000.0 / max(1, elapsed)
        self.rate.setText(
            tr("{rate} fps").format(rate=f"{rate:.0f}") if rate >= STILL else tr("idle")
        )
        self.frames = 0

    def show_autosaved(self, when: datetime) -> None:
        self.saved.setText(tr("autosaved {time}").format(time=f"{when:%H:%M}"))
