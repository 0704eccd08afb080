# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong with stones and scenery of a layout, or good to know of them."""

from __future__ import annotations

import re

import palpate
from palpate.assessment.check_problem import ERROR, NOTE, WARNING, Problem
from palpate.layout.assemble import Assembly
from palpate.layout.document import Layout
from palpate.layout.rest_advice import RestAdvice, advise_rest
from palpate.layout.settle import SETTLED, Rest, Settled, settle
from palpate.runs.alarms import describe_alarm, tell_alarm

ROUGH = 0.15
"""[-] Of a stone's length: a hull that lies deeper in the mesh is seen to."""
AT_REST, FAR, SAGGED, FALLEN = 0.01, 1e-3, 0.01, 0.1
"""[m/s] of what lies still, [m] of what has moved, of what is no longer as it was scanned, and of
what has fallen."""
NUMBERED = re.compile(r"\b(body |scenery |bodies\[|rigid\[|scenery\[)(\d+)(\]?)")
"""A part of a scene by its number, as the core's sentences have it."""


def note_hard_parts(layout: Layout, assembly: Assembly) -> list[Problem]:
    """Of hulls that lie deep in their meshes, and of scenery that stops nothing."""
    problems = []
    for placed, stone in zip(layout.stones, assembly.stones, strict=True):
        deep = stone.hull.deepest
        if deep > ROUGH * stone.length:
            problems.append(
                Problem(WARNING, placed.name,
                        f"its hull of {placed.spheres} spheres lies up to {1e3 * deep:.2f} mm in "
                        f"it, expected at most {1e3 * ROUGH * stone.length:.2f} mm: more spheres, "
                        "or a rounder mesh")
            )  # fmt: skip
    for scenery in layout.scenery:
        if not scenery.stops and layout.bodies:
            problems.append(
                Problem(NOTE, scenery.name,
                        "stops instruments and stones alone: `palpate scene pair LAYOUT "
                        f"{scenery.name} BODY` has it stop a body")
            )  # fmt: skip
    return problems


def find_unsettled(layout: Layout, scene: palpate.Scene, assembly: Assembly) -> list[Problem]:
    """Of stones that float or fall away, and of all that moves before any hand comes."""
    rest = settle(scene)
    if rest.end:
        return [describe_end(scene, rest, advise_rest(assembly))]
    problems = []
    if layout.stones and not any(scene.gravity):
        problems.append(
            Problem(NOTE, "scene",
                    "has no gravity, so stones float: `palpate scene set LAYOUT "
                    "--gravity=0,0,-9.81` gives it one")
        )  # fmt: skip
    for placed, stone in zip(layout.stones, rest.stones, strict=True):
        if stone.speed > AT_REST and stone.moved > FALLEN:
            said = f"{describe(stone)}: it falls, expected something that it lies on"
            problems.append(Problem(WARNING, placed.name, said))
        elif stone.speed > AT_REST or stone.moved > FAR:
            problems.append(Problem(NOTE, placed.name, describe(stone)))
    for organ, body in zip(layout.bodies, rest.bodies, strict=True):
        if body.moved > SAGGED and any(scene.gravity):
            said = (
                f"{describe(body)}, where most, expected at most {1e3 * SAGGED:g} mm: it was "
                "scanned as it lies, and here gravity pulls it down once more; `palpate scene "
                f"place LAYOUT {organ.name} --weightless` takes its shape as the one under its "
                "weight"
            )
            problems.append(Problem(WARNING, organ.name, said))
        elif body.moved > FAR:
            said = f"{describe(body)}, where most: gravity, or what it lies on, moves it"
            problems.append(Problem(NOTE, organ.name, said))
    return problems


def describe_end(scene: palpate.Scene, rest: Rest, advice: RestAdvice | None) -> Problem:
    """Of a run that ends before any hand comes."""
    if advice is None:
        alarm = tell_alarm(rest.end, scene, rest.end_body)
        return Problem(ERROR, "scene", f"without any hand: {alarm}")
    alarm = str(describe_alarm(rest.end))
    said = f"without any hand, with {advice.now} and not with {advice.option}: {alarm}"
    return Problem(ERROR, advice.where, said)


def describe(settled: Settled) -> str:
    return (
        f"within {SETTLED:g} s it goes {1e3 * settled.moved:.1f} mm from where it is placed, and "
        f"moves at {1e3 * settled.speed:.1f} mm/s then"
    )


def name_numbers(layout: Layout, sentence: str) -> str:
    """A sentence of the core with the names of bodies, stones and scenery behind their numbers."""
    fields = {"body ": layout.bodies, "bodies[": layout.bodies, "rigid[": layout.stones,
              "scenery[": layout.scenery, "scenery ": layout.scenery}  # fmt: skip

    def name(found: re.Match[str]) -> str:
        rows, number = fields[found[1]], int(found[2])
        return f"{found[0]} ({rows[number].name})" if number < len(rows) else found[0]

    return NUMBERED.sub(name, sentence)
