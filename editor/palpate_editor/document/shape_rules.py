# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules about the shape of a surface: parts too thin for its triangles."""

from __future__ import annotations

from collections.abc import Iterator

from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import phrase
from palpate_editor.document.problems import Facts, Problem

MOST_THIN = 0.02
"""[-] of the triangles may stand on parts thinner than half their edges: rims have some."""


def find_shape_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Parts of a solid that its triangles are too large for."""
    found = facts.surface
    if found is None or found.border_loops or not found.is_manifold or found.thinnest is None:
        return
    if organ.material.wall_thickness is None and found.thin_share > MOST_THIN:
        yield Problem(
            "thin",
            "note",
            "decimate",
            "surface",
            phrase(
                "parts thinner than half of their triangles' edges under {share:.0%} of them, "
                "{thinnest:.2g} mm at the thinnest",
                share=found.thin_share,
                thinnest=1e3 * found.thinnest,
            ),
            phrase("more vertices, or a wall of a thickness (Material)"),
        )
