# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a tool goes on an organ, and the stations of that way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from palpate.runs.press import Place, find_place_on, find_top_on
from palpate.scene.scene_parts import VALIDATED_PART, VALIDATED_RADII, is_deeper

from palpate_editor.truth import wanted
from palpate_editor.truth.contact import find_touch
from palpate_editor.truth.levels import Station
from palpate_editor.truth.progress import TruthError
from palpate_editor.truth.subject import Subject, find_thickness
from palpate_editor.truth.tetrahedra import Floats

PARTS = (0.25, 0.5, 0.75, 1.0)
"""Of the greatest depth, where no depths are asked for."""


@dataclass(frozen=True, eq=False)
class Way:
    """The stations of a path, in the order in which the tool passes them."""

    path: str
    """press, pull, drag or script."""
    stations: tuple[Station, ...]
    deepest: float
    """[m] that linear truth holds at all of them."""
    bound: str
    """Which length that comes from: thickness, radius or wall."""


def find_stations(subject: Subject, radius: float, path: wanted.Path) -> Way:
    """Raises TruthError."""
    return find_way("press", subject, radius, [choose_place(subject, path.near)])


def choose_place(subject: Subject, near: Sequence[float] | None) -> Place:
    """The point of the surface closest to `near` [m], or where a check presses first: at the vertex
    that gives way closest to the top."""
    x, triangles = subject.surface.x, subject.surface.triangles.astype(np.int32)
    if near is None:
        free = np.setdiff1d(np.arange(len(x)), subject.fixed)
        if not len(free):
            raise TruthError("truth: got a surface that is held everywhere, expected a free place")
        top = find_top_on(x, triangles).point
        near = x[free][np.linalg.norm(x[free] - top, axis=1).argmin()]
    return find_place_on(x, triangles, np.asarray(near))


def find_way(path: str, subject: Subject, radius: float, places: list[Place]) -> Way:
    """Raises TruthError where nothing is behind a place, or it is held."""
    stations = tuple(place_station(subject, radius, place) for place in places)
    bounds = {
        "thickness": VALIDATED_PART * min(station.thickness for station in stations),
        "radius": VALIDATED_RADII * radius,
    }
    if subject.wall_thickness is not None:
        bounds["wall"] = subject.wall_thickness
    bound = min(bounds, key=lambda name: bounds[name])
    return Way(path, stations, bounds[bound], bound)


def place_station(subject: Subject, radius: float, place: Place) -> Station:
    skin, point, outward = subject.surface, place.point, place.outward
    _, triangle = skin.project(point[None])
    if np.isin(skin.triangles[triangle[0]], subject.fixed).all():
        at = ", ".join(f"{1e3 * value:.1f}" for value in point)
        raise TruthError(f"truth: got a place at {at} mm that is held, expected one that gives way")
    return Station(
        point,
        outward,
        find_touch(skin.x, skin.triangles, point, outward, radius),
        find_thickness(skin, point, outward, subject.is_hollow),
    )


def choose_depths(way: Way, wanted: Floats | None) -> Floats:
    """[m] ascending. Raises TruthError where one is beyond what linear truth holds."""
    if wanted is None:
        return way.deepest * np.array(PARTS)
    depths = np.unique(np.asarray(wanted, dtype=float))
    if not len(depths) or not np.isfinite(depths).all() or depths[0] <= 0.0:
        raise TruthError(f"depths: got {np.asarray(wanted).tolist()} m, expected some above 0")
    if is_deeper(float(depths[-1]), way.deepest):
        words = {
            "thickness": f"{VALIDATED_PART:.0%} of the thickness",
            "radius": f"{VALIDATED_RADII:g} radii of the ball",
            "wall": "the thickness of the wall",
        }
        raise TruthError(
            f"depths: got {1e3 * depths[-1]:.3g} mm, expected at most {1e3 * way.deepest:.3g} mm, "
            f"{words[way.bound]}: deeper, small displacements are no truth"
        )
    return depths
