# SPDX-License-Identifier: GPL-3.0-or-later
"""What an advisor says, in sentences that a window can say in another language."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from palpate.scene.scene_parts import VALIDATED_PART, VALIDATED_RADII
from palpate.study.advice import (
    DISPLACEMENT,
    FORCE,
    STEP,
    TIME,
    TIME_FACTOR,
    TRUTH,
    Advice,
    Candidate,
    Need,
    is_deeper,
)
from palpate.study.scene_chart import Chart

from palpate_editor.configuration import join, name_configuration
from palpate_editor.document import Organ, Phrase, phrase

if TYPE_CHECKING:  # they load SciPy
    from palpate.study.held_out import Score

    from palpate_editor.advise import Advised, Ground

CLOSE = 1.02
"""[-] Of what is allowed or another length, within which it is the same."""


def describe_advised(advised: Advised, chart: Chart, organ: Organ) -> list[Phrase]:
    """The choice, what it is valid for, its margins, what binds, its neighbours, its score."""
    advice = advised.advice
    lines = [say_choice(advice, organ)]
    if advice.choice is None:
        return lines
    if advised.ground is not None:
        lines += describe_ground(advised.ground, organ)
    if is_deeper(advice.targets, chart):
        lines.append(
            phrase(
                "It will be pressed or pulled {depth:.1f} mm: kinds for small displacements are "
                "left out, and how right the others are so far was not asked.",
                depth=1e3 * advice.targets.depth,
            )
        )
    lines += [say_need(need) for need in advice.choice.needs]
    lines.append(say_binding(advice))
    lines += describe_neighbours(advice, organ)
    if advised.score is not None:
        lines += describe_score(advised.score, advice.choice, chart)
    if advised.own_score is not None:
        lines.append(say_own_score(advised.own_score))
    return lines


def say_choice(advice: Advice, organ: Organ) -> Phrase:
    if advice.choice is None:
        return phrase(
            "None of {tried} configurations came to the end of the path, so there is nothing to "
            "choose from.",
            tried=advice.tried,
        )
    name = name_configuration(advice.choice.configuration, organ)
    if not advice.fits:
        return phrase(
            "None of the {ran} configurations that ran meets every target. Nearest: {name}.",
            ran=advice.ran,
            name=name,
        )
    if advice.keeps_own:
        return phrase("Keep what it has: {name}.", name=name)
    return phrase("The cheapest that meets every target: {name}.", name=name)


def describe_ground(ground: Ground, organ: Organ) -> Iterator[Phrase]:
    """How deep it holds, and what is touched there."""
    yield say_depth(ground, organ)
    if ground.contact_radius is not None:
        yield phrase(
            "There the ball touches a circle of {contact:.1f} mm radius, on edges of {edge:.1f} "
            "mm: {across:.1f} of them across it.",
            contact=1e3 * ground.contact_radius,
            edge=1e3 * ground.edge,
            across=2.0 * ground.contact_radius / ground.edge,
        )
    else:
        yield phrase("Edges of {edge:.1f} mm are touched.", edge=1e3 * ground.edge)


def say_depth(ground: Ground, organ: Organ) -> Phrase:
    """The depth, and the length that bounds it."""
    depth, wall = ground.depth, organ.material.wall_thickness
    values = {"depth": 1e3 * depth, "radius": 1e3 * organ.tool.radius}
    if depth * CLOSE >= VALIDATED_RADII * organ.tool.radius:
        return phrase(
            "Validated to {depth:.1f} mm deep, one and a half times the tip's radius of "
            "{radius:g} mm.",
            **values,
        )
    if wall is not None and depth * CLOSE >= wall:
        return phrase("Validated to {depth:.1f} mm deep, the thickness of its wall.", **values)
    thickness = depth / VALIDATED_PART if ground.thickness is None else ground.thickness
    if depth * CLOSE >= VALIDATED_PART * thickness:
        return phrase(
            "Validated to {depth:.1f} mm deep, a tenth of the thickness of {thickness:.0f} mm.",
            **values,
            thickness=1e3 * thickness,
        )
    return phrase("Validated to {depth:.1f} mm deep.", **values)


def say_need(need: Need) -> Phrase:
    """A target, and what the choice has of it."""
    values = {"value": need.value, "allowed": need.allowed}
    if need.value is None:
        return phrase("Displacement: nobody looked at it, so it meets no target.")
    if need.name == FORCE:
        return phrase(
            "Force {value:.1%} off with the truth's own error, of {allowed:.0%} allowed.", **values
        )
    if need.name == DISPLACEMENT:
        return phrase(
            "Displacement {value:.1%} off with the truth's own error, of {allowed:.0%} allowed.",
            **values,
        )
    if need.name == TIME:
        return phrase(
            "{factor:g} times the p99 of a tick in touch is {value:.3g} µs, of {allowed:.4g} µs "
            "allowed.",
            value=1e6 * need.value,
            factor=TIME_FACTOR,
            allowed=1e6 * need.allowed,
        )
    if need.value == 0.0:
        return phrase("Its steps are stable at any length.")
    return phrase(
        "Its steps are {value:.2f} of the longest stable one, of {allowed:g} allowed.", **values
    )


def say_binding(advice: Advice) -> Phrase:
    """What keeps from something cheaper, or from a choice that fits."""
    if not advice.fits:
        return say_miss(advice.binding)
    if advice.binding == FORCE:
        return phrase("Accuracy binds: the force of what is cheaper is further off.")
    if advice.binding == DISPLACEMENT:
        return phrase("Accuracy binds: the shape of what is cheaper is further off.")
    if advice.binding == TIME:
        return phrase("Time binds: what is cheaper on average has longer ticks among them.")
    if advice.binding == STEP:
        return phrase("Stability binds: what is cheaper steps too near its limit.")
    if advice.binding == TRUTH:
        return phrase(
            "The truth binds: something cheaper would do, but for what the truth itself leaves "
            "open."
        )
    return phrase("Nothing binds: no other configuration is cheaper for certain.")


def say_miss(binding: str) -> Phrase:
    if binding == FORCE:
        return phrase("Accuracy binds: its force is too far off.")
    if binding == DISPLACEMENT:
        return phrase("Accuracy binds: its shape is too far off.")
    if binding == TIME:
        return phrase("Time binds: its ticks in touch take too long.")
    if binding == STEP:
        return phrase("Stability binds: its steps are too long.")
    return phrase(
        "The truth binds: by itself it would do, but the truth leaves more open than the target."
    )


def describe_neighbours(advice: Advice, organ: Organ) -> Iterator[Phrase]:
    """What the next cheaper and the next better give up."""
    choice, cheaper, better = advice.choice, advice.cheaper, advice.better
    assert choice is not None
    if cheaper is not None:
        yield phrase(
            "Next cheaper: {name}; {times:.2g} times cheaper, with {misses}.",
            name=name_configuration(cheaper.configuration, organ),
            times=choice.cost.median / cheaper.cost.median,
            misses=say_given_up(cheaper),
        )
    if better is None:
        yield phrase("Nothing on the chart is better by more than the truth's own error.")
    else:
        yield phrase(
            "Next better: {name}; {times:.2g} times the cost, with {misses}.",
            name=name_configuration(better.configuration, organ),
            times=better.cost.median / choice.cost.median,
            misses=say_given_up(better),
        )


def say_given_up(candidate: Candidate) -> Phrase:
    """The force of a neighbour, and what it misses beside that."""
    assert candidate.row.total is not None
    parts = [phrase("a force {error:.1%} off", error=candidate.row.total.force_rms)]
    parts += [say_missed(need) for need in candidate.misses if need.name != FORCE]
    return join(*parts)


def say_missed(need: Need) -> Phrase:
    if need.name == TIME:
        return phrase("ticks {times:.2g} times too long", times=need.ratio)
    if need.name == STEP:
        return phrase("steps {times:.2g} times too long", times=need.ratio)
    if need.value is None:
        return phrase("a shape that nobody looked at")
    return phrase("a shape {error:.1%} off", error=need.value)


def describe_score(score: Score, choice: Candidate, chart: Chart) -> Iterator[Phrase]:
    """The held-out presses beside the chart."""
    if not score.presses:
        yield phrase(
            "No place is left to score it at: all are near what is held, or what was charted."
        )
        return
    total = choice.row.total
    assert total is not None
    if score.errors is None:
        alarm = next(press.alarm for press in score.presses if press.errors is None)
        yield phrase("Not scored: an alarm ended a held-out press ({why}).", why=alarm)
        return
    template = (
        "On one press held out from the choice its force is {held:.1%} off, where the chart has "
        "{charted:.1%}; the truth is known to {truth:.1%} there, to {own:.1%} on the chart."
        if len(score.presses) == 1
        else "On {count} presses held out from the choice its force is {held:.1%} off, where the "
        "chart has {charted:.1%}; the truth is known to {truth:.1%} there, to {own:.1%} on the "
        "chart."
    )
    yield phrase(
        template,
        count=len(score.presses),
        held=score.errors.force_rms,
        charted=total.force_rms,
        truth=score.force_error,
        own=chart.truth.force_error,
    )
    if score.errors.displacement is not None and total.displacement is not None:
        yield phrase(
            "Its displacement is {held:.1%} off there, {charted:.1%} on the chart.",
            held=score.errors.displacement,
            charted=total.displacement,
        )


def say_own_score(score: Score) -> Phrase:
    """What the organ came with, on the same presses."""
    if score.errors is None:
        return phrase("What it has now does not come to the end of the held-out presses.")
    return phrase(
        "What it has now is {held:.1%} off on the held-out presses.", held=score.errors.force_rms
    )
