# SPDX-License-Identifier: BSD-3-Clause
"""The rings that mark where the steps of a task that are to be done now are."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.player import place_marks
from palpate.player.place_marks import MOST, PlaceMarks
from palpate.player.style import ACCENTS
from palpate.player.trainee_window import Phase
from palpate.runs.play import Play, open_play
from palpate.viewport.draped_line import Drape
from palpate.viewport.ring import ACROSS
from short_tasks import MESHES, PATIENCE, click, open_task

WAITING, ACTIVE, DONE = (
    palpate.StepStatus.waiting,
    palpate.StepStatus.active,
    palpate.StepStatus.done,
)


@pytest.fixture(scope="module")
def open_shipped(tmp_path_factory):
    """open_shipped(task, organ) plays a task that ships."""
    folder = tmp_path_factory.mktemp("shipped")

    @cache
    def open_it(task: str, organ: str) -> Play:
        path = MESHES / "scenarios" / f"{task}.json"
        made = with_assessment(path, read_assessment(path), scenario.read(MESHES / organ))
        out = folder / f"{task}.palpate"
        scenario.write(out, made)
        return open_play(out)

    return open_it


@pytest.fixture
def spleen(open_shipped) -> Play:
    return open_shipped("spleen_probe", "published/spleen.palpate")


def rest(play: Play) -> tuple[np.ndarray, ...]:
    return tuple(np.array(surface.vertices) for surface in play.drawn.task.surfaces)


def frame_of(play: Play, *status, positions=None, rigid=(), pinches=(0.0, 0.0)) -> SimpleNamespace:
    steps = [SimpleNamespace(status=each) for each in status]
    return SimpleNamespace(
        task=SimpleNamespace(steps=steps),
        positions=rest(play) if positions is None else positions,
        rigid=rigid,
        instruments=[SimpleNamespace(pinch=pinch) for pinch in pinches],
    )


def seen(view) -> dict[str, np.ndarray]:
    """[m] The middles of the tubes that are in sight, by name."""
    return {
        name: np.array(thing.streams["position"]).reshape(-1, ACROSS, 3).mean(axis=1)
        for name, thing in view.scenery._things.items()
        if thing.visible and name.startswith(("place", "path"))
    }


def test_a_ring_is_on_the_tissue_around_the_place_and_as_large(view, spleen):
    marks, task = PlaceMarks(view, spleen), spleen.drawn.task
    marks.show(frame_of(spleen, ACTIVE, WAITING, WAITING))

    (ring,) = seen(view).values()
    place = task.places[task.steps[0].place]
    assert np.allclose(np.linalg.norm(ring - place.points[0], axis=1), place.radius, atol=1e-3)
    (surface,) = task.surfaces
    tree = palpate.AabbTree(surface.vertices, surface.triangles)
    gaps = [palpate.find_closest_point(tree, surface.vertices, p).distance for p in ring]
    assert max(gaps) < 1e-5


def test_a_ring_goes_where_the_tissue_goes_and_is_laid_only_once(view, spleen, monkeypatch):
    marks = PlaceMarks(view, spleen)
    marks.show(frame_of(spleen, ACTIVE, WAITING, WAITING))
    (before,) = seen(view).values()
    monkeypatch.setattr(place_marks, "build_mark", None)  # nothing is searched in a frame
    (x,) = rest(spleen)
    pushed = x + (0.001, -0.002, 0.003)
    near = np.linalg.norm(x - before.mean(axis=0), axis=1) < 0.02

    marks.show(frame_of(spleen, DONE, ACTIVE, WAITING, positions=(pushed,)))
    (ring,) = seen(view).values()
    assert np.allclose(ring, before + (0.001, -0.002, 0.003), atol=1e-6)

    marks.show(frame_of(spleen, DONE, ACTIVE, WAITING, positions=(np.where(near[:, None], x, 0),)))
    (ring,) = seen(view).values()
    assert np.allclose(ring, before, atol=1e-6)


def test_what_jaws_have_taken_has_no_ring_that_they_would_draw_in(view, open_shipped):
    play = open_shipped("stomach_two_graspers", "published/stomach.palpate")
    marks, status = PlaceMarks(view, play), (ACTIVE, ACTIVE, *[WAITING] * 4)
    marks.show(frame_of(play, *status))
    both = set(seen(view))
    assert len(both) == 2

    marks.show(frame_of(play, *status, pinches=(3.0, 0.0)))
    assert len(seen(view)) == 1
    marks.show(frame_of(play, *status, pinches=(3.0, 2.0)))
    assert not seen(view)
    marks.show(frame_of(play, *status))
    assert set(seen(view)) == both


def test_a_path_that_is_traced_is_drawn_and_goes_with_its_step(view, spleen):
    marks, task = PlaceMarks(view, spleen), spleen.drawn.task
    number = task.steps[2].place
    marks.show(frame_of(spleen, DONE, DONE, ACTIVE))
    found = seen(view)
    assert set(found) == {f"place {number}", f"path {number}"}
    points = np.asarray(task.places[number].points)
    ends = found[f"path {number}"][[0, -1]]
    assert np.allclose(ends, points[[0, -1]], atol=1e-3)

    marks.show(frame_of(spleen, DONE, DONE, DONE))
    assert not seen(view)


def test_each_of_two_open_steps_has_a_ring(view, open_shipped):
    stomach = open_shipped("stomach_two_graspers", "published/stomach.palpate")
    marks, task = PlaceMarks(view, stomach), stomach.drawn.task
    marks.show_first()
    assert set(seen(view)) == {f"place {task.steps[0].place}"}

    marks.show(frame_of(stomach, DONE, DONE, ACTIVE, ACTIVE, WAITING, WAITING))
    found = seen(view)
    assert len(found) == 2
    for step in task.steps[2:4]:
        place = task.places[step.place]
        away = np.linalg.norm(found[f"place {step.place}"] - place.points[0], axis=1)
        assert np.allclose(away, MOST, atol=2e-3)

    marks.show(frame_of(stomach, DONE, DONE, DONE, DONE, ACTIVE, WAITING))
    assert not seen(view)  # letting go has no place


def test_a_region_has_its_ring_inside(view, open_shipped):
    play = open_shipped("spleen_push_and_pull", "published/spleen.palpate")
    PlaceMarks(view, play).show_first()
    (ring,) = seen(view).values()
    task = play.drawn.task
    place, (x,) = task.places[task.steps[0].place], rest(play)
    members = x[np.asarray(place.members, dtype=bool)]
    away = np.linalg.norm(members[None] - ring[:, None], axis=2).min(axis=1)
    assert away.max() < 0.01 and np.ptp(ring, axis=0).max() < 2.1 * MOST


def test_a_stone_is_marked_where_it_is_and_the_tray_when_it_is_carried(view, open_shipped):
    play = open_shipped("kidney_stone_removal", "scenes/kidney_stone_removal.palpate")
    marks, task = PlaceMarks(view, play), play.drawn.task
    stone = SimpleNamespace(position=np.array((0.06, 0.0, 0.01)), orientation=(0.0, 0.0, 0.0, 1.0))
    marks.show(frame_of(play, DONE, DONE, DONE, ACTIVE, WAITING, rigid=(stone,)))
    found, step = seen(view), task.steps[3]
    assert np.allclose(found[f"place {step.place}"].mean(axis=0), stone.position, atol=1e-5)
    tray = task.places[step.space].points[0]
    assert np.allclose(found[f"place {step.space}"].mean(axis=0), tray, atol=1e-5)


def test_what_is_to_be_found_is_not_marked(view, open_shipped):
    liver = open_shipped("liver_hidden_lump", "published/liver.palpate")
    marks = PlaceMarks(view, liver)
    marks.show_first()
    marks.show(frame_of(liver, ACTIVE))
    assert not seen(view)


def test_a_ring_has_the_accent_of_the_theme(view, spleen):
    marks = PlaceMarks(view, spleen)
    marks.show_first()
    (name,) = seen(view)
    for theme, accents in ACCENTS.items():
        marks.use_theme(theme)
        assert view.scenery._things[name].appearance.colour == accents.accent


def test_rings_lie_flat_on_flat_tissue():
    x = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], float)
    ring = Drape(x, [(0, 1, 2), (0, 2, 3)]).lay_ring((0.5, 0.4, 0.1), 0.2)
    points, outward = ring.find_points(x)
    assert np.allclose(np.linalg.norm(points - (0.5, 0.4, 0.0), axis=1), 0.2)
    assert np.allclose(outward[:, :2], 0.0) and (outward[:, 2] > 0.0).all()
    shape = ring.build(x, 0.01)
    assert np.allclose(np.linalg.norm(shape.normals, axis=1), 1.0, atol=1e-6)
    a, b, c = (shape.vertices[shape.triangles[:, k]] for k in range(3))
    out = shape.normals[shape.triangles[:, 0]]
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), out) > 0.0).all()


@pytest.mark.usefixtures("database")
def test_the_wall_of_the_device_s_check_has_no_ring(open_window, short_task):
    window = open_window(open_task(short_task))
    click(window.over.who.practice)
    check = window.attendance.admission.check
    check.start()
    assert check.busy and not seen(window.view)
    check.leave()
    assert len(seen(window.view)) == 1


@pytest.mark.usefixtures("database")
def test_the_theme_and_a_simulated_hand_keep_the_ring(open_window, qtbot, short_task):
    window = open_window(open_task(short_task))
    click(window.over.who.practice)
    window.use_theme("light")
    (name,) = seen(window.view)
    assert window.view.scenery._things[name].appearance.colour == ACCENTS["light"].accent

    ghost = window.attendance.ghost
    ghost.show()
    qtbot.waitUntil(lambda: window.play.state is not None, timeout=PATIENCE)
    assert set(seen(window.view)) == {name}
    ghost.stop()
    assert set(seen(window.view)) == {name}


@pytest.mark.usefixtures("database")
def test_the_window_marks_the_place_from_the_brief_until_the_task_is_done(
    open_window, qtbot, short_task
):
    window = open_window(open_task(short_task))
    click(window.over.who.practice)
    assert len(seen(window.view)) == 1
    click(window.over.start.start)
    assert len(seen(window.view)) == 1
    qtbot.waitUntil(lambda: window.over.force.peak > 0.05, timeout=PATIENCE)
    if window.phase is Phase.running:
        assert len(seen(window.view)) == 1

    qtbot.waitUntil(lambda: window.phase is Phase.over, timeout=PATIENCE)
    assert not seen(window.view)


def test_a_scenario_without_a_task_has_no_ring(open_window, qtbot):
    window = open_window()
    assert not seen(window.view)
    window.restart()
    qtbot.waitUntil(lambda: window.shown.time > 0.05, timeout=PATIENCE)
    assert not seen(window.view)
