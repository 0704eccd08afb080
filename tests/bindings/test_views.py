# SPDX-License-Identifier: BSD-3-Clause
"""Arrays and the library share memory: what is written arrives, and nothing is left dangling."""

from __future__ import annotations

import copy
import gc

import numpy as np
import palpate
import pytest
from surfaces import MEMBRANE, chain, ellipsoid, organ_scene, sheet


def test_writing_into_the_position_moves_the_particles():
    model = chain(3)
    state = palpate.State(model)

    state.position[2] += (0.0, 0.0, 0.001)
    state.velocity[:, 1] = 2.0

    assert state.position[2, 2] == 0.001
    assert state.velocity[0, 1] == 2.0
    elastic = palpate.compute_energy(model, (0, 0, 0), state).links
    stretch = np.hypot(0.01, 0.001) - 0.01
    assert elastic == pytest.approx(0.5 * 100.0 * stretch**2)


def test_an_array_shows_what_a_step_has_done():
    model = chain(3)
    state = palpate.State(model)
    x = state.position
    before = x.copy()
    state.velocity[2] = (0.0, 1.0, 0.0)

    palpate.step(model, palpate.Load(), 1e-4, state)

    assert x[2, 1] == pytest.approx(1e-4)
    assert np.array_equal(x[:2], before[:2])
    assert np.shares_memory(x, state.position)


def test_an_array_keeps_what_it_shows_alive():
    mass = palpate.build_mass_spring(ellipsoid((0.03, 0.03, 0.03), 2), MEMBRANE, 50.0).mass
    stiffness = chain(50).springs.stiffness
    position = palpate.World(organ_scene(1)).bodies[0].tissue.position
    gc.collect()
    rubbish = [np.full(5000, 7.0) for _ in range(50)]

    assert mass.sum() == pytest.approx(1060.0 * 2e-3 * 4 * np.pi * 0.03**2, rel=0.05)
    assert (stiffness == 100.0).all()
    assert np.linalg.norm(position, axis=1).max() == pytest.approx(0.03, rel=0.1)
    del rubbish


def test_points_are_float64_rows_of_three_without_a_copy():
    mesh = sheet(4, 0.03)

    assert mesh.vertices.shape == (16, 3)
    assert mesh.vertices.dtype == np.float64
    assert mesh.vertices.flags.c_contiguous
    assert not mesh.vertices.flags.owndata
    assert np.shares_memory(mesh.vertices, mesh.vertices)


def test_a_mesh_copies_what_it_is_made_of():
    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    mesh = palpate.SurfaceMesh(vertices, [(0, 1, 2)])

    vertices[0] = 9.0

    assert (mesh.vertices[0] == 0.0).all()


@pytest.mark.parametrize(
    "indices",
    [
        lambda: sheet(3, 0.02).triangles,
        lambda: chain(3).springs.ends,
        lambda: chain(3).fixed,
        lambda: palpate.build_topology(sheet(3, 0.02).triangles).edges,
        lambda: palpate.World(organ_scene(1)).bodies[0].tree.order(),
        lambda: palpate.World(organ_scene(1)).bodies[0].tree.triangles(),
        lambda: palpate.World(organ_scene(1)).instruments[0].tool.holds,
        lambda: palpate.World(organ_scene(1)).bodies[0].load.storage,
    ],
    ids=["triangles", "ends", "fixed", "edges", "order", "tree", "holds", "pushes"],
)
def test_indices_can_be_read_but_not_written(indices):
    array = indices()

    assert len(array) > 0
    with pytest.raises(ValueError, match="read-only"):
        array[0] = array[0]


def test_a_vector_is_a_view_when_read_and_a_copy_when_assigned():
    load = palpate.Load()
    down = np.array([0.0, 0.0, -9.81])

    load.gravity = down
    down[2] = 0.0
    load.gravity[0] = 1.0

    assert load.gravity.tolist() == [1.0, 0.0, -9.81]


def test_an_orientation_is_x_y_z_w():
    sample = palpate.HapticSample()
    assert sample.orientation.tolist() == [0.0, 0.0, 0.0, 1.0]

    sample.orientation = (1.0, 0.0, 0.0, 0.0)

    assert sample.orientation.tolist() == [1.0, 0.0, 0.0, 0.0]


def test_no_copy_takes_the_place_of_an_array_to_write_to():
    model = chain(3)
    x = model.rest_position
    wrong = np.zeros((3, 3), dtype=np.float32)

    with pytest.raises(TypeError):
        palpate.compute_forces(model, palpate.Load(), x, np.zeros_like(x), wrong)
    with pytest.raises(TypeError):
        palpate.compute_forces(model, palpate.Load(), x, np.zeros_like(x), np.zeros((3, 6))[:, ::2])


def test_an_array_that_refuses_writing_is_not_written():
    model = chain(3)
    f = np.zeros((3, 3))
    f.flags.writeable = False

    with pytest.raises(TypeError, match="f: got float64 .*read-only, expected a writable"):
        palpate.accumulate_gravity(model.mass, (0, 0, -9.81), f)


def test_a_scene_takes_its_tissue_once_so_views_of_it_stay_good():
    scene = palpate.Scene()
    scene.bodies[0].tissue = chain(3)
    mass = scene.bodies[0].tissue.mass

    with pytest.raises(ValueError, match="soft body: tissue"):
        scene.bodies[0].tissue = chain(200)

    assert np.shares_memory(mass, scene.bodies[0].tissue.mass)
    assert not mass.flags.writeable


def test_a_copy_is_its_own():
    state = palpate.State(chain(3))
    twin = copy.deepcopy(state)

    twin.position[1] = 5.0

    assert state.position[1, 0] == 0.01
    assert copy.copy(palpate.Material(density=900.0)).density == 900.0


def test_options_that_read_as_copies_refuse_writing():
    options = palpate.SurfaceOptions(stiffness_scale=[1.0, 2.0], fixed=[3])

    with pytest.raises(ValueError, match="read-only"):
        options.stiffness_scale[0] = 5.0
    options.fixed = [1, 2]

    assert options.stiffness_scale.tolist() == [1.0, 2.0]
    assert options.fixed.tolist() == [1, 2]


def test_structured_rows_share_memory_with_a_record():
    felt = np.zeros(3, palpate.Felt.dtype)
    record = palpate.Record(hand=np.zeros(3, palpate.HapticSample.dtype), felt=felt)

    record.hand["position"][1, 2] = 0.5

    assert record.hand["position"].tolist() == [[0, 0, 0], [0, 0, 0.5], [0, 0, 0]]


def test_structured_rows_are_matched_by_name():
    wrong = np.zeros(3, [("position", "f8", 3), ("time", "f8")])

    with pytest.raises(ValueError, match="hand: got fields"):
        palpate.Record(hand=wrong)


def test_rows_survive_the_way_through_a_file_of_numpy(tmp_path):
    hand = np.zeros(3, palpate.HapticSample.dtype)
    hand["position"] = np.arange(9.0).reshape(3, 3)
    hand["orientation"][:, 3] = 1.0
    np.save(tmp_path / "hand.npy", hand)

    felt = np.zeros(3, palpate.Felt.dtype)
    record = palpate.Record(hand=np.load(tmp_path / "hand.npy"), felt=felt)

    assert np.array_equal(record.hand["position"], hand["position"])
    assert np.array_equal(record.hand["orientation"], hand["orientation"])
