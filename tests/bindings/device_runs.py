# SPDX-License-Identifier: BSD-3-Clause
"""Pressing an organ through a device in virtual time: driver, firmware, arm and tick."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import palpate
from numpy.typing import NDArray
from palpate.runs.other_hands import find_centre
from palpate.runs.press import PressScript, find_top, write_script

DT = 1e-3
"""[s] of a tick."""


@dataclass(frozen=True)
class DeviceRun:
    """What was asked of a device and what its motors made of it, tick by tick."""

    time: NDArray[np.float64]
    """[s]"""
    hand: NDArray[np.float64]
    """[m] (n, 3) as the device told it."""
    asked: NDArray[np.float64]
    """[N] (n, 3) by the tick, past the safety wrapper."""
    motor: NDArray[np.float64]
    """[N] (n, 3) of the motors at the tip; of an ideal device, what was asked."""
    pressed: float
    held: float
    end: float
    fault: palpate.DeviceFault


def press_through(
    scene: palpate.Scene,
    kind: str,
    *,
    depth: float = 6e-3,
    link_delay: float = 0.0,
    host_dies_at: float = np.inf,
) -> DeviceRun:
    """Presses a scene from above with an "ideal" device, or a hand on the "plant"."""
    script = PressScript(depth, speed=0.02, hold=0.6)
    frames, times = write_script(find_top(scene), scene.instruments[0].tool.radius, script)
    frames = [palpate.KeyFrame(0.0, frames[0].position), *shift(frames, 0.8)]
    hand = palpate.ScriptedDevice(frames)
    device: palpate.HapticDevice = hand
    limits = palpate.SafetyLimits()
    if kind == "plant":
        options = palpate.NativeCoreOptions(link_delay=link_delay)
        device = palpate.SimulatedArm(hand, find_centre(scene, 0, 0.0), palpate.Plant(), options)
        device.open()
        limits = palpate.find_safety_limits(device.driver().calibration())
    safe = palpate.SafeDevice(device, limits)
    world = palpate.World(scene)
    rows = [
        step(scene, world, safe, device, k * DT, k * DT < host_dies_at)
        for k in range(round((times.end + 0.8) / DT))
    ]
    time, at, asked, motor = (np.array(column) for column in zip(*rows, strict=True))
    shifted = (times.pressed + 0.8, times.held + 0.8, times.end + 0.8)
    return DeviceRun(time, at, asked, motor, *shifted, safe.fault())


def shift(frames: list[palpate.KeyFrame], by: float) -> list[palpate.KeyFrame]:
    """Later by a time [s], in which the motors come to their full force."""
    return [palpate.KeyFrame(frame.time + by, frame.position, frame.buttons) for frame in frames]


def step(
    scene: palpate.Scene,
    world: palpate.World,
    safe: palpate.SafeDevice,
    device: palpate.HapticDevice,
    time: float,
    alive: bool,
) -> tuple[float, NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    core = device.core() if isinstance(device, palpate.SimulatedArm) else None
    if alive:
        sample = safe.read(time)
        safe.write(palpate.tick(scene, sample, DT, world))
        at = np.array(sample.position)
    else:
        core.advance(time)
        at = np.full(3, np.nan)
    asked = np.array(safe.sent().force)
    if core is None:
        return time, at, asked, asked
    arm = palpate.find_arm(core.plant())
    joints = core.state().joints
    duty = palpate.Drive(core.drive().duty, core.drive().enabled)
    torque = palpate.compute_motor_torque(core.plant(), duty, np.zeros(3))
    if not core.drive().enabled:
        return time, at, asked, np.zeros(3)
    return time, at, asked, palpate.compute_tip_force(arm, joints, torque)


def spoil(calibration: palpate.Calibration) -> palpate.Calibration:
    """Zeros, scales and torques as of other sensors and motors."""
    joints = calibration.joints
    for joint in joints:
        joint.zero, joint.scale = joint.zero + 40, 0.93 * joint.scale
    calibration.joints = joints
    calibration.torque_full = np.array([0.8, 1.3, 0.9]) * calibration.torque_full
    return calibration
