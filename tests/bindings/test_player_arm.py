# SPDX-License-Identifier: BSD-3-Clause
"""The trainee's window with the mouse as the hand at the simulated arm."""

from __future__ import annotations

import palpate
from palpate.player.trainee_window import Phase
from palpate.runs.play import open_play
from published import publish
from trainees import press_and_wait


def test_the_mouse_presses_through_the_simulated_arm_up_to_its_own_limit(
    open_window, qtbot, tmp_path
):
    window = open_window(open_play(publish(tmp_path), "plant"))
    window.restart()

    press_and_wait(window, qtbot)

    motors = palpate.find_safety_limits(palpate.find_calibration(palpate.Plant()))
    assert window.over.force.limit == motors.force_max < palpate.SafetyLimits().force_max
    assert 0.0 < window.over.force.peak < motors.force_max
    assert window.phase is Phase.running  # the organ was not torn by a tool that came out of it
