# SPDX-License-Identifier: GPL-3.0-or-later
"""Fins are dropped many at a time, as they would be one by one."""

from __future__ import annotations

import numpy as np
import pytest
from organs import surface_of
from palpate_editor.document import Surface
from palpate_editor.edits import fins
from palpate_editor.edits.fins import choose_apart, drop_fins


def with_fins(seed: int) -> Surface:
    """A ball with triangles that stand on it, on each other, and between its vertices."""
    random = np.random.default_rng(seed)
    surface = surface_of(int(random.integers(100, 300)))
    x, faces = [*np.asarray(surface.vertices)], [*np.asarray(surface.triangles).tolist()]
    for _ in range(int(random.integers(1, 50))):
        a, b = random.permutation(faces[random.integers(len(faces))])[:2]
        if random.random() < 0.25:
            near = np.argsort(np.linalg.norm(np.array(x) - x[a], axis=1))[3:12]
            c = int(random.choice(near))
            faces += [[a, b, c]] if c not in (a, b) else []
            continue
        x.append(0.5 * (x[a] + x[b]) + random.normal(size=3) * random.uniform(8e-4, 8e-3))
        faces.append([a, b, len(x) - 1])
    return Surface(np.array(x), np.array(faces))


@pytest.mark.parametrize("seed", range(30))
def test_fins_that_are_dropped_together_are_those_that_go_one_by_one(seed, monkeypatch):
    surface = with_fins(seed)
    together = drop_fins(surface)

    monkeypatch.setattr(fins, "choose_apart", lambda *given: choose_apart(*given)[:1])
    one_by_one = drop_fins(surface)

    assert len(together.triangles) < len(surface.triangles)
    assert np.array_equal(together.triangles, one_by_one.triangles)
    assert np.array_equal(together.vertices, one_by_one.vertices)


def test_fins_far_apart_are_found_at_once():
    surface = surface_of(200)
    x, faces = np.asarray(surface.vertices), np.asarray(surface.triangles)
    stand = faces[:: len(faces) // 8]
    tips = 1.1 * x[stand[:, :2]].mean(axis=1)
    fin_rows = np.column_stack([stand[:, :2], len(x) + np.arange(len(stand))])
    finned = Surface(np.concatenate([x, tips]), np.concatenate([faces, fin_rows]))
    areas = fins.compute_areas(finned)

    found = fins.find_fins(finned, areas, np.ones(len(areas), bool), 0.1 * areas.sum())

    assert set(found) == set(range(len(faces), len(areas)))
