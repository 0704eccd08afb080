# SPDX-License-Identifier: GPL-3.0-or-later
"""The key of a truth: a hash of all that it depends on."""

from __future__ import annotations

import hashlib
import json
from importlib.metadata import version

import numpy as np

from palpate_editor.document import Organ
from palpate_editor.truth import contact, levels, solve, subject
from palpate_editor.truth.paths import Way
from palpate_editor.truth.tetrahedra import Floats

METHOD = 1
"""Of the solver: another number where it gives something else."""


def compute_key(organ: Organ, way: Way, radius: float, depths: Floats) -> str:
    """Of an organ that has a surface."""
    assert organ.surface is not None
    material = organ.material
    numbers = [
        METHOD, way.path, radius, levels.SIZES, levels.SLOPE, contact.PENALTY, solve.CHANGE,
        levels.MOST_MEMORY, subject.COARSEST, subject.FINER,
        material.young_modulus, material.poisson_ratio, material.wall_thickness,
        version("scikit-fem"),
    ]  # fmt: skip
    hashed = hashlib.sha256(json.dumps(numbers).encode())
    arrays = (
        organ.surface.vertices, organ.surface.triangles, organ.fixed, organ.stiffness_scale, depths,
        *(part for s in way.stations for part in (s.point, s.direction)),
    )  # fmt: skip
    for station in way.stations:
        if station.hold is not None:
            hashed.update(json.dumps([station.hold.stiffness, station.hold.grip]).encode())
    for values in arrays:
        hashed.update(f"{values.dtype.str} {values.shape} ".encode())
        hashed.update(np.ascontiguousarray(values).tobytes())
    return hashed.hexdigest()[:32]
