# SPDX-License-Identifier: BSD-3-Clause
"""What an alarm says, in every language, and what to do about it."""

from __future__ import annotations

import re
from types import SimpleNamespace

import palpate
import pytest
from palpate.runs.alarms import (
    ALARMS,
    CAUSES,
    CONTEXT,
    ELEMENTS,
    INPUTS,
    OPTIONS,
    SAFEGUARDS,
    Advice,
    advise_design,
    advise_hand,
    describe_alarm,
    say_alarm,
)
from palpate.runs.run import run_device
from palpate.translation import read_translations
from surfaces import organ_scene

AlarmKind = palpate.AlarmKind
KINDS = [kind for kind in AlarmKind if kind is not AlarmKind.none]
TURKISH = read_translations("palpate.translation", "tr")


def say_turkish(context: str, text: str) -> str:
    return TURKISH[context, text]


def raise_alarm(kind: palpate.AlarmKind, value: float, limit: float) -> palpate.Alarm:
    alarm = palpate.Alarm()
    alarm.kind, alarm.value, alarm.limit, alarm.time = kind, value, limit, 0.412
    return alarm


def test_every_alarm_has_words_of_its_own_in_english_and_turkish():
    assert set(ALARMS) == set(KINDS)
    alarms = [raise_alarm(kind, 3.0, 2.0) for kind in KINDS]

    assert len({str(describe_alarm(alarm)) for alarm in alarms}) == len(KINDS)
    assert len({say_alarm(alarm, say_turkish) for alarm in alarms}) == len(KINDS)
    spoken = {text for words in ALARMS.values() for text in (words.event, words.hand)}
    advices = [*CAUSES.values(), *(words.design for words in ALARMS.values())]
    spoken |= set(INPUTS.values()) | {advice.text for advice in advices}
    spoken |= set(SAFEGUARDS.values()) | set(ELEMENTS.values())
    assert {text for context, text in TURKISH if context == CONTEXT} == spoken


@pytest.mark.parametrize("name", palpate.TickInput.__members__)
def test_every_value_that_no_tick_can_use_has_a_sentence_with_what_it_was(name):
    alarm = raise_alarm(AlarmKind.invalid_input, 0.25, 7.5)
    alarm.index = int(palpate.TickInput[name])

    for told in (str(describe_alarm(alarm)), say_alarm(alarm, say_turkish)):
        assert "0.25" in told
        assert ("7.5" in told) == ("%2" in INPUTS[palpate.TickInput[name]])


def test_a_translated_alarm_has_the_numbers_of_the_english_one():
    for kind in KINDS:
        alarm = raise_alarm(kind, 0.0321, 0.0123)
        told, said = str(describe_alarm(alarm)), say_alarm(alarm, say_turkish)
        assert sorted(re.findall(r"\d[\d.]*", told)) == sorted(re.findall(r"\d[\d.]*", said))
        assert not re.search(r"%\d\b(?!\d)", told.replace("%", "", told.count(" %")))


def test_a_strain_of_two_is_three_times_the_length_at_rest():
    words = str(describe_alarm(raise_alarm(AlarmKind.overstretched, 2.1, 2.0)))

    assert words == "a link was stretched to 3.1 times its length at rest, at most 3 times is right"


def test_only_what_is_unstable_is_said_to_have_blown_up():
    blown = {kind for kind in KINDS if "blew up" in ALARMS[kind].event}

    assert blown == {AlarmKind.not_finite, AlarmKind.moved_far, AlarmKind.energy}
    for kind in set(KINDS) - blown - {AlarmKind.invalid_input}:
        assert advise_hand(kind, lambda _, text: text).startswith("Press less deep")
        alarm = raise_alarm(kind, 3.0, 2.0)
        told = advise_design(alarm, None, lambda _, text: text, OPTIONS.__getitem__)
        assert told.startswith("Press less deep")


def list_advice() -> list[tuple[Advice, int]]:
    """Every advice, and how many values of its cause it holds."""
    causes = [(advice, 2) for advice in CAUSES.values()]
    return causes + [(words.design, 0) for words in ALARMS.values()]


def test_an_advice_has_a_place_for_every_value_and_constant_in_every_language():
    for advice, values in list_advice():
        places = {f"%{k + 1}" for k in range(values + len(advice.constants))}
        for text in (advice.text, say_turkish(CONTEXT, advice.text)):
            assert set(re.findall(r"%\d", text)) == places
            assert "--" not in text


def test_no_advice_to_a_hand_names_an_option_or_a_field():
    for words in ALARMS.values():
        assert "--" not in words.hand and "%" not in words.hand


def test_a_press_that_overstretches_says_so_and_what_to_do(monkeypatch, tmp_path):
    alarm = raise_alarm(AlarmKind.overstretched, 2.1, 2.0)
    costs = SimpleNamespace(alarm=alarm, alarm_body=0, fault=palpate.DeviceFault.none)

    class Over:
        def __init__(self, *_, **__): ...
        def __enter__(self):
            return self

        def __exit__(self, *_): ...
        def wait(self, _):
            return True

        def finish(self):
            return costs

    monkeypatch.setattr("palpate.runs.run.LiveRun", Over)
    monkeypatch.setattr("palpate.runs.run.describe_build", lambda *_: {})
    with pytest.raises(RuntimeError) as stopped:
        run_device(organ_scene(1), SimpleNamespace(name=str), 1.0, tmp_path / "r", tmp_path / "s")

    assert str(stopped.value) == (
        "the run was stopped at 0.412 s: a link was stretched to 3.1 times its length at rest, "
        "at most 3 times is right. Press less deep or more slowly, or make the organ stiffer."
    )
