# SPDX-License-Identifier: BSD-3-Clause
"""Pushing against a scale: what tells how strong the motors really are."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.command.sentence import PoorData
from palpate.device.fit import Pull
from palpate.device.hand import SEEN, ask, bring, watch
from palpate.device.link import Link
from palpate.device.poses import ARM, POSES, STILL

Array = NDArray[np.float64]

DIRECTIONS = {"right": (1.0, 0.0, 0.0), "away": (0.0, 1.0, 0.0), "up": (0.0, 0.0, 1.0)}
"""Of the pushes, in the arm's frame."""
WEAK, STRONG = 0.3, 0.9
"""[N] of the two pushes in each direction."""
LEAN, LEAN_STEPS = 1.0, 50
"""[s] in which a push grows, and in how many steps."""

Reader = Callable[[Link, str, Array, float], float | None]
"""(link, name of the direction, direction, force [N]) -> what the scale reads [N], None to skip."""


def measure_pulls(link: Link, read: Reader) -> Iterator[Pull]:
    """Pushes weakly and strongly in every direction, at home. Ends where no reading is given."""
    bring(link, POSES[0])
    power_up(link)
    strong = find_strong(link)
    for name, vector in DIRECTIONS.items():
        direction = np.array(vector)
        duty, readings, joints, before = [], [], np.zeros(ARM), 0.0
        for force in (WEAK, strong):
            lean(link, before * direction, force * direction)
            before = force
            reading = read(link, name, direction, force)
            if reading is None:
                link.push()
                return
            gather = watch(link)
            joints = gather.joints()
            duty.append(gather.duty())
            readings.append(reading)
        lean(link, strong * direction, np.zeros(3))
        yield Pull(direction, joints, np.array(duty), np.array(readings))


def lean(link: Link, before: Array, after: Array) -> None:
    """From one force [N] to another so slowly that the arm follows without swinging back: its
    friction then is the same in every reading.
    """
    for share in np.linspace(0.0, 1.0, LEAN_STEPS + 1)[1:]:
        link.push(before + share * (after - before))
        link.run(LEAN / LEAN_STEPS)
    link.run(STILL)


def find_strong(link: Link) -> float:
    """[N] of the stronger push: what the motors can keep up."""
    return min(STRONG, 0.8 * link.limits().force_continuous)


def power_up(link: Link) -> None:
    """Motors on. Raises PoorData where they stay off."""
    link.driver.clear_fault()
    link.driver.enable(True)
    if not link.wait_for(palpate.DeviceMode.run, 2.0):
        raise PoorData("The motors stay off: %1.", palpate.describe_status(link.status()))


def read_scale(link: Link, name: str, direction: Array, force: float) -> float:
    """What the hand of a simulated device holds against."""
    del name, force
    assert link.arm is not None
    held = []
    for _ in range(round(STILL / SEEN)):
        link.run(SEEN)
        held.append(-float(np.asarray(link.arm.hand_force()) @ direction))
    return float(np.mean(held))


def ask_scale(link: Link, name: str, direction: Array, force: float) -> float | None:
    del link, direction
    response = ask(
        f"the stylus is pushed {name} with {force:g} N; hold it at home with a spring scale and "
        "type what it reads in N (nothing: leave out the force check)"
    ).strip()
    if not response:
        return None
    try:
        return float(response.removesuffix("N"))
    except ValueError:
        raise PoorData("%1 is no number of newtons.", repr(response)) from None
