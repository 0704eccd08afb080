# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be wrong or doubtful about an organ, as values: the window shows them, `check` prints.

The rules need to know what was measured on the surface and what came of building the tissue. That
comes to them as `Facts`, found out by palpate_editor.check, so they need neither.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import Phrase

SEVERITIES = ("error", "warning", "note")
"""An error cannot be published; a warning will be felt; a note is worth knowing."""


@dataclass(frozen=True)
class Problem:
    """One thing to fix, or to know."""

    key: str
    """What kind of problem, for programs; the same whatever the numbers."""
    severity: str
    stage: str
    where: str
    got: Phrase
    expected: Phrase
    fix: Callable[[Organ], Organ] | None = field(default=None, compare=False)
    """An edit that fixes it, where one is sure to."""
    faces: np.ndarray | None = field(default=None, compare=False)
    """The triangles where it is, of a problem that is somewhere on the surface."""


@dataclass(frozen=True)
class SurfaceFacts:
    """What was measured on a surface."""

    shells: int
    border_loops: tuple[int, ...]
    """Vertices of each."""
    outward: bool | None
    non_manifold_edges: int
    self_intersecting_faces: int | None
    triangles: int
    orientable: bool
    """Whether neighbours can agree on which side is outside."""
    largest_crosses: bool | None
    """Whether the largest piece alone crosses itself too much; None where that was not asked."""
    can_be_united: bool
    """Whether its pieces cross each other, and each is closed and does not cross itself."""
    smallest_angle_deg: float | None
    mean_edge: float
    """[m]"""
    diagonal: float
    """[m] of the bounding box."""
    inner_shells: int = 0
    """Pieces that are not seen from outside."""
    doubled_shells: int = 0
    """Closed pieces that lie inside of others and face outwards too: their volume counts twice."""
    thinnest: float | None = None
    """[m] of the body behind a triangle; None where none ends there."""
    thin_share: float = 0.0
    """[-] of the triangles looked behind: there the body is thinner than half their edges."""

    @property
    def is_manifold(self) -> bool:
        """Whether a tissue can be built on it: two triangles at an edge, two sides."""
        return not self.non_manifold_edges and self.orientable


@dataclass(frozen=True)
class WallFit:
    """How a tissue of springs and bonds compares with a wall of its material, at rest."""

    young_modulus: float
    """[Pa] of the wall nearest to it."""
    poisson_ratio: float
    least: float
    """[-] of the material's stiffness, in the softest strain anywhere."""
    most: float
    error: float
    """[-] root mean square over area."""


@dataclass(frozen=True)
class PlaceFacts:
    """What came of pressing the tissue at one place."""

    point: tuple[float, float, float]
    """[m] on the surface at rest."""
    home_share: float | None = None
    """[-] of the felt force that home springs carry; None where there are none, or where it was not
    pressed or nothing was felt."""
    edge: float | None = None
    """[m] of the tetrahedra at the surface there; None for a surface."""
    thickness: float | None = None
    """[m] of the organ along the press, a hollow one with its far wall; None for a sheet."""
    validated: float = 0.0
    """[m] How deep the tool may go for its force to be validated; 0 for no depth."""
    bound: str = "tip"
    """Which length that comes from: thickness, radius or wall; tip where that is too small or too
    large itself."""
    forces: tuple[float, float] | None = None
    """[N] felt at the depth of the trial under the hard law and by the near field, of a solid that
    has the hard law; None of any other, and where it was not pressed."""


@dataclass(frozen=True)
class PressFacts:
    """A press that someone means to make."""

    depth: float
    """[m] of the hand's tip below the surface at rest."""
    place: PlaceFacts


@dataclass(frozen=True)
class NearestFacts:
    """A constant with which the tissue cannot be felt, and the nearest value with which it can."""

    key: str
    """As in the table of constants: "model.stiffness"."""
    value: float
    """[SI] as it is."""
    limit: float
    """[SI] the nearest that would do."""
    substeps: int = 0
    """A tick that it asks for at rest; 0 where it is not for want of these."""
    excess: float = 0.0
    """[-] decades by which it is farther from what is usual than tissues differ."""


@dataclass(frozen=True)
class TrialFacts:
    """What came of pressing the tissue, place by place."""

    depth: float
    """[m] of each press."""
    substeps: int
    """Per tick, the most that a press takes; those in the air where nothing was felt."""
    places: tuple[PlaceFacts, ...] = ()
    blown: NearestFacts | None = None
    """Where a light touch ends in an alarm, the constant that does it."""

    @property
    def home_shares(self) -> tuple[float, ...]:
        """[-] Of the places that have one."""
        return tuple(p.home_share for p in self.places if p.home_share is not None)

    @property
    def validated(self) -> tuple[float, ...]:
        """[m] Of the places that are validated to some depth."""
        return tuple(p.validated for p in self.places if p.validated > 0.0)

    @property
    def offer(self) -> tuple[PlaceFacts, ...]:
        """The places whose force under either law of contact is known."""
        return tuple(p for p in self.places if p.forces is not None)

    @property
    def edges(self) -> tuple[float, ...]:
        """[m] Of the places that have one."""
        return tuple(p.edge for p in self.places if p.edge is not None)


@dataclass(frozen=True)
class FillingFacts:
    """What was measured on the tetrahedra of a solid."""

    asked: int
    smallest_angle_deg: float
    """Between two faces of one."""
    place: tuple[float, float, float]
    """[m] where that is"""
    edges: tuple[float, float, float]
    """[m] shortest, median and longest"""
    fine_edge: float | None
    """[m] the median at the finer region; None where there is none"""


@dataclass(frozen=True)
class TissueFacts:
    """What came of building the tissue."""

    substeps: int = 0
    """Per tick, in the air; 0 where there is no tissue."""
    stable_step: float | None = None
    """[s] The longest step at which the tissue is stable at rest."""
    margin: float | None = None
    """[-] How many times longer than it is the step could be."""
    total_mass: float | None = None
    """[kg]"""
    links: int = 0
    """Springs and bonds."""
    tetrahedra: int = 0
    """Of a solid."""
    filling: FillingFacts | None = None
    """Of a solid."""
    default_home: float | None = None
    """[N/m³] What home springs are where the designer says nothing."""
    trial: TrialFacts | None = None
    """None where there is no tissue."""
    wall: WallFit | None = None
    """None for a solid, and where triangles are too thin to be compared."""
    refusal: tuple[str, str, str] | None = None
    """Where, got, expected: why there is none."""
    nearest: NearestFacts | None = None
    """Of a tissue that needs more substeps than a tick has time for."""
    reduced: tuple[int, ...] = ()
    """Vertices of a wall of prisms whose inner face is nearer than the wall is thick: bends are
    too narrow there, or the far side is near."""
    least_depth: float = 1.0
    """[-] Of the distance between the faces, at the nearest of them."""
    coupling_range: tuple[float, float] | None = None
    """[N] the stretch-bend that every triangle can take, where one could not take the organ's."""


@dataclass(frozen=True)
class Facts:
    """All that the rules are told."""

    surface: SurfaceFacts | None = None
    tissue: TissueFacts | None = None
    tested: bool | None = None
    """Whether the organ has been felt as it is; None where nobody can know."""
