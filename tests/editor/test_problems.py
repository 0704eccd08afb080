# SPDX-License-Identifier: GPL-3.0-or-later
"""Every problem is found at its stage, and every fix that is offered repairs it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from organs import (
    FILLING,
    fin,
    make_organ,
    moebius,
    nested,
    open_surface,
    surface_of,
    two_shells,
    untitled,
)
from palpate.scene.scene_parts import FillPart
from palpate_editor import check
from palpate_editor.check import Assessment, assess
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_editor.document.constants import CONSTANTS
from palpate_editor.document.cost_rules import TICK_SHARE, compute_tick_share
from palpate_editor.document.problems import SEVERITIES, Problem
from palpate_editor.edits import SetConstant
from palpate_editor.views.stages.panels import list_stages
from tiers import keep_everyday

STAGES = list_stages()
CONFIRMED = replace(make_organ().source, unit_guessed=False, up_guessed=False)
SOUND = replace(make_organ(), source=CONFIRMED, filling=None)
WALL = replace(
    SOUND,
    material=replace(SOUND.material, wall_thickness=2e-3),
    model=replace(SOUND.model, kind="shell", home_stiffness=None),
)
"""Which no home springs carry, and no tetrahedra."""


def on(surface: Surface, organ: Organ = SOUND) -> Organ:
    return replace(organ.with_surface(surface), imported=surface, decimation=None)


def with_part(part: str, **values) -> Organ:
    return replace(SOUND, **{part: replace(getattr(SOUND, part), **values)})


def crossed() -> Surface:
    """Two shells, one stuck into the other."""
    one, other = surface_of(60), surface_of(50)
    moved = other.vertices + [0.6 * np.ptp(one.vertices[:, 0]), 1e-4, 2e-4]
    return Surface(
        np.concatenate((one.vertices, moved)), np.concatenate((one.triangles, other.triangles + 60))
    )


def pricked() -> Surface:
    """One vertex reaches out through the other side."""
    surface = surface_of(1500)
    x = surface.vertices.copy()
    middle = x.mean(axis=0)
    x[0] = middle - 1.2 * (x[0] - middle)
    return Surface(x, surface.triangles)


def grid(n: int) -> Surface:
    """A sheet of n x n vertices, 1 mm apart."""
    x, y = np.meshgrid(1e-3 * np.arange(n), 1e-3 * np.arange(n))
    first = (n * np.arange(n - 1)[:, None] + np.arange(n - 1)).ravel()
    triangles = [(first, first + 1, first + n + 1), (first, first + n + 1, first + n)]
    return Surface(
        np.column_stack((x.ravel(), y.ravel(), np.zeros(n * n))),
        np.concatenate([np.column_stack(corners) for corners in triangles]),
    )


def needles() -> Surface:
    surface = surface_of(60)
    return Surface(surface.vertices * [1.0, 1.0, 0.02], surface.triangles)


def flat() -> Surface:
    surface = surface_of(60)
    return Surface(surface.vertices * [1.0, 1.0, 0.1], surface.triangles)


def indefinite(coupling: float) -> Organ:
    return with_part("model", kind="molecular", bend_stiffness=1e-3, stretch_coupling=coupling)


SLOW = on(surface_of(2000), replace(WALL, material=replace(WALL.material, young_modulus=5e4)))
WRONG = {
    # key: (organ, stage, severity, part of what is said)
    "no_surface": (EMPTY, "import", "error", "no surface"),
    "size": (on(Surface(1000 * surface_of().vertices, surface_of().triangles)), "import", "error",
             "from corner to corner"),
    "unit_guessed": (make_organ(), "import", "warning", "mm, guessed (120 units"),
    "up_guessed": (make_organ(), "import", "note", "z, guessed"),
    "inward": (on(Surface(surface_of().vertices, surface_of().triangles[:, ::-1])), "repair",
               "error", "face inwards"),
    "inner": (on(nested()), "repair", "warning", "1 pieces inside others"),
    "shells": (on(two_shells()), "repair", "warning", "2 pieces"),
    "non_manifold": (on(fin()), "repair", "error", "1 edges with more than two triangles"),
    "one_sided": (on(moebius()), "repair", "error", "one side only"),
    "crossing": (on(crossed()), "repair", "error", "triangles that cross others, as of parts"),
    "unsound": (on(fin()), "material", "error", "no tissue can be built on yet"),
    "holes": (on(open_surface()), "repair", "note", "a hole of "),
    "self_intersections": (on(pricked()), "repair", "warning", "triangles that cross others"),
    "thin": (on(flat()), "decimate", "note", "parts thinner than half of their triangles' edges"),
    "angles": (on(needles()), "decimate", "warning", "a smallest angle of"),
    "too_slow": (SLOW, "decimate", "warning", "2000 vertices"),
    "own_filling": (
        replace(with_part("model", kind="solid"), filling=FILLING),
        "material", "note", "2 tetrahedra of the file",
    ),
    "too_many": (on(grid(142)), "decimate", "error", "20164 vertices"),
    "constant": (with_part("material", density=-1.0), "material", "error", "-1 kg/m³"),
    "choice": (with_part("model", kind="jelly"), "material", "error", "jelly"),
    "open_solid": (on(open_surface()), "material", "error", "a solid with holes"),
    "indefinite": (indefinite(1e4), "material", "error", "K_btheta 10000 N"),
    "tissue": (with_part("hand", gravity=(0.0, 9.81)), "material", "error", "2 numbers"),
    "all_fixed": (replace(SOUND, fixed=np.ones(60, bool)), "material", "error", "every vertex"),
    "loose": (replace(with_part("model", home_stiffness=None), fixed=np.zeros(60, bool)),
              "material", "warning", "neither home springs nor fixed"),
    "reach": (replace(with_part("model", kind="linear_solid"), fill=FillPart(reach="apex")),
              "material", "error", "'apex'"),
    "slow_solid": (replace(with_part("model", kind="solid"), fill=FillPart(9000)), "material",
                   "warning", "steps a tick in touch"),
    "late_tick": (SLOW, "publish", "error", "steps a tick in touch: about 169% of the time"),
    "needless_exchange": (with_part("hand", exchange_rate=100.0), "material", "warning",
                          "felt by its local stiffness, told 100 times a second"),
    "late_exchange": (replace(SLOW, hand=replace(WALL.hand, exchange_rate=100.0)),
                      "material", "warning", "it would be late"),
    "coarse_contact": (replace(with_part("model", kind="solid", contact_law="hard"),
                               fill=FillPart(300)), "material",
                       "warning", "under a contact radius of 6.0 mm (a tip of 12 mm pressed 3 mm)"),
    "filling": (replace(with_part("model", kind="solid"),
                        fill=FillPart(6000, sizing="estimated")), "material", "note",
                "than the 6000 that were asked for"),
    "locking": (replace(with_part("model", kind="solid"), fill=FillPart(300, 0.2),
                        material=replace(SOUND.material, poisson_ratio=0.49)), "material",
                "warning", "0.2 with a Poisson's ratio of 0.49"),
    "home_share": (SOUND, "material", "warning", "of the felt force through home springs"),
    "no_home": (with_part("model", home_stiffness=0.0), "material", "warning", "of 0 N/m in all"),
    "gravity": (with_part("hand", gravity=(0.0, 588.6, -784.8)), "material", "warning",
                "981 m/s², 100 times that of the Earth: "),
    "springs_poisson": (replace(WALL, model=replace(WALL.model, kind="mass_spring",
                                                    constants="tissue")),
                        "material", "warning", "0.45, but springs stretch like 0.3"),
    "low_rate": (replace(with_part("model", stiffness=500.0), hand=replace(SOUND.hand, rate=1.0)),
                 "material", "error", "1 Hz, of which a tick has "),
    "hard_constant": (with_part("model", stiffness=5e8), "material", "error",
                      "us at most: about"),
    "blown": (with_part("tool", stiffness=3e11), "material", "error",
              "a light touch ends the run"),
    "small_tip": (with_part("tool", radius=1e-3), "material", "warning", "1.0 mm"),
    "untested": (SOUND, "test", "note", "never felt"),
    "no_title": (untitled(SOUND), "publish", "error", "no title"),
    "no_task": (untitled(SOUND), "publish", "note", "no task"),
}  # fmt: skip


def test_stone_and_bone_may_be_held_everywhere():
    stone = with_part("material", young_modulus=2e10)

    assert "all_fixed" not in keys(assess(replace(stone, fixed=np.ones(60, bool)), tested=True))


def keys(assessment: Assessment) -> set[str]:
    return {problem.key for problem in assessment.problems}


def test_a_sound_organ_that_was_felt_has_no_problems():
    found = assess(WALL, tested=True)

    assert found.problems == () and found.errors == ()
    assert found.scene is not None and found.facts.tissue.margin >= 1.0
    assert found.report.vertices == 60


@cache
def find_problem(key: str) -> Problem:
    """The one of that key in its organ, which is assessed once."""
    [problem] = [p for p in assess(WRONG[key][0], tested=False).problems if p.key == key]
    return problem


COSTLY = ("slow_solid", "low_rate", "hard_constant", "too_slow", "late_exchange")
QUICK = set(WRONG) - set(COSTLY)


@pytest.mark.parametrize("key", keep_everyday(WRONG, QUICK))
def test_a_problem_is_found_at_its_stage(key):
    _, stage, severity, words = WRONG[key]

    problem = find_problem(key)

    assert (problem.stage, problem.severity) == (stage, severity)
    assert words in problem.got
    assert problem.expected and problem.where
    for said in (problem.got, problem.expected):
        assert said.template.format(**said.values) == said


@pytest.mark.parametrize("key", WRONG)
def test_a_problem_is_not_found_where_it_is_not(key):
    organ = WALL if key != "self_intersections" else on(surface_of(60))

    assert key not in keys(assess(organ, tested=True))


FIXABLE = {
    "size", "too_many",
    "unit_guessed", "up_guessed", "inward", "inner", "shells", "non_manifold", "one_sided",
    "crossing", "self_intersections",
    "constant", "choice", "open_solid",
    "indefinite", "loose", "reach", "small_tip", "no_title", "gravity", "springs_poisson",
    "locking", "coarse_contact", "hard_constant", "blown",
    "low_rate",
}  # fmt: skip


@pytest.mark.parametrize("key", keep_everyday(WRONG, QUICK))
def test_a_fix_that_is_offered_mends_the_problem(key):
    organ, problem = WRONG[key][0], find_problem(key)

    assert (problem.fix is not None) == (key in FIXABLE)
    if problem.fix is not None:
        assert key not in keys(assess(problem.fix(organ), tested=False))
        assert problem.fix.title


def test_every_constant_beyond_its_range_is_found_by_its_name():
    for constant in CONSTANTS:
        organ = with_part(constant.part, **{constant.field: float("nan")})
        problems = [p for p in assess(organ).problems if p.key == "constant"]
        assert [p.where for p in problems] == [constant.key]


@pytest.mark.parametrize("coupling", [1e4, -1e4])
def test_an_indefinite_triangle_is_named_with_what_it_could_take(coupling):
    organ = indefinite(coupling)

    found = assess(organ)

    [problem] = found.errors
    low, high = found.facts.tissue.coupling_range
    assert "triangle" in problem.where and "indefinite" in problem.got
    assert low < problem.fix.value < high
    # the words of the library and the numbers found here are of the same range
    assert problem.expected.startswith(f"{low:.3g}"[:4])


def test_a_size_that_only_one_unit_explains_can_be_fixed_with_that_unit():
    organ = on(Surface(100 * surface_of().vertices, surface_of().triangles))
    organ = replace(organ, source=replace(CONFIRMED, unit="m"))

    [problem] = [p for p in assess(organ).problems if p.key == "size"]

    assert problem.fix is None or "size" not in keys(assess(problem.fix(organ)))


def test_stages_and_severities_are_those_that_were_agreed():
    used = {(stage, severity) for _, stage, severity, _ in WRONG.values()}

    assert {stage for stage, _ in used} == set(STAGES.names) - {"scenario"}  # judged on its own
    assert {severity for _, severity in used} == set(SEVERITIES)


def test_problems_come_in_the_order_of_the_stages():
    organ = replace(untitled(on(two_shells(), make_organ())), tool=replace(SOUND.tool, radius=0.0))

    order = [STAGES.place(problem.stage) for problem in assess(organ, tested=False).problems]

    assert order == sorted(order) and len(set(order)) >= 5


def test_a_weight_is_told_with_what_it_pulls_with_and_its_fix_keeps_its_direction():
    organ = WRONG["gravity"][0]

    [problem] = [p for p in assess(organ).problems if p.key == "gravity"]

    mass = assess(organ).facts.tissue.total_mass
    assert f"{1e3 * mass:.4g} g of tissue weigh {981.0 * mass:.3g} N" in problem.got
    assert problem.fix(organ).hand.gravity == pytest.approx((0.0, 5.886, -7.848))


def test_weight_as_on_earth_in_any_direction_is_no_problem():
    for gravity in ((0.0, 0.0, 0.0), (0.0, 0.0, -9.81), (9.8, 0.0, 1.0)):
        assert "gravity" not in keys(assess(with_part("hand", gravity=gravity)))


@pytest.mark.landing
def test_a_tissue_too_slow_for_any_machine_is_an_error_and_one_for_this_a_warning():
    organs = [on(surface_of(600), with_part("model", stiffness=k)) for k in (1e2, 1e6, 2e7)]

    found = [[p.severity for p in assess(o).problems if p.key == "hard_constant"] for o in organs]

    assert found == [[], ["warning"], ["error"]]


@pytest.mark.landing
def test_what_is_asked_for_instead_gives_as_many_tetrahedra_as_were_wanted():
    organ = replace(with_part("model", kind="solid"), fill=FillPart(6000, sizing="estimated"))
    [problem] = [p for p in assess(organ).problems if p.key == "filling"]
    assert problem.expected.values["asked"] == 6000

    asked = SetConstant("fill", "tetrahedra", 6000)(organ)

    assert not [p for p in assess(asked).problems if p.key == "filling"]
    assert assess(asked).facts.tissue.tetrahedra == pytest.approx(6000, rel=0.1)


def test_a_tick_is_judged_by_its_substeps_in_touch():
    organ = replace(with_part("model", kind="solid"), fill=FillPart(1200))

    facts = assess(organ).facts

    air, touch = facts.tissue.substeps, facts.tissue.trial.substeps
    assert touch > air
    assert compute_tick_share(organ, facts) == pytest.approx(
        18e-9 * facts.tissue.tetrahedra * touch * organ.hand.rate
    )


def test_a_linear_solid_has_its_cost_in_touch():
    organ = replace(with_part("model", kind="linear_solid"), fill=FillPart(600))

    found = assess(organ)

    assert found.facts.tissue.trial.substeps >= 3
    assert 0.0 < compute_tick_share(organ, found.facts) < 1.0
    hilum = replace(organ, fill=FillPart(600, reach=""))
    assert assess(hilum).facts.tissue.trial.substeps >= 3


def test_the_share_of_a_tick_grows_with_the_vertices():
    small, large = assess(on(surface_of(60))), assess(on(surface_of(600)))

    assert compute_tick_share(small.organ, small.facts) < TICK_SHARE
    substeps = [found.facts.tissue.trial.substeps for found in (small, large)]
    assert compute_tick_share(large.organ, large.facts) == pytest.approx(
        10 * substeps[1] / substeps[0] * compute_tick_share(small.organ, small.facts)
    )
    assert compute_tick_share(EMPTY, assess(EMPTY).facts) is None


def test_what_did_not_change_is_not_built_or_measured_again(monkeypatch):
    before = assess(SOUND)
    monkeypatch.setattr(check, "compile_organ", None)  # building would fail
    monkeypatch.setattr(check.authoring, "inspect_mesh", None)

    after = assess(untitled(SOUND), before=before)

    assert after.scene is before.scene and after.report is before.report
    assert "no_title" in keys(after)


def test_what_did_change_is_built_again():
    before = assess(SOUND)

    after = assess(with_part("model", stiffness=500.0), before=before)

    assert after.scene is not before.scene
    assert after.facts.tissue.stable_step < before.facts.tissue.stable_step


def test_an_organ_that_a_press_goes_through_is_not_pressed():
    """One in centimetres whose unit was metres: 1.2 mm large, beside a press of 3 mm."""
    small = Surface(0.01 * SOUND.surface.vertices, SOUND.surface.triangles)

    pressed, not_pressed = (assess(o).facts.tissue for o in (SOUND, on(small)))

    assert all(place.home_share is not None for place in pressed.trial.places)
    assert all(place.home_share is None for place in not_pressed.trial.places)
    assert not_pressed.trial.substeps == not_pressed.substeps
