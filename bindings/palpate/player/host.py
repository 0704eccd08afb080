# SPDX-License-Identifier: BSD-3-Clause
"""The trainee's window, as its helpers know it."""

from __future__ import annotations

from typing import Protocol

import palpate
from palpate.player.boards import Board
from palpate.player.device_button import DeviceButton
from palpate.player.overlays import Overlays
from palpate.player.place_marks import PlaceMarks
from palpate.runs.play import Play
from palpate.viewport import View


class Host(Protocol):
    """What it needs of the window."""

    play: Play
    over: Overlays
    view: View
    marks: PlaceMarks
    scene: palpate.Scene
    language: str
    theme: str
    button: DeviceButton

    def show_board(self, board: Board | None) -> None: ...
    def use_language(self, code: str) -> None: ...
    def restart(self) -> None: ...
    def play_another(self) -> None: ...
    def close(self) -> bool: ...
