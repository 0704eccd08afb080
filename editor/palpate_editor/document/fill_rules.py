# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules about what a solid is filled with."""

from __future__ import annotations

from collections.abc import Iterator

from palpate.scene.scene_parts import FILLED

from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import Phrase, phrase
from palpate_editor.document.problems import Facts, Problem

COUNT_ERROR = 0.1
"""[-] By how much another number of tetrahedra may come than was asked for, without a word."""
LEAST_DIHEDRAL = 5.0
"""[degree] Between two faces: a flatter tetrahedron asks for shorter steps and is stiffer than its
tissue. Improved fillings have 7 and more."""


def find_filling_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    yield from find_own_problems(organ)
    tissue = facts.tissue
    if tissue is None:
        return
    yield from find_other_count(organ, tissue.tetrahedra)
    if tissue.filling is None:
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


def find_other_count(organ: Organ, made: int) -> Iterator[Problem]:
    """Whether a solid has as many tetrahedra as were asked for."""
    asked = organ.fill.tetrahedra
    if made and abs(made - asked) > COUNT_ERROR * asked:
        yield Problem(
            "filling",
            "note",
            "material",
            "fill.tetrahedra",
            say_difference(made, asked),
            say_filling(organ),
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


def say_filling(organ: Organ) -> Phrase:
    """What there should be, and how to have it."""
    asked = organ.fill.tetrahedra
    if organ.fill.sizing == "estimated":
        return phrase(
            "about {asked}: it was filled by an estimate; ask for a number again, and they are "
            "counted",
            asked=asked,
        )
    return phrase("about {asked}; what is thin takes more than a few", asked=asked)


def say_difference(made: int, asked: int) -> Phrase:
    share = abs(made / asked - 1.0)
    if made < asked:
        return phrase(
            "{made}, {share:.0%} fewer than the {asked} that were asked for",
            made=made,
            share=share,
            asked=asked,
        )
    return phrase(
        "{made}, {share:.0%} more than the {asked} that were asked for",
        made=made,
        share=share,
        asked=asked,
    )
