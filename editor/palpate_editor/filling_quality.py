# SPDX-License-Identifier: GPL-3.0-or-later
"""How well an organ is filled: how many tetrahedra, how flat and how fine they are, and where."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import palpate
from palpate.command.verb import Report

from palpate_editor.compile import mesh_of
from palpate_editor.document import Organ
from palpate_editor.document.problems import FillingFacts
from palpate_editor.edits.cap import find_caps
from palpate_editor.fill import fill_organ

MOST_PLACES = 5
"""Of the flattest tetrahedra that are told."""
APART = 3.0
"""Median edges from one of these places to the next."""
ANGLE_LIMITS = np.arange(0.0, 75.0, 5.0)
"""[degree] Of the histogram; a regular tetrahedron has 70.5."""
SIDES = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))
"""The edges of a tetrahedron, and its pairs of faces."""
FACES = ((1, 3, 2), (0, 2, 3), (0, 3, 1), (0, 1, 2))
"""Corners of the face across from each corner, counter-clockwise from outside."""


@dataclass(frozen=True)
class FlatPlace:
    """A tetrahedron that is flatter than all around it."""

    point: tuple[float, float, float]
    """[m] its middle"""
    angle_deg: float
    """The smallest between two of its faces."""
    edge: float
    """[m] the mean of its six"""


@dataclass(frozen=True, eq=False)
class FillingQuality:
    """What can be measured on the tetrahedra of an organ."""

    asked: int
    vertices: int
    tetrahedra: int
    volume_share: float
    """[-] Of the volume inside the surface."""
    outside_distance: float
    """[m] The outside's vertices are at most so far from the surface."""
    edges: tuple[float, float, float]
    """[m] shortest, median and longest"""
    fine_edge: float | None
    """[m] The median at the finer region; None where there is none."""
    angles_deg: np.ndarray
    """(t,) the smallest between two faces of each"""
    places: tuple[FlatPlace, ...]
    """The flattest first."""
    caps: tuple[str, ...]
    """Regions that close what was open."""

    def as_dict(self) -> Report:
        counts, limits = np.histogram(self.angles_deg, ANGLE_LIMITS)
        return {
            "asked": self.asked,
            "tetrahedra": self.tetrahedra,
            "vertices": self.vertices,
            "volume_share": self.volume_share,
            "outside_distance_mm": 1e3 * self.outside_distance,
            "edges_mm": [1e3 * edge for edge in self.edges],
            "fine_edge_mm": None if self.fine_edge is None else 1e3 * self.fine_edge,
            "smallest_angle_deg": float(self.angles_deg.min()),
            "angles_deg": {"limits": limits.tolist(), "counts": counts.tolist()},
            "places": [
                {
                    "point_m": list(place.point),
                    "angle_deg": place.angle_deg,
                    "edge_mm": 1e3 * place.edge,
                }
                for place in self.places
            ],
            "caps": list(self.caps),
        }


def measure_filling(organ: Organ) -> FillingQuality:
    """Of an organ that has a surface. Raises ValueError where it cannot be filled."""
    assert organ.surface is not None
    solid = fill_organ(organ)
    x, t = np.asarray(solid.vertices), np.asarray(solid.tetrahedra)
    lengths = list_lengths(x, t)
    median = float(np.median(lengths))
    outside = np.unique(palpate.find_boundary(solid))
    tree = palpate.AabbTree(organ.surface.vertices, organ.surface.triangles)
    away = [
        palpate.find_closest_point(tree, organ.surface.vertices, p).distance for p in x[outside]
    ]
    angles = compute_dihedrals(x, t)
    return FillingQuality(
        asked=organ.fill.tetrahedra,
        vertices=len(x),
        tetrahedra=len(t),
        volume_share=compute_volume(x, t) / palpate.compute_volume(mesh_of(organ.surface)),
        outside_distance=float(max(away)),
        edges=(float(lengths.min()), median, float(lengths.max())),
        fine_edge=find_fine_edge(organ, x, t, lengths),
        angles_deg=angles,
        places=find_flattest(x, t, angles, lengths, APART * median),
        caps=tuple(find_caps(organ)),
    )


def state_facts(quality: FillingQuality) -> FillingFacts:
    """What the rules need of it."""
    return FillingFacts(
        asked=quality.asked,
        smallest_angle_deg=float(quality.angles_deg.min()),
        place=quality.places[0].point,
        edges=quality.edges,
        fine_edge=quality.fine_edge,
    )


def list_lengths(x: np.ndarray, t: np.ndarray) -> np.ndarray:
    """[m] (t, 6) the edges of every tetrahedron."""
    return np.stack([np.linalg.norm(x[t[:, i]] - x[t[:, j]], axis=1) for i, j in SIDES], axis=1)


def compute_volume(x: np.ndarray, t: np.ndarray) -> float:
    """[m³]"""
    a, b, c, d = (x[t[:, k]] for k in range(4))
    return float(np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a).sum() / 6.0)


def compute_dihedrals(x: np.ndarray, t: np.ndarray) -> np.ndarray:
    """[degree] (t,) the smallest angle between two faces of each."""
    normals = []
    for i, j, k in FACES:
        n = np.cross(x[t[:, j]] - x[t[:, i]], x[t[:, k]] - x[t[:, i]])
        normals.append(n / np.linalg.norm(n, axis=1)[:, None])
    cosines = [-(normals[i] * normals[j]).sum(axis=1) for i, j in SIDES]
    return np.degrees(np.arccos(np.clip(np.max(cosines, axis=0), -1.0, 1.0)))


def find_fine_edge(organ: Organ, x: np.ndarray, t: np.ndarray, lengths: np.ndarray) -> float | None:
    """[m] The median edge of the tetrahedra whose middles are within one edge of the region."""
    assert organ.surface is not None
    ids = organ.regions.get(organ.fill.fine_region)
    if ids is None or not len(ids):
        return None
    middles, means = x[t].mean(axis=1), lengths.mean(axis=1)
    region = organ.surface.vertices[ids]
    away = np.array([np.linalg.norm(region - p, axis=1).min() for p in middles])
    near = away < means
    return float(np.median(lengths[near])) if near.any() else None


def find_flattest(
    x: np.ndarray, t: np.ndarray, angles: np.ndarray, lengths: np.ndarray, apart: float
) -> tuple[FlatPlace, ...]:
    """Places of the flattest, `apart` [m] from each other."""
    found: list[FlatPlace] = []
    for row in np.argsort(angles, kind="stable"):
        middle = x[t[row]].mean(axis=0)
        if any(np.linalg.norm(middle - p.point) < apart for p in found):
            continue
        point = (float(middle[0]), float(middle[1]), float(middle[2]))
        found.append(FlatPlace(point, float(angles[row]), float(lengths[row].mean())))
        if len(found) == MOST_PLACES:
            break
    return tuple(found)
