# SPDX-License-Identifier: GPL-3.0-or-later
"""Organs damaged in every way that was seen all open, and become simulable by one call."""

from __future__ import annotations

from pathlib import Path

import palpate
import pytest
from broken_twins import DAMAGES, make_twin
from foreign_files import write_obj
from palpate_editor.check import Assessment, measure_surface
from palpate_editor.document import EMPTY
from palpate_editor.document.rules import MOST_CROSSING
from palpate_editor.edits import import_file
from palpate_editor.repair_all import repair_all

SEEDS = range(6)
SIMULABLE = 0.95
"""[-] of the twins, at least."""


def open_and_repair(name: str, seed: int, folder: Path) -> Assessment:
    """What is known of a twin once all that can be repaired is. Raises FileError."""
    path = folder / f"{seed}.obj"
    write_obj(path, *make_twin(name, seed))
    return repair_all(import_file(path)(EMPTY))[0]


def is_simulable(assessment: Assessment) -> bool:
    """Whether a tissue is built and no stage of the surface has an error left."""
    wrong = [p for p in assessment.errors if p.stage in ("import", "repair", "material")]
    return assessment.scene is not None and not wrong


@pytest.mark.parametrize("name", DAMAGES)
def test_a_twin_opens_and_becomes_simulable(name, tmp_path):
    found = open_and_repair(name, 0, tmp_path)

    assert is_simulable(found), [(p.key, p.got) for p in found.errors]
    surface = found.organ.surface
    facts = measure_surface(surface)[1]
    assert facts.is_manifold
    assert facts.self_intersecting_faces <= MOST_CROSSING * facts.triangles
    palpate.validate(palpate.SurfaceMesh(surface.vertices, surface.triangles))


@pytest.mark.landing
def test_of_all_twins_all_open_and_all_but_a_few_become_simulable(tmp_path):
    failed = [
        (name, seed)
        for name in DAMAGES
        for seed in SEEDS
        if not is_simulable(open_and_repair(name, seed, tmp_path))
    ]

    count = len(DAMAGES) * len(SEEDS)
    print(f"{count - len(failed)} of {count} simulable; not: {failed}")
    assert len(failed) <= (1.0 - SIMULABLE) * count, failed
