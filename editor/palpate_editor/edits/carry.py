# SPDX-License-Identifier: GPL-3.0-or-later
"""Taking what was painted on one surface over to another of the same organ."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate

from palpate_editor.document import Organ, Surface


def carry_paint(organ: Organ, surface: Surface) -> Organ:
    """`organ` on `surface`, each vertex painted as the old surface is at the point closest to it.

    A factor of stiffness is interpolated; a vertex is fixed where most of its point is.
    """
    old = organ.surface
    fresh = organ.with_surface(surface)
    if old is None or not (organ.fixed.any() or (organ.stiffness_scale != 1.0).any()):
        return fresh
    tree = palpate.AabbTree(old.vertices, old.triangles)
    fixed = np.zeros(len(surface.vertices), bool)
    scale = np.ones(len(surface.vertices))
    held = organ.fixed.astype(float)
    for i, point in enumerate(surface.vertices):
        near = palpate.find_closest_point(tree, old.vertices, point)
        corners, weights = old.triangles[near.triangle], np.asarray(near.weights)
        fixed[i] = weights @ held[corners] >= 0.5
        scale[i] = weights @ organ.stiffness_scale[corners]
    return replace(fresh, fixed=fixed, stiffness_scale=scale)
