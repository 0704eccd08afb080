# SPDX-License-Identifier: BSD-3-Clause
"""Values of the compiled module print on one line, are copied and cross process borders."""

from __future__ import annotations

import copy
import enum
import pickle
from pathlib import Path

import numpy as np
import palpate
import pytest
from bound_values import NOT_MADE, all_classes, make
from headers import Type, read_header
from surfaces import organ_scene

SIM = Path(__file__).resolve().parents[2] / "core" / "sim"
MADE = [name for name, _ in all_classes() if name not in NOT_MADE]
VALUES = [name for name, kind in all_classes() if "__setstate__" in vars(kind)]
MADE_VALUES = [name for name in VALUES if name not in NOT_MADE]
NO_VALUES = {
    "AabbTree", "World", "SoftState", "InstrumentState", "ContactPair",
    "Response", "NearField", "VelocityWindow", "TickLog", "ImplicitStepper",
    "HapticDevice", "ScriptedDevice", "PointerDevice", "ReplayDevice", "SafeDevice",
    "SurfacePointer", "SceneSurfaces", "MailboxDevice", "FulcrumDevice",
    "SerialDevice", "FaultyDevice", "SimulatedArm", "Transport", "NativeCore", "SerialTransport",
    "FaultyTransport", "PtyDevice", "Loop", "DeviceLoop", "Recorder", "SlowTissue",
    "Progress",
}  # fmt: skip
"""What runs, or holds what it cannot share."""
WORK_SPACE = {
    "State": {"scratch"},
    "Candidates": {"lanes", "near", "border", "at_border"},
    "Load": {"forces"},
}


def read_fields(value: object) -> dict[str, object]:
    kind = type(value)
    names = {name for base in kind.__mro__ for name, each in vars(base).items()
             if isinstance(each, property)}  # fmt: skip
    return {name: getattr(value, name) for name in sorted(names)}


def assert_same(one: object, other: object) -> None:
    assert type(one) is type(other)
    if isinstance(one, np.ndarray):
        assert one.dtype == other.dtype
        assert one.shape == other.shape
        # what pads the rows of structured arrays is no part of them
        for field in one.dtype.names or (...,):
            assert one[field].tobytes() == other[field].tobytes()
    elif isinstance(one, dict):
        assert one.keys() == other.keys()
        for key in one:
            assert_same(one[key], other[key])
    elif isinstance(one, list | tuple):
        assert len(one) == len(other)
        for a, b in zip(one, other, strict=True):
            assert_same(a, b)
    elif type(one).__module__.startswith("palpate._sim") and not isinstance(one, enum.Enum):
        assert_same(read_fields(one), read_fields(other))
    else:
        assert one == other


@pytest.mark.parametrize("name", MADE)
def test_every_value_prints_on_one_line(name):
    text = repr(make(name))

    assert "\n" not in text
    assert len(text) < 200


def test_what_a_designer_holds_says_what_it_is():
    scene = organ_scene(1)
    world = palpate.World(scene)

    assert "42 particles" in repr(scene)
    assert "substeps" in repr(scene)
    assert "not built" in repr(palpate.make_scene(scene.bodies[0].tissue))
    assert "tick 0" in repr(world)
    assert "42 particles at 0 s" in repr(world.bodies[0].tissue)
    assert "N/m" in repr(scene.bodies[0].tissue.springs)
    assert "stiffness_scale=<float64 (5000,)>" in repr(make("SurfaceOptions"))


@pytest.mark.parametrize("name", MADE_VALUES)
def test_a_value_comes_back_from_pickle_and_from_copy_as_it_was(name):
    value = make(name)

    assert_same(pickle.loads(pickle.dumps(value)), value)
    assert_same(copy.copy(value), value)
    assert_same(copy.deepcopy(value), value)


@pytest.mark.parametrize("name", MADE_VALUES)
def test_a_value_from_pickle_shares_no_memory_with_the_one_it_was(name):
    value = make(name)
    twin = pickle.loads(pickle.dumps(value))

    for field, array in read_fields(value).items():
        if isinstance(array, np.ndarray) and array.size > 0:
            assert not np.shares_memory(array, getattr(twin, field))


def test_every_class_is_a_value_or_known_to_be_none():
    assert {name for name, _ in all_classes()} - set(VALUES) == NO_VALUES


@pytest.mark.parametrize("name", sorted(NO_VALUES - set(NOT_MADE)))
def test_what_is_no_value_says_that_it_cannot_be_pickled(name):
    with pytest.raises(TypeError, match=f"{name}: got .* expected a value"):
        pickle.dumps(make(name))


def declared_types() -> dict[str, Type]:
    found: dict[str, Type] = {}

    def visit(scope: Type, prefix: str) -> None:
        for kind in scope.types:
            found[prefix + kind.name] = kind
            visit(kind, prefix + kind.name + ".")

    for path in SIM.rglob("*.h"):
        try:
            visit(read_header(path), "")
        except AssertionError:
            continue  # private headers have declarations that the reader does not know
    return found


DECLARED = declared_types()
BUILT = ("Scene", "SoftBody")
"""What build_scene fills in is not kept but filled in again, by the Scene."""


@pytest.mark.parametrize("name", [n for n in MADE_VALUES if n in DECLARED and n not in BUILT])
def test_pickle_keeps_every_field_of_the_struct(name):
    fields = list(dict.fromkeys(DECLARED[name].fields))
    extra = 1 if name in ("SurfaceOptions", "SolidOptions") else 0  # how long a mask was

    kept = len(make(name).__getstate__())

    assert kept == len(set(fields) - WORK_SPACE.get(name, set())) + extra


def test_a_scene_from_pickle_ticks_with_the_very_forces():
    scene = organ_scene(2)
    twin = pickle.loads(pickle.dumps(scene))
    worlds = palpate.World(scene), palpate.World(twin)

    for k in range(60):
        sample = palpate.HapticSample(time=1e-3 * k, position=(0, 0, 0.05 - 1e-3 * k))
        ours = palpate.tick(scene, sample, 1e-3, worlds[0]).force
        theirs = palpate.tick(twin, sample, 1e-3, worlds[1]).force
        assert ours.tobytes() == theirs.tobytes()

    assert worlds[0].instruments[0].tool.touching


def test_a_state_from_pickle_can_be_stepped():
    state = make("State")
    twin = pickle.loads(pickle.dumps(state))
    from surfaces import chain

    for each in (state, twin):
        palpate.step(chain(4), palpate.Load(), 1e-5, palpate.Integrator.runge_kutta_4, each)

    assert_same(twin, state)


def test_a_damaged_pickle_is_refused():
    with pytest.raises(ValueError, match="pickle: got 1 members, expected 5"):
        palpate.Tool.__new__(palpate.Tool).__setstate__((1.0,))
