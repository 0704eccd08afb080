# SPDX-License-Identifier: BSD-3-Clause
"""Every public name says what it is, arrays with their shape and numbers with their unit."""

from __future__ import annotations

import enum
import importlib.util
import re
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import palpate
import palpate._sim
import pytest
from palpate.refused_call import read_signature

WRITER = Path(__file__).resolve().parents[2] / "bindings" / "write_stub.py"
NUMBER = "typing.SupportsFloat | typing.SupportsIndex"


def read_words(member: object) -> str:
    spec = importlib.util.spec_from_file_location("write_stub", WRITER)
    writer = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(writer)
    return writer.read_words(member)


def all_members() -> Iterator[tuple[str, object, type | None]]:
    """Name, member and class of everything public in palpate, palpate._sim and palpate.scenario."""

    def visit(scope: object, prefix: str) -> Iterator[tuple[str, object, type | None]]:
        for name, member in vars(scope).items():
            is_public = not name.startswith("_") or name == "__init__"
            if not is_public or isinstance(member, ModuleType | int | float | str):
                continue
            if name == "__init__" and not (member.__doc__ or "").startswith("__init__("):
                continue  # only made by the library
            if not (isinstance(member, type | property) or callable(member)):
                continue
            yield prefix + name, member, scope if isinstance(scope, type) else None
            if isinstance(member, type) and not issubclass(member, enum.Enum | Exception):
                yield from visit(member, f"{prefix}{name}.")

    yield from visit(palpate, "")
    yield from visit(palpate.scenario, "scenario.")


MEMBERS = {name: (member, owner) for name, member, owner in all_members()}


def is_array(kind: str) -> bool:
    return "ndarray" in kind or "NDArray" in kind or "ArrayLike" in kind


def result_of(member: property) -> str:
    return (member.fget.__doc__ or "").partition(" -> ")[2]


def test_everything_the_module_has_is_walked():
    assert len(MEMBERS) > 600
    assert {"SurfaceMesh.vertices", "step", "scenario.read", "read_mesh", "Loop.wait"} <= set(
        MEMBERS
    )


def test_every_public_name_has_words():
    missing = [name for name, (member, _) in MEMBERS.items() if not read_words(member)]

    assert missing == []
    assert palpate.__doc__ and palpate._sim.__doc__ and palpate.scenario.__doc__


def test_every_array_property_says_its_shape():
    wrong = [
        name
        for name, (member, _) in MEMBERS.items()
        if isinstance(member, property)
        and is_array(result_of(member))
        and "shape" not in read_words(member).lower()
    ]

    assert wrong == []


def test_every_property_of_numbers_says_its_unit():
    wrong = [
        name
        for name, (member, _) in MEMBERS.items()
        if isinstance(member, property)
        and (result_of(member).startswith("float") or "float" in result_of(member))
        and not re.search(r"\[[^\]]+\]", read_words(member))
        and "fields of" not in read_words(member)
    ]

    assert wrong == []


def read_arguments(name: str) -> Iterator[tuple[str, str, str]]:
    """Name, kind and words of each argument of a function that are not a field of its class."""
    member, owner = MEMBERS[name]
    words = dict(re.findall(r"^    (\w+): (.*)$", member.__doc__ or "", flags=re.MULTILINE))
    for line in (member.__doc__ or "").splitlines():
        if re.match(r"(?:\d+\. )?\w+\(.*\) -> ", line) and "*args" not in line:
            for each in read_signature(line):
                if not (name.endswith(".__init__") and hasattr(owner, each.name)):
                    yield each.name, each.kind, words.get(each.name, "")


FUNCTIONS = [
    name for name, (member, _) in MEMBERS.items() if not isinstance(member, type | property)
]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_function_says_shape_and_unit_of_its_arguments(name):
    wrong = []
    for argument, kind, words in read_arguments(name):
        if is_array(kind) and "shape" not in words:
            wrong.append(f"{argument}: no shape in {words!r}")
        if (kind.startswith(NUMBER) or "numpy.float64" in kind) and not re.search(r"\[", words):
            wrong.append(f"{argument}: no unit in {words!r}")

    assert wrong == []


def test_every_constructor_of_fields_says_so():
    for name, (member, owner) in MEMBERS.items():
        if not name.endswith(".__init__") or owner.__module__ != "palpate._sim":
            continue
        first = (member.__doc__ or "").splitlines()[0]
        if "*args" not in first and any(hasattr(owner, p.name) for p in read_signature(first)):
            assert "Arguments are the fields" in member.__doc__, name
