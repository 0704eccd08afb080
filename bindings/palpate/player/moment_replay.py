# SPDX-License-Identifier: BSD-3-Clause
"""Shows a moment of the last run once more, as it was seen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from palpate.player.moments import Moment

if TYPE_CHECKING:
    from palpate.player.host import Host

SHOT_MS = 33
"""[ms] between two pictures"""


class MomentReplay(QObject):
    """From the debrief, and back to it at the moment's end or with Esc."""

    def __init__(self, window: Host, parent: QObject):
        super().__init__(parent)
        self.window = window
        self._moment: Moment | None = None
        self._at = 0
        self._timer = QTimer(self, interval=SHOT_MS)
        self._timer.timeout.connect(self._show)

    @property
    def busy(self) -> bool:
        return self._moment is not None

    def show(self, moment: Moment) -> None:
        self._moment, self._at = moment, 0
        self.window.show_board(None)
        self._timer.start()

    def stop(self) -> None:
        """Back to the debrief; nothing where none is shown."""
        if self.busy:
            self.close()
            self.window.view.show_force(None)
            self.window.show_board(self.window.over.debrief)

    def close(self) -> None:
        self._timer.stop()
        self._moment = None

    def _show(self) -> None:
        moment, view = self._moment, self.window.view
        if moment is None or self._at >= len(moment.shots):
            self.stop()
            return
        shot = moment.shots[self._at]
        view.move_surface(shot.surface)
        view.show_torn(shot.torn)
        view.move_rigid(shot.rigid)
        view.show_instruments(shot.instruments)
        view.show_force(shot.tip, shot.force)
        self.window.over.clock.show_time(shot.time)
        self._at += 1
