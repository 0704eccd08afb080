# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 4: every number of tissue, tip and hand, and at once what comes of them."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

import numpy as np
from PySide6.QtWidgets import (
    QCheckBox,
    QHBoxLayout,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from palpate_editor import comparison
from palpate_editor.document import Organ
from palpate_editor.document.constants import CONSTANTS, SWINGING
from palpate_editor.document.cost_rules import count_substeps
from palpate_editor.edits import FixLowest, FixVertices, SetGravity
from palpate_editor.trial import has_hard_law
from palpate_editor.views.chart.advisor import Advisor
from palpate_editor.views.context import Context
from palpate_editor.views.number_box import NumberBox
from palpate_editor.views.stages.advice_form import AdviceForm
from palpate_editor.views.stages.constant_form import ChoiceField, ConstantField, build_grid
from palpate_editor.views.stages.contact_offer import ContactOffer
from palpate_editor.views.stages.facts import Fact, Facts, Section, write_label
from palpate_editor.views.stages.fill_form import FillForm
from palpate_editor.views.stages.material_words import (
    filling_rows,
    home_rows,
    say_compared,
    say_error,
    say_origin,
    share_rows,
    validity_rows,
)
from palpate_editor.views.stages.published_values import PublishedValues
from palpate_editor.views.stages.stage_panel import StagePanel, Workers
from palpate_editor.views.translations import count, number, quantity, say_memory, tr

WEIGHT = (0.0, 0.0, -9.81)
"""[m/s²]"""
GOOD_MARGIN = 1.05
"""[-] below it the margin is shown as a warning."""

TISSUE = (
    "material.young_modulus",
    "material.poisson_ratio",
    "material.density",
    "material.damping_ratio",
    "material.wall_thickness",
)
LINKS = tuple(constant.key for constant in CONSTANTS if constant.part == "model")
TIP = (
    "tool.radius",
    "tool.length",
    "tool.trocar_height",
    "tool.jaw_opening",
    "tool.grip_force",
    "tool.stiffness",
    "tool.friction",
)
HAND = (
    "hand.coupling",
    "hand.hold_stiffness",
    "hand.force_max",
    "hand.rate",
    "hand.exchange_rate",
    "hand.substeps",
    "hand.force_error",
)
GOOD_FIT = 0.05
"""[-] a larger error against the wall is shown as a warning, where constants come from tissue."""


class MaterialPanel(StagePanel):
    """Edits the constants."""

    stage = "material"
    colouring = "stiffness"
    shows_fixed = True

    def __init__(self, context: Context, advisor: Advisor, parent: QWidget | None = None):
        self.advisor = advisor
        super().__init__(context, parent)

    @classmethod
    def make(cls, workers: Workers, parent: QWidget) -> MaterialPanel:
        return cls(workers.context, workers.advisor, parent)

    @staticmethod
    def title() -> str:
        return tr("Material")

    @staticmethod
    def lead() -> str:
        return tr("Chosen by hand to feel like an organ, or given by what the tissue is made of.")

    @staticmethod
    def help() -> list[str]:
        return [
            tr("Every number has its unit beside it. Type a value, or use the arrow keys. Mass, "
               "substeps and the stability margin follow at once."),
            tr("The mass–spring model has springs along all edges. The molecular model adds angles "
               "and their coupling to stretch; a triangle can only take a certain range of it."),
            tr("A wall can have its constants from the tissue: choose so under Constants, and read "
               "what the model makes of the wall. A shell of prisms bends as well."),
            tr("Fix what is attached to the body, and paint places that are harder: choose a brush "
               "at the left, and drag over the organ."),
        ]  # fmt: skip

    def build(self) -> None:
        self.shown_kind: tuple[str, str, bool] | None = None
        self.tool_options = QVBoxLayout()
        self.form.addLayout(self.tool_options)
        self.fields: list[ConstantField | ChoiceField] = []
        self.kind = ChoiceField(self.context, "kind", self)
        self.origin = ChoiceField(self.context, "constants", self)
        for choice in (self.kind, self.origin):
            row = QHBoxLayout()
            row.setSpacing(12)
            row.addWidget(choice.label)
            row.addWidget(choice, 1)
            self.form.addLayout(row)
        self.compared = write_label("", "note", self)
        self.compared.setObjectName("compared_kind")
        self.compared.setWordWrap(True)
        self.form.addWidget(self.compared)
        self.published = PublishedValues(self.context, self)
        self.section(tr("Published values")).add(self.published)
        self.facts = self.section(tr("What comes of it")).add(Facts(self))
        self.facts.keep_height = True
        self.range = write_label("", "note", self)
        self.range.setWordWrap(True)
        self.form.addWidget(self.range)
        self.advice = AdviceForm(self.context, self.advisor, self)
        self.form.addWidget(self.advice)
        tissue = self.section(tr("Tissue"))
        self.add_constants(tissue, TISSUE)
        self.origin_note = tissue.add(write_label("", "note", self))
        self.origin_note.setWordWrap(True)
        self.filling = FillForm(self.context, self)
        self.form.addWidget(self.filling)
        self.fields += self.filling.constants
        self.links = self.section(tr("Springs and bonds"))
        self.add_constants(self.links, LINKS, self.build_laws())
        self.build_support(self.section(tr("What holds it")))
        laws = ("contact_law", "contact_curvature", "contact_hold")
        contact = [ChoiceField(self.context, law, self) for law in laws]
        tip = self.section(tr("Tip of the tool"))
        self.add_constants(tip, TIP, contact)
        self.offer = tip.add(ContactOffer(self.context, self))
        integrator = ChoiceField(self.context, "integrator", self)
        self.add_constants(self.section(tr("Hand")), HAND, [integrator])
        self.fields += [self.kind, self.origin]
        self.context.assessor.said.connect(self.show_building)

    def build_laws(self) -> list[ChoiceField]:
        return [
            ChoiceField(self.context, "spring_rule", self),
            ChoiceField(self.context, "damping_law", self),
            ChoiceField(self.context, "angle_law", self),
        ]

    def add_constants(
        self, section: Section, keys: tuple[str, ...], laws: Sequence[ChoiceField] = ()
    ) -> None:
        grid, fields = build_grid(self.context, keys, self)
        for law in laws:
            row = grid.rowCount()
            grid.addWidget(law.label, row, 0)
            grid.addWidget(law, row, 1)
        section.body.addLayout(grid)
        self.fields += [*fields, *laws]

    def build_support(self, section: Section) -> None:
        row = QHBoxLayout()
        row.setSpacing(8)
        self.share = NumberBox(self)
        self.share.setObjectName("lowest_share")
        self.share.setRange(0.5, 100.0)
        self.share.setDecimals(1)
        self.share.setValue(10.0)
        self.share.setSuffix("\N{NO-BREAK SPACE}%")
        self.lowest = QPushButton(tr("Fix the lowest"), self)
        self.lowest.setObjectName("fix_lowest")
        self.lowest.clicked.connect(self.fix_lowest)
        self.free = QPushButton(tr("Free all"), self)
        self.free.setObjectName("free_all")
        self.free.clicked.connect(self.free_all)
        row.addWidget(self.lowest)
        row.addWidget(self.share, 1)
        row.addWidget(self.free)
        section.body.addLayout(row)
        self.fixed = section.add(write_label("", "note", self))
        self.fixed.setWordWrap(True)
        self.gravity = QCheckBox(tr("The organ has weight (9.81 m/s² downwards)"), self)
        self.gravity.setObjectName("gravity")
        self.gravity.clicked.connect(self.set_gravity)
        section.add(self.gravity)

    # ------------------------------------------------------------ showing

    def show_organ(self, organ: Organ) -> None:
        kind = (organ.model.kind, organ.model.constants, organ.surface is None)
        if kind != self.shown_kind:
            # only then may what stands below move: nobody's mouse is on it
            self.shown_kind = kind
            self.facts.forget_height()
            policy = self.range.sizePolicy()
            policy.setRetainSizeWhenHidden(organ.model.kind == "molecular")
            self.range.setSizePolicy(policy)
        for field in [*self.fields, self.published]:
            field.show_organ(organ)
        self.origin_note.setText(say_origin(organ))
        error = comparison.say_error(organ.model.kind)
        self.compared.setText("" if error is None else say_compared(error))
        self.compared.setVisible(error is not None)
        self.filling.show_organ(organ)
        self.advice.show_organ(organ)
        if not has_hard_law(organ):
            self.offer.hide()
        self.links.setVisible(organ.model.kind in SWINGING)
        there = organ.surface is not None
        self.lowest.setEnabled(there)
        self.free.setEnabled(bool(organ.fixed.any()))
        fixed, painted = int(organ.fixed.sum()), int((organ.stiffness_scale != 1.0).sum())
        self.fixed.setText(
            tr("{fixed} of {all} vertices are fixed; {painted} have a stiffness of their own.")
            .format(fixed=count(fixed), all=count(organ.vertex_count), painted=count(painted))
        )  # fmt: skip
        self.fixed.setVisible(there)
        self.gravity.setChecked(any(organ.hand.gravity))

    def show_assessment(self) -> None:
        assessment = self.context.assessment
        if assessment is None:
            return
        for field in self.fields:
            if isinstance(field, ConstantField) and field.constant.field == "home_stiffness":
                tissue = assessment.tissue
                field.default = (tissue.default_home if tissue else None) or 0.0
                field.show_organ(self.context.session.organ)
        tissue = assessment.tissue
        self.offer.show_trial(tissue.trial if tissue else None)
        self.facts.parentWidget().setVisible(assessment.organ.surface is not None)
        span = tissue.coupling_range if tissue else None
        self.range.setVisible(span is not None)
        if span is not None:
            self.range.setText(
                tr("Every triangle can take a stretch-bend of {low} to {high} N.").format(
                    low=number(span[0], 3), high=number(span[1], 3)
                )
            )
        if tissue is None or assessment.scene is None:
            self.facts.show_facts([(tr("No tissue yet"), tr("see the checks below"), "bad")])
            return
        self.facts.show_facts(self.result_rows())

    def show_building(self, text: str) -> None:
        """What is being built, while it takes its time."""
        self.facts.show_facts([(tr("Its response"), text)])

    def result_rows(self) -> list[Fact]:
        assessment = self.context.assessment
        assert assessment is not None and assessment.tissue is not None
        tissue, share = assessment.tissue, assessment.tick_share
        mass, step = tissue.total_mass, tissue.stable_step
        rows: list[Fact] = [(tr("Total mass"), quantity(None if mass is None else 1e3 * mass, "g"))]
        if tissue.tetrahedra:
            rows.append((tr("Tetrahedra"), count(tissue.tetrahedra)))
            rows += filling_rows(tissue)
        scene = assessment.scene
        if scene is not None and scene.bodies[0].response is not None:  # nothing of it swings
            rows.append((tr("Its response"), say_memory(scene.bodies[0].response.size)))
            return rows + share_rows(share) + validity_rows(tissue)
        rows += [
            (tr("Links"), count(tissue.links)),
            (tr("Substeps a tick"), count(tissue.substeps)),
            (tr("Substeps in touch"), count(count_substeps(tissue))),
            (tr("Longest stable step"), quantity(None if step is None else 1e3 * step, "ms", 3)),
        ]
        # what is held everywhere cannot swing, and has no margin to speak of
        if tissue.margin is not None and isfinite(tissue.margin):
            tone = "good" if tissue.margin >= GOOD_MARGIN else "warning"
            rows.append((tr("Stability margin"), f"{number(tissue.margin, 3)} ×", tone))
        rows += self.wall_rows() + home_rows(tissue) + share_rows(share)
        return rows + validity_rows(tissue)

    def wall_rows(self) -> list[Fact]:
        """How the springs and bonds of a wall compare with its material."""
        assessment = self.context.assessment
        wall = assessment.tissue.wall if assessment and assessment.tissue else None
        if wall is None:
            return []
        from_tissue = self.context.session.organ.model.constants == "tissue"
        tone = "good" if wall.error <= GOOD_FIT else "warning" if from_tissue else ""
        least, most = number(wall.least, 3), number(wall.most, 3)
        stiff = f"{least} ×" if least == most else f"{least} – {most} ×"
        like = quantity(1e-3 * wall.young_modulus, "kPa", 3)
        return [
            (tr("Stretches like"), f"{like}, ν {number(wall.poisson_ratio, 3)}"),
            (tr("Of the wall's stiffness"), stiff),
            (tr("Error of stretching"), say_error(wall.error), tone),
        ]

    def good_news(self) -> list[str]:
        assessment = self.context.assessment
        if assessment is None or assessment.scene is None:
            return []
        return [tr("The tissue can be built and stays stable.")]

    # ------------------------------------------------------------ doing

    def fix_lowest(self) -> None:
        self.share.interpretText()
        self.context.apply(FixLowest(self.share.value() / 100.0))

    def free_all(self) -> None:
        ids = np.flatnonzero(self.context.session.organ.fixed)
        self.context.apply(FixVertices(ids, False))

    def set_gravity(self, on: bool) -> None:
        self.context.apply(SetGravity(WEIGHT if on else (0.0, 0.0, 0.0)))
