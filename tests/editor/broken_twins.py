# SPDX-License-Identifier: GPL-3.0-or-later
"""An organ damaged in every way that files of others were seen to be, another one for each seed.

Each damage takes vertices [mm] (n, 3), triangles (t, 3) and a random generator, and gives both
back.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from palpate_meshes.generate import ellipsoid

Mesh = tuple[np.ndarray, np.ndarray]
Random = np.random.Generator
EDGE = 5.0
"""[mm] about that of the organ that is damaged."""


def make_organ(random: Random) -> Mesh:
    """A lumpy ellipsoid of a few centimetres, outside out."""
    radii = random.uniform(0.02, 0.04, 3)
    x, triangles = ellipsoid(500, radii=tuple(radii), bow=0, hollow=0, notches=0)
    lump = 1.0 + 0.06 * np.sin(x @ random.uniform(-80, 80, (3, 3)) + random.uniform(0, 6, 3))
    return 1e3 * x * lump, np.asarray(triangles)


def join(*meshes: Mesh) -> Mesh:
    first = np.cumsum([0] + [len(x) for x, _ in meshes])
    triangles = [t + k for (_, t), k in zip(meshes, first, strict=False)]
    return np.concatenate([x for x, _ in meshes]), np.concatenate(triangles)


def punch_holes(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    for middle in x[random.choice(len(x), 4, replace=False)]:
        t = t[np.linalg.norm(x[t].mean(axis=1) - middle, axis=1) > 1.2 * EDGE]
    return x, t


def miss_one(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    return x, np.delete(t, random.integers(len(t)), axis=0)


def flip_some(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    some = random.random(len(t)) < 0.3
    t[some] = t[some][:, ::-1]
    return x, t


def turn_inside_out(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    del random
    return x, t[:, ::-1]


def double_some(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    return x, np.concatenate([t, t[random.random(len(t)) < 0.2]])


def unweld(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    del random
    return x[t].reshape(-1, 3), np.arange(3 * len(t)).reshape(-1, 3)


def add_fin(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """Triangles that stand on edges: three at each."""
    rows = random.choice(len(t), 9, replace=False)
    tips = x[t[rows][:, :2]].mean(axis=1) * 1.3
    fins = np.column_stack([t[rows][:, :2], len(x) + np.arange(len(rows))])
    return np.concatenate([x, tips]), np.concatenate([t, fins])


def share_wall(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """A part within it that shares some of its surface, as parts of an atlas do: a disc from the
    inside of the organ closes a cap of it, three triangles at every edge of the cap's rim."""
    pole = x[random.integers(len(x))]
    near = x[t].mean(axis=1) @ pole > 0.6 * (pole @ pole)
    sides = np.concatenate([t[near][:, [0, 1]], t[near][:, [1, 2]], t[near][:, [2, 0]]])
    _, first, times = np.unique(np.sort(sides, axis=1), axis=0, return_index=True,
                                return_counts=True)  # fmt: skip
    rim = sides[first[times == 1]]
    middle = x[rim].mean(axis=(0, 1)) * 0.95
    fan = np.column_stack([rim[:, ::-1], np.full(len(rim), len(x))])
    return np.vstack([x, middle]), np.concatenate([t, fan])


def touch_along_edges(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """The surface of voxels, which hang together by single edges as well."""
    del x, t
    solid = np.zeros((8, 8, 8), bool)
    at = np.indices((6, 6, 6)).transpose(1, 2, 3, 0) - 2.5
    solid[1:7, 1:7, 1:7] = np.linalg.norm(at / random.uniform(1.9, 2.6, 3), axis=3) < 1.0
    free = np.argwhere(~solid)
    for cell in free[random.permutation(len(free))]:
        others = [cell + d for d in ([1, 1, 0], [0, 1, 1], [1, 0, 1])]
        if any((o < 8).all() and solid[tuple(o)] for o in others):
            solid[tuple(cell)] = True
            if random.random() < 0.2:
                break
    return build_voxels(solid, 6.0)


def build_voxels(solid: np.ndarray, size: float) -> Mesh:
    """The surface of voxels, with the vertices of neighbours shared, as segmentations have."""
    number: dict[tuple[int, ...], int] = {}
    triangles = []
    whole = np.pad(solid, 1)
    axes = np.eye(3, dtype=int)
    for cell in np.argwhere(whole):
        for axis in range(3):
            for side in (0, 1):
                if whole[tuple(cell + (2 * side - 1) * axes[axis])]:
                    continue
                u, v = axes[(axis + 1) % 3], axes[(axis + 2) % 3]
                first = cell + side * axes[axis]
                corners = [first, first + u, first + u + v, first + v]
                ids = [number.setdefault(tuple(c.tolist()), len(number)) for c in corners]
                ids = ids if side else ids[::-1]
                triangles += [ids[:3], [ids[0], ids[2], ids[3]]]
    return size * (np.array(list(number), float) - 1.0), np.array(triangles)


def nest_parts(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """Smaller copies within it that reach through its surface."""
    shifts = random.uniform(-0.3, 0.3, (3, 3)) * np.ptp(x, axis=0)
    return join((x, t), *((0.8 * x + shift, t) for shift in shifts))


def cross_itself(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """One vertex pulled out through the other side."""
    i = random.integers(len(x))
    x[i] = -1.2 * x[i]
    return x, t


def join_at_vertex(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """Two shells with one vertex in common."""
    tip = int(random.choice([x[:, 0].argmax(), x[:, 1].argmax(), x[:, 2].argmax()]))
    other, u = join((x, t), (2.0 * x[tip] - x, t[:, ::-1]))
    u[u == len(x) + tip] = tip
    return other, u


def add_specks(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """Islands of some micrometres."""
    specks = [(2e-4 * x + 1.5 * p, t) for p in x[random.choice(len(x), 5)]]
    return join((x, t), *specks)


def add_slivers(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """A fan of needles in the place of some triangles, all but flat."""
    rows = random.choice(len(t), 12, replace=False)
    middles = x[t[rows][:, :2]].mean(axis=1) + 1e-5 * (x[t[rows][:, 2]] - x[t[rows][:, 0]])
    ids = len(x) + np.arange(len(rows))
    i, j, k = t[rows].T
    fan = [np.column_stack(c) for c in ((i, j, ids), (j, k, ids), (k, i, ids))]
    return np.concatenate([x, middles]), np.concatenate([np.delete(t, rows, axis=0), *fan])


def cut_t_junctions(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """Vertices in the middle of edges that only one of two triangles knows."""
    rows = random.choice(len(t), 8, replace=False)
    middles = x[t[rows][:, :2]].mean(axis=1)
    ids = len(x) + np.arange(len(rows))
    i, j, k = t[rows].T
    halves = [np.column_stack((i, ids, k)), np.column_stack((ids, j, k))]
    return np.concatenate([x, middles]), np.concatenate([np.delete(t, rows, axis=0), *halves])


def add_noise(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    return x + random.normal(scale=0.08 * EDGE, size=x.shape), t


def scale_up(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """In micrometres, of which nothing in the file tells."""
    del random
    return 1e3 * x, t


def cut_band(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """A band with half a turn in it, beside the organ: one side only."""
    angle = 2 * np.pi * np.arange(40) / 40
    rows = []
    for side in (-4.0, 4.0):
        r = 20.0 + side * np.cos(0.5 * angle)
        rows.append(np.column_stack([r * np.cos(angle), r * np.sin(angle),
                                     side * np.sin(0.5 * angle)]))  # fmt: skip
    band = np.stack(rows, axis=1).reshape(-1, 3) + [3.0 * np.abs(x).max(), 0.0, random.normal()]
    low, high = 2 * np.arange(40), 2 * np.arange(40) + 1
    after, above = np.append(low[1:], 1), np.append(high[1:], 0)
    u = np.concatenate([np.column_stack([low, after, high]), np.column_stack([high, after, above])])
    return join((x, t), (band, u))


def punch_many(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """Some thirty holes of a few triangles each."""
    for vertex in random.choice(len(x), 32, replace=False):
        t = t[~(t == vertex).any(axis=1)]
    return x, t


def open_parts(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """Five open parts with vertices of their own, which only together are closed."""
    turn = np.arctan2(*x[t].mean(axis=1)[:, :2].T) + random.uniform(0.0, 6.0)
    of = np.floor(5.0 * np.mod(turn / (2.0 * np.pi), 1.0)).astype(int)
    return join(*((x, t[of == part]) for part in range(5)))


def bore_through(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """A segmentation with holes right through it."""
    del x, t
    solid = np.ones((10, 10, 6), bool)
    for i, j in random.choice(4, (2, 2)) * 2 + 1:
        solid[i, j] = False
    return build_voxels(solid, 6.0)


def scatter_pieces(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """Three thousand crumbs in and around it."""
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    places = random.uniform(-1.1, 1.1, (3000, 3)) * np.abs(x).max(axis=0)
    crumbs = (places[:, None] + random.uniform(0.3, 2.0, (3000, 1, 1)) * corners).reshape(-1, 3)
    return join((x, t), (crumbs, (4 * np.arange(3000)[:, None, None] + faces).reshape(-1, 3)))


def cross_often(x: np.ndarray, t: np.ndarray, random: Random) -> Mesh:
    """A dozen vertices pulled through the other side."""
    some = random.choice(len(x), 12, replace=False)
    x[some] *= -random.uniform(1.05, 1.3, (12, 1))
    return x, t


DAMAGES: dict[str, Callable[[np.ndarray, np.ndarray, Random], Mesh]] = {
    "holes": punch_holes,
    "thirty holes": punch_many,
    "open parts": open_parts,
    "bored through": bore_through,
    "three thousand pieces": scatter_pieces,
    "crossed often": cross_often,
    "one face missing": miss_one,
    "flipped": flip_some,
    "inside out": turn_inside_out,
    "doubled": double_some,
    "unwelded": unweld,
    "three faces at an edge": add_fin,
    "shared wall": share_wall,
    "four faces at an edge": touch_along_edges,
    "nested parts": nest_parts,
    "crossed": cross_itself,
    "joined at a vertex": join_at_vertex,
    "specks": add_specks,
    "slivers": add_slivers,
    "T-junctions": cut_t_junctions,
    "noise": add_noise,
    "scale 1000": scale_up,
    "one side only": cut_band,
}


def make_twin(name: str, seed: int) -> Mesh:
    random = np.random.default_rng([seed, *name.encode()])
    x, t = make_organ(random)
    return DAMAGES[name](x.copy(), t.copy(), random)
