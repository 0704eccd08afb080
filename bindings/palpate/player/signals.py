# SPDX-License-Identifier: BSD-3-Clause
"""What is heard while a task is played, and the same in words: no sound is without its caption."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtWidgets import QApplication, QFrame, QWidget

import palpate
from palpate.player.overlays import Overlays
from palpate.player.sentences import translate

CAPTION_MS = 1500
"""[ms] for which a caption can be read"""
NOTE = "\N{BEAMED EIGHTH NOTES}"


class Glow(QFrame):
    """The edge of the window, in the colour of what went wrong."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.setObjectName("glow")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def show_over(self, view: QWidget) -> None:
        self.setGeometry(view.rect())
        self.raise_()
        self.show()


class Signals(QObject):
    """Compares the state of a task with that of the frame before. The sound is the system's own
    short one.
    """

    def __init__(self, over: Overlays, view: QWidget, parent: QObject):
        super().__init__(parent)
        self.over, self.view = over, view
        self.audible = True
        self.heard: list[str] = []
        """Captions since the run began."""
        self.glow = Glow(view)
        self._before: palpate.TaskState | None = None
        self._timer = QTimer(self, singleShot=True, interval=CAPTION_MS)
        self._timer.timeout.connect(self.fade)

    def reset(self) -> None:
        """Before a run."""
        self._before, self.heard = None, []
        self.fade()

    def take(self, state: palpate.TaskState, limits: Sequence[str]) -> None:
        """`limits` is what each limit of the task says."""
        before, self._before = self._before, state
        if before is None:
            return
        passed = [
            number
            for number, (now, then) in enumerate(zip(state.limits, before.limits, strict=True))
            if now.count > then.count
        ]
        if passed:
            self._signal(limits[passed[0]], wrong=True)
            return
        done = palpate.StepStatus.done
        if any(
            now.status is done and then.status is not done
            for now, then in zip(state.steps, before.steps, strict=True)
        ):
            self._signal(translate("Player", "Step done"), wrong=False)

    def _signal(self, words: str, wrong: bool) -> None:
        if self.audible:
            QApplication.beep()
        caption = f"{NOTE} {words}"
        self.heard.append(caption)
        self.over.caption.tell(caption)
        self.over.place()
        if wrong:
            self.glow.show_over(self.view)
        self._timer.start()

    def fade(self) -> None:
        """Nothing is to be seen of it any more."""
        self._timer.stop()
        self.glow.hide()
        if self.over.caption.sentence:
            self.over.caption.tell("")
            self.over.place()
