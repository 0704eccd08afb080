# SPDX-License-Identifier: BSD-3-Clause
"""Solves the finite-element references and writes them as JSON, offline.

    .venv/bin/python tests/references/fill_organs.py
    .venv/bin/python tests/references/solve_references.py block sphere ellipsoid spleen kidney \\
        liver gallbladder stomach

Ten minutes of one processor; palpate_editor.truth solves. Linear truth is P2 on the once refined
mesh, neo-Hookean truth P2 on the mesh itself; the error of both is how much the linear results of
the two meshes differ. P1 on the mesh itself tells what a law costs, apart from what the mesh costs.
core/ACCURACY.md is written again afterwards, from what `palpate study accuracy` prints.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import time
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np
from palpate_editor.truth.elasticity import Body, Diverged, Press, find_lame
from palpate_editor.truth.tetrahedra import MICRON, Floats, Ints
from places import BODIES, Place, Subject

FOLDER = Path(__file__).parents[2] / "bindings/palpate/study/references"
DEPTHS = (0.03, 0.08, 0.15)
"""Of the thickness at the place."""
STEP = 0.05
"""Of the thickness: the largest step from one equilibrium to the next."""
TOOLS = ("scikit-fem", "cvxopt", "numpy", "scipy")


@dataclass(frozen=True)
class Result:
    depth: float
    """[m], negative for a pull."""
    force: float
    """[N] along the press, negative for a pull."""
    displacement: Floats
    """[m] of the vertices of the surface."""


def solve_reference(name: str) -> dict:
    subject = BODIES[name]()
    reference = {
        "format": "palpate-reference",
        "version": 1,
        "name": name,
        "title": subject.title,
        "command": f"tests/references/solve_references.py {name}",
        "tools": {tool: version(tool) for tool in TOOLS},
        "source": subject.source,
        "shape": subject.shape,
        "wall_thickness": subject.wall_thickness,
        "material": {
            "young_modulus": subject.young_modulus,
            "poisson_ratio": subject.poisson_ratio,
        },
        "mesh": write_mesh(subject.x, subject.t),
        "surface": subject.surface.tolist(),
        "held": np.unique(subject.held).tolist(),
        "places": [],
    }
    for place in subject.places:
        start = time.monotonic()
        reference["places"].append(solve_place(subject, place))
        write_reference(reference)
        print(f"{name} {place.name}: {time.monotonic() - start:.0f} s", flush=True)
    return reference


def write_reference(reference: dict) -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / f"{reference['name']}.json"
    path.write_text(json.dumps(reference, separators=(",", ":")) + "\n", encoding="utf-8")


def write_mesh(x: Floats, t: Ints) -> dict:
    vertices = np.rint(x / MICRON).astype("<i4")
    cells = t.astype("<i4")
    return {
        "sha256": hashlib.sha256(vertices.tobytes() + cells.tobytes()).hexdigest(),
        "vertices": vertices.ravel().tolist(),
        "tetrahedra": cells.ravel().tolist(),
    }


def solve_place(subject: Subject, place: Place) -> dict:
    tags = {"held": subject.held, "moved": place.faces}
    lame = find_lame(subject.young_modulus, subject.poisson_ratio)
    depths = DEPTHS
    if place is subject.places[0] and subject.same_mesh_depths:
        depths = subject.same_mesh_depths
    coarse = Press(Body(subject.x, subject.t, lame, 2, 0, tags), "held", "moved")
    fine = Press(Body(subject.x, subject.t, lame, 2, 1, tags), "held", "moved")
    plain = Press(Body(subject.x, subject.t, lame, 1, 0, tags), "held", "moved")
    before, truth = (respond(press, subject, place) for press in (coarse, fine))
    error = {
        "force_error": round(abs(truth.force - before.force) / truth.force, 5),
        "displacement_error": round(
            find_rms(truth.displacement - before.displacement) / truth.depth, 5
        ),
    }
    results = [write_result("linear", "P2", 1, truth) | error]
    results += [
        write_result("neo_hookean", "P2", 0, a) | error
        for a in follow(coarse, subject, place, DEPTHS)
    ]
    results.append(write_result("linear", "P1", 0, respond(plain, subject, place)))
    results += [
        write_result("neo_hookean", "P1", 0, a) for a in follow(plain, subject, place, depths)
    ]
    return {
        "name": place.name,
        "vertices": np.unique(place.faces).tolist(),
        "direction": np.round(place.direction, 6).tolist(),
        "thickness": round(place.thickness, 7),
        "results": results,
    }


def find_rms(u: Floats) -> float:
    return float(np.sqrt((u**2).sum(axis=1).mean()))


def write_result(law: str, elements: str, refinements: int, result: Result) -> dict:
    return {
        "law": law,
        "elements": elements,
        "refinements": refinements,
        "depth": round(result.depth, 9),
        "force": float(f"{result.force:.6g}"),
        "displacement": np.rint(result.displacement / MICRON).astype(int).ravel().tolist(),
    }


def respond(press: Press, subject: Subject, place: Place) -> Result:
    """The linear result at the middle of the depths; others are proportional."""
    depth = DEPTHS[1] * place.thickness
    u = press.respond(-depth * place.direction)
    return build_result(press, subject, place, depth, u, "linear")


def build_result(
    press: Press, subject: Subject, place: Place, depth: float, u: Floats, law: str
) -> Result:
    force = float(-press.force(u, law) @ place.direction)
    return Result(depth, force, u[press.body.vertex_nodes[subject.surface]])


def follow(
    press: Press, subject: Subject, place: Place, depths: tuple[float, ...]
) -> Iterator[Result]:
    """Neo-Hookean results to a press through all depths, then to a pull."""
    unit = press.respond(-place.direction)
    reach = STEP * place.thickness
    for sign in (1.0, -1.0):
        u, there = np.zeros_like(unit), 0.0
        for depth in depths:
            goal = sign * depth * place.thickness
            count = int(np.ceil(abs(goal - there) / reach - 1e-6))
            for following in np.linspace(there, goal, count + 1)[1:]:
                u = go(press, u, unit, there, float(following))
                there = float(following)
            yield build_result(press, subject, place, goal, u, "neo_hookean")


def go(press: Press, u: Floats, unit: Floats, before: float, after: float) -> Floats:
    """Equilibrium at depth `after` from the one at `before`, in halves where it is too far."""
    if abs(after - before) < 1e-6:
        raise Diverged(f"the step from {before:g} to {after:g} m is too hard")
    try:
        return press.balance(u + (after - before) * unit)
    except Diverged:
        middle = 0.5 * (before + after)
        return go(press, go(press, u, unit, before, middle), unit, middle, after)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="+", choices=sorted(BODIES))
    for name in parser.parse_args().names:
        solve_reference(name)


if __name__ == "__main__":
    main()
