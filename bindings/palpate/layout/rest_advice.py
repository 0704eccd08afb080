# SPDX-License-Identifier: BSD-3-Clause
"""Which constant of a scene's surroundings, or of a stone, is wrong where a run ends before any
hand comes, and the nearest value with which it does not."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from palpate.layout.assemble import Assembly, build
from palpate.layout.nearest_value import find_nearest_value
from palpate.layout.settle import settle

FAR = 5.0
"""[-] Times what is usual, or less: a constant nearer to that is not tried."""
STONE, WATER, VISCOSITY, GRAVITY = 2000.0, 1000.0, 1e-3, 9.81
"""[kg/m³], [kg/m³], [Pa s], [m/s²] What is usual."""


@dataclass(frozen=True)
class RestAdvice:
    """A constant, and a value with which the scene rests."""

    where: str
    """The stone, or "scene"."""
    now: str
    option: str
    """As `palpate scene place` or `set` takes them."""


@dataclass(frozen=True)
class Candidate:
    """A constant that is far from what is usual."""

    where: str
    value: float
    usual: float
    put: Callable[[float], Assembly]
    write: Callable[[float], str]

    @property
    def excess(self) -> float:
        """[-] Times farther than what is usual."""
        return max(self.value / self.usual, self.usual / self.value)


def advise_rest(assembly: Assembly) -> RestAdvice | None:
    """What alone lets the scene rest, the least usual first; None where nothing does. Runs a second
    of it some times."""
    candidates = [each for each in list_candidates(assembly) if each.excess > FAR]
    for candidate in sorted(candidates, key=lambda each: -each.excess):

        def rests(value: float, candidate: Candidate = candidate) -> bool | None:
            try:
                return not settle(build(candidate.put(value))).end or None
            except ValueError:
                return None

        found = find_nearest_value(rests, candidate.value, candidate.usual)
        if found is not None:
            write = candidate.write
            return RestAdvice(candidate.where, write(candidate.value), write(found[0]))
    return None


def list_candidates(assembly: Assembly) -> Iterator[Candidate]:
    """Those that are not 0."""
    layout = assembly.layout
    for number, placed in enumerate(layout.stones):
        yield Candidate(
            placed.name, placed.density, STONE,
            lambda value, number=number: with_density(assembly, number, value),
            lambda value: f"--density {value:.2g}kg/m3",
        )  # fmt: skip
    density, viscosity = layout.fluid
    if layout.stones and density:
        yield Candidate(
            "scene", density, WATER, lambda value: with_fluid(assembly, value, viscosity),
            lambda value: f"--fluid {value:.2g},{viscosity:.2g}",
        )  # fmt: skip
    if layout.stones and viscosity:
        yield Candidate(
            "scene", viscosity, VISCOSITY, lambda value: with_fluid(assembly, density, value),
            lambda value: f"--fluid {density:.2g},{value:.2g}",
        )  # fmt: skip
    if layout.gravity and any(layout.gravity):
        yield Candidate(
            "scene", float(np.linalg.norm(layout.gravity)), GRAVITY,
            lambda value: with_gravity(assembly, value),
            lambda value: "--gravity=" + ",".join(f"{g:.2g}" for g in scale(assembly, value)),
        )  # fmt: skip


def with_density(assembly: Assembly, number: int, density: float) -> Assembly:
    """Of a stone [kg/m³]."""
    stones = list(assembly.stones)
    body = copy.copy(stones[number].body)
    part = density / assembly.layout.stones[number].density
    body.mass, body.inertia = part * body.mass, part * np.asarray(body.inertia)
    stones[number] = replace(stones[number], body=body)
    return replace(assembly, stones=stones)


def with_fluid(assembly: Assembly, density: float, viscosity: float) -> Assembly:
    return replace(assembly, layout=replace(assembly.layout, fluid=(density, viscosity)))


def with_gravity(assembly: Assembly, size: float) -> Assembly:
    """[m/s²] In the direction that it has."""
    return replace(assembly, layout=replace(assembly.layout, gravity=scale(assembly, size)))


def scale(assembly: Assembly, size: float) -> tuple[float, float, float]:
    x, y, z = (size / np.linalg.norm(assembly.layout.gravity)) * np.array(assembly.layout.gravity)
    return float(x), float(y), float(z)
