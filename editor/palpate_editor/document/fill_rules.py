# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules about what a solid is filled with."""

from __future__ import annotations

from collections.abc import Iterator

from palpate.scene.scene_parts import FILLED

from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import phrase
from palpate_editor.document.problems import Facts, Problem

COUNT_ERROR = 0.1
"""[-] By how much another number of tetrahedra may come than was asked for, without a word."""
LEAST_DIHEDRAL = 5.0
"""[degree] Between two faces: a flatter tetrahedron asks for shorter steps and is stiffer than its
tissue. Improved fillings have 7 and more."""


def find_filling_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    yield from find_own_problems(organ)
    tissue = facts.tissue
    if tissue is None or tissue.filling is None:
        return
    found = tissue.filling
    if found.smallest_angle_deg < LEAST_DIHEDRAL:
        x, y, z = (1e3 * each for each in found.place)
        yield Problem(
            "flat_tetrahedra",
            "warning",
            "material",
            "fill.tetrahedra",
            phrase(
                "faces of a tetrahedron at {angle:.1f} degrees to each other, at ({x:.0f}, "
                "{y:.0f}, {z:.0f}) mm",
                angle=found.smallest_angle_deg,
                x=x,
                y=y,
                z=z,
            ),
            phrase(
                "at least {least:g}: another number of tetrahedra, or a surface without a narrow "
                "edge there",
                least=LEAST_DIHEDRAL,
            ),
        )
    share = tissue.tetrahedra / found.asked - 1.0
    if organ.fill.sizing == "counted" and abs(share) > COUNT_ERROR:
        yield Problem(
            "other_count",
            "warning",
            "material",
            "fill.tetrahedra",
            phrase("{count} tetrahedra, {share:+.0%}", count=tissue.tetrahedra, share=share),
            phrase(
                "{asked}, to a tenth: the shape of the surface allows no such number",
                asked=found.asked,
            ),
        )


def find_own_problems(organ: Organ) -> Iterator[Problem]:
    """The file's own tetrahedra fill a surface that is as it was read, where as many are asked."""
    if organ.filling is None or organ.model.kind not in FILLED:
        return
    count, fill = len(organ.filling.tetrahedra), organ.fill
    if organ.surface is organ.imported and fill.tetrahedra == count and not fill.fine_region:
        return
    yield Problem(
        "own_filling",
        "note",
        "material",
        "fill.tetrahedra",
        phrase("{count} tetrahedra of the file, which are not used", count=count),
        phrase("the surface as it was read, {count} tetrahedra, and no finer region", count=count),
    )
