# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles that stand on a surface like fins, at edges that have two others already."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.clean import DEBRIS, compute_areas, take
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.repair import find_crowded, list_sides, put_in_place


@dataclass(frozen=True)
class DropFins:
    """Drop what stands on the surface and ends freely, where the surface goes on without it."""

    title: ClassVar[str] = "Drop fins"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if not len(find_crowded(surface.triangles)):
            raise EditError(phrase("No edge has more than two triangles."))
        if drop_fins(surface) is surface:
            raise EditError(phrase("Nothing stands on it that ends freely."))
        return put_in_place(organ, drop_fins)


def drop_fins(surface: Surface) -> Surface:
    """Fin by fin, the smallest first, for one may stand on another; the very same surface where
    there is none."""
    kept = np.ones(len(surface.triangles), bool)
    areas = compute_areas(surface)
    most = DEBRIS * areas.sum()
    while len(fins := find_fins(surface, areas, kept, most)):
        kept[fins] = False
    return surface if kept.all() else take(surface, kept)


def find_fins(surface: Surface, areas: np.ndarray, kept: np.ndarray, most: float) -> np.ndarray:
    """The triangles of the smallest fins among those that are left; empty for none.

    A fin hangs together by edges of two triangles, has a border, stands on an edge of more than
    two that has two others, and has an area of at most `most` [m²]. `areas` [m²] (triangles,).
    """
    rows = np.flatnonzero(kept)
    edge, times, _ = list_sides(surface.triangles[rows])
    patch = find_patches(len(rows), edge, times)
    sides = patch.repeat(3)
    count = patch.max() + 1 if len(patch) else 0
    free = np.zeros(count, bool)
    free[sides[times == 1]] = True
    stands, holds = np.zeros(count, bool), np.ones(count, bool)
    crowded = times > 2
    pairs, own = np.unique(
        np.column_stack([edge[crowded], sides[crowded]]), axis=0, return_counts=True
    )
    all_there = np.bincount(edge[crowded], minlength=1)
    left = all_there[pairs[:, 0]] - own
    stands[pairs[:, 1]] = True
    # what is left at each of its edges is a surface that goes on, or is crowded still
    holds[pairs[left < 2, 1]] = False
    sizes = np.bincount(patch, areas[rows], minlength=count)
    fins = np.flatnonzero(free & stands & holds & (sizes <= most))
    chosen = choose_apart(fins[np.argsort(sizes[fins], kind="stable")], sizes, pairs)
    return rows[np.isin(patch, chosen)]


def choose_apart(fins: np.ndarray, sizes: np.ndarray, pairs: np.ndarray) -> list[int]:
    """Of fins, the smallest first, as many as would be found in this order one by one.

    Where one is gone, only what meets at its edges is another: a fin that has none of these, and
    beside which nothing smaller has one, is as it was, and so is all that would come before it.
    `pairs` (n, 2) are edges of more than two triangles with the patches there.
    """
    edges_of: dict[int, list[int]] = {}
    patches_at: dict[int, list[int]] = {}
    for edge, patch in pairs.tolist():
        edges_of.setdefault(patch, []).append(edge)
        patches_at.setdefault(edge, []).append(patch)
    chosen: list[int] = []
    changed: set[int] = set()
    for fin in fins.tolist():
        around = {other for edge in edges_of[fin] for other in patches_at[edge]}
        near = {edge for other in around if sizes[other] <= sizes[fin] for edge in edges_of[other]}
        if changed & near:
            break
        chosen.append(fin)
        changed.update(edges_of[fin])
    return chosen


def find_patches(count: int, edge: np.ndarray, times: np.ndarray) -> np.ndarray:
    """(count,) which triangles hang together by edges of two, numbered from 0; `edge` and `times`
    as `list_sides` has them."""
    two = np.flatnonzero(times == 2)
    two = two[np.argsort(edge[two], kind="stable")]
    ends = (two // 3).reshape(-1, 2)
    # neighbours as the corners of triangles: who hangs together is asked of them
    links = np.column_stack([ends, ends[:, 1]]).astype(np.int32)
    shell = np.asarray(palpate.find_shells(count, links))
    alone = shell < 0
    shell[alone] = shell.max(initial=-1) + 1 + np.arange(alone.sum())
    return np.unique(shell, return_inverse=True)[1]
