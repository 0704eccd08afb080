# SPDX-License-Identifier: BSD-3-Clause
"""Every public C++ name of core/sim has its Python twin, with the same parameters in order."""

from __future__ import annotations

import enum
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import palpate
import pytest
from headers import Function, Type, read_header, split_parameters

SIM = Path(__file__).resolve().parents[2] / "core" / "sim"

NOT_MIRRORED = {
    "Latest": "a mailbox between C++ threads; Python reads it through Loop.take_snapshot",
    "State.Scratch": "work space without meaning between steps",
    "State.scratch": "work space without meaning between steps",
    "CacheAlignedAllocator": "how C++ aligns memory",
    "Scene.identity": "how a world knows its scene; World.alarm says where it does not",
    "World.scene_identity": "how a world knows its scene; World.alarm says where it does not",
    "InstrumentState.last_force": "inside of World: how the force fades after an alarm",
    "InstrumentState.fade_from": "inside of World: how the force fades after an alarm",
    "World.fade_ticks": "inside of World: how the force fades after an alarm",
    "InstrumentState.release_load": "inside of World: how holds that are let go fade",
    "Owned": "hides in C++ what stands behind a SoftState or a World",
    "SoftState.SoftState": "a World makes those of its scene",
    "tick(commands)": "what C++ writes into its argument, Python is given back",
    "NearContacts": "inside of balance_tool with a near field",
    "Grip": "inside of balance_tool with a near field",
    "NearField.ties_holds": "SoftBody.tied_holds says so",
    "NearMemory": "inside of balance_tool with a near field",
    "ParticleForce": "inside of a step: it cancels what torn parts bear",
    "Load.forces": "inside of a step: of that one alone",
    "Candidates.near": "inside of balance_tool with a near field",
    "ResponseState": "inside of World; Python reads SoftState.tissue",
    "World.World": "in Python it takes `recovers` too, for a world is read-only there",
    "World.follows_all": "inside of the loop; worlds of Python follow all",
    "TaskObject.tree": "inside of the judge, who asks it for what hides a place",
    "AabbTree.refit_steps": "inside of the tick",
    "AabbTree.refit_step_count": "inside of the tick",
    "TreeRefit.step_count": "inside of AabbTree",
    "AabbTree.set_moving": "inside of the tick",
    "AabbTree.refit_moving": "inside of the tick",
    "Stretch": "inside of World; Python reads SoftState.substeps",
    "StretchSpectrum": "inside of World; Python reads SoftState.substeps",
    "SoftState.stretch": "inside of World; Python reads SoftState.substeps",
    "AabbTree.Node": "rows of AabbTree.nodes()",
    "ContactLanes": "inside of balance_tool under the packed kernel",
    "Candidates.lanes": "inside of balance_tool under the packed kernel",
    "Candidates.border": "inside of balance_tool at an open border",
    "Candidates.at_border": "inside of balance_tool at an open border",
    "TreeRefit": "inside of AabbTree",
    "TreeCost": "inside of World: when the loop has another tree built",
    "ToolState.Hold": "rows of ToolState.holds",
    "ToolState.PatchPoint": "rows of ToolState.patch",
    "ToolState.Anchor": "rows of ToolState.anchors",
    "TickLog.take(ticks)": "what C++ appends to its arguments, Python is given back",
    "TickLog.take(events)": "what C++ appends to its arguments, Python is given back",
    "TickLog.take(hashes)": "what C++ appends to its arguments, Python is given back",
    "Transport.read(bytes)": "what C++ writes into its argument, Python is given back",
    "NativeCore.read(bytes)": "what C++ writes into its argument, Python is given back",
    "FaultyTransport.read(bytes)": "what C++ writes into its argument, Python is given back",
    "SerialTransport.read(bytes)": "what C++ writes into its argument, Python is given back",
    "replay(stopped)": "Python hears its own signals meanwhile",
    "check_conformance(stopped)": "Python hears its own signals meanwhile",
    "SerialDevice.open(stopped)": "Python hears its own signals meanwhile",
    "SerialDevice.store(stopped)": "Python hears its own signals meanwhile",
    "JudgeSignals": "inside of Progress; Python reads Progress.state",
    "JudgeTimer": "inside of Progress; Python reads Progress.state",
    "Progress.signals": "inside of Progress; Python reads Progress.state",
    "Progress.step_timers": "inside of Progress; Python reads Progress.state",
    "Progress.limit_timers": "inside of Progress; Python reads Progress.state",
    "Progress.reached": "inside of Progress; Python reads Progress.state",
    "FileError.FileError": "Python's OSError makes it, with the same arguments",
}
RENAMED = {"from": "from_", "lambda": "lambda_"}
"""Words that are not to be had in Python."""


def public_headers() -> list[Path]:
    return sorted(SIM.glob("*/*.h"))


def declared() -> Iterator[tuple[str, Type]]:
    for path in public_headers():
        yield str(path.relative_to(SIM)), read_header(path)


def types_in(scope: Type, prefix: str = "") -> Iterator[tuple[str, Type]]:
    for kind in scope.types:
        name = prefix + kind.name
        if name not in NOT_MIRRORED:
            yield name, kind
            yield from types_in(kind, name + ".")


def all_types() -> list[tuple[str, Type]]:
    return [named for _, scope in declared() for named in types_in(scope)]


def all_functions() -> list[Function]:
    return [function for _, scope in declared() for function in scope.functions]


@cache
def twin(name: str) -> object:
    found: object = palpate
    for part in name.split("."):
        found = getattr(found, part, None)
    return found


def name_constant(name: str) -> str:
    """kMostParticles of C++ is MOST_PARTICLES in Python."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name[1:]).upper()


def overloads(function: object) -> list[list[str]]:
    """The parameter names of a bound function, from the first lines of its docstring."""
    doc = getattr(function, "__doc__", None) or ""
    lines = re.findall(r"^(?:\d+\. )?\w+\((.*)\) -> ", doc, flags=re.MULTILINE)
    found = []
    for line in lines:
        line = re.sub(r" = <[^>]*>", "", line).replace("[", "(").replace("]", ")")
        names = [p.strip().partition(":")[0] for p in split_parameters(line)]
        found.append([name for name in names if name not in ("*", "self")])
    return found


def expected_parameters(owner: str, function: Function) -> list[str]:
    names = [RENAMED.get(name, name) for name in function.parameters]
    return [name for name in names if f"{owner}{function.name}({name})" not in NOT_MIRRORED]


def test_the_headers_are_read():
    names = {name for name, _ in all_types()}
    functions = {function.name: function.parameters for function in all_functions()}

    assert {"SurfaceMesh", "TissueModel", "State", "World", "Loop", "Record"} <= names
    assert functions["find_closest_point"] == ["tree", "x", "p", "max_distance"]
    assert dict(all_types())["Material"].fields == [
        "density", "young_modulus", "poisson_ratio", "damping_ratio", "wall_thickness"]  # fmt: skip
    assert dict(all_types())["AlarmKind"].values[:2] == ["none", "not_finite"]
    assert [f.name for f in dict(all_types())["Loop"].functions][-1] == "report"


@pytest.mark.parametrize("name", sorted(name for name, _ in all_types()))
def test_every_type_has_its_twin_with_every_field_and_method(name):
    kind = dict(all_types())[name]
    python = twin(name)
    assert isinstance(python, type), f"palpate.{name} is missing"

    if kind.values:
        assert issubclass(python, enum.Enum)
        assert [member.name for member in python] == kind.values
        return
    constants = [name_constant(constant) for constant in kind.constants]
    members = kind.fields + constants + [f.name for f in kind.functions if f.name != kind.name]
    missing = [
        member
        for member in members
        if f"{name}.{member}" not in NOT_MIRRORED
        and not has_member(python, RENAMED.get(member, member))
    ]
    assert missing == []


def has_member(python: type, member: str) -> bool:
    if issubclass(python, Exception):
        return hasattr(python("a", "b", "c", "d"), member)
    return hasattr(python, member)


@pytest.mark.parametrize("name", sorted(name for name, _ in all_types()))
def test_every_method_takes_the_same_parameters_in_the_same_order(name):
    kind = dict(all_types())[name]
    wrong = []
    for function in kind.functions:
        key = f"{name}.{function.name}"
        if key in NOT_MIRRORED or "" in function.parameters:
            continue  # copies and moves have no names for what they take
        bound = "__init__" if function.name == kind.name else function.name
        expected = expected_parameters(f"{name}.", function)
        found = overloads(getattr(twin(name), bound))
        if expected not in found and (expected or bound != "__init__"):
            wrong.append(f"{key}({', '.join(expected)}): got {found}")

    assert wrong == []


@pytest.mark.parametrize("name", sorted({function.name for function in all_functions()}))
def test_every_function_has_its_twin_with_the_same_parameters_in_the_same_order(name):
    found = overloads(twin(name))

    for function in all_functions():
        if function.name == name:
            assert expected_parameters("", function) in found


@pytest.mark.parametrize("name", sorted(c for _, scope in declared() for c in scope.constants))
def test_every_constant_has_its_twin(name):
    assert isinstance(twin(name_constant(name)), int | float)


def test_every_exception_on_the_list_is_still_needed():
    words = "\n".join(path.read_text(encoding="utf-8") for path in public_headers())

    for key in NOT_MIRRORED:
        last = re.split(r"[.(]", key.rstrip(")"))[-1]
        assert re.search(rf"\b{last}\b", words), key


def test_rows_of_structured_arrays_have_the_fields_of_their_structs():
    mesh = palpate.SurfaceMesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    nodes = palpate.AabbTree(mesh.vertices, mesh.triangles).nodes()
    structs = {name: kind for _, scope in declared() for name, kind in nested_types(scope)}

    assert list(nodes.dtype.names) == structs["AabbTree.Node"].fields
    assert list(palpate.ToolState(1).holds.dtype.names) == structs["ToolState.Hold"].fields
    assert list(palpate.ToolState(1).patch.dtype.names) == structs["ToolState.PatchPoint"].fields
    assert list(palpate.ToolState(1).anchors.dtype.names) == structs["ToolState.Anchor"].fields
    for name in ("Push", "HapticSample", "Felt", "Event", "StateHash", "TickLog.Tick"):
        assert list(twin(name).dtype.names) == structs[name].fields


def nested_types(scope: Type, prefix: str = "") -> Iterator[tuple[str, Type]]:
    for kind in scope.types:
        yield prefix + kind.name, kind
        yield from nested_types(kind, prefix + kind.name + ".")
