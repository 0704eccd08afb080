# SPDX-License-Identifier: BSD-3-Clause
"""The trainee's side: a published scenario in a window. Never loads authoring or editor code."""

from palpate.player.start import play_in_window
from palpate.player.trainee_window import TraineeWindow

__all__ = ["TraineeWindow", "play_in_window"]
