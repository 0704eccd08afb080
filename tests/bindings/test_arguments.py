# SPDX-License-Identifier: BSD-3-Clause
"""Arguments are what a user of NumPy expects, or are refused in one sentence."""

from __future__ import annotations

import copy
import re
from pathlib import Path

import numpy as np
import palpate
import pytest
from bound_values import all_classes
from surfaces import MEMBRANE, chain, ellipsoid, organ_scene, sheet

MESH = sheet(4, 0.03)


def test_a_mask_fixes_the_vertices_where_it_is_true():
    low = MESH.vertices[:, 1] < 0.005
    options = palpate.SurfaceOptions(fixed=low)

    model = palpate.build_mass_spring(MESH, MEMBRANE, 50.0, options)

    assert options.fixed.tolist() == [0, 1, 2, 3]
    assert model.fixed.tolist() == [0, 1, 2, 3]
    assert palpate.SurfaceOptions(fixed=[True, False, True]).fixed.tolist() == [0, 2]


@pytest.mark.parametrize(
    "build",
    [
        lambda options: palpate.build_mass_spring(MESH, MEMBRANE, 50.0, options),
        lambda options: palpate.build_membrane_springs(MESH, MEMBRANE, options=options),
        lambda options: palpate.build_membrane_molecular(MESH, MEMBRANE, options=options),
        lambda options: palpate.build_shell(MESH, MEMBRANE, options),
        lambda options: palpate.build_molecular(
            MESH, MEMBRANE, palpate.MolecularConstants(), options
        ),
    ],
)
def test_a_mask_of_another_length_is_refused(build):
    options = palpate.SurfaceOptions(fixed=np.ones(15, bool))

    with pytest.raises(ValueError, match="options.fixed: got a mask of 15 booleans, .* of 16"):
        build(options)


def test_a_mask_of_a_model_has_one_entry_per_particle():
    rest = chain(3).rest_position
    model = palpate.TissueModel(rest_position=rest, mass=[1, 1, 1], fixed=[False, True, True])

    assert model.fixed.tolist() == [1, 2]
    with pytest.raises(ValueError, match="fixed: got a mask of 2 booleans, expected indices, or"):
        palpate.TissueModel(rest_position=rest, mass=[1, 1, 1], fixed=[False, True])


def test_rows_of_indices_take_no_mask():
    with pytest.raises(TypeError, match=r"triangles: got bool of shape \(1, 3\), expected int"):
        palpate.SurfaceMesh(np.zeros((3, 3)), [[True, False, True]])


@pytest.mark.parametrize(
    ("call", "kind", "sentence"),
    [
        (
            lambda: palpate.SurfaceOptions(fixed=np.array([0.0, 1.0])),
            TypeError,
            "fixed: got float64 of shape (2,), expected integers of shape (n,)",
        ),
        (
            lambda: palpate.build_topology([[0.0, 1.0, 2.0]]),
            TypeError,
            "triangles: got float64 of shape (1, 3), expected integers of shape (n, 3)",
        ),
        (
            lambda: palpate.build_topology(np.zeros((2, 4), int)),
            ValueError,
            "triangles: got int64 of shape (2, 4), expected integers of shape (n, 3)",
        ),
        (
            lambda: palpate.compute_diagonal("abc"),
            TypeError,
            "vertices: got str 'abc', expected numbers of shape (n, 3)",
        ),
        (
            lambda: palpate.compute_diagonal([[1, 2], [3]]),
            TypeError,
            "vertices: got list [[1, 2], [3]], expected numbers of shape (n, 3)",
        ),
        (
            lambda: palpate.compute_diagonal(np.zeros((4, 3), complex)),
            TypeError,
            "vertices: got complex128 of shape (4, 3), expected numbers of shape (n, 3)",
        ),
        (
            lambda: palpate.accumulate_gravity([1.0], (0, 0, -9.8), np.zeros((1, 3), "f4")),
            TypeError,
            "f: got float32 of shape (1, 3), expected a writable C-ordered array of float64, "
            "shape (n, 3)",
        ),
        (
            lambda: palpate.accumulate_gravity([1.0], (0, 0, -9.8), [[0.0, 0.0, 0.0]]),
            TypeError,
            "f: got list [[0.0, 0.0, 0.0]], expected a writable C-ordered array of float64, "
            "shape (n, 3)",
        ),
        (
            lambda: palpate.Material(density="heavy"),
            TypeError,
            "Material: density: got str 'heavy', expected a number",
        ),
        (
            lambda: palpate.Material(densty=1.0),
            TypeError,
            "Material: got an argument 'densty', expected density, young_modulus, "
            "poisson_ratio, damping_ratio, wall_thickness",
        ),
        (
            lambda: palpate.Material(1000.0),
            TypeError,
            "Material: got 1 arguments by place, expected none: they go by name (density, "
            "young_modulus, poisson_ratio, damping_ratio, wall_thickness)",
        ),
        (
            lambda: palpate.HapticSample(position=(1, 2)),
            TypeError,
            "HapticSample: position: got tuple (1, 2), expected numbers of shape (3,)",
        ),
        (
            lambda: setattr(palpate.Material(), "density", None),
            TypeError,
            "Material.density: got None, expected a number",
        ),
        (
            lambda: setattr(palpate.HapticSample(), "position", np.zeros(4)),
            TypeError,
            "HapticSample.position: got float64 of shape (4,), expected numbers of shape (3,)",
        ),
        (
            lambda: palpate.tick(organ_scene(1), palpate.HapticSample(), 1e-3),
            TypeError,
            "tick: world: got nothing, expected World",
        ),
        (
            lambda: palpate.World(7),
            TypeError,
            "World: scene: got int 7, expected Scene",
        ),
        (
            lambda: palpate.HapticSample(buttons=1.5),
            TypeError,
            "HapticSample: buttons: got float 1.5, expected a whole number",
        ),
    ],
)
def test_a_wrong_argument_is_named_with_what_was_found_and_expected(call, kind, sentence):
    with pytest.raises(kind) as caught:
        call()

    assert str(caught.value) == sentence


def test_a_call_that_no_overload_takes_is_refused_on_one_line():
    for call in (
        lambda: palpate.validate(7),
        lambda: palpate.step(chain(3), palpate.Load(), "dt", 1, 2),
        lambda: palpate.HapticSample(buttons=300),
        lambda: palpate.compute_volume((1, 2, 3)),
    ):
        with pytest.raises(TypeError) as caught:
            call()
        assert "\n" not in str(caught.value)
        assert ": got " in str(caught.value) and "expected" in str(caught.value)
        assert "Supports" not in str(caught.value)


@pytest.mark.parametrize("name", [name for name, _ in all_classes()])
def test_an_object_made_by_new_alone_is_refused_by_every_method(name):
    kind = dict(all_classes())[name]
    for member in dir(kind):
        if member in ("__class__", "__init__", "__new__", "__del__", "__setstate__"):
            continue
        raw = kind.__new__(kind)
        found = getattr(kind, member)
        if isinstance(found, property):
            with pytest.raises(TypeError, match="made by __new__ alone"):
                getattr(raw, member)
        elif not member.startswith("__") or member in ("__repr__", "__copy__", "__bool__"):
            if isinstance(found, type) or (member[0] == "_" and member[1] != "_"):
                continue
            owner = next(base for base in kind.__mro__ if member in vars(base))
            if owner.__module__ == "palpate._sim" and callable(found):
                with pytest.raises(TypeError):
                    getattr(raw, member)()


def test_an_object_made_by_new_alone_is_refused_as_an_argument():
    raw = palpate.SurfaceMesh.__new__(palpate.SurfaceMesh)

    with pytest.raises(TypeError, match="compute_area: got an object made by __new__ alone"):
        palpate.compute_area(raw)
    with pytest.raises(TypeError, match="made by __new__ alone"):
        palpate.Record(hand=[palpate.HapticSample.__new__(palpate.HapticSample)])


def test_a_device_whose_read_python_would_override_is_refused_when_its_class_is_made():
    with pytest.raises(TypeError, match="Mine.read: got a method of a Python class"):

        class Mine(palpate.PointerDevice):
            def read(self, time: float) -> palpate.HapticSample:
                return palpate.HapticSample()

    class Reader:
        def read(self, time: float) -> bytes:
            return b""

    with pytest.raises(TypeError, match="Wire.read: got a method of a Python class"):
        type("Wire", (Reader, palpate.NativeCore), {})


def test_a_device_may_be_given_more_in_python():
    class Marked(palpate.PointerDevice):
        label = "left hand"

    hand = Marked()
    hand.set(palpate.HapticSample(position=(1, 2, 3)))

    assert hand.read(0.0).position.tolist() == [1, 2, 3]
    assert hand.label == "left hand"


@pytest.mark.parametrize("kernel", list(palpate.Kernel)[:2])
def test_what_belongs_to_a_world_is_read_only(kernel):
    raw = palpate.Scene(
        bodies=[palpate.SoftBody(tissue=organ_scene(1).bodies[0].tissue, kernel=kernel)]
    )
    scene = palpate.build_scene(raw)
    world = palpate.World(scene)

    body, instrument, built = world.bodies[0], world.instruments[0], scene.bodies[0].tissue
    for array in (
        body.tissue.position, body.tissue.velocity, instrument.tool.position, instrument.hand,
        body.load.gravity, body.guard.last_position, world.pairs[0].load.gravity,
        built.mass, built.springs.stiffness, raw.bodies[0].tissue.rest_position,
    ):  # fmt: skip
        with pytest.raises(ValueError, match="read-only"):
            array[:] = 1.0
    for change in (
        lambda: setattr(world.bodies[0].tissue, "time", 1.0),
        lambda: setattr(world.instruments[0], "hand", (1, 2, 3)),
        lambda: setattr(scene.bodies[0].tissue, "pressure", 1.0),
        lambda: setattr(scene.bodies[0].tissue.volumes, "nodal_share", 1.0),
    ):
        with pytest.raises(AttributeError, match="part of a Scene or a World"):
            change()


@pytest.fixture
def world() -> palpate.World:
    return palpate.World(organ_scene(1))


@pytest.mark.parametrize(
    ("call", "name"),
    [
        (
            lambda w, m: palpate.step(m, palpate.Load(), 1e-4, w.bodies[0].tissue),
            "step: got a State",
        ),
        (
            lambda w, m: palpate.step(
                model=m, load=palpate.Load(), dt=1e-4, state=w.bodies[0].tissue
            ),
            "step: got a State",
        ),
        (
            lambda w, m: palpate.release_tool(w.instruments[0].tool),
            "release_tool: got a ToolState",
        ),
        (lambda w, m: w.bodies[0].load.clear(), r"Load.clear: got a Load"),
        (lambda w, m: w.bodies[0].load.add(palpate.Push()), r"Load.add: got a Load"),
        (lambda w, m: w.bodies[0].tree.refit(m.rest_position), "AabbTree.refit: got a AabbTree"),
        (
            lambda w, m: palpate.check(m, (0, 0, 0), palpate.State(m), 0.0, w.bodies[0].guard),
            "check: got a Guard",
        ),
    ],
    ids=["step", "by name", "release", "clear", "add", "refit", "check"],
)
def test_no_function_moves_what_belongs_to_a_world(world, call, name):
    model = organ_scene(1).bodies[0].tissue
    before = palpate.compute_hash(world)

    with pytest.raises(ValueError, match=name + " that is part of a World, expected one that"):
        call(world, model)

    assert palpate.compute_hash(world) == before


def test_what_belongs_to_a_world_is_read_by_functions_and_copied(world):
    model = organ_scene(1).bodies[0].tissue
    state = copy.copy(world.bodies[0].tissue)

    palpate.step(model, world.bodies[0].load, 1e-4, state)
    palpate.check(
        model, (0, 0, 0), world.bodies[0].tissue, 0.0, palpate.Guard(model, (0, 0, 0), state)
    )

    assert state.time == 1e-4 and world.bodies[0].tissue.time == 0.0


BINDINGS = Path(palpate.__file__).parents[1] / "src"
OF_WORLD = "State|ToolState|Guard|Load|AabbTree|Candidates"


def test_every_function_that_writes_to_a_part_of_a_world_is_known():
    known = set(re.findall(r'Write\{"(?:\w+\.)?(\w+)", "(\w+)"\}', read(BINDINGS / "calls.cpp")))
    found = set()
    for source in BINDINGS.glob("*.cpp"):
        for name, _, parameters in re.findall(
            r'def\(\s*"(\w+)",\s*\[([^\]]*)\]\(([^)]*)\)', read(source)
        ):
            for written in re.findall(rf"(?<!const )\b({OF_WORLD})& \w+", parameters):
                found.add((name, written))
    # bound without a lambda
    found |= {("release_tool", "ToolState"), ("add", "Load"), ("clear", "Load")}

    assert len(found) > 8
    assert found == known


def read(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def test_what_belongs_to_nobody_else_is_written_to():
    model = organ_scene(1).bodies[0].tissue.__copy__()
    state = palpate.State(model)

    model.mass[:] *= 2.0
    model.springs.stiffness[:] = 7.0
    model.pressure = 5.0
    state.position[0] = (1, 2, 3)

    assert (
        palpate.build_scene(palpate.make_scene(model)).bodies[0].tissue.springs.stiffness == 7.0
    ).all()
    assert state.position[0].tolist() == [1, 2, 3]


def test_a_part_that_is_gone_leaves_no_trace_on_what_comes_after():
    for _ in range(50):
        world = palpate.World(organ_scene(1))
        assert not world.bodies[0].tissue.position.flags.writeable
        del world
        state = palpate.State(chain(3))
        state.position[:] = 0.0


def test_no_name_of_python_is_spelled_as_a_constant_of_cpp():
    for scope in (palpate, palpate.scenario, *(kind for _, kind in all_classes())):
        wrong = [
            name for name in vars(scope) if len(name) > 1 and name[0] == "k" and name[1].isupper()
        ]
        assert wrong == []


def test_the_surface_of_an_ellipsoid_may_be_given_as_lists():
    mesh = ellipsoid((0.03, 0.02, 0.01), 0)

    made = palpate.SurfaceMesh(mesh.vertices.tolist(), mesh.triangles.tolist())

    assert made.vertices.tobytes() == mesh.vertices.tobytes()
