# SPDX-License-Identifier: GPL-3.0-or-later
"""Twins of what files of others were seen to be: damaged surfaces, and files that are odd."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from broken_twins import DAMAGES, Random, make_organ, make_twin
from foreign_files import numbers, write_obj, write_stl


def write_polygons(path: Path, random: Random) -> Path:
    """A drum with two sides of two hundred corners."""
    n, radius = 200, random.uniform(20.0, 40.0)
    angle = 2.0 * np.pi * np.arange(n) / n
    ring = radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    x = np.concatenate([np.column_stack([ring, np.full(n, z)]) for z in (-15.0, 15.0)])
    after = np.roll(np.arange(n), -1)
    sides = np.column_stack([np.arange(n), after, after + n, np.arange(n) + n])
    faces = [*sides.tolist(), list(range(n))[::-1], list(range(n, 2 * n))]
    lines = [f"v {numbers(p)}" for p in x]
    lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in faces]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def write_trailing(path: Path, random: Random) -> Path:
    """A binary STL with bytes after its last triangle."""
    path = path.with_suffix(".stl")
    write_stl(path, *make_organ(random), trailing=int(random.integers(1, 60)))
    return path


def write_normal_zero(path: Path, random: Random) -> Path:
    """Faces that name a normal with the number 0, which no file has."""
    x, t = make_organ(random)
    lines = [f"v {numbers(p)}" for p in x] + ["vn 0 0 1"]
    lines += ["f {}//0 {}//0 {}//0".format(*face) for face in (t + 1).tolist()]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def write_in(scale: float) -> Callable[[Path, Random], Path]:
    """The same organ in another unit, of which nothing in the file tells."""

    def write(path: Path, random: Random) -> Path:
        x, t = make_organ(random)
        write_obj(path, scale * x, t)
        return path

    return write


ODD_FILES: dict[str, Callable[[Path, Random], Path]] = {
    "polygons of 200 sides": write_polygons,
    "bytes after the end": write_trailing,
    "normal 0": write_normal_zero,
    "metres": write_in(1e-3),
    "centimetres": write_in(0.1),
}
CLASSES = (*DAMAGES, *ODD_FILES)


def write_twin(name: str, seed: int, folder: Path) -> Path:
    path = folder / f"{seed}.obj"
    if name in ODD_FILES:
        return ODD_FILES[name](path, np.random.default_rng([seed, *name.encode()]))
    write_obj(path, *make_twin(name, seed))
    return path
