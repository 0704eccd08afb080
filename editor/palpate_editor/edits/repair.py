# SPDX-License-Identifier: GPL-3.0-or-later
"""Repairing what reading a file could not decide alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.carry import carry_paint
from palpate_editor.edits.edit import EditError, find_surface


@dataclass(frozen=True)
class KeepLargestShell:
    """Throw away every piece of the surface but the one with the most area."""

    title: ClassVar[str] = "Keep the largest piece"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        kept = keep_largest(surface)
        if kept is surface:
            raise EditError(phrase("The surface is one piece already."))
        imported = surface if organ.imported is None else organ.imported
        whole = kept if imported is surface else keep_largest(imported)
        changed = carry_paint(organ, kept)
        decimation = organ.decimation
        if decimation is not None:
            decimation = replace(
                decimation, vertices=len(kept.vertices), triangles=len(kept.triangles)
            )
        return replace(changed, imported=whole, decimation=decimation)


def keep_largest(surface: Surface) -> Surface:
    """The shell of `surface` with the most area; the very same surface where it is the only one."""
    x, triangles = surface.vertices, surface.triangles
    shell = np.asarray(palpate.find_shells(len(x), triangles))
    side = x[triangles[:, 1:]] - x[triangles[:, :1]]
    areas = 0.5 * np.linalg.norm(np.cross(side[:, 0], side[:, 1]), axis=1)
    of_triangle = shell[triangles[:, 0]]
    largest = np.bincount(of_triangle, areas).argmax()
    kept = of_triangle == largest
    if kept.all():
        return surface
    used = np.unique(triangles[kept])
    number = np.full(len(x), -1, np.int32)
    number[used] = np.arange(len(used), dtype=np.int32)
    return Surface(x[used], number[triangles[kept]])


@dataclass(frozen=True)
class TurnOutward:
    """Turn a closed surface inside out, where its triangles face inwards."""

    title: ClassVar[str] = "Turn triangles outward"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if not palpate.is_closed(surface.triangles):
            raise EditError(phrase("A surface with holes has no outside to turn to."))
        mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)
        if palpate.compute_volume(mesh) > 0.0:
            raise EditError(phrase("The triangles face outwards already."))
        turned = replace(surface, triangles=surface.triangles[:, ::-1])
        imported = turned if organ.imported is surface else organ.imported
        # the vertices are the same, so what was painted on them is too
        return replace(organ, surface=turned, imported=imported)


@dataclass(frozen=True)
class CutCrowdedEdges:
    """Cut along edges of more than two triangles; what goes on flattest stays together."""

    title: ClassVar[str] = "Cut where more than two triangles meet"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if not len(find_crowded(surface.triangles)):
            raise EditError(phrase("No edge has more than two triangles."))
        return put_in_place(organ, cut_crowded)


def cut_crowded(surface: Surface) -> Surface:
    """The surface cut along every crowded edge; the very same where there is none."""
    if not len(find_crowded(surface.triangles)):
        return surface
    cut = authoring.cut_crowded_edges(palpate.SurfaceMesh(surface.vertices, surface.triangles))
    whole = authoring.repair_mesh(cut).mesh
    return Surface(np.asarray(whole.vertices), np.asarray(whole.triangles))


@dataclass(frozen=True)
class CutDisagreement:
    """Take out the triangles at which a one-sided surface cannot say what is outside."""

    title: ClassVar[str] = "Cut where neighbours disagree"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if not len(find_disagreeing(surface.triangles)):
            raise EditError(phrase("All neighbours agree on which side is outside."))
        return put_in_place(organ, cut_disagreement)


def cut_disagreement(surface: Surface) -> Surface:
    """The surface without those triangles; the very same where there are none."""
    wrong = find_disagreeing(surface.triangles)
    if not len(wrong):
        return surface
    kept = np.delete(surface.triangles, wrong, axis=0)
    if not len(kept):
        raise EditError(phrase("Nothing of the surface would be left."))
    whole = authoring.repair_mesh(palpate.SurfaceMesh(surface.vertices, kept)).mesh
    return Surface(np.asarray(whole.vertices), np.asarray(whole.triangles))


def put_in_place(organ: Organ, change: Callable[[Surface], Surface]) -> Organ:
    """The organ with both surfaces changed alike; what was painted is carried over."""
    surface = find_surface(organ)
    changed = change(surface)
    whole = changed
    if organ.imported is not None and organ.imported is not surface:
        whole = change(organ.imported)
    decimation = organ.decimation and replace(
        organ.decimation, vertices=len(changed.vertices), triangles=len(changed.triangles)
    )
    return replace(carry_paint(organ, changed), imported=whole, decimation=decimation)


def list_sides(triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of every side (3 t,): the number of its edge, how many triangles have that edge, and whether
    it runs from the lower vertex to the higher one."""
    sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    low, high = sides.min(axis=1).astype(np.int64), sides.max(axis=1)
    _, edge, times = np.unique((low << 32) | high, return_inverse=True, return_counts=True)
    edge = edge.ravel()
    return edge, times[edge], sides[:, 0] < sides[:, 1]


def find_crowded(triangles: np.ndarray) -> np.ndarray:
    """Triangles at edges of more than two, ascending."""
    times = list_sides(triangles)[1]
    return np.unique(np.flatnonzero(times > 2) // 3).astype(np.int32)


def find_disagreeing(triangles: np.ndarray) -> np.ndarray:
    """Triangles that share an edge with one other and run along it the same way, ascending."""
    edge, times, forward = list_sides(triangles)
    upwards = np.bincount(edge, forward)[edge]
    return np.unique(np.flatnonzero((times == 2) & (upwards != 1)) // 3).astype(np.int32)
