# SPDX-License-Identifier: GPL-3.0-or-later
"""Organs small enough for a test, whole enough for every edit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from functools import cache

import numpy as np
from palpate.scene.scene_parts import (
    AppearancePart,
    FillPart,
    HandPart,
    MaterialPart,
    ModelPart,
    ToolPart,
)
from palpate_editor.document import (
    AppliedTissue,
    Assembly,
    Decimation,
    FarField,
    Filling,
    History,
    Line,
    Organ,
    Repairs,
    Segmentation,
    Source,
    Surface,
    Translation,
)
from palpate_editor.edits import PaintStiffness, SetName, SetRegion
from palpate_meshes.generate import ellipsoid, sheet

SOURCE = Source(
    file="dalağı.stl",
    folder="/organs",
    sha256="0123456789abcdef" * 4,
    format="STL",
    parts_available=("left", "right"),
    parts=("left",),
    unit="mm",
    unit_guessed=True,
    unit_reason="120 units from corner to corner: above 60, so millimetres",
    up="z",
    up_guessed=True,
    up_reason="the format states none; medical programs have z up",
    repairs=Repairs(welded_vertices=12, degenerate_triangles=1),
    notes=("a colour was ignored",),
)

SEGMENTATION = Segmentation(
    series="1.2.826.0.1",
    labels=(1, 7),
    low=None,
    high=1.0 / 3.0,
    smooth=0.8,
    largest=True,
    least_volume=1e-7,
    size=(122, 101, 30),
    spacing=(0.003, 0.003, 0.003),
    tilt=18.0,
    voxel_volume=2.552e-4,
    volume=2.557e-4,
    volume_change=0.0018,
    pieces_dropped=2,
    shells_dropped=1,
)

ASSEMBLY = Assembly(weld=1e-4 / 3.0, unite=False, subtracted=("right",), regions=True)

FILLING = Filling(
    np.array([[0.0, 0, 0], [0.1, 0, 0], [0, 0.06, 0], [0, 0, 0.04], [0.06, 0.06, 0.06]]),
    np.array([[0, 1, 2, 3], [1, 2, 3, 4]]),
)

TISSUES = (
    AppliedTissue("pancreas", "pancreas", "", 6.4e3, 0.45, None, 2e-3, "recalled", "from memory"),
    AppliedTissue("fat", "yağ", "hilum", 1e3 / 3.0, None, None, None, "unknown", ""),
)

APPEARANCE = AppearancePart(
    colour=(0.37, 0.135, 0.2),
    pattern_colour=(0.5, 0.22, 0.27),
    pattern_size=0.003,
    pattern_strength=0.5,
    vein_colour=(0.45, 0.1, 0.1),
    vein_strength=0.25,
    relief=0.09,
    gloss=0.8,
    roughness=0.3,
    subsurface=1.0 / 3.0,
)


generate = cache(ellipsoid)


def surface_of(vertices: int = 60) -> Surface:
    return Surface(*generate(vertices=vertices))


def open_surface() -> Surface:
    return Surface(*sheet())


def make_organ(vertices: int = 60, imported: int | None = 150) -> Organ:
    """A closed organ in which every field has a value of its own."""
    surface = surface_of(vertices)
    whole = surface if imported is None else surface_of(imported)
    rng = np.random.default_rng(3)
    decimation = Decimation(
        vertices_before=len(whole.vertices),
        triangles_before=len(whole.triangles),
        vertices=len(surface.vertices),
        triangles=len(surface.triangles),
        smallest_angle_deg=31.25,
        mean_distance=1.25e-4,
        max_distance=1.0 / 3.0 * 1e-3,
    )
    return Organ(
        name="dalak",
        source=SOURCE,
        segmentation=SEGMENTATION,
        tissues=TISSUES,
        assembly=ASSEMBLY,
        imported=whole,
        filling=FILLING,
        surface=surface,
        decimation=None if imported is None else decimation,
        material=MaterialPart(density=1050.0, damping_ratio=0.3),
        model=ModelPart(stiffness=120.0, home_stiffness=1e6, drag=8.0),
        fill=FillPart(tetrahedra=1200, nodal_share=0.75, reach="hilum"),
        far_field=FarField("0123abcd", 0.008, 8123, rng.random(6 * vertices) - 0.3),
        fixed=np.arange(vertices) < 5,
        stiffness_scale=1.0 + rng.random(vertices),
        regions={"hilum": np.array([1, 4, 7]), "alt uç": np.array([], int)},
        tool=ToolPart(radius=0.012),
        hand=HandPart(coupling=900.0, gravity=(0.0, 0.0, -9.81)),
        appearance=APPEARANCE,
        title="Press the spleen",
        task="Bas ve bırak.",
        languages={"en": Translation("Press the spleen", "Press and let go.")},
        assessment='{"palpate_scenario": 1}',
    )


def with_history(organ: Organ) -> Organ:
    """The organ after a stroke, a region and a name."""
    for edit in (
        PaintStiffness(np.array([7, 9]), np.array([2.5, 1.0 / 3.0])),
        SetRegion("kapı", np.array([30, 20])),
        SetName("karaciğer"),
    ):
        organ = edit(organ)
    return organ


def nested() -> Surface:
    """A small copy of an organ in the middle of it."""
    one = surface_of()
    middle = one.vertices.mean(axis=0)
    within = middle + 0.3 * (one.vertices - middle)
    both = np.concatenate([one.triangles, one.triangles + len(one.vertices)])
    return Surface(np.concatenate([one.vertices, within]), both)


def two_shells() -> Surface:
    """A large and a small ellipsoid side by side."""
    large, small = surface_of(60), surface_of(50)
    away = 0.3 * small.vertices + [0.5, 0.0, 0.0]
    return Surface(
        np.concatenate((away, large.vertices)),
        np.concatenate((small.triangles, large.triangles + len(away))),
    )


def same(one: Organ, other: Organ) -> bool:
    """Whether two organs are equal in every number and letter, bit for bit."""
    return all(same_value(getattr(one, f.name), getattr(other, f.name)) for f in fields(Organ))


def same_value(a: object, b: object) -> bool:
    for kind in (FarField, History, Line, Organ):
        if isinstance(a, kind) and isinstance(b, kind):
            return all(same_value(getattr(a, f.name), getattr(b, f.name)) for f in fields(kind))
    if isinstance(a, list | tuple) and isinstance(b, list | tuple):
        alike = type(a) is type(b) and len(a) == len(b)
        return alike and all(map(same_value, a, b))
    if isinstance(a, Filling) and isinstance(b, Filling):
        return same_value(a.vertices, b.vertices) and same_value(a.tetrahedra, b.tetrahedra)
    if isinstance(a, Surface) and isinstance(b, Surface):
        return same_value(a.vertices, b.vertices) and same_value(a.triangles, b.triangles)
    if isinstance(a, np.ndarray) and isinstance(b, np.ndarray):
        return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
    if isinstance(a, Mapping) and isinstance(b, Mapping):
        return list(a) == list(b) and all(same_value(a[key], b[key]) for key in a)
    return type(a) is type(b) and a == b


def untitled(organ: Organ) -> Organ:
    return replace(organ, title="", task="")


def fin() -> Surface:
    """A closed surface with a triangle that stands on one of its edges."""
    surface = surface_of(60)
    i, j, _ = surface.triangles[0]
    middle = surface.vertices[[i, j]].mean(axis=0)
    tip = middle + 0.5 * (middle - surface.vertices.mean(axis=0))
    return Surface(np.vstack([surface.vertices, tip]), np.vstack([surface.triangles, [i, j, 60]]))


def moebius(n: int = 40) -> Surface:
    """A band of 3 cm radius and 1 cm width with half a turn in it."""
    angle = 2 * np.pi * np.arange(n) / n
    rows = []
    for side in (-5e-3, 5e-3):
        r = 0.03 + side * np.cos(0.5 * angle)
        rows.append(
            np.column_stack([r * np.cos(angle), r * np.sin(angle), side * np.sin(0.5 * angle)])
        )
    here = np.arange(n)
    low, high = 2 * here, 2 * here + 1
    next_low, next_high = np.append(low[1:], 1), np.append(high[1:], 0)
    triangles = np.concatenate(
        [np.column_stack([low, next_low, high]), np.column_stack([high, next_low, next_high])]
    )
    return Surface(np.stack(rows, axis=1).reshape(-1, 3), triangles)
