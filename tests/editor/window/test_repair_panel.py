# SPDX-License-Identifier: GPL-3.0-or-later
"""The Repair and Decimate stages: what they list, show, fill and judge."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import palpate
import pytest
from hands import child, click, log_of
from palpate_editor.document import Organ, Surface
from palpate_editor.document.cost_rules import TICK_SHARE
from palpate_editor.views.assessment import Assessment
from palpate_editor.views.problem_marks import MARK, find_view
from patience import rest, settle
from tiers import keep_everyday
from touch_context import build_organ

pytestmark = pytest.mark.window


def punch(surface: Surface, count: int, wide: int) -> Surface:
    """Without `count` triangles that do not touch, and without all around `wide` vertices."""
    triangles, used = surface.triangles, np.zeros(len(surface.vertices), bool)
    kept = np.ones(len(triangles), bool)
    for _ in range(wide):
        vertex = int(np.flatnonzero(~used[triangles].any(axis=1) & kept)[0])
        vertex = int(triangles[vertex, 0])
        around = (triangles == vertex).any(axis=1)
        kept &= ~around
        used[triangles[around]] = True
    for row in range(len(triangles)):
        if count and kept[row] and not used[triangles[row]].any():
            kept[row], count = False, count - 1
            used[triangles[row]] = True
            used[triangles[used[triangles].any(axis=1)]] = True
    left, number = np.unique(triangles[kept]), np.full(len(surface.vertices), -1, np.int32)
    number[left] = np.arange(len(left), dtype=np.int32)
    return Surface(surface.vertices[left], number[triangles[kept]])


@cache
def build_holed_organ() -> Organ:
    whole = build_organ(vertices=2400)
    surface = punch(whole.surface, 20, 1)
    return replace(whole.with_surface(surface), imported=surface)


@pytest.fixture
def holed(qtbot, window):
    """A ball with twenty small holes and a wide one, in the Repair stage."""
    window.session.restore(build_holed_organ(), None)
    window.show_stage("repair")
    settle(qtbot, window)
    return window


def rows_of(tree) -> list[str]:
    return [tree.topLevelItem(i).text(0) for i in range(tree.topLevelItemCount())]


def test_many_holes_are_grouped_by_size_the_largest_first(holed):
    panel = holed.stage_dock.panels["repair"]
    sizes = [len(loop) for loop in palpate.find_border_loops(holed.session.organ.surface.triangles)]
    assert len(sizes) == 21 and sorted(sizes)[:20] == [3] * 20

    rows = rows_of(panel.holes.tree)

    assert rows == [f"Hole of {max(sizes)} edges", "20 holes of 3 edges"]
    assert panel.holes.tree.topLevelItem(1).childCount() == 20
    assert panel.facts.texts()["Holes"] == "21, kept open"
    checks = " ".join(row.label.text() for row in panel.rows if not row.isHidden())
    assert f"21 holes of 3 to {max(sizes)} edges" in checks


@pytest.mark.landing
def test_a_click_on_a_hole_shows_it_from_outside(qtbot, holed, checkout):
    view, tree = holed.view, holed.stage_dock.panels["repair"].holes.tree
    x = holed.session.organ.surface.vertices

    tree.topLevelItem(0).setSelected(True)

    loops = palpate.find_border_loops(holed.session.organ.surface.triangles)
    loop = max(loops, key=len)
    middle = x[loop].mean(axis=0)
    assert view.camera.target == pytest.approx(middle)
    assert (view.camera.eye() - middle) @ (middle - x.mean(axis=0)) > 0.0
    rest(qtbot, holed)
    folder = checkout / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    assert holed.grab().save(str(folder / "editor_holes.png"))
    tree.clearSelection()
    holed.show_stage("decimate")
    assert tree.selectedItems() == []


def test_chosen_holes_are_filled_and_undo_opens_them(qtbot, holed):
    panel = holed.stage_dock.panels["repair"]
    before = holed.session.organ
    assert not panel.holes.fill_button.isEnabled()

    panel.holes.tree.topLevelItem(1).setSelected(True)
    click(panel.holes.fill_button)
    settle(qtbot, holed)

    assert [len(loop) for loop in palpate.find_border_loops(holed.session.organ.surface.triangles)]
    assert rows_of(panel.holes.tree)[0].startswith("Hole of") and panel.holes.isVisible()
    assert len(rows_of(panel.holes.tree)) == 1
    holed.session.history.undo()
    assert holed.session.organ is before


@pytest.mark.landing
def test_all_holes_are_filled_by_one_button_with_its_command(qtbot, holed):
    panel = holed.stage_dock.panels["repair"]

    click(child(holed, "fill_holes"))
    settle(qtbot, holed)

    assert palpate.is_closed(holed.session.organ.surface.triangles)
    assert panel.facts.texts()["Holes"] == "none, it is closed"
    assert not panel.holes.isVisible()
    assert "palpate repair ball.organ --fill-holes -o ball.organ" in log_of(holed)


def test_what_cannot_be_told_is_neither_good_nor_bad_and_says_why(qtbot, holed):
    panel = holed.stage_dock.panels["repair"]
    words = panel.facts.texts()["Triangles face"]
    assert words == "cannot be told: an open surface has no inside"
    value = next(v for n, v in panel.facts.rows if n.text() == "Triangles face")
    assert not value.property("tone")

    holed.session.restore(build_organ(), None)
    settle(qtbot, holed)
    assert panel.facts.texts()["Triangles face"] == "outwards"
    assert value.property("tone") == "good"


@pytest.mark.parametrize("share", keep_everyday([TICK_SHARE, 0.5 * TICK_SHARE, 0.98], [TICK_SHARE]))
def test_a_tick_that_takes_too_long_has_no_tick(qtbot, holed, share):
    """The check said "98 %, at most 70 %" above a green "98 %"."""
    holed.session.restore(build_organ(), None)
    settle(qtbot, holed)
    found = holed.context.assessment
    holed.context.assessor.assessment = Assessment(found.checked, found.comparison, share)

    news = " ".join(holed.stage_dock.panels["decimate"].good_news())

    assert ("of a millisecond" in news) == (share <= TICK_SHARE)


# ---------------------------------------------------------------- what cannot be built on yet


@pytest.fixture
def broken(qtbot, window):
    """A surface with a triangle on one of its edges, in the Repair stage."""
    ball = build_organ(vertices=60)
    x, (i, j, _) = ball.surface.vertices, ball.surface.triangles[0]
    tip = 1.5 * x[[i, j]].mean(axis=0) - 0.5 * x.mean(axis=0)
    surface = Surface(np.vstack([x, tip]), np.vstack([ball.surface.triangles, [i, j, len(x)]]))
    organ = replace(ball.with_surface(surface), imported=surface)
    window.session.restore(organ, None)
    window.show_stage("repair")
    settle(qtbot, window)
    return window


def row_of(window, words: str):
    panel = window.stage_dock.panels["repair"]
    [row] = [r for r in panel.rows if not r.isHidden() and words in r.label.text()]
    return row


def test_triangles_that_nothing_can_be_built_on_are_red_and_only_there(qtbot, broken):
    things = broken.view.scenery._things

    # each of three triangles from both sides
    assert len(things[MARK].triangles) == 6
    for stage, shown in (("material", False), ("import", True)):
        broken.show_stage(stage)
        assert (broken.problem_marks.shown is not None) == shown


def test_show_flies_to_the_place_and_fix_it_mends_it(qtbot, broken):
    row = row_of(broken, "more than two triangles")
    assert row.look.isVisible() and row.button.isVisible()
    middle, _ = find_view(broken.session.organ.surface, row.place.faces)

    click(row.look)
    assert np.allclose(broken.view.camera.target, middle)

    click(row.button)
    settle(qtbot, broken)
    assert broken.problem_marks.shown is None
    assert broken.context.assessment.report.non_manifold_edges == 0
    assert "repair ball.organ --problem non_manifold" in log_of(broken)
    broken.session.history.undo()
    settle(qtbot, broken)
    assert broken.problem_marks.shown is not None


# ---------------------------------------------------------------- steps


def test_repair_all_is_shown_before_it_is_applied_and_is_one_undo(qtbot, broken, checkout):
    panel, before = broken.stage_dock.panels["repair"], broken.session.organ

    click(child(broken, "repair_all"))
    settle(qtbot, broken)

    assert broken.session.organ is before and broken.context.previewing
    assert "Drop fins\n" in panel.card.text.text()
    assert "1 edges with more than two triangles, now 0" in panel.card.text.text()
    assert child(broken, "smooth").height() >= child(broken, "smooth").sizeHint().height()
    assert panel.card.isVisible()
    folder = checkout / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    assert broken.grab().save(str(folder / "editor_repair_all.png"))
    click(child(broken, "apply_step"))
    settle(qtbot, broken)
    assert not broken.context.previewing and not panel.card.isVisible()
    assert broken.context.assessment.report.non_manifold_edges == 0
    assert "palpate repair ball.organ --all -o ball.organ" in log_of(broken)
    broken.session.history.undo()
    assert broken.session.organ is before


def test_a_step_that_is_discarded_leaves_the_organ_and_the_view_as_they_were(qtbot, broken):
    panel, before = broken.stage_dock.panels["repair"], broken.session.organ

    click(child(broken, "drop_fins"))
    settle(qtbot, broken)
    assert broken.context.previewing
    click(child(broken, "discard_step"))

    assert broken.session.organ is before
    assert not broken.context.previewing and not panel.card.isVisible()


def test_a_step_is_cancelled_and_nothing_has_changed(qtbot, broken):
    before = broken.session.organ

    click(child(broken, "wrap"))
    broken.context.jobs.cancel()
    qtbot.waitUntil(lambda: not broken.context.jobs.alive)

    assert broken.session.organ is before and not broken.context.previewing
