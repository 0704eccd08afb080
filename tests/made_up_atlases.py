# SPDX-License-Identifier: BSD-3-Clause
"""Atlases made up for tests of what reads, keeps, draws and follows them: nothing of it ran."""

from __future__ import annotations

from dataclasses import replace

from palpate.scene.scene_parts import INTEGRATORS
from palpate.study.atlas import (
    DAMPINGS,
    LIMITED,
    MESHES,
    NEVER,
    OWN,
    REFUSED,
    UNLIMITED,
    Atlas,
    Present,
    Row,
    Spot,
)

EXPLICIT = {"symplectic_euler": 1.0, "midpoint": 0.7, "runge_kutta_4": 1.4, "explicit_euler": 0.2}
LIMIT = 1e-3
"""[s] Of symplectic Euler on the organ as it is."""
SIZES = dict(zip(MESHES, (1.3, 1.0, 0.7), strict=True))
DAMPED = dict(zip(DAMPINGS, (1.1, 1.0, 0.5), strict=True))


def make_row(number: int, spot: Spot, integrator: str) -> Row:
    """A stiffness four times as large halves the limit; what was found is a tenth above."""
    row = Row(number, spot, integrator, LIMITED, "", 700, 4000, *[None] * 6)
    share = EXPLICIT.get(integrator)
    if share is None:
        return replace(row, outcome=UNLIMITED, loss=0.3, chatter=0.1, softness=None)
    limit = share * LIMIT * SIZES[spot.mesh] * DAMPED[spot.damping] / spot.stiffness**0.5
    if spot.damping == "none" and integrator in ("explicit_euler", "midpoint"):
        return replace(row, outcome=NEVER, failed=0.1 * limit)
    return replace(row, predicted=limit, held=1.09 * limit, failed=1.11 * limit)


def make_atlas(kind: str = "solid", integrator: str = "symplectic_euler") -> Atlas:
    """Of two models; the second has one row that was refused."""
    spots = [Spot(kind, s, "own", "own") for s in (0.01, 0.1, OWN, 10.0, 100.0)]
    spots += [Spot(kind, OWN, d, "own") for d in DAMPINGS if d != "own"]
    spots += [Spot(kind, OWN, "own", m) for m in MESHES if m != "own"]
    spots.append(Spot("molecular", OWN, "own", "own"))
    rows = [make_row(0, spot, name) for spot in spots for name in INTEGRATORS]
    rows[-1] = replace(
        rows[-1], outcome=REFUSED, reason="angles without energy", loss=None, chatter=None
    )
    return Atlas(
        organ="Spleen",
        key="0" * 64,
        command="palpate stability spleen.organ",
        rate=1000.0,
        steps=240,
        complete=True,
        present=Present(
            kind=kind,
            integrator=integrator,
            substeps=2,
            step=5e-4,
            predicted=LIMIT if integrator in EXPLICIT else None,
            measured=1.1 * LIMIT if integrator in EXPLICIT else None,
            young_modulus=5e3,
            stiffness=50.0,
            constants="tissue",
            damping_ratio=0.3,
            size=4000,
        ),
        rows=tuple(replace(row, number=i) for i, row in enumerate(rows)),
    )
