# SPDX-License-Identifier: BSD-3-Clause
"""The common work at equal accuracy: a rigid ball pressed into an organ, held, deeper, held.

Truth is a contact reference (bindings/palpate/study/contacts): force of a frictionless ball at rest
at two depths, in proportion to Young's modulus. An engine's run counts where its mean force over
the end of each hold lies within GATE of it, at both depths. Its cost is processor time of its
thread per simulated second, presses and holds alike.

NumPy and SciPy only: every engine's environment has them.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

GATE = 0.10
"""How far a force may lie from the truth, at each depth."""
APPROACH, RAMP, HOLD = 0.02, 0.15, 0.25
"""[s] From CLEARANCE to the first touch; from depth to depth; at a depth."""
CLEARANCE = 2e-4
"""[m]"""
READ = 0.1
"""[s] at the end of a hold, over which the force is averaged."""
WRECK = 0.05
"""[m] A displacement beyond it is a wreck."""
BUDGET = 150.0
"""[s] of processor time, after which a run is given up; what it had cost per second is told."""


@dataclass(frozen=True)
class Work:
    """A ball, a place, and what a hand should feel."""

    name: str
    title: str
    shipped: str
    """The organ whose surface it has."""
    young_modulus: float
    """[Pa]"""
    poisson_ratio: float
    density: float
    """[kg/m³]"""
    wall_thickness: float | None
    """[m] of a hollow organ; None for a solid."""
    radius: float
    """[m] of the ball."""
    point: tuple[float, ...]
    """[m] (3,) on the surface at rest."""
    direction: tuple[float, ...]
    """Unit (3,), outward: the ball goes against it."""
    depths: tuple[float, ...]
    """[m] of the ball beyond its first touch, rising."""
    forces: tuple[float, ...]
    """[N] truth at the depths."""

    @property
    def duration(self) -> float:
        """[s] from where the ball begins to the end of the last hold."""
        return APPROACH + len(self.depths) * (RAMP + HOLD)

    def place(self, moment: float, touch: float) -> Floats:
        """[m] (3,) the ball's centre at a time [s]; `touch` [m] is its height at first touch."""
        times, sunk = [0.0, APPROACH], [-CLEARANCE, 0.0]
        for depth in self.depths:
            times += [times[-1] + RAMP, times[-1] + RAMP + HOLD]
            sunk += [depth, depth]
        height = touch - float(np.interp(moment, times, sunk))
        return np.array(self.point) + height * np.array(self.direction)

    def find_hold(self, moment: float) -> int | None:
        """Which depth's force is read at a time [s]."""
        for k in range(len(self.depths)):
            end = APPROACH + (k + 1) * (RAMP + HOLD)
            if end - READ < moment <= end + 1e-9:
                return k
        return None


@dataclass(frozen=True)
class Mesh:
    """What an engine is given (organ_meshes.py makes it)."""

    x: Floats
    """[m] (n, 3)"""
    cells: Ints
    """(t, 4) tetrahedra, or (t, 3) triangles of a wall's middle surface."""
    held: Ints
    """Vertices that stand still."""
    touch_faces: float
    """[m] Height of the ball's centre over the place when it first touches the organ's faces."""
    touch_vertices: float
    """[m] The same of its vertices, for engines that touch no more."""

    @property
    def is_shell(self) -> bool:
        """Whether it is a wall's middle surface."""
        return self.cells.shape[1] == 3

    def find_mass(self, work: Work) -> float:
        """[kg] of each vertex, alike: forces at rest do not know it, and the small vertices under
        the ball, were they as light as they are, would ask for shorter steps."""
        a, b, c = (self.x[self.cells[:, k]] - self.x[self.cells[:, 0]] for k in (1, 2, -1))
        if not self.is_shell:
            size = np.abs(np.einsum("ij,ij->i", a, np.cross(b, c))) / 6.0
        else:
            size = 0.5 * np.linalg.norm(np.cross(a, b), axis=1) * float(work.wall_thickness or 0)
        return float(work.density * size.sum() / len(self.x))


@dataclass(frozen=True)
class Engine:
    """One engine with the body in it."""

    step: Callable[[Floats], None]
    """Puts the ball's centre at a point [m] (3,) and advances by one step."""
    force: Callable[[], float]
    """[N] that the ball pushed with against the direction, in the last step."""
    positions: Callable[[], Floats]
    """[m] (n, 3) of the vertices."""
    prepare: Callable[[], None] = lambda: None
    """Called before each step, and no part of its cost: what an engine offers no setting for."""


def read_work(path: Path) -> Work:
    data = json.loads(path.read_text(encoding="utf-8"))
    lists = {key: tuple(value) for key, value in data.items() if isinstance(value, list)}
    return Work(**{**data, **lists})


def name_mesh(folder: Path, work: Work, recipe: str) -> Path:
    """Where the mesh of a recipe is."""
    return folder / f"{work.name}-{recipe.replace(':', '-')}.npz"


def read_mesh(folder: Path, work: Work, recipe: str) -> Mesh:
    with np.load(name_mesh(folder, work, recipe)) as data:
        return Mesh(
            data["x"], data["cells"], data["held"], *(float(height) for height in data["touch"])
        )


def press(engine: Engine, work: Work, rest: Floats, touch: float, dt: float) -> dict:
    """Steps of `dt` [s] over the whole work: forces [N] at the holds, and processor time."""
    count = int(round(work.duration / dt))
    first = int(APPROACH / dt)
    every = max(1, int(2e-3 / dt))
    costs: list[float] = []
    read: list[list[float]] = [[] for _ in work.depths]
    spent = 0.0
    for i in range(count):
        moment = (i + 1) * dt
        centre = work.place(moment, touch)
        engine.prepare()
        start = time.thread_time()
        engine.step(centre)
        cost = time.thread_time() - start
        spent += cost
        if i >= first:
            costs.append(cost)
        hold = work.find_hold(moment)
        if hold is not None:
            read[hold].append(engine.force())
        if i % every == 0:
            moved = np.abs(engine.positions() - rest).max()
            if not moved < WRECK:
                return {"why": f"blew up at {moment:.3f} s"}
        if spent > BUDGET:
            rate = float(np.mean(costs or [cost])) / dt
            return {"why": f"given up at {moment:.3f} s: {rate:.0f} s a simulated second"}
    return {
        "forces": [float(np.mean(part)) for part in read],
        "swing": max(float(np.ptp(part)) / abs(float(np.mean(part)) or 1.0) for part in read),
        "cpu_per_second": float(np.mean(costs)) / dt,
        "median_us": 1e6 * float(np.median(costs)),
        "p99_us": 1e6 * float(np.percentile(costs, 99)),
        "steps": len(costs),
    }


def find_lame(work: Work) -> tuple[float, float]:
    """[Pa] Lame's constants, the shear modulus first."""
    mu = work.young_modulus / (2.0 * (1.0 + work.poisson_ratio))
    return mu, 2.0 * mu * work.poisson_ratio / (1.0 - 2.0 * work.poisson_ratio)


def convert_for_newton(mu: float, lam: float) -> tuple[float, float]:
    """[Pa] What Newton's semi-implicit solver must be given for tissue of Lame's constants.

    Its stress is k_mu F (1 - 1/(|F|² + 1)) + k_lambda (J - 1 - 3/4 k_mu/k_lambda) dJ/dF. At rest
    |F|² = 3, so its shear modulus is 3/4 k_mu; along I the first part adds k_mu/8 to the first
    constant, and d²J/dF² takes 3/4 k_mu away.
    """
    k_mu = 4.0 / 3.0 * mu
    return k_mu, lam + 0.625 * k_mu


def compute_errors(work: Work, forces: list[float]) -> list[float]:
    """[-] of each depth, against the truth."""
    return [felt / true - 1.0 for felt, true in zip(forces, work.forces, strict=True)]


def passes(row: dict) -> bool:
    """Whether the force is near enough to the truth at every depth."""
    return "errors" in row and max(abs(error) for error in row["errors"]) <= GATE


def report(work: Work, row: dict, **about: object) -> None:
    """One line of JSON on standard output."""
    if "forces" in row:
        row = {**row, "errors": compute_errors(work, row["forces"])}
    print(json.dumps({"work": work.name, **about, **row}), flush=True)
