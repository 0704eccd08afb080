# SPDX-License-Identifier: BSD-3-Clause
"""What every window says of a device: its state, its faults, and what to do about them."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

import palpate
from palpate.device.report import NO_FAULT

translate = QCoreApplication.translate


def say_state(status: palpate.DeviceStatus) -> tuple[str, str]:
    """The state in a word or two, and its tone: good, warm, bad or plain."""
    if status.link is palpate.LinkState.lost:
        return translate("Device", "Gone"), "bad"
    if status.link is palpate.LinkState.uncalibrated:
        if status.blank:
            return translate("Device", "Blank board"), "warm"
        if status.damaged:
            return translate("Device", "Calibration damaged"), "bad"
        return translate("Device", "Not calibrated"), "warm"
    if status.link is not palpate.LinkState.ready:
        return translate("Device", "Greeting"), "plain"
    if status.mode is palpate.DeviceMode.faulted:
        return say_fault(status.first_fault), "bad"
    if status.degraded:
        return translate("Device", "Reports are missing"), "warm"
    return {
        palpate.DeviceMode.run: (translate("Device", "Motors on"), "good"),
        palpate.DeviceMode.ramp: (translate("Device", "Motors coming on"), "good"),
    }.get(status.mode, (translate("Device", "Motors off"), "plain"))


def say_advice(status: palpate.DeviceStatus) -> str:
    """What it means, and what to do."""
    if status.link is palpate.LinkState.lost:
        return translate(
            "Device", "Its cable is out, or it has fallen silent. Plug it in and connect again."
        )
    if status.link is palpate.LinkState.uncalibrated and status.blank:
        return translate(
            "Device",
            "No calibration was ever stored in it: calibrate it. Its motors stay off until then.",
        )
    if status.link is palpate.LinkState.uncalibrated and status.damaged:
        return translate(
            "Device",
            "The newest copy of its calibration in its EEPROM is damaged, and an older one is not "
            "obeyed: calibrate it. Its motors stay off until then.",
        )
    if status.link is palpate.LinkState.uncalibrated:
        return translate(
            "Device",
            "Its sensors are read, but mean nothing without a calibration: calibrate it. Its "
            "motors stay off until then.",
        )
    if status.link is not palpate.LinkState.ready:
        return translate("Device", "The device is being identified.")
    if status.mode is palpate.DeviceMode.faulted:
        return say_remedy(status.first_fault)
    if status.degraded:
        return translate("Device", "The force is taken back until reports come again.")
    if status.mode in (palpate.DeviceMode.run, palpate.DeviceMode.ramp):
        return translate("Device", "It carries its own arm. Hold the stylus.")
    return translate("Device", "Its joints are read; nothing can push.")


def say_fault(fault: int) -> str:
    """What cut the motors, in words."""
    return {
        0: translate("Device", "Host silent"),
        1: translate("Device", "Emergency stop pressed"),
        2: translate("Device", "Motor driver fault"),
        3: translate("Device", "Sensor fault"),
        4: translate("Device", "Moved too fast"),
        5: translate("Device", "Motor too hot"),
        6: translate("Device", "Firmware overrun"),
        7: translate("Device", "Reset by its watchdog"),
        8: translate("Device", "Bytes lost"),
        9: translate("Device", "Damaged frame"),
        10: translate("Device", "Calibration damaged"),
        11: translate("Device", "Message refused"),
        NO_FAULT: translate("Device", "No fault"),
    }.get(fault, translate("Device", "Unknown fault"))


def say_remedy(fault: int) -> str:
    """What to do about it."""
    return {
        0: translate(
            "Device",
            "This computer did not speak to it for 20 ms, so it cut its motors. Clear the fault; "
            "if it comes again, close what keeps the computer busy.",
        ),
        1: translate("Device", "Release the stop button, then clear the fault."),
        2: translate(
            "Device", "Check the motor drivers, their supply and its fuse, then clear the fault."
        ),
        3: translate(
            "Device",
            "A sensor reads the end of its scale: a wire is off or shorted. Repair it, then "
            "clear the fault.",
        ),
        4: translate("Device", "The arm moved too fast. Hold the stylus, then clear the fault."),
        5: translate("Device", "Let the motors cool for a minute, then clear the fault."),
        7: translate(
            "Device", "Its program hung and was restarted. Clear the fault; if it comes again, "
            "flash it again."
        ),
        10: translate("Device", "Its stored data cannot be read: calibrate it."),
    }.get(fault, translate("Device", "Clear the fault to go on."))  # fmt: skip
