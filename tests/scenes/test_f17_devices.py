# SPDX-License-Identifier: BSD-3-Clause
"""F17: a device that is unplugged, stalls or gives what is no number, in the middle of a press."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import NONE, TICK, open_springs
from palpate.runs.press import PressScript, find_top, write_script

WATCHDOG = 5e-3
"""[s] after which the firmware cuts a silent host's torque; no force may be sent for longer."""
AT = 0.4
"""[s] of the fault: the hand is deep in the tissue then."""


def press(faults: palpate.Faults, stall: float = 0.0):
    """What was sent [N] tick by tick (n, 3), the device and the world after a press."""
    scene = open_springs("spleen")
    frames, times = write_script(
        find_top(scene), scene.instruments[0].tool.radius, PressScript(5e-3, hold=0.3)
    )
    faulty = palpate.FaultyDevice(palpate.ScriptedDevice(frames), faults)
    device, world, sent = palpate.SafeDevice(faulty), palpate.World(scene), []
    for k in range(round(times.held / TICK)):
        late = stall if k * TICK >= AT else 0.0
        sample = device.read(k * TICK + late)
        device.write(palpate.tick(scene, sample, TICK, world))
        sent.append(np.array(device.sent().force))
    return np.array(sent), device, world


def test_f17_without_a_fault_the_hand_feels_its_press():
    sent, device, world = press(palpate.Faults())

    assert device.fault() == palpate.DeviceFault.none and world.alarm.kind == NONE
    assert np.linalg.norm(sent[round(AT / TICK)]) > 0.05


@pytest.mark.parametrize(
    ("faults", "fault"),
    [
        (palpate.Faults(unplug_at=AT), palpate.DeviceFault.device_failed),
        (palpate.Faults(cut_at=AT), palpate.DeviceFault.none),  # the loop tells of it
        (palpate.Faults(corrupt=0.05, seed=4), palpate.DeviceFault.sample_not_finite),
    ],
)
def test_f17_a_device_that_fails_is_sent_nothing_from_the_next_tick_on(faults, fault):
    sent, device, world = press(faults)

    assert device.fault() == fault
    felt = np.flatnonzero(np.linalg.norm(sent, axis=1))
    assert not len(felt) or felt[-1] * TICK <= AT + WATCHDOG
    assert np.isfinite(sent).all()
    # the tissue goes on as the last good hand left it
    assert world.alarm.kind == NONE


def test_f17_a_stall_of_20_ms_is_no_fault_and_no_knock():
    sent, device, world = press(palpate.Faults(), stall=0.02)

    assert device.fault() == palpate.DeviceFault.none and world.alarm.kind == NONE
    jumps = np.linalg.norm(np.diff(sent, axis=0), axis=1)
    assert jumps.max() < 0.5 * np.linalg.norm(sent, axis=1).max()
