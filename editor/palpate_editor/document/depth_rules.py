# SPDX-License-Identifier: GPL-3.0-or-later
"""The rule about presses that go deeper than what a truth was solved for [accuracy: tool]."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from palpate.scene.scene_parts import VALIDATED_PART, VALIDATED_RADII, VALIDATED_TIPS, is_deeper

from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import Phrase, phrase
from palpate_editor.document.problems import PlaceFacts, PressFacts, Problem


def find_depth_problems(organ: Organ, presses: Sequence[PressFacts]) -> Iterator[Problem]:
    """Of the Test stage: the press that goes farthest beyond what is validated at its place."""
    deep = [p for p in presses if is_deeper(p.depth, p.place.validated)]
    if not deep:
        return
    worst = max(deep, key=lambda press: press.depth - press.place.validated)
    yield Problem(
        "deep_press",
        "warning",
        "test",
        "press.depth",
        say_depth(organ, worst),
        say_remedy(worst),
    )


def say_depth(organ: Organ, press: PressFacts) -> Phrase:
    """How deep the press goes, and to which depth it is validated."""
    place = press.place
    if place.bound == "tip":
        return phrase(
            "a press of {depth:.1f} mm with a tip of {radius:g} mm, for which no depth is "
            "validated",
            depth=1e3 * press.depth,
            radius=1e3 * organ.tool.radius,
        )
    is_thin, is_wall = place.bound == "thickness", place.bound == "wall"
    template = (
        "{depth:.1f} mm deep at {x}, {y}, {z} mm, where {validated:.1f} mm are "
        "validated: a tenth of the thickness of {length:.1f} mm"
        if is_thin
        else "{depth:.1f} mm deep at {x}, {y}, {z} mm, where {validated:.1f} mm are "
        "validated: the thickness of its wall, {length:.1f} mm"
        if is_wall
        else "{depth:.1f} mm deep at {x}, {y}, {z} mm, where {validated:.1f} mm are "
        "validated: one and a half times the tip's radius of {length:.1f} mm"
    )
    lengths = {
        "thickness": place.thickness or 0.0,
        "radius": organ.tool.radius,
        "wall": place.validated,
    }
    return phrase(
        template,
        depth=1e3 * press.depth,
        validated=1e3 * place.validated,
        length=1e3 * lengths[place.bound],
        **dict(zip("xyz", (round(1e3 * c) for c in place.point), strict=True)),
    )


def say_remedy(press: PressFacts) -> Phrase:
    """What to do for the force to be one that was compared."""
    place = press.place
    if place.bound == "tip":
        return phrase(
            "a ball of {least:g} to {most:g} mm, as those that forces were compared with",
            least=1e3 * VALIDATED_TIPS[0],
            most=1e3 * VALIDATED_TIPS[1],
        )
    radius = press.depth / VALIDATED_RADII
    if (
        place.bound == "radius"
        and radius <= VALIDATED_TIPS[1]
        and can_be_deeper(press.depth, place)
    ):
        return phrase(
            "at most {validated:.1f} mm, or a tip of {radius:.1f} mm: deeper no truth was solved "
            "to compare the force with",
            validated=1e3 * place.validated,
            radius=1e3 * radius,
        )
    return phrase(
        "at most {validated:.1f} mm: deeper no truth was solved to compare the force with",
        validated=1e3 * place.validated,
    )


def can_be_deeper(depth: float, place: PlaceFacts) -> bool:
    """Whether a larger tip may go to a depth [m], as far as the thickness is concerned."""
    return place.thickness is None or depth <= VALIDATED_PART * place.thickness
