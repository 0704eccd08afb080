# SPDX-License-Identifier: BSD-3-Clause
"""The common work in Palpate: whole haptic ticks, with all that a tick does.

`palpate_engine.py N DT_MS CONTACT FORCE_ERROR`. A step is a tick of DT_MS with as many substeps as
it asks for: tree, candidates, tool, forces, alarm. The hand holds the tool by a spring so stiff
that the ball is where the hand is, to a tenth of a millimetre. CONTACT is the tool's stiffness
[N/m³], FORCE_ERROR [N] by how much the force may be wrong so that tissue at rest may sleep; 0: none
does.
"""

from __future__ import annotations

import json
import sys

import numpy as np
import palpate
from body import RADIUS, STIFFNESS, Body, build_body
from press import Engine, press

COUPLING = 1e4
"""[N/m]"""
FORCE_MAX = 1e3
"""[N]"""


def build_scene(body: Body, dt: float, contact: float, force_error: float = 0.0) -> palpate.Scene:
    n, edges = body.vertices, len(body.edges)
    rest = np.linalg.norm(body.x[body.edges[:, 1]] - body.x[body.edges[:, 0]], axis=1)
    springs = palpate.Links(
        ends=body.edges,
        rest_length=rest,
        stiffness=np.full(edges, STIFFNESS),
        damping=np.full(edges, body.damping),
    )
    tissue = palpate.TissueModel(
        rest_position=body.x,
        mass=np.full(n, body.mass),
        fixed=body.fixed,
        springs=springs,
        home=np.full(n, body.home),
        triangles=body.triangles,
        drag=0.0,
    )
    return palpate.build_scene(
        palpate.Scene(
            bodies=[palpate.SoftBody(tissue=tissue, force_error=force_error)],
            instruments=[
                palpate.Instrument(
                    tool=palpate.Tool(radius=RADIUS, stiffness=contact),
                    coupling=palpate.Coupling(stiffness=COUPLING, force_max=FORCE_MAX),
                )
            ],
            rate=1.0 / dt,
        )
    )


class Tissue:
    """A running scene as an engine."""

    def __init__(self, scene: palpate.Scene, dt: float):
        self.scene, self.dt = scene, dt
        self.world, self.sample = palpate.World(scene), palpate.HapticSample()
        self.substeps: list[int] = []

    def step(self, height: float) -> None:
        self.sample.position[2] = height
        palpate.tick(self.scene, self.sample, self.dt, self.world)

    def positions(self) -> np.ndarray:
        if self.world.alarm:
            return np.full_like(self.world.bodies[0].tissue.position, np.nan)
        return np.array(self.world.bodies[0].tissue.position)

    def contacts(self) -> int:
        self.substeps.append(self.world.bodies[0].substeps)
        return self.world.bodies[0].load.push_count


if __name__ == "__main__":
    count, dt = int(sys.argv[1]), 1e-3 * float(sys.argv[2])
    contact, force_error = float(sys.argv[3]), float(sys.argv[4])
    body = build_body(count)
    tissue = Tissue(build_scene(body, dt, contact, force_error), dt)
    engine = Engine(tissue.step, tissue.positions, tissue.contacts)
    row = press(engine, body, dt)
    about = {
        "engine": "Palpate",
        "vertices": count,
        "dt_ms": 1e3 * dt,
        "contact": contact,
        "force_error_n": force_error,
    }
    substeps = float(np.median(tissue.substeps or [0]))
    print(json.dumps({**about, "version": palpate.__version__, "substeps": substeps, **row}))
