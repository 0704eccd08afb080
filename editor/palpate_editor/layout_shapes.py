# SPDX-License-Identifier: GPL-3.0-or-later
"""What is placed in a layout as it is drawn and turned: shapes, regions, angles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
import palpate
from numpy.typing import NDArray
from palpate.assessment.publish import find_regions
from palpate.layout.document import Layout, Placed, PlacedBody
from palpate.layout.hard_parts import read_part_mesh
from palpate.layout.placed import move_points, read_placed
from palpate.layout.publish import find_organ_colours
from palpate.render.hard_parts import build_shape, place_shape
from palpate.render.shapes import Shape
from scipy.spatial.transform import Rotation

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PartShape:
    """What a file holds, in its own frame."""

    x: Floats
    """[m] (n, 3)"""
    triangles: NDArray[np.int32]
    tree: palpate.AabbTree
    colours: NDArray[np.uint8] | None = None
    """(n, 3) sRGB of a body's vertices."""
    regions: tuple[str, ...] = ()
    """Names of a body's."""
    region_rows: Mapping[str, NDArray[np.int32]] = field(default_factory=dict)
    """Their vertices."""
    drawn: Shape | None = None
    """Of a stone or scenery: smooth but for its edges."""

    @property
    def middle(self) -> Floats:
        """[m] (3,) of its bounding box."""
        return np.asarray(0.5 * (self.x.min(axis=0) + self.x.max(axis=0)))

    @property
    def radius(self) -> float:
        """[m] from there to its farthest vertex."""
        return float(np.linalg.norm(self.x - self.middle, axis=1).max())


Key = tuple[str, str, float]
"""File, hash and scale: what a shape depends on."""


def key_of(part: Placed) -> Key:
    return part.file, part.sha256, float(getattr(part, "scale", 1.0))


def read_shapes(path: Path, layout: Layout, known: dict[Key, PartShape]) -> dict[Key, PartShape]:
    """Of all parts of the layout at `path` whose files can be had; what is `known` is kept."""
    found = {}
    for part in layout.parts:
        key = key_of(part)
        if key in known:
            found[key] = known[key]
            continue
        try:
            found[key] = read_shape(path, part)
        except (OSError, ValueError):  # the checks say why
            continue
    return found


def read_shape(path: Path, part: Any) -> PartShape:
    """Raises Refusal, OSError or ValueError."""
    if not isinstance(part, PlacedBody):
        mesh = read_part_mesh(path, part)
        x, triangles = np.array(mesh.vertices), np.array(mesh.triangles, dtype=np.int32)
        return PartShape(x, triangles, palpate.AabbTree(x, triangles), drawn=build_shape(mesh))
    organ = read_placed(path, part)
    tissue = organ.body.tissue
    x = np.array(palpate.compute_surface(tissue, tissue.rest_position))
    triangles = np.array(tissue.triangles, dtype=np.int32)
    regions = find_regions(organ.path, organ.published)
    tree = palpate.AabbTree(x, triangles)
    return PartShape(x, triangles, tree, find_organ_colours(organ), tuple(regions), regions)


def place_drawn(shape: PartShape, part: Placed) -> Shape:
    """[m] A stone or scenery where it stands."""
    assert shape.drawn is not None
    quaternion = Rotation.from_rotvec(part.rotation).as_quat()
    return place_shape(shape.drawn, part.position, quaternion)


def find_hit(shape: PartShape, part: Placed, origin: Floats, direction: Floats) -> float | None:
    """[m] along a ray to the part where it stands; None beside it."""
    back = Rotation.from_rotvec(part.rotation).inv()
    start = back.apply(np.asarray(origin) - np.asarray(part.position))
    hit = palpate.find_ray_hit(shape.tree, shape.x, start, back.apply(direction))
    return None if hit is None else float(hit.distance)


def find_middle(shape: PartShape, part: Placed) -> Floats:
    """[m] (3,) of a part where it stands."""
    return move_points(part, shape.middle[None])[0]


def move(part: Any, offset: Sequence[float]) -> Any:
    """The part, by an offset [m]."""
    position = np.asarray(part.position) + np.asarray(offset)
    return replace(part, position=tuple(map(float, position)))


def turn(part: Any, axis: Sequence[float], angle: float, pivot: Floats) -> Any:
    """The part turned by an angle [rad] about a unit axis through a point [m]."""
    by = Rotation.from_rotvec(angle * np.asarray(axis))
    position = by.apply(np.asarray(part.position) - pivot) + pivot
    rotation = (by * Rotation.from_rotvec(part.rotation)).as_rotvec()
    return replace(part, position=tuple(map(float, position)), rotation=tuple(map(float, rotation)))


def find_degrees(part: Placed) -> tuple[float, ...]:
    """[degree] about x, then y, then z of the scene, as `--turn` takes them."""
    angles = Rotation.from_rotvec(part.rotation).as_euler("xyz", degrees=True)
    return tuple(0.0 if abs(angle) < 1e-9 else float(angle) for angle in angles)
