# SPDX-License-Identifier: BSD-3-Clause
"""Devices by name: what there is, and the link to one of them."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.verb import Report, WrongCall

PLANT = "plant"
SERIAL = "serial:"
TICK = 1e-3
"""[s]"""
NAMES = f"{PLANT} or {SERIAL}PATH"


@dataclass
class Link:
    """A driver and what it drives, run tick by tick without a tissue."""

    name: str
    driver: palpate.SerialDevice
    transport: palpate.Transport
    core: palpate.NativeCore | None = None
    """Of a device that is simulated, whose time passes as fast as the machine can."""
    note: str = ""
    """What was done about latency."""
    time: float = 0.0
    """[s] of the run."""
    sample: palpate.HapticSample = field(default_factory=palpate.HapticSample)

    def open(self) -> None:
        """Raises DeviceError in words."""
        self.driver.open()
        self.time = 0.0

    def run(
        self,
        seconds: float,
        force: ArrayLike = (0.0, 0.0, 0.0),
        each: Callable[[palpate.HapticSample], None] | None = None,
    ) -> palpate.DeviceStatus:
        """Ticks with a force [N]; `each` sees every sample. Returns the newest status."""
        command = palpate.HapticCommand(np.asarray(force, dtype=float))
        begun = time.monotonic() - self.time
        for _ in range(max(1, round(seconds / TICK))):
            self.sample = self.driver.read(self.time)
            self.driver.write(command)
            if each is not None:
                each(self.sample)
            self.time += TICK
            if self.core is None:
                time.sleep(max(0.0, begun + self.time - time.monotonic()))
        return self.status()

    def wait_for(self, mode: palpate.DeviceMode, seconds: float) -> bool:
        """Ticks without force until the device is in a mode; False where it does not get there."""
        return any(self.run(0.01).mode == mode for _ in range(max(1, round(seconds / 0.01))))

    def status(self) -> palpate.DeviceStatus:
        self.driver.take_status()
        return self.driver.status()

    def hold(self, position: ArrayLike) -> None:
        """Puts a simulated hand on the stylus of a simulated device, at a place of the arm [m]."""
        if self.core is not None:
            self.core.hold(palpate.HandTarget(np.asarray(position, dtype=float), holding=True))


def build_link(name: str, origin: ArrayLike | None = None) -> Link:
    """A link that is not yet open; `origin` [m] of the scene is the middle of the workspace, and
    without it the scene's frame is the arm's. Raises WrongCall or DeviceError.
    """
    place = np.asarray(palpate.Workspace().center if origin is None else origin, dtype=float)
    if name == PLANT:
        core = palpate.NativeCore()
        return Link(name, palpate.SerialDevice(core, place), core, core, "in this process")
    if name.startswith(SERIAL):
        port = palpate.SerialTransport(name.removeprefix(SERIAL))
        driver = palpate.SerialDevice(port, place)
        return Link(name, driver, port, note=port.latency_note())
    raise WrongCall(f"device: got {name!r}, expected {NAMES}")


def list_devices() -> list[Report]:
    """The serial ports of this machine that could be a device, and the one that always is there."""
    ports = [
        {
            "device": f"{SERIAL}{port.path}",
            "product": port.product or port.driver,
            "permitted": port.permitted,
            "latency_timer_ms": port.latency_timer if port.latency_timer >= 0 else None,
        }
        for port in palpate.find_serial_ports()
    ]
    simulated = {
        "device": PLANT,
        "product": "simulated arm with the real firmware",
        "permitted": True,
        "latency_timer_ms": None,
    }
    return [*ports, simulated]


def describe_low_latency() -> tuple[bool, str]:
    """Whether every serial adapter hands on bytes at once, and a sentence about it."""
    ports = palpate.find_serial_ports()
    if not ports:
        return True, "no USB serial adapter is plugged in"
    words, good = [], True
    for port in ports:
        late = port.latency_timer > 1
        good = good and port.permitted and not late
        told = f"{port.path} ({port.product or port.driver})"
        if not port.permitted:
            told += ": not permitted; add this user to the group of the file"
        elif late:
            told += (
                f": keeps bytes back for {port.latency_timer} ms; a udev rule with "
                'ATTR{latency_timer}="1" ends that'
            )
        words.append(told)
    return good, "; ".join(words)


def to_list(values: NDArray[np.float64]) -> list[float]:
    return [float(value) for value in values]
