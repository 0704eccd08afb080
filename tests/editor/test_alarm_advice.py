# SPDX-License-Identifier: GPL-3.0-or-later
"""What an alarm advises a designer to do can be done: its options are those of the verb."""

from __future__ import annotations

import re

from palpate.alarms import ALARMS, CAUSES
from palpate_editor.compile import compile_organ
from palpate_editor.edits import SetConstant
from palpate_editor.shipped import make_organ
from palpate_editor.verbs.tissue import OPTIONS


def test_every_option_that_an_alarm_names_is_one_of_palpate_material():
    advice = " ".join([*CAUSES.values(), *(words.design for words in ALARMS.values())])

    named = set(re.findall(r"--[a-z-]+", advice))

    assert {"--substeps", "--tool-stiffness", "--pressure", "--damping"} <= named
    assert named <= {option for option, _ in OPTIONS.values()}


def test_asked_for_substeps_are_taken_where_the_tissue_needs_fewer():
    organ = make_organ("spleen", 300)
    usual = compile_organ(organ)

    more = compile_organ(SetConstant("hand", "substeps", usual.substeps + 5.0)(organ))
    fewer = compile_organ(SetConstant("hand", "substeps", 0.0)(organ))

    assert (more.substeps, more.substeps_max) == (usual.substeps + 5, usual.substeps_max + 5)
    assert (fewer.substeps, fewer.substeps_max) == (usual.substeps, usual.substeps_max)
    assert type(SetConstant("hand", "substeps", 7.0)(organ).hand.substeps) is int
