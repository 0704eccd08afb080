# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 2: what is good and bad about the surface, and what was repaired when it was read."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget

from palpate_editor.authoring import MeshReport
from palpate_editor.document import Organ, Repairs
from palpate_editor.document.rules import MOST_CROSSING
from palpate_editor.edits import Edit, RemoveCrossings, RepairAll
from palpate_editor.views.context import Context
from palpate_editor.views.stages.facts import Facts
from palpate_editor.views.stages.histogram import Histograms
from palpate_editor.views.stages.hole_list import HoleList
from palpate_editor.views.stages.repair_steps import RepairSteps
from palpate_editor.views.stages.stage_panel import StagePanel, Workers
from palpate_editor.views.stages.step_card import StepCard
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.translations import count, quantity, tr


class RepairPanel(StagePanel):
    """Reports on the surface."""

    stage = "repair"

    @staticmethod
    def title() -> str:
        return tr("Repair")

    @staticmethod
    def lead() -> str:
        return tr("A tissue needs a clean surface. Holes stay open until you fill them.")

    @staticmethod
    def help() -> list[str]:
        return [
            tr("Doubled points are welded, doubled and empty triangles removed, and triangles "
               "turned so that all face outwards. What was done stands in the panel."),
            tr("Whatever can be drawn is imported. Triangles that no tissue can be built on are "
               "red on the organ, and the checks below name what repairs them."),
            tr("Holes are never closed without being asked for: an open surface can be a hollow "
               "organ or a sheet, and then needs the thickness of its wall."),
            tr("Each step is shown before it is applied, with what it changes and how far the "
               "surface moves. Repair all takes them in turn and says what each did; a wrap, which "
               "changes most, comes last and only where nothing else helps."),
        ]  # fmt: skip

    def __init__(self, context: Context, tasks: Tasks, parent: QWidget | None = None):
        self.tasks = tasks
        super().__init__(context, parent)

    @classmethod
    def make(cls, workers: Workers, parent: QWidget) -> RepairPanel:
        return cls(workers.context, workers.tasks, parent)

    def build(self) -> None:
        self.facts = self.section(tr("The surface now")).add(Facts(self))
        self.all = self.main_button(tr("Repair all"), "repair_all")
        self.all.setToolTip(
            tr("From cleaning to, where nothing else helps, a wrap: says what each step did.")
        )
        self.all.clicked.connect(self.repair_all)
        self.form.addWidget(self.all)
        self.card = StepCard(self.context, self.tasks, self)
        self.form.addWidget(self.card)
        self.shape = self.section(tr("Its triangles")).add(Histograms(self.context, self))
        self.holes = self.section(tr("Holes")).add(HoleList(self.context, self.tasks, self))
        self.steps = self.section(tr("Steps")).add(RepairSteps(self.card.attempt, self))
        self.repairs = self.section(tr("Repaired when it was read")).add(Facts(self))

    def show_organ(self, organ: Organ) -> None:
        self.all.setEnabled(organ.surface is not None)
        self.steps.show_organ(organ)
        repairs = organ.source.repairs if organ.source else Repairs()
        rows = [(name, count(value)) for name, value in repair_rows(repairs) if value]
        self.repairs.show_facts(rows or [(tr("Nothing needed repair"), "")])
        self.repairs.parentWidget().setVisible(organ.source is not None)

    def show_assessment(self) -> None:
        assessment = self.context.assessment
        report = assessment.report if assessment else None
        self.facts.parentWidget().setVisible(report is not None)
        self.shape.parentWidget().setVisible(report is not None)
        self.shape.show_report(report)
        self.steps.largest.setEnabled(report is not None and report.shells > 1)
        loops = [] if report is None else report.border_loops
        self.holes.parentWidget().setVisible(bool(loops))
        self.holes.show_surface(assessment.organ.surface if assessment and loops else None)
        if report is None:
            return
        holes = (
            tr("none, it is closed")
            if not loops
            else tr("{count}, kept open").format(count=count(len(loops)))
        )
        crossing = report.self_intersecting_faces
        self.facts.show_facts(
            [
                (tr("Holes"), holes, "warning" if loops else "good"),
                (tr("Pieces"), count(report.shells), "good" if report.shells == 1 else "warning"),
                (tr("Handles"), "–" if report.genus is None else count(report.genus)),
                (tr("Euler number"), count(report.euler_number)),
                (tr("Edge of the holes"), quantity(sum(report.border_lengths_mm), "mm", 3)),
                (tr("Triangles face"), *say_outward(report)),
                (
                    tr("Edges shared by more than two"),
                    count(report.non_manifold_edges),
                    "bad" if report.non_manifold_edges else "good",
                ),
                (
                    tr("Points where surfaces touch"),
                    count(len(report.pinched_vertices)),
                    "warning" if report.pinched_vertices else "good",
                ),
                (
                    tr("Crossing triangles"),
                    tr("too many to count") if crossing is None else count(crossing),
                    say_crossing_tone(report),
                ),
                (tr("Volume"), quantity(report.volume_ml, "ml")),
                (tr("Thinnest"), quantity(report.thinnest_mm, "mm", 3)),
            ]
        )

    def good_news(self) -> list[str]:
        assessment = self.context.assessment
        report = assessment.report if assessment else None
        if report is None:
            return []
        news = []
        if not report.border_loops:
            news.append(tr("The surface is closed: it can be a solid organ."))
        if not report.non_manifold_edges:
            news.append(tr("No edge has more than two triangles."))
        if report.outward:
            news.append(tr("All triangles face outwards."))
        if report.self_intersecting_faces == 0:
            news.append(tr("The surface does not cross itself."))
        return news

    def fix(self, edit: Edit) -> None:
        """What may take long is tried beside the window first."""
        if isinstance(edit, RemoveCrossings):
            self.card.attempt(edit)
        else:
            super().fix(edit)

    def repair_all(self) -> None:
        self.card.attempt(RepairAll())


def say_crossing_tone(report: MeshReport) -> str:
    """Bad where nothing can be published so."""
    crossing = report.self_intersecting_faces
    if crossing is None or crossing > MOST_CROSSING * report.triangles:
        return "bad"
    return "warning" if crossing else "good"


def say_outward(report: MeshReport) -> tuple[str, str]:
    """Which way triangles face, or why that cannot be told; and the tone."""
    if report.outward is not None:
        return (tr("outwards"), "good") if report.outward else (tr("inwards"), "bad")
    if report.non_manifold_edges:
        why = tr("cannot be told: edges have more than two triangles")
    elif not report.closed:
        why = tr("cannot be told: an open surface has no inside")
    else:
        why = tr("cannot be told: neighbours do not agree")
    return why, ""


def repair_rows(repairs: Repairs) -> list[tuple[str, int]]:
    """What was done, in words."""
    return [
        (tr("Vertices welded"), repairs.welded_vertices),
        (tr("Triangles there twice, removed"), repairs.duplicate_triangles),
        (tr("Triangles of no area, removed"), repairs.degenerate_triangles),
        (tr("Vertices of no triangle, removed"), repairs.unused_vertices),
        (tr("Vertices split"), repairs.split_vertices),
        (tr("Triangles turned round"), repairs.turned_triangles),
    ]
