# SPDX-License-Identifier: BSD-3-Clause
"""F7: soft tissue pressed between a tool and something hard, from a gap of 0."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import NONE, TICK, make_block
from test_f06_layers import make_layer

HALF = 2.5e-3
"""[m] of a layer of 5 mm that lies on the table at z = -HALF."""


def make_table(side: float = 0.08, cells: int = 4) -> palpate.SurfaceMesh:
    at = np.linspace(-0.5 * side, 0.5 * side, cells + 1)
    y, x = (each.ravel() for each in np.meshgrid(at, at, indexing="ij"))
    first = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    a, b, c, d = first, first + 1, first + cells + 1, first + cells + 2
    triangles = np.concatenate([np.stack([a, b, d], 1), np.stack([a, d, c], 1)])
    return palpate.SurfaceMesh(np.stack([x, y, np.full(x.size, -HALF)], 1), triangles)


def make_scene(radius: float, integrator=palpate.Integrator.symplectic_euler) -> palpate.Scene:
    layer = make_layer(0.06, 12, 0.0, 5e3)
    layer.integrator = integrator
    return palpate.build_scene(
        palpate.Scene(
            bodies=[layer],
            instruments=[palpate.Instrument(tool=palpate.Tool(radius=radius))],
            scenery=[palpate.Scenery(make_table(), [0])],
        )
    )


def measure_least_volume(scene: palpate.Scene, world: palpate.World) -> float:
    """J of the tetrahedron that is pressed most."""
    volumes = scene.bodies[0].tissue.volumes
    a, b, c, d = (world.bodies[0].tissue.position[volumes.corners[:, k]] for k in range(4))
    now = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6.0
    return float((now / volumes.rest_volume).min())


def press(scene: palpate.Scene, depth: float) -> tuple[palpate.World, float, np.ndarray]:
    """Pressed at 40 mm/s and held: the world, the lowest vertex ever [m], and forces [N]."""
    world, sample = palpate.World(scene), palpate.HapticSample()
    lowest, forces = np.inf, []
    top = HALF + scene.instruments[0].tool.radius + 1e-4
    for k in range(round((depth / 0.04 + 0.3) / TICK)):
        sample.position = (0.001, 0.002, top - min(depth, 0.04 * k * TICK))
        forces.append(palpate.tick(scene, sample, TICK, world).force[2])
        lowest = min(lowest, palpate.surface_position(world.bodies[0])[:, 2].min())
    return world, lowest, np.array(forces)


@pytest.mark.parametrize(("depth", "least"), [(2.5e-3, 0.5), (3.5e-3, 0.38)])
def test_f7_a_layer_on_a_table_is_pressed_to_50_and_70_per_cent(depth, least):
    scene = make_scene(8e-3)

    world, lowest, forces = press(scene, depth)

    assert world.alarm.kind == NONE
    assert lowest == pytest.approx(-HALF, abs=1e-8)
    assert measure_least_volume(scene, world) > least
    assert np.abs(np.diff(forces[-50:], 2)).max() < 2e-5
    assert forces[-1] > 0.1
    # the table bears what the ball presses, and what the held rim pulls down besides
    assert world.scenery_contacts[0].force[2] == pytest.approx(forces[-1], rel=0.1)


@pytest.mark.parametrize(
    "name",
    [
        pytest.param("implicit_euler", marks=pytest.mark.verify),  # four minutes of a processor
        *(
            pytest.param(name, marks=pytest.mark.landing)
            for name in ("xpbd", "projective_dynamics")
        ),
    ],
)
def test_f7_whatever_steps_the_layer(name):
    world, lowest, forces = press(make_scene(8e-3, palpate.Integrator[name]), 2.5e-3)

    assert world.alarm.kind == NONE
    assert lowest == pytest.approx(-HALF, abs=1e-8)
    assert forces[-1] > 0.1


def test_a_body_that_begins_in_scenery_is_refused_with_the_vertex_and_the_depth():
    table = make_table()
    above = palpate.SurfaceMesh(table.vertices + [0.0, 0.0, 1e-3], table.triangles)
    slab = palpate.SurfaceMesh(
        [(x, y, z) for z in (-0.02, -0.001) for y in (-0.05, 0.05) for x in (-0.05, 0.05)],
        [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7),
         (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)],
    )  # fmt: skip
    layer = make_layer(0.06, 4, 0.0, 5e3)

    with pytest.raises(ValueError, match=r"scenery\[0\]: got vertex \d+ of body 0 1.5 mm inside"):
        palpate.build_scene(palpate.Scene(bodies=[layer], scenery=[palpate.Scenery(slab, [0])]))
    # a sheet has no inside, but the layer has
    with pytest.raises(ValueError, match=r"got vertex \d+ of the scenery 1 mm inside of body 0"):
        palpate.build_scene(palpate.Scene(bodies=[layer], scenery=[palpate.Scenery(above, [0])]))


def test_a_body_that_begins_across_an_open_sheet_is_refused():
    # nothing is inside of a sheet, and of a large one no vertex is inside of the body
    corners = np.array([(x, y, 5e-4) for y in (-0.05, 0.05) for x in (-0.05, 0.05)])
    through, beside = (
        palpate.Scenery(palpate.SurfaceMesh(corners + [0, 0, up], [(0, 1, 2), (1, 3, 2)]), [0])
        for up in (0.0, 2e-3)
    )
    tissue = palpate.build_solid(
        make_block((4, 4, 2), (0.06, 0.06, 2.0 * HALF)), palpate.Material()
    )

    with pytest.raises(ValueError, match=r"got vertex \d+ of body 0 0.5 mm inside of the scenery"):
        palpate.build_scene(
            palpate.Scene(bodies=[palpate.SoftBody(tissue=tissue)], scenery=[through])
        )
    palpate.build_scene(palpate.Scene(bodies=[palpate.SoftBody(tissue=tissue)], scenery=[beside]))


@pytest.mark.parametrize(
    ("bodies", "friction", "said"),
    [
        ([1], 0.0, r"scenery\[0\].bodies: got body 1, expected some of the 1 bodies"),
        ([0, 0], 0.0, r"scenery\[0\].bodies: got body 0 again, expected each body once"),
        ([0], -0.1, r"scenery\[0\].friction \[-\]: got -0.1, expected 0, or a positive number"),
    ],
)
def test_scenery_that_cannot_be_is_refused(bodies, friction, said):
    scenery = palpate.Scenery(make_table(), bodies, friction=friction)
    layer = make_layer(0.06, 4, 0.0, 5e3)
    with pytest.raises(ValueError, match=said):
        palpate.build_scene(palpate.Scene(bodies=[layer], scenery=[scenery]))
