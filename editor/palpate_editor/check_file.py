# SPDX-License-Identifier: GPL-3.0-or-later
"""What `palpate check` says of a file: a press of it place by place, and all that is wrong."""

from __future__ import annotations

from math import inf, isfinite
from pathlib import Path

import palpate
from palpate.command.verb import Report
from palpate.runs.script_file import read_script_file
from palpate.runs.validated import measure_script
from palpate.scene.scene_parts import WITH_NEAR_FIELD

from palpate_editor.check import Assessment, assess, describe_model, describe_problem
from palpate_editor.document import Organ
from palpate_editor.document.cost_rules import compute_tick_share
from palpate_editor.document.depth_rules import find_depth_problems
from palpate_editor.document.press_rules import compute_contact_radius, compute_patch_factor
from palpate_editor.document.problems import PlaceFacts, PressFacts, TrialFacts
from palpate_editor.open_organ import open_organ
from palpate_editor.trial import describe_place


def check_file(path: Path, depth: float | None = None, script: Path | None = None) -> Report:
    """Everything wrong or doubtful about a working file or a scene file.

    A scene file has neither title nor task, so it is not held to those. Raises Refusal, FileError
    or OSError where a file cannot be read.

    Args:
        depth: [m] of a press that is meant, at every place.
        script: A way of the hand that is meant.
    """
    frames = None if script is None else read_script_file(script)
    assessment = assess(open_organ(path))
    scene, tissue = assessment.scene, assessment.facts.tissue
    trial = tissue.trial if tissue else None
    presses = list_presses(assessment, depth, frames)
    found = [*assessment.problems, *find_depth_problems(assessment.organ, presses)]
    judged = [p for p in found if path.suffix != ".json" or p.stage != "publish"]
    return {
        "file": str(path),
        "description": "cannot be built" if scene is None else describe_model(scene),
        # JSON has no infinity, which is the margin of what cannot swing
        "stability_margin": tissue.margin if tissue and isfinite(tissue.margin or inf) else None,
        "substeps_in_touch": trial.substeps if trial else None,
        "tick_share_in_touch": compute_tick_share(assessment.organ, assessment.facts),
        "press_depth_m": trial.depth if trial else None,
        "contact_law": find_contact_law(assessment.organ),
        "places": describe_places(assessment.organ, trial) if trial else [],
        "meant_presses": list(map(describe_meant, presses)),
        "problems": [describe_problem(p, assessment.organ.surface) for p in judged],
    }


def list_presses(
    assessment: Assessment, depth: float | None, frames: list[palpate.KeyFrame] | None
) -> list[PressFacts]:
    """Those that are meant; none of an organ that cannot be built."""
    scene, tissue = assessment.scene, assessment.facts.tissue
    if scene is None or tissue is None or tissue.trial is None:
        return []
    presses = []
    if depth is not None:
        presses += [PressFacts(depth, place) for place in tissue.trial.places]
    if frames is not None:
        deepest = measure_script(scene, frames, assessment.organ.material.wall_thickness)
        if deepest is not None:
            place = describe_place(deepest.place, deepest.validity)
            presses.append(PressFacts(deepest.depth, place))
    return presses


def find_contact_law(organ: Organ) -> str:
    """By which a ball is felt; that of a surface is the hard one, whatever it would be filled."""
    return organ.model.contact_law if organ.model.kind in WITH_NEAR_FIELD else "hard"


def describe_places(organ: Organ, trial: TrialFacts) -> list[Report]:
    """What a press feels, place by place."""
    contact = compute_contact_radius(organ.tool.radius, trial.depth)
    return [
        {
            "point_m": list(place.point),
            "home_share": place.home_share,
            "edge_m": place.edge,
            "contact_radius_m": contact,
            "times_too_stiff": place.edge and compute_patch_factor(place.edge, contact),
            "hard_force_N": place.forces and place.forces[0],
            "near_field_force_N": place.forces and place.forces[1],
            **describe_validity(place),
        }
        for place in trial.places
    ]


def describe_meant(press: PressFacts) -> Report:
    point = list(press.place.point)
    return {"depth_m": press.depth, "point_m": point, **describe_validity(press.place)}


def describe_validity(place: PlaceFacts) -> Report:
    return {
        "thickness_m": place.thickness,
        "validated_depth_m": place.validated,
        "validated_by": place.bound,
    }
