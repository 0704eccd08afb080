# SPDX-License-Identifier: BSD-3-Clause
"""Devices by name: what there is, and the link to one of them."""

from __future__ import annotations

import threading

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.command.sentence import Sentence, sentence
from palpate.command.verb import Report
from palpate.device.names import NATIVE, PLANT, find_port, name_port, require_device

PARTING = 0.1
"""[s] in which the motors have to be off before a device is left."""
DRIVING = (palpate.DeviceMode.ramp, palpate.DeviceMode.run)


class Ended(Exception):
    """The link was ended while a thread waited."""


class Link:
    """A driver, what it drives, and the loop that keeps both company without a tissue, all in the
    arm's frame.

    Any thread may ask and order; nothing here holds up the haptic thread.
    """

    def __init__(
        self,
        name: str,
        driver: palpate.SerialDevice,
        arm: palpate.SimulatedArm | None = None,
        hand: palpate.PointerDevice | None = None,
        far_end: object = None,
        note: Sentence | str = "",
    ):
        """`arm` and `hand` are of a simulated device, whose time may pass as fast as the machine
        can; `far_end` is kept alive for as long as the link.
        """
        self.name, self.driver, self.arm, self.note = name, driver, arm, note
        """`note` says what was done about latency; that of a port is a sentence of the core."""
        self._hand, self._far_end = hand, far_end
        self._loop: palpate.DeviceLoop | None = None
        self._lock = threading.Lock()
        self._ending = threading.Event()
        self._over = False

    @property
    def device(self) -> palpate.HapticDevice:
        return self.driver if self.arm is None else self.arm

    def open(self) -> None:
        """Greets the device. Raises DeviceError in words."""
        if self.arm is None:
            self.driver.open()
        else:
            self.arm.open()

    def begin(self, live: bool | None = None) -> None:
        """Greets the device and keeps it company, its motors off. Raises DeviceError in words.

        `live` by the clock, in a thread of its own, as a device in real time needs; otherwise time
        passes only while a thread waits.
        """
        self.open()
        self.driver.enable(False)
        self._over = False
        self._ending.clear()
        self._keep_company(self.arm is None if live is None else live)

    def interrupt(self) -> None:
        """What waits in another thread gets Ended at once, and so does what waits later."""
        self._over = True
        self._ending.set()

    def end(self) -> None:
        """Motors off, then nothing is said any more. May be repeated."""
        self.interrupt()
        self._part()

    def _part(self) -> None:
        with self._lock:
            loop, self._loop = self._loop, None
        if loop is None:
            return
        self.driver.enable(False)
        loop.set_task(palpate.DeviceTask())
        for _ in range(round(PARTING / 0.01)):
            if self.status().mode not in DRIVING or loop.fault() is not palpate.DeviceFault.none:
                break
            if loop.running():
                threading.Event().wait(0.01)
            else:
                loop.run(0.01)
        loop.stop()

    def run(self, seconds: float) -> palpate.DeviceStatus:
        """Lets time pass; the newest status. Raises Ended where the link is ended meanwhile."""
        loop = self._loop
        if loop is None:
            raise Ended
        if not loop.running():
            loop.run(seconds)
        elif self._ending.wait(seconds):
            raise Ended
        return self.status()

    def push(self, force: ArrayLike = (0.0, 0.0, 0.0)) -> None:
        """A force [N] until another is asked for."""
        self._set(palpate.DeviceTask(force=np.asarray(force, dtype=float)))

    def draw(self, stiffness: float, rest: ArrayLike) -> None:
        """A spring [N/m] to a place [m] until something else is asked for."""
        self._set(palpate.DeviceTask(stiffness=stiffness, rest=np.asarray(rest, dtype=float)))

    def fall_silent(self, seconds: float) -> None:
        """As if the host had died for so long [s]."""
        if self._loop is not None:
            self._loop.fall_silent(seconds)

    def wait_for(self, mode: palpate.DeviceMode, seconds: float) -> bool:
        """Until the device is in a mode; False where it does not get there."""
        return any(self.run(0.01).mode == mode for _ in range(max(1, round(seconds / 0.01))))

    def status(self) -> palpate.DeviceStatus:
        """The newest; of at most 8 ms ago while the device is heard."""
        with self._lock:
            self.driver.take_status()
            return self.driver.status()

    def is_lost(self) -> bool:
        """Whether the device is gone for good, or says what nobody can use."""
        loop = self._loop
        failed = loop is not None and loop.fault() is not palpate.DeviceFault.none
        return failed or self.status().link is palpate.LinkState.lost

    def missed_ticks(self) -> int:
        return 0 if self._loop is None else self._loop.missed_ticks()

    def time(self) -> float:
        """[s] since it began."""
        return 0.0 if self._loop is None else self._loop.time()

    def hold(self, position: ArrayLike, orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0)) -> None:
        """Where the hand of a simulated device goes, in the arm's frame [m], and how it turns the
        stylus, a quaternion (x, y, z, w); upright unless told.
        """
        if self._hand is not None:
            sample = palpate.HapticSample(
                position=np.asarray(position, dtype=float),
                orientation=np.asarray(orientation, dtype=float),
            )
            with self._lock:
                self._hand.set(sample)

    def limits(self) -> palpate.SafetyLimits:
        """What the device can bear; of one that is not calibrated, nothing is known."""
        try:
            return palpate.find_safety_limits(self.driver.calibration())
        except palpate.DeviceError:
            return palpate.SafetyLimits()

    def store(self, calibration: palpate.Calibration) -> palpate.Calibration:
        """Writes a calibration to the device, motors off, and reads back what it kept.

        Raises DeviceError in words, and ValueError for numbers it cannot hold.
        """
        loop, live = self._loop, False
        if loop is not None:
            live = loop.running()
            self._part()
        try:
            self.driver.store(calibration)
        finally:
            if loop is not None and not self._over:
                self._keep_company(live)
        return self.driver.calibration()

    def _keep_company(self, live: bool) -> None:
        self._loop = palpate.DeviceLoop(self.device, self.limits())
        if live:
            self._loop.start()

    def _set(self, task: palpate.DeviceTask) -> None:
        with self._lock:
            if self._loop is not None:
                self._loop.set_task(task)


def build_link(name: str, origin: ArrayLike | None = None) -> Link:
    """A link that is not yet open; `origin` [m] of the scene is the middle of the workspace, and
    without it the scene's frame is the arm's. Raises WrongCall or DeviceError.
    """
    require_device(name)
    place = np.asarray(palpate.Workspace().center if origin is None else origin, dtype=float)
    if name == PLANT:
        return hold_plant(palpate.Plant(), palpate.NativeCoreOptions())
    if name == NATIVE:
        pty = palpate.PtyDevice()
        port = palpate.SerialTransport(pty.path())
        note = sentence("the firmware's code behind %1", pty.path())
        return Link(name, palpate.SerialDevice(port, place), far_end=pty, note=note)
    port = palpate.SerialTransport(find_port(name))
    return Link(name, palpate.SerialDevice(port, place), note=port.latency_note())


def hold_plant(plant: palpate.Plant, options: palpate.NativeCoreOptions) -> Link:
    """A simulated arm, held by a hand that is moved by Link.hold."""
    hand = palpate.PointerDevice()
    hand.set(palpate.HapticSample(position=palpate.Workspace().center))
    arm = palpate.SimulatedArm(hand, palpate.Workspace().center, plant, options)
    return Link(PLANT, arm.driver(), arm, hand, note=sentence("in this process"))


def list_devices() -> list[Report]:
    """The serial ports of this machine that could be a device, and those that always are there."""
    ports = [
        {
            "device": name_port(port.path),
            "product": port.product or port.driver,
            "permitted": port.permitted,
            "latency_timer_ms": port.latency_timer if port.latency_timer >= 0 else None,
        }
        for port in palpate.find_serial_ports()
    ]
    simulated = {
        NATIVE: "the firmware's code behind a pseudo terminal, in real time",
        PLANT: "simulated arm with the real firmware",
    }
    return ports + [
        {"device": name, "product": product, "permitted": True, "latency_timer_ms": None}
        for name, product in simulated.items()
    ]


def describe_low_latency() -> tuple[bool, str]:
    """Whether every serial adapter hands on bytes at once, and a sentence about it."""
    ports = palpate.find_serial_ports()
    if not ports:
        return True, "no USB serial adapter is plugged in"
    texts, good = [], True
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
        texts.append(told)
    return good, "; ".join(texts)


def to_list(values: NDArray[np.float64]) -> list[float]:
    return [float(value) for value in values]
