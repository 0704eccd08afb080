# SPDX-License-Identifier: GPL-3.0-or-later
"""The atlas of the organ on the desk: how long a step of every method may be, on every tissue."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import palpate
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import FILLED
from palpate.study.atlas import OWN, Atlas, Present, Row, Spot
from palpate.study.step_limit import STEPS, foretell_limit

from palpate_editor.atlas_jobs import Job, Plan, lose, run_job
from palpate_editor.atlas_spots import Point, list_points
from palpate_editor.atlas_store import VERSION, Store
from palpate_editor.chart import UNFELT, keep_known
from palpate_editor.chart_jobs import open_document
from palpate_editor.compile import compile_organ
from palpate_editor.document import Organ
from palpate_editor.document.files import pack_organ
from palpate_editor.job_pool import Runner, run_in_processes

UNSTEPPED = (*UNFELT, "tool", "far_field")
"""Of a document: no limit of an atlas depends on it, as nothing is in touch."""


@dataclass(frozen=True)
class Step:
    """How far an atlas is."""

    done: int
    """Tissues, ..."""
    all: int
    """... of so many."""
    rows: tuple[Row, ...]
    """That were finished just now."""


Told = Callable[[Step], None]
Asked = Callable[[], bool]
Begun = Callable[[Atlas], None]


def run_tissues(workers: int) -> Runner:
    """Tissues of an atlas in so many processes at once."""
    return run_in_processes(run_job, lose, workers)


def compute_key(plan: Plan) -> str:
    """Hash of all that limits depend on."""
    content, arrays = pack_organ(open_document(plan.organ))
    for name in UNSTEPPED:
        content.pop(name, None)
    keep_known(content)
    content["hand"] = {name: content["hand"][name] for name in ("rate", "gravity", "substeps")}
    whole = hashlib.sha256(json.dumps([VERSION, STEPS, content], sort_keys=True).encode())
    for name in sorted(name for name in arrays if name.split("/")[0] not in UNSTEPPED):
        array = np.ascontiguousarray(arrays[name])
        whole.update(f"{name} {array.dtype.str} {array.shape}".encode() + array.tobytes())
    return whole.hexdigest()


def draw_atlas(
    plan: Plan,
    *,
    runner: Runner,
    points: Sequence[Point] | None = None,
    store: Store | None = None,
    told: Told = lambda step: None,
    asked: Asked = lambda: False,
    begun: Begun = lambda atlas: None,
    command: str = "",
) -> Atlas:
    """Runs what is not finished yet; on any thread. Ctrl-C ends it with what is finished.

    Args:
        plan: The organ.
        runner: Where tissues run (run_tissues).
        points: Tissues and integrators; all of list_points if None.
        store: What was finished before, and where to keep what will be.
        told: Of every tissue that is finished.
        asked: Whether to stop, between two tissues.
        begun: Told the atlas of what was finished before, before anything is run.
        command: What the atlas says it was drawn by.

    Raises:
        Refusal: where the organ cannot be built as it is.
    """
    organ = open_document(plan.organ)
    wanted = list_points(organ) if points is None else list(points)
    store = Store(compute_key(plan)) if store is None else store
    head = begin_atlas(plan, organ, command)
    begun(fill_atlas(head, wanted, store))
    jobs = list_jobs(wanted, store)
    done, complete = len(wanted) - len(jobs), True
    try:
        for _, rows in runner(plan, jobs) if jobs else ():
            store.keep(rows)
            done += 1
            told(Step(done, len(wanted), rows))
            if asked() and done < len(wanted):
                complete = False
                break
    except KeyboardInterrupt:
        complete = False
    return replace(fill_atlas(head, wanted, store), complete=complete)


def list_jobs(wanted: Sequence[Point], store: Store) -> list[Job]:
    """A job for each tissue, of the integrators that the store has not."""
    jobs = []
    for spot, names in wanted:
        missing = tuple(name for name in names if (spot, name) not in store.rows)
        if missing:
            jobs.append(Job(spot, missing))
    return jobs


def begin_atlas(plan: Plan, organ: Organ, command: str) -> Atlas:
    """Without rows, and not complete. Raises Refusal."""
    return Atlas(
        organ=organ.title or organ.name,
        key=compute_key(plan),
        command=command,
        rate=organ.hand.rate,
        steps=STEPS,
        complete=False,
        present=find_present(organ),
        rows=(),
    )


def find_present(organ: Organ) -> Present:
    """The organ's own scene, its limit foretold. Raises Refusal where it cannot be built."""
    try:
        scene = compile_organ(organ)
    except ValueError as problem:
        raise Refusal(None, "organ", str(problem), "one that can be built as it is") from None
    body = scene.bodies[0]
    rests = body.kernel == palpate.Kernel.response or palpate.is_implicit(body.integrator)
    limit = None if rests else foretell_limit(body.tissue, body.integrator)
    return Present(
        kind=organ.model.kind,
        integrator=organ.model.integrator,
        substeps=body.substeps,
        step=1.0 / (scene.rate * body.substeps),
        predicted=limit if limit and np.isfinite(limit) else None,
        measured=None,
        young_modulus=organ.material.young_modulus,
        stiffness=organ.model.stiffness,
        constants=organ.model.constants,
        damping_ratio=organ.material.damping_ratio,
        size=organ.fill.tetrahedra if organ.model.kind in FILLED else organ.vertex_count,
    )


def fill_atlas(head: Atlas, wanted: Sequence[Point], store: Store) -> Atlas:
    """With the rows that were finished so far."""
    rows = [
        store.rows[spot, name]
        for spot, names in wanted
        for name in names
        if (spot, name) in store.rows
    ]
    filled = replace(head, rows=tuple(replace(row, number=i) for i, row in enumerate(rows)))
    own = filled.find_row(Spot(head.present.kind, OWN, "own", "own"), head.present.integrator)
    measured = None if own is None else own.measured
    return replace(filled, present=replace(head.present, measured=measured))
