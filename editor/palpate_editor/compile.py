# SPDX-License-Identifier: GPL-3.0-or-later
"""From what a designer decided to what ticks: Organ -> Scene."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import palpate
from palpate.assessment.instruments import shape_tools
from palpate.files.refusal import Refusal
from palpate.scene.scene_file import build_tissue, compile_scene
from palpate.scene.scene_parts import FILLED, SceneFile

from palpate_editor.document import Organ, Surface
from palpate_editor.document.far_compliance import find_far_compliance
from palpate_editor.fill import build_filled


def mesh_of(surface: Surface) -> palpate.SurfaceMesh:
    return palpate.SurfaceMesh(surface.vertices, surface.triangles)


def surface_of(mesh: palpate.SurfaceMesh) -> Surface:
    return Surface(np.asarray(mesh.vertices), np.asarray(mesh.triangles))


def parts_of(organ: Organ) -> SceneFile:
    """The organ's numbers as a scene file has them, with what was painted among them."""
    scale = organ.stiffness_scale
    model = replace(
        organ.model,
        fixed=tuple(np.flatnonzero(organ.fixed).tolist()),
        stiffness_scale=tuple(scale.tolist()) if (scale != 1.0).any() else (),
    )
    return SceneFile(
        organ=None, material=organ.material, model=model, tool=organ.tool, hand=organ.hand
    )


def compile_organ(
    organ: Organ, measured: Callable[[palpate.ResponseSize], None] | None = None
) -> palpate.Scene:
    """A scene that ticks. Raises ValueError naming what is wrong.

    Takes as long as finding the largest eigenvalues does, and filling a solid: some tenths of a
    second for a large organ, on any thread; a linear solid's response some seconds, and `measured`
    is told its size before.
    """
    if organ.surface is None:
        raise ValueError("organ: got no surface, expected an imported mesh")
    tissue = build_organ(organ)
    if measured is not None and len(tissue.elastic.corners):
        measured(palpate.measure_response(tissue))
    far = find_far_compliance(organ)
    return compile_scene(parts_of(organ), mesh_of(organ.surface), tissue, far)


def compile_with_tools(
    organ: Organ, measured: Callable[[palpate.ResponseSize], None] | None = None
) -> palpate.Scene:
    """The same with the instruments that the organ's task names. Raises ValueError likewise."""
    scene = compile_organ(organ, measured)
    if not organ.assessment:
        return scene
    try:
        return shape_tools("assessment", json.loads(organ.assessment), scene)
    except Refusal as refusal:
        where, found, expected = refusal.where, refusal.got, refusal.expected
        raise ValueError(f"{where}: got {found}, expected {expected}") from None


def list_tools(organ: Organ) -> dict[str, Any]:
    """What the organ's task says of its instruments, by name; none without a task."""
    tools = json.loads(organ.assessment).get("tools") if organ.assessment else None
    return tools if isinstance(tools, dict) else {}


def build_organ(organ: Organ) -> palpate.TissueModel:
    """The tissue alone, of an organ that has a surface. Raises ValueError naming what is wrong."""
    if organ.model.kind in FILLED:
        return build_filled(organ)
    assert organ.surface is not None
    return build_tissue(parts_of(organ), mesh_of(organ.surface))


BUILT_FROM = (
    *("surface", "material", "model", "fill", "filling", "far_field", "fixed", "stiffness_scale"),
    *("tool", "hand"),
)
"""What of an organ its scene depends on, but for the regions that its filling
names."""


def is_built_alike(one: Organ, other: Organ) -> bool:
    """Whether two organs are known to make the same scene: they differ at most in texts."""
    alike = all(is_alike(getattr(one, name), getattr(other, name)) for name in BUILT_FROM)
    if one.assessment != other.assessment and list_tools(one) != list_tools(other):
        return False
    return alike and all(
        one.regions.get(getattr(one.fill, name)) is other.regions.get(getattr(other.fill, name))
        for name in ("reach", "fine_region")
    )


def is_alike(one: object, other: object) -> bool:
    if one is other:
        return True
    # arrays that an edit made are taken to differ; parts of a few numbers are compared
    return not isinstance(one, np.ndarray | Surface) and one == other


def compute_stability_margin(scene: palpate.Scene, stable_step: float | None = None) -> float:
    """How many times longer the tissue's steps could be before they may become unstable at rest.

    At least 1: the substeps are chosen so, and contact raises them as it needs (scene.cpp).
    `stable_step` [s] is that of the tissue, where it is known.
    """
    longest = palpate.stable_step(scene.bodies[0].tissue) if stable_step is None else stable_step
    return float(longest * scene.rate * scene.bodies[0].substeps)
