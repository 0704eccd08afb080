# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere, a torus and a spleen, whole and damaged in twelve ways each.

Vertices [mm] (n, 3) with the middle in the origin, triangles (t, 3), outside out.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import broken_twins as twins
import numpy as np
import palpate
from broken_twins import Mesh
from palpate_editor.authoring import find_self_intersecting_faces
from palpate_meshes.catalogue import read_organ_mesh
from palpate_meshes.generate import ellipsoid


def make_sphere() -> Mesh:
    x, triangles = ellipsoid(500, radii=(0.03, 0.03, 0.03), bow=0, hollow=0, notches=0)
    return 30.0 * x / np.linalg.norm(x, axis=1, keepdims=True), np.asarray(triangles)


def make_torus(n: int = 40, m: int = 16, ring: float = 30.0, tube: float = 12.0) -> Mesh:
    a, b = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m, indexing="ij")
    r = ring + tube * np.cos(b)
    x = np.stack([r * np.cos(a), r * np.sin(a), tube * np.sin(b)], axis=-1).reshape(-1, 3)
    at = np.arange(n * m).reshape(n, m)
    right, up = np.roll(at, -1, axis=0), np.roll(at, -1, axis=1)
    both = np.roll(right, -1, axis=1)
    quads = np.stack([at, right, both, up], axis=-1).reshape(-1, 4)
    return x, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def make_spleen() -> Mesh:
    """The one that ships."""
    x, triangles = read_organ_mesh("spleen")
    return 1e3 * (x - x.mean(axis=0)), np.asarray(triangles)


def cross(x: np.ndarray, t: np.ndarray, random: np.random.Generator) -> Mesh:
    """One vertex pulled out through the other side; another one where the first crosses nothing."""
    while True:
        y, _ = twins.cross_itself(x.copy(), t, random)
        if find_self_intersecting_faces(palpate.SurfaceMesh(y, t)):
            return y, t


SHAPES: dict[str, Callable[[], Mesh]] = {
    name: cache(make)
    for name, make in (("sphere", make_sphere), ("torus", make_torus), ("spleen", make_spleen))
}
DAMAGES: dict[str, Callable[[np.ndarray, np.ndarray, np.random.Generator], Mesh]] = {
    "holes": twins.punch_holes,
    "flipped": twins.flip_some,
    "doubled": twins.double_some,
    "crossed": cross,
    "non-manifold edge": twins.add_fin,
    "sliver fan": twins.add_slivers,
    "joined at a vertex": twins.join_at_vertex,
    "scale 1000": twins.scale_up,
    "one face missing": twins.miss_one,
    "noise": twins.add_noise,
    "T-junctions": twins.cut_t_junctions,
    "unwelded": twins.unweld,
}
COPIES = {"joined at a vertex": 2.0}
"""Volumes of the shape in what a damage makes of it, where that is not one."""


def damage(shape: str, name: str, seed: int) -> Mesh:
    x, t = SHAPES[shape]()
    return DAMAGES[name](x.copy(), t.copy(), np.random.default_rng([seed, *name.encode()]))


def compute_volume(x: np.ndarray, t: np.ndarray) -> float:
    """[mm³] (or the cube of whatever length `x` has) inside a closed surface."""
    a, b, c = x[t].transpose(1, 0, 2)
    return float((a * np.cross(b, c)).sum() / 6.0)
