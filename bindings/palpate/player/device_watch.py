# SPDX-License-Identifier: BSD-3-Clause
"""Whether the device gives the force that a run asks it for."""

from __future__ import annotations

import palpate
from palpate.player.device_sentences import say_advice, say_fault, say_state
from palpate.player.sentences import say_fault as say_end_of_device
from palpate.player.sentences import translate
from palpate.runs.play import find_driver

PATIENCE = 12
"""Frames that anything but a fault has to last before it is told of."""


class DeviceWatch:
    """Looks at the device of a run, once a frame. Nobody could tell motors that are off from an
    organ without stiffness.
    """

    def __init__(self, device: palpate.HapticDevice | None = None):
        self.driver = None if device is None else find_driver(device)
        """None for a device without motors."""
        self._frames = 0

    def say(self, fault: palpate.DeviceFault = palpate.DeviceFault.none) -> str:
        """Why no force can be felt, and what to do; empty where one can, or will at once.

        `fault` is that of the run, which rests while there is one.
        """
        if fault not in (palpate.DeviceFault.none, palpate.DeviceFault.motors_cut):
            return say_end_of_device(fault)
        if self.driver is None:
            return say_end_of_device(fault) if fault is palpate.DeviceFault.motors_cut else ""
        self.driver.take_status()
        status = self.driver.status()
        if status.link is palpate.LinkState.ready and status.mode is palpate.DeviceMode.faulted:
            text = translate(
                "Player", "Paused: no force from the device. %1. %2 C clears the fault."
            )
            text = text.replace("%1", say_fault(status.first_fault))
            return text.replace("%2", say_advice(status))
        if fault is palpate.DeviceFault.motors_cut:
            text = translate("Player", "Paused: no force from the device. %1. %2")
            text = text.replace("%1", say_state(status)[0])
            return text.replace("%2", say_advice(status))
        gives = status.mode in (palpate.DeviceMode.run, palpate.DeviceMode.ramp)
        if gives and not status.degraded and status.link is palpate.LinkState.ready:
            self._frames = 0
            return ""
        self._frames += 1
        if self._frames < PATIENCE:
            return ""
        return f"{say_state(status)[0]}. {say_advice(status)}"

    def clear_fault(self) -> None:
        """The motors come on again, slowly, where what cut them is gone."""
        if self.driver is not None:
            self.driver.clear_fault()
