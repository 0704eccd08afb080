# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies from Python: a stone on a table, in water, and what is refused."""

from __future__ import annotations

import palpate
import pytest

TICK = 1e-3


def make_table(z: float = 0.0, half: float = 0.1) -> palpate.SurfaceMesh:
    corners = [(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)]
    return palpate.SurfaceMesh(corners, [(0, 1, 2), (0, 2, 3)])


def make_body() -> palpate.SoftBody:
    """Far away, as a scene needs a tissue."""
    chain = palpate.SurfaceMesh([(1, 0, 0), (1.01, 0, 0), (1, 0.01, 0)], [(0, 1, 2)])
    options = palpate.SurfaceOptions(fixed=[0, 1, 2])
    return palpate.SoftBody(
        tissue=palpate.build_mass_spring(
            chain, palpate.Material(wall_thickness=3e-3), 100.0, options
        )
    )


def make_ball(**changed: object) -> palpate.RigidBody:
    made: dict[str, object] = {
        "mass": 1e-3,
        "inertia": (1e-8, 1e-8, 1e-8),
        "position": (0, 0, 0.01),
    }
    made.update(changed)
    return palpate.RigidBody([(0, 0, 0)], [0.005], **made)  # type: ignore[arg-type]


def make_scene(*stones: palpate.RigidBody, **changed: object) -> palpate.Scene:
    return palpate.Scene(
        bodies=[make_body()],
        rigid=stones,
        scenery=[palpate.Scenery(make_table())],
        gravity=(0, 0, -9.81),
        **changed,  # type: ignore[arg-type]
    )


def run(scene: palpate.Scene, ticks: int) -> palpate.World:
    world, sample = palpate.World(scene), palpate.HapticSample(position=(0, 0, 0.3))
    for _ in range(ticks):
        palpate.tick(scene, sample, TICK, world)
    return world


def test_a_ball_falls_on_a_table_and_rests_with_its_weight():
    world = run(palpate.build_scene(make_scene(make_ball())), 1500)

    # 1e-3 kg 9.81 m/s² on 1000 N/m: 0.01 mm
    assert world.rigid[0].position[2] == pytest.approx(0.005 - 9.81e-6, abs=1e-6)
    assert abs(world.rigid[0].velocity).max() < 1e-4


def test_what_is_lighter_than_water_rises():
    scene = palpate.build_scene(make_scene(make_ball(mass=1e-4), fluid=palpate.Fluid(1000.0, 7e-4)))

    assert run(scene, 300).rigid[0].velocity[2] > 0.05


def test_a_scene_with_a_stone_survives_pickle_and_copy():
    import copy
    import pickle

    scene = palpate.build_scene(make_scene(make_ball(), fluid=palpate.Fluid(1000.0)))
    other = pickle.loads(pickle.dumps(scene))

    assert other.fluid.density == 1000.0
    assert other.rigid[0].mass == 1e-3
    world = run(other, 20)
    assert copy.copy(world).rigid[0].position.tolist() == world.rigid[0].position.tolist()


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"mass": 0.0}, r"rigid\[0\].mass \[kg\]: got 0, expected a positive number"),
        ({"inertia": (1e-8, 1e-8, 3e-8)}, r"inertia .* got 3e-08 about one axis"),
        ({"orientation": (0, 0, 0, 2)}, r"orientation .* got a norm of 2, expected a unit"),
        ({"friction": -1.0}, r"friction \[-\]: got -1, expected 0, or a positive number"),
        ({"contact_stiffness": 0.0}, r"contact_stiffness .* got 0, expected a positive number"),
        ({"position": (0, 0, 0.001)}, r"rigid\[0\]: got sphere 0 deep in scenery 0"),
        ({"mesh": make_table()}, r"rigid\[0\].mesh: got an open one, expected a closed one"),
    ],
)
def test_a_rigid_body_that_cannot_be_is_refused(changed, said):
    with pytest.raises(ValueError, match=said):
        palpate.build_scene(make_scene(make_ball(**changed)))


def test_several_spheres_in_a_fluid_need_a_mesh():
    pair = palpate.RigidBody(
        [(0, 0, 0), (0.004, 0, 0)], [0.005, 0.005], mass=1e-3, inertia=(1e-8, 1e-8, 1e-8),
        position=(0, 0, 0.01),
    )  # fmt: skip
    with pytest.raises(ValueError, match=r"rigid\[0\].mesh: got none for several spheres"):
        palpate.build_scene(make_scene(pair, fluid=palpate.Fluid(1000.0)))
