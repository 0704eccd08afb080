# SPDX-License-Identifier: BSD-3-Clause
"""Hands that handle a scene of several bodies at random, from a seed, tick by tick."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import palpate
from palpate.layout.gaps import Surface

ABOVE = 20e-3
"""[m] of the tip over the surface, where the hand comes from and goes back to."""
FLIGHT = 0.5
"""[m/s] of the hand in the air."""
Way = tuple[float, np.ndarray, int]
"""[s] since the one before, [m] (3,) of the tip, and the buttons."""


class RandomHand:
    """Presses, slides, flicks, takes hold and pulls, all over what can be reached from outside."""

    def __init__(self, scene: palpate.Scene, seed: int):
        self.chance = np.random.default_rng(seed)
        self.radius = scene.instruments[0].tool.radius
        self.surfaces = []
        for body in scene.bodies:
            x = palpate.compute_surface(body.tissue, body.tissue.rest_position)
            self.surfaces.append(Surface(np.asarray(x), np.asarray(body.tissue.triangles)))
        used = np.vstack([surface.used for surface in self.surfaces])
        self.centre = 0.5 * (used.min(axis=0) + used.max(axis=0))
        self.far = np.linalg.norm(used - self.centre, axis=1).max() + 2.0 * ABOVE
        self.normals = [
            np.asarray(palpate.compute_vertex_normals(s.x, s.triangles)) for s in self.surfaces
        ]

    def write(self) -> Iterator[Way]:
        """Without an end."""
        point, out = self.find_place()
        at = point + (self.radius + ABOVE) * out
        yield 0.0, at, 0
        while True:
            for way in self.handle(point, out):
                at = way[1]
                yield way
            point, out = self.find_place()
            for corner in self.go_around(at, point + (self.radius + ABOVE) * out):
                yield float(np.linalg.norm(corner - at)) / FLIGHT, corner, 0
                at = corner

    def find_place(self) -> tuple[np.ndarray, np.ndarray]:
        """[m] A point of the surface of a body at rest, and the way out from there, that leads
        through none."""
        while True:
            body = int(self.chance.integers(len(self.surfaces)))
            surface = self.surfaces[body]
            vertex = self.chance.choice(np.unique(surface.triangles))
            point, out = surface.x[vertex], self.normals[body][vertex]
            if self.is_open(point, out):
                return point, out

    def is_open(self, point: np.ndarray, out: np.ndarray) -> bool:
        heights = np.arange(2e-3, 2.0 * self.far, self.radius)
        for height in heights:
            at = point + (self.radius + height) * out
            if np.linalg.norm(at - self.centre) > self.far:
                return True
            if any(
                palpate.find_closest_point(s.tree, s.x, at, self.radius) is not None
                for s in self.surfaces
            ):
                return False
        return True

    def handle(self, point: np.ndarray, out: np.ndarray) -> list[Way]:
        """In, something there, and out again."""
        chance = self.chance
        aside = np.cross(out, chance.normal(size=3))
        aside /= np.linalg.norm(aside)
        depth, speed = chance.uniform(1e-3, 12e-3), chance.uniform(0.01, 0.2)
        at = point + (self.radius + 2e-3) * out
        ways: list[Way] = [(0.1, at, 0)]

        def go(by: np.ndarray, rate: float, buttons: int) -> None:
            nonlocal at
            at = at + by
            ways.append((max(1e-3, float(np.linalg.norm(by)) / rate), at, buttons))

        go(-(depth + 2e-3) * out, speed, 0)
        held = 0
        for _ in range(int(chance.integers(1, 4))):
            kind = chance.choice(["hold", "slide", "flick", "take", "press"])
            if kind == "hold":
                ways.append((chance.uniform(0.05, 0.5), at, held))
            elif kind == "slide":
                go(chance.uniform(-20e-3, 20e-3) * aside, chance.uniform(0.02, 0.2), held)
            elif kind == "flick":
                go(chance.uniform(-5e-3, 5e-3) * (aside + chance.uniform(-1, 1) * out), 1.0, held)
            elif kind == "take":
                held = 1
                ways.append((0.05, at, held))
                go((depth + chance.uniform(0, 15e-3)) * out, chance.uniform(0.02, 0.2), held)
            else:
                go(-chance.uniform(0, 4e-3) * out, speed, held)
        if held and chance.random() < 0.8:
            ways.append((0.05, at, 0))
        leave = point + (self.radius + ABOVE) * out
        ways.append((float(np.linalg.norm(leave - at)) / chance.uniform(0.05, 0.5), leave, 0))
        return ways

    def go_around(self, first: np.ndarray, last: np.ndarray) -> list[np.ndarray]:
        """[m] (n, 3) straight out to a sphere around everything, along that, and in."""
        ends = []
        for at in (first, last):
            out = at - self.centre
            ends.append(out / np.linalg.norm(out))
        middle = ends[0] + ends[1] + 0.1 * np.roll(ends[0], 1)
        return [
            *(self.centre + self.far * n / np.linalg.norm(n) for n in (ends[0], middle, ends[1])),
            last,
        ]


class RandomGrasper:
    """Jaws through a trocar that look for a stone: in and out, turned, open and closed, against
    the stone and into the walls around it."""

    def __init__(self, scene: palpate.Scene, seed: int):
        self.chance = np.random.default_rng(seed)
        self.stone = np.asarray(scene.rigid[0].position)
        out = np.asarray(scene.instruments[0].trocar) - self.stone
        self.length = float(np.linalg.norm(out))
        self.out = out / self.length

    def write(self) -> Iterator[Way]:
        """Without an end."""
        chance = self.chance
        at = self.stone + 0.7 * self.length * self.out
        yield 0.0, at, 0
        while True:
            inside = chance.random() < 0.8
            far = chance.uniform(0.2, 0.7) * self.length
            aside = chance.normal(scale=4e-3, size=3)
            to = self.stone + (aside if inside else far * self.out)
            closed = int(chance.random() < 0.6)
            speed = chance.uniform(0.02, 0.2)
            yield max(1e-3, float(np.linalg.norm(to - at)) / speed), to, closed
            closed = int(chance.random() < 0.6)
            yield chance.uniform(0.05, 0.5), to, closed
            at = to


def follow(ways: Iterator[Way], rate: float, roll: float = 0.0) -> Iterator[palpate.HapticSample]:
    """One sample a tick; a device that turns about its axis at `roll` [rad/s]."""
    _, at, _ = next(ways)
    time, tick = 0.0, 0
    for duration, to, held in ways:
        while tick / rate < time + duration:
            share = (tick / rate - time) / duration
            sample = palpate.HapticSample()
            sample.time = tick / rate
            sample.position = at + share * (to - at)
            half = 0.5 * roll * tick / rate
            sample.orientation = (0.0, 0.0, np.sin(half), np.cos(half))
            sample.buttons = held
            yield sample
            tick += 1
        time, at = time + duration, to


def move_at_random(scene: palpate.Scene, seed: int) -> Iterator[palpate.HapticSample]:
    """One sample a tick, without an end."""
    if scene.instruments[0].tool.jaws is not None:
        return follow(RandomGrasper(scene, seed).write(), scene.rate, roll=0.5)
    return follow(RandomHand(scene, seed).write(), scene.rate)
