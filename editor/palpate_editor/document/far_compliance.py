# SPDX-License-Identifier: GPL-3.0-or-later
"""What of an organ's far field is felt, and whether it is that of this organ at all."""

from __future__ import annotations

import hashlib
import json

import numpy as np
from palpate.scene.scene_parts import FILLED

from palpate_editor.document.organ import Organ


def compute_key(organ: Organ) -> str:
    """Of an organ that has a surface: another one where its far field may be another."""
    assert organ.surface is not None
    hashed = hashlib.sha256(json.dumps(organ.material.poisson_ratio).encode())
    surface = organ.surface
    for values in (surface.vertices, surface.triangles, organ.fixed, organ.stiffness_scale):
        hashed.update(f"{values.dtype.str} {values.shape} ".encode())
        hashed.update(np.ascontiguousarray(values).tobytes())
    return hashed.hexdigest()[:32]


def wants_far_field(organ: Organ) -> bool:
    """Whether it is felt by a near field, as a solid through and through."""
    return (
        organ.surface is not None
        and organ.model.kind in FILLED
        and organ.model.contact_law == "near_field"
        and organ.material.wall_thickness is None
    )


def is_stale(organ: Organ) -> bool:
    """Whether it has a far field that was solved for something else."""
    return (
        organ.far_field is not None
        and organ.surface is not None
        and organ.far_field.key != compute_key(organ)
    )


def find_far_compliance(organ: Organ) -> np.ndarray | None:
    """[m/N] (n, 6) of the surface, of an organ that has a far field and a use for it."""
    if organ.far_field is None or not wants_far_field(organ) or is_stale(organ):
        return None
    material = organ.material
    modulus = material.young_modulus / (1.0 - material.poisson_ratio**2)
    return np.asarray(organ.far_field.tensors / modulus)
