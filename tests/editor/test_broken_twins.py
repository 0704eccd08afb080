# SPDX-License-Identifier: GPL-3.0-or-later
"""Organs damaged in every way that was seen all open, and become simulable by one call."""

from __future__ import annotations

from pathlib import Path

import palpate
import pytest
from palpate_editor.check import Assessment, measure_surface
from palpate_editor.document import EMPTY
from palpate_editor.document.rules import MOST_CROSSING
from palpate_editor.edits import import_file
from palpate_editor.repair_all import repair_all
from tiers import keep_everyday
from twin_files import CLASSES, write_twin

SEEDS = range(6)
SIMULABLE = 0.95
"""[-] of the twins, at least."""


def open_and_repair(name: str, seed: int, folder: Path) -> Assessment:
    """What is known of a twin once all that can be repaired is. Raises FileError."""
    return repair_all(import_file(write_twin(name, seed, folder))(EMPTY))[0]


def is_simulable(assessment: Assessment) -> bool:
    """Whether a tissue is built and no stage of the surface has an error left."""
    wrong = [p for p in assessment.errors if p.stage in ("import", "repair", "material")]
    return assessment.scene is not None and not wrong


@pytest.mark.parametrize("name", keep_everyday(CLASSES, list(CLASSES)[::3]))
def test_a_twin_opens_and_becomes_simulable(name, tmp_path):
    found = open_and_repair(name, 0, tmp_path)

    assert is_simulable(found), [(p.key, p.got) for p in found.errors]
    surface = found.organ.surface
    facts = measure_surface(surface)[1]
    assert facts.is_manifold
    assert facts.self_intersecting_faces <= MOST_CROSSING * facts.triangles
    palpate.validate(palpate.SurfaceMesh(surface.vertices, surface.triangles))


@pytest.mark.parametrize(
    "seeds",
    [
        pytest.param(SEEDS[1:2], marks=pytest.mark.landing, id="sample"),
        pytest.param(SEEDS, marks=pytest.mark.verify, id="all"),
    ],
)
def test_of_all_twins_all_open_and_all_but_a_few_become_simulable(seeds, tmp_path):
    """Prints the table: pytest -s -m verify tests/editor/test_broken_twins.py -k all_twins"""
    failed = 0
    for name in CLASSES:
        wrong = [s for s in seeds if not is_simulable(open_and_repair(name, s, tmp_path))]
        failed += len(wrong)
        print(f"{name:24} {len(seeds) - len(wrong)} of {len(seeds)}", *(f"not {s}" for s in wrong))

    count = len(CLASSES) * len(seeds)
    print(f"{count - failed} of {count} simulable")
    assert failed <= (1.0 - SIMULABLE) * count
