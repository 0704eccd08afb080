# SPDX-License-Identifier: GPL-3.0-or-later
"""The far field of a solid organ on quadratic tetrahedra [contact: far field].

A uniform traction on a disc of radius a moves the disc by C on the mean, a tensor: a half space by
h = 16 / (3 pi² E* a) along its normal, and by h (2 - nu) / (2 - 2 nu) along the disc [Johnson85,
3.4 and 3.6]. What is left is the body: how far its bulk, its bends and what holds it are. That is
the same for every smaller disc there, and so for the contact of a ball, whichever way it presses.
"""

from __future__ import annotations

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.compile import mesh_of
from palpate_editor.document import Organ
from palpate_editor.document.far_compliance import compute_key
from palpate_editor.document.far_field import FarField
from palpate_editor.truth.elasticity import Press
from palpate_editor.truth.find_truth import require_solver
from palpate_editor.truth.graded import snap
from palpate_editor.truth.levels import build_press
from palpate_editor.truth.patches import POINTS, WEIGHTS, compute_shapes, find_nodes
from palpate_editor.truth.progress import Asked, Told, TruthError, Watch
from palpate_editor.truth.subject import Subject, find_whole, take_subject
from palpate_editor.truth.tetrahedra import Floats, Ints, find_surface

TETRAHEDRA = 8000
LEAST_PATCH = 0.008
"""[m] or ..."""
PATCH_EDGES = 1.5
"""... so many edges of its tetrahedra, if that is more: what such a mesh can tell."""
BLOCK = 32
"""Discs that are solved for at once."""
ROWS, COLUMNS = [0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]
"""Of a symmetric tensor, as a table has it: xx, yy, zz, xy, yz, zx."""
DIGITS = 6
"""Of the table that are kept: another machine rounds otherwise, and means the same."""


class Discs:
    """Uniform pressures on a body's boundary."""

    def __init__(self, press: Press, faces: Ints):
        x = press.body.basis.mesh.p.T
        corners = x[faces]
        turned = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        area = 0.5 * np.linalg.norm(turned, axis=1)
        self.press = press
        self.nodes = find_nodes(press.body, faces)
        self.normals = turned / (2.0 * area[:, None])
        self.points = np.einsum("qk,fkd->fqd", POINTS, corners)
        self.weights = area[:, None] * WEIGHTS
        self.shapes = compute_shapes(POINTS)

    def load(self, point: Floats, outward: Floats, radius: float) -> tuple[Floats, float]:
        """1 N on the disc around a point along each axis, on the free nodes (3 free, 3), and the
        radius [m] of the flat disc whose points are as far apart."""
        near = np.linalg.norm(self.points - point, axis=2) < radius
        parts = np.where(near & (self.normals @ outward > 0.0)[:, None], self.weights, 0.0)
        if not parts.any():
            raise TruthError("far field: got a place with no surface of the mesh near it")
        parts /= parts.sum()
        middle = (parts[..., None] * self.points).sum(axis=(0, 1))
        spread = 2.0 * (parts * ((self.points - middle) ** 2).sum(axis=2)).sum()
        share = np.zeros(self.press.body.node_count)
        np.add.at(share, self.nodes, parts @ self.shapes)
        loads = share[self.press.free, None, None] * np.eye(3)
        return loads.reshape(-1, 3), float(np.sqrt(spread))


def solve_far_field(
    organ: Organ, progress: Told | None = None, cancelled: Asked | None = None
) -> FarField:
    """Of a solid organ, some seconds, on any thread.

    Args:
        organ: Its surface, what is held, what is painted stiffer and Poisson's ratio count.
        progress: Told of every stage.
        cancelled: Asked between stages and blocks of loads.

    Raises:
        TruthError: a sentence on what is missing or wrong.
        Stopped: once `cancelled` says so.
    """
    require_solver()
    watch = Watch(progress, cancelled, [1.0])
    whole = find_whole(organ)
    subject = take_subject(whole)
    if subject.wall_thickness is not None:
        raise TruthError("far field: got a hollow organ, expected a solid one")
    watch.tell(0, "mesh", 0.0)
    x, t = build_mesh(whole, subject)
    watch.tell(0, "stiffness", 0.05)
    press = build_press(subject, x, t)
    _ = press.matrix
    watch.tell(0, "factor", 0.1)
    _ = press.factor
    assert organ.surface is not None
    vertices, triangles = organ.surface.vertices, organ.surface.triangles
    normals = np.asarray(palpate.compute_vertex_normals(vertices, triangles))
    used = np.unique(triangles)
    patch = max(LEAST_PATCH, PATCH_EDGES * measure_edge(x, t))
    modulus = subject.young_modulus / (1.0 - subject.poisson_ratio**2)
    softness = np.zeros((len(vertices), 6))
    discs = Discs(press, find_surface(t))
    for first in range(0, len(used), BLOCK):
        watch.tell(0, "response", 0.2 + 0.8 * first / len(used))
        rows = used[first : first + BLOCK]
        loads = [discs.load(vertices[v], normals[v], patch) for v in rows]
        half = press.factor.halve(np.concatenate([load for load, _ in loads], axis=1))
        half = half.reshape(-1, len(rows), 3).transpose(1, 0, 2)
        whole = modulus * (half.transpose(0, 2, 1) @ half)
        radii = np.array([radius for _, radius in loads])
        far = whole - find_half_space(normals[rows], radii, subject.poisson_ratio)
        softness[rows] = far[:, ROWS, COLUMNS]
    return FarField(compute_key(organ), patch, len(t), round_digits(softness.ravel()))


def find_half_space(normals: Floats, radii: Floats, poisson_ratio: float) -> Floats:
    """[1/m] (k, 3, 3) what discs of these radii [m] on half spaces move, times E*."""
    along = 16.0 / (3.0 * np.pi**2 * radii)[:, None, None]
    aside = along * (2.0 - poisson_ratio) / (2.0 - 2.0 * poisson_ratio)
    normal = normals[:, :, None] * normals[:, None, :]
    return np.asarray(along * normal + aside * (np.eye(3) - normal))


def build_mesh(whole: Organ, subject: Subject) -> tuple[Floats, Ints]:
    """Tetrahedra inside the surface, the outside of which lies on it."""
    assert whole.surface is not None
    try:
        solid = authoring.fill_to_count(mesh_of(whole.surface), TETRAHEDRA)
    except ValueError as refused:
        raise TruthError(f"far field: the surface cannot be filled: {refused}") from None
    x, t = np.array(solid.vertices), np.asarray(solid.tetrahedra, dtype=np.int64)
    return snap(x, t, 0, subject.surface), t


def measure_edge(x: Floats, t: Ints) -> float:
    """[m] The mean edge of tetrahedra."""
    return float(np.mean([np.linalg.norm(x[t[:, k]] - x[t[:, 0]], axis=1) for k in (1, 2, 3)]))


def round_digits(values: Floats) -> Floats:
    """To DIGITS of the largest."""
    unit = 10.0 ** (np.floor(np.log10(np.abs(values).max(initial=1e-9))) + 1 - DIGITS)
    return np.asarray(np.round(values / unit) * unit)
