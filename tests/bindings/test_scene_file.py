# SPDX-License-Identifier: BSD-3-Clause
"""Scene files: round trip, and refusal of everything that is not one."""

from __future__ import annotations

import json
from dataclasses import fields, replace

import numpy as np
import pytest
from palpate.files.refusal import Refusal
from palpate.layout.document import History, Layout
from palpate.layout.layout_file import read_layout, write_layout
from palpate.scene.mesh_file import read_mesh_file
from palpate.scene.scene_file import (
    compile_scene,
    hash_file,
    open_scene,
    read_scene_file,
    write_scene_file,
)
from palpate.scene.scene_parts import (
    HandPart,
    MaterialPart,
    ModelPart,
    OrganPart,
    SceneFile,
    ToolPart,
)

OCTAHEDRON = """v 0.03 0 0
v -0.03 0 0
v 0 0.03 0
v 0 -0.03 0
v 0 0 0.03
v 0 0 -0.03
f 1 3 5
f 3 2 5
f 2 4 5
f 4 1 5
f 3 1 6
f 2 3 6
f 4 2 6
f 1 4 6
"""


@pytest.fixture
def organ(tmp_path):
    path = tmp_path / "organ.obj"
    path.write_text(OCTAHEDRON, encoding="utf-8")
    return path


def scene_of(organ) -> SceneFile:
    return SceneFile(OrganPart("octahedron", organ.name, hash_file(organ)))


def test_a_scene_file_comes_back_as_it_went(organ, tmp_path):
    scene = replace(
        scene_of(organ),
        material=MaterialPart(density=1000.0, wall_thickness=0.002),
        model=ModelPart(kind="molecular", stretch_coupling=-0.01, fixed=(0, 5)),
        hand=HandPart(gravity=(0.0, 0.0, -9.81)),
    )

    write_scene_file(tmp_path / "a.json", scene)

    assert read_scene_file(tmp_path / "a.json") == scene


def test_an_opened_scene_ticks_with_its_own_constants(organ, tmp_path):
    scene = replace(scene_of(organ), model=ModelPart(stiffness=70.0), tool=ToolPart(radius=0.002))
    write_scene_file(tmp_path / "a.json", scene)

    _, compiled = open_scene(tmp_path / "a.json")

    assert np.all(np.asarray(compiled.bodies[0].tissue.springs.stiffness) == 70.0)
    assert compiled.instruments[0].tool.radius == 0.002
    assert compiled.bodies[0].substeps >= 1


def change(data: dict, path: str, value: object) -> None:
    *outer, last = path.split(".")
    for key in outer:
        data = data[key]
    if value is DELETE:
        del data[last]
    else:
        data[last] = value


DELETE = object()


@pytest.mark.parametrize(
    ("path", "value", "where"),
    [
        ("format", "other", "format"),
        ("version", 3, "version"),
        ("extra", {}, ""),
        ("model.stifness", 3.0, "model.stifness"),
        ("model.stiffness", "3", "model.stiffness"),
        ("model.stiffness", True, "model.stiffness"),
        ("model.fixed", [0.5], "model.fixed"),
        ("tool", 3, "tool"),
        ("organ.mesh", DELETE, "organ"),
        ("hand.gravity", [0, 0, "down"], "hand.gravity"),
    ],
)
def test_a_damaged_scene_file_is_refused_where_it_is_wrong(organ, tmp_path, path, value, where):
    file = tmp_path / "a.json"
    write_scene_file(file, scene_of(organ))
    data = json.loads(file.read_text(encoding="utf-8"))
    change(data, path, value)
    file.write_text(json.dumps(data), encoding="utf-8")

    with pytest.raises(Refusal) as refusal:
        read_scene_file(file)

    assert refusal.value.where == where
    assert refusal.value.file == str(file)


@pytest.mark.parametrize(("version", "law"), [(1, "hard"), (2, "near_field")])
def test_a_wall_of_an_older_file_is_felt_by_the_hard_law_as_before(organ, tmp_path, version, law):
    file, scene = tmp_path / "a.json", scene_of(organ)
    write_scene_file(file, replace(scene, model=replace(scene.model, kind="shell")))
    data = json.loads(file.read_text(encoding="utf-8"))
    file.write_text(json.dumps(data | {"version": version}), encoding="utf-8")

    assert read_scene_file(file).model.contact_law == law


@pytest.mark.parametrize("text", ["", "{", "[]", "null", '{"format": "palpate scene"', "\xff\xfe"])
def test_text_that_is_no_scene_is_refused(tmp_path, text):
    file = tmp_path / "a.json"
    file.write_bytes(text.encode("latin-1"))

    with pytest.raises(Refusal):
        read_scene_file(file)


def test_another_kind_of_file_is_named(tmp_path):
    layout = tmp_path / "two.layout.json"
    write_layout(layout, History(Layout()))

    with pytest.raises(Refusal, match="got a layout, expected a scene file"):
        read_scene_file(layout)
    write_scene_file(tmp_path / "organ.scene.json", SceneFile(OrganPart("a", "a.obj", "0" * 64)))
    with pytest.raises(Refusal, match="got a scene file, expected a layout"):
        read_layout(tmp_path / "organ.scene.json")


def test_numbers_that_are_not_finite_are_refused(organ, tmp_path):
    file = tmp_path / "a.json"
    write_scene_file(file, scene_of(organ))
    file.write_text(
        file.read_text(encoding="utf-8").replace('"drag": 2.0', '"drag": NaN'), encoding="utf-8"
    )

    with pytest.raises(Refusal) as refusal:
        read_scene_file(file)

    assert refusal.value.where == "model.drag"


def test_a_scene_whose_mesh_has_changed_is_refused(organ, tmp_path):
    write_scene_file(tmp_path / "a.json", scene_of(organ))
    organ.write_text(OCTAHEDRON.replace("0.03 0 0", "0.031 0 0", 1), encoding="utf-8")

    with pytest.raises(Refusal) as refusal:
        open_scene(tmp_path / "a.json")

    assert refusal.value.where == "organ.sha256"


def test_constants_no_tissue_can_have_are_refused_with_the_builders_sentence(organ, tmp_path):
    write_scene_file(tmp_path / "a.json", replace(scene_of(organ), model=ModelPart(stiffness=-1.0)))

    with pytest.raises(Refusal, match="stiffness"):
        open_scene(tmp_path / "a.json")


def every_number() -> list[tuple[str, str, float]]:
    changed = {
        "wall_thickness": 0.004,
        "exchange_rate": 100.0,
        "tear_stretch": 1.6,
        "home_stiffness": 2e5,
        "poisson_ratio": None,
        "young_modulus": None,  # these two act on the default home springs of walls, or later
        "force_error": None,  # asks for home springs: below
    }
    rows = []
    for part, kind in (
        ("material", MaterialPart),
        ("model", ModelPart),
        ("tool", ToolPart),
        ("hand", HandPart),
    ):
        for f in fields(kind):
            value = getattr(kind(), f.name)
            if isinstance(value, float) or f.name in changed:
                new = changed.get(f.name, value * 1.5 if value else 0.01)
                if new is not None:
                    rows.append((part, f.name, new))
    return rows


@pytest.mark.parametrize(("part", "name", "value"), every_number())
def test_every_number_of_a_scene_file_changes_what_is_compiled(organ, part, name, value):
    mesh = read_mesh_file(organ)
    base = replace(scene_of(organ), model=ModelPart(kind="molecular"))
    if name in ("trocar_height", "jaw_opening", "grip_force"):  # of a shaft, or of jaws on one
        opening = 0.5 if name == "grip_force" else 0.0
        base = replace(base, tool=replace(base.tool, length=0.02, jaw_opening=opening))
    changed = replace(base, **{part: replace(getattr(base, part), **{name: value})})

    def values(scene: SceneFile) -> list:
        s = compile_scene(scene, mesh)
        t = s.bodies[0].tissue
        return [
            s.bodies[0].tear_stretch,
            list(t.mass),
            list(t.bonds.stiffness),
            list(t.bonds.damping),
            list(t.home),
            np.asarray(t.angles.bend_stiffness).tolist(),
            np.asarray(t.angles.stretch_coupling).tolist(),
            t.pressure,
            t.drag,
            t.maxwell.ratio,
            t.maxwell.time,
            s.instruments[0].tool.radius,
            s.instruments[0].tool.stiffness,
            s.instruments[0].tool.friction,
            [list(capsule.to) for capsule in s.instruments[0].tool.capsules],
            str(s.instruments[0].tool.jaws),
            None if s.instruments[0].trocar is None else list(s.instruments[0].trocar),
            s.instruments[0].coupling.stiffness,
            s.instruments[0].coupling.force_max,
            s.instruments[0].hold_stiffness,
            s.rate,
            s.exchange_rate,
        ]

    assert values(base) != values(changed)


def test_a_force_error_is_compiled_for_walls_and_refused_without_home_springs(organ):
    mesh = read_mesh_file(organ)
    scene = replace(scene_of(organ), hand=HandPart(force_error=2e-3))
    with pytest.raises(ValueError, match=r"force_error.*home springs"):
        compile_scene(scene, mesh)

    wall = replace(scene, material=MaterialPart(wall_thickness=0.004))
    assert compile_scene(wall, mesh).bodies[0].force_error == 2e-3


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("v 0 0\n", "line 1"),
        ("v 0 0 nan\n", "line 1"),
        ("v 0 0 0\nsurf 0 0 1\n", "line 2"),
        ("v 0 0 0\nf 1 2 x\n", "line 2"),
        ("v 0 0 0\nf 1 2 9\n", "line 2"),
        ("v 0 0 0\nf 0 1 1\n", "line 2"),
        ("v 0 0 0\n", ""),
        ("", ""),
    ],
)
def test_a_mesh_file_that_is_not_one_is_refused_where_it_is_wrong(tmp_path, text, where):
    file = tmp_path / "a.obj"
    file.write_text(text, encoding="utf-8")

    with pytest.raises(Refusal) as refusal:
        read_mesh_file(file)

    assert refusal.value.where == where
