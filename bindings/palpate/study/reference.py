# SPDX-License-Identifier: BSD-3-Clause
"""Finite-element results to presses and pulls, solved offline and kept as files.

tests/references/solve_references.py makes them; each file says the call. Nothing here solves.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from palpate.files.refusal import Refusal

FOLDER = Path(__file__).parent / "references"
FORMAT, VERSION = "palpate-reference", 1
MICRON = 1e-6
LAWS = ("linear", "neo_hookean")
ELEMENTS = ("P1", "P2")


@dataclass(frozen=True)
class Result:
    """What a body does when a patch of it is moved along its normal."""

    law: str
    elements: str
    """P1 or P2 tetrahedra, on the mesh itself or refined so many times."""
    refinements: int
    depth: float
    """[m], negative for a pull."""
    force: float
    """[N] along the press, negative for a pull."""
    displacement: NDArray[np.float64]
    """[m] (s, 3) of the vertices of the surface."""
    force_error: float | None
    """[-] of the force, that the mesh leaves; None where the mesh itself is meant."""
    displacement_error: float | None
    """[-] of the depth, root mean square over the surface."""


@dataclass(frozen=True)
class Shape:
    """The shipped surface that a body was made from."""

    file: str
    """In meshes/published."""
    sha256: str


@dataclass(frozen=True)
class Place:
    """A patch that is moved as a whole, and what came of it."""

    name: str
    vertices: NDArray[np.int32]
    direction: NDArray[np.float64]
    """Unit, outward."""
    thickness: float
    """[m] of the body under the patch."""
    results: tuple[Result, ...]

    def find(self, law: str, elements: str, depth: float | None = None) -> Result:
        """The result at a depth [m]; linear ones are known at every depth. Raises KeyError."""
        for result in self.results:
            if (result.law, result.elements) != (law, elements):
                continue
            if depth is None or abs(result.depth - depth) < 1e-6:
                return result
            if law == "linear":
                return scale(result, depth)
        raise KeyError(f"{self.name}: no result of {elements} {law} at {depth} m")

    def list_parts(self, law: str, elements: str) -> list[float]:
        """Depths over the thickness that have an result, in the order of the file."""
        return [
            round(result.depth / self.thickness, 3)
            for result in self.results
            if (result.law, result.elements) == (law, elements)
        ]


def scale(result: Result, depth: float) -> Result:
    """A linear result at another depth [m]."""
    part = depth / result.depth
    return Result(
        result.law,
        result.elements,
        result.refinements,
        depth,
        part * result.force,
        part * result.displacement,
        result.force_error,
        result.displacement_error,
    )


@dataclass(frozen=True)
class Reference:
    """A body of tetrahedra and its results."""

    name: str
    title: str
    command: str
    source: str
    """What the mesh was made by."""
    shape: Shape | None
    """Of a shipped organ; None for a body that a formula makes."""
    young_modulus: float
    """[Pa]"""
    poisson_ratio: float
    wall_thickness: float | None
    """[m] of a hollow body, whose mesh is its wall; None for a solid."""
    vertices: NDArray[np.float64]
    """[m] (n, 3)"""
    tetrahedra: NDArray[np.int32]
    """(t, 4), of positive volume"""
    surface: NDArray[np.int32]
    """Vertices on the surface, ascending: the rows of every displacement."""
    held: NDArray[np.int32]
    places: tuple[Place, ...]


@dataclass(frozen=True)
class Layer:
    """A layer on a rigid base under smooth indenters, linear, by finite elements."""

    young_modulus: float
    """[Pa]"""
    poisson_ratio: float
    thickness: float
    """[m]"""
    punch_radius: float
    """[m]"""
    punch_depth: float
    """[m]"""
    punch_force: float
    """[N]"""
    sphere_radius: float
    """[m]"""
    sphere_depths: NDArray[np.float64]
    """[m]"""
    sphere_forces: NDArray[np.float64]
    """[N]"""
    sink_distances: NDArray[np.float64]
    """[m] from the middle of the punch."""
    sinks: NDArray[np.float64]
    """[m] of the surface there under the punch."""


def read_layer() -> Layer:
    """What tests/references/solve_layer.py found."""
    data = json.loads((Path(__file__).parent / "layer.json").read_bytes())
    punch, sphere, sink = data["punch"], data["sphere"], data["sink"]
    return Layer(
        young_modulus=data["material"]["young_modulus"],
        poisson_ratio=data["material"]["poisson_ratio"],
        thickness=data["thickness"],
        punch_radius=punch["radius"],
        punch_depth=punch["depth"],
        punch_force=punch["force"],
        sphere_radius=sphere["radius"],
        sphere_depths=np.array(sphere["depths"]),
        sphere_forces=np.array(sphere["forces"]),
        sink_distances=np.array(sink["distances"]),
        sinks=np.array(sink["sinks"]),
    )


def list_references() -> list[str]:
    return sorted(path.stem for path in FOLDER.glob("*.json"))


def read_reference(name: str) -> Reference:
    """A reference of ours by name, checked against its hash. Raises Refusal or OSError."""
    path = FOLDER / f"{name}.json"
    if not path.is_file():
        raise Refusal(None, "reference", repr(name), "one of " + ", ".join(list_references()))
    data = json.loads(path.read_bytes())
    if (data.get("format"), data.get("version")) != (FORMAT, VERSION):
        found = f"{data.get('format')!r}, version {data.get('version')!r}"
        raise Refusal(path, "format", found, f"{FORMAT!r}, version {VERSION}")
    vertices, tetrahedra = read_mesh(path, data["mesh"])
    return Reference(
        name=data["name"],
        title=data["title"],
        command=data["command"],
        source=data["source"],
        shape=None if data["shape"] is None else Shape(**data["shape"]),
        young_modulus=data["material"]["young_modulus"],
        poisson_ratio=data["material"]["poisson_ratio"],
        wall_thickness=data["wall_thickness"],
        vertices=vertices,
        tetrahedra=tetrahedra,
        surface=np.array(data["surface"], dtype=np.int32),
        held=np.array(data["held"], dtype=np.int32),
        places=tuple(map(read_place, data["places"])),
    )


def read_mesh(path: Path, data: dict[str, Any]) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    vertices = np.array(data["vertices"], dtype="<i4").reshape(-1, 3)
    tetrahedra = np.array(data["tetrahedra"], dtype="<i4").reshape(-1, 4)
    found = hashlib.sha256(vertices.tobytes() + tetrahedra.tobytes()).hexdigest()
    if found != data["sha256"]:
        raise Refusal(path, "mesh.sha256", found[:12] + "...", data["sha256"][:12] + "...")
    return MICRON * vertices, tetrahedra


def read_place(data: dict[str, Any]) -> Place:
    return Place(
        name=data["name"],
        vertices=np.array(data["vertices"], dtype=np.int32),
        direction=np.array(data["direction"]),
        thickness=data["thickness"],
        results=tuple(map(read_result, data["results"])),
    )


def read_result(data: dict[str, Any]) -> Result:
    return Result(
        law=data["law"],
        elements=data["elements"],
        refinements=data["refinements"],
        depth=data["depth"],
        force=data["force"],
        displacement=MICRON * np.array(data["displacement"], dtype=float).reshape(-1, 3),
        force_error=data.get("force_error"),
        displacement_error=data.get("displacement_error"),
    )
