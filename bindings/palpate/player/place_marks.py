# SPDX-License-Identifier: BSD-3-Clause
"""Where the steps that are to be done now are: a ring round each place, on the tissue.

What is to be found is never marked.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.assessment.organ_surface import OrganSurface
from palpate.player.style import ACCENTS
from palpate.render import Appearance, Shape
from palpate.render.hard_parts import Pose
from palpate.runs.live import Frame
from palpate.runs.pinch import LEAST_PINCH
from palpate.runs.play import Play
from palpate.viewport import View
from palpate.viewport.draped_line import Drape, DrapedLine
from palpate.viewport.ring import build_ring

LEAST, MOST = 0.004, 0.015
"""[m] radius of a ring"""
THICKNESS = 0.011
"""[-] radius of its tube, in radii of the surfaces"""
THIN = 0.06
"""[-] radius of the tube of a ring beside tissue, in that of the ring: a lens may be close to it"""
ROUND = 1.5
"""[-] radius of the ring round a rigid body, in that of the body"""
MARK = Appearance(gloss=0.0, subsurface=0.0, seen_through=True, ghost=0.45, casts_shadow=False)
"""In the accent of the theme."""


@dataclass(frozen=True)
class OnTissue:
    """The mark of a place on an organ."""

    body: int
    ring: DrapedLine
    path: DrapedLine | None
    """All of a path; its ring is round its beginning."""


@dataclass(frozen=True)
class Beside:
    """The mark of a rigid body, or of a space that stands still."""

    rigid: int
    """-1: a space"""
    centre: NDArray[np.float64]
    """[m] of a space"""
    radius: float
    """[m] of its ring"""


Mark = OnTissue | Beside


class PlaceMarks:
    """Draws them in the view of a trainee."""

    def __init__(self, view: View, play: Play):
        self._view, self._play = view, play
        self._appearance = MARK
        self._drawn: palpate.scenario.DrawnTask | None = None
        self._steps: tuple[palpate.TaskStep, ...] = ()
        self._marks: dict[int, Mark] = {}
        self._shown: dict[str, Shape] = {}

    def show(self, frame: Frame) -> None:
        """Those of the steps that are open in a frame, on the tissue as it is there."""
        active = [
            number
            for number, step in enumerate(frame.task.steps)
            if step.status is palpate.StepStatus.active
        ]
        holding = frozenset(
            index for index, one in enumerate(frame.instruments) if one.pinch >= LEAST_PINCH
        )
        self._show(active, frame.positions, frame.rigid, holding)

    def show_first(self) -> None:
        """Those of the steps with which an attempt begins, on the tissue at rest."""
        if self._play.drawn is None:
            self.clear()
            return
        task = self._play.drawn.task
        first = [number for number, step in enumerate(task.steps) if not step.after]
        rest = [np.asarray(surface.vertices) for surface in task.surfaces]
        self._show(first, rest, self._play.scenario.scene.rigid)

    def clear(self) -> None:
        self._draw({})

    def use_theme(self, name: str) -> None:
        """dark or light."""
        self._appearance = replace(MARK, colour=ACCENTS[name].accent)
        self._draw(self._shown)

    def _show(
        self,
        active: Sequence[int],
        positions: Sequence[ArrayLike],
        rigid: Sequence[Pose],
        holding: Collection[int] = (),
    ) -> None:
        drawn = self._play.drawn
        if drawn is not self._drawn:
            self._drawn, self._marks = drawn, {}
            self._steps = () if drawn is None else drawn.task.steps
        thickness, shapes = self._find_thickness(), dict[str, Shape]()
        for number, traced in list_marked([self._steps[each] for each in active], holding).items():
            mark = self._find_mark(number)
            if isinstance(mark, Beside):
                shapes[f"place {number}"] = self._build_beside(mark, rigid)
                continue
            shapes[f"place {number}"] = mark.ring.build(positions[mark.body], thickness)
            if traced and mark.path is not None:
                shapes[f"path {number}"] = mark.path.build(positions[mark.body], thickness / 2)
        self._draw(shapes)

    def _draw(self, shapes: dict[str, Shape]) -> None:
        for name in self._shown.keys() - shapes.keys():
            self._view.hide_part(name)
        for name, shape in shapes.items():
            self._view.show_part(name, shape, self._appearance)
        self._shown = shapes

    def _find_thickness(self) -> float:
        """[m]"""
        return THICKNESS * self._view.scenery.radius

    def _find_mark(self, place: int) -> Mark:
        """Built once for each place of an attempt."""
        if place not in self._marks:
            assert self._drawn is not None
            self._marks[place] = build_mark(self._drawn.task, place)
        return self._marks[place]

    def _build_beside(self, mark: Beside, rigid: Sequence[Pose]) -> Shape:
        """Turned to the eye."""
        centre = mark.centre if mark.rigid < 0 else np.array(rigid[mark.rigid].position)
        towards = self._view.seen_from.eye() - centre
        return build_ring(centre, towards, mark.radius, THIN * mark.radius)


def list_marked(
    steps: Sequence[palpate.TaskStep], holding: Collection[int] = ()
) -> dict[int, bool]:
    """The places of steps, and of each whether its path is to be traced. What jaws have taken
    needs none, and would draw it in between them: `holding` are the instruments that have."""
    marked: dict[int, bool] = {}
    for step in steps:
        if step.verb is palpate.TaskVerb.find:
            continue
        into = step.space if step.verb is palpate.TaskVerb.carry else -1
        for place in (-1 if step.instrument in holding else step.place, into):
            if place >= 0:
                traced = step.verb is palpate.TaskVerb.trace
                marked[place] = marked.get(place, False) or traced
    return marked


def build_mark(task: palpate.Task, number: int) -> Mark:
    """Of a place of a task."""
    place, kinds = task.places[number], palpate.PlaceKind
    if place.kind is kinds.space:
        return Beside(-1, np.array(place.points[0]), clamp(place.radius))
    if place.kind is kinds.object:
        (body,) = (each for each in task.objects if each.rigid == place.body)
        reach = float(np.linalg.norm(body.vertices, axis=1).max())
        return Beside(place.body, np.zeros(3), clamp(ROUND * reach))
    surface = task.surfaces[place.body]
    drape = Drape(surface.vertices, surface.triangles)
    if place.kind is kinds.region:
        middle, radius = measure_region(task, place)
    else:
        middle, radius = np.asarray(place.points[0]), place.radius
    ring = drape.lay_ring(middle, clamp(radius))
    path = drape.lay_path(place.points) if place.kind is kinds.path else None
    return OnTissue(place.body, ring, path)


def clamp(radius: float) -> float:
    return min(max(radius, LEAST), MOST)


def measure_region(
    task: palpate.Task, place: palpate.TaskPlace
) -> tuple[NDArray[np.float64], float]:
    """[m] The point of a region that lies farthest inside, and how far it is from what does not
    belong to it."""
    surface = OrganSurface(task, LEAST)
    anchor, _ = surface.find_anchor(place)
    outside = ~np.asarray(place.members, dtype=bool) & surface.outer[place.body]
    others = surface.vertices[place.body][outside]
    if not len(others):
        return anchor, MOST
    return anchor, float(np.linalg.norm(others - anchor, axis=1).min())
