# SPDX-License-Identifier: GPL-3.0-or-later
"""Giving an organ a configuration of its chart: kind, constants, contact, time step, mesh."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from typing import Any, TypeVar

from palpate.scene.scene_parts import FILLED
from palpate.study.scene_chart import FAR_FIELDS, Configuration

from palpate_editor.document import Organ, phrase
from palpate_editor.document.constants import CHOICES, VALUE_NAMES
from palpate_editor.document.far_compliance import find_far_compliance, is_stale
from palpate_editor.edits.decimate import decimate_organ
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.set_constant import check_constant

OF_MODEL = (
    "kind",
    "constants",
    "spring_rule",
    "angle_law",
    "stiffness",
    "bend_stiffness",
    "stretch_coupling",
    "home_stiffness",
    "contact_law",
    "integrator",
)
"""Fields that a configuration shares with the document's model part."""
CHANGED = ("surface", "model", "fill", "far_field", "hand")
NUMBERS = ("stiffness", "bend_stiffness", "stretch_coupling", "home_stiffness")

Part = TypeVar("Part")


@dataclass(frozen=True)
class Configure:
    """Simulate the organ as a row of its chart says; what it is made of stays as it is.

    Seconds where a large surface is decimated: then beside the window (prepare).
    """

    configuration: Configuration

    @property
    def title(self) -> str:
        c = self.configuration
        return phrase(
            "Configuration: {kind}, {step}",
            kind=VALUE_NAMES.get(c.kind, c.kind),
            step=VALUE_NAMES.get(c.integrator, c.integrator),
        )

    def __call__(self, organ: Organ) -> Organ:
        find_surface(organ)
        check_configuration(self.configuration)
        changed = apply_configuration(organ, self.configuration)
        if all(getattr(changed, part) is getattr(organ, part) for part in CHANGED):
            raise EditError(phrase("The organ has that configuration already."))
        return changed


def check_configuration(configuration: Configuration) -> None:
    """Raises EditError for what no organ can have: a chart's file may come from anywhere."""
    values = asdict(configuration)
    for key, allowed in CHOICES.items():
        field = key.removeprefix("model.")
        if field in OF_MODEL and values[field] not in allowed:
            raise EditError(
                phrase(
                    "{field} must be one of {allowed}, got {got}.",
                    field=field,
                    allowed=", ".join(allowed),
                    got=values[field],
                )
            )
    if configuration.far_field not in FAR_FIELDS:
        raise EditError(
            phrase(
                "{field} must be one of {allowed}, got {got}.",
                field="far_field",
                allowed=", ".join(FAR_FIELDS),
                got=configuration.far_field,
            )
        )
    for field in NUMBERS:
        check_constant("model", field, values[field])
    check_constant("hand", "substeps", values["substeps"])
    if configuration.kind in FILLED or configuration.tetrahedra:
        check_constant("fill", "tetrahedra", values["tetrahedra"])


def find_configuration(organ: Organ) -> Configuration:
    """The one that an organ has."""
    values = {name: getattr(organ.model, name) for name in OF_MODEL}
    solid = organ.model.kind in FILLED
    return Configuration(
        **values,
        substeps=organ.hand.substeps,
        vertices=0,
        tetrahedra=organ.fill.tetrahedra if solid else 0,
        far_field="fine" if find_far_compliance(organ) is not None else "mesh",
    )


def apply_configuration(organ: Organ, configuration: Configuration) -> Organ:
    """The organ with the values of a configuration; the rest of it stays as it is.

    A solid keeps its surface, which is its skin. Seconds where a large surface is decimated, on any
    thread.

    Raises:
        EditError: where the surface cannot be decimated to so many vertices.
    """
    if configuration.vertices not in (0, organ.vertex_count):
        organ = decimate_organ(organ, configuration.vertices)(organ)
    values = asdict(configuration)
    if configuration.far_field == "fine" and not has_far_field(organ):
        raise EditError(
            phrase("The far field has not been solved for this surface yet: solve it first.")
        )
    if configuration.far_field == "mesh" and organ.far_field is not None and has_near_field(values):
        organ = replace(organ, far_field=None)
    changed = {
        "model": change(organ.model, {name: values[name] for name in OF_MODEL}),
        "hand": change(organ.hand, {"substeps": configuration.substeps}),
    }
    if configuration.tetrahedra:
        changed["fill"] = change(organ.fill, {"tetrahedra": configuration.tetrahedra})
    return replace(organ, **changed)


def has_far_field(organ: Organ) -> bool:
    return organ.far_field is not None and not is_stale(organ)


def has_near_field(values: dict[str, Any]) -> bool:
    return values["kind"] in FILLED and values["contact_law"] == "near_field"


def change(part: Part, values: dict[str, Any]) -> Part:
    """The part with these values; the very same one where it has them."""
    changed: Part = replace(part, **values)  # type: ignore[type-var]
    return part if changed == part else changed
