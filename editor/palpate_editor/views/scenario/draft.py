# SPDX-License-Identifier: GPL-3.0-or-later
"""The assessment of the open organ, as panels read it and change it."""

from __future__ import annotations

import numpy as np
from palpate.assessment import author
from palpate.assessment.author import Json
from PySide6.QtCore import QObject

from palpate_editor.document import Organ
from palpate_editor.document.files import write_assessment
from palpate_editor.edits import SetAssessment
from palpate_editor.surface_path import follow_surface
from palpate_editor.views.context import Context
from palpate_editor.views.scenario.task_draft import BALL, TaskDraft, round_point
from palpate_editor.views.translations import tr

MOST_HELD = 0.2
"""[-] of a region that is held at rest: more of it nobody is asked to touch first."""


class Draft(TaskDraft):
    """Reads and changes what stands in the organ."""

    def __init__(self, context: Context, parent: QObject | None = None):
        super().__init__(parent)
        self.context = context

    def show_organ(self, organ: Organ) -> None:
        self.show_assessment(organ.assessment)

    @property
    def regions(self) -> list[str]:
        return list(self.context.session.organ.regions)

    @property
    def usual_friction(self) -> float:
        return float(self.context.session.organ.tool.friction)

    @property
    def own_words(self) -> str:
        return tr("as in Material")

    @property
    def organ_id(self) -> str:
        assert self.assessment is not None
        return next(iter(self.assessment["organs"]))

    def of_region(self, region: str) -> Json:
        return {"region": f"{self.organ_id}/{region}"}

    def name_region(self, place: Json) -> str:
        return str(place.get("region", "")).partition("/")[2]

    def keep(self, changed: Json, change: str) -> bool:
        return self.context.apply(SetAssessment(write_assessment(changed), change))

    def tell(self, sentence: str) -> None:
        self.context.tell(sentence)

    def log(self, verb: object, *words: object) -> None:
        """The same on the command line: `palpate scenario VERB FILE ...`."""
        name = f"{self.context.stem()}.task.json"
        self.context.log_command(["palpate", "scenario", verb, name, *words])

    def begin(self) -> None:
        """A new one, in the languages of the organ's titles."""
        organ = self.context.session.organ
        name = organ.title or organ.name or "Organ"
        said = organ.languages.get("tr")
        titles = {"en": name, "tr": said.title if said is not None and said.title else name}
        made = author.new_assessment(organ.name or "organ", titles)
        self.apply(made, "new")
        stem = self.context.stem()
        words = ["palpate", "scenario", "new", f"{stem}.palpate", f"--title={name}"]
        self.context.log_command([*words, "-o", f"{stem}.task.json"])

    def find_usual_place(self, verb: str) -> tuple[Json, str]:
        assert self.assessment is not None
        known = self.step.get("at") if self.step is not None else None
        is_path = known in self.places and "path" in self.places[known]
        if known is not None and (verb != "trace" or is_path):
            return self.assessment, str(known)
        organ = self.context.session.organ
        top = self.find_top()
        if verb == "trace":
            side = np.array([0.02, 0.0, 0.0])
            surface = self.context.session.organ.surface
            corners = np.array([top - side, top + side])
            if surface is not None:
                corners = np.array([find_vertex(surface.vertices, c) for c in corners])
                corners = follow_surface(surface, corners)
            path = [round_point(point) for point in corners]
            return author.add_place(self.assessment, "line", {"organ": self.organ_id, "path": path})
        for region in organ.regions:
            if organ.fixed[organ.regions[region]].mean() < MOST_HELD:
                return author.add_place(self.assessment, region, self.of_region(region))
        return author.add_place(self.assessment, "spot", self.of_ball(top))

    def find_top(self) -> np.ndarray:
        surface = self.context.session.organ.surface
        if surface is None:
            return np.zeros(3)
        return np.asarray(surface.vertices[int(surface.vertices[:, 2].argmax())])

    def of_ball(self, point: np.ndarray, radius: float = BALL) -> Json:
        return self.of_ball_at(self.organ_id, point, radius)


def find_vertex(vertices: np.ndarray, point: np.ndarray) -> np.ndarray:
    return np.asarray(vertices[int(((vertices - point) ** 2).sum(axis=1).argmin())])
