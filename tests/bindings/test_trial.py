# SPDX-License-Identifier: BSD-3-Clause
"""A trial press: what home springs carry of it, by hand; where it presses; what it counts."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.runs.press import find_top
from palpate.runs.trial import choose_places, find_giving, press_places
from surfaces import MEMBRANE, sheet

HOME = 3e5
"""[N/m³]"""


def foundation(share: float, fixed: tuple[int, ...] = (), pressure: float = 0.0) -> palpate.Scene:
    """A sheet, each vertex of which stands on a home spring and on a spring to a fixed particle
    below it, so that the home spring carries `share` of any push along z."""
    options = palpate.SurfaceOptions()
    options.home_stiffness = HOME
    plain = palpate.build_mass_spring(sheet(9, 0.04), MEMBRANE, 20.0, options)
    vertices, home, springs = np.asarray(plain.rest_position), np.asarray(plain.home), plain.springs
    n, one = len(vertices), np.ones(len(vertices))
    ground = n + np.arange(n)
    tissue = palpate.TissueModel(
        rest_position=np.vstack([vertices, vertices - [0.0, 0.0, 0.02]]),
        mass=np.concatenate([plain.mass, 1e-3 * one]),
        fixed=np.concatenate([np.asarray(fixed, dtype=int), ground]),
        home=np.concatenate([home, 0.0 * one]),
        springs=palpate.Links(
            ends=np.vstack([springs.ends, np.column_stack([ground - n, ground])]),
            rest_length=np.concatenate([springs.rest_length, 0.02 * one]),
            stiffness=np.concatenate([springs.stiffness, home * (1.0 - share) / share]),
            damping=np.concatenate([springs.damping, 0.01 * one]),
        ),
        pressure=pressure,
        triangles=plain.triangles,
        drag=plain.drag,
    )
    return palpate.build_scene(palpate.make_scene(tissue))


@pytest.mark.parametrize("share", [0.2, 1.0 / 3.0, 0.8])
def test_home_springs_carry_what_their_stiffness_is_of_all_that_holds_a_vertex(share):
    """k_home of k_home + k at every vertex is k_home of k_home + k of their sum, by hand."""
    scene = foundation(share)

    [trial] = press_places(scene, [find_top(scene)])

    assert trial.force > 0.05 and not trial.stopped
    # springs to the ground lean by the dent's slope, and the plate still moves a little
    assert trial.home_share == pytest.approx(share, rel=0.03)


def test_where_nothing_else_holds_a_tissue_home_springs_carry_it_all():
    options = palpate.SurfaceOptions()
    options.home_stiffness = HOME
    tissue = palpate.build_mass_spring(sheet(9, 0.04), MEMBRANE, 20.0, options)
    scene = palpate.build_scene(palpate.make_scene(tissue))

    trials = press_places(scene, choose_places(scene))

    assert len(trials) == 5
    for trial in trials:
        assert trial.home_share == pytest.approx(1.0, abs=0.03)


def test_what_a_pressure_moves_by_itself_is_no_share_of_the_press():
    """2 kPa move a vertex on its home spring by 7 mm, and the press by 3."""
    still, blown = (foundation(0.5, pressure=p) for p in (0.0, 500.0))

    one, other = (press_places(s, [find_top(s)])[0].home_share for s in (still, blown))

    assert other == pytest.approx(one, abs=0.05)


def test_gravity_does_not_change_what_home_springs_carry():
    scene = foundation(0.5)
    heavy = palpate.make_scene(scene.bodies[0].tissue)
    heavy.gravity = [0.0, 0.0, -98.1]
    heavy = palpate.build_scene(heavy)

    one, other = (press_places(s, [find_top(s)])[0] for s in (scene, heavy))

    assert (one.home_share, one.force) == (other.home_share, other.force)
    assert list(heavy.gravity) == [0.0, 0.0, -98.1]


def test_a_tissue_without_home_springs_has_no_share_but_a_force_and_its_substeps():
    options = palpate.SurfaceOptions()
    options.home_stiffness, options.fixed = 0.0, [0, 8, 72, 80]
    tissue = palpate.build_mass_spring(sheet(9, 0.04), MEMBRANE, 20.0, options)
    scene = palpate.build_scene(palpate.make_scene(tissue))

    [trial] = press_places(scene, [find_top(scene)], hold=0.0)

    assert trial.home_share is None
    assert trial.force > 0.0 and trial.substeps >= 3 > scene.bodies[0].substeps


def test_places_give_way_and_are_apart_and_the_same_each_time():
    held = tuple(range(40))
    scene = foundation(0.5, held)

    places = choose_places(scene)

    points = np.array([place.point for place in places])
    x = np.asarray(scene.bodies[0].tissue.rest_position)
    nearest = np.linalg.norm(x[:81, None] - points[None], axis=2).argmin(axis=0)
    assert not set(nearest.tolist()) & set(held)
    apart = np.linalg.norm(points[:, None] - points[None], axis=2)
    assert apart[np.triu_indices(len(points), 1)].min() > 2.0 * scene.instruments[0].tool.radius
    again = choose_places(scene)
    assert all(np.array_equal(a.point, b.point) for a, b in zip(places, again, strict=True))


def test_what_is_held_everywhere_is_pressed_at_its_top():
    scene = foundation(0.5, tuple(range(81)))

    assert not find_giving(scene.bodies[0].tissue)[:81].any()
    assert len(choose_places(scene)) == 1
