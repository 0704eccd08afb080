# SPDX-License-Identifier: BSD-3-Clause
"""A task is judged from Python as in C++, and what does not fit together is refused."""

from __future__ import annotations

import hashlib

import numpy as np
import palpate
import pytest
from palpate import scenario
from surfaces import organ_scene


def press_task(scene: palpate.Scene, **other: object) -> palpate.Task:
    """A push where a tip comes down on the top of the organ."""
    x = np.asarray(scene.bodies[0].tissue.rest_position)
    top = x[int(x[:, 2].argmax())]
    task = palpate.Task(
        places=[palpate.TaskPlace(points=[top], radius=0.01)],
        steps=[palpate.TaskStep(verb=palpate.TaskVerb.push, place=0, depth=palpate.Band(0.002))],
        time_limit=1.0,
        **other,
    )
    return palpate.build_task(scene, task)


def press(scene: palpate.Scene, task: palpate.Task) -> tuple[palpate.Progress, list[int]]:
    """Down on the top at 20 mm/s, judged."""
    x = np.asarray(scene.bodies[0].tissue.rest_position)
    top = x[int(x[:, 2].argmax())]
    world, progress = palpate.World(scene), palpate.Progress(task)
    kinds: list[int] = []
    for t in range(2000):
        height = scene.instruments[0].tool.radius + 0.01 - 2e-5 * t
        sample = palpate.HapticSample(time=1e-3 * t, position=top + (0, 0, max(height, -0.002)))
        command = palpate.tick(scene, sample, 1e-3, world)
        palpate.judge(task, world, [sample], [command], 1e-3, progress)
        kinds += [int(kind) for kind in progress.events["kind"]]
    return progress, kinds


def test_a_push_is_judged_and_its_events_are_told():
    scene = organ_scene(2)

    progress, kinds = press(scene, press_task(scene))

    state = progress.state
    assert state.outcome is palpate.Outcome.done
    assert kinds == [palpate.TaskEvent.step_begun, palpate.TaskEvent.step_done,
                     palpate.TaskEvent.task_ended]  # fmt: skip
    assert state.steps[0].status is palpate.StepStatus.done
    assert state.ticks == state.steps[0].until_tick + 1
    assert progress.event_count == 0


def test_a_limit_of_force_is_an_error():
    scene = organ_scene(2)
    limit = palpate.TaskLimit(bound=1e-3, then=palpate.LimitConsequence.end)

    progress, kinds = press(scene, press_task(scene, limits=[limit]))

    assert progress.state.outcome is palpate.Outcome.failed
    assert palpate.TaskEvent.limit_opened in kinds
    assert progress.state.limits[0].count == 1


def test_what_does_not_fit_together_is_refused():
    scene, other = organ_scene(2), organ_scene(1)
    task = press_task(scene)
    sample, command = palpate.HapticSample(), palpate.HapticCommand()

    with pytest.raises(ValueError, match="task: got "):
        palpate.judge(task, palpate.World(other), [sample], [command], 1e-3, palpate.Progress(task))
    with pytest.raises(ValueError, match="samples: got 2 entries, expected 1"):
        palpate.judge(
            task, palpate.World(scene), [sample] * 2, [command], 1e-3, palpate.Progress(task)
        )
    longer = palpate.build_task(scene, palpate.Task(
        places=task.places, steps=[*task.steps, *task.steps], time_limit=1.0))  # fmt: skip
    with pytest.raises(ValueError, match="progress: got one of another task"):
        palpate.judge(task, palpate.World(scene), [sample], [command], 1e-3,
                      palpate.Progress(longer))  # fmt: skip
    with pytest.raises(ValueError, match="from build_task"):
        palpate.Progress(palpate.Task())
    device = palpate.ScriptedDevice([palpate.KeyFrame(0.0, (0, 0, 0.05))])
    with pytest.raises(ValueError, match="one of another scene"):
        palpate.Loop(other, device, task=task)
    with pytest.raises(ValueError, match="one of another scene"):
        palpate.replay(other, palpate.Record(), task)


def test_rows_of_a_task_are_copies():
    task = press_task(organ_scene(1))

    task.steps[0].place = 7
    task.places[0].body = 7

    assert task.steps[0].place == 0
    assert task.places[0].body == 0


@pytest.mark.parametrize("seed", [0, 1, 7, 2**63])
@pytest.mark.parametrize("name", ["press", "where"])
def test_a_draw_is_what_python_makes_of_the_same_text(seed, name):
    digest = hashlib.sha256(f"{seed}\nspleen-push\n{name}".encode()).digest()
    expected = (int.from_bytes(digest[:8], "big") >> 11) / 2**53

    assert scenario.draw(seed, "spleen-push", name) == expected
