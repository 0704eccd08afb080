# SPDX-License-Identifier: BSD-3-Clause
"""What a ball feels of a body of tissue along a path: the truth that models are held against.

Solved by palpate_editor.truth, which owns meshing and the solver. Nothing here solves.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Truth:
    """Forces at rest over s stations of a path and k depths, on a surface of m points.

    A press has one station; a drag one for every place that was solved, in the order in which the
    tool passes them; a pull one, with negative depths.
    """

    key: str
    """Of all that it depends on: surface, what is held, material, tool, stations, depths."""
    law: str
    """linear or neo_hookean."""
    radius: float
    """[m] of the ball."""
    point: Floats
    """[m] (s, 3) on the surface at rest."""
    direction: Floats
    """Unit (s, 3), outward: the ball goes against it."""
    touch: Floats
    """[m] (s,) Height of the ball's centre over the point at its first touch."""
    thickness: Floats
    """[m] (s,) of the body under the point; a hollow one with its far wall."""
    depth: Floats
    """[m] (k,) of the ball beyond its first touch; rising away from 0."""
    force: Floats
    """[N] (s, k) along the direction."""
    force_error: Floats
    """[-] (s, k) of the force: what the last refinement of the mesh changed."""
    contact_radius: Floats
    """[m] (s, k)"""
    surface: Floats
    """[m] (m, 3) points of the surface at rest, where displacements are compared."""
    displacement: Floats
    """[m] (s, k, m, 3) of them."""
    displacement_error: Floats
    """[-] (s, k) of the depth: root mean square of what the last refinement changed."""
