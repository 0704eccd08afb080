# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers a designer may set: what they are called, their units, and what they may be.

Forms, edits and checks all read this one table.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from palpate.scene.scene_parts import (
    CONTACT_CURVATURES,
    CONTACT_HOLDS,
    CONTACT_LAWS,
    FILLED,
    FINITE,
    INTEGRATORS,
    KINDS,
    ORIGINS,
    SPRING_RULES,
    WITH_NEAR_FIELD,
    ModelPart,
)

from palpate_editor.document.phrase import Phrase, phrase


@dataclass(frozen=True)
class Constant:
    """One number of a part of an organ."""

    part: str
    """material, model, fill, tool or hand."""
    field: str
    label: str
    """What people call it."""
    unit: str
    """As shown; empty for a bare ratio."""
    option: str
    """Of the command line, and ..."""
    option_unit: str
    """... the unit that must stand with its number, in SI; empty for a bare number."""
    scale: float = 1.0
    """1 of the unit shown, in SI."""
    least: float = 0.0
    above: bool = True
    """The least itself is not allowed."""
    most: float = math.inf
    optional: bool = False
    """None stands for `absent`."""
    absent: str = ""
    kinds: tuple[str, ...] = KINDS
    """The model kinds on which it has an effect."""
    whole: bool = False
    """A count of something."""
    chosen: bool = False
    """It counts only where the constants are chosen, not where tissue gives them."""

    @property
    def key(self) -> str:
        return f"{self.part}.{self.field}"

    def counts(self, model: ModelPart) -> bool:
        """Whether a model of this kind makes use of it."""
        return model.kind in self.kinds and (not self.chosen or model.constants == "chosen")

    def allows(self, value: float) -> bool:
        if not math.isfinite(value) or (self.whole and value != int(value)):
            return False
        return (value > self.least if self.above else value >= self.least) and value <= self.most

    def describe(self, value: float | None) -> Phrase:
        """A value [SI] in the unit shown: "5 kPa"; what no value means where it may have none."""
        if value is None:
            return phrase("{value}", value=self.absent or "none")
        template = "{value:g} {unit}" if self.unit else "{value:g}"
        return phrase(template, value=float(value) / self.scale, unit=self.unit)

    def describe_range(self) -> Phrase:
        """In the unit shown: "above 0 mm", "0 to 1", "any finite number"."""
        low, high = self.least / self.scale, self.most / self.scale
        unit = f" {self.unit}" if self.unit else ""
        if self.whole:
            return phrase("a whole number of {low:g} to {high:g}", low=low, high=high)
        if math.isinf(low) and math.isinf(high):
            return phrase("any finite number")
        if math.isinf(high):
            template = "more than {low:g}{unit}" if self.above else "at least {low:g}{unit}"
            return phrase(template, low=low, unit=unit)
        template = (
            "more than {low:g}, at most {high:g}{unit}"
            if self.above
            else "{low:g} to {high:g}{unit}"
        )
        return phrase(template, low=low, high=high, unit=unit)


SHORT_KINDS = {
    "mss": "mass_spring",
    "mms": "molecular",
    "shell": "shell",
    "solid": "solid",
    "linear": "linear_solid",
    "corotated": "corotated_solid",
    "neo-hookean": "neo_hookean_solid",
}
"""What the command line calls them."""
ELASTIC = ("material.young_modulus", "material.poisson_ratio")
MOLECULAR = ("molecular",)
SURFACES = ("mass_spring", "molecular")
HOLLOW = (*SURFACES, "shell")
LINKED = (*HOLLOW, "solid")
"""What has springs or bonds."""
SWINGING = (*LINKED, *FINITE)
"""A linear solid is always at rest under its loads, but for the time its damping takes."""
ANY = -math.inf
LEAST_TETRAHEDRA, MOST_TETRAHEDRA = 100, 40_000
"""Fewer are no shape; more are not begun (core/authoring/fill_interior.h)."""
LEAST_FINE_RATIO = 0.1
"""[-] Of the edges of a filling at its fine region to those far away."""
MOST_FRICTION = 2.0
"""[-] Coulomb's coefficient. Smooth metal on wet tissue has up to 0.11, profiled jaws up to 0.8."""
MOST_LENGTH = 0.05
"""[m] Of the part of a shaft that touches. The near field of a longer one would take in the whole
organ, and the time of a tick."""
MOST_TROCAR_HEIGHT = 0.3
"""[m] Instruments for the abdomen are 0.33 m long."""
MOST_JAW_OPENING = 1.0
"""[rad] Of each jaw: two at a right angle and more hold nothing."""
MOST_GRIP_FORCE = 40.0
"""[N] Pinches of 15 to 37 N harm bowel [Heijnsdijk04]; no surgeon closes a grasper harder."""
MOST_TEAR_STRETCH = 10.0
"""[-] Of the length at rest: there a run ends, whatever the tissue."""
MOST_SUBSTEPS = 1000
"""Of a tick. More take longer than a tick does on any machine."""

CONSTANTS = (
    Constant("material", "density", "Density", "kg/m³", "--density", "kg/m3"),
    Constant("material", "damping_ratio", "Damping ratio", "", "--damping", "", above=False),
    Constant(
        "material",
        "wall_thickness",
        "Wall thickness",
        "mm",
        "--wall",
        "m",
        scale=1e-3,
        optional=True,
        absent="solid",
    ),
    Constant(
        "material", "young_modulus", "Young's modulus", "kPa", "--young-modulus", "Pa", scale=1e3
    ),
    Constant(
        "material", "poisson_ratio", "Poisson's ratio", "", "--poisson", "", above=False, most=0.5
    ),
    Constant(
        "model", "stiffness", "Stiffness", "N/m", "--stiffness", "N/m", kinds=SURFACES, chosen=True
    ),
    Constant(
        "model",
        "bend_stiffness",
        "Bend stiffness",
        "mJ",
        "--bend",
        "J",
        scale=1e-3,
        above=False,
        kinds=MOLECULAR,
        chosen=True,
    ),
    Constant(
        "model",
        "stretch_coupling",
        "Stretch-bend",
        "N",
        "--stretch-bend",
        "N",
        least=ANY,
        kinds=MOLECULAR,
        chosen=True,
    ),
    Constant(
        "model",
        "home_stiffness",
        "Home springs",
        "N/mm³",
        "--home",
        "N/m3",
        scale=1e9,
        above=False,
        optional=True,
        absent="by kind",
        kinds=HOLLOW,
    ),
    Constant(
        "model",
        "pressure",
        "Pressure",
        "kPa",
        "--pressure",
        "Pa",
        scale=1e3,
        least=ANY,
        kinds=HOLLOW,
    ),
    Constant("model", "drag", "Drag", "1/s", "--drag", "1/s", above=False, kinds=SWINGING),
    Constant(
        "model",
        "relaxation",
        "Relaxation",
        "",
        "--relaxation",
        "",
        above=False,
        most=100.0,
        kinds=LINKED,
    ),
    Constant(
        "model",
        "relaxation_time",
        "Relaxation time",
        "s",
        "--relaxation-time",
        "s",
        least=1e-4,
        above=False,
        most=1e4,
        kinds=LINKED,
    ),
    Constant(
        "model",
        "tear_stretch",
        "Tear stretch",
        "",
        "--tear-stretch",
        "",
        above=False,
        most=MOST_TEAR_STRETCH,
        kinds=LINKED,
    ),
    Constant(
        "fill",
        "tetrahedra",
        "Tetrahedra",
        "",
        "--tetrahedra",
        "",
        least=LEAST_TETRAHEDRA,
        above=False,
        most=MOST_TETRAHEDRA,
        kinds=FILLED,
        whole=True,
    ),
    Constant(
        "fill",
        "nodal_share",
        "Nodal share",
        "",
        "--nodal-share",
        "",
        above=False,
        most=1.0,
        kinds=FILLED,
    ),
    Constant(
        "fill",
        "fine_ratio",
        "Fine size",
        "",
        "--fine-ratio",
        "",
        least=LEAST_FINE_RATIO,
        above=False,
        most=1.0,
        kinds=FILLED,
    ),
    Constant("tool", "radius", "Tip radius", "mm", "--tool-radius", "m", scale=1e-3),
    Constant(
        "tool", "stiffness", "Contact stiffness", "N/mm³", "--tool-stiffness", "N/m3", scale=1e9
    ),
    Constant("tool", "friction", "Friction", "", "--friction", "", above=False, most=MOST_FRICTION),
    Constant(
        "tool",
        "length",
        "Length that touches",
        "mm",
        "--tool-length",
        "m",
        scale=1e-3,
        above=False,
        most=MOST_LENGTH,
    ),
    Constant(
        "tool",
        "trocar_height",
        "Trocar height",
        "mm",
        "--trocar-height",
        "m",
        scale=1e-3,
        above=False,
        most=MOST_TROCAR_HEIGHT,
    ),
    Constant(
        "tool",
        "jaw_opening",
        "Jaw opening",
        "rad",
        "--jaw-opening",
        "",
        above=False,
        most=MOST_JAW_OPENING,
    ),
    Constant("tool", "grip_force", "Grip force", "N", "--grip-force", "N", most=MOST_GRIP_FORCE),
    Constant("hand", "coupling", "Hand coupling", "N/m", "--coupling", "N/m"),
    Constant("hand", "force_max", "Largest force", "N", "--force-max", "N"),
    Constant("hand", "hold_stiffness", "Grip stiffness", "N/m", "--grip", "N/m"),
    Constant("hand", "rate", "Tick rate", "Hz", "--rate", ""),
    Constant("hand", "exchange_rate", "Exchange rate", "Hz", "--exchange-rate", "", above=False),
    Constant(
        "hand",
        "force_error",
        "Allowed force error",
        "mN",
        "--force-error",
        "N",
        scale=1e-3,
        above=False,
        kinds=SWINGING,
    ),
    Constant(
        "hand",
        "substeps",
        "Least substeps",
        "",
        "--substeps",
        "",
        above=False,
        most=MOST_SUBSTEPS,
        kinds=SWINGING,
        whole=True,
    ),
)
"""In the order in which a form shows them."""

CHOICES = {
    "model.kind": KINDS,
    "model.constants": ORIGINS,
    "model.spring_rule": SPRING_RULES,
    "model.angle_law": ("gradient", "eq10"),
    "model.damping_law": ("axis", "isotropic"),
    "model.contact_law": CONTACT_LAWS,
    "model.contact_curvature": CONTACT_CURVATURES,
    "model.contact_hold": CONTACT_HOLDS,
    "model.integrator": INTEGRATORS,
}


LAW_NAMES = {
    "kind": "Model",
    "constants": "Constants",
    "spring_rule": "Rule of springs",
    "angle_law": "Law of angles",
    "damping_law": "Damping",
    "contact_law": "Contact",
    "contact_curvature": "Curvature under the ball",
    "contact_hold": "What is held",
    "integrator": "Integrator",
}
"""What people call a choice."""

VALUE_NAMES = {
    "mass_spring": "Mass–spring (MSS)",
    "molecular": "Molecular (MMS)",
    "shell": "Shell of prisms",
    "solid": "Solid (MSS+V)",
    "linear_solid": "Linear solid, shallow presses",
    "corotated_solid": "Corotated solid",
    "neo_hookean_solid": "Neo-Hookean solid",
    "chosen": "Chosen by hand",
    "tissue": "From the tissue",
    "van_gelder": "Van Gelder",
    "lloyd": "Lloyd",
    "gradient": "Energy gradient (Eq 9, 11)",
    "eq10": "Opposite edge (Eq 10)",
    "axis": "Along the link",
    "isotropic": "In all directions",
    "near_field": "As on tissue",
    "hard": "As on the mesh",
    "vertices": "Mean of the vertices",
    "facets": "Of the triangles",
    "tied": "Gives way as tissue",
    "fastened": "Gives way as the mesh",
    "symplectic_euler": "Symplectic Euler",
    "explicit_euler": "Explicit Euler",
    "midpoint": "Explicit midpoint",
    "runge_kutta_4": "Runge–Kutta 4",
    "symplectic_euler_implicit_damping": "Implicit damping",
    "implicit_euler_linear": "Implicit Euler, linear",
    "implicit_euler": "Implicit Euler",
    "implicit_midpoint": "Implicit midpoint",
    "xpbd": "XPBD",
    "projective_dynamics": "Projective dynamics",
}
"""What people call what can be chosen."""


KINDS_OF_LAWS = {
    "angle_law": MOLECULAR,
    "constants": SURFACES,
    "contact_curvature": FILLED,
    "contact_hold": WITH_NEAR_FIELD,
    "contact_law": WITH_NEAR_FIELD,
    "damping_law": LINKED,
    "spring_rule": ("mass_spring",),
}
"""The model kinds on which a choice has an effect."""


def counts_choice(field: str, model: ModelPart) -> bool:
    """Whether a law of `field` has an effect on a model."""
    counts = model.kind in KINDS_OF_LAWS.get(field, KINDS)
    if field in ("contact_curvature", "contact_hold"):
        return counts and model.contact_law != "hard"
    return counts and (field != "spring_rule" or model.constants == "tissue")


def find_constant(part: str, field: str) -> Constant | None:
    return next((c for c in CONSTANTS if (c.part, c.field) == (part, field)), None)
