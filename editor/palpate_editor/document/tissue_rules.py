# SPDX-License-Identifier: GPL-3.0-or-later
"""The rule about where the stiffness of a tissue comes from."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from palpate_editor.document.constants import find_constant
from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import Phrase, phrase
from palpate_editor.document.problems import Problem
from palpate_editor.document.tissue import AppliedTissue

SAME = 1e-9
"""[-] Relative; a stiffness further from the tissue's was changed since."""


def find_tissue_problems(organ: Organ) -> Iterator[Problem]:
    """A stiffness that nobody has looked up is said as long as it is in force."""
    for tissue in organ.tissues:
        if tissue.status == "checked" or not is_in_force(organ, tissue):
            continue
        recalled = tissue.status == "recalled"
        yield Problem(
            "recalled_tissue" if recalled else "own_tissue",
            "warning" if recalled else "note",
            "material",
            f"tissues.{tissue.region}" if tissue.region else "material.young_modulus",
            describe(tissue),
            phrase("a value that was read in its source, or that you have measured"),
        )


def describe(tissue: AppliedTissue) -> Phrase:
    constant = find_constant("material", "young_modulus")
    assert constant is not None
    value = constant.describe(tissue.young_modulus)
    if tissue.status == "recalled":
        return phrase(
            "{value} of {tissue}, recalled and not looked up ({source})",
            value=value,
            tissue=tissue.title,
            source=tissue.source,
        )
    return phrase(
        "{value} of {tissue}, a value of your own that no publication stands for",
        value=value,
        tissue=tissue.title,
    )


def is_in_force(organ: Organ, tissue: AppliedTissue) -> bool:
    """Whether the organ, or the region, still has the stiffness that was taken."""
    stiffness = organ.material.young_modulus
    if not tissue.region:
        return abs(stiffness - tissue.young_modulus) <= SAME * tissue.young_modulus
    ids = organ.regions.get(tissue.region)
    if ids is None or not ids.size:
        return False
    found = stiffness * organ.stiffness_scale[ids]
    return bool(np.all(np.abs(found - tissue.young_modulus) <= SAME * tissue.young_modulus))
