# SPDX-License-Identifier: BSD-3-Clause
"""The common work at equal accuracy in PositionBasedDynamics: XPBD, its collision of vertices.

`pbd_tissue.py FOLDER WORK RECIPE DT_MS ITERATIONS LAW`. LAW is fem, whose constraint is the strain
energy of every tetrahedron by Young's modulus and Poisson's ratio, or springs, which are edges and
volumes. The ball is a heavy rigid body with a distance field; contact is solved in velocities
after each step, and what it gives in impulses is the force.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np
import pypbd
from work import Engine, Mesh, Work, press, read_mesh, read_work, report

FEM, SPRINGS = 3, 6
"""Of addSolidConstraints: XPBD of the strain energy; of distances and volumes."""
VERSION = "2.2.2"
MILLI = 1e3
"""It works in millimetres and millinewtons: in metres its least volume lets no such tetrahedron
in."""
GRAVITY = 9.81
"""[mm/s²] along -y. Its Python cannot turn it off, so every step begins with what it will add taken
from the velocities, which costs nothing here."""
HEAVY = 1e9
"""[kg]"""
FREE = 0.9
"""Of a step's penetration, that contact takes back in the next: all of it swings."""


def build_ball(model: pypbd.SimulationModel, work: Work) -> tuple[pypbd.RigidBody, object]:
    """So heavy that nothing turns it aside, for only bodies with a mass are followed by the boxes
    in which contact is looked for. Its mesh is an octahedron; touched is a sphere's distance
    field."""
    vertices = pypbd.VertexData()
    for point in MILLI * work.radius * np.vstack([np.eye(3), -np.eye(3)]):
        vertices.addVertex(point)
    faces = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
    mesh = pypbd.IndexedFaceMesh()
    mesh.initMesh(6, 12, 8)
    for face in faces:
        mesh.addFace(list(face))
    mesh.buildNeighbors()
    ball = model.addRigidBody(
        1.0, vertices, mesh, translation=np.zeros(3), generateCollisionObject=False
    )
    ball.setMass(HEAVY)
    ball.setInertiaTensor(np.full(3, HEAVY))
    ball.setFrictionCoeff(0.0)
    ball.setRestitutionCoeff(0.0)
    collision = pypbd.Simulation.getCurrent().getTimeStep().getCollisionDetection()
    collision.addCollisionSphere(
        0, pypbd.CollisionObject.RigidBodyCollisionObjectType, vertices, 0, 6, MILLI * work.radius,
        False, False,
    )  # fmt: skip
    return ball, vertices


def build_engine(work: Work, mesh: Mesh, dt: float, iterations: int, law: str) -> Engine:
    simulation = pypbd.Simulation.getCurrent()
    simulation.initDefault()
    model = simulation.getModel()
    stepper = simulation.getTimeStep()
    collision = stepper.getCollisionDetection()
    collision.setTolerance(0.0)
    stepper.setValueUInt(pypbd.TimeStepController.NUM_SUB_STEPS, 1)
    stepper.setValueUInt(pypbd.TimeStepController.MAX_ITERATIONS, iterations)
    pypbd.TimeManager.getCurrent().setTimeStepSize(dt)
    tissue = model.addTetModel(list(MILLI * mesh.x), mesh.cells.ravel().tolist())
    particles = model.getParticles()
    mass = mesh.find_mass(work)
    for i in range(len(mesh.x)):
        particles.setMass(i, mass)
    for i in mesh.held:
        particles.setMass(int(i), 0.0)
    # [mN/mm²]
    stiffness = work.young_modulus / MILLI
    kind = FEM if law == "fem" else SPRINGS
    model.addSolidConstraints(tissue, kind, stiffness, work.poisson_ratio, stiffness, False, False)
    if len(model.getConstraints()) < len(mesh.cells):
        raise SystemExit(f"{len(model.getConstraints())} constraints of {len(mesh.cells)} cells")
    # the collision keeps a pointer to the vertices
    ball, kept = build_ball(model, work)
    collision.addCollisionObjectWithoutGeometry(
        0, pypbd.CollisionObject.TetModelCollisionObjectType, particles, 0, len(mesh.x), True
    )
    tissue.setFrictionCoeff(0.0)
    tissue.setRestitutionCoeff(0.0)
    model.setContactStiffnessParticleRigidBody(FREE / dt)
    outward = np.array(work.direction)
    weight = np.array([0.0, -GRAVITY, 0.0])

    def step(centre: np.ndarray) -> None:
        # a step adds the weight first, and then goes there
        ball.setVelocity((MILLI * centre - ball.getPosition().ravel()) / dt - weight * dt)
        stepper.step(model)

    def force() -> float:
        total = 0.0
        for contact in model.getParticleRigidBodyContactConstraints():
            normal = np.asarray(contact.constraintInfo)[:, 2]
            total += contact.sum_impulses * abs(float(normal @ outward))
        return total / dt / MILLI

    def positions() -> np.ndarray:
        return np.array(particles.getVertices()) / MILLI

    free = np.setdiff1d(np.arange(len(mesh.x)), mesh.held).tolist()

    def lift(keep: object = kept) -> None:
        for i in free:
            particles.setVelocity(i, particles.getVelocity(i) - weight * dt)

    ball.setPosition(MILLI * work.place(0.0, 2.0 * work.radius))
    return Engine(step, force, positions, lift)


def main() -> None:
    folder, name, recipe = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    dt, iterations, law = 1e-3 * float(sys.argv[4]), int(sys.argv[5]), sys.argv[6]
    work = read_work(folder / f"{name}.json")
    mesh = read_mesh(folder, work, recipe)
    began = time.perf_counter()
    engine = build_engine(work, mesh, dt, iterations, law)
    built = time.perf_counter() - began
    row = press(engine, work, np.array(engine.positions()), mesh.touch_vertices, dt)
    report(
        work, row, engine="PositionBasedDynamics", version=VERSION, vertices=len(mesh.x),
        cells=len(mesh.cells), recipe=recipe, dt_ms=1e3 * dt, iterations=iterations, law=law,
        load_s=built,
    )  # fmt: skip


if __name__ == "__main__":
    main()
