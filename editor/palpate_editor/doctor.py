# SPDX-License-Identifier: GPL-3.0-or-later
"""All that can be said of a surface before a tissue is chosen: what it is, what is wrong, and the
step of the tissue that it would get."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import palpate

from palpate_editor.authoring import MeshReport
from palpate_editor.check import measure_surface, place_problem
from palpate_editor.compile import build_organ
from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.document.defaults import WALL_THICKNESS
from palpate_editor.document.problems import Facts, Problem
from palpate_editor.document.rules import (
    find_decimate_problems,
    find_import_problems,
    find_repair_problems,
)
from palpate_editor.document.shape_rules import find_shape_problems
from palpate_editor.edits.repair import find_disagreeing
from palpate_editor.problem_places import find_around

CROSSING = ("crossing", "self_intersections")
"""Problems of repair that decimating can make."""
MOST_STEPPED = 60_000
"""Vertices of a surface whose tissue is built to find its step: more would take seconds."""


@dataclass(frozen=True)
class StableStep:
    """The longest step at which a tissue is stable at rest, or why nobody knows."""

    step: float | None = None
    """[s]"""
    substeps: int | None = None
    """Of a tick at the rate of the organ's hand."""
    kind: str = ""
    """Of the model that was built."""
    wall: float | None = None
    """[m] taken for an open surface that has none."""
    refusal: str = ""


def find_stable_step(organ: Organ) -> StableStep:
    """Of the tissue that the organ has, or would get: builds it, up to a second for a large one."""
    surface, wall = organ.surface, None
    if surface is None:
        return StableStep(refusal="no surface")
    if len(surface.vertices) > MOST_STEPPED:
        return StableStep(refusal=f"more than {MOST_STEPPED} vertices: decimate first")
    if not measure_surface(surface)[1].is_manifold:
        return StableStep(refusal="no tissue can be built before the surface is repaired")
    if organ.material.wall_thickness is None and not palpate.is_closed(surface.triangles):
        wall = WALL_THICKNESS
        organ = replace(organ, material=replace(organ.material, wall_thickness=wall))
    try:
        step = palpate.stable_step(build_organ(organ))
    except ValueError as refused:
        return StableStep(kind=organ.model.kind, wall=wall, refusal=str(refused))
    substeps = int(np.ceil(1.0 / (organ.hand.rate * step)))
    return StableStep(step, substeps, organ.model.kind, wall)


def list_surface_problems(organ: Organ) -> list[Problem]:
    """What is wrong with a surface before anything is built on it, with places and fixes."""
    assert organ.surface is not None
    facts = Facts(measure_surface(organ.surface)[1])
    found = [
        *find_import_problems(organ, facts),
        *find_repair_problems(organ, facts),
        *find_shape_problems(organ, facts),
    ]
    return [place_problem(p, organ, facts) for p in found]


def list_decimated(organ: Organ) -> list[Problem]:
    """What decimating has made worse, and a size that no organ of its name has."""
    assert organ.surface is not None
    facts = Facts(measure_surface(organ.surface)[1])
    found = [p for p in find_import_problems(organ, facts) if p.key == "size"]
    found += [p for p in find_repair_problems(organ, facts) if p.key in CROSSING]
    found += find_decimate_problems(organ, facts)
    return [place_problem(p, organ, facts) for p in found]


def list_repaired(surface: Surface, report: MeshReport) -> Iterator[Problem]:
    """What is wrong with a surface as its file has it that importing it repairs."""
    rows = [
        ("duplicates", report.duplicate_faces,
         phrase("{count} triangles that are there twice", count=len(report.duplicate_faces)),
         phrase("each once: importing removes the others")),
        ("flat", report.degenerate_faces,
         phrase("{count} triangles of no height", count=len(report.degenerate_faces)),
         phrase("triangles that have an area: importing flips these away or removes them")),
        ("pinched", find_around(surface.triangles, report.pinched_vertices),
         phrase("{count} points where surfaces touch and no edge is shared",
                count=len(report.pinched_vertices)),
         phrase("surfaces that hang together by edges: importing parts them there")),
        ("winding", find_disagreeing(surface.triangles) if report.disagreeing_edges else [],
         phrase("{count} edges at which neighbours face different sides",
                count=report.disagreeing_edges),
         phrase("one outside: importing turns triangles until neighbours agree, where they can")),
    ]  # fmt: skip
    for key, faces, got, expected in rows:
        if len(faces):
            places = np.asarray(faces, np.int32)
            yield Problem(key, "note", "import", "file", got, expected, faces=places)
    if report.outward is False and not report.disagreeing_edges:
        yield Problem(
            "inside_out", "note", "import", "file",
            phrase("triangles that face inwards"), phrase("outwards: importing turns them"),
        )  # fmt: skip
