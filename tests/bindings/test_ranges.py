# SPDX-License-Identifier: BSD-3-Clause
"""Every number of a published file has a range: beyond it the file is refused, never played."""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Iterator
from typing import Any

import hostile_scenarios
import palpate
import pytest
from palpate import scenario
from surfaces import MEMBRANE, ellipsoid, organ_scene

VALUES = (0.0, -1.0, 1e300, -1e300, 1e-300, 1e30, 1e-9)
NOT_NUMBERS = ("NaN", "Infinity", "-Infinity", "1e999")
DERIVED = ("spectrum_stiffness", "spectrum_damping")
"""Compared with what the tissue gives, and refused where they differ."""


def build_tissue(kind: str) -> palpate.TissueModel:
    """A small tissue of every kind that a file can hold."""
    mesh = ellipsoid((0.03, 0.025, 0.02), 0)
    if kind == "mass-spring":
        return palpate.build_mass_spring(mesh, MEMBRANE, 50.0)
    if kind == "molecular":
        return palpate.build_membrane_molecular(mesh, MEMBRANE)
    if kind == "shell":
        return palpate.build_shell(mesh, MEMBRANE)
    corners = [(x, y, z) for z in (0.0, 0.02) for y in (0.0, 0.02) for x in (0.0, 0.02)]
    inside = [(0, 1, 2, 4), (1, 3, 2, 7), (1, 2, 4, 7), (1, 4, 5, 7), (2, 6, 4, 7)]
    solid, soft = palpate.SolidMesh(corners, inside), palpate.Material(poisson_ratio=0.3)
    build = palpate.build_solid if kind == "solid" else palpate.build_linear_solid
    return build(solid, soft, palpate.SolidOptions(fixed=[0, 1, 2]))


def with_stone(scene: palpate.Scene) -> palpate.Scene:
    stone = palpate.RigidBody(
        [(0, 0, 0)], [0.004], mass=5e-4, inertia=(3e-9, 3e-9, 3e-9), position=(0, 0, 0.2)
    )
    corners = [(0.2, 0, 0), (0.3, 0, 0), (0.2, 0.1, 0)]
    table = palpate.Scenery(palpate.SurfaceMesh(corners, [(0, 1, 2)]), [0])
    tissues = [palpate.SoftBody(tissue=body.tissue) for body in scene.bodies]
    return palpate.Scene(bodies=tissues, rigid=[stone], scenery=[table])


@pytest.fixture(
    scope="module", params=["mass-spring", "molecular", "shell", "solid", "linear solid"]
)
def good(request, tmp_path_factory) -> bytes:
    path = tmp_path_factory.mktemp("good") / "good.palpate"
    scene = palpate.build_scene(palpate.make_scene(build_tissue(request.param)))
    if request.param == "mass-spring":
        scene.bodies[0].force_error = 1e-3
    scene.bodies[0].may_fold = request.param == "shell"
    if request.param == "solid":
        scene = with_stone(scene)
    scenario.write(path, scenario.Scenario(scene=palpate.build_scene(scene), title="Good"))
    return path.read_bytes()


RANGES = {name: (least, most) for name, _, least, most in scenario.list_ranges()}


def list_numbers(value: Any, path: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """Where the numbers of a JSON value stand."""
    if isinstance(value, dict | list):
        rows = value.items() if isinstance(value, dict) else enumerate(value)
        for key, inner in rows:
            yield from list_numbers(inner, (*path, key))
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield path


def replace(manifest: dict, path: tuple[str | int, ...], value: Any) -> None:
    for key in path[:-1]:
        manifest = manifest[key]
    manifest[path[-1]] = value


def find_range(path: tuple[str | int, ...]) -> tuple[float, float] | None:
    name = "".join(f".{key}" if isinstance(key, str) else "[i]" for key in path).lstrip(".")
    name = name.removesuffix("[i]")  # an axis
    return (1, 10_000) if name.endswith(("substeps", "substeps_max")) else RANGES.get(name)


def read(data: bytes) -> scenario.Scenario:
    container = scenario.unpack_container(data, "a.palpate", "palpate", 7)
    return scenario.unpack(container, "a.palpate")


def test_every_number_of_the_manifest_is_in_range_or_refused_with_its_name(good):
    manifest = json.loads(hostile_scenarios.entries_of(good)["manifest.json"])
    paths = list(list_numbers(manifest["content"]["scene"], ("content", "scene")))
    assert len(paths) >= 18

    for path in paths:
        for value in VALUES:
            changed = copy.deepcopy(manifest)
            replace(changed, path, value)
            data = hostile_scenarios.with_text(good, json.dumps(changed).encode())
            check(data, path[1:], value)


def check(data: bytes, path: tuple[str | int, ...], value: float) -> None:
    least, most = find_range(path) or (float("nan"), float("nan"))
    try:
        made = read(data)
    except palpate.FileError as refused:
        names = [key for key in path[1:] if isinstance(key, str)]
        beside = path[-1] == "maxwell_ratio" and "got maxwell beside it" in str(refused)
        named = any(name in str(refused) for name in names)
        assert path[-1] in DERIVED or beside or named, refused
        assert refused.expected
    else:
        assert least <= value <= most, (path, value)
        assert made.scene.rate > 0.0


@pytest.mark.parametrize("word", NOT_NUMBERS)
def test_what_is_no_number_is_refused_wherever_a_number_stands(word, good):
    manifest = json.loads(hostile_scenarios.entries_of(good)["manifest.json"])
    for path in list_numbers(manifest["content"]["scene"], ("content", "scene")):
        changed = copy.deepcopy(manifest)
        replace(changed, path, "@")
        text = json.dumps(changed).replace('"@"', word).encode()

        with pytest.raises(palpate.FileError):
            read(hostile_scenarios.with_text(good, text))


def test_every_table_of_numbers_is_in_range_or_refused_with_its_name(good):
    manifest = json.loads(hostile_scenarios.entries_of(good)["manifest.json"])
    tables = [name for name, row in manifest["arrays"].items() if row["dtype"] == "<f8"]
    patterns = {name: re.sub(r"/(bodies|rigid|scenery)/0/", r"/\1/i/", name) for name in tables}
    assert set(patterns.values()) <= set(RANGES)

    for name in tables:
        if not hostile_scenarios.array_of(good, name).size:
            continue
        for value in (*VALUES, float("nan"), float("inf")):
            try:
                read(hostile_scenarios.with_number(good, name, 0, value))
            except palpate.FileError as refused:
                assert refused.got
                assert refused.expected
            else:
                least, most = RANGES[patterns[name]]
                assert least <= value <= most, (name, value)


def test_the_page_and_the_code_have_the_same_ranges(checkout):
    page = (checkout / "core/scenario/CONTAINER.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (scene[./]\S+) \| ([^|]+) \| (\S+) \| (\S+) \|$", page, re.MULTILINE)

    told = [(name, unit, float(least), float(most)) for name, unit, least, most in rows]

    assert told == list(map(tuple, scenario.list_ranges()))


@pytest.mark.parametrize(
    ("field", "value"),
    [("rate", 1e12), ("rate", 1e-9), ("hold_stiffness", 1e30), ("gravity", (0.0, 0.0, 1e9))],
)
def test_what_hung_or_was_felt_as_nothing_is_no_scene_of_a_file(field, value, tmp_path):
    scene = organ_scene(0)
    setattr(scene.instruments[0] if field == "hold_stiffness" else scene, field, value)

    place = r"scene\.instruments\[0\]" if field == "hold_stiffness" else "scene"
    with pytest.raises(ValueError, match=rf"{place}\.{field}: got"):
        scenario.check_ranges(scene)
    with pytest.raises(ValueError, match=rf"{place}\.{field}: got"):
        scenario.write(tmp_path / "a.palpate", scenario.Scenario(scene=scene))


@pytest.mark.parametrize(
    ("part", "field", "value"),
    [
        ("tool", "radius", 1e300),
        ("tool", "radius", 1e-300),
        ("coupling", "stiffness", 1e30),
        ("tool", "friction", 3.0),
    ],
)
def test_a_tool_that_was_played_at_no_force_is_no_scene_of_a_file(part, field, value):
    tissue = palpate.build_mass_spring(ellipsoid((0.03, 0.025, 0.02), 0), MEMBRANE, 50.0)
    scene = palpate.make_scene(tissue)
    setattr(getattr(scene.instruments[0], part), field, value)

    with pytest.raises(ValueError, match=rf"scene\.instruments\[0\]\.{part}\.{field}: got"):
        scenario.check_ranges(scene)
