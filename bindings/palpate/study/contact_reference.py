# SPDX-License-Identifier: BSD-3-Clause
"""Forces of rigid, frictionless balls in bodies of tissue, solved offline and kept as files.

tests/references/solve_contacts.py makes them; each file says the call. Nothing here solves.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from palpate.files.json_part import is_whole, read_part
from palpate.files.refusal import Refusal
from palpate.study.reference import LAWS, Shape

FOLDER = Path(__file__).parent / "contacts"
FORMAT, VERSION = "palpate-contact-reference", 1


@dataclass(frozen=True)
class Spot:
    """Where a ball is pressed, and from where."""

    name: str
    point: tuple[float, ...]
    """[m] (3,) on the surface at rest."""
    direction: tuple[float, ...]
    """Unit, outward: the ball goes against it."""
    thickness: float
    """[m] of the body under the place; a hollow one with its far wall."""


@dataclass(frozen=True)
class Result:
    """A ball at rest."""

    depth: float
    """[m] of the ball beyond its first touch."""
    force: float
    """[N] along the press."""
    contact_radius: float
    """[m] of the circle that has the area of the contact; neo-Hookean, how far from the axis the
    ball is touched at most."""
    force_error: float
    """[-] of the force: what the last refinement of the linear problem changed."""


@dataclass(frozen=True)
class Head:
    """A ball pressed at a place: a case of a file, but for its results."""

    place: str
    law: str
    """linear: small displacements, the force along the press; or neo_hookean."""
    radius: float
    """[m] of the ball."""
    touch: float
    """[m] Height of the ball's centre over the place when it first touches the surface."""
    elements: str
    tetrahedra: int
    freedoms: int
    key: str
    """Of all that the case depends on; the solver goes by it."""


@dataclass(frozen=True)
class Case(Head):
    """A ball pressed at a place, to several depths."""

    results: tuple[Result, ...]

    def find_force(self, depth: float) -> float:
        """[N] at a depth [m] up to the last, between the results as d^1.5 times a line.

        Raises:
            ValueError: where the depth is beyond what was solved.
        """
        depths = np.array([result.depth for result in self.results])
        if not 0.0 < depth <= depths[-1] * (1.0 + 1e-6):
            raise ValueError(
                f"depth: got {1e3 * depth:g} mm, expected up to {1e3 * depths[-1]:g} mm"
            )
        factor = [result.force / result.depth**1.5 for result in self.results]
        return float(np.interp(depth, depths, factor)) * depth**1.5


@dataclass(frozen=True)
class ContactReference:
    """A body and the balls that were pressed into it."""

    name: str
    title: str
    command: str
    source: str
    """What the mesh was made by."""
    shape: Shape | None
    """None for a body that a formula makes."""
    wall_thickness: float | None
    """[m] of a hollow body; None for a solid."""
    held: str
    """What of it is held."""
    fixed: tuple[int, ...] | None
    """Vertices of the shipped surface that are held; None for a body that a formula makes."""
    young_modulus: float
    """[Pa]"""
    poisson_ratio: float
    places: tuple[Spot, ...]
    cases: tuple[Case, ...]

    def find_place(self, name: str) -> Spot:
        """Raises KeyError."""
        for spot in self.places:
            if spot.name == name:
                return spot
        raise KeyError(f"{self.name}: no place {name!r}")

    def list_cases(self, law: str) -> list[Case]:
        return [case for case in self.cases if case.law == law]


def list_contact_references() -> list[str]:
    return sorted(path.stem for path in FOLDER.glob("*.json"))


def read_contact_reference(name: str) -> ContactReference:
    """A reference of ours by name. Raises Refusal or OSError."""
    path = FOLDER / f"{name}.json"
    if not path.is_file():
        expected = "one of " + ", ".join(list_contact_references())
        raise Refusal(None, "contact reference", repr(name), expected)
    return read_contact_file(path)


def read_contact_file(path: Path) -> ContactReference:
    """Checked field by field and against its hash. Raises Refusal or OSError."""
    try:
        data = json.loads(path.read_bytes())
    except ValueError as problem:
        raise Refusal(path, "", f"no JSON: {problem}", "a contact reference") from None
    if not isinstance(data, dict):
        raise Refusal(path, "", type(data).__name__, "an object")
    if (data.get("format"), data.get("version")) != (FORMAT, VERSION):
        found = f"{data.get('format')!r}, version {data.get('version')!r}"
        raise Refusal(path, "format", found, f"{FORMAT!r}, version {VERSION}")
    places, cases = (need(path, data, name, list) for name in ("places", "cases"))
    whole = json.dumps([places, cases], sort_keys=True, separators=(",", ":"))
    found = hashlib.sha256(whole.encode()).hexdigest()
    told = need(path, data, "sha256", str)
    if found != told:
        raise Refusal(path, "sha256", found[:12] + "...", told[:12] + "...")
    shape = data.get("shape")
    reference = ContactReference(
        **{name: need(path, data, name, str) for name in ("name", "title", "command", "source")},
        shape=None if shape is None else read_part(path, "shape", Shape, shape, whole=True),
        wall_thickness=None
        if data.get("wall_thickness") is None
        else need(path, data, "wall_thickness", float),
        held=need(path, data, "held", str),
        fixed=read_fixed(path, data.get("fixed")),
        young_modulus=need(path, data, "young_modulus", float),
        poisson_ratio=need(path, data, "poisson_ratio", float),
        places=tuple(
            read_part(path, f"places[{i}]", Spot, part, whole=True) for i, part in enumerate(places)
        ),
        cases=tuple(read_case(path, f"cases[{i}]", part) for i, part in enumerate(cases)),
    )
    check(path, reference)
    return reference


def need(path: Path, data: dict[str, Any], name: str, kind: type) -> Any:
    """A field of the head. Raises Refusal."""
    value = data.get(name)
    if not isinstance(value, kind) or isinstance(value, bool):
        expected = {float: "a number", str: "text", list: "a list"}[kind]
        raise Refusal(path, name, json.dumps(value)[:40], expected)
    return value


def read_fixed(path: Path, data: Any) -> tuple[int, ...] | None:
    if data is None:
        return None
    if not isinstance(data, list) or not all(map(is_whole, data)):
        raise Refusal(path, "fixed", json.dumps(data)[:40], "a list of whole numbers, or null")
    return tuple(data)


def read_case(path: Path, where: str, data: Any) -> Case:
    if not isinstance(data, dict) or not isinstance(data.get("results"), list):
        raise Refusal(path, f"{where}.results", "nothing", "a list")
    results = tuple(
        read_part(path, f"{where}.results[{i}]", Result, part, whole=True)
        for i, part in enumerate(data["results"])
    )
    head = {name: value for name, value in data.items() if name != "results"}
    case = read_part(path, where, Head, head, whole=True)
    return Case(**vars(case), results=results)


def check(path: Path, reference: ContactReference) -> None:
    """What belongs together. Raises Refusal."""
    places = {spot.name for spot in reference.places}
    seen: set[tuple[str, str, float]] = set()
    for i, case in enumerate(reference.cases):
        where, named = f"cases[{i}]", (case.place, case.law, case.radius)
        if case.place not in places:
            raise Refusal(path, f"{where}.place", repr(case.place), "a place of the file")
        if case.law not in LAWS:
            raise Refusal(path, f"{where}.law", repr(case.law), "one of " + ", ".join(LAWS))
        if named in seen:
            raise Refusal(path, where, "a case a second time", "each place, law and radius once")
        seen.add(named)
        steps: NDArray[np.float64] = np.array([[r.depth, r.force] for r in case.results])
        rises = np.diff(steps, axis=0, prepend=0.0) > 0.0
        if case.law != "linear":  # a narrow part that snaps aside pushes less
            rises[:, 1] = steps[:, 1] > 0.0
        if not len(steps) or not rises.all():
            raise Refusal(path, f"{where}.results", "depths or forces", "rising ones, above 0")
