# SPDX-License-Identifier: BSD-3-Clause
"""One run of a scene along a path, tick by tick, beside the truth at the tool's own place.

Without gravity: an organ that sags is another one at every place. Nothing here looks at a clock.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.runs.alarms import tell_alarm
from palpate.runs.press import take_surface
from palpate.study.contact_reference import Spot
from palpate.study.scene_chart import Errors
from palpate.study.tool import find_touch
from palpate.study.truth import Floats, Truth

SPEED, HOLD = 0.01, 0.15
"""[m/s] of the hand, mean; [s] at the end. A truth at rest knows no inertia: a spleen that is
pressed 6 mm at three times the speed swings, and is twice as far off."""
CLEARANCE = 1e-3
"""[m] over the surface where a path begins."""
GRIP = 5e-4
"""[m] A pull begins by pressing so deep, where the tool takes hold."""
LOOK = 20
"""Ticks from one look at the surface to the next."""
DEEP = 0.5
"""[-] Of the deepest that the tool comes: shallower, displacements are not looked at."""


@dataclass(frozen=True)
class Course:
    """Where the ball first touches a scene at every station of a truth."""

    truth: Truth
    centre: Floats
    """[m] (s, 3) of the ball at first touch, on this scene's own surface, which may be coarser."""

    def locate(self, p: Floats) -> tuple[float, Floats, float]:
        """Where between stations a ball's centre is: 0 to s - 1, the outward direction there, and
        how deep it is beyond first touch [m]."""
        at = find_between(self.centre, p)
        i, j, part = split(at, len(self.centre))
        outward = (1.0 - part) * self.truth.direction[i] + part * self.truth.direction[j]
        outward /= np.linalg.norm(outward)
        middle = (1.0 - part) * self.centre[i] + part * self.centre[j]
        return at, outward, float((middle - p) @ outward)

    def find_force(self, at: float, depth: float) -> float:
        """[N] of the truth along the direction between stations; 0 above the surface, and beyond
        what was solved that of the deepest."""
        depth = self.clip(depth)
        return self.truth.find_force(at, depth) if depth else 0.0

    def find_displacement(self, at: float, depth: float) -> Floats:
        """[m] (m, 3) of the truth's surface, likewise."""
        depth = self.clip(depth)
        if depth == 0.0:
            return np.zeros_like(self.truth.surface)
        return self.truth.find_displacement(at, depth)

    def clip(self, depth: float) -> float:
        """[m] As deep as the truth goes; 0 where it has none."""
        last = float(self.truth.depth[-1])
        return float(np.clip(depth, min(0.0, last), max(0.0, last)))


def split(at: float, stations: int) -> tuple[int, int, float]:
    """The stations on both sides of a place between them, and how far it is from the first."""
    i = min(int(at), stations - 1)
    j = min(i + 1, stations - 1)
    return i, j, at - i


def find_between(points: Floats, p: Floats) -> float:
    """Where a line through points comes nearest to p: 1.25 is a quarter behind the second."""
    best, found = np.inf, 0.0
    for i in range(len(points) - 1):
        along = points[i + 1] - points[i]
        part = float(np.clip((p - points[i]) @ along / (along @ along), 0.0, 1.0))
        away = float(np.linalg.norm(p - points[i] - part * along))
        if away < best:
            best, found = away, i + part
    return found


def set_course(scene: palpate.Scene, truth: Truth) -> Course:
    """Brings the scene's own ball down to its own surface at every station."""
    radius = scene.instruments[0].tool.radius
    centres = []
    for point, outward, thickness in zip(
        truth.point, truth.direction, truth.thickness, strict=True
    ):
        spot = Spot("", tuple(point), tuple(outward), float(thickness))
        centres.append(point + find_touch(scene, spot, radius) * outward)
    return Course(truth, np.array(centres))


def write_way(course: Course, kind: str, speed: float = SPEED) -> list[palpate.KeyFrame]:
    """Key frames of a hand that goes along a course as deep as its truth was solved, and rests.

    Args:
        course: Of the scene.
        kind: press, straight down at the first station; pull, which takes hold there and goes up;
            drag, over all stations at one depth.
        speed: [m/s] mean.
    """
    outward, depth = course.truth.direction, float(np.abs(course.truth.depth).max())
    over = course.centre[0] + CLEARANCE * outward[0]
    if kind == "pull":
        grip, pulled = (course.centre[0] + height * outward[0] for height in (-GRIP, depth))
        stops = [(over, 0), (grip, 0), (grip, 1), (pulled, 1), (pulled, 1)]
    else:
        below = course.centre - depth * outward
        if kind == "press":
            below = below[:1]
        stops = [(over, 0), *((point, 0) for point in below), (below[-1], 0)]
    frames, now = [], 0.0
    for i, (point, buttons) in enumerate(stops):
        length = float(np.linalg.norm(point - stops[i - 1][0])) if i else 0.0
        now += (length / speed or HOLD) if i else 0.0
        frames.append(palpate.KeyFrame(now, point, buttons))
    return frames


def list_samples(frames: Sequence[palpate.KeyFrame], rate: float) -> list[palpate.HapticSample]:
    """What a hand that follows key frames says, tick by tick."""
    hand = palpate.ScriptedDevice(frames)
    ticks = round(frames[-1].time * rate)
    return [hand.read((tick + 1) / rate) for tick in range(ticks)]


@dataclass(frozen=True)
class Track:
    """What a run felt, tick by tick, as far as it came."""

    force: Floats
    """[N] (t, 3) on the hand."""
    along: Floats
    """[N] (t,) of it along the direction where the tool is."""
    truth: Floats
    """[N] (t,) where the tool is."""
    touching: NDArray[np.bool_]
    """(t,) Either is felt, or the tool is below the surface or holds on."""
    depth: Floats
    """[m] (t,) of the tool beyond first touch."""
    substeps: NDArray[np.int64]
    """(t,)"""
    displacement: Floats
    """[-] (l,) error of every look at the surface, of the tool's depth."""
    alarm: str
    """In words; empty where it came to the end."""


def run_track(
    scene: palpate.Scene, course: Course, samples: Sequence[palpate.HapticSample]
) -> Track:
    """Ticks a scene from rest through all samples, or to an alarm."""
    scene = copy(scene)
    scene.gravity = [0.0, 0.0, 0.0]
    runner = Runner(scene, course)
    for sample in samples:
        if not runner.tick(sample):
            break
    return runner.finish()


class Runner:
    """A world on its way."""

    def __init__(self, scene: palpate.Scene, course: Course):
        self.scene, self.course, self.world = scene, course, palpate.World(scene, recovers=False)
        self.surface = Surface(scene, course.truth.surface)
        self.rows: list[tuple] = []
        self.looks: list[tuple[float, float]] = []
        self.before: float | None = None
        self.alarm = ""

    def tick(self, sample: palpate.HapticSample) -> bool:
        """Whether it can go on."""
        world, scene = self.world, self.scene
        force = np.array(palpate.tick(scene, sample, 1.0 / scene.rate, world).force)
        if world.alarm.kind != palpate.AlarmKind.none:
            self.alarm = tell_alarm(world.alarm, scene, world.alarm_body)
            return False
        tool = world.instruments[0].tool
        at, outward, depth = self.course.locate(np.asarray(tool.position))
        # the force is the mean of a tick, so is the depth
        middle = depth if self.before is None else 0.5 * (self.before + depth)
        self.before = depth
        truth = self.course.find_force(at, middle) if self.is_meant(tool) else 0.0
        touching = bool(force.any()) or truth != 0.0
        self.rows.append(
            (*force, force @ outward, truth, touching, middle, world.bodies[0].substeps)
        )
        if len(self.rows) % LOOK == 0 and truth != 0.0:
            self.look(at, depth)
        return True

    def is_meant(self, tool: palpate.ToolState) -> bool:
        """Whether the truth has an answer: a pull is of a tool that holds on."""
        return self.course.truth.depth[0] > 0.0 or tool.hold_count > 0

    def look(self, at: float, depth: float) -> None:
        if self.surface.count == 0 or depth == 0.0:
            return
        off = self.surface.measure(self.world) - self.course.find_displacement(at, depth)
        rms = float(np.sqrt((off**2).sum(axis=1).mean()))
        self.looks.append((abs(depth), rms / abs(depth)))

    def finish(self) -> Track:
        table = np.array(self.rows, dtype=float).reshape(-1, 8)
        deepest = max((depth for depth, _ in self.looks), default=0.0)
        looks = [error for depth, error in self.looks if depth >= DEEP * deepest]
        return Track(
            table[:, :3], table[:, 3], table[:, 4], table[:, 5] > 0.0, table[:, 6],
            table[:, 7].astype(int), np.array(looks), self.alarm,
        )  # fmt: skip


class Surface:
    """Points of a truth on a scene's own surface."""

    def __init__(self, scene: palpate.Scene, points: Floats):
        x, triangles = take_surface(scene, 0)
        tree = palpate.AabbTree(x, triangles)
        found = [palpate.find_closest_point(tree, x, point) for point in points]
        self.count = len(found)
        self.corners = triangles[[near.triangle for near in found]] if found else triangles[:0]
        self.weights = np.array([near.weights for near in found]).reshape(-1, 3)
        self.rest = x.copy()

    def measure(self, world: palpate.World) -> Floats:
        """[m] (m, 3) displacements of the points."""
        moved = np.asarray(palpate.surface_position(world.bodies[0])) - self.rest
        return np.einsum("ij,ijk->ik", self.weights, moved[self.corners])


def compare_with_truth(track: Track, largest: float) -> Errors:
    """Of a run that came to its end; `largest` [N] is the truth's on the path."""
    off = np.abs(track.along - track.truth)[track.touching] / largest
    looks = track.displacement
    return Errors(*measure(off), float(np.sqrt((looks**2).mean())) if len(looks) else None)


def compare_in_time(track: Track, converged: Floats, largest: float) -> Errors:
    """Of a run beside forces [N] (t, 3) of the same model converged in time, tick by tick."""
    off = np.linalg.norm(track.force - converged, axis=1) / largest
    touched = track.touching | converged.any(axis=1)
    return Errors(*measure(off[touched]), None)


def measure(off: Floats) -> tuple[float, float]:
    """Root mean square and largest; nothing where nothing was touched."""
    return (float(np.sqrt((off**2).mean())), float(off.max())) if len(off) else (0.0, 0.0)


def find_largest_force(truth: Truth) -> float:
    """[N] of a truth on its path."""
    return float(np.abs(truth.force).max())


def find_jump(track: Track) -> float:
    """[N] The largest change of the force on the hand from tick to tick."""
    if len(track.force) < 2:
        return 0.0
    return float(np.linalg.norm(np.diff(track.force, axis=0), axis=1).max())
