# SPDX-License-Identifier: BSD-3-Clause
"""Contact, scenes and ticks as Python calls them."""

from __future__ import annotations

import copy

import numpy as np
import palpate
import pytest
from surfaces import MEMBRANE, ellipsoid, organ_scene, press_frames, run_frames, sheet


def tick_at(scene, world, z: float, *, count: int = 1, buttons: int = 0) -> np.ndarray:
    """The force [N] of the last of `count` ticks with the hand at height `z` above the middle."""
    sample = palpate.HapticSample(position=(0.0, 0.0, z), buttons=buttons)
    for _ in range(count):
        force = palpate.tick(scene, sample, 1e-3, world).force
    return force


def test_hovering_is_exactly_nothing():
    scene = organ_scene()
    world = palpate.World(scene)

    force = tick_at(scene, world, 0.03, count=20)

    assert force.tolist() == [0.0, 0.0, 0.0]
    assert not world.instruments[0].tool.touching
    assert world.tick_count == 20
    # a float cannot tell a rest length from the distance of two rest positions
    assert np.allclose(
        world.bodies[0].tissue.position, scene.bodies[0].tissue.rest_position, rtol=0.0, atol=1e-8
    )


def test_the_pressed_organ_pushes_the_hand_out_and_gives_way():
    scene = organ_scene()
    world = palpate.World(scene)
    tick_at(scene, world, 0.03)

    for z in np.linspace(0.03, 0.018, 120):
        force = tick_at(scene, world, z)

    assert 0.05 < force[2] < scene.instruments[0].coupling.force_max
    assert world.instruments[0].tool.touching
    assert world.bodies[0].tissue.position[:, 2].max() < 0.0199
    assert world.bodies[0].load.push_count == len(world.bodies[0].load.pushes()) > 0
    pushed = world.bodies[0].load.pushes()["force"].sum(axis=0)
    at_tool = scene.instruments[0].coupling.stiffness * (
        world.instruments[0].tool.position - (0.0, 0.0, 0.018)
    )
    assert pushed == pytest.approx(-(at_tool + world.instruments[0].tool.residual), abs=1e-9)


def test_the_attach_button_holds_the_tissue_until_it_is_let_go():
    scene = organ_scene()
    world = palpate.World(scene)
    for z in np.linspace(0.03, 0.021, 90):
        tick_at(scene, world, z)

    for z in np.linspace(0.021, 0.03, 180):
        force = tick_at(scene, world, z, buttons=palpate.ATTACH_BUTTON)
    held, pulled = world.instruments[0].tool.hold_count, force[2]
    force = tick_at(scene, world, 0.03, count=500)

    assert held > 0
    assert pulled < -0.05
    assert world.instruments[0].tool.hold_count == 0
    assert force.tolist() == [0.0, 0.0, 0.0]


def test_a_copied_world_goes_on_to_the_same_bits():
    scene = organ_scene(1)
    world = palpate.World(scene)
    for z in np.linspace(0.03, 0.02, 100):
        tick_at(scene, world, z)
    twin = copy.copy(world)

    one, other = (tick_at(scene, w, 0.019, count=50) for w in (world, twin))

    assert one.tolist() == other.tolist()
    assert palpate.compute_hash(world) == palpate.compute_hash(twin)
    assert palpate.compute_hash(world) != palpate.compute_hash(palpate.World(scene))


def test_two_organs_are_felt_differently():
    soft, stiff = (run_frames(organ_scene(stiffness=k), press_frames()) for k in (50.0, 400.0))

    assert stiff.felt["force"][:, 2].max() > 1.05 * soft.felt["force"][:, 2].max()


def test_build_scene_fills_in_what_is_derived():
    raw = palpate.make_scene(palpate.build_mass_spring(sheet(6, 0.05), MEMBRANE, 50.0))

    scene = palpate.build_scene(raw)

    assert raw.bodies[0].substeps == 0
    assert scene.bodies[0].substeps >= 1
    assert scene.bodies[0].substeps_max >= scene.bodies[0].substeps
    assert scene.bodies[0].rest_areas.sum() == pytest.approx(0.05**2)
    assert 1.0 / (scene.rate * scene.bodies[0].substeps) <= palpate.stable_step(
        scene.bodies[0].tissue
    )


def test_a_scene_that_cannot_be_is_refused():
    raw = palpate.make_scene(organ_scene(1).bodies[0].tissue)
    raw.instruments[0].coupling.stiffness = -1.0

    with pytest.raises(ValueError, match="coupling.stiffness"):
        palpate.build_scene(raw)


def test_contact_by_hand_balances_as_in_a_tick():
    scene = organ_scene()
    x, triangles = scene.bodies[0].tissue.rest_position, scene.bodies[0].tissue.triangles
    tree = palpate.AabbTree(x, triangles)
    candidates = palpate.Candidates(len(triangles))
    state, load = palpate.ToolState(len(triangles)), palpate.Load(2 * len(triangles))
    over, hand = np.array([0.0, 0.0, 0.03]), np.array([0.0, 0.0, 0.022])

    assert palpate.place_tool(tree, x, over, scene.instruments[0].tool.radius, state)
    palpate.find_candidates(
        tree, x, scene.instruments[0].tool, over, hand, scene.bodies[0].rest_areas, candidates
    )
    for _ in range(2):  # from afar the first balance ends where the contacts begin
        force = palpate.balance_tool(
            scene.instruments[0].tool,
            scene.instruments[0].coupling,
            hand,
            candidates,
            triangles,
            x,
            state,
            load,
        )
    scratch = np.zeros(len(x))
    bound = palpate.bound_contact_stiffness(
        scene.instruments[0].tool,
        candidates,
        triangles,
        x,
        scene.bodies[0].tissue.mass,
        state,
        scratch,
    )

    assert candidates.count > 4
    assert (np.diff(candidates.triangles[: candidates.count]) > 0).all()
    assert force[2] > 0.0
    assert load.pushes()["force"].sum(axis=0) == pytest.approx(-(force + state.residual), abs=1e-9)
    assert bound > 0.0
    assert palpate.attach_tool(load, triangles, x, 500.0, state)
    assert state.holds["stiffness"][: state.hold_count].sum() == pytest.approx(500.0)
    palpate.release_tool(state)
    assert state.hold_count == 0


def test_the_contact_law_is_pressure_times_area_over_a_barrier():
    tool = palpate.Tool(radius=0.003, stiffness=3e7)
    contact = palpate.Contact()
    a, b, c = (0.0, 0.0, 0.0), (0.001, 0.0, 0.0), (0.0, 0.001, 0.0)
    area, depth = 5e-7, 0.001

    touching = palpate.find_contact(tool, area, (2e-4, 2e-4, 0.002), a, b, c, contact)

    assert touching
    assert contact.force == pytest.approx(3e7 * area * depth / (1.0 - depth / 0.003))
    assert contact.direction == pytest.approx([0.0, 0.0, 1.0])
    assert not palpate.find_contact(tool, area, (2e-4, 2e-4, -0.002), a, b, c, contact)
    assert palpate.BARRIER_FLOOR == 0.1


def test_a_script_moves_smoothly_and_the_same_in_every_run():
    device = palpate.ScriptedDevice(press_frames())

    half = device.read(0.075)

    assert device.duration() == pytest.approx(0.4)
    # minimum jerk is half way at half time, at 1.875 times the mean speed
    assert half.position[2] == pytest.approx((0.028 + 0.017) / 2)
    assert half.velocity[2] == pytest.approx(-1.875 * 0.011 / 0.15)
    assert device.read(0.2).position.tolist() == [0.0, 0.0, pytest.approx(0.017)]
    with pytest.raises(ValueError):
        palpate.ScriptedDevice([])


def test_a_bench_times_every_work_of_two_scenes():
    mesh = ellipsoid((0.03, 0.025, 0.02), 1)
    constants = palpate.MolecularConstants(bond_stiffness=50.0)
    scenes = [
        palpate.build_scene(palpate.make_scene(tissue))
        for tissue in (
            palpate.build_mass_spring(mesh, MEMBRANE, 50.0),
            palpate.build_molecular(mesh, MEMBRANE, constants),
        )
    ]

    rows = palpate.run_bench(*scenes, palpate.BenchOptions(budget=1e-3, least_runs=2))

    assert {row.work for row in rows} >= {"mss_step", "mms_step", "refit", "segment", "mss_tick"}
    assert all(row.vertices == 42 and row.median > 0.0 and row.physics for row in rows)


def test_a_tip_with_friction_drags_the_tissue_up_to_mu_n():
    scene = organ_scene()
    scene.instruments[0].tool.friction = 0.2
    scene = palpate.build_scene(scene)
    world = palpate.World(scene)
    tick_at(scene, world, 0.03)
    for z in np.linspace(0.03, 0.020, 100):
        tick_at(scene, world, z)

    for x in np.linspace(0.0, 0.004, 200):
        sample = palpate.HapticSample(position=(x, 0.0, 0.020))
        force = palpate.tick(scene, sample, 1e-3, world).force

    tool = world.instruments[0].tool
    normal = tool.patch_normal
    pull = scene.instruments[0].coupling.stiffness * (sample.position - tool.position)
    along = pull - normal * (normal @ pull)
    assert np.linalg.norm(along) == pytest.approx(-0.2 * (normal @ pull), rel=0.01)
    assert np.linalg.norm(tool.friction) == pytest.approx(np.linalg.norm(along), rel=0.01)
    assert force[0] < -0.1 * force[2]
    patch = tool.patch[: tool.patch_count]
    assert patch["share"].sum() == pytest.approx(1.0)
