# SPDX-License-Identifier: GPL-3.0-or-later
"""The shipped organs, filled: no tetrahedron of them is a sliver."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.scene.mesh_file import read_mesh_file
from palpate_editor import authoring

PUBLISHED = Path(__file__).parents[2] / "meshes" / "published"


@pytest.mark.parametrize(
    ("organ", "cell_size", "degrees"),
    [("spleen", 8e-3, 12.1), ("kidney", 7e-3, 12.1), ("liver", 14.5e-3, 13.2)],
)
def test_a_filled_organ_has_the_smallest_dihedral_angle_that_the_page_says(
    organ, cell_size, degrees
):
    """[laws: filling]; the same surface and cell size give the same tetrahedra."""
    surface = read_mesh_file(PUBLISHED / f"{organ}.obj")

    solid = authoring.fill_interior(surface, cell_size)

    assert 2000 < len(solid.tetrahedra) < 3000
    found = np.degrees(palpate.compute_smallest_dihedral(solid))
    assert found == pytest.approx(degrees, abs=0.1)
