# SPDX-License-Identifier: BSD-3-Clause
"""What a designer chooses about an organ, part by part: the numbers of scene files and documents.

Plain values: nothing here knows files or the simulation. Units stand with each field.
"""

from __future__ import annotations

from dataclasses import dataclass, field

FINITE = ("corotated_solid", "neo_hookean_solid")
"""Those of tetrahedra that may be strained and turned far."""
FILLED = ("solid", "linear_solid", *FINITE)
"""Those of tetrahedra inside the surface."""
KINDS = ("mass_spring", "molecular", "shell", *FILLED)
"""The laws that can hold an organ together."""
ORIGINS = ("chosen", "tissue")
"""Where the constants of springs, bonds and angles come from: the model part, or the material."""
CONTACT_LAWS = ("near_field", "hard")
"""How tissue is felt under a ball."""
CONTACT_CURVATURES = ("vertices", "facets")
"""Of what a solid's near field is as curved as."""
CONTACT_HOLDS = ("fastened", "tied")
"""How what a tool holds gives way, under a near field."""
WITH_NEAR_FIELD = ("shell", *FILLED)
"""Kinds that both contact laws are for; the others are felt by the hard law."""
EXPLICIT = (
    "symplectic_euler",
    "explicit_euler",
    "midpoint",
    "runge_kutta_4",
    "symplectic_euler_implicit_damping",
)
"""Integrators that have a longest step."""
INTEGRATORS = (
    *EXPLICIT,
    "implicit_euler_linear",
    "implicit_euler",
    "implicit_midpoint",
    "xpbd",
    "projective_dynamics",
)
"""How a tissue steps in time: names of palpate.Integrator, the usual one first."""
SIZINGS = ("counted", "estimated")
"""How the size of tetrahedra follows from their number."""
SPRING_RULES = ("van_gelder", "lloyd")
"""How the constants of springs follow from the material."""
VALIDATED_PART, VALIDATED_RADII = 0.10, 1.5
"""[-] To which depth a press is validated: the smaller of these parts of the thickness and of the
tip's radius [accuracy: tool]."""
VALIDATED_TIPS = (2e-3, 8e-3)
"""[m] The least and the largest radius of a tip that is validated to any depth."""
ROUNDING = 1e-6
"""[-] of a length, which files and units have."""


def is_deeper(depth: float, validated: float) -> bool:
    """Whether a press goes deeper [m] than what is validated [m]."""
    return depth > validated * (1.0 + ROUNDING)


LATER = "later"
"""Metadata of a field that parts and edits of before did not have: a file says it where it is not
the default, which is what it was before. So what was written before is written as it was."""


@dataclass(frozen=True)
class OrganPart:
    """Which surface is simulated."""

    name: str
    mesh: str
    """Path of an OBJ in metres, relative to the scene file."""
    sha256: str


@dataclass(frozen=True)
class MaterialPart:
    density: float = 1060.0
    """[kg/m³]"""
    young_modulus: float = 5e3
    """[Pa]"""
    poisson_ratio: float = 0.45
    damping_ratio: float = 0.2
    wall_thickness: float | None = None
    """[m], None for a solid."""


@dataclass(frozen=True)
class ModelPart:
    """Which law holds the organ together, with its constants."""

    kind: str = "mass_spring"
    constants: str = "chosen"
    """tissue: Young's modulus, Poisson's ratio and the wall's thickness give them, and the next
    three numbers do not count. A shell always has its constants from there."""
    spring_rule: str = "van_gelder"
    """Of springs with constants from tissue."""
    stiffness: float = 50.0
    """[N/m] of every spring, or of every bond inside the surface."""
    bend_stiffness: float = 0.0
    """[J] K_theta (molecular), [N] under eq10."""
    stretch_coupling: float = 0.0
    """[N] K_btheta (molecular)."""
    angle_law: str = "gradient"
    damping_law: str = "axis"
    home_stiffness: float | None = None
    """[N/m³] None: the builder's default."""
    pressure: float = 0.0
    """[Pa]"""
    drag: float = 2.0
    """[1/s]"""
    relaxation: float = field(default=0.0, metadata={"since": 6})
    """[-] k_v/k: how much stiffer springs, bonds and angles are against a sudden strain than they
    are in the end; 0 for tissue that does not relax."""
    relaxation_time: float = field(default=0.5, metadata={"since": 6})
    """[s] in which 63 % of that fades."""
    contact_law: str = field(default="near_field", metadata={"since": 7})
    """Of solids and walls of prisms. near_field: as on tissue of Young's modulus and Poisson's
    ratio, however large its triangles are; hard: as the mesh gives way."""
    contact_curvature: str = field(default="vertices", metadata={"since": 13})
    """Of a solid's near field. vertices: it is as curved as they are on the mean; facets: as those
    under the ball are, as finite elements on this surface feel them [contact: facets]."""
    contact_hold: str = field(default="fastened", metadata={"since": 14})
    """Of a near field. fastened: what a tool holds gives way as the mesh does at the vertices under
    it; tied: as tissue does at a disc as wide as the contact [contact: hold]."""
    tear_stretch: float = field(default=0.0, metadata={LATER: True})
    """[-] What an instrument holds tears where it is longer than so many times its length at rest;
    0: nothing tears. Of springs and bonds [contact: tear]."""
    integrator: str = field(default="symplectic_euler", metadata={"since": 8})
    """Any but the first runs in plain code, at many times the cost."""
    fixed: tuple[int, ...] = ()
    stiffness_scale: tuple[float, ...] = ()


@dataclass(frozen=True)
class FillPart:
    """How a solid is cut into tetrahedra, and what of its surface can be pushed. Documents have it;
    a scene file has no tetrahedra."""

    tetrahedra: int = 3000
    """About how many fill the organ: what ticks a thousand times a second with time to spare."""
    nodal_share: float = 0.9
    """[-] 0 to 1: how much of the resistance to a change of volume acts on the mean around each
    particle, and not on each tetrahedron by itself."""
    reach: str = ""
    """The region of the surface on which a linear solid can be pushed; empty: all of it."""
    sizing: str = field(default="counted", metadata={"since": 9})
    """counted: sizes are tried until there are as many tetrahedra, to a tenth; estimated: one size,
    as solids of before version 9 were filled, which gives up to a third fewer."""
    fine_region: str = field(default="", metadata={"since": 9})
    """The region of the surface at which tetrahedra are smaller; empty: none."""
    fine_ratio: float = field(default=0.5, metadata={"since": 9})
    """[-] How much smaller their edges are there than far away."""


@dataclass(frozen=True)
class ToolPart:
    radius: float = 3e-3
    """[m]"""
    stiffness: float = 3e7
    """[N/m³] k_A of the contact law."""
    friction: float = field(default=0.0, metadata={"since": 12})
    """[-] Coulomb's coefficient between tip and tissue: 0.01 to 0.11 of smooth metal on wet bowel,
    0.3 to 0.8 of a profiled jaw; 0: it slides."""
    length: float = field(default=0.0, metadata={"since": 15})
    """[m] of the shaft, from the tip's middle to the hand, that touches: a capsule; 0: a ball. Of
    an instrument with jaws, their length."""
    trocar_height: float = field(default=0.15, metadata={"since": 15})
    """[m] over the highest point of the organ, above its middle: where the shaft passes the
    abdominal wall; 0: nowhere, the device turns the instrument."""
    jaw_opening: float = field(default=0.0, metadata={"since": 16})
    """[rad] by which each of two jaws opens at most; 0: what touches is rigid."""
    grip_force: float = field(default=5.0, metadata={"since": 16})
    """[N] with which each jaw closes at most, at its middle."""


@dataclass(frozen=True)
class HandPart:
    coupling: float = 1000.0
    """[N/m] K of Eq 12."""
    force_max: float = 5.0
    """[N]"""
    hold_stiffness: float = 500.0
    """[N/m] between tool and patch while attached."""
    rate: float = 1000.0
    """[Hz]"""
    gravity: tuple[float, ...] = (0.0, 0.0, 0.0)
    """[m/s²]"""
    force_error: float = 0.0
    """[N] by which the force may be wrong, so that tissue at rest may sleep; 0: none of it does."""
    substeps: int = 0
    """Of a tick at least; the tissue's own need counts where it is more."""
    exchange_rate: float = field(default=0.0, metadata={"since": 11})
    """[Hz] 0: the tissue ticks with the hand. Else, where it is too slow for that, in a thread of
    its own: it is told so often where the hand is, and felt between by its local stiffness."""


@dataclass(frozen=True)
class AppearancePart:
    """How a tissue takes the light; colours are sRGB, 0 to 1. Nothing that is felt."""

    colour: tuple[float, ...]
    pattern_colour: tuple[float, ...]
    """Of the spots all over it."""
    pattern_size: float
    """[m] Of the spots."""
    pattern_strength: float
    """[-] 0 none of the spots' colour, 1 all of it in their middle."""
    vein_colour: tuple[float, ...]
    vein_strength: float
    """[-] Of fine vessels."""
    relief: float
    """[-] How far the spots stand out, in parts of their size."""
    gloss: float
    """[-] 0 dull, 1 wet."""
    roughness: float
    """[-] 0 a mirror, 1 chalk."""
    subsurface: float
    """[-] How far light creeps into the shade."""


def find_appearance_fault(appearance: AppearancePart) -> tuple[str, str, str] | None:
    """The first field that is out of its range: its name, what it is, what was expected."""
    for name in ("colour", "pattern_colour", "vein_colour"):
        colour = getattr(appearance, name)
        if len(colour) != 3 or not all(0.0 <= channel <= 1.0 for channel in colour):
            return name, str(list(colour)), "three numbers of 0 to 1"
    if not appearance.pattern_size > 0.0:
        return "pattern_size", f"{appearance.pattern_size} m", "a positive length"
    for name in ("pattern_strength", "vein_strength", "relief", "gloss", "roughness", "subsurface"):
        if not 0.0 <= getattr(appearance, name) <= 1.0:
            return name, str(getattr(appearance, name)), "0 to 1"
    return None


@dataclass(frozen=True)
class SceneFile:
    """A whole scene as authored."""

    organ: OrganPart
    material: MaterialPart = field(default_factory=MaterialPart)
    model: ModelPart = field(default_factory=ModelPart)
    tool: ToolPart = field(default_factory=ToolPart)
    hand: HandPart = field(default_factory=HandPart)
