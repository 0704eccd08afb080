# SPDX-License-Identifier: BSD-3-Clause
"""The common work at equal accuracy in Newton on the processor: neo-Hookean tetrahedra.

`newton_tissue.py FOLDER WORK RECIPE DT_MS SOLVER [ITERATIONS]`. SOLVER is vbd (implicit, vertex by
vertex) or semi (semi-implicit Euler). Its constants are Lamé's. It touches vertices, which have a
radius, with a stiffness each; the ball is made smaller by the radius. Its semi-implicit law is of
another energy, whose constants in small strain are not those it is given: they are converted.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np
import warp
from work import (
    Engine,
    Mesh,
    Work,
    convert_for_newton,
    find_lame,
    press,
    read_mesh,
    read_work,
    report,
)

warp.config.quiet = True

import newton  # noqa: E402  (after what it prints has been turned off)

PARTICLE_RADIUS = 1e-4
"""[m]"""
CONTACT = 300.0
"""[N/m] per vertex: it sinks in by some hundredths of a millimetre at most."""
DAMPING = {"vbd": 0.03, "semi": 5e-4}
"""[s] Viscosity over the shear modulus; the explicit one blows up with more."""


def build_model(work: Work, mesh: Mesh, solver: str) -> newton.Model:
    masses = np.full(len(mesh.x), mesh.find_mass(work))
    masses[mesh.held] = 0.0
    builder = newton.ModelBuilder(gravity=(0.0, 0.0, 0.0))
    still = [warp.vec3(0.0, 0.0, 0.0)] * len(mesh.x)
    builder.add_particles(
        [warp.vec3(*p) for p in mesh.x],
        still,
        masses.tolist(),
        radius=[PARTICLE_RADIUS] * len(mesh.x),
    )
    mu, lam = find_lame(work)
    k_mu, k_lambda = (mu, lam) if solver == "vbd" else convert_for_newton(mu, lam)
    viscosity = DAMPING[solver] * mu
    for a, b, c, d in mesh.cells.tolist():
        builder.add_tetrahedron(a, b, c, d, k_mu, k_lambda, viscosity)
    config = builder.default_shape_cfg
    config.ke, config.kd, config.mu = CONTACT, 0.0, 0.0
    place = warp.transform(warp.vec3(*work.place(0.0, 2.0 * work.radius)), warp.quat_identity())
    ball = builder.add_body(mass=0.0, is_kinematic=True, xform=place)
    builder.add_shape_sphere(ball, radius=work.radius - PARTICLE_RADIUS)
    if solver == "vbd":
        builder.color()
    model = builder.finalize(device="cpu")
    model.soft_contact_ke, model.soft_contact_kd, model.soft_contact_mu = CONTACT, 0.0, 0.0
    model.particle_grid = None  # no particle touches another
    return model


def build_engine(work: Work, mesh: Mesh, dt: float, solver: str, iterations: int) -> Engine:
    model = build_model(work, mesh, solver)
    if solver == "vbd":
        stepper = newton.solvers.SolverVBD(
            model, iterations=iterations, particle_enable_self_contact=False
        )
    else:
        stepper = newton.solvers.SolverSemiImplicit(model, enable_tri_contact=False)
    pipeline = newton.CollisionPipeline(model, broad_phase="nxn", soft_contact_gap=1e-3)
    contacts = pipeline.contacts()
    states = [model.state(), model.state()]
    control = model.control()
    outward = np.array(work.direction)
    centre_now = [np.zeros(3)]

    def step(centre: np.ndarray) -> None:
        now, then = states
        now.body_q.numpy()[0, :3] = centre  # a view, on the processor
        then.body_q.numpy()[0, :3] = centre
        centre_now[0] = centre
        now.clear_forces()
        pipeline.collide(now, contacts)
        stepper.step(now, then, control, contacts, dt)
        states.reverse()

    def positions() -> np.ndarray:
        return states[0].particle_q.numpy().astype(float)

    def force() -> float:
        # what its penalty is: a stiffness times how deep a vertex is in the ball
        away = positions() - centre_now[0]
        distance = np.linalg.norm(away, axis=1)
        deep = np.maximum(work.radius - distance, 0.0)
        return float(-CONTACT * (deep / distance * (away @ outward)).sum())

    for _ in range(3):  # compiles what it will run
        step(work.place(0.0, 3.0 * work.radius))
    return Engine(step, force, positions)


def main() -> None:
    folder, name, recipe = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    dt, solver = 1e-3 * float(sys.argv[4]), sys.argv[5]
    iterations = int(sys.argv[6]) if solver == "vbd" else 1
    warp.set_device("cpu")
    work = read_work(folder / f"{name}.json")
    mesh = read_mesh(folder, work, recipe)
    began = time.perf_counter()
    engine = build_engine(work, mesh, dt, solver, iterations)
    built = time.perf_counter() - began
    row = press(engine, work, np.array(engine.positions()), mesh.touch_vertices, dt)
    report(
        work, row, engine="Newton", version=newton.__version__, vertices=len(mesh.x),
        cells=len(mesh.cells), recipe=recipe, dt_ms=1e3 * dt, solver=solver,
        iterations=iterations, load_s=built,
    )  # fmt: skip


if __name__ == "__main__":
    main()
