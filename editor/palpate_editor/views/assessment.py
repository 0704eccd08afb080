# SPDX-License-Identifier: GPL-3.0-or-later
"""What is good and bad about the open organ, worked out beside the window.

Inspecting a surface and building a tissue take up to seconds for a large organ, so both are done
in a thread after every change; what did not change is not done again.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import palpate
from PySide6.QtCore import QObject, QTimer, Signal

from palpate_editor import authoring, check
from palpate_editor.app.session import Session
from palpate_editor.compile import mesh_of
from palpate_editor.document import Organ, Surface
from palpate_editor.document.cost_rules import compute_tick_share
from palpate_editor.document.problems import Problem, TissueFacts
from palpate_editor.views.jobs import Jobs, Progress
from palpate_editor.views.translations import say_memory, tr

PATIENCE = 60
"""[ms] without a change before work begins: a stroke of the keyboard is not yet a decision."""
MOST_POINTS = 20_000
"""Of a large source that are measured; the colours would not look different with more."""


@dataclass(frozen=True)
class Comparison:
    """A surface beside the imported one."""

    imported_angle: float
    """[degree] smallest of the imported surface."""
    distances: np.ndarray | None
    """[m] (n,) at each vertex, how far the imported surface lies from this one around it; None
    where they are one."""


@dataclass(frozen=True, eq=False)
class Assessment:
    """All that the window says about one organ."""

    checked: check.Assessment
    comparison: Comparison | None
    """None where there is no surface."""
    tick_share: float | None
    """[-] of a tick that the tissue takes on the reference machine."""

    @property
    def organ(self) -> Organ:
        return self.checked.organ

    @property
    def scene(self) -> palpate.Scene | None:
        return self.checked.scene

    @property
    def report(self) -> authoring.MeshReport | None:
        """Of the surface."""
        return self.checked.report

    @property
    def tissue(self) -> TissueFacts | None:
        """What came of building the tissue; None where there is nothing to build it on."""
        return self.checked.facts.tissue

    @property
    def problems(self) -> tuple[Problem, ...]:
        """Of an organ; an empty document has none, it has only not begun."""
        return () if self.organ.surface is None else self.checked.problems

    def of_stage(self, stage: str) -> list[Problem]:
        return [problem for problem in self.problems if problem.stage == stage]


def assess(
    organ: Organ,
    tested: bool,
    before: Assessment | None,
    measured: Callable[[palpate.ResponseSize], None] | None = None,
) -> Assessment:
    """Finds everything out, on any thread; what `before` knows is used again where it holds.

    `measured` is told what memory a response will take, before it is solved for.
    """
    checked = check.assess(
        organ, tested=tested, before=before.checked if before else None, measured=measured
    )
    share = compute_tick_share(organ, checked.facts)
    same = (
        before is not None
        and before.organ.surface is organ.surface
        and before.organ.imported is organ.imported
    )
    comparison = before.comparison if before is not None and same else compare(organ)
    return Assessment(checked, comparison, share)


def compare(organ: Organ) -> Comparison | None:
    surface = organ.surface
    if surface is None:
        return None
    source = surface if organ.imported is None else organ.imported
    angle = float(np.degrees(palpate.compute_smallest_angle(mesh_of(source))))
    return Comparison(angle, None if source is surface else measure_distances(surface, source))


def measure_distances(surface: Surface, source: Surface) -> np.ndarray:
    """[m] (n,) the largest distance of those points of the source that lie over the triangles of a
    vertex. The vertices themselves lie on the source, so their own distance would say nothing.
    """
    x, triangles = surface.vertices, surface.triangles
    tree = palpate.AabbTree(x, triangles)
    points = source.vertices[:: max(1, len(source.vertices) // MOST_POINTS)]
    found = [palpate.find_closest_point(tree, x, point) for point in points]
    corners = triangles[[near.triangle for near in found]]
    distances = np.zeros(len(x))
    np.maximum.at(distances, corners.ravel(), np.repeat([near.distance for near in found], 3))
    return distances


@dataclass(frozen=True, eq=False)
class AssessWork:
    """The work of one assessment."""

    organ: Organ
    tested: bool
    before: Assessment | None

    def __call__(self, progress: Progress) -> Assessment:
        progress("", 0.0)

        def tell(size: palpate.ResponseSize) -> None:
            if size.bytes > palpate.MOST_RESPONSE_BYTES:
                return  # and a check says so
            text = tr("{memory}, being solved for").format(memory=say_memory(size))
            progress(text, 0.5)

        return assess(self.organ, self.tested, self.before, tell)


class Assessor(QObject):
    """Keeps the newest assessment of a session's organ."""

    assessed = Signal()
    said = Signal(str)
    """What is being built now, where that takes its time."""

    def __init__(self, session: Session, jobs: Jobs, parent: QObject | None = None):
        super().__init__(parent)
        self.session, self.jobs = session, jobs
        self.assessment: Assessment | None = None
        self.busy = False
        self.assessed_tested = False
        self.timer = QTimer(self, singleShot=True, interval=PATIENCE)
        self.timer.timeout.connect(self.begin)
        session.changed.connect(self.on_changed)
        self.timer.start()

    def on_changed(self, before: Organ, after: Organ) -> None:
        del before, after
        self.timer.start()

    def begin(self) -> None:
        """Starts assessing the open organ, unless that is under way."""
        if self.busy or self.jobs.closed:
            return
        self.busy = True
        self.assessed_tested = self.session.is_tested
        work = AssessWork(self.session.organ, self.assessed_tested, self.assessment)
        job = self.jobs.start_unseen("assessment", work, self.finish, self.give_up)
        if job is not None:
            job.progressed.connect(self.tell)

    def tell(self, text: str, share: float) -> None:
        del share
        if text:
            self.said.emit(text)

    def finish(self, assessment: Assessment) -> None:
        self.busy = False
        self.assessment = assessment
        if not self.is_current:
            self.begin()
        self.assessed.emit()

    def give_up(self, problem: BaseException) -> None:
        self.busy = False
        raise problem

    @property
    def is_current(self) -> bool:
        """Whether the open organ is the one that was assessed, and as felt as it is."""
        return (
            self.assessment is not None
            and self.assessment.organ is self.session.organ
            and self.assessed_tested == self.session.is_tested
        )
