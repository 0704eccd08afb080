# SPDX-License-Identifier: BSD-3-Clause
"""The device as shapes: what stands still, what turns with each joint, and where the tip can go."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.render import Shape, build_capsule, build_sphere
from palpate.render.shapes import turn

Array = NDArray[np.float64]

AXLE_HEIGHT = 0.212
"""[m] of the elevation axis over the table."""
CRANK = 0.04
"""[m] of the parallelogram that drives the forearm."""
SIDE = 0.016
"""[m] that the parallelogram stands beside the arm."""
STYLUS = 0.085
"""[m] of it below the tip."""
YOKE, FORK = 0.030, 0.019
"""[m] its length, and half its width."""
TURRET = (
    (1e-6, 0.0),
    (0.05, 0.0),
    (0.052, 0.003),
    (0.05, 0.008),
    (0.022, 0.012),
    (0.018, 0.05),
    (1e-6, 0.05),
)
"""[m] its profile: radius and height."""
SIDES = 24
"""Of what is round: it is drawn again whenever the arm moves, often without a graphics card."""
AROUND = 6
"""Sides of a line's tube."""


def build_solid(
    profile: Sequence[tuple[float, float]],
    origin: ArrayLike,
    axis: ArrayLike,
    sides: int = SIDES,
) -> Shape:
    """A body turned around an axis, its edges sharp: (radius, height) [m] from its foot up."""
    points, slopes = [], []
    for (r0, h0), (r1, h1) in zip(profile, profile[1:], strict=False):
        length = math.hypot(r1 - r0, h1 - h0)
        slope = ((h1 - h0) / length, (r0 - r1) / length)
        points += [(r0, h0), (r1, h1)]
        slopes += [slope, slope]
    return turn(
        np.array(points),
        np.array(slopes),
        np.asarray(origin, dtype=float),
        np.asarray(axis, dtype=float),
        sides,
    )


def build_drum(centre: ArrayLike, axis: ArrayLike, radius: float, width: float) -> Shape:
    """A bevelled drum across an axis, `centre` [m] in its middle."""
    along = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    bevel = 0.15 * radius
    profile = [
        (1e-6, 0.0),
        (radius - bevel, 0.0),
        (radius, bevel),
        (radius, width - bevel),
        (radius - bevel, width),
        (1e-6, width),
    ]
    return build_solid(profile, np.asarray(centre) - 0.5 * width * along, along)


def join(shapes: Sequence[Shape]) -> Shape:
    """Several as one."""
    starts = np.cumsum([0, *(len(shape.vertices) for shape in shapes)])
    return Shape(
        np.concatenate([shape.vertices for shape in shapes]),
        np.concatenate([shape.normals for shape in shapes]),
        np.concatenate(
            [shape.triangles + start for shape, start in zip(shapes, starts, strict=False)]
        ).astype(np.uint32),
    )


def build_stand() -> Shape:
    """Base, column and deck: all that never moves, in metres, the axle at the origin."""
    floor = -AXLE_HEIGHT
    profile = [
        (1e-6, 0.0),
        (0.088, 0.0),
        (0.092, 0.003),
        (0.090, 0.008),
        (0.040, 0.012),
        (0.033, 0.022),
        (0.028, 0.118),
        (0.036, 0.128),
        (0.064, 0.132),
        (0.066, 0.135),
        (0.066, 0.141),
        (0.062, 0.144),
        (1e-6, 0.144),
    ]
    return build_solid(profile, (0.0, 0.0, floor), (0.0, 0.0, 1.0), 2 * SIDES)


def find_points(arm: palpate.Arm, joints: Array) -> tuple[Array, Array, Array]:
    """Elbow, tip [m] and the direction of the forearm."""
    yaw, elevation, forearm = joints
    out = np.array([math.sin(yaw), -math.cos(yaw), 0.0])
    up = np.array([0.0, 0.0, 1.0])
    elbow = arm.upper_length * (math.cos(elevation) * out + math.sin(elevation) * up)
    along = math.sin(forearm) * out - math.cos(forearm) * up
    return elbow, elbow + arm.forearm_length * along, along


X, Y, Z = np.eye(3)
"""Of a link's own frame: along it, to its side, and across both."""


class ArmShapes:
    """What moves, part by part: made once, then turned and moved with the joints."""

    def __init__(self, arm: palpate.Arm):
        self.arm = arm
        long, tail, hold = arm.upper_length, -CRANK * X, arm.forearm_length - YOKE
        self._pieces: list[tuple[str, str, Shape]] = [
            ("turret", "yaw", build_solid(TURRET, -0.066 * Z, Z)),
            ("turret", "yaw", build_drum(0 * X, Y, 0.021, 0.056)),
            ("drive", "yaw", build_drum(0 * X, Y, 0.014, 0.064)),
            ("arm", "upper", capsule(0 * X, long * X, 0.0095)),
            ("arm", "upper", build_drum(long * X, Y, 0.0155, 0.026)),
            ("arm", "forearm", capsule(tail, hold * X, 0.0085)),
            ("arm", "forearm", build_drum(tail, Y, 0.010, 0.038)),
            ("drive", "crank", capsule(0 * X, tail, 0.0055)),
            ("drive", "coupler", capsule(0 * X, long * X, 0.0055)),
            ("yoke", "forearm", capsule(hold * X - FORK * Y, hold * X + FORK * Y, 0.005)),
            ("yoke", "forearm", capsule((hold + YOKE) * X - FORK * Y,
                                        (hold + YOKE) * X + FORK * Y, 0.003)),
            ("stylus", "stylus", capsule(-0.016 * X, STYLUS * X, 0.006)),
            ("stylus", "stylus", capsule(0.2 * STYLUS * X, 0.75 * STYLUS * X, 0.0072)),
            ("tip", "stylus", build_sphere(0 * X, 0.0085, SIDES)),
        ]  # fmt: skip
        for side in (-FORK * Y, FORK * Y):
            arm_of_yoke = capsule(hold * X + side, (hold + YOKE) * X + side, 0.004)
            self._pieces.append(("yoke", "forearm", arm_of_yoke))

    def place(self, joints: Array, stylus: Array) -> dict[str, Shape]:
        """Every part at joints [rad]; `stylus` is its unit direction."""
        frames = self._find_frames(joints, stylus)
        parts: dict[str, list[Shape]] = {}
        for part, frame, shape in self._pieces:
            turned, origin = frames[frame]
            moved = Shape(
                (shape.vertices @ turned + origin).astype(np.float32),
                (shape.normals @ turned).astype(np.float32),
                shape.triangles,
            )
            parts.setdefault(part, []).append(moved)
        return {part: join(shapes) for part, shapes in parts.items()}

    def _find_frames(self, joints: Array, stylus: Array) -> dict[str, tuple[Array, Array]]:
        """Rows X, Y and Z of each frame, and its origin [m]."""
        elbow, tip, forearm = find_points(self.arm, joints)
        side = np.array([math.cos(joints[0]), math.sin(joints[0]), 0.0])
        upper = elbow / np.linalg.norm(elbow)
        across = np.cross(stylus, np.eye(3)[np.abs(stylus).argmin()])
        across /= np.linalg.norm(across)
        beside = SIDE * side
        return {
            "yaw": (build_frame(np.cross(side, Z), side), np.zeros(3)),
            "upper": (build_frame(upper, side), np.zeros(3)),
            "coupler": (build_frame(upper, side), beside - CRANK * forearm),
            "forearm": (build_frame(forearm, side), elbow),
            "crank": (build_frame(forearm, side), beside),
            "stylus": (build_frame(stylus, across), tip),
        }


def build_frame(along: Array, side: Array) -> Array:
    return np.stack([along, side, np.cross(along, side)])


def capsule(start: Array, end: Array, radius: float) -> Shape:
    return build_capsule(start, end, radius, SIDES)


def build_ghost(arm: palpate.Arm, joints: Array) -> Shape:
    """Where the arm is to be brought."""
    elbow, tip, _ = find_points(arm, joints)
    return join(
        [
            capsule(np.zeros(3), elbow, 0.0045),
            capsule(elbow, tip, 0.0045),
            build_sphere(elbow, 0.009, SIDES),
            build_sphere(tip, 0.011, SIDES),
        ]
    )


# ---------------------------------------------------------------- where the tip can go


def build_cage(arm: palpate.Arm, radius: float) -> Shape:
    """The reachable volume: its section at five yaws, and arcs through its corners."""
    section = find_section(arm)
    tubes = []
    for yaw in np.linspace(arm.joint_min[0], arm.joint_max[0], 5):
        tubes.append(build_tube(place_section(section, yaw), radius))
    # the outermost, the lowest, the highest and the innermost point
    yaws = np.linspace(arm.joint_min[0], arm.joint_max[0], 33)
    ends = {int(k) for k in (section[:, 0].argmax(), section[:, 1].argmin(), section[:, 1].argmax(),
                             section[:, 0].argmin())}  # fmt: skip
    for k in sorted(ends):
        arc = np.concatenate([place_section(section[k : k + 1], yaw) for yaw in yaws])
        tubes.append(build_tube(arc, radius))
    return join(tubes)


def find_section(arm: palpate.Arm) -> Array:
    """(n, 2) [m] out and up: the edge of what is reached at one yaw, closed."""
    low, high = arm.joint_min[1:], arm.joint_max[1:]
    corners = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    for sign in (1.0, -1.0):
        corners = list(clip(corners, sign, arm.bend_max))
    edge = []
    for (a, b), (c, d) in zip(corners, [*corners[1:], corners[0]], strict=True):
        share = np.linspace(0.0, 1.0, 17)[:-1, None]
        edge.append(np.array([a, b]) + share * np.array([c - a, d - b]))
    angles = np.concatenate([*edge, edge[0][:1]])
    return np.stack(
        [
            arm.upper_length * np.cos(angles[:, 0]) + arm.forearm_length * np.sin(angles[:, 1]),
            arm.upper_length * np.sin(angles[:, 0]) - arm.forearm_length * np.cos(angles[:, 1]),
        ],
        axis=1,
    )


def clip(
    corners: list[tuple[float, float]], sign: float, most: float
) -> Iterator[tuple[float, float]]:
    """The part of a polygon of (elevation, forearm) in which the links are bent enough."""
    for (a, b), (c, d) in zip(corners, [*corners[1:], corners[0]], strict=True):
        here, there = most - sign * (a - b), most - sign * (c - d)
        if here >= 0.0:
            yield a, b
        if here * there < 0.0:
            share = here / (here - there)
            yield a + share * (c - a), b + share * (d - b)


def place_section(section: Array, yaw: float) -> Array:
    """[m] (n, 3)"""
    out = np.array([math.sin(yaw), -math.cos(yaw), 0.0])
    return section[:, :1] * out + section[:, 1:] * np.array([0.0, 0.0, 1.0])


def build_box(box: palpate.Workspace, radius: float) -> Shape:
    """The edges of a box."""
    corners = np.array(
        [[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
    ) * np.asarray(box.size) + np.asarray(box.center)
    pairs = [(a, a | bit) for a in range(8) for bit in (1, 2, 4) if not a & bit]
    return join([build_tube(corners[[a, b]], radius) for a, b in pairs])


def build_tube(points: Array, radius: float) -> Shape:
    """A thin tube [m] along points (n, 3), open at its ends."""
    along = np.gradient(points, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    helper = np.eye(3)[np.abs(along).max(axis=0).argmin()]
    first = np.cross(along, helper)
    first /= np.maximum(np.linalg.norm(first, axis=1, keepdims=True), 1e-9)
    second = np.cross(along, first)
    angle = np.arange(AROUND) * 2 * math.pi / AROUND
    normals = (
        np.cos(angle)[None, :, None] * first[:, None]
        + np.sin(angle)[None, :, None] * second[:, None]
    )
    vertices = points[:, None] + radius * normals
    j, i = np.meshgrid(np.arange(len(points) - 1), np.arange(AROUND), indexing="ij")
    a, b = j * AROUND + i, j * AROUND + (i + 1) % AROUND
    triangles = np.stack([a, b, b + AROUND, a, b + AROUND, a + AROUND], axis=-1).reshape(-1, 3)
    return Shape(
        vertices.reshape(-1, 3).astype(np.float32),
        normals.reshape(-1, 3).astype(np.float32),
        triangles.astype(np.uint32),
    )
