# SPDX-License-Identifier: GPL-3.0-or-later
"""Which constant and which element an alarm of a run is of, found beside the window."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import palpate
from numpy.typing import NDArray
from palpate.runs.cause import Cause, find_cause
from palpate.runs.element import Element, cut_hand, find_element

from palpate_editor.document import Surface
from palpate_editor.document.problems import Problem
from palpate_editor.views.jobs import Progress


@dataclass(frozen=True)
class CauseWork:
    """Of the alarm that ended a run, else of the first that a safeguard averted."""

    scene: palpate.Scene
    report: palpate.LoopReport
    hand: NDArray[np.void] | None
    """Record.hand up to the tick of the alarm."""

    def __call__(
        self, progress: Progress
    ) -> tuple[palpate.LoopReport, Cause | None, Element | None]:
        del progress
        report = self.report
        ended = has_ended(report)
        alarm = report.alarm if ended else report.averted
        body = report.alarm_body if ended else report.averted_body
        element = find_element(self.scene, alarm, body, self.hand)
        return report, find_cause(self.scene, alarm, body), element


def has_ended(report: palpate.LoopReport) -> bool:
    """Whether an alarm ended the run."""
    return bool(report.alarm.kind != palpate.AlarmKind.none)


def plan_cause_work(
    scene: palpate.Scene, report: palpate.LoopReport, record: palpate.Record | None
) -> CauseWork:
    """With what of the record tells where the alarm began."""
    kind = palpate.EventKind.alarm if has_ended(report) else palpate.EventKind.safeguard
    return CauseWork(scene, report, None if record is None else cut_hand(record, kind))


def make_problem(element: Element, surface: Surface) -> Problem:
    """An alarm as something to look at: the triangle nearest to its element."""
    middles = surface.vertices[surface.triangles].mean(axis=1)
    nearest = np.linalg.norm(middles - element.place, axis=1).argmin()
    faces = np.array([nearest], np.int32)
    return Problem("alarm", "error", "test", "alarm", element.name, "", faces=faces)
