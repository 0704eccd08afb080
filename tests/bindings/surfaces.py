# SPDX-License-Identifier: BSD-3-Clause
"""Small surfaces and scenes the tests of the bindings share. Everything is deterministic."""

from __future__ import annotations

import numpy as np
import palpate

MEMBRANE = palpate.Material(damping_ratio=0.2, wall_thickness=2e-3)


def ellipsoid(radii: tuple[float, float, float], subdivisions: int) -> palpate.SurfaceMesh:
    """A closed ellipsoid around the origin: an icosahedron divided `subdivisions` times."""
    g = (1.0 + 5.0**0.5) / 2.0
    corners = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
               (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]  # fmt: skip
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
                 (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
                 (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]  # fmt: skip
    points = [np.array(c) / np.linalg.norm(c) for c in corners]
    for _ in range(subdivisions):
        middles: dict[tuple[int, int], int] = {}

        def middle(i: int, j: int, middles: dict[tuple[int, int], int] = middles) -> int:
            key = (min(i, j), max(i, j))
            if key not in middles:
                middles[key] = len(points)
                point = points[i] + points[j]
                points.append(point / np.linalg.norm(point))
            return middles[key]

        finer = []
        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        triangles = finer
    return palpate.SurfaceMesh(np.array(points) * radii, triangles)


def tube(radius: float, length: float, around: int, rings: int) -> palpate.SurfaceMesh:
    """The side of a tube around +z, open at both ends."""
    turn = 2 * np.pi * np.arange(around) / around
    circle = radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    points = [(*xy, length * r / (rings - 1)) for r in range(rings) for xy in circle]
    triangles = []
    for r in range(rings - 1):
        for a in range(around):
            i, j = r * around + a, r * around + (a + 1) % around
            triangles += [(i, j, i + around), (j, j + around, i + around)]
    return palpate.SurfaceMesh(points, triangles)


def sheet(count: int, size: float) -> palpate.SurfaceMesh:
    """A flat open sheet in z = 0, outside +z; vertex (i, j) has index j * count + i."""
    at = np.linspace(0.0, size, count)
    points = [(x, y, 0.0) for y in at for x in at]
    triangles = []
    for j in range(count - 1):
        for i in range(count - 1):
            a = j * count + i
            b, c, d = a + 1, a + count, a + count + 1
            triangles += [(a, b, d), (a, d, c)] if (i + j) % 2 == 0 else [(a, b, c), (b, d, c)]
    return palpate.SurfaceMesh(points, triangles)


def chain(count: int, *, mass=1e-3, stiffness=100.0, damping=0.0) -> palpate.TissueModel:
    """`count` particles 1 cm apart along +x, the first held, joined by springs."""
    x = np.zeros((count, 3))
    x[:, 0] = 0.01 * np.arange(count)
    links = count - 1
    return palpate.TissueModel(
        rest_position=x,
        mass=np.full(count, mass),
        fixed=[0],
        springs=palpate.Links(
            [(i, i + 1) for i in range(links)],
            np.full(links, 0.01),
            np.full(links, stiffness),
            np.full(links, damping),
        ),
    )


def organ_scene(subdivisions: int = 2, stiffness: float = 50.0) -> palpate.Scene:
    """A hollow ellipsoid of 3 x 2.5 x 2 cm, ready for ticks."""
    mesh = ellipsoid((0.03, 0.025, 0.02), subdivisions)
    return palpate.build_scene(
        palpate.make_scene(palpate.build_mass_spring(mesh, MEMBRANE, stiffness))
    )


def press_frames(depth: float = 0.006) -> list[palpate.KeyFrame]:
    """From above the top of organ_scene() down, hold, and up again: 0.4 s."""
    over, down = (0.0, 0.0, 0.028), (0.0, 0.0, 0.023 - depth)
    return [
        palpate.KeyFrame(0.0, over),
        palpate.KeyFrame(0.15, down),
        palpate.KeyFrame(0.25, down),
        palpate.KeyFrame(0.4, over),
    ]


def run_frames(
    scene: palpate.Scene,
    frames: list[palpate.KeyFrame],
    header: str = "{}",
    hash_interval: int = 100,
) -> palpate.Record:
    """The frames through tick() itself, without a loop or a clock, and a hash of the whole state
    every `hash_interval` ticks. Raises RuntimeError for an alarm.
    """
    device, world = palpate.ScriptedDevice(frames), palpate.World(scene)
    dt = 1.0 / scene.rate
    hand, felt, hashes = [], [], []
    for tick in range(round(device.duration() * scene.rate)):
        hand.append(device.read(tick * dt))
        felt.append(palpate.compute_felt(palpate.tick(scene, hand[-1], dt, world), world))
        if world.alarm.kind != palpate.AlarmKind.none:
            raise RuntimeError(f"{world.alarm.kind.name} at {tick * dt:.3f} s")
        if (tick + 1) % hash_interval == 0:
            hashes.append(palpate.StateHash(tick=tick, hash=palpate.compute_hash(world)))
    return palpate.Record(header=header, hand=hand, felt=felt, hashes=hashes)
