# SPDX-License-Identifier: BSD-3-Clause
"""Sentences of the trainee's window that depend on what happened."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np
from PySide6.QtCore import QCoreApplication, QLocale

import palpate
from palpate.command.sentence import fill
from palpate.command.verb import Report
from palpate.runs.alarms import advise_hand, say_alarm, say_safeguard
from palpate.runs.coupling import FELT_WITHIN
from palpate.runs.live import Frame
from palpate.runs.pinch import Pinch, list_wrong, tell_rows
from palpate.translation.numbers import say_digits
from palpate.viewport.hint_line import PLAIN, Means, say_hands, say_jaws, say_taking, say_turns

translate = QCoreApplication.translate


def say_notice() -> str:
    """Stands on every screen."""
    return translate("Player", "Not validated. Not a medical device.")


def say_end(alarm: palpate.Alarm) -> str:
    """What an alarm was, and what the hand can do about it."""
    text = translate(
        "Player",
        "The force was switched off after %1 s: %2. %3 Press R to start again.",
    )
    advice = advise_hand(alarm.kind, translate)
    values = format_number(alarm.time, 1), say_alarm(alarm, translate, format_short), advice
    return fill(text, values)


def say_fault(fault: palpate.DeviceFault) -> str:
    """Why a run rests that its device cannot go on with."""
    causes = {
        palpate.DeviceFault.sample_not_finite: translate(
            "Player",
            "The device reported a position that is not a number, so its force was switched off. "
            "Check its cable, then press R to start again.",
        ),
        palpate.DeviceFault.sample_out_of_reach: translate(
            "Player",
            "The device reported a position where no hand reaches, so its force was switched off. "
            "Check its calibration, then press R to start again.",
        ),
        palpate.DeviceFault.sample_too_fast: translate(
            "Player",
            "The device reported a speed that no hand has, so its force was switched off. "
            "Check its cable, then press R to start again.",
        ),
        palpate.DeviceFault.motors_cut: translate(
            "Player",
            "Paused: the motors of the device are off, so no force can be felt. "
            "Press R to start again.",
        ),
        palpate.DeviceFault.device_failed: translate(
            "Player",
            "The device is gone: its cable is out, or it has fallen silent. "
            "Plug it in again, then press R to start again.",
        ),
    }
    return causes.get(fault) or translate(
        "Player",
        "The computed force was not a number, so the force was switched off. "
        "Press R to start again.",
    )


def say_outcome(state: palpate.TaskState) -> str:
    """How a task came out."""
    outcome = palpate.Outcome
    sentences = {
        outcome.done: translate("Player", "The task is done. Errors: %1."),
        outcome.failed: translate("Player", "The task has failed. Errors: %1."),
        outcome.timed_out: translate("Player", "The time for the task is over. Errors: %1."),
        outcome.device_fault: translate("Player", "The device failed before the task was done."),
        outcome.diverged: translate("Player", "The task could not be judged to its end."),
    }
    left = translate("Player", "The task was left before it was done. Errors: %1.")
    return sentences.get(state.outcome, left).replace("%1", str(state.errors))


def say_no_force() -> str:
    return translate("Player", "The mouse gives no force: these numbers are not comparable.")


def say_outcome_of(outcome: str) -> str:
    """As the database has it, in a word."""
    outcomes = {
        "done": translate("Player", "done"), "failed": translate("Player", "failed"),
        "timed_out": translate("Player", "time over"), "left": translate("Player", "left"),
        "device_fault": translate("Player", "device failed"),
        "diverged": translate("Player", "could not be judged"),
    }  # fmt: skip
    return outcomes.get(outcome, translate("Player", "interrupted"))


def say_earlier(row: Report) -> str:
    """An attempt of the database."""
    outcome = say_outcome_of(row["outcome"])
    clock = format_clock(row["ticks"] / 1000.0)
    return f"{row['started'][:10]}  {row['level']}  {outcome}, {clock}"


def say_slow(missed: int, due: int) -> str:
    text = translate(
        "Player",
        "This computer is too slow just now: %1 of the last %2 force updates were missed.",
    )
    return text.replace("%1", str(missed)).replace("%2", str(due))


def say_damped(count: int) -> str:
    """Of the passivity controller, in the last second."""
    text = translate(
        "Player", "The force was damped %1 times: it was about to push the hand along by itself."
    )
    return text.replace("%1", str(count))


def say_held(safeguard: palpate.Safeguard) -> str:
    """What keeps the tissue from blowing up, and what the hand can do about it."""
    held = say_safeguard(safeguard, translate)
    return f"{held} {advise_hand(palpate.AlarmKind.energy, translate)}" if held else ""


def say_gestures(means: Means = PLAIN) -> list[tuple[str, str]]:
    """What a hand can do and how, with its first instrument."""
    return [
        (translate("Player", "Move"), translate("Player", "stroke along the surface")),
        (translate("Player", "Left button"), translate("Player", "press")),
        (translate("Player", "Wheel"), translate("Player", "deeper or higher")),
        (translate("Player", "Right button"), say_taking(means)),
        *say_jaws(means),
        *say_turns(means),
        *say_hands(means),
        (translate("Player", "Beside the organ"), translate("Player", "turn the view")),
    ]


def say_stylus(means: Means = PLAIN) -> list[tuple[str, str]]:
    """What a hand can do with the stylus of a device, and with the mouse beside it."""
    return [
        (translate("Player", "Stylus"), translate("Player", "moves the tip")),
        (translate("Player", "Its button"), say_taking(means)),
        ("", translate("Player", "here and in the menu: as Enter")),
        (translate("Player", "Mouse"), translate("Player", "turn the view")),
    ]


def say_keys() -> list[tuple[str, str]]:
    return [
        (translate("Player", "Space"), translate("Player", "pause")),
        ("R", translate("Player", "restart")),
        ("T", translate("Player", "task")),
        ("F", translate("Player", "force arrow")),
        ("F11", translate("Player", "full screen")),
        ("Esc", translate("Player", "menu")),
    ]


def say_forces(frame: Frame, pinches: Mapping[int, Pinch]) -> list[tuple[str, str]]:
    """The force on the hand of each of several instruments, where of one the force bar tells it;
    how hard jaws press, and how far what is about them is stretched; whether tissue keeps one from
    turning as its hand does; and how much softer than it is a tissue is felt through a device that
    bears no more."""
    name = translate("Player", "Instrument %1")
    several = len(frame.instruments) > 1
    rows, names = [], name_rows(several)
    for index, one in enumerate(frame.instruments):
        if several:
            force = format_number(float(np.linalg.norm(one.force)), 2)
            rows.append((name.replace("%1", str(index + 1)), f"{force} N"))
        rows += [(row, say_digits(told)) for row, told in tell_rows(index, pinches, *names)]
        if one.turn_limited:
            turns = translate("Player", "Turning %1") if several else translate("Player", "Turning")
            rows.append(
                (turns.replace("%1", str(index + 1)), translate("Player", "held by tissue"))
            )
    softer = max(one.stiffness_error for one in frame.instruments)
    if softer > FELT_WITHIN:
        rows.append((translate("Player", "Feels softer"), f"{format_number(100 * softer, 0)} %"))
    return rows


def name_jaws(index: int, several: bool) -> str:
    """Of which instrument they are, where there are several."""
    if not several:
        return translate("Player", "Jaws")
    return translate("Player", "Jaws %1").replace("%1", str(index + 1))


def name_stretch(index: int, several: bool) -> str:
    """Of what the jaws of which instrument hold."""
    if not several:
        return translate("Player", "Stretch")
    return translate("Player", "Stretch %1").replace("%1", str(index + 1))


def name_rows(several: bool) -> tuple[Callable[[int], str], Callable[[int], str]]:
    """What names the rows of an instrument's jaws, and of what is about them."""
    return partial(name_jaws, several=several), partial(name_stretch, several=several)


def name_wrong(pinches: Mapping[int, Pinch], several: bool) -> list[str]:
    """The rows whose number is beyond what it may be."""
    return list_wrong(pinches, *name_rows(several))


def format_number(value: float, decimals: int) -> str:
    """As the language of the window writes it."""
    return QLocale().toString(value, "f", decimals)


def format_short(value: float) -> str:
    """Three digits that count, as the language of the window writes them."""
    return QLocale().toString(value, "g", 3)


def format_clock(seconds: float) -> str:
    """Minutes, seconds and tenths, cut off and not rounded."""
    tenths = int(10.0 * max(0.0, seconds) + 1e-6)
    return f"{tenths // 600}:{tenths // 10 % 60:02d}{QLocale().decimalPoint()}{tenths % 10}"
