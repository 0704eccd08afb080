# SPDX-License-Identifier: GPL-3.0-or-later
"""Places on the organ in colour: that of the chosen step, the others, and what is forbidden."""

from __future__ import annotations

import numpy as np
from palpate.assessment.author import Json
from palpate.render import Appearance, Shape
from palpate.render.shapes import build_capsule
from PySide6.QtCore import QObject

from palpate_editor.document import Organ, Surface
from palpate_editor.views.problem_marks import build_shape
from palpate_editor.views.scenario.draft import Draft

TUBE = 0.0012
"""[m] Radius of a line."""


def colour(red: float, green: float, blue: float) -> Appearance:
    return Appearance((red, green, blue), gloss=0.1, subsurface=0.0, casts_shadow=False)


CHOSEN, OTHER, FORBIDDEN = colour(0.1, 0.75, 0.95), colour(0.3, 0.6, 0.45), colour(0.95, 0.2, 0.1)
NAMES = {"chosen": CHOSEN, "other": OTHER, "forbidden": FORBIDDEN}


class PlaceMarks(QObject):
    """Paints them while the stage is open."""

    def __init__(self, draft: Draft, stage: str, parent: QObject | None = None):
        super().__init__(parent)
        self.draft, self.stage = draft, stage
        self._shown: object = None
        draft.shown.connect(self.show)
        draft.context.stage_shown.connect(self.show)
        draft.context.preview_shown.connect(self.show)

    def show(self, *_: object) -> None:
        context = self.draft.context
        organ = context.session.organ
        seen = context.stage == self.stage and not context.previewing
        shown = (organ.surface, organ.assessment, self.draft.step_id) if seen else None
        if shown == self._shown:
            return
        self._shown = shown
        found = self.sort_places() if seen and organ.surface is not None else {}
        for name, appearance in NAMES.items():
            shapes = [shape for place in found.get(name, []) for shape in self.draw(organ, place)]
            context.view.show_part(f"places {name}", None, appearance)
            if shapes:
                context.view.show_part(f"places {name}", join(shapes), appearance)

    def sort_places(self) -> dict[str, list[Json]]:
        draft = self.draft
        places, step = draft.places, draft.step
        at = None if step is None else step.get("at")
        forbidden = {limit["when"].get("place") for limit in draft.limits}
        used = {each.get("at") for each in draft.steps} - {at} - forbidden
        return {
            "chosen": [places[at]] if at in places else [],
            "other": [places[name] for name in used if name in places],
            "forbidden": [places[name] for name in forbidden - {at} if name in places],
        }

    def draw(self, organ: Organ, place: Json) -> list[Shape]:
        assert organ.surface is not None
        if "path" in place:
            points = np.array(place["path"], dtype=float)
            return [
                build_capsule(a, b, TUBE, 8)
                for a, b in zip(points, points[1:], strict=False)
                if np.linalg.norm(b - a) > 0.0
            ]
        faces = find_faces(organ, organ.surface, place)
        return [build_shape(organ.surface, faces)] if len(faces) else []


def find_faces(organ: Organ, surface: Surface, place: Json) -> np.ndarray:
    """The triangles of a region, or within a ball."""
    inside = np.zeros(len(surface.vertices), bool)
    if "region" in place:
        region = str(place["region"]).partition("/")[2]
        if region in organ.regions:
            inside[organ.regions[region]] = True
    elif "ball" in place and all(not isinstance(value, str) for value in place["ball"]):
        *centre, radius = place["ball"]
        inside = np.linalg.norm(surface.vertices - np.array(centre), axis=1) <= radius
    return np.flatnonzero(inside[surface.triangles].all(axis=1))


def join(shapes: list[Shape]) -> Shape:
    offsets = np.cumsum([0, *(len(shape.vertices) for shape in shapes)])
    triangles = [s.triangles + o for s, o in zip(shapes, offsets[:-1], strict=True)]
    return Shape(
        np.concatenate([shape.vertices for shape in shapes]),
        np.concatenate([shape.normals for shape in shapes]),
        np.concatenate(triangles).astype(np.int32),
    )
