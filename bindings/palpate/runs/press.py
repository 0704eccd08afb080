# SPDX-License-Identifier: BSD-3-Clause
"""Scripted presses and pulls: where the hand goes, and what it felt there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import palpate
from palpate.runs.felt import read_column, read_force

CLEARANCE = 4e-3
"""[m] between tip and tissue where a script usually begins and ends."""
REST = 0.1
"""[s] at the end of the hold, in which tissue at rest gives the same force."""
UNREST = 0.1
"""[-] of the mean force: how far apart the forces of that time may lie."""
RAMP = 0.02
"""[s] The attach button goes down once the press has come to rest for this long."""
CLOSE = 0.2
"""[s] in which jaws close before they pull."""


@dataclass(frozen=True)
class Place:
    """A point on the surface at rest and the outward direction there."""

    point: np.ndarray
    """[m] (3,)"""
    outward: np.ndarray
    """[-] (3,), unit"""


@dataclass(frozen=True)
class PressScript:
    """A press to a depth, a hold, then a pull beyond the rest surface, and away."""

    depth: float
    """[m] of the hand's tip below the surface at rest."""
    pull: float = 0.0
    """[m] of the hand above where it touched; 0 for no pull."""
    speed: float = 0.03
    """[m/s] mean, of the press and the pull."""
    hold: float = 0.3
    """[s] at the deepest and at the highest point."""
    clearance: float = CLEARANCE
    """[m] between tip and tissue where it begins and ends."""


@dataclass(frozen=True)
class PressTimes:
    """When a script does what [s]."""

    pressed: float
    """The hand has come to rest at the depth."""
    held: float
    """It leaves the depth, or reaches for the attach button there."""
    pulled: float | None
    """The hand has come to rest at the height of the pull; None where nothing is pulled."""
    end: float


def find_top(scene: palpate.Scene, body: int | None = None) -> Place:
    """Where a ray from above, over the middle of a body's surface, meets it, or its highest vertex;
    for None of the first body, or of what covers that.
    """
    if body is not None:
        return find_top_on(*take_surface(scene, body))
    surfaces = [take_surface(scene, number) for number in range(len(scene.bodies))]
    x, triangles = surfaces[0]
    middle = x[triangles].mean(axis=(0, 1))
    covers = [top for each in surfaces[1:] if (top := find_under(*each, middle)) is not None]
    return max([find_top_on(x, triangles), *covers], key=lambda top: top.point[2])


def find_top_on(x: np.ndarray, triangles: np.ndarray) -> Place:
    """The top of a surface: vertices [m] (n, 3), triangles (t, 3)."""
    top = find_under(x, triangles, x[triangles].mean(axis=(0, 1)))
    return top or find_place_on(x, triangles, x[x[:, 2].argmax()])


def find_under(x: np.ndarray, triangles: np.ndarray, point: np.ndarray) -> Place | None:
    """Where a ray from above through `point` [m] (3,) meets a surface; None where it does not."""
    above = np.array([point[0], point[1], x[:, 2].max() + 0.01])
    tree = palpate.AabbTree(x, triangles)
    hit = palpate.find_ray_hit(tree, x, above, np.array([0.0, 0.0, -1.0]))
    return None if hit is None else find_place_on(x, triangles, np.asarray(hit.point))


def find_place(scene: palpate.Scene, near: np.ndarray, body: int = 0) -> Place:
    """The surface point of a body closest to `near` [m] and the smooth outward normal there."""
    return find_place_on(*take_surface(scene, body), near)


def find_nearest_place(scene: palpate.Scene, near: np.ndarray) -> Place:
    """The surface point closest to `near` [m] of all bodies."""
    places = [find_place(scene, near, body) for body in range(len(scene.bodies))]
    return min(places, key=lambda place: float(np.linalg.norm(place.point - near)))


def find_place_on(x: np.ndarray, triangles: np.ndarray, near: np.ndarray) -> Place:
    """The point of a surface closest to `near` [m] and the smooth outward normal there."""
    tree = palpate.AabbTree(x, triangles)
    found = palpate.find_closest_point(tree, x, np.asarray(near, dtype=float))
    normals = np.asarray(palpate.compute_vertex_normals(x, triangles))
    outward = np.asarray(found.weights) @ normals[triangles[found.triangle]]
    return Place(np.array(found.point), outward / np.linalg.norm(outward))


def take_surface(scene: palpate.Scene, body: int) -> tuple[np.ndarray, np.ndarray]:
    """Vertices at rest [m] (n, 3) and triangles (t, 3) of a body's surface."""
    tissue = scene.bodies[body].tissue
    x = palpate.compute_surface(tissue, tissue.rest_position)
    return np.asarray(x), np.asarray(tissue.triangles)


def has_jaws(scene: palpate.Scene, instrument: int = 0) -> bool:
    return scene.instruments[instrument].tool.jaws is not None


def write_script(
    place: Place, radius: float, script: PressScript, has_jaws: bool = False
) -> tuple[list[palpate.KeyFrame], PressTimes]:
    """Key frames of the tip's centre for a ScriptedDevice, and when they do what.

    Jaws are closed in a press, as open ones leave what lies between them untouched; for a pull they
    close at the depth.
    """
    frames: list[palpate.KeyFrame] = []
    closed = has_jaws and script.pull == 0.0
    now = 0.0

    def go(height: float, duration: float, attached: bool = False) -> float:
        nonlocal now
        now += duration
        frame = palpate.KeyFrame()
        frame.time = now
        frame.position = place.point + place.outward * (radius + height)
        frame.buttons = 1 if attached or closed else 0
        frames.append(frame)
        return now

    go(script.clearance, 0.0)
    go(script.clearance, 0.05)
    pressed = go(-script.depth, (script.clearance + script.depth) / script.speed)
    held = go(-script.depth, script.hold)
    pulled = None
    if script.pull > 0.0:
        go(-script.depth, RAMP, attached=True)
        if has_jaws:
            go(-script.depth, CLOSE, attached=True)
        pulled = go(script.pull, (script.depth + script.pull) / script.speed, attached=True)
        go(script.pull, script.hold, attached=True)
        go(script.pull, RAMP)
    go(max(script.clearance, 2 * script.pull), 0.2)
    go(max(script.clearance, 2 * script.pull), 0.1)
    return frames, PressTimes(pressed, held, pulled, now)


def is_at_rest(force: np.ndarray) -> bool:
    """Whether forces [N] (n,) that a hand at rest feels are those of tissue at rest."""
    return bool(force.max() - force.min() <= UNREST * force.mean())


def measure_press(
    record: palpate.Record, place: Place, radius: float, times: PressTimes
) -> dict[str, float | None]:
    """What a recorded script felt: peak of the press, peak of the pull, stiffness of the patch, and
    of a pull that came out empty the force at which it slipped.

    The hand's own time counts, so skipped ticks do not shift these times. Stiffness is the mean
    force of the last 100 ms of the hold over how deep the tip itself then stands below the surface
    at rest. It is None where the tip does not, and where the tissue has not come to rest: an organ
    that swings as a whole, as a solid does on a small base, may give any force then, and the
    peak is that of the impact.
    """
    time = read_column(record, "hand", "time")
    force = np.linalg.norm(read_force(record), axis=1)
    centre = read_column(record, "felt", "position").astype(float)
    depth = (place.point - centre) @ place.outward + radius
    pressing = time <= times.held
    settled = pressing & (time >= max(times.pressed, times.held - REST))
    stiffness = pull = slipped = None
    if settled.any() and depth[settled].mean() > 0.0 and is_at_rest(force[settled]):
        stiffness = float(force[settled].mean() / depth[settled].mean())
    if times.pulled is not None:
        drawn = time > times.held
        pull = float(force[drawn & (depth < 0.0)].max(initial=0.0))
        if pull == 0.0:
            slipped = float(force[drawn].max(initial=0.0))
    return {
        "peak_force_N": float(force[pressing].max(initial=0.0)),
        "pull_force_N": pull,
        "slipped_at_N": slipped,
        "patch_stiffness_N_per_m": stiffness,
    }
