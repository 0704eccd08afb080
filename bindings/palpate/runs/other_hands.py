# SPDX-License-Identifier: BSD-3-Clause
"""The hands of a scene's other instruments, and handles that are no tips."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.command.verb import WrongCall
from palpate.device.link import build_link
from palpate.device.names import PARKED, PLANT, POINTER, find_port, split_hand
from palpate.runs.press import find_top
from palpate.runs.script_file import read_script_file

ASIDE = 0.7
"""[-] of the organ's half diagonal from its top to where a parked instrument waits."""
HIGH = 0.02
"""[m] over the top."""
LEAST_INSERTED = 0.02
"""[m] of a shaft beyond its trocar, where its tip is at the organ's top."""


def name_hands(asked: Sequence[str], count: int, hand: str = "") -> list[str]:
    """One for each of `count` instruments: as asked for, and where nothing is said the mouse where
    the first is the mouse, which Tab gives to the next, the simulated `hand` where the first is
    one, else parked. Raises WrongCall for more."""
    if len(asked) > count:
        raise WrongCall(f"--device: got {len(asked)}, expected at most {count}, one an instrument")
    names = [hand if hand and split_hand(name)[1] == hand else name for name in asked] or [POINTER]
    rest = hand or (POINTER if names[0] == POINTER else PARKED)
    return names + [rest] * (count - len(names))


def park(scene: palpate.Scene, instrument: int) -> NDArray[np.float64]:
    """[m] (3,) Where an instrument waits: over the organ, beside its top."""
    top = find_top(scene)
    x = np.asarray(scene.bodies[0].tissue.rest_position)
    aside = ASIDE * 0.5 * float(np.linalg.norm(x.max(axis=0) - x.min(axis=0)))
    radius = scene.instruments[instrument].tool.radius
    return np.array(top.point) + np.array([aside * instrument, 0.0, HIGH + radius])


def build_other(
    name: str, scene: palpate.Scene, instrument: int, handle: float = 0.0
) -> palpate.HapticDevice:
    """The device of an instrument after the first; an arm may be its handle, so far [m] from its
    tip. Raises WrongCall, Refusal, OSError or
    DeviceError."""
    if name == PARKED:
        return palpate.ScriptedDevice([palpate.KeyFrame(0.0, park(scene, instrument))])
    if name == POINTER:
        return palpate.SurfacePointer(scene, 0, instrument)
    arm, script = split_hand(name)
    if find_port(arm):
        link = build_link(arm, find_centre(scene, instrument, handle))
        link.open()
        return link.driver
    if arm == PLANT or not script:
        raise WrongCall(
            f"--device: got {name!r} for instrument {instrument + 1}, expected {POINTER}, "
            f"{PARKED}, script:FILE or serial:PATH"
        )
    return palpate.ScriptedDevice(read_script_file(Path(script)))


def find_fulcrum(scene: palpate.Scene, instrument: int, length: float) -> palpate.Fulcrum | None:
    """Of an instrument whose handle a device is, `length` [m] from its tip; None for 0.

    Raises WrongCall where it has no trocar, or does not reach the organ through it.
    """
    if not length > 0.0:
        return None
    trocar = scene.instruments[instrument].trocar
    if trocar is None:
        raise WrongCall("--fulcrum: the instrument of this scenario has no trocar to turn about")
    least = find_least_handle(scene, trocar)
    if length < least:
        raise WrongCall(
            f"--fulcrum: got {1e3 * length:g} mm, expected at least {1e3 * least:.0f} mm: so far "
            "is the organ behind the trocar"
        )
    return palpate.Fulcrum(trocar, length)


def find_least_handle(scene: palpate.Scene, trocar: NDArray[np.float64]) -> float:
    """[m] From the tip of a shaft to its handle, which stays outside of the trocar."""
    return float(np.linalg.norm(trocar - np.array(find_top(scene).point))) + LEAST_INSERTED


def find_centre(scene: palpate.Scene, instrument: int, length: float) -> NDArray[np.float64]:
    """[m] (3,) Where the middle of an arm's workspace lies: at the middle of all tissue or, where
    it is the handle of an instrument, at its handle when the tip is there."""
    x = np.concatenate([np.asarray(body.tissue.rest_position) for body in scene.bodies])
    middle = 0.5 * (x.min(axis=0) + x.max(axis=0))
    fulcrum = find_fulcrum(scene, instrument, length)
    return (
        middle if fulcrum is None else np.asarray(palpate.compute_fulcrum_handle(fulcrum, middle))
    )
