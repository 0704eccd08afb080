# SPDX-License-Identifier: BSD-3-Clause
"""Whether a hand can get to the places of a task, and past its limits."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate import scenario
from palpate.assessment.check_problem import ERROR, WARNING, Problem

Array = NDArray[np.float64]


def check_reach(scene: palpate.Scene, drawn: scenario.DrawnTask, level: str) -> Iterator[Problem]:
    """Of each step of an attempt: its place lies where a tool can touch it, and where the low-cost
    arm can bring the tool.
    """
    for name, step in zip(drawn.steps, drawn.task.steps, strict=True):
        if step.place < 0:
            continue
        place = drawn.task.places[step.place]
        if place.kind in (palpate.PlaceKind.object, palpate.PlaceKind.space):
            continue  # is of no organ, and goes where it is brought
        surface = drawn.task.surfaces[place.body]
        points = find_points(place, surface)
        radius = scene.instruments[step.instrument].tool.radius
        where = f"steps.{name}{level}"
        yield from check_contact(place, surface, radius, where)
        yield from check_workspace(scene, place, points, where)


def find_points(place: palpate.TaskPlace, surface: palpate.TaskSurface) -> Array:
    """[m] (n, 3): the vertices of a region, the points of a path, the centre of a ball."""
    if place.kind is palpate.PlaceKind.region:
        return np.asarray(surface.vertices)[np.flatnonzero(np.asarray(place.members))]
    return np.asarray(place.points, dtype=float)


def check_contact(
    place: palpate.TaskPlace, surface: palpate.TaskSurface, radius: float, where: str
) -> Iterator[Problem]:
    """A region is of the surface; a ball or a path may lie where no tool touches anything."""
    if place.kind is palpate.PlaceKind.region:
        return
    x, triangles = np.asarray(surface.vertices), np.asarray(surface.triangles)
    tree = palpate.AabbTree(x, triangles)
    far = [palpate.find_closest_point(tree, x, point).distance for point in place.points]
    reach = place.radius
    if place.kind is palpate.PlaceKind.path:
        reach += radius
    worst = max(far)
    if worst > reach:
        kind = "path" if place.kind is palpate.PlaceKind.path else "ball"
        text = (
            f"its {kind} lies {1e3 * worst:.3g} mm off the surface, and a tool that touches "
            f"comes within {1e3 * reach:.3g} mm"
        )
        yield Problem(ERROR, where, text)


def check_workspace(
    scene: palpate.Scene, place: palpate.TaskPlace, points: Array, where: str
) -> Iterator[Problem]:
    """The middle of all tissue lies in the middle of the arm's workspace. Of a region a part is
    enough.
    """
    x = np.concatenate([np.asarray(body.tissue.rest_position) for body in scene.bodies])
    middle = 0.5 * (x.min(axis=0) + x.max(axis=0))
    size = np.asarray(palpate.Workspace().size)
    outside = np.maximum(np.abs(points - middle) - 0.5 * size, 0.0)
    far = np.linalg.norm(outside, axis=1)
    worst = float(far.min() if place.kind is palpate.PlaceKind.region else far.max())
    if worst > 0.0:
        box = " x ".join(f"{1e3 * side:.0f}" for side in size)
        text = (
            f"its place lies {1e3 * worst:.3g} mm outside the workspace of the low-cost arm, "
            f"{box} mm about the middle of the organ"
        )
        yield Problem(WARNING, where, text)


def check_limits(scene: palpate.Scene, drawn: scenario.DrawnTask, level: str) -> Iterator[Problem]:
    """A limit of force that no tool can pass is none."""
    for name, limit in zip(drawn.limits, drawn.task.limits, strict=True):
        if limit.measure is not palpate.TaskMeasure.force or not limit.above:
            continue
        most = scene.instruments[limit.instrument].coupling.force_max
        if limit.bound >= most:
            text = f"is at {limit.bound:g} N, and the coupling gives {most:g} N at most"
            yield Problem(ERROR, f"limits.{name}{level}", text)


def check_times(drawn: scenario.DrawnTask, level: str) -> Iterator[Problem]:
    """A step that is overdue before it can be done."""
    for name, step in zip(drawn.steps, drawn.task.steps, strict=True):
        if step.duration >= step.time_limit > 0.0:
            text = f"lasts {step.duration:g} s, and is an error after {step.time_limit:g} s"
            yield Problem(ERROR, f"steps.{name}{level}", text)
