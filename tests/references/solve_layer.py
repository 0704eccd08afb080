# SPDX-License-Identifier: BSD-3-Clause
"""Presses an elastic layer with a flat punch and with a sphere, offline, and writes layer.json.

The layer is P2 and linear, bonded to its base; indenters are smooth, so their forces follow from
the compliance of the points they touch. How wide a sphere touches is what makes its force
greatest at a given depth [Barber74]. Run as solve_references.py.
"""

from __future__ import annotations

import json
from importlib.metadata import version

import numpy as np
from bodies import build_layer
from palpate_editor.truth.elasticity import Body, Press, find_lame
from palpate_editor.truth.tetrahedra import Floats, find_surface
from solve_references import FOLDER, TOOLS

YOUNG_MODULUS, POISSON_RATIO = 5e3, 0.45
RINGS = [0.0, 1.25, 2.5, 3.75, 4.5, 5.0, 5.6, 7.0, 9.5, 14.0, 22.0, 34.0, 50.0]
"""[mm] The punch ends at one of them."""
LEVELS = [0.0, -0.8, -2.0, -4.0, -7.0, -11.0, -17.0, -25.0]
PUNCH, SPHERE = 5e-3, 5e-3
"""[m] Radii of the indenters."""
DEPTHS = (1e-3, 2e-3, 3e-3)
ROUNDED = 2e-6
"""[m] Bodies are rounded to whole micrometres."""
WIDEST = 7e-3
"""[m] The widest contact that is tried."""


def main() -> None:
    x, t = build_layer([1e-3 * r for r in RINGS], [1e-3 * z for z in LEVELS])
    faces = find_surface(t)
    base = faces[(x[faces][:, :, 2] < x[:, 2].min() + 1e-9).all(axis=1)]
    top = faces[(x[faces][:, :, 2] > -1e-9).all(axis=1)]
    body = Body(x, t, find_lame(YOUNG_MODULUS, POISSON_RATIO), 2, 0, {"base": base, "top": top})
    place = body.basis.doflocs.T
    radius = np.hypot(place[:, 0], place[:, 1])
    press = Press(body, "base", "base")
    touched = body.tags["top"][radius[body.tags["top"]] <= WIDEST + ROUNDED]
    compliance = find_compliance(press, touched)
    within = radius[touched]
    inside = within <= PUNCH + ROUNDED
    pushes = np.linalg.solve(compliance[np.ix_(inside, inside)], np.full(inside.sum(), 1e-3))
    layer = {
        "format": "palpate-layer",
        "version": 1,
        "command": "tests/references/solve_layer.py",
        "tools": {tool: version(tool) for tool in TOOLS},
        "material": {"young_modulus": YOUNG_MODULUS, "poisson_ratio": POISSON_RATIO},
        "thickness": -1e-3 * LEVELS[-1],
        "width": 2e-3 * RINGS[-1],
        "tetrahedra": len(t),
        "freedoms": press.size,
        "punch": {"radius": PUNCH, "depth": 1e-3, "force": round_off(pushes.sum())},
        "sphere": {
            "radius": SPHERE,
            "depths": DEPTHS,
            "forces": [round_off(press_sphere(compliance, within, d)) for d in DEPTHS],
        },
        "sink": measure_sink(press, touched[inside], pushes, radius),
    }
    path = FOLDER.parent / "layer.json"
    path.write_text(json.dumps(layer, indent=1) + "\n", encoding="utf-8")
    print(path.read_text(encoding="utf-8"))


def round_off(value: float) -> float:
    return float(f"{value:.6g}")


def find_compliance(press: Press, touched: Floats) -> Floats:
    """[m/N] How far each touched node sinks under a force on each."""
    at = 3 * np.searchsorted(press.free, touched) + 2
    loads = np.zeros((press.size, len(at)))
    loads[at, np.arange(len(at))] = 1.0
    return press.factor(loads)[at]


def press_sphere(compliance: Floats, within: Floats, depth: float) -> float:
    """[N] The greatest force over all widths of the contact."""
    forces = []
    for width in np.unique(np.ceil(within / ROUNDED) * ROUNDED)[1:]:
        inside = within <= width + ROUNDED
        sink = depth - within[inside] ** 2 / (2.0 * SPHERE)
        forces.append(np.linalg.solve(compliance[np.ix_(inside, inside)], sink).sum())
    return float(max(forces))


def measure_sink(press: Press, pushed: Floats, pushes: Floats, radius: Floats) -> dict:
    """The mean sink of the surface under the punch, ring by ring outside of it."""
    load = np.zeros((len(press.free), 3))
    load[np.searchsorted(press.free, pushed), 2] = pushes
    u = press.factor(load.ravel()).reshape(-1, 3)[:, 2]
    top = np.searchsorted(press.free, press.body.tags["top"])
    around = np.round(radius[press.body.tags["top"]], 9)
    distances = [1e-3 * r for r in RINGS if r > 1e3 * PUNCH]
    sinks = [round_off(u[top[np.abs(around - d) < ROUNDED]].mean()) for d in distances]
    return {"distances": [round_off(d) for d in distances], "sinks": sinks}


if __name__ == "__main__":
    main()
