# SPDX-License-Identifier: GPL-3.0-or-later
"""What the last run felt and cost, and the button that keeps its record."""

from __future__ import annotations

from pathlib import Path

from palpate.runs.coupling import FELT_WITHIN
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from palpate_editor.views.context import Context
from palpate_editor.views.stages.facts import Fact, Facts
from palpate_editor.views.touch.results import Outcome, keep_record
from palpate_editor.views.touch.save_dialog import ask_save
from palpate_editor.views.translations import count, quantity, tr


class ResultsBox(QWidget):
    """Numbers of one run."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.outcome: Outcome | None = None
        self.facts = Facts(self)
        self.save_button = QPushButton(tr("Save record…"), self)
        self.save_button.setObjectName("save_record")
        self.save_button.setProperty("small", True)
        self.save_button.setToolTip(
            tr("Every tick of the run and, beside it, the organ: to replay and to compare")
        )
        self.save_button.clicked.connect(self.choose_record)
        self.save_button.setEnabled(False)
        self.facts.show_facts([(tr("Nothing felt yet"), "")])
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.facts)
        row = QHBoxLayout()
        row.addStretch(1)
        row.addWidget(self.save_button)
        column.addLayout(row)

    def show_outcome(self, outcome: Outcome) -> None:
        """Writes what a run felt and what it cost."""
        self.outcome = outcome
        self.save_button.setEnabled(True)
        self.facts.show_facts([*list_felt(outcome), *list_costs(outcome)])

    def choose_record(self) -> None:
        """Asks for a file and keeps the last run in it."""
        if self.outcome is None:
            self.context.tell(tr("There is no run to save yet."))
            return
        first = (self.outcome.organ.name or "organ") + ".prec"
        filters = tr("Record (*.prec)")
        ask_save(self, tr("Save record"), first, filters, self._take_name)

    def _take_name(self, name: str) -> None:
        self.save_record(Path(name))

    def save_record(self, path: Path) -> None:
        """Keeps the last run, with the organ beside it."""
        path = path if path.suffix else path.with_suffix(".prec")
        try:
            scene = keep_record(self.outcome, path)
        except (OSError, ValueError) as problem:
            self.context.refuse(problem)
            return
        self.context.tell(
            tr("Kept in {record}, with the organ beside it in {scene}.").format(
                record=path.name, scene=scene.name
            ),
            "info",
        )
        self.context.log_command(["palpate", "replay", str(path)])


def list_felt(outcome: Outcome) -> list[Fact]:
    """Forces; a hand has a peak alone, for it follows no script."""
    felt = outcome.felt
    facts: list[Fact] = [
        (tr("Run"), outcome.name),
        (tr("Peak force"), quantity(felt["peak_force_N"], "N", 3)),
    ]
    if "patch_stiffness_N_per_m" in felt:
        stiffness, pull = felt["patch_stiffness_N_per_m"], felt["pull_force_N"]
        if stiffness is None:
            facts.append((tr("Force / depth"), tr("not at rest: hold longer"), "warning"))
        else:
            facts.append((tr("Force / depth, at rest"), quantity(stiffness, "N/m", 3)))
        if felt["slipped_at_N"] is not None:
            slipped = quantity(felt["slipped_at_N"], "N", 3)
            words = tr("slipped off at {force}: press deeper").format(force=slipped)
            facts.append((tr("Pull force"), words, "warning"))
        elif pull is not None:
            facts.append((tr("Pull force"), quantity(pull, "N", 3)))
    return facts


def list_costs(outcome: Outcome) -> list[Fact]:
    """Shares of the millisecond, and the ticks that were left out."""
    rate, report = outcome.scene.rate, outcome.report
    facts: list[Fact] = []
    for name, cost in ((tr("Cost"), report.cost), (tr("Lateness"), report.lateness)):
        shares = tr("{median:.0f} % of a tick, p99 {p99:.0f} %").format(
            median=100 * cost.median * rate, p99=100 * cost.p99 * rate
        )
        facts.append((name, shares))
    missed = f"{count(report.missed_ticks)} / {count(report.ticks)}"
    tone = "warning" if report.missed_ticks else "good"
    facts.append((tr("Missed ticks"), missed, tone))
    if report.exchanges:
        late = f"{count(report.late_exchanges)} / {count(report.exchanges)}"
        facts.append((tr("Late exchanges"), late, "warning" if report.late_exchanges else "good"))
    damped = "warning" if report.interventions else "good"
    facts.append((tr("Damped by the link"), count(report.interventions), damped))
    softer = max((device.stiffness_error for device in report.devices), default=0.0)
    if softer > 0.0:
        tone = "warning" if softer > FELT_WITHIN else "good"
        facts.append((tr("Stiffness not felt"), f"{100 * softer:.0f} %", tone))
    return facts
