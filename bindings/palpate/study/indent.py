# SPDX-License-Identifier: BSD-3-Clause
"""Force-indentation curves of a scene: its own tool on its own tissue, tick by tick, at rest."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

import palpate
from palpate.runs.alarms import tell_alarm
from palpate.runs.press import Place

STOPS = 10
"""Depths at which the tool is let come to rest."""
SETTLED = 2e-4
"""Of the force: how little it may still change within INTERVAL."""
INTERVAL = 0.05
"""[s]"""
FARTHEST = 5.0
"""Of the depth: how deep the hand may be for the tool to come there."""
SPEED = 0.03
"""[m/s] of the hand from stop to stop."""
CLEARANCE = 2e-3
"""[m] over the surface, where the hand begins."""
PATIENCE = 2.0
"""[s] A tissue that still swings by then is taken as it is on average."""


class OutOfReach(ValueError):
    """The tool cannot come as deep as was asked."""


def measure_indentation(
    scene: palpate.Scene, place: Place, depths: NDArray[np.float64]
) -> NDArray[np.float64]:
    """[N] that pushes the tool back at depths [m] of its tip, all at rest.

    The hand goes down in steps until the tool is as deep as asked, and what it feels between them
    is interpolated.

    Raises:
        OutOfReach: where the tool never gets there.
        RuntimeError: where the tissue blows up.
    """
    probe = Probe(scene, place)
    deepest = float(depths[-1])
    found = [(0.0, 0.0)]
    while found[-1][0] < deepest:
        # by how much the tool lags behind the hand is known from the step before
        before, force = found[-1]
        lag = force / before / scene.instruments[0].coupling.stiffness if before > 0.0 else 0.0
        hand = probe.hand + deepest / STOPS * (1.0 + lag)
        if hand <= FARTHEST * deepest:
            probe.go(hand)
            found.append(probe.settle())
        if found[-1][0] <= before:
            raise OutOfReach(
                f"the tip comes to {1e3 * found[-1][0]:.1f} mm of {1e3 * deepest:.1f} mm: the "
                "hand's spring is too soft for this tissue, or the tissue too thin"
            )
    depth, force = np.array(found).T
    return np.maximum(PchipInterpolator(depth, force)(depths), 0.0)


class Probe:
    """A hand that goes down along the normal of a place, with the scene's tool in it."""

    def __init__(self, scene: palpate.Scene, place: Place):
        self.scene, self.place = scene, place
        self.world = palpate.World(scene, recovers=False)
        self.tool = self.world.instruments[0].tool
        self.radius, self.period = scene.instruments[0].tool.radius, 1.0 / scene.rate
        self.sample = palpate.HapticSample()
        self.hand = -CLEARANCE
        """[m] of the hand's tip below the surface at rest."""
        self.tick()
        self.go(0.0)

    def tick(self) -> None:
        self.sample.position = self.place.point + self.place.outward * (self.radius - self.hand)
        palpate.tick(self.scene, self.sample, self.period, self.world)
        alarm = self.world.alarm
        if alarm.kind != palpate.AlarmKind.none:
            raise RuntimeError(
                f"the press was stopped {1e3 * self.hand:.2f} mm deep: "
                f"{tell_alarm(alarm, self.scene, self.world.alarm_body)}"
            )

    def go(self, depth: float) -> None:
        start = self.hand
        count = max(1, int(np.ceil(abs(depth - start) / SPEED * self.scene.rate)))
        for self.hand in np.linspace(start, depth, count + 1)[1:].tolist():
            self.tick()

    def settle(self) -> tuple[float, float]:
        """Depth [m] of the tool's tip and force [N] on it once both have come to rest."""
        count = max(1, round(INTERVAL * self.scene.rate))
        before = None
        for _ in range(round(PATIENCE / INTERVAL)):
            middle = np.zeros(3)
            for _ in range(count):
                self.tick()
                # the mean over a while: what still swings has its middle there
                middle += self.tool.position
            lag = float((middle / count - self.sample.position) @ self.place.outward)
            force = self.scene.instruments[0].coupling.stiffness * lag
            if before is not None and abs(force - before) <= SETTLED * abs(force) + 1e-9:
                break
            before = force
        return self.hand - lag, force
