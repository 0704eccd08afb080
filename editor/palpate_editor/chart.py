# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of the organ on the desk: every configuration along one path, and its cost in touch.

First the same models converged in time, then every row, in as many processes as are asked for; what
they cost is timed after that, one after the other in this process, so that no run disturbs another.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import palpate
from palpate.files.refusal import Refusal
from palpate.study.path_cost import measure_path_cost
from palpate.study.scene_chart import (
    DISPLACEMENT_TARGET,
    FORCE_TARGET,
    RAN,
    Chart,
    Configuration,
    Cost,
    Held,
    Machine,
    Row,
    Way,
)
from palpate.study.track import find_largest_force, set_course
from palpate.study.truth import Truth
from palpate.system.processor import name_processor

from palpate_editor.chart_jobs import (
    REFINED,
    Converged,
    Job,
    Plan,
    compile_row,
    find_converged,
    list_hand,
    open_document,
)
from palpate_editor.chart_pool import Runner, run_here
from palpate_editor.chart_store import VERSION, Store
from palpate_editor.configurations import list_configurations
from palpate_editor.document.files import pack_organ

TIMED = "in one process, one configuration after the other, once all runs were done"
UNFELT = ("name", "title", "task", "languages", "source", "decimation", "appearance")
"""Of a document: nothing of a chart depends on it."""


@dataclass(frozen=True)
class Step:
    """How far a chart is."""

    stage: str
    """converged, rows or costs."""
    done: int
    all: int
    row: Row | None = None
    """That was finished just now."""


Told = Callable[[Step], None]
Asked = Callable[[], bool]
Begun = Callable[[Chart], None]


class Stopped(Exception):
    """Somebody asked to stop between two runs; what was finished is in the chart."""


def compute_key(plan: Plan) -> str:
    """Hash of all that errors depend on."""
    content, arrays = pack_organ(open_document(plan.organ))
    for name in UNFELT:
        content.pop(name, None)
    keep_known(content)
    head = [VERSION, REFINED, plan.path, plan.speed, plan.frames, plan.truth.key]
    whole = hashlib.sha256(json.dumps([head, content], sort_keys=True).encode())
    for name in sorted(arrays):
        array = np.ascontiguousarray(arrays[name])
        whole.update(f"{name} {array.dtype.str} {array.shape}".encode() + array.tobytes())
    return whole.hexdigest()


SINCE = (
    ("hand", "exchange_rate", 0.0),
    ("tool", "friction", 0.0),
    ("model", "contact_curvature", "vertices"),
    ("model", "contact_hold", "fastened"),
    ("tool", "length", 0.0),
    ("tool", "trocar_height", 0.15),
    ("tool", "jaw_opening", 0.0),
    ("tool", "grip_force", 5.0),
)
"""Part, field and value as before of what came to documents with versions 11 to 16."""


def keep_known(content: dict[str, Any]) -> None:
    """Takes away what documents of before versions 9 and 11 to 16 do not say, so that their charts
    are known."""
    for part, name, usual in SINCE:
        if content.get(part, {}).get(name) == usual:
            del content[part][name]
    fill = content["fill"]
    if fill["sizing"] == "estimated" and not fill["fine_region"]:
        for name in ("sizing", "fine_region", "fine_ratio"):
            del fill[name]


def draw_chart(
    plan: Plan,
    *,
    configurations: Sequence[Configuration] | None = None,
    runner: Runner = run_here,
    store: Store | None = None,
    told: Told = lambda step: None,
    asked: Asked = lambda: False,
    begun: Begun = lambda chart: None,
    script: str = "",
    command: str = "",
) -> Chart:
    """Runs what is not finished yet; on any thread. Ctrl-C ends it with what is finished.

    Args:
        plan: Organ, truth and path.
        configurations: The organ's own first; all of list_configurations if None.
        runner: Where the rows run (chart_pool).
        store: What was finished before, and where to keep what will be.
        told: Of every finished run.
        asked: Whether to stop, between two runs.
        begun: Told the chart without rows, for fill_chart, before anything is run.
        script: The name of a script's file.
        command: What the chart says it was drawn by.

    Raises:
        Refusal: where the organ cannot be run as it is, so that there is no path to share.
    """
    if configurations is None:
        configurations = list_configurations(open_document(plan.organ))
    wanted = list(configurations)
    store = Store(compute_key(plan)) if store is None else store
    head = begin_chart(plan, wanted[0], script, command)
    begun(head)
    complete = True
    try:
        for step in run_all(plan, wanted, runner, store):
            told(step)
            if asked():
                raise Stopped
    except (KeyboardInterrupt, Stopped):
        complete = False
    return replace(fill_chart(head, wanted, store), complete=complete)


def begin_chart(plan: Plan, own: Configuration, script: str, command: str) -> Chart:
    """Without rows, and not complete. Raises Refusal."""
    organ = open_document(plan.organ)
    way, rate = measure_way(plan, own, script)
    return Chart(
        organ=organ.title or organ.name,
        key=compute_key(plan),
        command=command,
        young_modulus=organ.material.young_modulus,
        poisson_ratio=organ.material.poisson_ratio,
        wall_thickness=organ.material.wall_thickness,
        tool_radius=organ.tool.radius,
        rate=rate,
        force_target=FORCE_TARGET,
        displacement_target=DISPLACEMENT_TARGET,
        complete=False,
        way=way,
        truth=hold_truth(plan.truth),
        machine=Machine(name_processor(), (palpate.simd_targets() or ["none"])[0], TIMED),
        rows=(),
    )


def fill_chart(head: Chart, wanted: Sequence[Configuration], store: Store) -> Chart:
    """With the rows that were finished so far, the organ's own first."""
    rows = [store.rows[c] for c in wanted if c in store.rows]
    return replace(
        head,
        rows=tuple(
            replace(row, number=i, own=row.configuration == wanted[0],
                    cost=store.costs.get(row.configuration))
            for i, row in enumerate(rows)
        ),
    )  # fmt: skip


def hold_truth(truth: Truth) -> Held:
    return Held(
        key=truth.key,
        law=truth.law,
        force=find_largest_force(truth),
        force_error=float(truth.force_error.max()),
        displacement_error=float(truth.displacement_error.max()),
    )


def measure_way(plan: Plan, own: Configuration, script: str) -> tuple[Way, float]:
    """What the hand does in the organ's own scene, and its rate [Hz]. Raises Refusal."""
    try:
        scene = compile_row(open_document(plan.organ), own)
    except ValueError as problem:
        raise Refusal(None, "organ", str(problem), "one that can be built as it is") from None
    samples = list_hand(plan, scene, set_course(scene, plan.truth))
    places = np.array([sample.position for sample in samples])
    length = float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum())
    speed = length * scene.rate / len(samples) if plan.path == "script" else plan.speed
    depth = float(plan.truth.depth[np.abs(plan.truth.depth).argmax()])
    return Way(plan.path, script, speed, depth, len(plan.truth.point), len(samples)), scene.rate


def run_all(
    plan: Plan, wanted: Sequence[Configuration], runner: Runner, store: Store
) -> Iterator[Step]:
    """What converged, the rows, the costs: whatever the store has not."""
    numbers = {c: i for i, c in enumerate(wanted)}
    models = dict.fromkeys(map(find_converged, wanted))
    missing = [
        Job(min(i for c, i in numbers.items() if find_converged(c) == model), model, converges=True)
        for model in models
        if model not in store.converged
    ]
    done = len(models) - len(missing)
    for job, found in run(runner, plan, missing):
        assert isinstance(found, Converged)
        store.keep_converged(job.configuration, found)
        done += 1
        yield Step("converged", done, len(models))
    jobs = [
        Job(i, c, own=i == 0, converged=store.converged[find_converged(c)])
        for c, i in numbers.items()
        if c not in store.rows
    ]
    done = len(wanted) - len(jobs)
    for _, found in run(runner, plan, jobs):
        assert isinstance(found, Row)
        store.keep_row(found)
        done += 1
        yield Step("rows", done, len(wanted), found)
    yield from time_all(plan, wanted, store)


def run(runner: Runner, plan: Plan, jobs: Sequence[Job]) -> Iterator[tuple[Job, Row | Converged]]:
    """No process is begun where there is nothing to do."""
    return runner(plan, jobs) if jobs else iter(())


def time_all(plan: Plan, wanted: Sequence[Configuration], store: Store) -> Iterator[Step]:
    """Costs of the rows that ran, where they were not timed yet."""
    ran = [c for c in wanted if c in store.rows and store.rows[c].outcome == RAN]
    for done, configuration in enumerate(ran, start=1):
        if configuration not in store.costs:
            store.keep_cost(configuration, time_row(plan, configuration))
            yield Step("costs", done, len(ran), store.rows[configuration])


def time_row(plan: Plan, configuration: Configuration) -> Cost | None:
    scene = compile_row(open_document(plan.organ), configuration)
    return measure_path_cost(scene, list_hand(plan, scene, set_course(scene, plan.truth)))
