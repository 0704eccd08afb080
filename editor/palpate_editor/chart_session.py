# SPDX-License-Identifier: GPL-3.0-or-later
"""A chart that is drawn once: what was finished is kept in the user's cache, by content.

The key leaves out how the organ is simulated, which every row says by itself: an organ that was
given another configuration finds its chart again.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from palpate.study.scene_chart import Chart, Configuration
from palpate.study.track import SPEED
from palpate.system.data_folder import find_cache_folder

from palpate_editor.chart import Step, compute_key, draw_chart, fill_chart
from palpate_editor.chart_jobs import Plan, pack_document
from palpate_editor.chart_pool import run_in_processes
from palpate_editor.chart_store import Store
from palpate_editor.configurations import list_configurations
from palpate_editor.document import EMPTY, Organ
from palpate_editor.edits.configure import apply_configuration, find_configuration
from palpate_editor.truth import Progress, solve_truth

NEUTRAL = replace(find_configuration(EMPTY), kind="solid", tetrahedra=EMPTY.fill.tetrahedra)
"""Stands in a kept chart's document for whatever the organ has."""
TRUTH_SHARE, ROWS_SHARE = 0.35, 0.9
"""[-] Of the work, until the truth is solved, and until all rows ran."""
OFTEN = 0.5
"""[s] between two charts of what is finished so far."""
PARTS = {"converged": (TRUTH_SHARE, 0.55), "rows": (0.55, ROWS_SHARE), "costs": (ROWS_SHARE, 1.0)}
"""Stage of draw_chart -> share of the work where it begins and ends."""

Told = Callable[[str, float], None]
"""A stage and the share of the work that is done, 0 to 1. Stages are those of a truth (mesh,
stiffness, factor, response) and of a chart (converged, rows, costs)."""
Asked = Callable[[], bool]
Shown = Callable[[Chart], None]


def draw_kept_chart(
    organ: Organ,
    workers: int,
    file: str,
    told: Told = lambda stage, share: None,
    asked: Asked = lambda: False,
    shown: Shown = lambda chart: None,
    cache: Path | None = None,
    configurations: Sequence[Configuration] | None = None,
) -> Chart:
    """The chart of a press; whatever is kept of it is taken, the rest is run.

    Args:
        organ: That has a surface.
        workers: Processes that run rows at once.
        file: What the chart says it was drawn of.
        told: Of progress.
        asked: Whether to stop: the chart is then of what is finished.
        shown: Told the chart of what is finished so far, now and then.
        cache: The folder of what is kept, truths and rows; the user's own if None.
        configurations: The organ's own first; all of list_configurations if None.

    Raises:
        TruthError: where the truth cannot be solved.
        Refusal: where the organ cannot be built as it is.
        OSError: where the cache cannot be written.
    """
    folder = find_cache_folder() if cache is None else cache

    def tell_truth(progress: Progress) -> None:
        told(progress.stage, TRUTH_SHARE * progress.fraction)

    truth = solve_truth(organ, progress=tell_truth, cancelled=asked, cache=folder / "truths")
    # rows with it need the far field, which none without it is held back by
    neutral = replace(apply_configuration(organ, NEUTRAL), far_field=organ.far_field)
    plan = Plan(pack_document(neutral), truth, "press", SPEED)
    wanted = list_configurations(organ) if configurations is None else list(configurations)
    with Store(compute_key(plan), folder / "charts") as store:
        watch = Watch(wanted, store, told, shown)
        return draw_chart(
            plan,
            configurations=wanted,
            runner=run_in_processes(workers),
            store=store,
            told=watch.tell,
            asked=asked,
            begun=watch.begin,
            command=f"palpate chart {file}",
        )


class Watch:
    """Tells of progress, and shows what is finished."""

    def __init__(self, wanted: Sequence[Configuration], store: Store, told: Told, shown: Shown):
        self.wanted, self.store, self.told, self.shown = wanted, store, told, shown
        self.head: Chart | None = None
        self.last = -OFTEN

    def begin(self, head: Chart) -> None:
        """Also what an earlier call finished is shown."""
        self.head = head
        self.show()

    def tell(self, step: Step) -> None:
        begin, end = PARTS[step.stage]
        self.told(step.stage, begin + (end - begin) * step.done / max(step.all, 1))
        if step.row is not None and time.monotonic() >= self.last + OFTEN:
            self.show()

    def show(self) -> None:
        assert self.head is not None
        self.last = time.monotonic()
        self.shown(fill_chart(self.head, self.wanted, self.store))
