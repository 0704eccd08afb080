# SPDX-License-Identifier: BSD-3-Clause
"""Makes meshes/scenes: what ships and is no single organ. Called by palpate_meshes.build."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import palpate
from palpate import scenario
from palpate.assessment.check_problem import ERROR
from palpate.layout.assemble import read_assembly
from palpate.layout.check import check
from palpate.layout.document import History, change_part
from palpate.layout.gaps import Surface
from palpate.layout.layout_file import read_layout, write_layout
from palpate.layout.publish import make_scenario
from palpate.scene.scene_file import hash_file
from palpate_editor.document import AppliedTissue
from palpate_editor.tissue_library import choose, find_tissue, read_library
from palpate_meshes.catalogue import HERE, read_tissues
from palpate_meshes.generate.layered_block import (
    FAT,
    LUMP,
    MUSCLE,
    SIDE,
    SKIN,
    find_layer_values,
    find_lump_share,
    layered_block,
)
from palpate_meshes.generate.sling import Sling, sling

FOLDER = HERE / "scenes"
LAYERS = ("skin", "fat", "muscle")
"""Names in the tissue library, from above."""
LUMP_MODULUS = 4.2e4
"""[Pa] Chosen: nineteen times that of the fat around it, as hard tumours of the breast are (42.5
kPa of those of high grade, Samani et al., Phys Med Biol 2007, 52, 1565, from memory)."""
POISSON_RATIO, DAMPING_RATIO, DRAG = 0.45, 0.3, 8.0
"""[-], [-], [1/s] as those of the other solids that ship."""
TIP = 8e-3
"""[m] Radius of the pad of a finger."""
COLOURS = {"skin": (226, 178, 150), "fat": (236, 208, 120), "muscle": (150, 52, 46)}
"""sRGB"""
PERITONEUM = palpate.Material(
    density=1000.0, young_modulus=5e4, poisson_ratio=0.45, damping_ratio=0.3, wall_thickness=2e-3
)
"""Peritoneum with the fat under it, together as taut as 100 N/m: chosen, for nothing that was
checked is known of it."""
ALONG, ACROSS, SPACING = (-0.012, 0.028), 0.036, 5.5e-3
"""[m] of the sheet over the gallbladder, from the middle of the sac."""
OFFSET = 1e-3
"""[m] of the sheet over what it covers: twice the thickness of the barriers."""
PALE = (0.86, 0.72, 0.62)
"""sRGB of the peritoneum."""
POINTS_ALONG, POINTS_ACROSS = 17, 4
"""Of a spring, and of a tetrahedron's sides, at which layers are looked up."""


def choose_layers() -> list[AppliedTissue]:
    """Skin, fat and muscle as the library has them."""
    library = read_library(own=False)
    return [choose(find_tissue(library, name)) for name in LAYERS]


def build_block(lump: float | None = LUMP_MODULUS) -> palpate.TissueModel:
    """The block held at its bottom and its sides: one solid of springs and volumes, in which each
    spring and each tetrahedron is as stiff as the mean of what it lies in.

    Args:
        lump: [Pa] Young's modulus of the lump; None for a block without one.
    """
    layers = choose_layers()
    points, tetrahedra = layered_block()
    held = (points[:, 2] < 1e-9) | (np.abs(points[:, :2]).max(axis=1) > 0.4999 * SIDE)
    moduli = read_layers(layers, "young_modulus")
    densities = read_layers(layers, "density")
    base = moduli[1]
    tissue = palpate.build_solid(
        palpate.SolidMesh(points, tetrahedra),
        palpate.Material(
            density=densities[1],
            young_modulus=base,
            poisson_ratio=POISSON_RATIO,
            damping_ratio=DAMPING_RATIO,
        ),
        palpate.SolidOptions(fixed=np.flatnonzero(held), drag=DRAG),
    )

    def find_factors(at: np.ndarray) -> np.ndarray:
        """(n,) of the base modulus, over points (n, k, 3) [m]."""
        young = find_layer_values(at, moduli)
        if lump is not None:
            young = young + find_lump_share(at) * (lump - young)
        return np.asarray(young.mean(axis=1) / base)

    x = np.asarray(tissue.rest_position)
    ends, corners = np.asarray(tissue.springs.ends), np.asarray(tissue.volumes.corners)
    along = ((np.arange(POINTS_ALONG) + 0.5) / POINTS_ALONG)[:, None]
    of_springs = find_factors(x[ends[:, None, 0]] * (1.0 - along) + x[ends[:, None, 1]] * along)
    np.asarray(tissue.springs.stiffness)[:] *= of_springs
    np.asarray(tissue.springs.damping)[:] *= np.sqrt(of_springs)  # as damped as before
    weights = spread_points()
    of_volumes = find_factors(np.einsum("pk,tkd->tpd", weights, x[corners]))
    np.asarray(tissue.volumes.bulk)[:] *= of_volumes
    np.asarray(tissue.mass)[:] *= find_layer_values(x, densities) / densities[1]
    return tissue


def read_layers(layers: list[AppliedTissue], quantity: str) -> tuple[float, float, float]:
    """A constant of skin, fat and muscle, SI."""
    skin, fat, muscle = (float(getattr(layer, quantity)) for layer in layers)
    return skin, fat, muscle


def spread_points() -> np.ndarray:
    """(k, 4) Barycentric coordinates of points all over the inside of a tetrahedron."""
    n = POINTS_ACROSS
    counts = range(n + 1)
    rows = [(a, b, c, n - a - b - c) for a in counts for b in counts for c in counts]
    inner = np.array([row for row in rows if row[3] >= 0], dtype=float)
    return (inner + 0.25) / (n + 1.0)


def build_block_scene(lump: float | None = LUMP_MODULUS) -> palpate.Scene:
    """The block under the pad of a finger."""
    tool = palpate.Tool(radius=TIP)
    return palpate.build_scene(
        palpate.Scene(
            bodies=[palpate.SoftBody(tissue=build_block(lump))],
            instruments=[palpate.Instrument(tool=tool)],
        )
    )


def make_layered_block() -> scenario.Scenario:
    """With where the lump is and what each layer is of in the designer's document."""
    scene = build_block_scene()
    x = np.asarray(scene.bodies[0].tissue.rest_position)
    colours = np.array([COLOURS[name] for name in LAYERS], dtype=np.uint8)
    of_layer = np.where(x[:, 2] > MUSCLE + FAT, 0, np.where(x[:, 2] > MUSCLE, 1, 2))
    content = {
        "appearance": asdict(read_tissues()["soft_patch"].appearance),
        "layers": [
            {
                "tissue": name,
                "thickness": thickness,
                "young_modulus": layer.young_modulus,
                "density": layer.density,
                "source": layer.source,
            }
            for name, thickness, layer in zip(
                LAYERS, (SKIN, FAT, MUSCLE), choose_layers(), strict=True
            )
        ],
        "lump": {"centre": LUMP.centre, "radius": LUMP.radius, "young_modulus": LUMP_MODULUS},
    }
    return scenario.Scenario(
        scene=scene,
        title="Skin, fat and muscle with a hidden lump",
        task="Feel for the lump under the skin: nothing of it is seen.",
        authored=json.dumps({"format": "palpate layered block", "version": 5, "content": content}),
        authored_arrays={"surface/vertices": x, "surface/colours": colours[of_layer]},
        languages={
            "tr": scenario.Words(
                "Gizli kitleli deri, yağ ve kas",
                "Derinin altındaki kitleyi elle arayın: hiçbir yeri görünmez.",
            )
        },
    )


def place_peritoneum(sac: Surface, liver: Surface) -> Sling:
    """Along the sac towards its fundus, across it from liver to liver, and away from there."""
    nearest = [palpate.find_closest_point(liver.tree, liver.x, p) for p in sac.used]
    away = np.mean(sac.used - np.array([found.point for found in nearest]), axis=0)
    away /= np.linalg.norm(away)
    middle = sac.used.mean(axis=0)
    along = np.linalg.svd(sac.used - middle, full_matrices=False)[2][0]
    along -= (along @ away) * away
    along /= np.linalg.norm(along)
    reach = (sac.used - middle) @ along
    if reach.max() > -reach.min():  # the duct is the longer end, and lies at u < 0
        along = -along
    axes = np.stack([along, np.cross(away, along), away])
    return Sling(middle, axes, ALONG, ACROSS, SPACING)


def lift(surface: Surface) -> np.ndarray:
    """[m] (n, 3) The vertices in use, OFFSET outside."""
    normals = np.asarray(palpate.compute_vertex_normals(surface.x, surface.triangles))
    used = np.unique(surface.triangles)
    return np.asarray(surface.x[used] + OFFSET * normals[used])


def make_peritoneum() -> scenario.Scenario:
    """A sheet over the gallbladder of liver_gallbladder, held where it comes to the liver."""
    path = FOLDER / "liver_gallbladder.layout.json"
    sac, liver = read_assembly(path, read_layout(path).now).surfaces
    points, triangles, sides = sling(lift(sac), lift(liver), place_peritoneum(sac, liver))
    tissue = palpate.build_membrane_springs(
        palpate.SurfaceMesh(points, triangles),
        PERITONEUM,
        options=palpate.SurfaceOptions(fixed=sides, drag=DRAG),
    )
    look = replace(read_tissues()["soft_patch"].appearance, colour=PALE)
    content = {"appearance": asdict(look)}
    return scenario.Scenario(
        scene=palpate.build_scene(palpate.make_scene(tissue)),
        title="Peritoneum over a gallbladder",
        authored=json.dumps({"format": "palpate sheet", "version": 5, "content": content}),
    )


def publish_covered() -> scenario.Scenario:
    """With the sheet made again."""
    file = FOLDER / "peritoneum.palpate"
    scenario.write(file, make_peritoneum())
    path = FOLDER / "liver_gallbladder_peritoneum.layout.json"
    history = read_layout(path)
    now = change_part(history.now, "peritoneum", lambda part: replace(part, sha256=hash_file(file)))
    write_layout(path, History(now, history.before, history.undone))
    return publish_layout(path.name.removesuffix(".layout.json"))


def publish_layout(name: str) -> scenario.Scenario:
    """Of meshes/scenes/NAME.layout.json, as `palpate scene publish` does. Raises ValueError for a
    layout that this would not publish."""
    path = FOLDER / f"{name}.layout.json"
    layout = read_layout(path).now
    checked = check(path, layout, measures=False)
    if checked.scene is None or checked.assembly is None or checked.has_errors:
        found = [each for each in checked.problems if each.severity == ERROR]
        raise ValueError("\n".join(f"{path.name}: {each.where}: {each.message}" for each in found))
    return make_scenario(layout, checked.assembly, checked.scene)


SCENES: dict[str, Callable[[], scenario.Scenario]] = {
    "kidney_stone_removal": lambda: publish_layout("kidney_stone_removal"),
    "layered_block": make_layered_block,
    "liver_gallbladder": lambda: publish_layout("liver_gallbladder"),
    "liver_gallbladder_peritoneum": publish_covered,
}
"""Name of the file in meshes/scenes -> what makes it."""


def write_scene(name: str) -> Path:
    """Makes one of SCENES again."""
    path = FOLDER / f"{name}.palpate"
    scenario.write(path, SCENES[name]())
    return path
