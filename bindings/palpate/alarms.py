# SPDX-License-Identifier: BSD-3-Clause
"""What a running tissue's alarm says, and what to do about it: one table for every program.

Commands print it in English. Windows have the same templates translated, context CONTEXT, by
palpate.translation, which keeps their Turkish.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from palpate import Alarm, AlarmKind
from palpate.sentence import Sentence, fill, sentence

CONTEXT = "Alarm"

Say = Callable[[str, str], str]
"""(context, English text) -> text, as QCoreApplication.translate."""
Write = Callable[[float], str]
"""A number in the digits of a language."""


@dataclass(frozen=True)
class Words:
    """Of one kind of alarm."""

    found: str
    """%1 is what was measured, %2 what it may be."""
    hand: str
    """What whoever holds the tool can do."""
    design: str
    """What whoever made the organ can do."""
    scale: float = 1.0
    """From the SI units of an alarm to those of `found`."""
    offset: float = 0.0


LIGHTER = "Press less deep or more slowly."
SLOWER = "Move more slowly. If it comes again, whoever made this organ has to make it more stable."
STIFFER = "Press less deep or more slowly, or make the organ stiffer."
STEADIER = "More substeps, softer springs, more damping or a larger mass hold it together."

ALARMS = {
    AlarmKind.not_finite: Words("the tissue blew up: a position is not a number", SLOWER, STEADIER),
    AlarmKind.moved_far: Words(
        "the tissue blew up: a point moved %1 mm between two looks, at most %2 mm is right",
        SLOWER,
        STEADIER,
        scale=1e3,
    ),
    AlarmKind.energy: Words(
        "the tissue blew up: its energy rose to %1 mJ, what it was given allows %2 mJ",
        SLOWER,
        STEADIER,
        scale=1e3,
    ),
    AlarmKind.overstretched: Words(
        "a link was stretched to %1 times its length at rest, at most %2 times is right",
        LIGHTER,
        STIFFER,
        offset=1.0,  # the alarm tells the strain
    ),
    AlarmKind.collapsed: Words(
        "a link was squeezed to %1 % of its length at rest, at least %2 % is right",
        LIGHTER,
        STIFFER,
        scale=1e2,
    ),
    AlarmKind.inverted: Words(
        "a tetrahedron was squeezed to %1 % of its volume at rest, at least %2 % is right",
        LIGHTER,
        STIFFER,
        scale=1e2,
    ),
    AlarmKind.pressed_deep: Words(
        "the tissue was moved by %1 mm; there a linear solid is good for %2 mm",
        LIGHTER,
        "Press less deep, or take a solid (MSS+V), which goes deeper.",
        scale=1e3,
    ),
}


def write_plain(value: float) -> str:
    return f"{value:.3g}"


def describe_alarm(alarm: Alarm, write: Write = write_plain) -> Sentence:
    """What happened, without a capital and a stop."""
    words = ALARMS[alarm.kind]
    shown = (words.scale * value + words.offset for value in (alarm.value, alarm.limit))
    return sentence(words.found, *(write(value) for value in shown))


def say_alarm(alarm: Alarm, say: Say, write: Write = write_plain) -> str:
    """What happened, in a language."""
    found = describe_alarm(alarm, write)
    return fill(say(CONTEXT, found.template), found.values)


def advise_hand(kind: AlarmKind, say: Say) -> str:
    return say(CONTEXT, ALARMS[kind].hand)


def advise_design(kind: AlarmKind, say: Say) -> str:
    return say(CONTEXT, ALARMS[kind].design)
