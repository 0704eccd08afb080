# SPDX-License-Identifier: BSD-3-Clause
"""The atlas of one organ's stability: how long a step may be before the simulation blows up.

An atlas has a row for every integrator on every tissue that the organ can be made of: its models,
at other stiffness, with other damping, on other meshes. Each has the limit that is foretold, and
the one that was found by running it. palpate_editor.atlas runs them; atlas_file keeps an atlas.
"""

from __future__ import annotations

from dataclasses import dataclass

LIMITED, NEVER, UNLIMITED, AT_REST = "limited", "never", "unlimited", "at_rest"
FAILED, REFUSED, LOST = "failed", "refused", "lost"
OUTCOMES = (LIMITED, NEVER, UNLIMITED, AT_REST, FAILED, REFUSED, LOST)
"""Of a row: it holds up to a step; no step holds, because something swings that nothing damps;
every step holds; it has no step to fail by, as it follows its loads at rest; it should hold every
step and did not; it cannot be built; the process that ran it ended, and nobody knows."""
DAMPINGS = ("none", "own", "critical")
"""Nothing is damped; as the organ is; every link is damped critically."""
MESHES = ("half", "own", "double")
"""How many tetrahedra or vertices, beside as many as the organ has."""
OWN = 1.0
"""[-] Times the organ's own stiffness."""


@dataclass(frozen=True)
class Spot:
    """A tissue that the organ can be made of."""

    kind: str
    """model.kind"""
    stiffness: float
    """[-] times the organ's own."""
    damping: str
    """One of DAMPINGS."""
    mesh: str
    """One of MESHES."""

    @property
    def is_own(self) -> bool:
        """But for its kind, what the organ is."""
        return (self.stiffness, self.damping, self.mesh) == (OWN, "own", "own")


@dataclass(frozen=True)
class Row:
    """One integrator on one tissue, with nothing in touch."""

    number: int
    """In the order of the atlas, from 0."""
    spot: Spot
    integrator: str
    """A name of palpate.Integrator."""
    outcome: str
    """One of OUTCOMES. What is None below is not for that outcome."""
    reason: str
    """In words, where it did not run."""
    particles: int
    elements: int
    """Tetrahedra, prisms, or springs and bonds."""
    predicted: float | None
    """[s] The limit that is foretold: ten ninths of palpate.stable_step; of `limited` alone."""
    held: float | None
    """[s] The longest step that held, ..."""
    failed: float | None
    """[s] ... and the shortest that did not; of `never`, within the steps of a run. None where
    none was found on that side of what was tried."""
    loss: float | None
    """[-] Of an implicit integrator, in steps of a tick: the part of a knock's energy that the
    method takes in a few ticks, beyond what the tissue's own damping does."""
    chatter: float | None
    """[-] Of the energy of motion after a knock: what changes its direction at every step."""
    softness: float | None
    """[-] Of XPBD and projective dynamics: how far it sags, over how far it should."""

    @property
    def measured(self) -> float | None:
        """[s] The limit that was found."""
        if self.held is None or self.failed is None:
            return None
        return float((self.held * self.failed) ** 0.5)


@dataclass(frozen=True)
class Present:
    """The organ's own scene, as it was when the atlas was drawn."""

    kind: str
    integrator: str
    substeps: int
    """Of a tick with nothing in touch."""
    step: float
    """[s] One of them."""
    predicted: float | None
    """[s] The limit that is foretold; None where there is none."""
    measured: float | None
    """[s] ... and that was found; None also where it was not looked for."""
    young_modulus: float
    """[Pa] material.young_modulus"""
    stiffness: float
    """[N/m] model.stiffness"""
    constants: str
    """tissue or chosen: which of the two says how stiff it is."""
    damping_ratio: float
    """[-] material.damping_ratio"""
    size: int
    """Tetrahedra that are asked for, or vertices."""


@dataclass(frozen=True)
class Atlas:
    """One organ, and every integrator on every tissue that it can be made of."""

    organ: str
    """Its title."""
    key: str
    """Hash of all that limits depend on. Rows of another key are rows of another atlas."""
    command: str
    """What draws it again."""
    rate: float
    """[Hz] of ticks."""
    steps: int
    """Of a run."""
    complete: bool
    """Every row was tried; not so after Ctrl-C."""
    present: Present
    rows: tuple[Row, ...]

    def list_kinds(self) -> list[str]:
        """The organ's own first."""
        return list(dict.fromkeys(row.spot.kind for row in self.rows))

    def list_integrators(self) -> list[str]:
        return list(dict.fromkeys(row.integrator for row in self.rows))

    def find_row(self, spot: Spot, integrator: str) -> Row | None:
        """None where it was not tried, or not yet."""
        found = (r for r in self.rows if r.spot == spot and r.integrator == integrator)
        return next(found, None)

    def find_usual(self, kind: str, integrator: str) -> Row | None:
        """Of the organ as it is, but for its kind; else on the coarser mesh."""
        rows = (self.find_row(Spot(kind, OWN, "own", mesh), integrator) for mesh in ("own", "half"))
        return next((row for row in rows if row is not None), None)

    def list_line(
        self, kind: str, integrator: str, damping: str = "own", mesh: str = "own"
    ) -> list[Row]:
        """Those that have a limit, by rising stiffness."""
        rows = [
            row
            for row in self.rows
            if (row.spot.kind, row.integrator) == (kind, integrator)
            and (row.spot.damping, row.spot.mesh) == (damping, mesh)
            and row.measured is not None
        ]
        return sorted(rows, key=lambda row: row.spot.stiffness)
