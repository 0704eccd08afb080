# SPDX-License-Identifier: GPL-3.0-or-later
"""Places along a surface that a ball is dragged over, or a script's hand goes over."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import palpate
from palpate.runs.press import Place
from palpate.runs.validated import list_centres

from palpate_editor.document import Organ
from palpate_editor.truth import wanted
from palpate_editor.truth.progress import TruthError
from palpate_editor.truth.subject import Subject
from palpate_editor.truth.tetrahedra import Floats, Ints

ELEMENTS = 3.0
"""Edges of the simulated surface that a drag passes."""
LEAST, MOST = 2.0, 10.0
"""Radii of the ball that it is long."""
MOST_STATIONS = 10
WAYS = 12
"""Directions along the surface that are tried."""
TURN = 0.5
"""Cosine of the most that the surface turns under a drag."""
FROM_HELD = 1.5
"""Radii of the ball between a drag and what is held."""


class Ground:
    """A surface to walk on."""

    def __init__(self, subject: Subject):
        self.x = subject.surface.x
        self.triangles = subject.surface.triangles.astype(np.int32)
        self.tree = palpate.AabbTree(self.x, self.triangles)
        self.normals = np.asarray(palpate.compute_vertex_normals(self.x, self.triangles))
        self.held = self.x[subject.fixed]

    def find(self, near: Floats) -> Place:
        found = palpate.find_closest_point(self.tree, self.x, near)
        outward = np.asarray(found.weights) @ self.normals[self.triangles[found.triangle]]
        return Place(np.array(found.point), outward / np.linalg.norm(outward))

    def walk(
        self, start: Place, toward: Floats, step: float, count: int, off: float
    ) -> list[Place]:
        """At most `count` steps [m] towards a direction, as far as the surface turns little and is
        farther than `off` [m] from what is held."""
        places, ahead = [start], toward
        for _ in range(count):
            last = places[-1]
            ahead = ahead - (ahead @ last.outward) * last.outward
            ahead = ahead / np.linalg.norm(ahead)
            following = self.find(last.point + step * ahead)
            gone = float(np.linalg.norm(following.point - last.point))
            apart = np.linalg.norm(self.held - following.point, axis=1).min(initial=np.inf)
            if following.outward @ start.outward < TURN or apart < off or gone < 0.5 * step:
                break
            places.append(following)
        return places


def walk(
    organ: Organ, subject: Subject, radius: float, start: Place, path: wanted.Drag
) -> list[Place]:
    """The stations of a drag, a radius apart and two on an edge of the body's surface, or as many
    as may be. Raises TruthError."""
    length = choose_length(organ, radius, path.length)
    ground = Ground(subject)
    apart = min(radius, 0.5 * measure_edge(ground.x, ground.triangles))
    count = int(np.clip(np.ceil(length / apart), 2, MOST_STATIONS - 1))
    step = length / count
    found = [
        ground.walk(start, toward, step, count, FROM_HELD * radius)
        for toward in list_directions(start, path.toward)
    ]
    best = max(found, key=lambda places: (len(places), places[-1].outward @ start.outward))
    if len(best) <= count:
        raise TruthError(
            f"drag: got {1e3 * step * (len(best) - 1):.3g} mm of free and smooth surface from "
            f"there, expected {1e3 * length:.3g} mm: begin elsewhere, or ask for a shorter one"
        )
    return best


def choose_length(organ: Organ, radius: float, length: float | None) -> float:
    """[m] Raises TruthError."""
    if length is None:
        assert organ.surface is not None
        edge = measure_edge(organ.surface.vertices, organ.surface.triangles)
        return float(np.clip(ELEMENTS * edge, LEAST * radius, MOST * radius))
    if not 0.0 < length <= MOST * radius:
        raise TruthError(
            f"length: got {1e3 * length:g} mm, expected one above 0 and up to "
            f"{1e3 * MOST * radius:g} mm, {MOST:g} radii of the ball"
        )
    return length


def measure_edge(x: Floats, triangles: Ints) -> float:
    """[m] The mean edge of a surface."""
    return float(np.linalg.norm(x[triangles] - x[np.roll(triangles, 1, axis=1)], axis=2).mean())


def list_directions(start: Place, toward: wanted.Point | None) -> list[Floats]:
    """Unit, along the surface. Raises TruthError."""
    if toward is None:
        side = np.eye(3)[np.abs(start.outward).argmin()]
        one = np.cross(start.outward, side)
        one /= np.linalg.norm(one)
        other = np.cross(start.outward, one)
        angles = 2.0 * np.pi * np.arange(WAYS) / WAYS
        return [np.cos(angle) * one + np.sin(angle) * other for angle in angles]
    away = np.asarray(toward, dtype=float) - start.point
    ahead = away - (away @ start.outward) * start.outward
    # a point over the beginning is beside it by rounding alone
    if not np.linalg.norm(ahead) > max(0.1 * float(np.linalg.norm(away)), 1e-6):
        raise TruthError("drag: got a point over its beginning to head for, expected one beside it")
    return [ahead / np.linalg.norm(ahead)]


def follow_script(
    subject: Subject, radius: float, path: wanted.Script
) -> tuple[list[Place], float]:
    """The places under a hand's way, and how deep [m] it goes at most. Raises TruthError."""
    ground = Ground(subject)
    if any(frame.buttons for frame in path.frames):
        raise TruthError("script: got one that takes hold, expected one that only presses")
    passed: list[Place] = []
    deepest = 0.0
    for centre in list_centres(path.frames):
        place = ground.find(centre)
        depth = radius - float((centre - place.point) @ place.outward)
        if depth > 0.0:
            passed.append(place)
            deepest = max(deepest, depth)
    if not passed:
        raise TruthError("script: got one that touches nothing, expected one that presses")
    return thin_out(passed, radius), deepest


def thin_out(passed: list[Place], radius: float) -> list[Place]:
    """A place every radius of the way, or as many as may be, with the last."""
    points = np.array([place.point for place in passed])
    gone = np.cumsum([0.0, *(float(np.linalg.norm(b - a)) for a, b in pairwise(points))])
    count = int(np.clip(np.ceil(gone[-1] / radius), 0, MOST_STATIONS - 1))
    if gone[-1] < 0.1 * radius:
        return [passed[-1]]
    wanted_at = np.linspace(0.0, gone[-1], count + 1)
    return [passed[int(np.abs(gone - at).argmin())] for at in wanted_at]
