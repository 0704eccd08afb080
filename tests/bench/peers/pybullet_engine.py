# SPDX-License-Identifier: BSD-3-Clause
"""The common work in PyBullet's deformable world: a mass-spring body, its own contact.

`pybullet_engine.py N DT_MS`. All its springs share one stiffness and no force can be put on a
vertex, so tethers of that stiffness take the place of homes (body.py), and its force is held
against the plain loop on the very same springs. The ball is made smaller by the margin around it.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
import pybullet
from body import RADIUS, STIFFNESS, Body, build_body, place_ball
from press import Engine, report

MARGIN = 5e-4
"""[m]"""


def write_obj(path: Path, body: Body) -> None:
    with path.open("w", encoding="ascii") as file:
        np.savetxt(file, body.x, "v %.9g %.9g %.9g")
        np.savetxt(file, body.triangles + 1, "f %d %d %d")


def build_engine(body: Body, dt: float) -> Engine:
    pybullet.connect(pybullet.DIRECT)
    pybullet.resetSimulation(pybullet.RESET_USE_DEFORMABLE_WORLD)
    pybullet.setGravity(0, 0, 0)
    pybullet.setTimeStep(dt)
    with tempfile.TemporaryDirectory() as folder:
        obj = Path(folder) / "shell.obj"
        write_obj(obj, body)
        shell = pybullet.loadSoftBody(
            str(obj),
            mass=body.mass * len(body.x),  # shared by all points alike
            useMassSpring=1,
            useBendingSprings=0,
            useNeoHookean=0,
            springElasticStiffness=STIFFNESS,
            springDampingStiffness=body.damping,
            springDampingAllDirections=0,
            useSelfCollision=0,
            collisionMargin=MARGIN,
            frictionCoeff=0.0,
            useFaceContact=1,
        )
    for i in body.fixed:
        pybullet.createSoftBodyAnchor(shell, int(i), -1, -1)
    shape = pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=RADIUS - MARGIN)
    ball = pybullet.createMultiBody(0, shape, basePosition=[0, 0, place_ball(0.0)])

    def step(height: float) -> None:
        pybullet.resetBasePositionAndOrientation(ball, [0, 0, height], [0, 0, 0, 1])
        pybullet.stepSimulation()

    def positions() -> np.ndarray:
        flags = pybullet.MESH_DATA_SIMULATION_MESH
        x = np.array(pybullet.getMeshData(shell, -1, flags=flags)[1])
        if x.shape != body.x.shape:
            raise RuntimeError(f"{x.shape} positions of {body.x.shape}")
        return x

    return Engine(step, positions, lambda: len(pybullet.getContactPoints(bodyA=ball)))


if __name__ == "__main__":
    count, dt = int(sys.argv[1]), 1e-3 * float(sys.argv[2])
    body = build_body(count, tethered=True)
    report("PyBullet", build_engine(body, dt), body, dt, version="3.2.7", tethered=True)
