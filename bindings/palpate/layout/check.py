# SPDX-License-Identifier: BSD-3-Clause
"""All that is wrong with a layout at once, and what it will cost."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

import palpate
from palpate import FileError
from palpate.assessment.check import find_problems
from palpate.assessment.check_problem import ERROR, NOTE, WARNING, Problem
from palpate.files.refusal import Refusal
from palpate.layout.assemble import Assembly, build, read_assembly, separate_bodies
from palpate.layout.costs import PairCosts, press_pair
from palpate.layout.document import Layout, PlacedBody
from palpate.layout.gaps import find_least
from palpate.layout.hard_checks import find_unsettled, name_numbers, note_hard_parts
from palpate.layout.hard_parts import read_part_mesh
from palpate.layout.pair_advice import PairAdvice, advise_pair, advise_slow_pair
from palpate.layout.placed import read_placed
from palpate.layout.publish import make_scenario, name_scene
from palpate.layout.separate import MOST_SHIFT, Separation
from palpate.runs.alarms import tell_alarm
from palpate.runs.costs import hold_costs
from palpate.scene.tick_cost import TICK_SHARE


@dataclass(frozen=True)
class Checked:
    """A layout that was looked through."""

    problems: list[Problem]
    scene: palpate.Scene | None
    """None where there is an error."""
    assembly: Assembly | None
    costs: dict[int, PairCosts]
    """By the number of the pair."""
    separations: list[tuple[Problem, Separation]] = field(default_factory=list)
    """What had to be done to bodies, with the problem that tells it."""
    press: palpate.SceneCosts | None = None
    """Of a held press of the first body, where no pair was pressed beside stones or scenery."""

    @property
    def has_errors(self) -> bool:
        return any(problem.severity == ERROR for problem in self.problems)


def check(path: Path, layout: Layout, measures: bool = True) -> Checked:
    """Reads every organ, moves apart what overlaps, builds, and presses each pair.

    Args:
        path: Of the layout; the files of its bodies are named from there.
        layout: What is checked.
        measures: Whether pairs are pressed, half a second each or more.
    """
    problems = find_file_problems(path, layout)
    if problems:
        return Checked(problems, None, None, {})
    try:
        assembly = read_assembly(path, layout)
    except ValueError as problem:
        return Checked([Problem(ERROR, "pairs", str(problem))], None, None, {})
    problems = [*note_title(layout), *find_disagreements(assembly), *find_unpaired(assembly)]
    problems += note_sleep(assembly)
    problems += note_hard_parts(layout, assembly)
    parted = [(describe_separation(layout, each), each) for each in separate_bodies(assembly)]
    problems += [problem for problem, _ in parted]
    checked = Checked(problems, None, assembly, {}, parted)
    if checked.has_errors:
        return checked
    try:
        scene = build(assembly)
    except ValueError as problem:
        said = name_numbers(layout, str(problem).removeprefix("scene: "))
        return Checked([*problems, Problem(ERROR, "scene", said)], None, assembly, {}, parted)
    problems += find_task_problems(layout, assembly, scene)
    if measures and (scene.rigid or layout.gravity):
        problems += find_unsettled(layout, scene, assembly)
    costs = measure_pairs(scene, assembly) if measures else {}
    if measures:
        problems += find_cost_problems(layout, scene, costs, assembly)
    alone = measures and not costs and (scene.rigid or scene.scenery)
    press = hold_costs(scene) if alone else None
    return Checked(problems, scene, assembly, costs, parted, press)


def find_task_problems(layout: Layout, assembly: Assembly, scene: palpate.Scene) -> list[Problem]:
    """Of its judged task, in 20 attempts of each level."""
    try:
        made = make_scenario(layout, assembly, scene)
    except Refusal as refusal:
        said = f"got {refusal.got}, expected {refusal.expected}"
        return [Problem(ERROR, f"task: {refusal.where}", said)]
    if not made.assessment:
        return []
    return [replace(each, where=f"task: {each.where}") for each in find_problems(made)]


def find_file_problems(path: Path, layout: Layout) -> list[Problem]:
    """Of everything whose file cannot be had."""
    if not layout.bodies:
        return [Problem(ERROR, "bodies", "got none, expected one or more: add an organ")]
    problems = []
    for part in layout.parts:
        try:
            if isinstance(part, PlacedBody):
                read_placed(path, part)
            else:
                read_part_mesh(path, part)
        except (Refusal, FileError) as problem:
            problems.append(Problem(ERROR, part.name, str(problem)))
        except OSError as problem:
            said = f"{problem.filename}: {problem.strerror}"
            problems.append(Problem(ERROR, part.name, said))
    return problems


def find_disagreements(assembly: Assembly) -> list[Problem]:
    """Where organs were published for another scene than the first."""
    first, *others = assembly.organs
    problems = []
    for organ, placed in zip(others, assembly.layout.bodies[1:], strict=True):
        for name, unit in (("rate", "Hz"), ("gravity", "m/s²")):
            if name == "gravity" and assembly.layout.gravity:
                continue
            usual = np.asarray(getattr(first.published.scene, name))
            found = np.asarray(getattr(organ.published.scene, name))
            if not np.array_equal(usual, found):
                problems.append(
                    Problem(ERROR, placed.name,
                            f"{name}: got {found} {unit}, expected {usual} {unit}, as the first "
                            "body's organ has it")
                )  # fmt: skip
    return problems


def find_unpaired(assembly: Assembly) -> list[Problem]:
    """Bodies that overlap and will pass through each other."""
    pairs = {frozenset((pair.first, pair.second)) for pair in assembly.pairs}
    problems = []
    for b, moved in enumerate(assembly.surfaces):
        for a, still in enumerate(assembly.surfaces[:b]):
            least = None
            if frozenset((a, b)) not in pairs:
                least = find_least(still, moved, 0.0, np.zeros(3))
            if least is not None and least.size < 0.0:
                names = assembly.layout.bodies[a].name, assembly.layout.bodies[b].name
                problems.append(
                    Problem(WARNING, " and ".join(names),
                            f"overlap by {-1e3 * least.size:.2f} mm and are no pair: they pass "
                            "through each other")
                )  # fmt: skip
    return problems


def note_title(layout: Layout) -> list[Problem]:
    if layout.title:
        return []
    said = (
        f'got none, so a trainee reads "{name_scene(layout)}": `palpate scene set LAYOUT --title '
        '"..."` gives it one'
    )
    return [Problem(NOTE, "title", said)]


def note_sleep(assembly: Assembly) -> list[Problem]:
    """Bodies that would sleep alone and cannot beside others."""
    return [
        Problem(NOTE, placed.name,
                f"its force_error of {organ.body.force_error:g} N is 0 here: a body that others "
                "touch never sleeps")
        for organ, placed, body in zip(
            assembly.organs, assembly.layout.bodies, assembly.bodies, strict=True
        )
        if organ.body.force_error > 0.0 and body.force_error == 0.0
    ]  # fmt: skip


def describe_separation(layout: Layout, found: Separation) -> Problem:
    name, other = layout.bodies[found.body].name, layout.bodies[found.other].name
    begin = (
        f"is {-1e3 * found.gap:.2f} mm inside of {other}"
        if found.gap < 0.0
        else f"is {1e3 * found.gap:.2f} mm from {other}, less than half the thickness"
    )
    if found.shift is None:
        said = (
            f"{begin}, expected no more than what moving it {1e3 * MOST_SHIFT:g} mm parts: "
            "place it elsewhere"
        )
        return Problem(ERROR, name, said)
    way = ", ".join(f"{1e3 * along:.2f}" for along in found.shift)
    far = 1e3 * float(np.linalg.norm(found.shift))
    return Problem(NOTE, name, f"{begin}: moved {far:.2f} mm, by {way} mm")


def measure_pairs(scene: palpate.Scene, assembly: Assembly) -> dict[int, PairCosts]:
    found = {}
    for index in range(len(scene.body_pairs)):
        costs = press_pair(scene, index, assembly.surfaces)
        if costs is not None:
            found[index] = costs
    return found


def find_cost_problems(
    layout: Layout, scene: palpate.Scene, costs: dict[int, PairCosts], assembly: Assembly
) -> list[Problem]:
    problems = []
    longest = TICK_SHARE / scene.rate
    for index, cost in costs.items():
        where = name_pair(layout, scene, index)
        if cost.end or cost.least_gap < 0.0:
            advice = advise_pair(scene, index, assembly)
            problems += describe_failed_press(scene, where, cost, advice)
        elif cost.tick_median > longest:
            quick = advise_slow_pair(scene, index, assembly)
            said = describe_slow_press(1e6 * cost.tick_median, 1e6 * longest, quick)
            problems.append(Problem(WARNING, where, said))
        if not cost.most_touching:
            problems.append(
                Problem(NOTE, where, "did not touch when pressed towards each other: their cost "
                        "is that of bodies apart")
            )  # fmt: skip
    for index, pair in enumerate(scene.body_pairs):
        if index not in costs and pair.first != pair.second:
            where = name_pair(layout, scene, index)
            problems.append(Problem(NOTE, where, "are too far apart to be pressed together"))
    return problems


def describe_failed_press(
    scene: palpate.Scene, where: str, cost: PairCosts, advice: PairAdvice | None
) -> list[Problem]:
    """An alarm, and bodies that went through each other."""
    problems = []
    if cost.end and advice is None:
        told = tell_alarm(cost.end, scene, cost.end_body)
        problems.append(Problem(ERROR, where, f"pressed together: {told}"))
    elif cost.end:
        said = f"pressed together with {advice.now}, and not with {advice.option}: {cost.alarm}"
        problems.append(Problem(ERROR, where, said))
    if cost.least_gap < 0.0:
        deep = f"{-1e3 * cost.least_gap:.2g}"
        said = f"went {deep} mm through each other when pressed"
        if advice is not None:
            said = (
                f"went {deep} mm through each other when pressed with {advice.now}: with "
                f"{advice.option} they do not"
            )
        problems.append(Problem(ERROR, where, said))
    return problems


def describe_slow_press(takes: float, most: float, quick: tuple[PairAdvice, float] | None) -> str:
    """Times in us."""
    if quick is None:
        return (
            f"a tick takes {takes:.0f} us here when they are pressed together, expected at most "
            f"{most:.0f} us"
        )
    advice, substeps = quick
    return (
        f"a tick takes {takes:.0f} us here when they are pressed together, expected at most "
        f"{most:.0f} us: {advice.now} asks for {substeps:.0f} substeps, {advice.option} for "
        f"{advice.pressed.substeps:.0f}"
    )


def name_pair(layout: Layout, scene: palpate.Scene, index: int) -> str:
    pair = scene.body_pairs[index]
    if pair.first == pair.second:
        return f"{layout.bodies[pair.first].name} with itself"
    return f"{layout.bodies[pair.first].name} and {layout.bodies[pair.second].name}"


def describe_pair(
    layout: Layout, scene: palpate.Scene, index: int, checked: Checked
) -> dict[str, Any]:
    """What is known of a pair, for a report."""
    pair, cost = scene.body_pairs[index], checked.costs.get(index)
    told: dict[str, Any] = {
        "pair": name_pair(layout, scene, index),
        "thickness_m": pair.thickness,
        "stiffness_N_per_m3": pair.stiffness,
        "damping": pair.damping,
        "friction": pair.friction,
    }
    if cost is not None:
        told |= {
            "pair_median_us": 1e6 * cost.pair_median,
            "pair_p99_us": 1e6 * cost.pair_p99,
            "tick_median_us": 1e6 * cost.tick_median,
            "tick_p99_us": 1e6 * cost.tick_p99,
            "most_touching": cost.most_touching,
            "least_gap_m": cost.least_gap if np.isfinite(cost.least_gap) else None,
        }
    return told
