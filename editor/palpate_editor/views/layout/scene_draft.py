# SPDX-License-Identifier: GPL-3.0-or-later
"""The judged task of a layout, as lists and forms read it and change it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from palpate.assessment import author
from palpate.assessment.author import AuthorError, Json, make_ids
from palpate.layout.document import Layout
from palpate.layout.task import begin_task, set_task
from palpate.scene.instrument_kinds import KINDS
from PySide6.QtCore import QObject

from palpate_editor.layout_shapes import Key, PartShape, find_middle, key_of
from palpate_editor.views.layout.layout_session import LayoutSession
from palpate_editor.views.scenario.task_draft import TaskDraft, round_point
from palpate_editor.views.scenario.verb_words import say_place
from palpate_editor.views.translations import tr

AROUND, INTO, ABOVE = 0.03, 0.02, 0.01
"""[m] Radius of a new space that an object is taken out of, of one that it is carried into, and of
that over the middle of the scenery."""


class SceneDraft(TaskDraft):
    """Regions are organ/region, the organ by the id of its name. Every change is a step of the
    layout's history."""

    records = False

    def __init__(
        self,
        session: LayoutSession,
        tell: Callable[[str], None],
        log: Callable[[list[str]], None],
        parent: QObject | None = None,
    ):
        super().__init__(parent)
        self.session = session
        self.shapes: dict[Key, PartShape] = {}
        self._tell, self._log = tell, log

    def show_layout(self, shapes: dict[Key, PartShape]) -> None:
        """The task of the layout as it is."""
        self.shapes = shapes
        self.show_assessment(self.session.layout.assessment)

    # ------------------------------------------------------------ the layout's

    @property
    def layout(self) -> Layout:
        return self.session.layout

    @property
    def regions(self) -> list[str]:
        names = make_ids(body.name for body in self.layout.bodies)
        return [
            f"{name}/{region}"
            for name, body in zip(names, self.layout.bodies, strict=True)
            if key_of(body) in self.shapes
            for region in self.shapes[key_of(body)].regions
        ]

    @property
    def usual_friction(self) -> float:
        tools = self.layout.tools
        return float(tools[0].friction if tools else KINDS["grasper"].friction)

    @property
    def own_words(self) -> str:
        return tr("as in the scene")

    @property
    def verbs(self) -> list[str]:
        """No line is drawn on a scene yet."""
        used = {step.get("do") for step in self.steps}
        return [verb for verb in super().verbs if verb != "trace" or verb in used]

    @property
    def objects(self) -> list[str]:
        return [] if self.assessment is None else list(self.assessment.get("objects", {}))

    def of_region(self, region: str) -> Json:
        return {"region": region}

    def name_region(self, place: Json) -> str:
        return str(place.get("region", ""))

    def of_point(self, body: int, point: np.ndarray) -> Json:
        """A ball around a point [m] of a body."""
        return self.of_ball_at(make_ids(each.name for each in self.layout.bodies)[body], point)

    def say_place(self, place: Json) -> str:
        return f"region:{place['region']}" if "region" in place else say_place(place)

    def begin(self) -> None:
        made = begin_task(self.layout)
        if self.keep(made, "new"):
            scene = self.session.path.name.removesuffix(".json").removesuffix(".layout")
            titles = [
                f"{option}={made['texts'][code]['title']}"
                for option, code in (("--title", "en"), ("--title-tr", "tr"))
            ]
            words = [f"{scene}.palpate", *titles, "-o", self.file]
            self._log(["palpate", "scenario", "new", *words])
            self.log_taken()

    def remove(self) -> None:
        """It is a scene to feel again."""
        self.session.apply(set_task(self.layout, None))
        self._log(["palpate", "scene", "task", str(self.session.path), "--remove"])

    # ------------------------------------------------------------ usual places

    def find_usual_place(self, verb: str) -> tuple[Json, str]:
        """That of the step that is looked at, else the first object or region."""
        assert self.assessment is not None
        moves = verb in author.SPACES or verb in author.SEEING
        known = self.places.get(str((self.step or {}).get("at")))
        if known is not None and ("object" in known or not moves):
            return author.add_place(self.assessment, str((self.step or {})["at"]), known)
        if self.objects and (moves or verb in author.HOLDING):
            name = self.objects[0]
            return author.add_place(self.assessment, name, {"object": name})
        if self.regions:
            region = self.regions[0]
            return author.add_place(self.assessment, region, self.of_region(region))
        if not self.layout.bodies or key_of(self.layout.bodies[0]) not in self.shapes:
            raise AuthorError(tr("The scene is being read: try again."))
        body = self.layout.bodies[0]
        point = find_middle(self.shapes[key_of(body)], body)
        return author.add_place(self.assessment, "spot", self.of_point(0, point))

    def find_usual_space(self, made: Json, verb: str) -> tuple[Json, str | None]:
        """Around the stone where it begins, or over the scenery."""
        if verb not in author.SPACES:
            return made, None
        carries, layout = verb == "carry", self.layout
        centre = np.asarray(layout.stones[0].position) if layout.stones else np.zeros(3)
        scenery = [part for part in layout.scenery if key_of(part) in self.shapes]
        if carries and scenery:
            centre = find_middle(self.shapes[key_of(scenery[0])], scenery[0]) + (0.0, 0.0, ABOVE)
        space = [*round_point(centre), INTO if carries else AROUND]
        return author.add_place(made, "into" if carries else "around", {"space": space})

    def find_space(self) -> list[float] | None:
        """[m] Centre and radius of the space of the step that is looked at; None of other steps."""
        step = self.step or {}
        member = author.SPACES.get(str(step.get("do")), "")
        space = self.places.get(str(step.get(member)), {}).get("space")
        is_told = isinstance(space, list) and all(not isinstance(each, str) for each in space)
        return list(space) if is_told else None

    def set_space(self, space: list[float]) -> None:
        """Of that name, in all steps that are there."""
        if self.assessment is None or self.step is None:
            return
        name, place = str(self.step[author.SPACES[str(self.step["do"])]]), {"space": space}
        self.keep({**self.assessment, "places": {**self.places, name: place}}, "space")
        self.log("place", "--set", name, "--at", self.say_place(place))
        self.log_taken()

    # ------------------------------------------------------------ changing

    @property
    def file(self) -> str:
        """What the command lines call the assessment."""
        name = self.session.path.name.removesuffix(".json").removesuffix(".layout")
        return f"{name}.task.json"

    def keep(self, changed: Json, change: str) -> bool:
        del change
        self.session.apply(set_task(self.layout, changed))
        return True

    def tell(self, sentence: str) -> None:
        self._tell(sentence)

    def log(self, verb: object, *words: object) -> None:
        self._log(["palpate", "scenario", str(verb), self.file, *map(str, words)])
        if verb != "place":
            self.log_taken()

    def log_taken(self) -> None:
        self._log(["palpate", "scene", "task", str(self.session.path), self.file])
