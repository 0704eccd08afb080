# SPDX-License-Identifier: BSD-3-Clause
"""Several organs in one scene: where they stand, how they are parted, what is refused."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.files.refusal import Refusal
from palpate.layout import document
from palpate.layout.assemble import build, read_assembly, separate_bodies
from palpate.layout.check import ERROR, NOTE, WARNING, check
from palpate.layout.document import (
    History,
    Layout,
    LayoutError,
    PlacedBody,
    PlacedScenery,
    TouchingPair,
)
from palpate.layout.gaps import find_least
from palpate.layout.layout_file import read_layout, write_layout
from palpate.layout.placed import turn_tensors
from palpate.layout.separate import MOST_SHIFT
from palpate.scene.scene_file import hash_file
from scipy.spatial.transform import Rotation
from surfaces import organ_scene

TAU = 4e-4
RADII = (0.03, 0.025, 0.02)


def write_organ(
    folder: Path, name: str = "organ", appearance: object = None, **changes: object
) -> Path:
    """An ellipsoid of 162 vertices, with a region of its top and one of its foot."""
    scene = organ_scene(2)
    for key, value in changes.items():
        setattr(scene, key, value)
    z = np.asarray(scene.bodies[0].tissue.rest_position)[:, 2]
    regions = {"top": np.flatnonzero(z > 0.012), "foot": np.flatnonzero(z < -0.012)}
    content = {"regions": list(regions), "appearance": appearance}
    made = scenario.Scenario(
        scene=palpate.build_scene(scene),
        title=name,
        authored=json.dumps({"format": "organ", "version": 16, "content": content}),
        authored_arrays={
            f"regions/{i}": rows.astype(np.int32) for i, rows in enumerate(regions.values())
        },
    )
    path = folder / f"{name}.palpate"
    scenario.write(path, made)
    return path


def place(path: Path, name: str, position=(0.0, 0.0, 0.0), rotation=(0.0, 0.0, 0.0)) -> PlacedBody:
    return PlacedBody(name, path.name, hash_file(path), tuple(position), tuple(rotation))


@pytest.fixture
def two(tmp_path) -> tuple[Path, Layout]:
    """Two organs above each other, so that they overlap by 1 mm, and may touch."""
    organ = write_organ(tmp_path)
    height = 2.0 * np.asarray(organ_scene(2).bodies[0].tissue.rest_position)[:, 2].max()
    bodies = (place(organ, "low"), place(organ, "high", (0.0, 0.0, height - 1e-3)))
    return tmp_path / "two.layout.json", Layout(
        title="Two", bodies=bodies, pairs=(TouchingPair("low", "high"),)
    )


# ---------------------------------------------------------------- the document


def test_a_layout_comes_back_with_all_that_can_be_undone(tmp_path, two):
    path, layout = two
    history = History(Layout())
    for step in (replace(layout, pairs=()), layout, replace(layout, title="Zwei Öfen")):
        history = document.apply(history, step)
    history = document.undo(history)
    write_layout(path, history)

    found = read_layout(path)

    assert found == history
    assert (len(found.before), len(found.undone)) == (2, 1)
    assert document.redo(found).now.title == "Zwei Öfen"
    assert document.undo(document.undo(found)).now == Layout()


def test_the_same_again_is_no_step_and_a_new_one_forgets_what_was_undone():
    history = document.apply(History(Layout()), Layout(title="a"))
    assert document.apply(history, Layout(title="a")) is history
    undone = document.undo(history)
    assert document.apply(undone, Layout(title="b")).undone == ()
    for act, given in ((document.undo, undone), (document.redo, history)):
        with pytest.raises(LayoutError, match="got n"):
            act(given)


def test_no_more_steps_are_kept_than_there_is_room_for():
    history = History(Layout())
    for step in range(document.MOST_STEPS + 5):
        history = document.apply(history, Layout(title=str(step)))
    assert len(history.before) == document.MOST_STEPS
    assert history.before[0].title == "4"


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda made: made | {"version": 8}, "version: got 8"),
        (lambda made: made | {"gravity": 1}, "unknown field"),
        (lambda made: made | {"now": 7}, "got 7, expected an object"),
        (lambda made: made["now"]["bodies"][0].pop("sha256") and made, "no sha256"),
        (lambda made: made["now"]["bodies"][0].update(position=[1, 2]) or made, "got 2 numbers"),
        (lambda made: made["now"]["bodies"][1].update(name="low") or made, "a name of its own"),
        (lambda made: made["now"]["pairs"][0].update(first="high") or made, "two of the bodies"),
        (lambda made: made["now"]["pairs"][0].update(thickness="a") or made, "a finite number"),
        (lambda made: made | {"version": 1}, "stones: got some in a layout of version 1"),
        (lambda made: made["now"].pop("stones") and made or made, "no stones"),
    ],
)
def test_a_damaged_layout_is_refused_and_stays_as_it_is(change, said, two):
    path, layout = two
    write_layout(path, History(layout))
    path.write_text(
        json.dumps(change(json.loads(path.read_text(encoding="utf-8")))), encoding="utf-8"
    )
    before = path.read_bytes()

    with pytest.raises(Refusal, match=said):
        read_layout(path)

    assert path.read_bytes() == before


def test_what_a_scenery_stops_rubs_with_that_scenery_alike(two):
    layout = replace(two[1], scenery=(PlacedScenery("table", "table.obj", ""),))
    with pytest.raises(LayoutError, match="table: got a friction of its pair with low"):
        document.set_pair(layout, TouchingPair("low", "table", friction=0.1))


def test_a_body_that_is_removed_takes_its_pairs_with_it(two):
    _, layout = two
    assert document.remove_part(layout, "high").pairs == ()
    assert document.remove_pair(layout, "high", "low").pairs == ()
    for wrong, said in (
        (lambda: document.remove_part(layout, "none"), "expected one of low, high"),
        (lambda: document.add_part(layout, layout.bodies[0]), "a name that is taken"),
        (lambda: document.set_pair(layout, TouchingPair("low", "low")), "--fold"),
        (lambda: document.remove_pair(layout, "low", "other"), "nothing of this name"),
    ):
        with pytest.raises(LayoutError, match=said):
            wrong()


# ---------------------------------------------------------------- what begins overlapped


def test_a_scene_that_began_overlapped_starts_at_rest_without_a_push(two):
    path, layout = two
    assembly = read_assembly(path, layout)
    tau = assembly.pairs[0].thickness

    (found,) = separate_bodies(assembly)
    scene = build(assembly)

    assert found.gap == pytest.approx(-1e-3, abs=2e-5)
    assert np.linalg.norm(found.shift) <= 1e-3 + tau + 1e-5
    least = find_least(*assembly.surfaces, 2e-3, np.zeros(3))
    assert tau - 1e-6 <= least.size <= tau + 1e-5
    world = palpate.World(scene)
    away = palpate.HapticSample(position=(0.0, 0.0, 1.0))
    for _ in range(200):
        palpate.tick(scene, away, 1e-3, world)
    assert not world.alarm
    for state, body in zip(world.bodies, scene.bodies, strict=True):
        assert np.abs(state.tissue.position - body.tissue.rest_position).max() < 1e-7


# ---------------------------------------------------------------- placing


def test_a_turned_organ_is_felt_as_before_seen_from_its_own_side(tmp_path):
    organ = write_organ(tmp_path)
    turn = Rotation.from_rotvec((0.4, -0.9, 0.3))
    shift = np.array((0.05, -0.02, 0.1))
    forces = []
    for placed in (place(organ, "a"), place(organ, "a", shift, turn.as_rotvec())):
        scene = build(read_assembly(tmp_path / "x.json", Layout(bodies=(placed,))))
        world, felt = palpate.World(scene), []
        moves = Rotation.from_rotvec(placed.rotation), np.asarray(placed.position)
        for tick in range(120):
            tip = moves[0].apply((0.001, 0.002, 0.03 - 1e-4 * tick)) + moves[1]
            command = palpate.tick(scene, palpate.HapticSample(position=tip), 1e-3, world)
            felt.append(moves[0].inv().apply(command.force))
        forces.append(np.array(felt))

    assert np.abs(forces[0]).max() > 0.05
    np.testing.assert_allclose(forces[1], forces[0], atol=2e-4)


def test_tensors_turn_as_what_they_are_made_of():
    rng = np.random.default_rng(3)
    vectors, rotation = rng.normal(size=(5, 3)), (0.3, 1.1, -0.7)

    def pack(v: np.ndarray) -> np.ndarray:
        x, y, z = v.T
        return np.stack([x * x, y * y, z * z, x * y, y * z, z * x], axis=1)

    turned = turn_tensors(pack(vectors), PlacedBody("a", "a", "", rotation=rotation))

    np.testing.assert_allclose(turned, pack(Rotation.from_rotvec(rotation).apply(vectors)))


# ---------------------------------------------------------------- what is checked


def find(problems, severity: str) -> str:
    return "\n".join(f"{p.where}: {p.message}" for p in problems if p.severity == severity)


def test_a_check_tells_the_overlap_and_what_the_pair_costs(two):
    path, layout = two
    checked = check(path, layout)

    assert not checked.has_errors
    note = find(checked.problems, NOTE)
    assert "high: is 0.99 mm inside of low: moved 1.50 mm" in note
    cost = checked.costs[0]
    assert cost.most_touching > 0
    assert 0.0 < cost.least_gap < checked.scene.body_pairs[0].thickness
    assert cost.tick_median >= cost.pair_median > 0.0
    assert cost.alarm == ""


def test_all_problems_are_told_at_once(tmp_path, two):
    path, layout = two
    changed = tmp_path / "changed.palpate"
    changed.write_bytes((tmp_path / "organ.palpate").read_bytes())
    bodies = (
        *layout.bodies,
        replace(place(changed, "changed"), sha256="0" * 64),
        PlacedBody("missing", "nowhere.palpate", "0" * 64),
    )
    errors = find(check(path, replace(layout, bodies=bodies)).problems, ERROR)
    assert "changed: " in errors and "--renew" in errors
    assert "missing: " in errors and "No such file" in errors
    assert "none, expected one or more" in find(check(path, Layout()).problems, ERROR)


def test_what_overlaps_unpaired_disagrees_or_is_too_deep_is_told(tmp_path, two):
    path, layout = two
    heavy = write_organ(tmp_path, "heavy", gravity=(0.0, 0.0, -9.81))
    alone = replace(layout, pairs=(), bodies=(*layout.bodies, place(heavy, "heavy", (1, 0, 0))))
    found = check(path, alone, measures=False)
    assert "low and high: overlap by 0.99 mm and are no pair" in find(found.problems, WARNING)
    assert "heavy: gravity: got" in find(found.problems, ERROR)

    deep = replace(layout.bodies[1], position=(0.0, 0.0, 0.02))
    found = check(path, replace(layout, bodies=(layout.bodies[0], deep)), measures=False)
    assert f"moving it {1e3 * MOST_SHIFT:g} mm parts: place it elsewhere" in find(
        found.problems, ERROR
    )
    assert found.scene is None


def test_a_linear_solid_cannot_be_in_a_pair(tmp_path):
    corners = [(x, y, z) for z in (0.0, 0.02) for y in (0.0, 0.02) for x in (0.0, 0.02)]
    inside = [(0, 1, 2, 4), (1, 3, 2, 7), (1, 2, 4, 7), (1, 4, 5, 7), (2, 6, 4, 7)]
    tissue = palpate.build_linear_solid(
        palpate.SolidMesh(corners, inside),
        palpate.Material(poisson_ratio=0.3),
        palpate.SolidOptions(fixed=[0, 1, 2]),
    )
    path = tmp_path / "linear.palpate"
    scene = palpate.build_scene(palpate.make_scene(tissue))
    scenario.write(path, scenario.Scenario(scene=scene, title="Linear"))
    bodies = (place(path, "a"), place(path, "b", (0.1, 0.0, 0.0)))
    layout = Layout(bodies=bodies, pairs=(TouchingPair("a", "b"),))

    found = check(tmp_path / "x.json", layout, measures=False)

    assert "linear solid" in find(found.problems, ERROR)
    assert not check(tmp_path / "x.json", replace(layout, pairs=()), measures=False).has_errors


def test_an_organ_of_several_bodies_is_not_placed(tmp_path):
    bodies = [palpate.SoftBody(tissue=organ_scene(n).bodies[0].tissue) for n in (0, 1)]
    path = tmp_path / "both.palpate"
    scene = palpate.build_scene(palpate.Scene(bodies=bodies))
    scenario.write(path, scenario.Scenario(scene=scene, title="Both"))

    found = check(tmp_path / "x.json", Layout(bodies=(place(path, "both"),)))

    assert "got 2 bodies, expected one" in find(found.problems, ERROR)


def test_bodies_that_overlap_are_told_with_their_place_and_what_parts_them(tmp_path):
    path, layout = two_bodies(tmp_path, apart=0.0588)

    checked = check(path, layout, measures=False)

    ((problem, separation),) = checked.separations
    assert "inside of" in problem.message
    assert problem in checked.problems
    assert np.linalg.norm(separation.place - (0.0294, 0.0, 0.0)) < 5e-3
    assert not any("too far apart" in each.message for each in checked.problems)


def test_a_pair_of_a_negative_constant_is_refused():
    for name in ("thickness", "stiffness", "damping"):
        with pytest.raises(LayoutError, match=f"{name}: got -1.*, expected 0 to "):
            document.set_pair(Layout(), TouchingPair("a", "b", **{name: -1.0}))


def two_bodies(folder: Path, apart: float) -> tuple[Path, Layout]:
    """Two ellipsoids that may touch, so far [m] from middle to middle along x."""
    file = write_organ(folder, "organ")
    bodies = tuple(
        PlacedBody(name, file.name, hash_file(file), position=(x, 0.0, 0.0))
        for name, x in (("left", 0.0), ("right", apart))
    )
    return folder / "two.layout.json", Layout(bodies=bodies, pairs=(TouchingPair("left", "right"),))
