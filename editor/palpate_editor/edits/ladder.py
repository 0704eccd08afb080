# SPDX-License-Identifier: GPL-3.0-or-later
"""Repairing a surface step by step, the least invasive first, and saying what each did.

A rung looks at the organ as it is by then and gives an edit, or none where there is nothing for it
to do. What one rung repairs the next ones need not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import pi

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Organ, Phrase, Surface, phrase
from palpate_editor.document.organ_sizes import LEAST, MOST, find_fitting_unit
from palpate_editor.document.rules import FAR_OFF, MOST_CROSSING, find_organ_word
from palpate_editor.edits.change import find_change, say_change
from palpate_editor.edits.clean import CleanUp, DropPieces, StitchBorders, measure_pieces
from palpate_editor.edits.crossings import RemoveCrossings, say_left
from palpate_editor.edits.edit import Edit, EditError, find_surface
from palpate_editor.edits.fill_holes import FillHoles
from palpate_editor.edits.fins import DropFins
from palpate_editor.edits.inspected import inspect_surface, mesh_of
from palpate_editor.edits.nested import DropDoubled, find_doubled
from palpate_editor.edits.orient import METRES, SetUnit
from palpate_editor.edits.repair import (
    CutCrowdedEdges,
    CutDisagreement,
    KeepLargestShell,
    TurnOutward,
    keep_largest,
)
from palpate_editor.edits.unite import UniteShells, can_be_united
from palpate_editor.edits.wall import has_chosen_wall
from palpate_editor.edits.wrap import Wrap
from palpate_editor.guarded import check_wanted

DAMAGE = 0.1
"""[-] A hole is damage where a circle as long as its rim has less than this part of the area of its
piece: the rim of a sheet or a bowl has half of it and more."""
NESTED = 0.02
"""[-] of the diagonal: pieces that reach out of the largest one by less lie inside it."""

Tell = Callable[[str], None]
"""Hears the title of the rung that is being climbed."""


@dataclass(frozen=True)
class Rung:
    """One step that was taken."""

    title: str
    did: tuple[Phrase, ...]
    """What is different since, and the price of it."""


@dataclass(frozen=True, eq=False)
class Climb:
    """An organ at the top of the ladder."""

    organ: Organ
    rungs: tuple[Rung, ...]
    left: tuple[Phrase, ...]
    """What is still wrong, and where; empty where nothing is."""


@dataclass(frozen=True, eq=False)
class State:
    """An organ part of the way up, and what its surface is like."""

    organ: Organ
    surface: Surface
    report: authoring.MeshReport

    @classmethod
    def of(cls, organ: Organ) -> State:
        surface = find_surface(organ)
        return cls(organ, surface, inspect_surface(surface))

    @property
    def is_manifold(self) -> bool:
        return not self.report.non_manifold_edges and self.report.orientable

    @property
    def crosses(self) -> bool:
        """So much that no tissue can be built on it."""
        crossing = self.report.self_intersecting_faces
        return crossing is None or crossing > MOST_CROSSING * self.report.triangles


# ---------------------------------------------------------------- the rungs


def choose_unit(state: State) -> Edit | None:
    """Another unit, where no organ is as large and one unit alone makes it one."""
    source = state.organ.source
    size = float(palpate.compute_diagonal(state.surface.vertices))
    if source is None or LEAST / FAR_OFF <= size <= FAR_OFF * MOST:
        return None
    unit = find_fitting_unit(size / METRES[source.unit], find_organ_word(state.organ))
    return None if unit in (None, source.unit) else SetUnit(unit)


def choose_cutting(state: State) -> Edit | None:
    return CutCrowdedEdges() if state.report.non_manifold_edges else None


def choose_fins(state: State) -> Edit | None:
    return DropFins() if state.report.non_manifold_edges else None


def choose_stitching(state: State) -> Edit | None:
    return StitchBorders() if state.report.border_loops else None


def choose_disagreement(state: State) -> Edit | None:
    return None if state.report.orientable else CutDisagreement()


def choose_dropping(state: State) -> Edit | None:
    return DropPieces() if state.report.shells > 1 else None


def choose_filling(state: State) -> Edit | None:
    """The holes that are damage; none of an organ that is told to be hollow."""
    if not state.is_manifold or not state.report.border_loops:
        return None
    if has_chosen_wall(state.organ):
        return None
    holes = tuple(find_damage(state.surface))
    return FillHoles(holes, even=True, bent=True) if holes else None


def choose_turning(state: State) -> Edit | None:
    return TurnOutward() if state.report.outward is False else None


def choose_uniting(state: State) -> Edit | None:
    """Closed pieces that cross become one solid."""
    if state.report.shells == 1 or state.report.self_intersecting_faces == 0:
        return None
    return UniteShells() if can_be_united(state.surface) else None


def choose_uncrossing(state: State) -> Edit | None:
    if not state.is_manifold or state.report.self_intersecting_faces == 0:
        return None
    return RemoveCrossings()


def choose_largest(state: State) -> Edit | None:
    """Pieces that cross go where they lie inside the largest one, and that one is sound."""
    if not state.crosses or state.report.shells == 1:
        return None
    largest = keep_largest(state.surface)
    faces = authoring.find_self_intersecting_faces(mesh_of(largest))
    if faces is None or len(faces) > MOST_CROSSING * len(largest.triangles):
        return None
    return KeepLargestShell() if lies_inside(state.surface, largest) else None


def choose_nested(state: State) -> Edit | None:
    """Pieces inside of others that face outwards too, of a surface that is sound."""
    report = state.report
    if report.shells == 1 or report.border_loops or not state.is_manifold or state.crosses:
        return None
    return DropDoubled() if find_doubled(state.surface).any() else None


def choose_wrapping(state: State) -> Edit | None:
    """Where nothing else has made it a surface that a tissue can be built on."""
    return Wrap(past_holes=True) if state.crosses or not state.is_manifold else None


CLEAN_UP = CleanUp()
RUNGS: tuple[Callable[[State], Edit | None], ...] = (
    choose_unit,
    lambda state: CLEAN_UP,
    choose_stitching,
    choose_fins,
    choose_cutting,
    choose_disagreement,
    choose_dropping,
    choose_stitching,
    choose_filling,
    # what was open beside an open piece is debris beside a closed one
    choose_dropping,
    lambda state: CLEAN_UP,
    choose_uniting,
    choose_uncrossing,
    choose_uniting,
    choose_largest,
    choose_wrapping,
    choose_turning,
    choose_nested,
)
"""From the bottom to the top."""


def find_damage(surface: Surface) -> Iterator[int]:
    """Numbers of the holes that are small beside their piece."""
    pieces = measure_pieces(surface)
    shell = np.zeros(len(surface.vertices), int)
    shell[surface.triangles] = pieces.of_triangle[:, None]
    for hole, loop in enumerate(palpate.find_border_loops(surface.triangles)):
        x = surface.vertices[loop]
        rim = float(np.linalg.norm(x - np.roll(x, 1, axis=0), axis=1).sum())
        if rim * rim < 4.0 * pi * DAMAGE * pieces.areas[shell[loop[0]]]:
            yield hole


def lies_inside(surface: Surface, largest: Surface) -> bool:
    """Whether no vertex reaches out of the largest piece by more than a little."""
    tree = palpate.AabbTree(largest.vertices, largest.triangles)
    normals = np.asarray(palpate.compute_vertex_normals(largest.vertices, largest.triangles))
    most = NESTED * float(palpate.compute_diagonal(surface.vertices))
    for point in surface.vertices:
        near = palpate.find_closest_point(tree, largest.vertices, point)
        corners = largest.triangles[near.triangle]
        away = point - np.asarray(near.weights) @ largest.vertices[corners]
        out = away @ (np.asarray(near.weights) @ normals[corners])
        if out > 0.0 and np.linalg.norm(away) > most:
            return False
    return True


# ---------------------------------------------------------------- the way up


def climb(organ: Organ, tell: Tell = lambda title: None) -> Climb:
    """Repairs all that can be repaired. Raises EditError where there is no surface, and
    guarded.Cancelled once it is no longer wanted."""
    state = State.of(organ)
    rungs: list[Rung] = []
    gave_up: list[Phrase] = []
    for choose in RUNGS:
        check_wanted()
        edit = choose(state)
        if edit is None:
            continue
        tell(edit.title)
        try:
            after = edit(state.organ)
        except EditError as refused:
            # what other rungs leave is told by what the surface is like in the end
            gave_up += [refused.sentence] if isinstance(edit, Wrap) else []
            continue
        rungs.append(Rung(edit.title, tuple(say_rung(edit, state.organ, after))))
        state = State.of(after)
    return Climb(state.organ, tuple(rungs), (*find_left(state), *gave_up))


def say_rung(edit: Edit, before: Organ, after: Organ) -> Iterator[Phrase]:
    change = find_change(edit, before, after)
    if change is not None:
        yield from say_change(change)


def find_left(state: State) -> Iterator[Phrase]:
    """What is still wrong."""
    report = state.report
    if report.non_manifold_edges:
        yield phrase("{count} edges with more than two triangles", count=report.non_manifold_edges)
    if not report.orientable:
        yield phrase("a surface with one side only, like a Moebius band")
    if report.self_intersecting_faces != 0:
        yield say_left(state.surface)
    if report.border_loops:
        yield from say_holes(state)
    if report.shells > 1:
        yield phrase("{count} pieces that nothing holds together", count=report.shells)


def say_holes(state: State) -> Iterator[Phrase]:
    """Those that were left as they are, and those that could not be filled."""
    damage = 0 if has_chosen_wall(state.organ) else len(list(find_damage(state.surface)))
    others = len(state.report.border_loops) - damage
    if others:
        yield phrase(
            "{count} holes that are no damage: a hollow organ or a sheet has them", count=others
        )
    if damage:
        yield phrase(
            "{count} small holes that no patch fits: it would touch another hole or the surface",
            count=damage,
        )
