# SPDX-License-Identifier: GPL-3.0-or-later
"""Patches over holes that go on in the planes of the triangles at the rim, where it allows that.

A torn rim goes up and down: its next edge may leave the plane of a triangle at the rim, or the next
triangle lie in another plane. No patch goes on smoothly over both, so such edges are left as they
are.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import acos, degrees, sqrt

import numpy as np

from palpate_editor.document import Surface
from palpate_editor.edits.even_patch import (
    ADMITTED,
    Edge,
    Patch,
    Point,
    crosses_more,
    dot,
    edge_of,
    find_normal,
    mean,
    subtract,
)

MOST_TURN = 30.0
"""[degree] By so much a patch may turn from the triangle at the rim."""
ROUNDS, STEPS = 10, 12
"""Rounds of steps of bending, each with the triangles made even again."""
TOWARDS, EVEN, INNER = 0.6, 0.1, 0.5
"""[-] Of the way to the planes of the rim in a step, and to the middle of the neighbours, for
vertices next to the rim and for those within."""


Rating = tuple[int, float]
"""See rate: less is better."""


class Rim:
    """The edges of a surface along a patch: planes of its triangles there, and which of the edges
    allow a patch to go on smoothly."""

    def __init__(self, patch: Patch, surface: Surface):
        edges = [edge for edge, faces in patch.list_edges().items() if len(faces) == 1]
        wanted = set(edges)
        ends = list({v for edge in edges for v in edge})
        rows = surface.triangles[np.isin(surface.triangles, ends).sum(axis=1) >= 2].tolist()
        self.normal: dict[Edge, Point] = {}
        self.onwards: dict[Edge, Point] = {}
        """Unit vectors in the triangles' planes, away from them across the edges."""
        for t in rows:
            for edge in (edge_of(t[i], t[(i + 1) % 3]) for i in range(3)):
                if edge in wanted:
                    a, b, c = (tuple(surface.vertices[v].tolist()) for v in t)
                    self.normal[edge] = find_normal(a, b, c)
                    self.onwards[edge] = find_onwards(patch.x, edge, mean([a, b, c]))
        at: dict[int, list[Edge]] = {}
        for edge in self.normal:
            for v in edge:
                at.setdefault(v, []).append(edge)
        self.smooth = {e for e in self.normal if self.is_smooth(e, at, patch.x)}

    def is_smooth(self, edge: Edge, at: dict[int, list[Edge]], x: dict[int, Point]) -> bool:
        """The edges next to it are in its triangle's plane, and their triangles as well, within
        MOST_TURN."""
        n = self.normal[edge]
        for v in edge:
            for other in at[v]:
                if other == edge:
                    continue
                along = subtract(x[other[1]], x[other[0]])
                rise = abs(dot(along, n)) / max(sqrt(dot(along, along)), 1e-300)
                if rise > np.sin(np.radians(MOST_TURN)):
                    return False
                if turn_between(n, self.normal[other]) > MOST_TURN:
                    return False
        return True

    def list_turns(self, patch: Patch) -> dict[Edge, float]:
        """[degree] By how much the patch turns from the triangle at each edge that allows it not
        to."""
        edges = patch.list_edges()
        return {
            edge: turn_between(
                self.normal[edge], find_normal(*(patch.x[v] for v in patch.triangles[face]))
            )
            for edge in sorted(self.smooth)
            for face in edges.get(edge, [])
        }


def turn_between(m: Point, n: Point) -> float:
    """[degree]"""
    return degrees(acos(max(-1.0, min(1.0, dot(m, n)))))


def bend_patches(closed: Surface, surface: Surface) -> Surface:
    """`closed`, which is `surface` and patches over holes of it, with patches bent into the planes
    at their rims; the very same where nothing turns by more than MOST_TURN, where that would make
    it less even, or would cross something."""
    begun = Patch(closed, len(surface.vertices), len(surface.triangles)), closed
    rim = Rim(begun[0], surface)
    found = closed, rate(begun[0], rim)
    for edges in (rim.normal, rim.smooth):
        if found[1][0] > 0:
            found = bend_in_rounds(begun, rim, edges, found)
    return found[0]


def bend_in_rounds(
    begun: tuple[Patch, Surface], rim: Rim, edges: Iterable[Edge], so_far: tuple[Surface, Rating]
) -> tuple[Surface, Rating]:
    """From what was found so far towards the planes at some of the edges."""
    before, closed = begun
    count = len(closed.triangles) - len(before.triangles)
    patch = Patch(so_far[0], before.first, count)
    for _ in range(ROUNDS):
        for _ in range(STEPS):
            bend(patch, rim, edges)
            so_far = choose_better(patch, rim, begun, so_far)
        patch.split_long()
        patch.collapse_short()
        patch.flip()
        so_far = choose_better(patch, rim, begun, so_far)
        if so_far[1][0] == 0:
            break
    return so_far


def choose_better(
    patch: Patch, rim: Rim, begun: tuple[Patch, Surface], so_far: tuple[Surface, Rating]
) -> tuple[Surface, Rating]:
    """The patch as it is, where it is as even as that which was begun with, and better than what
    was found so far."""
    before, closed = begun
    rating = rate(patch, rim)
    if rating >= so_far[1]:
        return so_far
    count = len(closed.triangles) - len(before.triangles)
    made = patch.build(closed, before.first, count)
    if find_excess(Patch(made, before.first, count)) > max(1.0, find_excess(before)):
        return so_far
    return so_far if crosses_more(made, closed) else (made, rating)


def find_excess(patch: Patch) -> float:
    """[-] How many times beyond what is admitted the most uneven edge is; at most 1 of an even
    patch."""
    ratios = [ratio for ratio, _ in patch.list_inner()]
    if not ratios:
        return 1.0
    low, high = ADMITTED
    return max(max(ratios) / high, low / min(ratios))


def rate(patch: Patch, rim: Rim) -> Rating:
    """How many edges turn by more than MOST_TURN, and the sum of what they do beyond it."""
    beyond = [turn - MOST_TURN for turn in rim.list_turns(patch).values() if turn > MOST_TURN]
    return len(beyond), sum(beyond)


def bend(patch: Patch, rim: Rim, towards: Iterable[Edge]) -> None:
    """A step of every vertex of the patch that is not on the rim."""
    edges = patch.list_edges()
    pulls: dict[int, list[Edge]] = {}
    for edge in sorted(towards):
        for face in edges.get(edge, []):
            for v in patch.triangles[face]:
                if v >= patch.first:
                    pulls.setdefault(v, []).append(edge)
    for v in sorted(v for v in patch.x if v >= patch.first):
        p = patch.x[v]
        middle = mean([patch.x[w] for w in sorted(patch.neighbours(v))])
        turned = [turn_onwards(patch.x, p, e, rim.onwards[e]) for e in pulls.get(v, [])]
        target = mean(turned or [p])
        even = EVEN if v in pulls else INNER
        x, y, z = (
            p[i] + TOWARDS * (target[i] - p[i]) + even * (middle[i] - p[i]) for i in range(3)
        )
        place = (x, y, z)
        if all(patch.may_move(face, {v: place}) for face in patch.around[v]):
            patch.x[v] = place


def find_foot(x: dict[int, Point], p: Point, edge: Edge) -> Point:
    """The point of the line through an edge that is closest to `p`."""
    a, along = x[edge[0]], subtract(x[edge[1]], x[edge[0]])
    s = dot(subtract(p, a), along) / max(dot(along, along), 1e-300)
    return a[0] + s * along[0], a[1] + s * along[1], a[2] + s * along[2]


def find_onwards(x: dict[int, Point], edge: Edge, inside: Point) -> Point:
    across = subtract(find_foot(x, inside, edge), inside)
    size = max(sqrt(dot(across, across)), 1e-300)
    return across[0] / size, across[1] / size, across[2] / size


def turn_onwards(x: dict[int, Point], p: Point, edge: Edge, onwards: Point) -> Point:
    """Turned about an edge into the plane of its triangle, on the other side of it."""
    foot = find_foot(x, p, edge)
    away = subtract(p, foot)
    height = sqrt(dot(away, away))
    a, b, c = (foot[i] + height * onwards[i] for i in range(3))
    return a, b, c
