# SPDX-License-Identifier: BSD-3-Clause
"""F13: slivers, as a poor decimation leaves them: told, remeshed, and then as stable as before."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
import pytest
from palpate_editor.check import assess
from palpate_editor.compile import build_organ
from palpate_editor.document import Organ, Surface
from palpate_editor.document.rules import ANGLE_LEAST
from palpate_editor.edits import Remesh
from palpate_editor.shipped import make_organ


def with_slivers(organ: Organ, count: int = 12) -> Organ:
    """Every so many a triangle gets a vertex within it, a hundredth from one of its sides."""
    x, triangles = organ.surface.vertices, organ.surface.triangles
    chosen = np.linspace(0, len(triangles) - 1, count).astype(int)
    a, b, c = x[triangles[chosen]].transpose(1, 0, 2)
    near = 0.495 * a + 0.495 * b + 0.01 * c
    added = len(x) + np.arange(count)
    i, j, k = triangles[chosen].T
    split = [np.column_stack(t) for t in ((i, j, added), (j, k, added), (k, i, added))]
    rows = np.concatenate((np.delete(triangles, chosen, axis=0), *split)).astype(np.int32)
    surface = Surface(np.concatenate((x, near)), rows)
    return replace(organ.with_surface(surface), imported=surface, decimation=None)


@pytest.fixture(scope="module")
def even() -> Organ:
    organ = make_organ("spleen", 300)
    model = replace(organ.model, kind="molecular", stiffness=60.0, bend_stiffness=1e-5,
                    contact_law="hard", home_stiffness=3e5)  # fmt: skip
    return replace(organ, model=model)


def find_step(organ: Organ) -> float:
    """[s]"""
    return float(palpate.stable_step(build_organ(organ)))


def test_f13_slivers_are_told_by_their_angle_and_shorten_the_step(even):
    found = assess(with_slivers(even))

    [problem] = [p for p in found.problems if p.key == "angles"]
    assert found.facts.surface.smallest_angle_deg < 5.0
    assert f"at least {ANGLE_LEAST:g}" in problem.expected
    assert len(problem.faces) >= 12
    assert find_step(with_slivers(even)) < 0.7 * find_step(even)


def test_f13_remeshed_the_organ_is_stable_at_the_step_it_had_without_slivers(even):
    mean = float(assess(even).facts.surface.mean_edge)

    repaired = Remesh(mean)(with_slivers(even))

    assert assess(repaired).facts.surface.smallest_angle_deg > ANGLE_LEAST
    assert find_step(repaired) > 0.8 * find_step(even)
