# SPDX-License-Identifier: GPL-3.0-or-later
"""From constants that the tissue gives to constants that are chosen: where the choosing begins."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
from palpate.scene.scene_file import build_tissue
from palpate.scene.scene_parts import ModelPart, SceneFile

from palpate_editor.document import Organ

MOST_HALVINGS = 12
"""Of a stretch-bend that some triangle cannot take; after these it is 0."""


def adopt_constants(organ: Organ) -> Organ:
    """The organ with chosen constants, each the mean of what its tissue gives.

    Where no tissue can be built the numbers stay what they were. One stretch-bend for all triangles
    may be more than some can take: it is halved until all can.
    """
    chosen = replace(organ, model=replace(organ.model, constants="chosen"))
    if organ.surface is None:
        return chosen
    mesh = palpate.SurfaceMesh(organ.surface.vertices, organ.surface.triangles)
    try:
        tissue = build(organ, organ.model, mesh)
    except ValueError:
        return chosen
    model = compute_means(tissue, chosen.model)
    for _ in range(MOST_HALVINGS):
        try:
            build(organ, model, mesh)
        except ValueError:
            model = replace(model, stretch_coupling=0.5 * model.stretch_coupling)
        else:
            return replace(organ, model=model)
    return replace(organ, model=replace(model, stretch_coupling=0.0))


def build(organ: Organ, model: ModelPart, mesh: palpate.SurfaceMesh) -> palpate.TissueModel:
    """Without what was painted, which multiplies chosen constants as well."""
    plain = replace(model, fixed=(), stiffness_scale=())
    scene = SceneFile(
        organ=None, material=organ.material, model=plain, tool=organ.tool, hand=organ.hand
    )
    return build_tissue(scene, mesh)


def compute_means(tissue: palpate.TissueModel, model: ModelPart) -> ModelPart:
    if model.kind == "mass_spring":
        return replace(model, stiffness=float(np.mean(tissue.springs.stiffness)))
    angles = tissue.angles
    # a bond inside the surface is twice a triangle's share of it; the means of constants that may
    # be negative are held to what uniform ones may be
    least = 0.0 if model.angle_law == "eq10" else -np.inf
    return replace(
        model,
        stiffness=max(2.0 * float(np.mean(angles.bond_share)), 1e-3),
        bend_stiffness=max(float(np.mean(angles.bend_stiffness)), least),
        stretch_coupling=float(np.mean(angles.stretch_coupling)),
    )
