# SPDX-License-Identifier: BSD-3-Clause
"""Presses rigid, frictionless balls into bodies and writes the forces as JSON, offline.

    .venv/bin/python tests/references/fill_contacts.py
    build/reference/bin/python tests/references/solve_contacts.py block spleen kidney liver \\
        gallbladder stomach
    build/reference/bin/python tests/references/solve_contacts.py --law neo_hookean block

Elements are P2 on meshes that are graded towards the place. A linear case is solved on finer and
finer ones until its forces change by less than CHANGE, or the finest is reached, and what they
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
from importlib.metadata import version
from pathlib import Path

import numpy as np
from bodies import find_surface
from contact import PENALTY, NoContact, find_touch, press_ball
from contact_bodies import SIZES, SLOPE, SUBJECTS, Spot, Subject
from elasticity import Body, Diverged, Press, find_lame
from neo_contact import follow
from patches import condense, find_footprint

FOLDER = Path(__file__).parents[2] / "bindings/palpate/study/contacts"
RADII = (2e-3, 3e-3, 5e-3, 8e-3)
OWN = {"spleen": 4e-3}
"""[m] The ball of a shipped scene that is none of these."""
PARTS = (0.25, 0.5, 0.75, 1.0)
"""Of the greatest depth."""
OF_THICKNESS, OF_RADIUS = 0.10, 1.5
"""The greatest depth is the smaller of these."""
CHANGE = 0.03
TOOLS = ("scikit-fem", "scikit-sparse", "numpy", "scipy")
LAWS = ("linear", "neo_hookean")


def solve_body(name: str, law: str, radii: list[float], finest: int) -> None:
    subject = SUBJECTS[name]()
    reference = open_reference(name, subject)
    reference["cases"] = [
        case for case in reference["cases"] if case["place"] in {s.name for s in subject.spots}
    ]
    for radius in radii:
        for spot in subject.spots:
            key = digest(subject, spot, law, radius, finest)
            if any(case["key"] == key for case in reference["cases"]):
                continue
            start = time.monotonic()
            try:
                case = solve_case(subject, spot, law, radius, finest)
            except (Diverged, NoContact) as problem:
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


def open_reference(name: str, subject: Subject) -> dict:
    """What is known already, under the head of today."""
    path = FOLDER / f"{name}.json"
    cases = json.loads(path.read_bytes())["cases"] if path.is_file() else []
    return {
        "format": "palpate-contact-reference",
        "version": 1,
        "name": name,
        "title": subject.title,
        "command": f"tests/references/solve_contacts.py {name}",
        "tools": {tool: version(tool) for tool in TOOLS},
        "source": subject.source,
        "shape": subject.shape,
        "wall_thickness": subject.wall_thickness,
        "held": subject.held_by,
        "fixed": None if subject.fixed is None else subject.fixed.tolist(),
        "young_modulus": subject.young_modulus,
        "poisson_ratio": subject.poisson_ratio,
        "places": [
            {
                "name": spot.name,
                "point": round_off(spot.point),
                "direction": round_off(spot.direction),
                "thickness": round_off(spot.thickness),
            }
            for spot in subject.spots
        ],
        "cases": cases,
    }


def write_reference(reference: dict) -> None:
    """A line per case, under a temporary name first, with a hash of what was found."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / f"{reference['name']}.json"
    known = sorted(reference["cases"], key=order)
    head = {k: v for k, v in reference.items() if k != "cases"}
    whole = json.dumps([reference["places"], known], sort_keys=True, separators=(",", ":"))
    head["sha256"] = hashlib.sha256(whole.encode()).hexdigest()
    cases = ",\n  ".join(json.dumps(case) for case in known)
    part = path.with_suffix(".part")
    with part.open("w") as file:
        file.write(f'{json.dumps(head, indent=1)[:-2]},\n "cases": [\n  {cases}\n ]\n}}\n')
        file.flush()
        os.fsync(file.fileno())
    part.replace(path)


def order(case: dict) -> tuple:
    return LAWS.index(case["law"]), case["place"], case["radius"]


def round_off(value):
    return [float(f"{v:.9g}") for v in value] if np.ndim(value) else float(f"{value:.6g}")


def digest(subject: Subject, spot: Spot, law: str, radius: float, finest: int) -> str:
    """Of all that a case depends on."""
    told = [
        law, radius, finest, SIZES, SLOPE, PARTS, PENALTY, subject.young_modulus,
        subject.poisson_ratio, subject.held_by, subject.source, spot.name,
        round_off(spot.point), round_off(spot.direction), round_off(spot.thickness),
    ]  # fmt: skip
    text = json.dumps([*told, subject.shape], default=float)
    for level in range(finest + 1):
        x, t = subject.build(level)
        text += hashlib.sha256(np.rint(1e6 * x).astype("<i4").tobytes()).hexdigest()
        text += hashlib.sha256(t.astype("<i4").tobytes()).hexdigest()
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def solve_case(subject: Subject, spot: Spot, law: str, radius: float, finest: int) -> dict:
    greatest = min(OF_THICKNESS * spot.thickness, OF_RADIUS * radius)
    depths = greatest * np.array(PARTS)
    touch = find_touch(
        subject.surface.x, subject.surface.triangles, spot.point, spot.direction, radius
    )
    last = finest if law == "linear" else 1
    press, found, error = solve_linear_levels(subject, spot, radius, depths, touch, last)
    if law != "linear":
        press = build_press(subject, spot, radius, greatest, 0)
        found = solve_deep(subject, spot, press, radius, depths, touch)
    return {
        "place": spot.name,
        "law": law,
        "radius": radius,
        "touch": round_off(touch),
        "elements": "P2",
        "tetrahedra": int(press.body.basis.mesh.t.shape[1]),
        "freedoms": press.size,
        "results": [
            {
                "depth": round_off(contact.depth),
                "force": round_off(contact.force),
                "contact_radius": float(f"{contact.radius:.4g}"),
                "force_error": float(f"{error[k]:.3g}"),
            }
            for k, contact in enumerate(found)
        ],
    }


def solve_linear_levels(subject, spot, radius, depths, touch, finest):
    """Finer and finer, until forces change by less than CHANGE; what they changed by in the end."""
    before = error = None
    for level in range(finest + 1):
        press = build_press(subject, spot, radius, float(depths[-1]), level)
        found = solve_linear(subject, spot, press, radius, depths, touch)
        force = np.array([contact.force for contact in found])
        if before is not None:
            error = np.abs(force - before) / force
            if error.max() < CHANGE:
                break
        before = force
    return press, found, error


def build_press(subject: Subject, spot: Spot, radius: float, depth: float, level: int) -> Press:
    x, t = subject.grade(spot, radius, depth, level)
    lame = find_lame(subject.young_modulus, subject.poisson_ratio)
    tags = {"held": subject.held(x, find_surface(t))}
    return Press(Body(x, t, lame, 2, 0, tags), "held", "held")


def find_stiffness(subject: Subject, radius: float) -> float:
    """[N/m³] E*/R."""
    return subject.young_modulus / (1.0 - subject.poisson_ratio**2) / radius


def solve_linear(subject, spot, press, radius, depths, touch):
    reach = min(radius, 1.45 * float(np.sqrt(radius * depths[-1])))
    under = find_footprint(press.body, spot.point, spot.direction, reach, radius)
    patch = condense(press, under, spot.point, spot.direction, radius, touch)
    return press_ball(patch, depths, PENALTY * find_stiffness(subject, radius))


def solve_deep(subject, spot, press, radius, depths, touch):
    under = find_footprint(press.body, spot.point, spot.direction, 1.6 * radius, radius)
    return follow(press, under, spot, radius, depths, touch, find_stiffness(subject, radius))


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
