# SPDX-License-Identifier: GPL-3.0-or-later
"""Setting the numbers and laws of tissue, tool and hand."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from palpate.scene.scene_parts import MaterialPart, ModelPart

from palpate_editor.document import Organ, phrase
from palpate_editor.document.constants import (
    CHOICES,
    CONSTANTS,
    LAW_NAMES,
    VALUE_NAMES,
    find_constant,
)
from palpate_editor.edits.adopt import adopt_constants
from palpate_editor.edits.edit import EditError


def replace_field(organ: Organ, part: str, field: str, value: object) -> Organ:
    return replace(organ, **{part: replace(getattr(organ, part), **{field: value})})


def count_tetrahedra(organ: Organ, part: str, field: str) -> Organ:
    """A number of tetrahedra that is asked for now is counted, also in a document of before."""
    if (part, field) != ("fill", "tetrahedra") or organ.fill.sizing == "counted":
        return organ
    return replace_field(organ, "fill", "sizing", "counted")


def check_constant(part: str, field: str, value: float | None) -> None:
    constant = find_constant(part, field)
    if constant is None:
        raise EditError(phrase("There is no number {name}.", name=f"{part}.{field}"))
    if value is None and constant.optional:
        return
    if value is None or not constant.allows(value):
        raise EditError(
            phrase(
                "{label} must be {range}, got {got}.",
                label=constant.label,
                range=constant.describe_range(),
                got=constant.describe(value),
            )
        )


@dataclass(frozen=True)
class SetConstant:
    """Set one number of the material, the model, the filling, the tool or the hand."""

    part: str
    field: str
    value: float | None
    """In SI, whatever unit a form shows; None where the table of constants allows it."""

    @property
    def title(self) -> str:
        constant = find_constant(self.part, self.field)
        if constant is None:
            return phrase("Set a number")
        value = constant.describe(self.value)
        return phrase("{name}: {value}", name=constant.label, value=value)

    def __call__(self, organ: Organ) -> Organ:
        check_constant(self.part, self.field, self.value)
        constant = find_constant(self.part, self.field)
        kind = int if constant is not None and constant.whole else float
        value = None if self.value is None else kind(self.value)
        changed = replace_field(organ, self.part, self.field, value)
        return count_tetrahedra(changed, self.part, self.field)


@dataclass(frozen=True)
class SetChoice:
    """Choose a law: `kind`, `angle_law` or another field of CHOICES.

    Constants that the tissue gave are taken over when they are to be chosen by hand.
    """

    field: str
    value: str

    @property
    def title(self) -> str:
        name, value = LAW_NAMES.get(self.field, self.field), VALUE_NAMES.get(self.value, self.value)
        return phrase("{name}: {value}", name=name, value=value)

    def __call__(self, organ: Organ) -> Organ:
        allowed = CHOICES.get(f"model.{self.field}", ())
        if self.value not in allowed:
            raise EditError(
                phrase(
                    "{field} must be one of {allowed}, got {got}.",
                    field=self.field,
                    allowed=", ".join(allowed) or "none",
                    got=self.value,
                )
            )
        if self.field == "constants" and (organ.model.constants, self.value) == (
            "tissue",
            "chosen",
        ):
            return adopt_constants(organ)
        return replace_field(organ, "model", self.field, self.value)


@dataclass(frozen=True)
class SetGravity:
    """Let the organ have weight, in some direction."""

    gravity: tuple[float, float, float]
    """[m/s²]"""

    @property
    def title(self) -> str:
        if not any(self.gravity):
            return phrase("No gravity")
        x, y, z = map(float, self.gravity)
        return phrase("Gravity: {x:g}, {y:g}, {z:g} m/s²", x=x, y=y, z=z)

    def __call__(self, organ: Organ) -> Organ:
        if len(self.gravity) != 3 or not all(map(math.isfinite, self.gravity)):
            raise EditError(phrase("Gravity is three finite numbers."))
        return replace_field(organ, "hand", "gravity", tuple(map(float, self.gravity)))


@dataclass(frozen=True)
class SetMaterial:
    """Give the organ a whole material and model at once: pasted from another, or a preset."""

    material: MaterialPart
    model: ModelPart
    tissue: str = ""
    """What it is that of, where that is known."""

    @property
    def title(self) -> str:
        if self.tissue:
            return phrase("Material of {tissue}", tissue=self.tissue)
        kind = VALUE_NAMES.get(self.model.kind, self.model.kind)
        modulus = find_constant("material", "young_modulus")
        assert modulus is not None
        value = modulus.describe(self.material.young_modulus)
        return phrase("Paste a material: {kind}, {value}", kind=kind, value=value)

    def __call__(self, organ: Organ) -> Organ:
        for constant in CONSTANTS:
            if constant.part in ("material", "model"):
                value = getattr(getattr(self, constant.part), constant.field)
                check_constant(constant.part, constant.field, value)
        # which vertices are meant stands in the organ's own arrays
        model = replace(self.model, fixed=(), stiffness_scale=())
        changed = replace(organ, material=self.material, model=model)
        for key in CHOICES:
            field = key.removeprefix("model.")
            changed = SetChoice(field, getattr(model, field))(changed)
        return changed
