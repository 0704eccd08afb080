# SPDX-License-Identifier: BSD-3-Clause
"""The JSON Schemas of the two manifests, held against files the library wrote and reads."""

from __future__ import annotations

import copy
import io
import json
import zipfile
from dataclasses import fields
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import palpate
import pytest
from hostile_scenarios import entries_of, pack, remove, set_in
from palpate import scenario
from palpate.scene import scene_parts
from surfaces import organ_scene

SCHEMAS = Path(palpate.__file__).parent / "schemas"
KEPT = Path(__file__).resolve().parents[1] / "scenes" / "published"

Json = dict[str, Any]


def validator(name: str) -> jsonschema.Draft202012Validator:
    schema = json.loads((SCHEMAS / f"{name}.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def manifest_of(file: Path | bytes) -> Json:
    with zipfile.ZipFile(io.BytesIO(file) if isinstance(file, bytes) else file) as archive:
        return json.loads(archive.read("manifest.json"))


def published() -> bytes:
    made = scenario.Scenario(
        scene=organ_scene(1),
        title="Spleen",
        task="Press it.",
        authored_arrays={"a/b": [1, 2]},
        languages={"tr": scenario.Words("Dalak", "Bastırın.")},
    )
    return scenario.pack_container(scenario.pack(made))


STONE = palpate.RigidBody(
    [(0, 0, 0)], [0.004], mass=5e-4, inertia=(3e-9, 3e-9, 3e-9), position=(0.2, 0.0, 0.2)
)
TABLE = palpate.SurfaceMesh([(0.2, 0, 0), (0.3, 0, 0), (0.2, 0.1, 0)], [(0, 1, 2)])


def published_pair() -> bytes:
    """Of two bodies and two instruments."""
    tissues = [copy.copy(organ_scene(1).bodies[0].tissue) for _ in range(2)]
    np.asarray(tissues[1].rest_position)[:] += (0.2, 0.0, 0.0)
    bodies = [palpate.SoftBody(tissue=tissue) for tissue in tissues]
    pairs = [palpate.BodyPair(0, 1)]
    scene = palpate.Scene(bodies=bodies, instruments=[palpate.Instrument()] * 2, body_pairs=pairs)
    made = scenario.Scenario(scene=palpate.build_scene(scene), title="Two spleens")
    return scenario.pack_container(scenario.pack(made))


def published_stone() -> bytes:
    """Of a body, a stone and a table that the body stops at."""
    scene = palpate.Scene(
        bodies=[palpate.SoftBody(tissue=organ_scene(1).bodies[0].tissue)],
        rigid=[STONE],
        scenery=[palpate.Scenery(TABLE, [0], friction=0.1)],
        fluid=palpate.Fluid(1000.0, 1e-3),
    )
    made = scenario.Scenario(scene=palpate.build_scene(scene), title="A stone")
    return scenario.pack_container(scenario.pack(made))


@pytest.mark.parametrize("publish", [published, published_pair, published_stone])
def test_a_published_file_satisfies_its_schema(publish):
    validator("palpate").validate(manifest_of(publish()))


@pytest.mark.parametrize("kept", sorted(KEPT.glob("*.palpate")), ids=lambda path: path.stem)
def test_every_kept_file_of_this_version_satisfies_the_schema(kept):
    manifest = manifest_of(kept)
    if manifest["version"] == manifest_of(published())["version"]:
        validator("palpate").validate(manifest)


@pytest.mark.parametrize(
    ("section", "part", "elsewhere"),
    [
        ("material", scene_parts.MaterialPart, set()),
        ("model", scene_parts.ModelPart, {"fixed", "stiffness_scale"}),
        ("fill", scene_parts.FillPart, set()),
        ("tool", scene_parts.ToolPart, set()),
        ("hand", scene_parts.HandPart, set()),
    ],
)
def test_an_organ_has_the_fields_of_its_parts(section, part, elsewhere):
    content = validator("organ").schema["properties"]["content"]["properties"]

    assert content[section]["properties"].keys() == {f.name for f in fields(part)} - elsewhere


def test_an_appearance_has_the_fields_of_one_or_is_null():
    appearance = validator("organ").schema["properties"]["content"]["properties"]["appearance"]

    none, some = appearance["oneOf"]
    assert none == {"type": "null"}
    assert some["properties"].keys() == {f.name for f in fields(scene_parts.AppearancePart)}


def test_the_schema_has_every_integrator():
    scene = validator("palpate").schema["properties"]["content"]["properties"]["scene"]
    body = scene["properties"]["bodies"]["items"]["properties"]

    assert body["integrator"]["enum"] == [one.name for one in palpate.Integrator]


PAIR = {"bodies": [0, 0], "thickness": 4e-4, "stiffness": 1e7, "damping": 0.3}
CHANGES = {
    "newer version": set_in("version", 8),
    "unknown member": set_in("script", "x"),
    "no title": remove("content|title"),
    "text for a number": set_in("content|scene|rate", "fast"),
    "unknown number": set_in("content|scene|pace", 1),
    "no substeps": set_in("content|scene|bodies|0|substeps", 0),
    "unknown law": set_in("content|scene|bodies|0|tissue|damping_law", "sticky"),
    "an unknown integrator": set_in("content|scene|bodies|0|integrator", "leapfrog"),
    "no bodies": set_in("content|scene|bodies", []),
    "one body, no list": set_in("content|scene|bodies", {}),
    "no list of pairs": remove("content|scene|body_pairs"),
    "a pair of one body": set_in("content|scene|body_pairs", [PAIR | {"bodies": [0]}]),
    "a pair of a body below 0": set_in("content|scene|body_pairs", [PAIR | {"bodies": [0, -1]}]),
    "a pair without a thickness": set_in("content|scene|body_pairs", [PAIR | {"thickness": 0}]),
    "a pair with a width": set_in("content|scene|body_pairs", [PAIR | {"width": 1}]),
    "a pair with too much friction": set_in("content|scene|body_pairs", [PAIR | {"friction": 3}]),
    "no list of stones": remove("content|scene|rigid"),
    "a stone without a mass": set_in("content|scene|rigid", [{}]),
    "scenery that stops a body below 0": set_in(
        "content|scene|scenery", [{"bodies": [-1], "friction": 0}]
    ),
    "scenery with a mass": set_in(
        "content|scene|scenery", [{"bodies": [], "friction": 0, "mass": 1}]
    ),
    "no fluid": remove("content|scene|fluid"),
    "a fluid lighter than none": set_in("content|scene|fluid|density", -1),
    "a table of a stone below 0": set_in("arrays|scene/rigid/-1/sphere_radii", {}),
    "too many instruments": set_in("content|scene|instruments", [{}] * 17),
    "an instrument without a tool": remove("content|scene|instruments|0|tool"),
    "a body of version 3": set_in("content|scene|tissue", {}),
    "a table of a body with a sign": set_in("arrays|scene/bodies/-1/tissue/mass", {}),
    "no table": remove("arrays|scene/bodies/0/tissue/mass"),
    "a table of another type": set_in("arrays|scene/bodies/0/tissue/mass|dtype", "<f4"),
    "a table of other columns": set_in("arrays|scene/bodies/0/tissue/rest_position|shape", [42, 2]),
    "a table of other dimensions": set_in("arrays|scene/bodies/0/tissue/mass|shape", [42, 1]),
    "an unknown table": set_in("arrays|scene/bodies/0/tissue/charge", {}),
    "a negative extent": set_in("arrays|scene/bodies/0/tissue/mass|shape", [-1]),
    "a hash of 3 digits": set_in("arrays|scene/bodies/0/tissue/mass|sha256", "abc"),
    "a list for the document": set_in("content|authored", []),
    "a list for the languages": set_in("content|languages", []),
    "a language of capital letters": set_in("content|languages|TR", {"title": "", "task": ""}),
    "a language without a task": remove("content|languages|tr|task"),
    "a language with more than words": set_in("content|languages|tr|voice", "x"),
}


@pytest.mark.parametrize("name", CHANGES)
def test_what_the_schema_refuses_the_reader_refuses(name):
    good = published()
    entries, manifest = entries_of(good), manifest_of(good)
    changed = copy.deepcopy(manifest)
    CHANGES[name](changed)
    entries["manifest.json"] = json.dumps(changed).encode()

    newest = manifest["version"]
    scenario.unpack(scenario.unpack_container(good, "file", "palpate", newest), "file")
    assert not validator("palpate").is_valid(changed)
    with pytest.raises(palpate.FileError):
        packed = scenario.unpack_container(pack(entries), "file", "palpate", newest)
        scenario.unpack(packed, "file")


@pytest.mark.parametrize("path", ["authored/../up", "/authored/a", "authored/A", "authored//a"])
def test_the_schema_knows_which_names_lead_out_of_the_file(path):
    manifest = manifest_of(published())
    manifest["arrays"][path] = manifest["arrays"]["scene/bodies/0/tissue/mass"]

    assert not validator("palpate").is_valid(manifest)
