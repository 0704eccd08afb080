# SPDX-License-Identifier: GPL-3.0-or-later
"""What an alarm advises a designer to do can be done where it is read: its options are those of the
verb, its fields those of the window."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import palpate
import pytest
from palpate.runs.alarms import ALARMS, CAUSES, OPTIONS
from palpate.runs.cause import find_cause
from palpate_editor.argument_text import LAWS
from palpate_editor.compile import compile_organ
from palpate_editor.document import Organ
from palpate_editor.document.constants import CONSTANTS, LAW_NAMES, find_constant
from palpate_editor.edits import SetConstant
from palpate_editor.open_organ import open_organ
from palpate_editor.views.touch.trial import advise, name_field

SPRINGS = Path(__file__).resolve().parents[1] / "scenes" / "springs" / "spleen.palpate"
ADVICES = [*CAUSES.values(), *(words.design for words in ALARMS.values())]
NAMED = {key for advice in ADVICES for key in advice.constants}


def test_every_option_that_an_alarm_names_is_one_of_palpate_material():
    verb = {constant.key: constant.option for constant in CONSTANTS} | LAWS

    assert set(OPTIONS) == NAMED
    assert {verb[key] for key in NAMED} == set(OPTIONS.values())
    assert all(OPTIONS[key] == verb[key] for key in NAMED)


@pytest.mark.parametrize("key", sorted(NAMED))
def test_a_window_names_the_stage_and_the_label_of_a_constant(key, qapp):
    part, field = key.split(".")
    constant = find_constant(part, field)
    label = LAW_NAMES[field] if constant is None else constant.label

    assert name_field(key) == f"Material \N{SINGLE RIGHT-POINTING ANGLE QUOTATION MARK} {label}"


@pytest.fixture(scope="module")
def organ() -> Organ:
    return open_organ(SPRINGS)


def test_a_run_that_ends_in_the_window_names_fields_and_no_options(qapp, organ):
    scene = compile_organ(SetConstant("tool", "stiffness", 3e10)(organ))
    alarm = palpate.Alarm()
    alarm.kind, alarm.time, alarm.value, alarm.limit = palpate.AlarmKind.energy, 0.5, 2e-3, 1e-3

    told = advise(SimpleNamespace(alarm=alarm), find_cause(scene, alarm))

    assert "--" not in told
    assert "contact stiffness of 30 N/mm³" in told
    assert name_field("tool.stiffness") in told


def test_asked_for_substeps_are_taken_where_the_tissue_needs_fewer(organ):
    usual = compile_organ(organ)

    more = compile_organ(SetConstant("hand", "substeps", usual.bodies[0].substeps + 5.0)(organ))
    fewer = compile_organ(SetConstant("hand", "substeps", 0.0)(organ))

    assert (more.bodies[0].substeps, more.bodies[0].substeps_max) == (
        usual.bodies[0].substeps + 5,
        usual.bodies[0].substeps_max + 5,
    )
    assert (fewer.bodies[0].substeps, fewer.bodies[0].substeps_max) == (
        usual.bodies[0].substeps,
        usual.bodies[0].substeps_max,
    )
    assert type(SetConstant("hand", "substeps", 7.0)(organ).hand.substeps) is int
