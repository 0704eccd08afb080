# SPDX-License-Identifier: GPL-3.0-or-later
"""Places of a task in the picture of a scene: that of the chosen step, and its space."""

from __future__ import annotations

import numpy as np
from palpate.assessment.author import SPACES, Json, make_ids
from palpate.layout.placed import move_points
from palpate.render import Appearance, Shape, build_sphere
from palpate.viewport import View
from palpate.viewport.ring import build_ring
from PySide6.QtCore import QObject

from palpate_editor.layout_shapes import key_of
from palpate_editor.views.layout.scene_draft import SceneDraft

PLACE = Appearance((0.1, 0.75, 0.95), gloss=0.0, seen_through=True, ghost=0.5, casts_shadow=False)
SPACE = Appearance((0.3, 0.8, 0.45), gloss=0.0, seen_through=True, ghost=0.25, casts_shadow=False)
DOT = 0.0015
"""[m] Radius of the mark of a place."""
THIN = 0.01
"""[-] Of a ball's radius: of the rings that outline it."""


class TaskMarks(QObject):
    """Paints them while the task is shown."""

    def __init__(self, draft: SceneDraft, view: View, parent: QObject | None = None):
        super().__init__(parent)
        self.draft, self.view, self.seen = draft, view, False
        draft.shown.connect(self.show)

    def see(self, seen: bool) -> None:
        self.seen = seen
        self.show()

    def show(self) -> None:
        step = self.draft.step or {}
        place = self.draft.places.get(str(step.get("at")), {})
        space = self.draft.places.get(str(step.get(SPACES.get(str(step.get("do")), ""))), {})
        for name, appearance, shape in (
            ("task place", PLACE, self.find_place(place)),
            ("task space", SPACE, find_ball(space.get("space"))),
        ):
            self.view.show_part(name, shape if self.seen else None, appearance)

    def find_place(self, place: Json) -> Shape | None:
        if "region" in place:
            return self.find_region(str(place["region"]))
        if "object" in place:
            names = make_ids(stone.name for stone in self.draft.layout.stones)
            if place["object"] in names:
                stone = self.draft.layout.stones[names.index(place["object"])]
                return build_sphere(np.asarray(stone.position), 4.0 * DOT)
        return find_ball(place.get("ball") or place.get("space"))

    def find_region(self, told: str) -> Shape | None:
        """A dot in the middle of the region, on the surface."""
        organ, _, region = told.partition("/")
        layout = self.draft.layout
        names = make_ids(body.name for body in layout.bodies)
        if organ not in names:
            return None
        body = layout.bodies[names.index(organ)]
        shape = self.draft.shapes.get(key_of(body))
        rows = None if shape is None else shape.region_rows.get(region)
        if shape is None or rows is None or not len(rows):
            return None
        points = move_points(body, shape.x[rows])
        nearest = np.linalg.norm(points - points.mean(axis=0), axis=1).argmin()
        return build_sphere(points[nearest], 2.0 * DOT)


def find_ball(numbers: object) -> Shape | None:
    """Its outline, three rings that hide nothing; None of numbers that a parameter says."""
    if not isinstance(numbers, list) or any(isinstance(each, str) for each in numbers):
        return None
    *centre, radius = numbers
    rings = [build_ring(centre, axis, float(radius), THIN * float(radius)) for axis in np.eye(3)]
    first = np.cumsum([0, *(len(ring.vertices) for ring in rings)]).astype(np.uint32)
    return Shape(
        np.vstack([ring.vertices for ring in rings]),
        np.vstack([ring.normals for ring in rings]),
        np.vstack([ring.triangles + n for ring, n in zip(rings, first, strict=False)]),
    )
