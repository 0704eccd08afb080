# SPDX-License-Identifier: BSD-3-Clause
"""What a running tissue's alarm says, and what to do about it: one table for every program.

Commands print it in English. Windows have the same templates translated, context CONTEXT, by
palpate.translation, which keeps their Turkish.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from palpate import Alarm, AlarmKind, LoopReport, Safeguard, Scene, TickInput
from palpate.command.sentence import Sentence, fill, sentence
from palpate.runs.cause import Cause, find_cause
from palpate.runs.element import Element

CONTEXT = "Alarm"

Say = Callable[[str, str], str]
"""(context, English text) -> text, as QCoreApplication.translate."""
Write = Callable[[float], str]
"""A number in the digits of a language."""
Name = Callable[[str], str]
"""What a person calls a constant, by its key as in palpate.scene.scene_parts ("tool.stiffness")."""


@dataclass(frozen=True)
class Advice:
    """What a designer can do."""

    text: str
    """Places hold the values of the cause, if it has any, then the names of the constants."""
    constants: tuple[str, ...] = ()
    """Their keys."""
    unit: float = 1.0
    """The values are told in: of SI."""


@dataclass(frozen=True)
class AlarmText:
    """Of one kind of alarm."""

    event: str
    """%1 is what was measured, %2 what it may be."""
    hand: str
    """What the person who holds the tool can do."""
    design: Advice
    """What its designer can do, where no cause is found."""
    scale: float = 1.0
    """From the SI units of an alarm to those of `event`."""
    offset: float = 0.0


LIGHTER = "Press less deep or more slowly."
SLOWER = (
    "Move more slowly. If it happens again, the designer of this organ has to make it more stable."
)
STIFFER = Advice("Press less deep or more slowly, or make the organ stiffer.")
STEADIER = Advice(
    "More substeps (%1), softer springs (%2) or a larger mass (%3) hold it together.",
    ("hand.substeps", "model.stiffness", "material.density"),
)

ALARMS = {
    AlarmKind.not_finite: AlarmText(
        "the tissue blew up: a position is not a number", SLOWER, STEADIER
    ),
    AlarmKind.moved_far: AlarmText(
        "the tissue blew up: a point moved %1 mm between two checks, at most %2 mm is right",
        SLOWER,
        STEADIER,
        scale=1e3,
    ),
    AlarmKind.energy: AlarmText(
        "the tissue blew up: its energy rose to %1 mJ, what it was given allows %2 mJ",
        SLOWER,
        STEADIER,
        scale=1e3,
    ),
    AlarmKind.overstretched: AlarmText(
        "a link was stretched to %1 times its length at rest, at most %2 times is right",
        LIGHTER,
        STIFFER,
        offset=1.0,  # the alarm tells the strain
    ),
    AlarmKind.collapsed: AlarmText(
        "a link was squeezed to %1 % of its length at rest, at least %2 % is right",
        LIGHTER,
        STIFFER,
        scale=1e2,
    ),
    AlarmKind.inverted: AlarmText(
        "a tetrahedron was squeezed to %1 % of its volume at rest, at least %2 % is right",
        LIGHTER,
        STIFFER,
        scale=1e2,
    ),
    AlarmKind.pressed_deep: AlarmText(
        "the tissue was moved by %1 mm; there a linear solid is good for %2 mm",
        LIGHTER,
        Advice("Press less deep, or take a solid (MSS+V), which goes deeper."),
        scale=1e3,
    ),
    AlarmKind.invalid_input: AlarmText(
        "a tick was given a value that it cannot use",
        "Start again. If it comes again, the device or the program that runs it is at fault.",
        Advice("Give every tick finite numbers, and the scene as build_scene returned it."),
    ),
    AlarmKind.not_solved: AlarmText(
        "an implicit step of %1 ms found no balance of forces",
        LIGHTER,
        Advice(
            "Press less deep or more slowly, or choose more substeps (%1) or another integrator.",
            ("hand.substeps",),
        ),
        scale=1e3,
    ),
}

SAFEGUARDS = {
    Safeguard.half_steps: (
        "The tissue was about to blow up, and is stepped twice as finely for now."
    ),
    Safeguard.quarter_steps: (
        "The tissue was about to blow up, and is stepped four times as finely for now."
    ),
    Safeguard.implicit_damping: (
        "The tissue was about to blow up, and is damped implicitly for now."
    ),
    Safeguard.implicit_euler: (
        "The tissue was about to blow up, and its stiffest parts are solved for implicitly for now."
    ),
}
"""What holds a tissue together that would have raised an alarm."""

ELEMENTS = {
    "particle": "It began at the point at %1, %2, %3 mm.",
    "link": "It began in the link at %1, %2, %3 mm.",
    "tetrahedron": "It began in the tetrahedron at %1, %2, %3 mm.",
    "vertex": "It began at the point of the surface at %1, %2, %3 mm.",
}
"""Where an alarm is, by the name of its element (palpate.runs.element); at rest."""

AVERTED = (
    "%1 of %2 ticks needed shorter steps or implicit damping, or an alarm would have ended the run"
)

INPUTS = {
    TickInput.time: "the device gave a time of %1 s, expected a finite number",
    TickInput.position: "the device gave a position of %1 m, expected at most %2 m",
    TickInput.orientation: "the device gave an orientation with %1, expected finite numbers",
    TickInput.velocity: "the device gave a velocity of %1 m/s, expected a finite number",
    TickInput.grip: "the device gave a grip of %1 rad, expected a finite number",
    TickInput.dt: "a tick was asked to last %1 s, expected more than 0",
    TickInput.scene: "a tick was given scene %1, expected scene %2, which its world was made for",
    TickInput.tool_radius: "the radius of the tool became %1 m, expected more than 0",
    TickInput.tool_stiffness: "the stiffness of the tool became %1 N/m³, expected more than 0",
    TickInput.coupling_stiffness: "the coupling stiffness became %1 N/m, expected more than 0",
    TickInput.coupling_force_max: "the largest coupling force became %1 N, expected more than 0",
    TickInput.hold_stiffness: "the hold stiffness became %1 N/m, expected more than 0",
    TickInput.gravity: "gravity became %1 m/s², expected a finite number",
    TickInput.substeps: "the substeps became %1, expected at least %2",
    TickInput.substeps_max: "the most substeps became %1, expected at least %2",
    TickInput.tool_friction: "the friction of the tool became %1, expected at least 0",
}
"""What AlarmKind.invalid_input found, by the index of the alarm."""

CAUSES = {
    "stiffness": Advice(
        "The tissue needs %1 substeps a tick, at most %2 are taken: choose more (%3), softer "
        "springs (%4, or %5 where the tissue gives them) or a larger mass (%6).",
        ("hand.substeps", "model.stiffness", "material.young_modulus", "material.density"),
    ),
    "bend": Advice(
        "The angles of the tissue need %1 substeps a tick, at most %2 are taken: choose more (%3) "
        "or softer angles (%4, %5).",
        ("hand.substeps", "model.bend_stiffness", "model.stretch_coupling"),
    ),
    "home": Advice(
        "The home springs of the tissue need %1 substeps a tick, at most %2 are taken: choose more "
        "(%3) or softer ones (%4).",
        ("hand.substeps", "model.home_stiffness"),
    ),
    "modulus": Advice(
        "The tissue needs %1 substeps a tick, at most %2 are taken: choose more (%3), a softer "
        "tissue (%4, %5) or a larger mass (%6).",
        ("hand.substeps", "material.young_modulus", "material.poisson_ratio", "material.density"),
    ),
    "damping": Advice(
        "Its damping needs %1 substeps a tick, at most %2 are taken: choose less damping (%3) or "
        "more substeps (%4).",
        ("material.damping_ratio", "hand.substeps"),
    ),
    "drag": Advice(
        "Its drag needs %1 substeps a tick, at most %2 are taken: choose less drag (%3) or more "
        "substeps (%4).",
        ("model.drag", "hand.substeps"),
    ),
    "pressure": Advice(
        "A pressure of %1 kPa does it with nothing touching, and one of %2 kPa does not: choose a "
        "lower one (%3), or stiffer springs (%4, %5).",
        ("model.pressure", "model.stiffness", "model.home_stiffness"),
        unit=1e3,
    ),
    "eq10": Advice(
        "Angles of %1 N do it with nothing touching, for Eq 10 makes energy, and those of %2 N do "
        "not: choose another law of angles (%3) or softer angles (%4).",
        ("model.angle_law", "model.bend_stiffness"),
    ),
    "finer": Advice(
        "A light touch does it with %1 substeps a tick, and does not with %2: choose more (%3).",
        ("hand.substeps",),
    ),
    "contact": Advice(
        "A light touch does it with a contact stiffness of %1 N/mm³, and does not with %2 N/mm³: "
        "choose a lower one (%3).",
        ("tool.stiffness",),
        unit=1e9,
    ),
    "grip": Advice(
        "A light pull does it with a grip stiffness of %1 N/m, and does not with %2 N/m: choose a "
        "lower one (%3).",
        ("hand.hold_stiffness",),
    ),
}
"""What a designer can do about a cause (palpate.runs.cause)."""

OPTIONS = {
    "model.stiffness": "--stiffness",
    "model.bend_stiffness": "--bend",
    "model.stretch_coupling": "--stretch-bend",
    "model.home_stiffness": "--home",
    "model.drag": "--drag",
    "model.pressure": "--pressure",
    "model.angle_law": "--angle-law",
    "material.density": "--density",
    "material.damping_ratio": "--damping",
    "material.young_modulus": "--young-modulus",
    "material.poisson_ratio": "--poisson",
    "tool.stiffness": "--tool-stiffness",
    "hand.hold_stiffness": "--grip",
    "hand.substeps": "--substeps",
}
"""What commands call the constants that advice names: options of `palpate material`."""


def write_plain(value: float) -> str:
    return f"{value:.3g}"


def describe_alarm(alarm: Alarm, write: Write = write_plain) -> Sentence:
    """What happened, without a capital and a stop."""
    text = ALARMS[alarm.kind]
    event = text.event
    if alarm.kind is AlarmKind.invalid_input:
        event = INPUTS.get(alarm.index, event)
    shown = (text.scale * value + text.offset for value in (alarm.value, alarm.limit))
    return sentence(event, *(write(value) for value in shown))


def say_alarm(alarm: Alarm, say: Say, write: Write = write_plain) -> str:
    """What happened, in a language."""
    event = describe_alarm(alarm, write)
    return fill(say(CONTEXT, event.template), event.values)


def say_safeguard(safeguard: Safeguard, say: Say) -> str:
    """What a body is stepped by where it would blow up; nothing for none."""
    return say(CONTEXT, SAFEGUARDS[safeguard]) if safeguard in SAFEGUARDS else ""


def say_element(element: Element | None, say: Say, write: Write = write_plain) -> str:
    """Which element an alarm is of and where that is at rest; nothing for none."""
    if element is None:
        return ""
    text = say(CONTEXT, ELEMENTS[element.name])
    return fill(text, tuple(write(1e3 * float(c)) for c in element.place))


def tell_averted(report: LoopReport, scene: Scene | None) -> str:
    """What would have ended a run that safeguards held together, and what to do about it, as
    tell_alarm; nothing where none was needed."""
    if report.averted.kind is AlarmKind.none:
        return ""
    counted = fill(AVERTED, (str(report.safeguarded_ticks), str(report.ticks)))
    return f"{counted}: {tell_alarm(report.averted, scene, report.averted_body)}"


def advise_hand(kind: AlarmKind, say: Say) -> str:
    return say(CONTEXT, ALARMS[kind].hand)


def advise_design(
    alarm: Alarm, cause: Cause | None, say: Say, name: Name, write: Write = write_plain
) -> str:
    """What to change in an organ, and why where the cause is known, in a language; `name` says what
    the window or the command that is asked calls a constant."""
    advice = CAUSES[cause.name] if cause is not None else ALARMS[alarm.kind].design
    values = list_values(cause, advice.unit, write)
    return fill(say(CONTEXT, advice.text), (*values, *map(name, advice.constants)))


def list_values(cause: Cause | None, unit: float, write: Write) -> tuple[str, ...]:
    """What stands in the first places of an advice."""
    if cause is None or cause.value == cause.limit == 0.0:
        return ()
    return write(cause.value / unit), write(cause.limit / unit)


def tell_alarm(
    alarm: Alarm, scene: Scene | None, body: int = -1, element: Element | None = None
) -> str:
    """What happened, where, and what to do about it, in English and with the options of commands.
    `body` is World.alarm_body, -1 where it is not known.
    """
    cause = find_cause(scene, alarm, body) if scene is not None else None
    advice = advise_design(alarm, cause, lambda _, text: text, OPTIONS.__getitem__)
    where = say_element(element, lambda _, text: text)
    told = " ".join(filter(None, [f"{describe_alarm(alarm)}.", where, advice]))
    if cause is not None:
        body = cause.body
    if scene is None or len(scene.bodies) == 1 or body < 0:
        return told
    return f"body {body + 1} (bodies[{body}] of {len(scene.bodies)}): {told}"
