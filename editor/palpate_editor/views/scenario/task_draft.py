# SPDX-License-Identifier: GPL-3.0-or-later
"""The assessment of what is open, as lists and forms read it and change it."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from palpate.assessment import author
from palpate.assessment.author import AuthorError, Json
from PySide6.QtCore import QObject, Signal

from palpate_editor.views.scenario.verb_words import find_words, list_new_places, say_place
from palpate_editor.views.translations import tr

BALL = 0.01
"""[m] Radius of a place that is clicked."""

OF_WHAT = "TaskDraft: got no document, expected one of the drafts that know theirs"


class TaskDraft(QObject):
    """Remembers which step is looked at. Each change is one edit of what the task is kept in, an
    organ or a layout, which subclasses know."""

    shown = Signal()
    """Another assessment, or another step."""

    records = True
    """Whether bands can be taken from a hand, and lines be drawn."""

    def __init__(self, parent: QObject | None = None):
        super().__init__(parent)
        self.assessment: Json | None = None
        self._text = ""
        self.step_id = ""
        self.level, self.seed = "", 0

    def show_assessment(self, text: str) -> None:
        """What stands there now, as it is kept; empty: none."""
        if text != self._text:
            self._text = text
            self.assessment = json.loads(text) if text else None
        ids = [step["id"] for step in self.steps]
        if self.step_id not in ids:
            self.step_id = ids[-1] if ids else ""
        if self.level not in ["", *self.levels]:
            self.level = ""
        self.shown.emit()

    # ------------------------------------------------------------ of an organ or a layout

    @property
    def regions(self) -> list[str]:
        """As of_region() takes them."""
        raise TypeError(OF_WHAT)

    @property
    def usual_friction(self) -> float:
        """[-] Of an instrument that says none."""
        raise TypeError(OF_WHAT)

    @property
    def own_words(self) -> str:
        """Of an instrument whose shape the task does not say."""
        raise TypeError(OF_WHAT)

    def of_region(self, region: str) -> Json:
        """Its place."""
        raise TypeError(OF_WHAT)

    def name_region(self, place: Json) -> str:
        """The one of `regions` that a place is; empty of others."""
        raise TypeError(OF_WHAT)

    def begin(self) -> None:
        """An assessment without steps."""
        raise TypeError(OF_WHAT)

    def find_usual_place(self, verb: str) -> tuple[Json, str]:
        """Where a new step is, and the assessment with that place. Raises AuthorError."""
        raise TypeError(OF_WHAT)

    def say_place(self, place: Json) -> str:
        """As --at of the command line has it."""
        return say_place(place)

    def keep(self, changed: Json, change: str) -> bool:
        """One edit; False where it was refused."""
        raise TypeError(OF_WHAT)

    def tell(self, sentence: str) -> None:
        raise TypeError(OF_WHAT)

    def log(self, verb: object, *words: object) -> None:
        """The same on the command line: `palpate scenario VERB FILE ...`."""
        raise TypeError(OF_WHAT)

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
        done = self.keep(changed, change)
        if done and words:
            for name, place in list_new_places(before, changed):
                self.log("place", "--set", name, "--at", self.say_place(place))
            self.log(*words)
        return done

    def change(self, change: str, act: Any, *arguments: Any) -> Any:
        """Applies a function of palpate.assessment.author; what it says of a new row comes back."""
        assert self.assessment is not None
        try:
            made = act(self.assessment, *arguments)
        except AuthorError as problem:
            self.tell(str(problem))
            return None
        made, identity = made if isinstance(made, tuple) else (made, None)
        words = find_words(act, arguments)
        return identity if self.apply(made, change, *words) else None

    def add_step(self, verb: str) -> None:
        """At the place of the step that is looked at, else at the first region, else on top."""
        if self.assessment is None:
            self.begin()
        assert self.assessment is not None
        made, at = self.assessment, None
        try:
            if verb != "release":
                made, at = self.find_usual_place(verb)
            made, space = self.find_usual_space(made, verb)
            values = {} if space is None else {author.SPACES[verb]: space}
            made, identity = author.add_step(made, verb, at, values)
        except AuthorError as problem:  # objects are moved out of a space or into one
            self.tell(str(problem))
            return
        self.step_id = identity
        words = [] if at is None else ["--at", at]
        words += [] if space is None else ["--space", space]
        self.apply(made, "step", "step", "--add", verb, *words)

    def find_usual_space(self, made: Json, verb: str) -> tuple[Json, str | None]:
        """Out of or into which an object is moved; None where there is none yet."""
        if verb not in author.SPACES:
            return made, None
        places = made.get("places", {})
        return made, next((name for name, row in places.items() if "space" in row), None)

    @staticmethod
    def of_ball_at(organ: str, point: np.ndarray, radius: float = BALL) -> Json:
        return {"organ": organ, "ball": [*round_point(point), radius]}

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
            return self.name_region(place)
        kinds = {"path": tr("line"), "object": tr("object"), "space": tr("space")}
        kind = next((word for key, word in kinds.items() if key in place), tr("ball"))
        return f"{at} ({kind})"


def round_point(point: np.ndarray) -> list[float]:
    """[m] To a hundredth of a millimetre: nobody clicks nearer."""
    return [round(float(value), 5) for value in point]
