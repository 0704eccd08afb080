# SPDX-License-Identifier: GPL-3.0-or-later
"""Finding out what the rules need to know: measures the surface, builds the tissue."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
import palpate
from palpate import scenario
from palpate.command.verb import Report
from palpate.files.refusal import split_sentence
from palpate.scene.nearest import find_step
from palpate.scene.pair_friction import keep_pairs
from palpate.scene.scene_file import build_material
from palpate.scene.scene_parts import FILLED, ModelPart

from palpate_editor import authoring
from palpate_editor.compile import (
    build_organ,
    compile_organ,
    compile_with_tools,
    compute_stability_margin,
    is_built_alike,
    mesh_of,
)
from palpate_editor.document import Organ, Surface
from palpate_editor.document.cost_rules import TICK_SHARE, compute_tick_share
from palpate_editor.document.problems import (
    Facts,
    NearestFacts,
    Problem,
    SurfaceFacts,
    TissueFacts,
    WallFit,
)
from palpate_editor.document.rules import MOST_CROSSING, find_problems
from palpate_editor.edits.inspected import inspect_surface
from palpate_editor.edits.keep_outer import keep_outer
from palpate_editor.edits.nested import find_doubled
from palpate_editor.edits.repair import keep_largest
from palpate_editor.edits.unite import can_be_united
from palpate_editor.filling_quality import measure_filling, state_facts
from palpate_editor.fixes import find_fix
from palpate_editor.nearest import find_fitting
from palpate_editor.problem_places import find_around, find_faces, find_nearest_face, find_place
from palpate_editor.trial import measure_trial

ROUNDING = 1e-6
"""[-] By which a distance may be less than it was meant to be."""
measured: WeakKeyDictionary[Surface, tuple[authoring.MeshReport, SurfaceFacts]] = (
    WeakKeyDictionary()
)
"""A surface never changes, so neither does what was measured on it."""


@dataclass(frozen=True, eq=False)
class Assessment:
    """An organ, the scene it makes, and what is wrong with it."""

    organ: Organ
    scene: palpate.Scene | None
    """None where no tissue can be built."""
    report: authoring.MeshReport | None
    """Of the surface."""
    facts: Facts
    problems: tuple[Problem, ...]

    @property
    def errors(self) -> tuple[Problem, ...]:
        """What keeps the organ from being published."""
        return tuple(p for p in self.problems if p.severity == "error")


def assess(
    organ: Organ,
    *,
    tested: bool | None = None,
    before: Assessment | None = None,
    measured: Callable[[palpate.ResponseSize], None] | None = None,
) -> Assessment:
    """Measures, builds and judges an organ: up to a second for a large one, on any thread.

    Args:
        organ: What is judged.
        tested: Whether it has been felt as it is; None where nobody can know.
        before: An earlier assessment; what it built is used again where nothing it depends on has
            changed.
        measured: Told what memory a linear solid's response will take, before it is solved for.
    """
    report = surface = None
    if organ.surface is not None:
        report, surface = measure_surface(organ.surface)
    if before is not None and is_built_alike(organ, before.organ):
        scene, tissue = before.scene, before.facts.tissue
    elif surface is not None and not surface.is_manifold:
        scene, tissue = None, None
    else:
        scene, tissue = build(organ, measured)
    facts = Facts(surface, tissue, tested)
    problems = tuple(place_problem(p, organ, facts) for p in find_problems(organ, facts))
    return Assessment(organ, scene, report, facts, problems)


def place_problem(problem: Problem, organ: Organ, facts: Facts) -> Problem:
    """The problem with the edit that fixes it and the triangles where it is, where there are."""
    faces = None
    if organ.surface is not None:
        faces = find_faces(problem.key, organ.surface, measure_surface(organ.surface)[0])
        if problem.key == "reduced_wall" and facts.tissue is not None:
            faces = find_around(organ.surface.triangles, facts.tissue.reduced)
        if problem.key == "flat_tetrahedra" and facts.tissue and facts.tissue.filling:
            faces = find_nearest_face(organ.surface, facts.tissue.filling.place)
    return replace(problem, fix=find_fix(problem, organ, facts), faces=faces)


def measure_surface(surface: Surface) -> tuple[authoring.MeshReport, SurfaceFacts]:
    if surface not in measured:
        x, triangles = surface.vertices, surface.triangles
        found = inspect_surface(surface)
        edges = np.linalg.norm(x[triangles] - x[np.roll(triangles, 1, axis=1)], axis=2)
        facts = SurfaceFacts(
            shells=found.shells,
            border_loops=tuple(found.border_loops),
            outward=found.outward,
            non_manifold_edges=found.non_manifold_edges,
            self_intersecting_faces=found.self_intersecting_faces,
            triangles=found.triangles,
            orientable=found.orientable,
            largest_crosses=find_largest_crosses(surface, found),
            can_be_united=bool(found.self_intersecting_faces) and can_be_united(surface),
            smallest_angle_deg=found.smallest_angle_deg,
            mean_edge=float(edges.mean()),
            diagonal=float(palpate.compute_diagonal(x)),
            inner_shells=len(keep_outer(surface).dropped) if found.shells > 1 else 0,
            doubled_shells=count_doubled(surface, found),
            thinnest=None if found.thinnest_mm is None else 1e-3 * found.thinnest_mm,
            thin_share=len(found.thin_faces) / max(1, found.thickness_looks),
        )
        measured[surface] = found, facts
    return measured[surface]


def count_doubled(surface: Surface, report: authoring.MeshReport) -> int:
    """Asked of a surface of pieces that neither are open nor cross."""
    if report.shells == 1 or report.border_loops or report.self_intersecting_faces != 0:
        return 0
    shells = np.asarray(palpate.find_shells(len(surface.vertices), surface.triangles))
    return len(np.unique(shells[surface.triangles[find_doubled(surface), 0]]))


def find_largest_crosses(surface: Surface, report: authoring.MeshReport) -> bool | None:
    """Whether the largest piece crosses itself too much; asked where all of them together do."""
    crossing = report.self_intersecting_faces
    if report.shells == 1 or (crossing or 0) <= MOST_CROSSING * report.triangles:
        return None
    largest = keep_largest(surface)
    faces = authoring.find_self_intersecting_faces(mesh_of(largest))
    return faces is None or len(faces) > MOST_CROSSING * len(largest.triangles)


def build(
    organ: Organ, measured: Callable[[palpate.ResponseSize], None] | None = None
) -> tuple[palpate.Scene | None, TissueFacts | None]:
    """The scene, or in what words it was refused; neither where nobody could feel it anyway."""
    if organ.surface is None or organ.vertex_count > scenario.MOST_PARTICLES:
        return None, None
    home = find_default_home(organ)
    try:
        scene = compile_with_tools(organ, measured)
    except ValueError as problem:
        refusal = split_refusal(str(problem))
        allowed = find_coupling_range(organ)
        # which is of all that build_scene refuses a tissue for
        stiff = refusal[0] == "scene: tissue"
        return None, TissueFacts(
            refusal=refusal,
            coupling_range=allowed,
            default_home=home,
            nearest=find_fitting(organ) if stiff else None,
            **(count_steps(organ) if stiff else {}),
        )
    tissue = scene.bodies[0].tissue
    stable_step = palpate.stable_step(tissue)
    found = TissueFacts(
        substeps=scene.bodies[0].substeps,
        stable_step=stable_step,
        margin=compute_stability_margin(scene, stable_step),
        total_mass=palpate.compute_total_mass(tissue),
        links=len(tissue.springs.ends) + len(tissue.bonds.ends),
        tetrahedra=len(palpate.list_tetrahedra(tissue)),
        default_home=home,
        trial=measure_trial(organ, keep_first_tool(scene)),
        wall=compare_with_wall(organ, tissue),
        filling=state_facts(measure_filling(organ)) if organ.model.kind in FILLED else None,
        **find_reduced(organ, tissue),
    )
    return scene, replace(found, nearest=find_overload(organ, found))


def count_steps(organ: Organ) -> dict[str, Any]:
    """Of a tissue that no scene takes: how long a step is stable, and how many a tick then has."""
    step = find_step(build_organ(organ), organ.model.integrator)
    return {"stable_step": step, "substeps": math.ceil(1.0 / (organ.hand.rate * step))}


def find_reduced(organ: Organ, tissue: palpate.TissueModel) -> dict[str, Any]:
    """Where the faces of a wall of prisms are nearer than its thickness asks for."""
    thickness, n = organ.material.wall_thickness, organ.vertex_count
    if organ.model.kind != "shell" or thickness is None:
        return {}
    x = np.asarray(tissue.rest_position)
    share = np.linalg.norm(x[:n] - x[n : 2 * n], axis=1) * np.sqrt(3.0) / thickness
    less = np.flatnonzero(share < 1.0 - ROUNDING)
    return {"reduced": tuple(less.tolist()), "least_depth": float(share.min(initial=1.0))}


def find_overload(organ: Organ, tissue: TissueFacts) -> NearestFacts | None:
    """Of a tissue that takes more of a tick than there is, the constant that is to blame."""
    share = compute_tick_share(organ, Facts(tissue=tissue))
    if share is None or share <= TICK_SHARE:
        return None
    return find_fitting(organ, tissue.tetrahedra)


def compare_with_wall(organ: Organ, tissue: palpate.TissueModel) -> WallFit | None:
    """What a surface model makes of the material, painted stiffness taken as the material's."""
    thickness = organ.material.wall_thickness
    if thickness is None or organ.surface is None:
        return None
    scale = np.ones(len(tissue.mass))
    scale[: organ.vertex_count] = organ.stiffness_scale
    material = build_material(organ.material)
    if organ.model.kind == "shell":  # each face is half of the wall
        material.wall_thickness = 0.5 * thickness
    try:
        fit = palpate.compare_with_membrane(tissue, material, scale)
    except ValueError:
        return None
    return WallFit(fit.young_modulus, fit.poisson_ratio, fit.least, fit.most, fit.error)


def find_default_home(organ: Organ) -> float | None:
    """[N/m³] of the builder's own choice, None where it refuses the material."""
    assert organ.surface is not None
    if organ.model.kind == "shell":
        return 0.0
    try:
        return palpate.default_home_stiffness(
            mesh_of(organ.surface), build_material(organ.material)
        )
    except ValueError:
        return None


def keep_first_tool(scene: palpate.Scene) -> palpate.Scene:
    """The scene with the first of its instruments, which is what is pressed with."""
    if len(scene.instruments) == 1:
        return scene
    return palpate.build_scene(
        palpate.Scene(
            bodies=list(scene.bodies),
            instruments=keep_pairs(scene.instruments[:1], range(len(scene.bodies))),
            gravity=scene.gravity,
            rate=scene.rate,
        )
    )


def split_refusal(sentence: str) -> tuple[str, str, str]:
    """Where, found and expected of a refusal of the library."""
    return split_sentence(sentence) or ("model", sentence, "a tissue that can be built")


def find_coupling_range(organ: Organ) -> tuple[float, float] | None:
    """[N] the stretch-bend that every triangle can take; None where that is not what is wrong.

    A hair of coupling, in place of what was refused, shows each triangle's share of it.
    """
    hair = 1e-12
    if organ.model.kind != "molecular" or organ.model.angle_law != "gradient":
        return None
    if organ.model.constants != "chosen":
        return None
    if organ.model.stretch_coupling == 0.0:
        return None
    model: ModelPart = replace(organ.model, stretch_coupling=hair)
    try:
        scene = compile_organ(replace(organ, model=model))
    except ValueError:
        return None
    angles = scene.bodies[0].tissue.angles
    shares = np.asarray(angles.stretch_coupling) / hair
    low, high = -np.inf, np.inf
    for row, share in enumerate(shares):
        allowed = palpate.find_coupling_range(angles, row, share.tolist())
        if allowed is None:
            return None
        low, high = max(low, allowed.low), min(high, allowed.high)
    if low < organ.model.stretch_coupling < high or not low < high:
        return None
    return float(low), float(high)


def describe_problem(problem: Problem, surface: Surface | None = None) -> Report:
    """`surface` is that of the organ, for the place."""
    faces = problem.faces
    placed = surface is not None and faces is not None and len(faces) > 0
    return {
        "severity": problem.severity,
        "stage": problem.stage,
        "problem": problem.key,
        "where": problem.where,
        "got": problem.got,
        "expected": problem.expected,
        "fix": problem.fix.title if problem.fix else None,
        "triangles": len(faces) if placed else None,
        "place_m": find_place(surface, faces) if placed else None,
    }


def describe_model(scene: palpate.Scene) -> str:
    tissue = scene.bodies[0].tissue
    links = len(tissue.springs.ends) + len(tissue.bonds.ends)
    tetrahedra = len(palpate.list_tetrahedra(tissue))
    solid = f"{tetrahedra} tetrahedra, " if tetrahedra else ""
    if scene.bodies[0].response is not None:
        moves = f"a response of {1e-6 * scene.bodies[0].response.size.bytes:.1f} MB"
    else:
        moves = f"{scene.bodies[0].substeps} substeps"
    return (
        f"{len(tissue.mass)} particles, {links} links, {solid}total mass "
        f"{1e3 * palpate.compute_total_mass(tissue):.1f} g, {moves}"
    )
