# SPDX-License-Identifier: GPL-3.0-or-later
"""Truths, on finer and finer meshes until forces no longer change."""

from __future__ import annotations

import numpy as np
from palpate.study.truth import Truth

from palpate_editor.truth.contact import NoContact
from palpate_editor.truth.levels import SIZES, Level, TooLarge, solve_level
from palpate_editor.truth.paths import Way
from palpate_editor.truth.progress import Asked, Told, TruthError, Watch
from palpate_editor.truth.subject import Subject
from palpate_editor.truth.tetrahedra import Floats

CHANGE = 0.03
"""[-] of a force: where a finer mesh changes less, no finer one is solved."""
FINEST, FINEST_OF_MANY = len(SIZES) - 1, 1
"""Levels of one station, and of several, which take as many times longer."""
SHARES = [1.0, 4.0, 12.0]
"""Of the work of a path, level by level, about."""


def solve_way(
    subject: Subject,
    way: Way,
    radius: float,
    depths: Floats,
    key: str,
    told: Told | None = None,
    cancelled: Asked | None = None,
    finest: int | None = None,
) -> Truth:
    """Raises TruthError where not even two meshes fit into memory, Stopped."""
    if finest is None:
        finest = FINEST if len(way.stations) == 1 else FINEST_OF_MANY
    watch = Watch(told, cancelled, SHARES[: finest + 1])
    solved: list[Level] = []
    remarks: list[str] = []
    for level in range(finest + 1):
        try:
            before = solved[-1] if solved else None
            solved.append(solve_level(subject, way.stations, radius, depths, level, watch, before))
        except NoContact as problem:
            raise TruthError(f"truth: the contact does not settle: {problem}") from None
        except TooLarge as refused:
            if len(solved) < 2:
                raise
            remarks.append(f"not solved on the finest mesh: {refused}")
            break
        if not (solved[-1].force * np.sign(depths) > 0.0).all():
            raise TruthError("truth: got a ball that touches nothing, expected a surface under it")
        if level and compare_forces(*solved[-2:]).max() < CHANGE:
            break
    error = compare_forces(*solved[-2:])
    if error.max() >= CHANGE:
        remarks.append(
            f"the last refinement of the mesh still changed a force by {error.max():.1%}"
        )
    return gather(subject, way, radius, depths, key, solved, tuple(remarks))


def compare_forces(before: Level, after: Level) -> Floats:
    """[-] (s, k)"""
    return np.abs((after.force - before.force) / after.force)


def gather(
    subject: Subject,
    way: Way,
    radius: float,
    depths: Floats,
    key: str,
    solved: list[Level],
    remarks: tuple[str, ...],
) -> Truth:
    before, last = solved[-2:]
    moved = ((last.displacement - before.displacement) ** 2).sum(axis=3).mean(axis=2)
    return Truth(
        key=key,
        law="linear",
        radius=radius,
        point=np.array([station.point for station in way.stations]),
        direction=np.array([station.direction for station in way.stations]),
        touch=np.array([station.touch for station in way.stations]),
        thickness=np.array([station.thickness for station in way.stations]),
        depth=depths,
        force=last.force,
        force_error=compare_forces(before, last),
        contact_radius=last.contact_radius,
        surface=subject.surface.x,
        displacement=last.displacement,
        displacement_error=np.sqrt(moved) / np.abs(depths),
        path=way.path,
        freedoms=last.freedoms,
        tetrahedra=last.tetrahedra,
        remarks=remarks,
    )
