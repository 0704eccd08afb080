# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of vertices: what a file's pictures, corners and materials make of them, and what of them
goes over to another surface of the same organ. Nothing of it is felt.

Means are taken in linear light: half of black and white is what an eye sees from afar.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from palpate_editor import authoring
from palpate_editor.document import Surface

MOST_CUTS = 8
"""Samples along each side of a triangle: 64 in all."""
CHUNK = 1_000_000
"""Samples that are taken at a time."""
ALIKE = 5
"""Of 255: colours that are no further apart are one."""
CODES = np.arange(256) / 255.0
LINEAR = np.where(CODES <= 0.04045, CODES / 12.92, ((CODES + 0.055) / 1.055) ** 2.4)
"""Linear light of a channel's byte [IEC 61966-2-1]."""


def to_linear(colour: np.ndarray) -> np.ndarray:
    """Of sRGB, 0 to 1."""
    return np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)


def to_bytes(light: np.ndarray) -> np.ndarray:
    """uint8 sRGB of linear light, 0 to 1."""
    light = np.clip(light, 0.0, 1.0)
    srgb = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    return np.rint(255.0 * srgb).astype(np.uint8)


# ---------------------------------------------------------------- of a file


def paint_surface(
    surface: Surface,
    parts: Sequence[authoring.ImportedPart],
    placed: Sequence[Surface],
    pictures: Sequence[np.ndarray | None],
) -> np.ndarray | None:
    """(n, 3) uint8 of the vertices of a surface that was made of parts; None where all are alike.

    A vertex has the mean, by area, of what the corners that lay there are painted with; one where
    none lay, as where parts were cut, that of the nearest.

    Args:
        surface: Whose vertices.
        parts: With their paint.
        placed: The same where they lie in the organ [m].
        pictures: Of the file, decoded; None for one that is not there.
    """
    points, light, weight = [], [], []
    for part, at in zip(parts, placed, strict=True):
        if len(np.asarray(part.pictures)) or part.colour is not None:
            corners = shade_corners(part, pictures)
            points.append(at.vertices[at.triangles].reshape(-1, 3))
            light.append(corners.reshape(-1, 3))
            weight.append(np.repeat(measure_areas(at), 3))
    if not points:
        return None
    tree = cKDTree(surface.vertices)
    _, nearest = tree.query(np.concatenate(points))
    total, sums = add_up(len(surface.vertices), nearest, np.concatenate(weight),
                         np.concatenate(light))  # fmt: skip
    mean = sums / np.where(total > 0.0, total, 1.0)[:, None]
    if not (total > 0.0).all():
        bare, known = total <= 0.0, total > 0.0
        _, of = cKDTree(surface.vertices[known]).query(surface.vertices[bare])
        mean[bare] = mean[known][of]
    colours = to_bytes(mean)
    return None if (np.ptp(colours.astype(int), axis=0) <= ALIKE).all() else colours


def measure_areas(surface: Surface) -> np.ndarray:
    """[m²] (t,), none of them quite 0."""
    x = surface.vertices[surface.triangles]
    sides = np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
    return np.asarray(0.5 * np.linalg.norm(sides, axis=1) + 1e-18)


def add_up(
    count: int, to: np.ndarray, weight: np.ndarray, light: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Of each of `count` vertices all weights that go to it (n,), and light times them (n, 3)."""
    sums = [np.bincount(to, weight * light[:, c], count) for c in range(3)]
    return np.bincount(to, weight, count), np.stack(sums, axis=1)


def shade_corners(
    part: authoring.ImportedPart, pictures: Sequence[np.ndarray | None]
) -> np.ndarray:
    """(t, 3, 3) linear light of each corner of each triangle."""
    count = len(np.asarray(part.mesh.triangles))
    numbers = np.asarray(part.pictures)
    if len(numbers) == 0:
        plain = to_linear(np.asarray(part.colour, float))
        return np.broadcast_to(plain, (count, 3, 3)).copy()
    paint = np.asarray(part.paint, float).reshape(-1, 3, 5)
    light = to_linear(np.clip(paint[:, :, 2:], 0.0, 1.0))
    for number, picture in enumerate(pictures):
        rows = np.flatnonzero(numbers == number)
        if picture is not None and len(rows):
            light[rows] *= sample(picture, paint[rows, :, :2])
    return light


def sample(picture: np.ndarray, places: np.ndarray) -> np.ndarray:
    """(k, 3, 3) linear light at the corners of triangles on a picture: the mean over the triangle,
    weighted as a linear function falls off from each corner.

    Args:
        picture: (h, w, 3) uint8
        places: (k, 3, 2) of the corners, 0 to 1 from the lower left.
    """
    height, width = picture.shape[:2]
    sides = (places[:, 1:] - places[:, :1]) * [width, height]
    texels = 0.5 * np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    cuts = np.clip(np.ceil(np.sqrt(texels)), 1, MOST_CUTS).astype(int)
    light = np.empty((len(places), 3, 3))
    for cut in np.unique(cuts):
        inside = list_middles(int(cut))
        share = inside / inside.sum(axis=0)
        rows = np.flatnonzero(cuts == cut)
        for begin in range(0, len(rows), max(1, CHUNK // len(inside))):
            some = rows[begin : begin + max(1, CHUNK // len(inside))]
            at = np.einsum("mc,kcd->kmd", inside, places[some])
            light[some] = np.einsum("mc,kmd->kcd", share, look_up(picture, at))
    return light


def list_middles(cuts: int) -> np.ndarray:
    """(cuts², 3) Barycentric middles of the triangles that one is cut into."""
    rows = []
    for i in range(cuts):
        for j in range(cuts - i):
            rows.append((i + 1 / 3, j + 1 / 3))
            if j < cuts - i - 1:
                rows.append((i + 2 / 3, j + 2 / 3))
    a, b = np.array(rows).T / cuts
    return np.stack([1.0 - a - b, a, b], axis=1)


def look_up(picture: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Linear light of the texels; the picture goes on beyond its borders."""
    height, width = picture.shape[:2]
    u, v = places[..., 0] % 1.0, places[..., 1] % 1.0
    column = np.minimum((u * width).astype(int), width - 1)
    row = np.minimum(((1.0 - v) * height).astype(int), height - 1)
    return np.asarray(LINEAR[picture[row, column]])


def find_mean(surface: Surface) -> tuple[float, ...]:
    """sRGB, 0 to 1: of its colours by area."""
    assert surface.colours is not None
    light = LINEAR[surface.colours][surface.triangles].mean(axis=1)
    mean = np.average(light, axis=0, weights=measure_areas(surface))
    return tuple((to_bytes(mean) / 255.0).tolist())


# ---------------------------------------------------------------- from surface to surface


def carry_colours(surface: Surface, source: Surface) -> Surface:
    """`surface` in the colours of `source`, another surface of the same organ.

    Each vertex of the source gives its colour, by its area, to the vertex that is nearest in place
    and direction, so that the two sides of a thin wall stay apart and a coarse surface has the mean
    of what it stands for. Where that is less than a vertex's own area, as on a finer surface, the
    rest is what lies nearest on the source.
    """
    if source.colours is None or len(surface.triangles) == 0:
        return surface
    if surface.vertices is source.vertices:
        return replace(surface, colours=source.colours)
    reach = 0.5 * measure_edge(surface)
    to, of = list_features(surface, reach), list_features(source, reach)
    own, given = spread_areas(surface), spread_areas(source)
    light = LINEAR[source.colours]
    total, sums = add_up(len(to), cKDTree(to).query(of)[1], given, light)
    short = np.flatnonzero(total < own)
    if len(short):
        rest = (own - total)[short]
        sums[short] += rest[:, None] * mix_nearest(to[short], of, light)
        total[short] = own[short]
    return replace(surface, colours=to_bytes(sums / total[:, None]))


def mix_nearest(points: np.ndarray, of: np.ndarray, light: np.ndarray) -> np.ndarray:
    """(n, 3) Of the three nearest of `of`, by the inverse square of how far they are."""
    count = min(3, len(of))
    away, near = (found.reshape(len(points), count) for found in cKDTree(of).query(points, k=count))
    share = 1.0 / np.maximum(away, 1e-12) ** 2
    mixed = np.einsum("nk,nkc->nc", share, light[near])
    return np.asarray(mixed / share.sum(axis=1, keepdims=True))


def list_features(surface: Surface, reach: float) -> np.ndarray:
    """(n, 6) [m] Place, and the normal times a length."""
    from palpate import compute_vertex_normals

    normals = np.asarray(compute_vertex_normals(surface.vertices, surface.triangles))
    return np.hstack([surface.vertices, reach * normals])


def measure_edge(surface: Surface) -> float:
    """[m] The mean."""
    x = surface.vertices[surface.triangles]
    return float(np.linalg.norm(x - np.roll(x, -1, axis=1), axis=2).mean())


def spread_areas(surface: Surface) -> np.ndarray:
    """[m²] (n,) A third of each triangle at a vertex."""
    areas = np.repeat(measure_areas(surface) / 3.0, 3)
    return np.bincount(surface.triangles.ravel(), areas, len(surface.vertices)) + 1e-18
