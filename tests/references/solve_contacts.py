# SPDX-License-Identifier: BSD-3-Clause
"""Presses rigid, frictionless balls into bodies and writes the forces as JSON, offline.

    .venv/bin/python tests/references/fill_contacts.py
    .venv/bin/python tests/references/solve_contacts.py block spleen kidney liver gallbladder \\
        stomach
    .venv/bin/python tests/references/solve_contacts.py --law neo_hookean block

Elements are P2 on meshes that are graded towards the place. A linear case is solved on finer and
finer ones until its forces change by less than 3 %, or the finest is reached, and what they
changed by is its error. A neo-Hookean case is solved on the coarsest; its error is how much the
linear forces of the same press change from there. Every finished case is written; a second call
goes on where the first one ended, and solves again what an older mesh, place or body gave.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import time
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

import numpy as np
from contact_bodies import SUBJECTS, Pressed, Spot
from palpate_editor.truth.contact import PENALTY
from palpate_editor.truth.elasticity import Diverged, Press
from palpate_editor.truth.levels import SIZES, SLOPE, Station, build_press, grade
from palpate_editor.truth.neo_contact import Found, follow
from palpate_editor.truth.patches import find_footprint
from palpate_editor.truth.paths import PARTS, Way
from palpate_editor.truth.progress import TruthError
from palpate_editor.truth.solve import solve_way
from palpate_editor.truth.subject import Subject
from palpate_editor.truth.tetrahedra import Floats

CHECKOUT = Path(__file__).parents[2]
FOLDER = CHECKOUT / "bindings/palpate/study/contacts"
ELSEWHERE = {"wall_2mm": CHECKOUT / "tests/bench/accuracy"}
"""Where a body's file goes that is not shipped."""
RADII = (2e-3, 3e-3, 5e-3, 8e-3)
OWN = {"spleen": 4e-3}
"""[m] The ball of a shipped scene that is none of these."""
OF_THICKNESS, OF_RADIUS = 0.10, 1.5
"""The greatest depth is the smaller of these."""
SHALLOW = {"wall_2mm": (0.125, 0.25)}
"""Parts of it, where a body is not pressed farther: the last is a third of this wall."""
TOOLS = ("scikit-fem", "cvxopt", "numpy", "scipy")
LAWS = ("linear", "neo_hookean")


def solve_body(name: str, law: str, radii: list[float], finest: int) -> None:
    pressed = SUBJECTS[name]()
    reference = open_reference(name, pressed)
    reference["cases"] = [
        case for case in reference["cases"] if case["place"] in {s.name for s in pressed.spots}
    ]
    for radius in radii:
        for spot in pressed.spots:
            parts = SHALLOW.get(name, PARTS)
            key = digest(pressed, spot, law, radius, finest, parts)
            if any(case["key"] == key for case in reference["cases"]):
                continue
            start = time.monotonic()
            try:
                case = solve_case(pressed, spot, law, radius, finest, parts)
            except (Diverged, TruthError) as problem:
                print(f"{name} {spot.name} {law} {1e3 * radius:g} mm: {problem}", flush=True)
                continue
            named = (spot.name, law, case["radius"])
            reference["cases"] = [
                other
                for other in reference["cases"]
                if (other["place"], other["law"], other["radius"]) != named
            ] + [{**case, "key": key}]
            write_reference(reference)
            deepest = case["results"][-1]
            print(
                f"{name} {spot.name} {law} {1e3 * radius:g} mm: {1e3 * deepest['depth']:.2f} mm "
                f"{1e3 * deepest['force']:.2f} mN, errors "
                f"{[r['force_error'] for r in case['results']]}, {case['freedoms']} freedoms, "
                f"{time.monotonic() - start:.0f} s",
                flush=True,
            )
    write_reference(reference)


def find_path(name: str) -> Path:
    return ELSEWHERE.get(name, FOLDER) / f"{name}.json"


def open_reference(name: str, pressed: Pressed) -> dict:
    """What is known already, under the head of today."""
    path = find_path(name)
    cases = json.loads(path.read_bytes())["cases"] if path.is_file() else []
    return {
        "format": "palpate-contact-reference",
        "version": 1,
        "name": name,
        "title": pressed.title,
        "command": f"tests/references/solve_contacts.py {name}",
        "tools": {tool: version(tool) for tool in TOOLS},
        "source": pressed.source,
        "shape": pressed.shape,
        "wall_thickness": pressed.subject.wall_thickness,
        "held": pressed.held_by,
        "fixed": None if pressed.fixed is None else pressed.fixed.tolist(),
        "young_modulus": pressed.subject.young_modulus,
        "poisson_ratio": pressed.subject.poisson_ratio,
        "places": [
            {
                "name": spot.name,
                "point": round_off(spot.point),
                "direction": round_off(spot.direction),
                "thickness": round_off(spot.thickness),
            }
            for spot in pressed.spots
        ],
        "cases": cases,
    }


def write_reference(reference: dict) -> None:
    """A line per case, under a temporary name first, with a hash of what was found."""
    path = find_path(reference["name"])
    path.parent.mkdir(parents=True, exist_ok=True)
    known = sorted(reference["cases"], key=order)
    head = {k: v for k, v in reference.items() if k != "cases"}
    whole = json.dumps([reference["places"], known], sort_keys=True, separators=(",", ":"))
    head["sha256"] = hashlib.sha256(whole.encode()).hexdigest()
    cases = ",\n  ".join(json.dumps(case) for case in known)
    part = path.with_suffix(".part")
    with part.open("w", encoding="utf-8") as file:
        file.write(f'{json.dumps(head, indent=1)[:-2]},\n "cases": [\n  {cases}\n ]\n}}\n')
        file.flush()
        os.fsync(file.fileno())
    part.replace(path)


def order(case: dict) -> tuple:
    return LAWS.index(case["law"]), case["place"], case["radius"]


def round_off(value):
    return [float(f"{v:.9g}") for v in value] if np.ndim(value) else float(f"{value:.6g}")


def digest(
    pressed: Pressed, spot: Spot, law: str, radius: float, finest: int, parts: Sequence[float]
) -> str:
    """Of all that a case depends on."""
    told = [
        law, radius, finest, SIZES, SLOPE, parts, PENALTY, pressed.subject.young_modulus,
        pressed.subject.poisson_ratio, pressed.held_by, pressed.source, spot.name,
        round_off(spot.point), round_off(spot.direction), round_off(spot.thickness),
    ]  # fmt: skip
    text = json.dumps([*told, pressed.shape], default=float)
    for level in range(finest + 1):
        x, t = pressed.subject.build(level)
        text += hashlib.sha256(np.rint(1e6 * x).astype("<i4").tobytes()).hexdigest()
        text += hashlib.sha256(t.astype("<i4").tobytes()).hexdigest()
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def solve_case(
    pressed: Pressed, spot: Spot, law: str, radius: float, finest: int, parts: Sequence[float]
) -> dict:
    depths = min(OF_THICKNESS * spot.thickness, OF_RADIUS * radius) * np.array(parts)
    station = spot.stand(pressed.subject, radius)
    way = Way("press", (station,), float(depths[-1]), "")
    last = finest if law == "linear" else 1
    truth = solve_way(pressed.subject, way, radius, depths, "", finest=last)
    found = list(zip(truth.force[0].tolist(), truth.contact_radius[0].tolist(), strict=True))
    freedoms, tetrahedra = truth.freedoms, truth.tetrahedra
    if law != "linear":
        press, contacts = solve_deep(pressed.subject, station, radius, depths)
        found = [(contact.force, contact.radius) for contact in contacts]
        freedoms, tetrahedra = press.size, int(press.body.basis.mesh.t.shape[1])
    return {
        "place": spot.name,
        "law": law,
        "radius": radius,
        "touch": round_off(station.touch),
        "elements": "P2",
        "tetrahedra": tetrahedra,
        "freedoms": freedoms,
        "results": [
            {
                "depth": round_off(depth),
                "force": round_off(force),
                "contact_radius": float(f"{contact_radius:.4g}"),
                "force_error": float(f"{error:.3g}"),
            }
            for depth, (force, contact_radius), error in zip(
                depths, found, truth.force_error[0], strict=True
            )
        ],
    }


def solve_deep(
    subject: Subject, station: Station, radius: float, depths: Floats
) -> tuple[Press, list[Found]]:
    """Neo-Hookean, on the coarsest mesh."""
    x, t = grade(subject, (station,), radius, float(depths[-1]), 0)
    press = build_press(subject, x, t)
    under = find_footprint(press.body, station.point, station.direction, 1.6 * radius, radius)
    stiffness = subject.plane_modulus / radius
    return press, follow(press, under, station, radius, depths, station.touch, stiffness)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="+", choices=sorted(SUBJECTS))
    parser.add_argument("--law", choices=LAWS, default="linear")
    parser.add_argument("--radius", type=float, action="append", metavar="MM", help="of the ball")
    parser.add_argument("--finest", type=int, default=2, choices=range(1, len(SIZES)))
    call = parser.parse_args()
    for name in call.names:
        radii = [*RADII, OWN[name]] if name in OWN else list(RADII)
        if call.radius:
            radii = [1e-3 * radius for radius in call.radius]
        solve_body(name, call.law, radii, call.finest)


if __name__ == "__main__":
    main()
