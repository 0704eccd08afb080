# SPDX-License-Identifier: GPL-3.0-or-later
"""Configurations of a chart in words."""

from __future__ import annotations

from palpate.scene.scene_parts import FILLED, WITH_NEAR_FIELD
from palpate.study.scene_chart import Configuration

from palpate_editor.document import Organ, Phrase, phrase
from palpate_editor.document.constants import SURFACES, VALUE_NAMES
from palpate_editor.edits.configure import apply_configuration as apply_configuration
from palpate_editor.edits.configure import find_configuration as find_configuration


def name_configuration(configuration: Configuration, organ: Organ) -> Phrase:
    """Without what all rows of a chart share."""
    step = VALUE_NAMES.get(configuration.integrator, configuration.integrator)
    parts = [phrase("{step}", step=step)]
    if configuration.substeps == 1:
        parts.append(phrase("1 substep"))
    elif configuration.substeps:
        parts.append(phrase("{count} substeps", count=configuration.substeps))
    if configuration.kind in WITH_NEAR_FIELD:
        hard = configuration.contact_law == "hard"
        template = "contact as on the mesh" if hard else "contact as on tissue"
        parts.insert(0, phrase(template))
    if configuration.kind in FILLED:
        parts.insert(0, phrase("{count} tetrahedra", count=configuration.tetrahedra))
        if configuration.far_field == "fine":
            parts.insert(2, phrase("fine far field"))
    else:
        count = configuration.vertices or organ.vertex_count
        parts.insert(0, phrase("{count} vertices", count=count))
        law = find_unusual_law(configuration)
        if law:
            parts.insert(0, phrase("{law}", law=VALUE_NAMES[law]))
        if configuration.constants == "chosen":
            parts.insert(0, phrase("chosen constants"))
    return join(phrase("{kind}", kind=VALUE_NAMES[configuration.kind]), *parts)


def find_unusual_law(configuration: Configuration) -> str:
    """Of springs or of molecules, where it is not the usual one."""
    kind = configuration.kind
    if kind == "molecular" and configuration.angle_law != "gradient":
        return configuration.angle_law
    if kind == "mass_spring" and configuration.constants == "tissue":
        return configuration.spring_rule if configuration.spring_rule != "van_gelder" else ""
    return ""


def join(*parts: Phrase) -> Phrase:
    """One after the other, in any language."""
    first, *rest = parts
    return phrase("{first}, {rest}", first=first, rest=join(*rest)) if rest else first


def describe_provenance(configuration: Configuration, organ: Organ) -> Phrase:
    """Where the constants come from."""
    if configuration.kind in SURFACES and configuration.constants == "chosen":
        home = configuration.home_stiffness
        if home is None:
            return phrase(
                "chosen by hand: {stiffness:g} N/m, home springs by kind",
                stiffness=configuration.stiffness,
            )
        return phrase(
            "chosen by hand: {stiffness:g} N/m, home springs of {home:g} N/mm³",
            stiffness=configuration.stiffness,
            home=1e-9 * home,
        )
    material = organ.material
    values = {"modulus": 1e-3 * material.young_modulus, "ratio": material.poisson_ratio}
    if material.wall_thickness is None:
        return phrase("from E {modulus:g} kPa, nu {ratio:g}", **values)
    return phrase(
        "from E {modulus:g} kPa, nu {ratio:g}, a wall of {wall:g} mm",
        **values,
        wall=1e3 * material.wall_thickness,
    )
