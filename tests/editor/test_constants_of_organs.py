# SPDX-License-Identifier: GPL-3.0-or-later
"""Every constant of shipped organs a thousand times too large and too small: each organ is opened,
checked and pressed, and either bears it or says which constant is wrong and what would do."""

from __future__ import annotations

from pathlib import Path

import pytest
from palpate_editor.check import assess
from palpate_editor.document import Organ
from palpate_editor.document.constants import CONSTANTS
from palpate_editor.document.problems import Problem
from palpate_editor.edits import SetConstant
from palpate_editor.edits.edit import EditError
from palpate_editor.open_organ import open_organ
from test_wrong_constants import bears_presses

PUBLISHED = Path(__file__).resolve().parents[2] / "meshes" / "published"
SECONDS = 2.0
"""[s] of presses and pulls that a constant must bear, or what was offered in its place."""
BORNE, REFUSED, ENDED = "borne", "refused", "ended"
"""A press ends no run; the edit says the range; a press ends the run, and no check has said so."""
RADIUS, FORCE, RATE = (
    f"tissue at scene.{name}"
    for name in ("instruments[0].tool.radius", "instruments[0].coupling.force_max", "rate")
)
"""What build_scene refuses with the range that it takes."""
LATE_MENDED = "late_tick at tick, mended"
"""It names the constant, and its fix sets it."""
LOW_RATE = "low_rate at hand.rate, mended"

TOOL_AND_HAND = {
    "tool.radius": (RADIUS, RADIUS),
    "tool.trocar_height": (REFUSED, BORNE),
    "tool.grip_force": (REFUSED, BORNE),
    "hand.force_max": (FORCE, BORNE),
    "hand.rate": (RATE, LOW_RATE),
}
HARD_DAMPING = ("hard_constant at material.damping_ratio, mended", BORNE)
HARD_MODULUS = ("hard_constant at material.young_modulus, mended", BORNE)
LIGHT = (BORNE, "hard_constant at material.density, mended")
SOLID = TOOL_AND_HAND | {
    "material.density": LIGHT,
    "material.damping_ratio": HARD_DAMPING,
    "material.young_modulus": HARD_MODULUS,
    "material.poisson_ratio": (REFUSED, "tissue at material: poisson_ratio"),
}


def find_wall_verdicts(triangle: int) -> dict[str, tuple[str, str]]:
    """Of walls of prisms, whose first triangle a wall too thick does not fit."""
    return TOOL_AND_HAND | {
        "material.damping_ratio": HARD_DAMPING,
        "material.wall_thickness": (
            f"tissue at mesh: triangle {triangle}",
            "hard_constant at material.wall_thickness, mended",
        ),
        "material.poisson_ratio": (REFUSED, BORNE),
    }


WRONG = {
    "kidney_stone": TOOL_AND_HAND
    | {
        "material.young_modulus": (BORNE, "all_fixed at fixed"),
        "material.poisson_ratio": (REFUSED, BORNE),
        "hand.rate": (RATE, BORNE),
    },
    "simple_tissue": find_wall_verdicts(0),
    "gallbladder": find_wall_verdicts(16)
    | {
        "material.density": LIGHT,
        "material.young_modulus": HARD_MODULUS,
    },
    "spleen": SOLID,
    "stomach": find_wall_verdicts(26)
    | {"material.density": LIGHT, "material.young_modulus": HARD_MODULUS},
    "collecting_system": SOLID,
    "kidney": SOLID,
    "liver": SOLID
    | {
        "material.density": (BORNE, LATE_MENDED),
        "material.young_modulus": (LATE_MENDED, BORNE),
        "hand.rate": (RATE, BORNE),
    },
}
"""Organ -> constant -> verdicts of 1000 times as much and of a thousandth, where they are not borne
both: the problem and where it is said to be, and "mended" where its fix bears presses."""


def name_verdict(organ: Organ, key: str, factor: float) -> str:
    """What becomes of a constant that is so many times what it was."""
    part, field = key.split(".")
    try:
        wrong = SetConstant(part, field, factor * getattr(getattr(organ, part), field))(organ)
    except EditError:
        return REFUSED
    errors = [p for p in assess(wrong).problems if p.severity == "error"]
    if not errors:
        return BORNE if bears_presses(wrong, SECONDS) else ENDED
    told = find_told(errors, key)
    mended = told.fix is not None and bears_presses(told.fix(wrong), SECONDS)
    return f"{told.key} at {told.where}" + (", mended" if mended else "")


def find_told(errors: list[Problem], key: str) -> Problem:
    """The one that names a constant, or the first."""
    return next((p for p in errors if p.where == key), errors[0])


def list_constants(organ: Organ) -> list[str]:
    """Those that count for an organ, and have a number that is not 0 and no count."""
    return [
        each.key
        for each in CONSTANTS
        if each.part != "fill" and not each.whole and each.counts(organ.model)
        if getattr(getattr(organ, each.part), each.field)
    ]


@pytest.mark.parametrize(
    "name",
    [
        pytest.param("kidney_stone", marks=pytest.mark.landing),
        pytest.param("simple_tissue", marks=pytest.mark.verify),
        *(pytest.param(name, marks=pytest.mark.verify) for name in list(WRONG)[2:]),
    ],
)
def test_a_constant_that_is_wrong_by_a_thousand_is_borne_or_told(name):
    organ = open_organ(PUBLISHED / f"{name}.palpate")

    found = {
        key: tuple(name_verdict(organ, key, factor) for factor in (1e3, 1e-3))
        for key in list_constants(organ)
    }

    assert {key: each for key, each in found.items() if each != (BORNE, BORNE)} == WRONG[name]


@pytest.mark.landing
def test_a_wall_that_is_too_thin_or_too_light_is_told_with_what_would_do():
    organ = open_organ(PUBLISHED / "gallbladder.palpate")

    for key in ("material.density", "material.wall_thickness"):
        assert name_verdict(organ, key, 1e-3) == f"hard_constant at {key}, mended"


@pytest.mark.landing
def test_a_rate_so_low_that_no_tick_can_be_built_is_what_is_told():
    organ = open_organ(PUBLISHED / "gallbladder.palpate")

    problems = assess(SetConstant("hand", "rate", 1.0)(organ)).problems

    assert name_verdict(organ, "hand.rate", 1e-3) == LOW_RATE
    assert [p.key for p in problems if p.severity == "error"] == ["low_rate"]


@pytest.mark.landing
@pytest.mark.parametrize(("field", "factor"), [("density", 1e-3), ("young_modulus", 1e3)])
def test_a_late_tick_of_a_wrong_constant_is_mended_by_its_fix(field, factor):
    organ = open_organ(PUBLISHED / "liver.palpate")

    assert name_verdict(organ, f"material.{field}", factor) == LATE_MENDED


OTHERS = ("spleen", "stomach", "collecting_system", "kidney", "liver")


@pytest.mark.landing
@pytest.mark.parametrize("name", OTHERS)
def test_damping_a_thousand_times_too_large_is_told_with_what_would_do(name):
    organ = open_organ(PUBLISHED / f"{name}.palpate")

    key = "material.damping_ratio"
    assert name_verdict(organ, key, 1e3) == f"hard_constant at {key}, mended"


@pytest.mark.verify
@pytest.mark.parametrize("name", OTHERS)
def test_what_was_mended_of_a_shipped_organ_runs_for_a_minute(name):
    organ = open_organ(PUBLISHED / f"{name}.palpate")
    value = 1e3 * organ.material.damping_ratio
    wrong = SetConstant("material", "damping_ratio", value)(organ)

    told = find_told(
        [p for p in assess(wrong).problems if p.severity == "error"], "material.damping_ratio"
    )

    assert bears_presses(told.fix(wrong), 60.0)


@pytest.mark.landing
def test_a_hand_that_may_push_with_next_to_nothing_ends_no_run():
    organ = open_organ(PUBLISHED / "simple_tissue.palpate")

    assert name_verdict(organ, "hand.force_max", 1e-3) == BORNE


@pytest.mark.landing
@pytest.mark.parametrize("name", ["kidney", "gallbladder"])
def test_a_hand_that_is_a_thousand_times_too_stiff_ends_no_run(name):
    organ = open_organ(PUBLISHED / f"{name}.palpate")

    assert name_verdict(organ, "hand.coupling", 1e3) == BORNE
