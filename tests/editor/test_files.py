# SPDX-License-Identifier: GPL-3.0-or-later
"""Working files: nothing of an organ is lost, and files of every version are read."""

from __future__ import annotations

import json
import zipfile
from dataclasses import asdict, fields, replace
from pathlib import Path

import jsonschema
import numpy as np
import palpate
import pytest
from organs import APPEARANCE, make_organ, open_surface, same, with_history
from palpate import FileError
from palpate.scenario import read_container
from palpate.scene.scene_parts import FillPart
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.files import (
    VERSION,
    pack_organ,
    read_organ,
    unpack_organ,
    write_organ,
)

TESTS = Path(__file__).resolve().parents[1]

KEPT = TESTS / "scenes" / "published"
SCHEMA = Path(palpate.__file__).parent / "schemas" / "organ.schema.json"

ORGANS = {
    "nothing yet": EMPTY,
    "words alone": Organ(name="dalak", title="Dalağa bas", task="Bas.\nBırak."),
    "decimated": make_organ(),
    "as imported": make_organ(imported=None),
    "made here": replace(make_organ(imported=None), source=None, imported=None),
    "with lines of history": with_history(make_organ()),
    "with a line, as imported": with_history(make_organ(imported=None)),
    "open": replace(EMPTY.with_surface(open_surface()), name="sheet"),
    "numbers that are hard to write": replace(
        make_organ(),
        model=replace(make_organ().model, stiffness=0.1 + 0.2, pressure=-5e-324, drag=1e308),
    ),
    "numbers that make no tissue": replace(
        make_organ(), material=replace(make_organ().material, density=-1.0)
    ),
}


def manifest_of(path: Path) -> dict:
    with zipfile.ZipFile(path) as archive:
        return json.loads(archive.read("manifest.json"))


@pytest.mark.parametrize("name", ORGANS)
def test_an_organ_comes_back_bit_for_bit(tmp_path, name):
    organ = ORGANS[name]

    write_organ(tmp_path / "a.organ", organ)
    found = read_organ(tmp_path / "a.organ")

    assert same(found, organ)
    assert (found.imported is found.surface) == (organ.imported is organ.surface)
    assert list(tmp_path.iterdir()) == [tmp_path / "a.organ"]


@pytest.mark.parametrize("name", ORGANS)
def test_what_is_written_satisfies_the_schema(tmp_path, name):
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)

    write_organ(tmp_path / "a.organ", ORGANS[name])

    jsonschema.Draft202012Validator(schema).validate(manifest_of(tmp_path / "a.organ"))


def test_random_organs_come_back_bit_for_bit(tmp_path):
    rng = np.random.default_rng(11)
    for _ in range(20):
        organ = make_organ()
        numbers = rng.standard_cauchy(3) * 10.0 ** rng.integers(-300, 300, 3)
        organ = replace(
            organ,
            fixed=rng.random(60) < rng.random(),
            regions={chr(0x100 + i): np.flatnonzero(rng.random(60) < 0.3) for i in range(3)},
            stiffness_scale=rng.standard_cauchy(60),
            hand=replace(organ.hand, gravity=tuple(numbers.tolist())),
            task="".join(map(chr, rng.integers(1, 0xD7FF, 40))),
        )

        write_organ(tmp_path / "a.organ", organ)

        assert same(read_organ(tmp_path / "a.organ"), organ)


def test_every_field_of_an_organ_is_kept_somewhere():
    content, arrays = pack_organ(with_history(make_organ()))

    kept = set(content) | {name.split("/")[0] for name in arrays}

    assert kept == {f.name for f in fields(Organ)}


def test_a_filling_of_other_vertices_is_refused():
    content, arrays = pack_organ(make_organ())
    arrays["filling/tetrahedra"] = arrays["filling/tetrahedra"] + 4

    with pytest.raises(FileError, match="filling/tetrahedra: got vertex numbers 4 to 8, expected"):
        unpack_organ(as_read(content), arrays, VERSION, "a.organ")


def as_read(content: dict[str, object]) -> dict[str, object]:
    """As it comes from a file: tuples are lists in JSON."""
    return json.loads(json.dumps(content))


@pytest.mark.parametrize(
    ("languages", "sentence"),
    [
        ([], "languages: got [], expected an object"),
        ({"TR": {"title": "", "task": ""}}, "languages: got the code 'TR', expected a code such"),
        ({"tr": {"title": "", "task": 1}}, "languages.tr.task: got 1, expected text"),
        ({"tr": {"title": ""}}, "languages.tr: got no task"),
        ({"tr": {"title": "", "task": "", "voice": ""}}, "languages.tr.voice: got"),
        (
            {f"a{a}{b}": {} for a in "abcdefgh" for b in "abcdefg"},
            "got 56 languages, expected at",
        ),
    ],
)
def test_languages_of_a_damaged_file_are_refused(languages, sentence):
    content, arrays = pack_organ(make_organ())

    with pytest.raises(palpate.FileError) as refused:
        unpack_organ(as_read(content | {"languages": languages}), arrays, VERSION, "a.organ")

    assert sentence in str(refused.value)


def test_a_file_without_further_languages_has_no_word_of_them():
    content, arrays = pack_organ(replace(make_organ(), languages={}))

    assert "languages" not in content
    assert unpack_organ(as_read(content), arrays, VERSION, "a.organ").languages == {}


def test_equal_organs_are_equal_files(tmp_path):
    for name in ("a", "b"):
        write_organ(tmp_path / name, make_organ())

    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()


@pytest.mark.parametrize("version", range(1, VERSION + 1))
def test_a_kept_file_of_every_version_is_read(version):
    organ = read_organ(KEPT / f"v{version}.organ")

    assert (organ.name, organ.title, organ.task) == ("dalak", "Press the spleen", "Bas ve bırak.")
    assert (len(organ.imported.vertices), organ.vertex_count) == (150, 60)
    assert (organ.model.stiffness, organ.material.density, organ.tool.radius) == (120, 1050, 0.012)
    assert organ.hand.gravity == (0.0, 0.0, -9.81)
    assert np.flatnonzero(organ.fixed).tolist() == [0, 1, 2, 3, 4]
    assert organ.decimation.max_distance == 1.0 / 3.0 * 1e-3
    assert organ.source.repairs.welded_vertices == 12
    assert organ.appearance == APPEARANCE
    assert organ.fill == (FillPart() if version < 3 else FillPart(1200, 0.75, "hilum"))
    assert {name: ids.tolist() for name, ids in organ.regions.items()} == {
        "hilum": [1, 4, 7],
        "alt uç": [],
    }


def test_the_kept_file_of_this_version_is_what_is_written_today(tmp_path):
    organ = read_organ(KEPT / f"v{VERSION}.organ")
    write_organ(tmp_path / "a.organ", organ)

    assert manifest_of(tmp_path / "a.organ") == manifest_of(KEPT / f"v{VERSION}.organ")


def read_manifest_of(version: int) -> tuple[dict, dict]:
    found = read_container(str(KEPT / f"v{version}.organ"), "organ", VERSION)
    return json.loads(found.content), found.arrays


def put_in(place: str, value: object):
    def change(content: dict) -> None:
        *parents, last = place.split(".")
        for name in parents:
            content = content[name]
        content[last] = value

    return change


@pytest.mark.parametrize("version", [1, 4])
@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (put_in("appearance", None), "appearance: got an unknown field, expected look"),
        (
            put_in("look.subsurface", 0.1),
            "look.subsurface: got an unknown field, expected softness",
        ),
        (put_in("look", 5), "look: got 5, expected an object"),
        (lambda content: content.pop("look"), "look: got nothing, expected a field of this name"),
        (lambda content: content["look"].pop("softness"), "look.softness: got nothing"),
        (put_in("look.shine", 0.1), "appearance.shine: got"),
    ],
)
def test_an_older_file_is_refused_for_a_field_that_its_version_has_not(version, change, sentence):
    content, arrays = read_manifest_of(version)
    change(content)

    with pytest.raises(palpate.FileError, match=sentence):
        unpack_organ(content, arrays, version, "a.organ")


def test_a_look_is_unknown_to_a_file_of_this_version():
    content, arrays = read_manifest_of(VERSION)
    content["look"] = content["appearance"]

    with pytest.raises(palpate.FileError, match="look: got an unknown field"):
        unpack_organ(content, arrays, VERSION, "a.organ")


@pytest.mark.parametrize("version", [4, VERSION])
def test_plain_tissue_stays_plain_in_every_version(version):
    content, arrays = read_manifest_of(version)
    content["look" if version < VERSION else "appearance"] = None

    assert unpack_organ(content, arrays, version, "a.organ").appearance is None


def test_an_older_file_is_written_again_with_the_terms_of_this_version(tmp_path):
    write_organ(tmp_path / "a.organ", read_organ(KEPT / "v4.organ"))

    manifest = manifest_of(tmp_path / "a.organ")
    assert manifest["version"] == VERSION
    assert "look" not in manifest["content"]
    assert manifest["content"]["appearance"] == asdict(APPEARANCE) | {
        name: list(value) for name, value in asdict(APPEARANCE).items() if isinstance(value, tuple)
    }
