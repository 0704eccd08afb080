# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball at the stations of a path, on one graded mesh: forces and displacements of a level."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sparse

from palpate_editor.truth.contact import PENALTY, Contact, Patch, press_ball
from palpate_editor.truth.elasticity import Body, Press, find_lame
from palpate_editor.truth.graded import Grading, Skin, refine
from palpate_editor.truth.hold import Hold, pull_ball
from palpate_editor.truth.patches import (
    compute_shapes,
    condense,
    condense_whole,
    find_footprint,
    find_nodes,
    place_ball,
)
from palpate_editor.truth.progress import TruthError, Watch
from palpate_editor.truth.subject import Subject
from palpate_editor.truth.tetrahedra import Floats, Ints, find_surface

SIZES = (2.0, 2.8, 4.0)
"""Edges within the radius of the ball, near the place: from the coarsest mesh to the finest."""
SLOPE = (1.1, 0.8, 0.6)
"""By how much edges grow per distance."""
MOST_MEMORY = 4e9
"""[bytes] A mesh that needs more is not begun."""
MARGIN = 1.15
"""[-] Of the farthest point that is touched on a mesh: how far a finer one is looked at."""
STAGES = {"mesh": 0.05, "stiffness": 0.15, "factor": 0.35, "response": 1.0}
"""[-] of a level's work that is done at the end of each."""


@dataclass(frozen=True)
class Station:
    """Where the ball goes into the body, and from where."""

    point: Floats
    """[m] (3,) on the surface at rest."""
    direction: Floats
    """Unit (3,), outward: the ball goes against it."""
    touch: float
    """[m] Height of the ball's centre over the point at its first touch."""
    thickness: float
    """[m] of the body under the point."""
    hold: Hold | None = None
    """How the ball takes hold; None where it only presses."""

    def find_deepest(self, depth: float) -> float:
        """[m] that the ball goes into the surface on its way to a depth [m]."""
        return depth if self.hold is None else self.hold.grip


@dataclass(frozen=True)
class Level:
    """What one mesh gives at s stations and k depths, on m points of the surface."""

    force: Floats
    """[N] (s, k)"""
    contact_radius: Floats
    """[m] (s, k)"""
    displacement: Floats
    """[m] (s, k, m, 3)"""
    extent: Floats
    """[m] (s,) from the axis to the farthest point that is touched."""
    freedoms: int
    tetrahedra: int


class TooLarge(TruthError):
    """A mesh that does not fit into memory."""


def estimate_memory(freedoms: int) -> float:
    """[bytes] that assembling and factorising take: nested dissection of a body fills its factor
    as n^(4/3). Measured from 26 000 to 122 000 freedoms."""
    return 4.5e3 * freedoms + 215.0 * freedoms ** (4.0 / 3.0)


def check_memory(freedoms: int) -> None:
    """Raises TooLarge."""
    need = estimate_memory(freedoms)
    if need > MOST_MEMORY:
        raise TooLarge(
            f"truth: got a mesh of {freedoms} freedoms, which takes {1e-9 * need:.1f} GB, expected "
            f"at most {1e-9 * MOST_MEMORY:g} GB: a larger ball or a shorter path asks for less"
        )


def solve_level(
    subject: Subject,
    stations: Sequence[Station],
    radius: float,
    depths: Floats,
    level: int,
    watch: Watch,
    before: Level | None = None,
) -> Level:
    """Every station at every depth on the mesh of a level. Raises TooLarge, TruthError, Stopped.

    `before` is what a coarser mesh gave; what is far from the contact there is left out here.
    """

    def tell(stage: str, part: float) -> None:
        names = list(STAGES)
        at = names.index(stage)
        first = STAGES[names[at - 1]] if at else 0.0
        watch.tell(level, stage, first + part * (STAGES[stage] - first))

    tell("mesh", 0.0)
    deepest = float(np.abs(depths).max())
    x, t = grade(subject, stations, radius, deepest, level)
    tell("stiffness", 0.0)
    press = build_press(subject, x, t)
    check_memory(press.size)
    _ = press.matrix
    tell("factor", 0.0)
    _ = press.factor
    seen = interpolate_surface(press.body, find_surface(t), subject.surface)
    contacts, displacement, extents = [], [], []
    for at, station in enumerate(stations):
        reach = min(radius, 1.45 * float(np.sqrt(radius * station.find_deepest(deepest))))
        if before is not None:
            reach = min(reach, MARGIN * float(before.extent[at]) + 0.5 * radius / SIZES[level])
        patch, found = solve_station(
            subject, press, station, radius, depths, reach,
            lambda part, at=at: tell("response", (at + part) / len(stations)),
        )  # fmt: skip
        contacts.append(found)
        extents.append(max(float(patch.beside[c.on].max(initial=0.0)) for c in found))
        displacement.append(respond(press, station, patch, found, seen))
    tell("response", 1.0)
    return Level(
        np.array([[contact.force for contact in found] for found in contacts]),
        np.array([[contact.radius for contact in found] for found in contacts]),
        np.array(displacement),
        np.array(extents),
        press.size,
        len(t),
    )


def grade(
    subject: Subject, stations: Sequence[Station], radius: float, depth: float, level: int
) -> tuple[Floats, Ints]:
    """The mesh of a level with small tetrahedra where the ball touches."""
    deepest = max(station.find_deepest(depth) for station in stations)
    wide = float(np.sqrt(radius * deepest))
    # what is gripped may be much smaller than the ball, and all of its force is there
    held = any(station.hold is not None for station in stations)
    grading = Grading(
        np.array([station.point for station in stations]),
        (min(radius, 2.0 * wide) if held else radius) / SIZES[level],
        min(1.1 * radius, 1.5 * wide),
        SLOPE[level],
    )
    x, t = subject.build(level)
    return refine(x, t, grading, subject.surface if subject.is_snapped else None)


def build_press(subject: Subject, x: Floats, t: Ints) -> Press:
    lame = find_lame(subject.young_modulus, subject.poisson_ratio)
    scale = None if subject.scale is None else subject.scale(x[t].mean(axis=1))
    held = subject.held(x, find_surface(t))
    if not len(held):
        raise TruthError("truth: got a mesh of which no facet is held, expected some held ones")
    return Press(Body(x, t, lame, 2, 0, {"held": held}, scale), "held", "held")


def solve_station(
    subject: Subject,
    press: Press,
    station: Station,
    radius: float,
    depths: Floats,
    reach: float,
    told: Callable[[float], None],
) -> tuple[Patch, list[Contact]]:
    under = find_footprint(press.body, station.point, station.direction, reach, radius)
    axis, penalty = station.direction, PENALTY * subject.plane_modulus / radius
    if station.hold is None:
        patch = condense(press, under, station.point, axis, radius, station.touch, told)
        return patch, press_ball(patch, depths, penalty)
    compliance = condense_whole(press, under, told)
    patch = place_ball(press, under, compliance, station.point, axis, radius, station.touch)
    return patch, pull_ball(patch, compliance, axis, station.hold, depths, penalty)


def respond(
    press: Press, station: Station, patch: Patch, found: Sequence[Contact], seen: sparse.csr_matrix
) -> Floats:
    """[m] (k, m, 3) of the surface's points under the pushes of a station's contacts."""
    at = 3 * np.searchsorted(press.free, patch.nodes)[:, None] + np.arange(3)
    loads = np.zeros((press.size, len(found)))
    for k, contact in enumerate(found):
        push = contact.push
        loads[at, k] = push if push.ndim == 2 else -push[:, None] * station.direction
    moved = np.zeros((len(found), press.body.node_count, 3))
    moved[:, press.free] = press.factor(loads).T.reshape(len(found), -1, 3)
    return np.stack([seen @ u for u in moved])


def interpolate_surface(body: Body, faces: Ints, skin: Skin) -> sparse.csr_matrix:
    """(m, nodes) What the skin's vertices move from what the nodes of a P2 body do: they go with
    the closest points of its boundary `faces`."""
    x = body.basis.mesh.p.T
    closest, triangle = Skin(x, faces).project(skin.x)
    a, b, c = (x[faces[triangle, k]] for k in range(3))
    u, v = b - a, c - a
    normal = np.cross(u, v)
    square = (normal**2).sum(axis=1)
    second = (np.cross(closest - a, v) * normal).sum(axis=1) / square
    third = (np.cross(u, closest - a) * normal).sum(axis=1) / square
    weights = np.stack([1.0 - second - third, second, third], axis=1)
    rows = np.repeat(np.arange(len(skin.x)), 6)
    columns = find_nodes(body, faces[triangle]).ravel()
    values = compute_shapes(weights).ravel()
    return sparse.csr_matrix((values, (rows, columns)), shape=(len(skin.x), body.node_count))
