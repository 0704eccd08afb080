# SPDX-License-Identifier: BSD-3-Clause
"""The common work in MuJoCo: a flex of edges, three slide joints a vertex, Euler's step.

`mujoco_engine.py N DT_MS`. Homes are the joints' own springs. Its contact is a soft constraint,
here as hard as a step allows (a time constant of two steps). A flex's vertices have a radius; the
ball is made smaller by it.
"""

from __future__ import annotations

import sys

import mujoco
from body import RADIUS, STIFFNESS, Body, build_body, place_ball
from press import Engine, report

FLEX_RADIUS = 5e-4
"""[m]"""


def write_model(body: Body, dt: float) -> str:
    points = " ".join(f"{number:.9g}" for number in body.x.ravel())
    edges = " ".join(map(str, body.edges.ravel()))
    pins = " ".join(map(str, body.fixed))
    contact = f'condim="1" solref="{2.0 * dt:g} 1"'
    return f"""<mujoco>
<option timestep="{dt}" gravity="0 0 0" integrator="Euler" solver="CG" cone="pyramidal"
 iterations="50" tolerance="1e-6"/>
<size memory="2G"/>
<worldbody>
<body name="ball" mocap="true" pos="0 0 {place_ball(0.0)}">
<geom type="sphere" size="{RADIUS - FLEX_RADIUS}" {contact}/></body>
<flexcomp name="shell" type="direct" dim="1" mass="{body.mass * body.vertices}"
 radius="{FLEX_RADIUS}" point="{points}" element="{edges}">
<pin id="{pins}"/><edge stiffness="{STIFFNESS}" damping="{body.damping}"/>
<contact selfcollide="none" {contact}/></flexcomp>
</worldbody></mujoco>"""


def build_engine(body: Body, dt: float) -> Engine:
    model = mujoco.MjModel.from_xml_string(write_model(body, dt))
    model.jnt_stiffness[:] = body.home
    model.qpos_spring[:] = 0.0
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)

    def step(height: float) -> None:
        data.mocap_pos[0, 2] = height
        mujoco.mj_step(model, data)

    return Engine(step, lambda: data.flexvert_xpos.copy(), lambda: data.ncon)


if __name__ == "__main__":
    count, dt = int(sys.argv[1]), 1e-3 * float(sys.argv[2])
    body = build_body(count)
    report("MuJoCo", build_engine(body, dt), body, dt, version=mujoco.__version__)
