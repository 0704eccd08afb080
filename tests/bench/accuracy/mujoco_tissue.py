# SPDX-License-Identifier: BSD-3-Clause
"""The common work at equal accuracy in MuJoCo: a flex of tetrahedra, or of triangles with bending.

`mujoco_tissue.py FOLDER WORK RECIPE DT_MS INTEGRATOR DAMPING_MS LAW`. Its elasticity takes Young's
modulus and Poisson's ratio as they are; DAMPING_MS is its Rayleigh damping. LAW of tetrahedra is
stvk, the usual one, or neo_hookean, which only its specification in Python sets. A flex's elements
have a radius; the ball is made smaller by it, and of a wall's middle surface it is half the wall.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import mujoco
import numpy as np
from work import Engine, Mesh, Work, press, read_mesh, read_work, report

FLEX_RADIUS = 1e-5
"""[m] of a tetrahedron's rim."""


ITERATIONS = 200
"""Of its conjugate gradients, at most."""


def write_model(work: Work, mesh: Mesh, dt: float, integrator: str, damping: float) -> str:
    points = " ".join(f"{number:.9g}" for number in mesh.x.ravel())
    cells = " ".join(map(str, mesh.cells.ravel()))
    pins = " ".join(map(str, mesh.held))
    wall = mesh.is_shell
    radius = find_radius(work, mesh)
    thin = f'thickness="{work.wall_thickness}" elastic2d="both"' if wall else ""
    contact = f'condim="1" solref="{max(2.0 * dt, 1e-4):g} 1" solimp="0.998 0.9998 0.00001"'
    return f"""<mujoco>
<option timestep="{dt}" gravity="0 0 0" integrator="{integrator}" solver="CG" cone="pyramidal"
 iterations="{ITERATIONS}" tolerance="1e-8"/>
<size memory="4G"/>
<worldbody>
<body name="ball" mocap="true" pos="0 0 1">
<geom type="sphere" size="{work.radius - (0.0 if wall else radius)}" {contact}/></body>
<flexcomp name="organ" type="direct" dim="{2 if wall else 3}"
 mass="{mesh.find_mass(work) * len(mesh.x)}" radius="{radius}" point="{points}" element="{cells}">
<pin id="{pins}"/>
<elasticity young="{work.young_modulus}" poisson="{work.poisson_ratio}" damping="{damping}" {thin}/>
<contact selfcollide="none" {contact}/></flexcomp>
</worldbody></mujoco>"""


def find_radius(work: Work, mesh: Mesh) -> float:
    return 0.5 * float(work.wall_thickness or 0) if mesh.is_shell else FLEX_RADIUS


def build_engine(
    work: Work, mesh: Mesh, dt: float, integrator: str, damping: float, law: str
) -> Engine:
    spec = mujoco.MjSpec.from_string(write_model(work, mesh, dt, integrator, damping))
    spec.flexes[0].elastic3d = int(law == "neo_hookean")
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    outward = np.array(work.direction)
    wrench = np.zeros(6)
    unstable = data.warning[mujoco.mjtWarning.mjWARN_BADQACC]

    def step(centre: np.ndarray) -> None:
        data.mocap_pos[0] = centre
        mujoco.mj_step(model, data)

    def force() -> float:
        total = 0.0
        for i in range(data.ncon):
            mujoco.mj_contactForce(model, data, i, wrench)
            total += wrench[0] * abs(float(data.contact.frame[i, :3] @ outward))
        return total

    def positions() -> np.ndarray:
        # it resets itself where it was unstable
        return np.full((1, 3), np.nan) if unstable.number else data.flexvert_xpos

    return Engine(step, force, positions)


def main() -> None:
    folder, name, recipe = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    dt, integrator, damping = 1e-3 * float(sys.argv[4]), sys.argv[5], 1e-3 * float(sys.argv[6])
    law = sys.argv[7]
    work = read_work(folder / f"{name}.json")
    mesh = read_mesh(folder, work, recipe)
    began = time.perf_counter()
    engine = build_engine(work, mesh, dt, integrator, damping, law)
    built = time.perf_counter() - began
    row = press(engine, work, np.array(engine.positions()), mesh.touch_faces, dt)
    report(
        work, row, engine="MuJoCo", version=mujoco.__version__, vertices=len(mesh.x),
        cells=len(mesh.cells), recipe=recipe, dt_ms=1e3 * dt, integrator=integrator,
        damping_ms=1e3 * damping, law=law, load_s=built,
    )  # fmt: skip


if __name__ == "__main__":
    main()
