# SPDX-License-Identifier: GPL-3.0-or-later
"""Configurations of a chart as what an organ's document says, and back."""

from __future__ import annotations

from dataclasses import asdict, replace

from palpate.scene.scene_parts import FILLED, ModelPart
from palpate.study.scene_chart import Configuration

from palpate_editor.document import Organ
from palpate_editor.document.constants import SURFACES, VALUE_NAMES
from palpate_editor.edits import decimate_organ

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


def find_configuration(organ: Organ) -> Configuration:
    """The one that an organ has."""
    values = {name: getattr(organ.model, name) for name in OF_MODEL}
    solid = organ.model.kind in FILLED
    return Configuration(
        **values,
        substeps=organ.hand.substeps,
        vertices=0,
        tetrahedra=organ.fill.tetrahedra if solid else 0,
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
    model: ModelPart = replace(organ.model, **{name: values[name] for name in OF_MODEL})
    fill = organ.fill
    if configuration.tetrahedra:
        fill = replace(fill, tetrahedra=configuration.tetrahedra)
    hand = replace(organ.hand, substeps=configuration.substeps)
    return replace(organ, model=model, fill=fill, hand=hand)


def name_configuration(configuration: Configuration, organ: Organ) -> str:
    """In words, without what all rows of a chart share."""
    kind, law = VALUE_NAMES[configuration.kind], configuration.contact_law
    solid = configuration.kind in FILLED
    size = (
        f"{configuration.tetrahedra} tetrahedra"
        if solid
        else f"{configuration.vertices or organ.vertex_count} vertices"
    )
    contact = f", contact {VALUE_NAMES[law].lower()}" if solid else ""
    origin = ", chosen constants" if configuration.constants == "chosen" and not solid else ""
    substeps = f", {configuration.substeps} substeps" if configuration.substeps else ""
    step = VALUE_NAMES.get(configuration.integrator, configuration.integrator)
    return f"{kind}{origin}, {size}{contact}, {step}{substeps}"


def describe_provenance(configuration: Configuration, organ: Organ) -> str:
    """In words: where the constants come from."""
    if configuration.kind in SURFACES and configuration.constants == "chosen":
        home = configuration.home_stiffness
        held = "home springs by kind" if home is None else f"home springs of {1e-9 * home:g} N/mm³"
        return f"chosen by hand: {configuration.stiffness:g} N/m, {held}"
    material = organ.material
    wall = material.wall_thickness
    text = f"from E {1e-3 * material.young_modulus:g} kPa, nu {material.poisson_ratio:g}"
    return text if wall is None else f"{text}, a wall of {1e3 * wall:g} mm"
