# SPDX-License-Identifier: BSD-3-Clause
"""The common work in Newton on the processor: springs, semi-implicit Euler, no self-contact.

`newton_engine.py N DT_MS`. Homes are springs to held particles a micrometre off, for a spring of no
length has no direction there. A particle has a radius; the ball is made smaller by it.
"""

from __future__ import annotations

import sys

import numpy as np
import warp
from body import RADIUS, STIFFNESS, Body, build_body, place_ball
from press import Engine, report

warp.config.quiet = True

import newton  # noqa: E402  (after what it prints has been turned off)

PARTICLE_RADIUS = 5e-4
"""[m]"""
CONTACT = 1e3
"""[N/m] per particle: that of the plain loop."""
OFFSET = 1e-6
"""[m]"""


def build_model(body: Body) -> newton.Model:
    count = body.vertices
    masses = np.where(body.free, body.mass, 0.0)
    builder = newton.ModelBuilder(gravity=(0.0, 0.0, 0.0))
    homes = body.x + [0.0, 0.0, OFFSET]
    still = [warp.vec3(0.0, 0.0, 0.0)] * (2 * count)
    builder.add_particles(
        [warp.vec3(*p) for p in np.concatenate([body.x, homes])],
        still,
        [*masses.tolist(), *[0.0] * count],
        radius=[PARTICLE_RADIUS] * count + [1e-9] * count,
    )
    for i, j in body.edges:
        builder.add_spring(int(i), int(j), STIFFNESS, body.damping, 0.0)
    for i in range(count):
        builder.add_spring(i, count + i, body.home, 0.0, 0.0)
    builder.default_shape_cfg.ke = CONTACT
    builder.default_shape_cfg.kd = 0.0
    builder.default_shape_cfg.mu = 0.0
    place = warp.transform(warp.vec3(0.0, 0.0, place_ball(0.0)), warp.quat_identity())
    ball = builder.add_body(mass=0.0, is_kinematic=True, xform=place)
    builder.add_shape_sphere(ball, radius=RADIUS - PARTICLE_RADIUS)
    model = builder.finalize(device="cpu")
    model.soft_contact_ke, model.soft_contact_kd, model.soft_contact_mu = CONTACT, 0.0, 0.0
    model.particle_grid = None  # no particle touches another
    return model


def build_engine(body: Body, dt: float) -> Engine:
    model = build_model(body)
    solver = newton.solvers.SolverSemiImplicit(model, enable_tri_contact=False)
    pipeline = newton.CollisionPipeline(model, broad_phase="nxn", soft_contact_gap=0.001)
    contacts = pipeline.contacts()
    states = [model.state(), model.state()]
    control = model.control()

    def step(height: float) -> None:
        now, then = states
        now.body_q.numpy()[0, 2] = height  # a view, on the processor
        now.clear_forces()
        pipeline.collide(now, contacts)
        solver.step(now, then, control, contacts, dt)
        states.reverse()

    def positions() -> np.ndarray:
        return states[0].particle_q.numpy()[: body.vertices].astype(float)

    for _ in range(3):  # compiles what it will run
        step(place_ball(0.0) + 1.0)
    return Engine(step, positions, lambda: int(contacts.soft_contact_count.numpy()[0]))


if __name__ == "__main__":
    count, dt = int(sys.argv[1]), 1e-3 * float(sys.argv[2])
    warp.set_device("cpu")
    body = build_body(count)
    report("Newton", build_engine(body, dt), body, dt, version=newton.__version__)
