# SPDX-License-Identifier: GPL-3.0-or-later
"""The advisor of an organ: the choice of its chart, and its score on presses held out from it.

palpate.study.advice chooses; here rows are compiled for what their steps may be, and the choice
runs where no row of the chart did. Minutes where the truth of those places is not kept yet.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from math import inf
from pathlib import Path

import numpy as np
import palpate
from palpate.files.refusal import Refusal
from palpate.runs.press import Place
from palpate.scene.scene_parts import FILLED
from palpate.study.advice import Advice, Steps, Targets, advise
from palpate.study.held_out import (
    HeldOut,
    PressScore,
    Score,
    choose_places,
    read_held_out,
    write_held_out,
)
from palpate.study.path_cost import measure_path_cost
from palpate.study.scene_chart import Chart, Configuration, Row
from palpate.study.track import (
    compare_with_truth,
    find_largest_force,
    list_samples,
    run_track,
    set_course,
)
from palpate.study.truth import Truth
from palpate.study.truth_file import read_truth
from palpate.system.data_folder import find_cache_folder

from palpate_editor.chart_fit import find_difference, find_wanted
from palpate_editor.compile import compile_organ
from palpate_editor.document import Organ
from palpate_editor.edits import EditError
from palpate_editor.edits.configure import apply_configuration
from palpate_editor.trial import measure_edges
from palpate_editor.truth import Press, Progress, Stopped, TruthError, solve_truth

HELD_OUT = Path(__file__).parent / "held_out.json"
LIMIT_SHARE = 0.9
"""[-] of its estimate of the limit, that palpate.stable_step gives."""

Told = Callable[[str, float], None]
"""A stage and the share of all work that is done, 0 to 1."""
Asked = Callable[[], bool]


class AdviseError(ValueError):
    """Why an organ cannot be advised, in a sentence."""


@dataclass(frozen=True)
class Ground:
    """What is touched at the place of a chart."""

    depth: float
    """[m] The deepest that the truth was solved to, and so that the choice is validated to."""
    thickness: float | None
    """[m] of the body there; None where the truth of the chart is not kept any more."""
    contact_radius: float | None
    """[m] of the truth at that depth; likewise."""
    edge: float
    """[m] mean edge at the surface that is touched, of the choice."""


@dataclass(frozen=True)
class Advised:
    """All that is known of a choice."""

    advice: Advice
    ground: Ground | None
    """None without a choice."""
    score: Score | None
    """Of the choice on the held-out path; None where nobody asked for it, or nothing ran."""
    own_score: Score | None
    """The same of what the organ came with, where that is another."""


def require_chart_of(chart: Chart, organ: Organ) -> None:
    """Raises AdviseError where a chart is of another organ than this."""
    difference = find_difference(chart, organ)
    if difference is not None:
        raise AdviseError(f"chart: {difference}")
    own = next((row for row in chart.rows if row.own and row.counts is not None), None)
    if own is None:
        return
    wanted = find_wanted(own, organ)
    if wanted != own.configuration:
        raise AdviseError(
            f"chart: got one of a surface of {wanted.vertices} vertices, expected "
            f"{organ.vertex_count}"
        )
    if own.configuration.kind in FILLED:
        require_filling_of(chart, own, organ)


def require_filling_of(chart: Chart, own: Row, organ: Organ) -> None:
    """Raises AdviseError where the organ, filled as it was for a chart's own row, is another body:
    constants and tool may be those of the chart all the same."""
    assert own.counts is not None
    found = len(compile_choice(organ, own.configuration).bodies[0].tissue.mass)
    if found != own.counts.particles:
        raise AdviseError(
            f"chart: got one of {chart.organ}, filled with {own.counts.particles} particles, "
            f"expected one of this organ, which has {found} when it is filled like that"
        )


def advise_organ(
    organ: Organ,
    chart: Chart,
    targets: Targets,
    *,
    scored: bool = True,
    told: Told = lambda stage, share: None,
    asked: Asked = lambda: False,
    cache: Path | None = None,
) -> Advised:
    """The choice of a chart, in words' facts and with its score.

    Args:
        organ: That the chart is of.
        chart: At the rate of the targets.
        targets: What is asked for.
        scored: Whether the choice is run on the held-out path.
        told: Of every stage.
        asked: Whether to stop.
        cache: The folder of kept truths; the user's own if None.

    Raises:
        AdviseError: a sentence on what does not fit, or cannot be solved.
        Stopped: once `asked` says so.
    """
    if abs(chart.rate - targets.rate) > 1e-6 * chart.rate:
        raise AdviseError(
            f"rate: got {targets.rate:g} Hz, expected {chart.rate:g} Hz, at which the chart was "
            "drawn: how many substeps a tick has, and what it costs, depends on it"
        )
    require_chart_of(chart, organ)
    told("choosing", 0.0)
    found = advise(chart, targets, lambda row: find_steps(organ, row))
    if found.choice is None:
        return Advised(found, None, None, None)
    truth = find_kept_truth(chart, cache)
    ground = find_ground(organ, found.choice.configuration, chart, truth)
    if not scored:
        return Advised(found, ground, None, None)
    scorer = Scorer(organ, list_others(organ, truth), told, asked, cache)
    score = scorer.score(found.choice.configuration)
    own = None
    if found.own is not None and found.own.row.number != found.choice.row.number:
        own = scorer.score(found.own.row.configuration)
    return Advised(found, ground, score, own)


def find_steps(organ: Organ, row: Row) -> Steps:
    """How a row steps at rest. Raises AdviseError where it can no longer be built."""
    scene = compile_choice(organ, row.configuration)
    body = scene.bodies[0]
    if body.kernel == palpate.Kernel.response or palpate.is_implicit(body.integrator):
        return Steps(body.substeps, inf)
    longest = palpate.stable_step(body.tissue, body.integrator)
    return Steps(body.substeps, longest / LIMIT_SHARE)


def compile_choice(organ: Organ, configuration: Configuration) -> palpate.Scene:
    """Raises AdviseError."""
    try:
        return compile_organ(apply_configuration(organ, configuration))
    except (EditError, ValueError) as problem:
        raise AdviseError(f"chart: a row of it cannot be built any more: {problem}") from None


def find_kept_truth(chart: Chart, cache: Path | None) -> Truth | None:
    """The chart's own truth, where it is still kept."""
    folder = find_cache_folder() / "truths" if cache is None else cache
    try:
        truth = read_truth(folder / f"{chart.truth.key}.truth")
    except (Refusal, OSError):
        return None
    return truth if truth.key == chart.truth.key else None


def find_ground(
    organ: Organ, configuration: Configuration, chart: Chart, truth: Truth | None
) -> Ground:
    scene = compile_choice(organ, configuration)
    place = find_station(organ, truth)
    depth = abs(chart.way.depth)
    if truth is None:
        return Ground(depth, None, None, measure_edge(scene, place))
    return Ground(
        depth,
        float(truth.thickness[0]),
        float(truth.contact_radius[0, -1]),
        measure_edge(scene, place),
    )


def find_station(organ: Organ, truth: Truth | None) -> Place:
    """The first place of a chart; where a truth presses first if it is not kept."""
    if truth is not None:
        return Place(truth.point[0], truth.direction[0])
    # they load the solver's meshing
    from palpate_editor.truth.paths import choose_place
    from palpate_editor.truth.subject import take_subject

    try:
        return choose_place(take_subject(organ), None)
    except TruthError as refused:
        raise AdviseError(str(refused)) from None


def list_others(organ: Organ, truth: Truth | None) -> list[np.ndarray]:
    """[m] (3,) places that the choice was made from."""
    return [find_station(organ, None).point] if truth is None else list(truth.point)


def measure_edge(scene: palpate.Scene, place: Place) -> float:
    """[m] mean edge of what is touched at a place."""
    tissue = scene.bodies[0].tissue
    tetrahedra = np.asarray(palpate.list_tetrahedra(tissue))
    if len(tetrahedra):
        return measure_edges(tissue, tetrahedra, [place])[0]
    x = np.asarray(palpate.compute_surface(tissue, tissue.rest_position))
    corners = x[np.asarray(tissue.triangles)]
    lengths = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean(axis=1)
    near = np.linalg.norm(corners.mean(axis=1) - place.point, axis=1).argsort()[:6]
    return float(lengths[near].mean())


class Scorer:
    """Runs configurations on the held-out presses of one organ."""

    def __init__(
        self,
        organ: Organ,
        others: list[np.ndarray],
        told: Told,
        asked: Asked,
        cache: Path | None,
    ):
        self.organ, self.told, self.asked, self.cache = organ, told, asked, cache
        self.held_out: HeldOut = read_held_out(HELD_OUT)
        assert organ.surface is not None
        x, triangles = organ.surface.vertices, organ.surface.triangles.astype(np.int32)
        self.places = choose_places(
            self.held_out, x, triangles, x[organ.fixed], others, organ.tool.radius
        )
        self.find_truth = lru_cache(maxsize=None)(self.solve)

    def solve(self, number: int) -> Truth:
        """The truth of a held-out place. Raises AdviseError, Stopped."""

        def tell(progress: Progress) -> None:
            share = (number + progress.fraction) / len(self.places)
            self.told(progress.stage, 0.9 * share)

        near = tuple(map(float, self.places[number].point))
        try:
            return solve_truth(
                self.organ, Press(near), progress=tell, cancelled=self.asked, cache=self.cache
            )
        except TruthError as refused:
            raise AdviseError(str(refused)) from None

    def score(self, configuration: Configuration) -> Score:
        """Raises AdviseError, Stopped."""
        scene = compile_choice(self.organ, configuration)
        return Score(tuple(self.press(scene, number) for number in range(len(self.places))))

    def press(self, scene: palpate.Scene, number: int) -> PressScore:
        truth = self.find_truth(number)
        if self.asked():
            raise Stopped
        self.told("pressing", 0.9)
        course = set_course(scene, truth)
        samples = list_samples(write_held_out(course, self.held_out), scene.rate)
        track = run_track(scene, course, samples)
        largest = find_largest_force(truth)
        return PressScore(
            point=tuple(truth.point[0].tolist()),
            thickness=float(truth.thickness[0]),
            depth=float(truth.depth[-1]),
            contact_radius=float(truth.contact_radius[0, -1]),
            force=largest,
            force_error=float(truth.force_error.max()),
            displacement_error=float(truth.displacement_error.max()),
            errors=None if track.alarm else compare_with_truth(track, largest),
            cost=None if track.alarm else measure_path_cost(scene, samples),
            alarm=track.alarm,
        )
