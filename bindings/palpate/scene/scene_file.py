# SPDX-License-Identifier: BSD-3-Clause
"""Scene files: an organ's mesh, its constants, the tool and the hand, as readable JSON.

A scene file names a mesh beside it and carries the mesh's SHA-256, so a record made with it can be
replayed years later or refused, never replayed on something else. Every field is checked and an
unknown one is refused: a parameter that has no effect is an error, not a habit.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Collection
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, get_type_hints

import numpy as np

import palpate
from palpate.files.json_document import read_document
from palpate.files.json_part import read_part
from palpate.files.read_file import read_file
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole
from palpate.scene.mesh_file import read_mesh_file
from palpate.scene.nearest import find_nearest
from palpate.scene.scene_parts import (
    CONTACT_CURVATURES,
    CONTACT_HOLDS,
    CONTACT_LAWS,
    FILLED,
    FINITE,
    ORIGINS,
    WITH_NEAR_FIELD,
    MaterialPart,
    ModelPart,
    SceneFile,
    ToolPart,
)
from palpate.scene.tick_cost import LONGEST_TICK, count_affordable

FORMAT, VERSION = "palpate scene", 2
MOST_BYTES = 32 * 2**20
"""Of a scene file: a factor for each of a million vertices, written out, takes 20 MB."""
HINGE_RADII, PAD_RADII = 2.0, 2.5
"""Of a jaw: how far behind its end the hinge is, and how wide its pad. A grasper of 5 mm has jaws
of 1.2 mm with pads of 3 mm (meshes/tools.toml)."""
MOST_SUBSTEPS = 10_000
"""A tick: build_scene refuses more (core/sim/tick/scene.cpp)."""


PARTS = get_type_hints(SceneFile)


def write_scene_file(path: Path, scene: SceneFile) -> None:
    """Writes whole or not at all. Raises OSError."""
    data = {"format": FORMAT, "version": VERSION, **asdict(scene)}
    write_whole(path, (json.dumps(data, indent=2, allow_nan=False) + "\n").encode())


def read_scene_file(path: Path) -> SceneFile:
    """Reads and checks a scene file. Raises Refusal or OSError."""
    data = read_document(
        path,
        format=FORMAT,
        version=VERSION,
        what="a scene file",
        most_bytes=MOST_BYTES,
        older=(1,),
    )
    unknown = set(data) - set(PARTS) - {"format", "version"}
    if unknown:
        raise Refusal(path, "", f"unknown part {sorted(unknown)[0]!r}", ", ".join(PARTS))
    parts = {}
    for name, kind in PARTS.items():
        parts[name] = read_part(path, name, kind, data.get(name, {}))
    if data["version"] == 1 and parts["model"].kind == "shell":
        # before version 2 a wall was felt as its mesh gives way, whatever its file said
        parts["model"] = replace(parts["model"], contact_law="hard")
    return SceneFile(**parts)


def hash_file(path: Path) -> str:
    return hashlib.sha256(read_file(path)).hexdigest()


def build_material(part: MaterialPart) -> palpate.Material:
    return palpate.Material(**asdict(part))


def build_tissue(scene: SceneFile, mesh: palpate.SurfaceMesh) -> palpate.TissueModel:
    """The compiled model of a scene's organ. Raises ValueError naming what is wrong."""
    model = scene.model
    if model.kind in FILLED:
        raise ValueError(
            f"model.kind: got {model.kind!r}, expected a law of surfaces: a scene file has no "
            "tetrahedra; palpate-editor fills an organ and publishes it with them"
        )
    check_choice("kind", model.kind, BUILDERS)
    options = palpate.SurfaceOptions()
    options.home_stiffness = model.home_stiffness
    options.stiffness_scale = list(model.stiffness_scale)
    options.fixed = list(model.fixed)
    options.pressure = model.pressure
    options.drag = model.drag
    options.damping_law = enumerator(palpate.DampingLaw, "model.damping_law", model.damping_law)
    return relax(BUILDERS[model.kind](scene, mesh, options), model)


def relax(tissue: palpate.TissueModel, model: ModelPart) -> palpate.TissueModel:
    """Gives a built tissue its Maxwell branches, but a solid without links, which has none."""
    if model.kind not in ("linear_solid", *FINITE):
        tissue.maxwell = palpate.Maxwell(model.relaxation, model.relaxation_time)
    return tissue


def has_constants_from_tissue(scene: SceneFile) -> bool:
    check_choice("constants", scene.model.constants, ORIGINS)
    return scene.model.constants == "tissue"


def build_springs(
    scene: SceneFile, mesh: palpate.SurfaceMesh, options: palpate.SurfaceOptions
) -> palpate.TissueModel:
    model, material = scene.model, build_material(scene.material)
    if has_constants_from_tissue(scene):
        rule = enumerator(palpate.SpringRule, "model.spring_rule", model.spring_rule)
        return palpate.build_membrane_springs(mesh, material, rule, options)
    return palpate.build_mass_spring(mesh, material, model.stiffness, options)


def build_molecules(
    scene: SceneFile, mesh: palpate.SurfaceMesh, options: palpate.SurfaceOptions
) -> palpate.TissueModel:
    model, material = scene.model, build_material(scene.material)
    angle_law = enumerator(palpate.AngleLaw, "model.angle_law", model.angle_law)
    if has_constants_from_tissue(scene):
        return palpate.build_membrane_molecular(mesh, material, 0.0, angle_law, options)
    constants = palpate.MolecularConstants()
    constants.bond_stiffness = model.stiffness
    constants.bend_stiffness = model.bend_stiffness
    constants.stretch_coupling = model.stretch_coupling
    constants.angle_law = angle_law
    return palpate.build_molecular(mesh, material, constants, options)


def build_wall(
    scene: SceneFile, mesh: palpate.SurfaceMesh, options: palpate.SurfaceOptions
) -> palpate.TissueModel:
    return palpate.build_shell(mesh, build_material(scene.material), options)


BUILDERS: dict[
    str,
    Callable[[SceneFile, palpate.SurfaceMesh, palpate.SurfaceOptions], palpate.TissueModel],
] = {"mass_spring": build_springs, "molecular": build_molecules, "shell": build_wall}
"""Model kind -> what builds it."""


def enumerator(kind: Any, where: str, name: str) -> Any:
    if name not in kind.__members__:
        raise ValueError(f"{where}: got {name!r}, expected one of {', '.join(kind.__members__)}")
    return kind.__members__[name]


def compile_scene(
    scene: SceneFile,
    mesh: palpate.SurfaceMesh,
    tissue: palpate.TissueModel | None = None,
    far_compliance: np.ndarray | None = None,
) -> palpate.Scene:
    """A scene that ticks, of its own tissue or of one that is built. Raises ValueError.

    `far_compliance` [m/N] (n, 6) is that of a solid's surface, where a finer mesh gave it.
    """
    if len(scene.hand.gravity) != 3:
        raise ValueError(f"hand.gravity: got {len(scene.hand.gravity)} numbers, expected 3")
    hand = scene.hand
    tissue = build_tissue(scene, mesh) if tissue is None else relax(tissue, scene.model)
    body = palpate.SoftBody(
        tissue=tissue,
        force_error=hand.force_error,
        integrator=enumerator(palpate.Integrator, "model.integrator", scene.model.integrator),
        contact_modulus=find_contact_modulus(scene),
        far_compliance=() if far_compliance is None else far_compliance,
        contact_facets=feels_facets(scene),
        tied_holds=ties_holds(scene),
        tear_stretch=find_tear_stretch(scene),
    )
    instrument = palpate.Instrument(
        tool=build_tool(scene.tool),
        trocar=find_trocar(scene.tool, tissue),
        coupling=palpate.Coupling(stiffness=hand.coupling, force_max=hand.force_max),
        hold_stiffness=hand.hold_stiffness,
    )
    compiled = palpate.Scene(
        bodies=[body],
        instruments=[instrument],
        gravity=list(hand.gravity),
        rate=hand.rate,
        exchange_rate=hand.exchange_rate,
    )
    palpate.scenario.check_ranges(compiled)
    built = palpate.build_scene(compiled)
    raise_substeps(built.bodies[0], hand.substeps)
    return built


def build_tool(part: ToolPart) -> palpate.Tool:
    """A ball, one capsule from the tip along the shaft, or two jaws of that length."""
    tool = palpate.Tool(radius=part.radius, stiffness=part.stiffness, friction=part.friction)
    if part.length > 0.0 and part.jaw_opening > 0.0:
        tool.capsules = [
            palpate.Capsule(from_=[0.0, side, 0.0], to=[0.0, side, part.length])
            for side in (part.radius, -part.radius)
        ]
        tool.jaws = palpate.Jaws(
            hinge=[0.0, 0.0, part.length + HINGE_RADII * part.radius],
            open=part.jaw_opening,
            grip=part.grip_force,
            pad_area=PAD_RADII * part.radius * part.length,
        )
    elif part.length > 0.0:
        tool.capsules = [palpate.Capsule(to=[0.0, 0.0, part.length])]
    return tool


def find_trocar(part: ToolPart, tissue: palpate.TissueModel) -> np.ndarray | None:
    """[m] Above the middle of the organ; None for a ball, and for a tool that the device turns."""
    if not (part.length > 0.0 and part.trocar_height > 0.0):
        return None
    low, high = tissue.rest_position.min(axis=0), tissue.rest_position.max(axis=0)
    middle = 0.5 * (low + high)
    return np.array([middle[0], middle[1], high[2] + part.trocar_height])


def check_choice(field: str, value: str, choices: Collection[str]) -> None:
    """Raises ValueError for a word of the model that is none of its choices."""
    if value not in choices:
        raise ValueError(f"model.{field}: got {value!r}, expected one of {', '.join(choices)}")


def find_contact_modulus(scene: SceneFile) -> float:
    """[Pa] E / (1 - nu²) of tissue with a near field; 0 for the hard law."""
    model, material = scene.model, scene.material
    check_choice("contact_law", model.contact_law, CONTACT_LAWS)
    if model.kind not in WITH_NEAR_FIELD or model.contact_law == "hard":
        return 0.0
    return material.young_modulus / (1.0 - material.poisson_ratio**2)


def feels_facets(scene: SceneFile) -> bool:
    """Whether a ball feels how curved the facets under it are. Raises ValueError."""
    model = scene.model
    check_choice("contact_curvature", model.contact_curvature, CONTACT_CURVATURES)
    solid = model.kind in FILLED and model.contact_law != "hard"
    return solid and model.contact_curvature == "facets"


def ties_holds(scene: SceneFile) -> bool:
    """Whether what a tool holds gives way as tissue does under it. Raises ValueError."""
    model = scene.model
    check_choice("contact_hold", model.contact_hold, CONTACT_HOLDS)
    near = model.kind in WITH_NEAR_FIELD and model.contact_law != "hard"
    return near and model.contact_hold == "tied"


def find_tear_stretch(scene: SceneFile) -> float:
    """[-] At which links tear; 0 for what has none."""
    model = scene.model
    return 0.0 if model.kind in ("linear_solid", *FINITE) else model.tear_stretch


def raise_substeps(body: palpate.SoftBody, least: int) -> None:
    """Gives a built body that many substeps in the air, and as many more in contact as it had."""
    more = least - body.substeps
    if more > 0:
        body.substeps_max += more
        body.substeps += more


def read_scene_and_mesh(path: Path) -> tuple[SceneFile, palpate.SurfaceMesh]:
    """A scene file and the very mesh it was made with. Raises Refusal or OSError."""
    scene = read_scene_file(path)
    mesh_path = path.parent / scene.organ.mesh
    if mesh_path.is_file() and hash_file(mesh_path) != scene.organ.sha256:
        raise Refusal(
            path,
            "organ.sha256",
            f"{mesh_path.name} with another SHA-256",
            "the mesh the scene was made with",
        )
    return scene, read_mesh_file(mesh_path)


def open_scene(path: Path) -> tuple[SceneFile, palpate.Scene]:
    """Reads a scene file and its mesh and compiles them.

    Raises OSError, or Refusal, also of a constant that is not what tissues have and asks for more
    substeps than a tick has time for: with the nearest value that does not.
    """
    scene, mesh = read_scene_and_mesh(path)
    try:
        compiled = compile_scene(scene, mesh)
    except ValueError as problem:
        refuse_overload(path, scene, mesh, MOST_SUBSTEPS + 1)
        raise Refusal(path, "", str(problem), "a scene that can be built") from None
    refuse_overload(path, scene, mesh, compiled.bodies[0].substeps)
    return scene, compiled


def refuse_overload(path: Path, scene: SceneFile, mesh: palpate.SurfaceMesh, substeps: int) -> None:
    """Raises Refusal where so many substeps [a tick] are more than any machine of today has time
    for, and one constant is to blame."""
    kind, count, rate = scene.model.kind, len(mesh.vertices), scene.hand.rate
    if substeps <= count_affordable(kind, count, rate, LONGEST_TICK):
        return
    most = count_affordable(kind, count, rate)
    nearest = find_nearest(scene, lambda parts: build_tissue(parts, mesh), most)
    if nearest is None or not nearest.excess > 0.0:
        return
    word = "at most" if nearest.limit < nearest.value else "at least"
    raise Refusal(
        path,
        nearest.key,
        f"{nearest.value:g}, which asks for {nearest.needed} substeps a tick",
        f"{word} {nearest.limit:g}, with which it asks for no more than the {most} that a tick of "
        f"{1e3 / rate:g} ms has time for",
    )
