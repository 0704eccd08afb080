# SPDX-License-Identifier: GPL-3.0-or-later
"""One row of a chart: compiled, run along the path, held against the truth. In any process."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import palpate
from palpate.scenario import Container, pack_container, unpack_container
from palpate.scene.scene_parts import INTEGRATORS
from palpate.study.scene_chart import (
    ALARM,
    RAN,
    REFUSED,
    Configuration,
    Counts,
    Errors,
    Row,
)
from palpate.study.track import (
    Course,
    Track,
    compare_in_time,
    compare_with_truth,
    find_jump,
    find_largest_force,
    list_samples,
    run_track,
    set_course,
    write_way,
)
from palpate.study.truth import Truth

from palpate_editor.compile import compile_organ
from palpate_editor.configuration import (
    apply_configuration,
    describe_provenance,
    name_configuration,
)
from palpate_editor.document import Organ
from palpate_editor.document.files import FORMAT, VERSION, pack_organ, unpack_organ
from palpate_editor.edits import EditError

REFINED = 4
"""How many times the substeps of need a run takes that stands for the same model converged in time.
Its own error in time is a third of what it finds at the substeps of need."""
STAGES = {
    "explicit_euler": 1,
    "symplectic_euler": 1,
    "midpoint": 2,
    "runge_kutta_4": 4,
    "symplectic_euler_implicit_damping": 1,
}
"""Explicit integrator -> evaluations of all forces in a step; of what damps, implicit damping has
several more."""


@dataclass(frozen=True)
class Plan:
    """What all runs of a chart share; it can be sent to another machine."""

    organ: bytes
    """The document, as an .organ file."""
    truth: Truth
    path: str
    """press, pull, drag or script."""
    speed: float
    """[m/s] of the hand, but for a script's."""
    frames: tuple[tuple[float, tuple[float, ...], int], ...] = ()
    """Time [s], position [m] and buttons of a script's key frames; of a script alone."""


@dataclass(frozen=True)
class Converged:
    """The same model converged in time."""

    force: tuple[tuple[float, ...], ...]
    """[N] (t, 3) on the hand; empty where it did not come to its end."""
    model: Errors | None
    """Beside the truth; None where it did not come to its end."""


@dataclass(frozen=True)
class Job:
    """A run to do."""

    number: int
    """Of the row; of one that converges, of the first row that it is for."""
    configuration: Configuration
    own: bool = False
    converges: bool = False
    """The run is that of the same model converged in time."""
    converged: Converged | None = None
    """Of the model, where that was run already."""


def find_converged(configuration: Configuration) -> Configuration:
    """What all configurations of one model in space have in common: the rest is a matter of time.

    A linear solid whose masses swing is another model than one that follows its loads at rest.
    """
    swings = configuration.kind == "linear_solid" and configuration.integrator != INTEGRATORS[0]
    integrator = "runge_kutta_4" if swings else INTEGRATORS[0]
    return replace(configuration, integrator=integrator, substeps=0)


def pack_document(organ: Organ) -> bytes:
    """The .organ file of a document, for a plan: however it came to be what it is."""
    content, arrays = pack_organ(replace(organ, history=None))
    document = Container(format=FORMAT, version=VERSION, content=json.dumps(content), arrays=arrays)
    return pack_container(document)


@lru_cache(maxsize=2)
def open_document(organ: bytes) -> Organ:
    """What pack_document packed."""
    found = unpack_container(organ, "plan", FORMAT, VERSION)
    return unpack_organ(json.loads(found.content), found.arrays, found.version, "plan")


def compile_row(organ: Organ, configuration: Configuration) -> palpate.Scene:
    """Raises EditError or ValueError where the organ cannot be built so."""
    return compile_organ(apply_configuration(organ, configuration))


def refine(scene: palpate.Scene) -> None:
    """Gives a built scene the substeps of one that is converged in time."""
    body = scene.bodies[0]
    body.substeps_max *= REFINED
    body.substeps *= REFINED


def list_hand(plan: Plan, scene: palpate.Scene, course: Course) -> list[palpate.HapticSample]:
    """What the hand says, tick by tick."""
    if plan.path == "script":
        frames = [palpate.KeyFrame(*frame) for frame in plan.frames]
    else:
        frames = write_way(course, plan.path, plan.speed)
    return list_samples(frames, scene.rate)


def run_job(plan: Plan, job: Job) -> Row | Converged:
    """Whatever happens to the run stands in the row."""
    organ = open_document(plan.organ)
    try:
        scene = compile_row(organ, job.configuration)
    except (EditError, ValueError) as problem:
        return Converged((), None) if job.converges else build_refused(organ, job, str(problem))
    if job.converges:
        refine(scene)
    course = set_course(scene, plan.truth)
    track = run_track(scene, course, list_hand(plan, scene, course))
    if job.converges:
        return keep_converged(plan, track)
    return build_row(plan, organ, job, scene, track)


def keep_converged(plan: Plan, track: Track) -> Converged:
    if track.alarm:
        return Converged((), None)
    force = tuple(map(tuple, track.force.tolist()))
    return Converged(force, compare_with_truth(track, find_largest_force(plan.truth)))


def start_row(organ: Organ, job: Job, outcome: str, reason: str) -> Row:
    return Row(
        number=job.number,
        name=str(name_configuration(job.configuration, organ)),
        own=job.own,
        configuration=job.configuration,
        provenance=str(describe_provenance(job.configuration, organ)),
        outcome=outcome,
        reason=reason,
        kernel="",
        force=0.0,
        jump=0.0,
        total=None,
        model=job.converged.model if job.converged is not None else None,
        time=None,
        reference_limited=False,
        counts=None,
        cost=None,
    )


def build_refused(organ: Organ, job: Job, reason: str) -> Row:
    return start_row(organ, job, REFUSED, reason)


def build_row(plan: Plan, organ: Organ, job: Job, scene: palpate.Scene, track: Track) -> Row:
    row = start_row(organ, job, ALARM if track.alarm else RAN, track.alarm)
    row = replace(
        row,
        kernel=scene.bodies[0].kernel.name,
        force=float(track.along.max(initial=0.0)),
        jump=find_jump(track),
        counts=count(scene, job.configuration, track),
    )
    if track.alarm:
        return row
    largest = find_largest_force(plan.truth)
    total = compare_with_truth(track, largest)
    converged = np.array(job.converged.force) if job.converged is not None else np.empty(0)
    return replace(
        row,
        total=total,
        time=compare_in_time(track, converged, largest) if converged.size else None,
        reference_limited=total.force_rms <= float(plan.truth.force_error.max()),
    )


def count(scene: palpate.Scene, configuration: Configuration, track: Track) -> Counts | None:
    """None where nothing was touched before an alarm."""
    if not track.touching.any():
        return None
    tissue, touching = scene.bodies[0].tissue, track.touching
    substeps = track.substeps[touching]
    stages = STAGES.get(configuration.integrator)
    is_response = scene.bodies[0].kernel == palpate.Kernel.response
    each = scene.bodies[0].iterations
    return Counts(
        particles=len(tissue.mass),
        elements=count_elements(tissue),
        substeps=int(substeps.max()),
        iterations=float(each * substeps.mean()) if each else None,
        evaluations=None if stages is None or is_response else float(stages * substeps.mean()),
    )


def count_elements(tissue: palpate.TissueModel) -> int:
    """Tetrahedra, else prisms, else springs and bonds."""
    solid = len(palpate.list_tetrahedra(tissue))
    return solid or len(tissue.prisms.corners) or len(tissue.springs.ends) + len(tissue.bonds.ends)
