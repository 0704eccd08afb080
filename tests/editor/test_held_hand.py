# SPDX-License-Identifier: GPL-3.0-or-later
"""A hand held still in a real organ feels a force that settles."""

from __future__ import annotations

import itertools

import numpy as np
import palpate
import pytest
from palpate.runs.press import CLEARANCE, Place, find_top
from palpate_editor.authoring import decimate, import_mesh

ORGANS = {
    # its capsule is two walls closer to each other than the sides of 1200 triangles are long
    "F_Kidney_L": ["VH_F_renal_pyramid_L_a"],
    "F_Liver": ["VH_F_capsule_of_the_liver"],
    "F_Pancreas": [],
    "F_Spleen": [],
    "M_Heart": ["VH_M_heart_left_ventricle"],
}
VERTICES = 300
HOLD = 2.0
"""[s]"""
SETTLED = 0.5
"""[s] of the hold, after which the force may no longer move."""
RIPPLE = 0.01
"""[-] of the mean force, from peak to peak."""
COUPLINGS, DEPTHS = (200.0, 500.0, 1000.0), (0.002, 0.005, 0.010)
"""[N/m], [m]"""
SAMPLE = list(zip(COUPLINGS, DEPTHS, strict=True))
EVERY = list(itertools.product(COUPLINGS, DEPTHS))


@pytest.fixture(scope="module")
def organ(request, shared_data) -> palpate.SurfaceMesh:
    path = shared_data(f"organs/VH_{request.param}.glb")
    return decimate(import_mesh(path, parts=ORGANS[request.param]).mesh, VERTICES).mesh


def build_tissue(kind: str, mesh: palpate.SurfaceMesh) -> palpate.TissueModel:
    """The demo's constants, with walls for organs that are open."""
    wall = None if palpate.is_closed(mesh.triangles) else 2.5e-3
    material = palpate.Material(density=1060.0, damping_ratio=0.3, wall_thickness=wall)
    height = np.asarray(mesh.vertices)[:, 2]
    lowest = np.flatnonzero(height <= height.min() + 0.12 * np.ptp(height))
    options = palpate.SurfaceOptions(home_stiffness=1e6, drag=8.0, fixed=lowest)
    if kind == "mss":
        return palpate.build_mass_spring(mesh, material, 150.0, options)
    constants = palpate.MolecularConstants(
        bond_stiffness=150.0, bend_stiffness=1e-3, stretch_coupling=0.1
    )
    return palpate.build_molecular(mesh, material, constants, options)


def hold(scene: palpate.Scene, place: Place, depth: float) -> np.ndarray:
    """[N] (n,) The force of every tick of a hold at `depth` [m], after a press of 0.2 s."""
    world, dt, force = palpate.World(scene), 1.0 / scene.rate, []
    for tick in range(round((0.2 + HOLD) * scene.rate)):
        part = min(1.0, tick * dt / 0.2)
        height = scene.instruments[0].tool.radius + CLEARANCE - part * (CLEARANCE + depth)
        sample = palpate.HapticSample(time=tick * dt, position=place.point + height * place.outward)
        command = palpate.tick(scene, sample, dt, world)
        assert not world.alarm
        force.append(np.linalg.norm(command.force))
    return np.array(force[-round(HOLD * scene.rate) :])


# every run has each kind, in organs that the other is not held in
@pytest.mark.parametrize(
    ("organ", "kind", "holds"),
    [
        pytest.param(organ, kind, SAMPLE, id=f"{organ}-{kind}-sample")
        for organ, kind in zip(ORGANS, itertools.cycle(["mss", "mms"]))
    ]
    + [
        pytest.param(organ, kind, EVERY, id=f"{organ}-{kind}-every", marks=pytest.mark.verify)
        for organ, kind in itertools.product(ORGANS, ["mss", "mms"])
    ],
    indirect=["organ"],
)
def test_a_hand_held_still_in_a_real_organ_feels_a_force_that_settles(organ, kind, holds):
    tissue = build_tissue(kind, organ)
    for coupling, depth in holds:
        scene = palpate.build_scene(
            palpate.Scene(
                bodies=[palpate.SoftBody(tissue=tissue)],
                instruments=[
                    palpate.Instrument(
                        tool=palpate.Tool(radius=3e-3, stiffness=3e7),
                        coupling=palpate.Coupling(stiffness=coupling, force_max=20.0),
                    )
                ],
            )
        )

        force = hold(scene, find_top(scene), depth)

        settled = force[round(SETTLED * scene.rate) :]
        assert settled.mean() > 0.02
        assert np.ptp(settled) < RIPPLE * settled.mean(), (coupling, depth)
