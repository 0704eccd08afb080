# SPDX-License-Identifier: GPL-3.0-or-later
"""Which numbers and laws have no effect on an organ as it is, and which would have one instead."""

from __future__ import annotations

from dataclasses import dataclass

from palpate_editor.document.constants import (
    ELASTIC,
    KINDS_OF_LAWS,
    SHORT_KINDS,
    SURFACES,
    VALUE_NAMES,
    Constant,
    counts_choice,
)
from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import phrase


@dataclass(frozen=True)
class Idle:
    """Why something has no effect."""

    why: str
    """A Phrase where a window says it; numbers of other models are hidden there."""
    instead: str
    """Options of the command line that have an effect in its place, or give it one."""
    where: str = ""
    """Where it counts, as a window says it."""


def find_idle(constant: Constant, organ: Organ) -> Idle | None:
    """Why a number has no effect on the force of an organ; None where it has one."""
    if organ.model.kind not in constant.kinds:
        return find_idle_in_kind(constant, organ.model.kind)
    if constant.chosen and organ.model.constants == "tissue":
        return Idle(
            "the tissue gives springs and bonds their constants",
            "--young-modulus and --wall, or --constants chosen with it",
        )
    if constant.key == "model.relaxation_time" and organ.model.relaxation == 0.0:
        return Idle(
            phrase("a relaxation of 0 has no time"),
            "--relaxation above 0 with it",
            phrase("It counts where the relaxation is above 0."),
        )
    if constant.key == "fill.fine_ratio" and not organ.fill.fine_region:
        return Idle(
            phrase("tetrahedra are of one size"),
            "--fine REGION with it",
            phrase("It counts where a region is filled finer."),
        )
    if constant.key == "tool.trocar_height" and organ.tool.length == 0.0:
        return Idle(
            phrase("a ball has no shaft that would pass a trocar"),
            "--tool-length above 0 with it",
            phrase("It counts where the length that touches is above 0."),
        )
    if constant.key == "tool.jaw_opening" and organ.tool.length == 0.0:
        return Idle(
            phrase("a ball has no jaws"),
            "--tool-length above 0 with it",
            phrase("It counts where the length that touches is above 0."),
        )
    if constant.key == "tool.grip_force" and not has_jaws(organ):
        return Idle(
            phrase("what has no jaws closes on nothing"),
            "--jaw-opening above 0 with it",
            phrase("It counts where jaws open."),
        )
    return find_idle_modulus(constant, organ) if constant.key in ELASTIC else None


def has_jaws(organ: Organ) -> bool:
    return organ.tool.length > 0.0 and organ.tool.jaw_opening > 0.0


def find_idle_in_kind(constant: Constant, kind: str) -> Idle:
    """Of a number that a model of this kind has no use for."""
    if constant.chosen and kind not in SURFACES:
        return Idle(
            "Young's modulus and Poisson's ratio give this model its constants",
            "--young-modulus and --poisson",
        )
    if constant.key == "model.home_stiffness":
        return Idle("a solid has no home springs: fixed vertices hold it", "--fix-lowest")
    return Idle(say_unused(kind), f"a model that uses it: --kind {list_kinds(constant.kinds)}")


def find_idle_modulus(constant: Constant, organ: Organ) -> Idle | None:
    """Of Young's modulus and Poisson's ratio, where springs and bonds are chosen by hand."""
    model, walled = organ.model, organ.material.wall_thickness is not None
    if model.kind not in SURFACES or model.constants == "tissue":
        return None
    if organ.fixed.any() and organ.fixed.all():  # tells a stone from what must be able to move
        return None
    is_modulus = constant.key == "material.young_modulus"
    if is_modulus and walled and model.home_stiffness is None:  # it gives the home springs
        return None
    why = phrase("springs and bonds take the stiffness that is chosen")
    where = phrase("It counts in a solid, and where the tissue gives a wall its constants.")
    if not walled:
        instead = "--kind solid with it, or a wall (--wall) and --constants tissue"
        return Idle(why, instead, where)
    if is_modulus:
        return Idle(
            phrase("springs, bonds and home springs take the stiffness that is chosen"),
            "--constants tissue with it, or --home none, which takes home springs from it",
            where,
        )
    return Idle(why, "--constants tissue with it", where)


def find_idle_choice(field: str, value: str, organ: Organ) -> Idle | None:
    """Why a law of `field` has no effect on the force of an organ; None where it has one."""
    model = organ.model
    if counts_choice(field, model):
        return None
    if field == "constants":
        if value == "tissue":  # which is where those of a wall or a solid come from
            return None
        return Idle(
            "Young's modulus and Poisson's ratio give this model its constants",
            "--kind mss or mms with it",
        )
    if field == "spring_rule" and model.kind == "mass_spring":
        return Idle("springs take the stiffness that is chosen", "--constants tissue with it")
    if field == "contact_curvature" and model.kind in KINDS_OF_LAWS[field]:
        return Idle("the hard law knows no curvature", "--contact-law near_field with it")
    if field == "contact_hold" and model.kind in KINDS_OF_LAWS[field]:
        return Idle(
            "by the hard law what is held gives way as the mesh",
            "--contact-law near_field with it",
        )
    kinds = list_kinds(KINDS_OF_LAWS[field])
    return Idle(say_unused(model.kind), f"a model that uses it: --kind {kinds}")


def say_unused(kind: str) -> str:
    return f"{VALUE_NAMES.get(kind, kind)} makes no use of it"


def list_kinds(kinds: tuple[str, ...]) -> str:
    """As the command line calls them: "mss, mms or shell"."""
    names = [short for short, kind in SHORT_KINDS.items() if kind in kinds]
    return " or ".join(filter(None, [", ".join(names[:-1]), names[-1]]))
