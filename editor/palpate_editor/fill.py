# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids: the tetrahedra inside an organ's surface, and the tissue they make."""

from __future__ import annotations

from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
import palpate
from palpate import scenario
from palpate.scene.scene_file import build_material, enumerator
from palpate.scene.scene_parts import SIZINGS

from palpate_editor import authoring
from palpate_editor.document import Organ, Surface
from palpate_editor.document.constants import LEAST_FINE_RATIO, LEAST_TETRAHEDRA, MOST_TETRAHEDRA
from palpate_editor.edits.own_filling import find_own_filling

MOST_KEPT = 4
"""Fillings of one surface: enough to go back and forth between a few."""

filled: WeakKeyDictionary[Surface, dict[Any, palpate.SolidMesh]] = WeakKeyDictionary()
"""A surface never changes, so neither does what fills it."""

WHOLE = (np.empty(0, np.int32), 1.0)
"""As fine everywhere."""


def fill_surface(
    surface: Surface,
    tetrahedra: int,
    sizing: str = "counted",
    fine: tuple[np.ndarray, float] = WHOLE,
) -> palpate.SolidMesh:
    """So many tetrahedra inside a surface. Raises ValueError where it is open or crosses itself.

    Args:
        surface: What is filled.
        tetrahedra: As asked for; see FillPart.
        sizing: See FillPart.
        fine: (k,) triangles of the surface at which they are smaller, and how much.
    """
    if not LEAST_TETRAHEDRA <= tetrahedra <= MOST_TETRAHEDRA:
        raise ValueError(
            f"fill.tetrahedra: got {tetrahedra}, expected a whole number of {LEAST_TETRAHEDRA} "
            f"to {MOST_TETRAHEDRA}"
        )
    if sizing not in SIZINGS:
        raise ValueError(f"fill.sizing: got {sizing!r}, expected one of {', '.join(SIZINGS)}")
    kept = filled.setdefault(surface, {})
    key = (tetrahedra, sizing, fine[0].tobytes(), fine[1])
    solid = kept.get(key)
    if solid is None:
        mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)
        if sizing == "estimated":
            solid = authoring.fill_interior(mesh, authoring.choose_cell_size(mesh, tetrahedra))
        else:
            solid = authoring.fill_to_count(mesh, tetrahedra, fine[0].tolist(), fine[1])
        if len(kept) >= MOST_KEPT:
            kept.pop(next(iter(kept)), None)
        kept[key] = solid
    return solid


def fill_organ(organ: Organ) -> palpate.SolidMesh:
    """The tetrahedra of an organ. Raises ValueError naming what is wrong."""
    assert organ.surface is not None
    own = find_own_filling(organ)
    if own is not None:
        return own
    fill = organ.fill
    return fill_surface(organ.surface, fill.tetrahedra, fill.sizing, find_fine(organ))


def find_fine(organ: Organ) -> tuple[np.ndarray, float]:
    """Triangles at the fine region, and how much finer they are filled. Raises ValueError for a
    region that is not there, or touches no triangle."""
    assert organ.surface is not None
    name, ratio = organ.fill.fine_region, organ.fill.fine_ratio
    if not name:
        return WHOLE
    ids = find_region(organ, "fill.fine_region", name)
    if not LEAST_FINE_RATIO <= ratio <= 1.0:
        raise ValueError(f"fill.fine_ratio: got {ratio:g}, expected {LEAST_FINE_RATIO:g} to 1")
    touched = np.isin(organ.surface.triangles, ids).any(axis=1)
    return np.flatnonzero(touched).astype(np.int32), ratio


BUILDERS = {
    "solid": palpate.build_solid,
    "linear_solid": palpate.build_linear_solid,
    "corotated_solid": palpate.build_corotated_solid,
    "neo_hookean_solid": palpate.build_neo_hookean_solid,
}
"""Model kind -> what builds it of tetrahedra."""


def build_filled(organ: Organ) -> palpate.TissueModel:
    """The solid of an organ under its own surface. Raises ValueError naming what is wrong.

    What is painted on the surface is carried inside: a vertex of the tetrahedra is as stiff as the
    nearest vertex of the surface is scaled, and held where it lies on the outside and that one is.
    """
    assert organ.surface is not None
    reach = find_reach(organ)
    surface = palpate.SurfaceMesh(organ.surface.vertices, organ.surface.triangles)
    check_asked(organ)
    solid = fill_organ(organ)
    check_room(solid, organ.model.kind)
    nearest = find_nearest(np.asarray(solid.vertices), organ.surface.vertices)
    outside = np.zeros(len(nearest), dtype=bool)
    outside[palpate.find_boundary(solid)] = True
    options = palpate.SolidOptions(
        nodal_share=organ.fill.nodal_share,
        fixed=np.flatnonzero(outside & organ.fixed[nearest]),
        stiffness_scale=organ.stiffness_scale[nearest],
        drag=organ.model.drag,
        damping_law=enumerator(palpate.DampingLaw, "model.damping_law", organ.model.damping_law),
    )
    model = BUILDERS[organ.model.kind](solid, build_material(organ.material), options)
    model = palpate.cover_with_skin(model, surface)
    return model if reach is None else palpate.limit_reach(model, reach)


FILLED_TO = 0.8
"""[-] of the tetrahedra that are asked for, that a filling has at the least: it is good to a
tenth where nothing is finer."""


def check_asked(organ: Organ) -> None:
    """Raises ValueError for so many tetrahedra that those of the filling cannot but be more than a
    published file has room for: a filling of so many takes minutes."""
    fill = organ.fill
    counted = fill.sizing == "counted" and fill.tetrahedra <= MOST_TETRAHEDRA
    if counted and find_own_filling(organ) is None:
        require_room(int(FILLED_TO * fill.tetrahedra), fill.tetrahedra, organ.model.kind)


def check_room(solid: palpate.SolidMesh, kind: str) -> None:
    """Raises ValueError for more tetrahedra than a published file has room for."""
    require_room(len(solid.tetrahedra), len(solid.tetrahedra), kind)


def require_room(least: int, count: int, kind: str) -> None:
    """Raises ValueError where at `least` so many tetrahedra are too many; `count` were got."""
    most = scenario.MOST_ELASTIC if kind == "linear_solid" else scenario.MOST_TETRAHEDRA
    if least > most:
        raise ValueError(
            f"fill.tetrahedra: got {count}, expected at most {most} in a solid of this kind, which "
            "a published file has room for: ask for fewer"
        )


def find_reach(organ: Organ) -> np.ndarray | None:
    """(k,) the vertices of the surface on which a linear solid can be pushed; None for all of them.

    Raises ValueError where they are those of a region that is not there, or has none.
    """
    name = organ.fill.reach
    if organ.model.kind != "linear_solid" or not name:
        return None
    return find_region(organ, "fill.reach", name)


def find_region(organ: Organ, where: str, name: str) -> np.ndarray:
    """(k,) its vertices. Raises ValueError where there is none of that name, or none in it."""
    if name not in organ.regions:
        known = ", ".join(map(repr, organ.regions)) or "this organ has none"
        raise ValueError(f"{where}: got {name!r}, expected a region of the organ: {known}")
    if not organ.regions[name].size:
        raise ValueError(f"{where}: got no vertex in {name!r}, expected at least one")
    return organ.regions[name]


def find_nearest(points: np.ndarray, among: np.ndarray) -> np.ndarray:
    """(n,) the vertex of `among` nearest to each point."""
    rows = max(1, 2_000_000 // max(1, len(among)))
    found = [
        np.linalg.norm(points[at : at + rows, None] - among[None], axis=2).argmin(axis=1)
        for at in range(0, len(points), rows)
    ]
    return np.concatenate(found)
