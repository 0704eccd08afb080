# SPDX-License-Identifier: GPL-3.0-or-later
"""What a press of an organ comes to, for the rules: place by place, and the same everywhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
from numpy.typing import NDArray
from palpate.runs.press import Place
from palpate.runs.trial import (
    DEPTH,
    HOLD,
    Trial,
    choose_places,
    compare_contact,
    press_places,
)
from palpate.runs.validated import Depths, Validity
from palpate.scene.scene_file import find_contact_modulus
from palpate.scene.scene_parts import WITH_NEAR_FIELD, SceneFile

from palpate_editor.document import Organ
from palpate_editor.document.cost_rules import estimate_tick
from palpate_editor.document.problems import PlaceFacts, TrialFacts
from palpate_editor.nearest import find_blown

LONG_TICK, LONGEST_TICK = 2e-3, 20e-3
"""[s] of the reference machine: longer ticks are pressed at one place only, or not at all, so that
a check does not take longer than a person waits."""
LEAST_DEPTHS = 2.0
"""Depths of the press that an organ is large: a tool that goes through all of it, as where its unit
is wrong, touches every triangle in every substep."""
NEAREST = 6
"""Triangles of tetrahedra at a place, of which edges are measured."""


def measure_trial(organ: Organ, scene: palpate.Scene) -> TrialFacts:
    """Presses a compiled organ at several places that give way, on any thread."""
    body = scene.bodies[0]
    places = choose_places(scene)
    tetrahedra = np.asarray(palpate.list_tetrahedra(body.tissue))
    tick = estimate_tick(organ, len(tetrahedra), body.substeps) or 0.0
    # of tissue without home springs only the substeps are asked for
    is_carried = len(body.tissue.home) > 0
    pressed = places if is_carried and tick <= LONG_TICK else places[:1]
    trials: list[Trial | None] = [None] * len(places)
    is_large = palpate.compute_diagonal(body.tissue.rest_position) >= LEAST_DEPTHS * DEPTH
    blown = None
    if tick <= LONGEST_TICK and is_large:
        found = press_places(scene, pressed, HOLD if is_carried else 0.0)
        trials[: len(found)] = found
        blown = find_blown(scene, next((t.alarm for t in found if t.stopped), None))
    edges: list[float | None] = [None] * len(places)
    if len(tetrahedra):
        edges = list(measure_edges(body.tissue, tetrahedra, places))
    forces: list[tuple[float, float] | None] = [None] * len(places)
    if has_hard_law(organ) and tick <= LONGEST_TICK and is_large:
        pressed = places if tick <= LONG_TICK else places[:1]
        forces[: len(pressed)] = compare_contact(scene, pressed, find_near_modulus(organ))
    depths = Depths(scene, organ.material.wall_thickness)
    return TrialFacts(
        depth=DEPTH,
        substeps=max((t.substeps for t in trials if t and t.substeps), default=body.substeps),
        blown=blown,
        places=tuple(
            describe_place(place, depths.find(place), trial, edge, force)
            for place, trial, edge, force in zip(places, trials, edges, forces, strict=True)
        ),
    )


def has_hard_law(organ: Organ) -> bool:
    """Whether an organ is felt as its mesh gives way, and could be felt as tissue."""
    return organ.model.kind in WITH_NEAR_FIELD and organ.model.contact_law == "hard"


def find_near_modulus(organ: Organ) -> float:
    """[Pa] that the organ's contact would have with a near field."""
    model = replace(organ.model, contact_law="near_field")
    return find_contact_modulus(SceneFile(organ=None, material=organ.material, model=model))


def describe_place(
    place: Place,
    validity: Validity,
    trial: Trial | None = None,
    edge: float | None = None,
    forces: tuple[float, float] | None = None,
) -> PlaceFacts:
    x, y, z = map(float, place.point)
    return PlaceFacts(
        point=(x, y, z),
        home_share=None if trial is None else trial.home_share,
        edge=edge,
        thickness=validity.thickness,
        validated=validity.depth,
        bound=validity.bound,
        forces=forces,
    )


def measure_edges(
    tissue: palpate.TissueModel, tetrahedra: NDArray[np.int32], places: list[Place]
) -> tuple[float, ...]:
    """[m] mean edge of the tetrahedra at the surface, of each place."""
    x = np.asarray(tissue.rest_position)
    faces = np.asarray(palpate.find_boundary(palpate.SolidMesh(x, tetrahedra)))
    lengths = np.linalg.norm(x[faces] - x[np.roll(faces, 1, axis=1)], axis=2).mean(axis=1)
    middles = x[faces].mean(axis=1)
    near = [np.linalg.norm(middles - p.point, axis=1).argsort()[:NEAREST] for p in places]
    return tuple(float(lengths[rows].mean()) for rows in near)
