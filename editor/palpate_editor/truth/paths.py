# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a tool goes on an organ, and the stations of that way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from palpate.runs.press import Place, find_place_on, find_top_on
from palpate.scene.scene_parts import VALIDATED_PART, VALIDATED_RADII, is_deeper

from palpate_editor.document import Organ
from palpate_editor.truth import wanted
from palpate_editor.truth.contact import find_touch
from palpate_editor.truth.hold import Hold
from palpate_editor.truth.levels import Station
from palpate_editor.truth.progress import TruthError
from palpate_editor.truth.subject import Subject, find_thickness
from palpate_editor.truth.tetrahedra import Floats
from palpate_editor.truth.walks import follow_script, walk

PARTS = (0.25, 0.5, 0.75, 1.0)
"""Of the greatest depth, where no depths are asked for."""
BOUNDS = {
    "thickness": f"{VALIDATED_PART:.0%} of the thickness",
    "radius": f"{VALIDATED_RADII:g} radii of the ball",
    "wall": "the thickness of the wall",
}


@dataclass(frozen=True, eq=False)
class Way:
    """The stations of a path, in the order in which the tool passes them."""

    path: str
    """press, pull, drag or script."""
    stations: tuple[Station, ...]
    deepest: float
    """[m] that linear truth holds at all of them, of a pull how high."""
    bound: str
    """Which length that comes from: thickness, radius or wall."""
    meant: float | None = None
    """[m] to which a script goes; None where no path says it."""


def find_stations(organ: Organ, subject: Subject, radius: float, path: wanted.Path) -> Way:
    """Of the organ on the desk, whose body is the subject. Raises TruthError."""
    if isinstance(path, wanted.Script):
        places, depth = follow_script(subject, radius, path)
        return replace(find_way("script", subject, radius, places), meant=depth)
    start = choose_place(subject, path.near)
    if isinstance(path, wanted.Drag):
        return find_way("drag", subject, radius, walk(organ, subject, radius, start, path))
    if isinstance(path, wanted.Press):
        return find_way("press", subject, radius, [start])
    way = find_way("pull", subject, radius, [start])
    if not 0.0 < path.grip <= way.deepest:
        raise TruthError(
            f"grip: got {1e3 * path.grip:g} mm, expected one above 0 and up to "
            f"{1e3 * way.deepest:.3g} mm, {BOUNDS[way.bound]}"
        )
    hold = Hold(organ.hand.hold_stiffness, path.grip)
    return replace(way, stations=(replace(way.stations[0], hold=hold),))


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


def find_way(path: str, subject: Subject, radius: float, places: Sequence[Place]) -> Way:
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


def choose_depths(way: Way, asked: Floats | None) -> tuple[Floats, tuple[str, ...]]:
    """[m] rising away from 0, those of a pull below it, and what is to be said of them.

    Raises TruthError where one is beyond what linear truth holds.
    """
    sign = -1.0 if way.path == "pull" else 1.0
    if asked is not None:
        return sign * check_depths(way, np.unique(np.abs(asked) if sign < 0.0 else asked)), ()
    if way.meant is None:
        return sign * way.deepest * np.array(PARTS), ()
    remarks = ()
    if is_deeper(way.meant, way.deepest):
        remarks = (
            f"the script goes {1e3 * way.meant:.3g} mm deep; deeper than {1e3 * way.deepest:.3g} "
            f"mm, {BOUNDS[way.bound]}, small displacements are no truth",
        )
    return min(way.meant, way.deepest) * np.array(PARTS), remarks


def check_depths(way: Way, depths: Floats) -> Floats:
    if not len(depths) or not np.isfinite(depths).all() or depths[0] <= 0.0:
        raise TruthError(f"depths: got {depths.tolist()} m, expected some above 0")
    if is_deeper(float(depths[-1]), way.deepest):
        raise TruthError(
            f"depths: got {1e3 * depths[-1]:.3g} mm, expected at most {1e3 * way.deepest:.3g} mm, "
            f"{BOUNDS[way.bound]}: deeper, small displacements are no truth"
        )
    return depths
