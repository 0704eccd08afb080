# SPDX-License-Identifier: GPL-3.0-or-later
"""The assessment of the open organ, as panels read it and change it. Each change is one edit."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from palpate.assessment import author
from palpate.assessment.author import AuthorError, Json
from PySide6.QtCore import QObject, Signal

from palpate_editor.document import Organ
from palpate_editor.document.files import write_assessment
from palpate_editor.edits import SetAssessment
from palpate_editor.surface_path import follow_surface
from palpate_editor.views.context import Context
from palpate_editor.views.scenario.verb_words import find_words, list_new_places, say_place
from palpate_editor.views.translations import tr

BALL = 0.01
"""[m] Radius of a place that is clicked."""
MOST_HELD = 0.2
"""[-] of a region that is held at rest: more of it nobody is asked to touch first."""


class Draft(QObject):
    """Reads and changes what stands in the organ; remembers which step is looked at."""

    shown = Signal()
    """Another assessment, or another step."""

    def __init__(self, context: Context, parent: QObject | None = None):
        super().__init__(parent)
        self.context = context
        self.assessment: Json | None = None
        self.step_id = ""
        self.level, self.seed = "", 0
        self._text = ""

    def show_organ(self, organ: Organ) -> None:
        if organ.assessment != self._text:
            self._text = organ.assessment
            self.assessment = json.loads(organ.assessment) if organ.assessment else None
        ids = [step["id"] for step in self.steps]
        if self.step_id not in ids:
            self.step_id = ids[-1] if ids else ""
        if self.level not in ["", *self.levels]:
            self.level = ""
        self.shown.emit()

    # ------------------------------------------------------------ reading

    @property
    def steps(self) -> list[Json]:
        return self.rows("steps")

    @property
    def limits(self) -> list[Json]:
        return self.rows("limits")

    @property
    def levels(self) -> list[str]:
        return [] if self.assessment is None else list(self.assessment.get("levels", []))

    def rows(self, name: str) -> list[Json]:
        found = [] if self.assessment is None else self.assessment.get(name, [])
        return [row for row in found if isinstance(row, dict) and "id" in row]

    @property
    def step(self) -> Json | None:
        """The one that is looked at."""
        return next((step for step in self.steps if step["id"] == self.step_id), None)

    @property
    def places(self) -> dict[str, Json]:
        return {} if self.assessment is None else dict(self.assessment.get("places", {}))

    @property
    def tools(self) -> dict[str, Json]:
        """The instruments by name, in their order."""
        said = {} if self.assessment is None else self.assessment.get("tools", {})
        return dict(sorted(said.items(), key=lambda item: item[1].get("instrument", 0)))

    @property
    def verbs(self) -> list[str]:
        """What can be asked for: objects are moved where there are some."""
        objects = {} if self.assessment is None else self.assessment.get("objects", {})
        used = {step.get("do") for step in self.steps}
        return [
            verb for verb in author.VERBS if objects or verb in used or verb not in author.SPACES
        ]

    @property
    def organ_id(self) -> str:
        assert self.assessment is not None
        return next(iter(self.assessment["organs"]))

    def choose(self, identity: str) -> None:
        """Another step is looked at."""
        if identity != self.step_id:
            self.step_id = identity
            self.shown.emit()

    # ------------------------------------------------------------ changing

    def apply(self, changed: Json, change: str, *words: object) -> bool:
        """One edit; `words` are those of the verb that does the same to a file."""
        if changed == self.assessment:
            return True
        before = self.assessment
        done = self.context.apply(SetAssessment(write_assessment(changed), change))
        if done and words:
            for name, place in list_new_places(before, changed):
                self.log("place", "--set", name, "--at", say_place(place))
            self.log(*words)
        return done

    def log(self, verb: object, *words: object) -> None:
        """The same on the command line: `palpate scenario VERB FILE ...`."""
        name = f"{self.context.stem()}.task.json"
        self.context.log_command(["palpate", "scenario", verb, name, *words])

    def change(self, change: str, act: Any, *arguments: Any) -> Any:
        """Applies a function of palpate.assessment.author; what it says of a new row comes back."""
        assert self.assessment is not None
        try:
            made = act(self.assessment, *arguments)
        except AuthorError as problem:
            self.context.tell(str(problem))
            return None
        made, identity = made if isinstance(made, tuple) else (made, None)
        words = find_words(act, arguments)
        return identity if self.apply(made, change, *words) else None

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

    def add_step(self, verb: str) -> None:
        """At the place of the step that is looked at, else at the first region, else on top."""
        if self.assessment is None:
            self.begin()
        assert self.assessment is not None
        made, at = self.assessment, None
        if verb != "release":
            made, at = self.find_usual_place(verb)
        space = next((name for name, row in self.places.items() if "space" in row), None)
        moves = verb in author.SPACES and space is not None
        try:
            values = {author.SPACES[verb]: space} if moves else {}
            made, identity = author.add_step(made, verb, at, values)
        except AuthorError as problem:  # objects are moved out of a space or into one
            self.context.tell(str(problem))
            return
        self.step_id = identity
        words = [] if at is None else ["--at", at]
        words += ["--space", str(space)] if moves else []
        self.apply(made, "step", "step", "--add", verb, *words)

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

    def of_region(self, region: str) -> Json:
        return {"region": f"{self.organ_id}/{region}"}

    def of_ball(self, point: np.ndarray, radius: float = BALL) -> Json:
        return {"organ": self.organ_id, "ball": [*round_point(point), radius]}

    def set_place(self, name: str, place: Json) -> None:
        """The step that is looked at is there; a place that nothing names any more goes."""
        if self.assessment is None or self.step is None:
            return
        made, at = author.add_place(self.assessment, name, place)
        self.set_at(made, at)

    def set_at(self, made: Json, at: str) -> None:
        made = author.change_step(made, self.step_id, {"at": at})
        made = author.remove_unused_places(made)
        self.apply(made, "place", "step", "--change", self.step_id, "--at", at)

    def set_step(self, values: dict[str, Any], change: str = "change") -> None:
        """Other values of the step that is looked at."""
        if self.step is not None:
            self.change(change, author.change_step, self.step_id, values)

    def name_place(self, at: str) -> str:
        """As the designer knows it."""
        place = self.places.get(at, {})
        if "region" in place:
            return str(place["region"]).partition("/")[2]
        kinds = {"path": tr("line"), "object": tr("object"), "space": tr("space")}
        kind = next((word for key, word in kinds.items() if key in place), tr("ball"))
        return f"{at} ({kind})"


def find_vertex(vertices: np.ndarray, point: np.ndarray) -> np.ndarray:
    return np.asarray(vertices[int(((vertices - point) ** 2).sum(axis=1).argmin())])


def round_point(point: np.ndarray) -> list[float]:
    """[m] To a hundredth of a millimetre: nobody clicks nearer."""
    return [round(float(value), 5) for value in point]
