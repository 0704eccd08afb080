# SPDX-License-Identifier: GPL-3.0-or-later
"""Working files: nothing is lost, nothing damaged is taken, and no kill leaves half of one."""

from __future__ import annotations

import copy
import io
import json
import os
import random
import subprocess
import sys
import zipfile
from dataclasses import asdict, fields, replace
from pathlib import Path

import jsonschema
import numpy as np
import palpate
import pytest
from organs import LOOK, make_organ, open_surface, same, surface_of
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
sys.path.append(str(TESTS / "bindings"))
from english import say_in_turkish  # noqa: E402
from hostile_scenarios import (  # noqa: E402
    array_of,
    entries_of,
    flip,
    pack,
    remove,
    set_in,
    with_array,
    with_entry,
    with_manifest,
)

KEPT = TESTS / "scenes" / "published"
SCHEMA = Path(palpate.__file__).parent / "schemas" / "organ.schema.json"

ORGANS = {
    "nothing yet": EMPTY,
    "words alone": Organ(name="dalak", title="Dalağa bas", task="Bas.\nBırak."),
    "decimated": make_organ(),
    "as imported": make_organ(imported=None),
    "made here": replace(make_organ(imported=None), source=None, imported=None),
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
    content, arrays = pack_organ(make_organ())

    kept = set(content) | {name.split("/")[0] for name in arrays}

    assert kept == {f.name for f in fields(Organ)}


def as_read(content: dict[str, object]) -> dict[str, object]:
    """As it comes from a file: tuples are lists in JSON."""
    return json.loads(json.dumps(content))


@pytest.mark.parametrize(
    ("languages", "sentence"),
    [
        ([], "languages: found [], expected an object"),
        ({"TR": {"title": "", "task": ""}}, "languages: found the code 'TR', expected a code such"),
        ({"tr": {"title": "", "task": 1}}, "languages.tr.task: found 1, expected text"),
        ({"tr": {"title": ""}}, "languages.tr: found no task"),
        ({"tr": {"title": "", "task": "", "voice": ""}}, "languages.tr.voice: found"),
        (
            {f"a{a}{b}": {} for a in "abcdefgh" for b in "abcdefg"},
            "found 56 languages, expected at",
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
    assert organ.look == LOOK
    assert organ.fill == (FillPart() if version < 3 else FillPart(1200, 0.75, "hilum"))
    assert {name: ids.tolist() for name, ids in organ.regions.items()} == {
        "hilum": [1, 4, 7],
        "alt uç": [],
    }


def test_the_kept_file_of_this_version_is_what_is_written_today(tmp_path):
    organ = read_organ(KEPT / f"v{VERSION}.organ")
    write_organ(tmp_path / "a.organ", organ)

    assert manifest_of(tmp_path / "a.organ") == manifest_of(KEPT / f"v{VERSION}.organ")


# --- what is refused -------------------------------------------------------------------------


@pytest.fixture(scope="module")
def good(tmp_path_factory) -> bytes:
    path = tmp_path_factory.mktemp("good") / "good.organ"
    write_organ(path, make_organ())
    return path.read_bytes()


def with_change(path: str, value: object):
    return lambda good: with_manifest(good, set_in(path, value))


def changed_array(name: str, change):
    def make(good: bytes) -> bytes:
        values = array_of(good, name)
        return with_array(good, name, change(values))

    return make


def at(index: tuple, value: float):
    def change(values: np.ndarray) -> np.ndarray:
        values[index] = value
        return values

    return change


def without_array(name: str):
    def make(good: bytes) -> bytes:
        entries = entries_of(good)
        manifest = json.loads(entries["manifest.json"])
        del manifest["arrays"][name], entries[name]
        return pack(entries | {"manifest.json": json.dumps(manifest).encode()})

    return make


def extra_array(good: bytes) -> bytes:
    return with_array(good, "paint", np.zeros(3))


def with_manifest_without_share(good: bytes) -> bytes:
    return with_manifest(good, remove("content|fill|nodal_share"))


DAMAGED = {
    "empty": (lambda good: b"", "an empty file"),
    "text": (lambda good: b"solid spleen" * 9, "something other than a zip archive"),
    "half": (lambda good: good[: len(good) // 2], "damaged zip archive"),
    "a flipped bit": (lambda good: flip(good, len(good) // 2), "damaged|SHA-256"),
    "an entry more": (lambda good: with_entry(good, "extra"), "that the manifest does not name"),
    "a newer version": (with_change("version", VERSION + 1), "a newer version|version: found"),
    "another format": (with_change("format", "palpate"), "format"),
    "no name": (lambda good: with_manifest(good, remove("content|name")), "name: found nothing"),
    "a field nobody knows": (with_change("content|colour", "red"), "colour: found an unknown"),
    "half a tetrahedron": (
        with_change("content|fill|tetrahedra", 1200.5),
        "fill.tetrahedra: found 1200.5, expected a whole number",
    ),
    "no share": (with_manifest_without_share, "fill: found no nodal_share"),
    "a number for a region": (with_change("content|fill|reach", 3), "fill.reach: found 3"),
    "text for a number": (with_change("content|model|drag", "fast"), 'model.drag: found "fast"'),
    "a constant nobody knows": (with_change("content|model|pace", 1.0), "model.pace"),
    "painted twice": (with_change("content|model|fixed", [1]), "model.fixed: found an unknown"),
    "no constant": (lambda good: with_manifest(good, remove("content|tool|radius")), "no radius"),
    "a colour that is none": (
        with_change("content|look", {**asdict(LOOK), "colour": [2.0, 0.0, 0.0]}),
        "look.colour: found [2.0, 0.0, 0.0], expected three numbers of 0 to 1",
    ),
    "a list for a part": (with_change("content|hand", []), "hand: found [[]], expected an object"),
    "a number for a name": (with_change("content|name", 5), "name: found 5, expected text"),
    "a number for a source": (with_change("content|source", 5), "source: found 5"),
    "half a source": (lambda good: with_manifest(good, remove("content|source|sha256")), "no sha"),
    "text for a truth": (with_change("content|source|up_guessed", "no"), "up_guessed"),
    "a half vertex": (with_change("content|decimation|vertices", 0.5), "a whole number"),
    "NaN in an array": (changed_array("surface/vertices", at((3, 1), np.nan)), "number 10"),
    "a corner too far": (
        changed_array("surface/triangles", at((7, 2), 60)),
        "surface/triangles: found vertex numbers 0 to 60, expected 0 to 59",
    ),
    "a corner below zero": (
        changed_array("imported/triangles", at((0, 0), -1)),
        "found vertex numbers -1 to 149",
    ),
    "a vertex fixed twice": (changed_array("fixed", at((1,), 0)), "fixed: found other numbers"),
    "a fixed vertex too far": (changed_array("fixed", at((4,), 60)), "ascending ones from 0 to 59"),
    "a region twice": (with_change("content|regions", ["a", "a"]), "regions: found a name twice"),
    "a region without a name": (with_change("content|regions", ["a"]), "regions/1: found an unkn"),
    "a name without a region": (with_change("content|regions", ["a", "b", "c"]), "regions/2: foun"),
    "a region beyond": (changed_array("regions/0", at((2,), 60)), "ascending ones from 0 to 59"),
    "too few factors": (changed_array("stiffness_scale", lambda v: v[:-1]), "shape (60)"),
    "whole factors": (
        changed_array("stiffness_scale", lambda v: v.astype(np.int64)),
        "found <i8 of shape",
    ),
    "flat vertices": (changed_array("surface/vertices", lambda v: v[:, :2].copy()), "shape (n, 3)"),
    "no triangles": (without_array("surface/triangles"), "surface/triangles: found no such array"),
    "no factors": (without_array("stiffness_scale"), "stiffness_scale: found no such array"),
    "an array nobody knows": (extra_array, "paint: found an unknown array"),
}


@pytest.mark.parametrize("name", DAMAGED)
def test_a_damaged_file_is_refused_in_a_sentence(tmp_path, good, name):
    damage, words = DAMAGED[name]
    path = tmp_path / "bad.organ"
    path.write_bytes(damage(good))

    with pytest.raises(palpate.FileError) as refusal:
        read_organ(path)

    sentence = str(refusal.value)
    assert any(word in sentence for word in (words.replace("[[]]", "[]")).split("|")), sentence
    assert sentence.startswith(str(path)) and "\n" not in sentence
    assert ": found " in sentence and ", expected " in sentence


@pytest.mark.parametrize("name", DAMAGED)
def test_a_damaged_file_is_refused_in_turkish_too(tmp_path, good, turkish, name):
    path = tmp_path / "bad.organ"
    path.write_bytes(DAMAGED[name][0](good))

    with pytest.raises(palpate.FileError) as refusal:
        read_organ(path)

    assert "; beklenen: " in say_in_turkish(str(refusal.value))


def test_no_flipped_bit_changes_an_organ_unseen(tmp_path, good):
    """Some bytes of a ZIP say nothing of what is in it, such as which version wrote it."""
    rng = random.Random(5)
    path, again = tmp_path / "bad.organ", tmp_path / "again.organ"
    unseen = 0
    for _ in range(60):
        path.write_bytes(flip(good, rng.randrange(len(good))))
        try:
            write_organ(again, read_organ(path))
        except palpate.FileError as refusal:
            assert "bad.organ" in str(refusal)
            continue
        assert again.read_bytes() == good
        unseen += 1
    assert unseen < 6


SCHEMA_REFUSES = [
    "a newer version", "no name", "a field nobody knows", "text for a number", "painted twice",
    "no constant", "a list for a part", "a number for a name", "half a source", "a half vertex",
    "flat vertices", "no triangles", "no factors", "an array nobody knows",
]  # fmt: skip


@pytest.mark.parametrize("name", SCHEMA_REFUSES)
def test_what_the_reader_refuses_the_schema_refuses(good, name):
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    data = DAMAGED[name][0](good)

    manifest = json.loads(zipfile.ZipFile(io.BytesIO(data)).read("manifest.json"))

    assert not jsonschema.Draft202012Validator(schema).is_valid(manifest)


def test_what_a_file_cannot_hold_is_refused_and_leaves_the_old_one(tmp_path):
    path = tmp_path / "a.organ"
    write_organ(path, make_organ())
    before = path.read_bytes()

    with pytest.raises(palpate.FileError, match="infinite or not a number"):
        write_organ(path, replace(make_organ(), stiffness_scale=np.full(60, np.nan)))
    with pytest.raises(palpate.FileError, match=r"a\.organ"):
        write_organ(path, replace(make_organ(), task="\udcff"))

    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


def test_a_place_that_cannot_be_written_is_a_sentence(tmp_path):
    with pytest.raises(palpate.FileError, match="nowhere"):
        write_organ(tmp_path / "nowhere" / "a.organ", EMPTY)


# --- kills -----------------------------------------------------------------------------------


def test_a_kill_while_saving_leaves_the_old_or_the_new_file_whole(tmp_path):
    # most of the time is spent in writing, so most kills come in the middle of it
    large = surface_of(60)
    many = np.tile(large.vertices, (5000, 1))
    for name in ("old", "new"):
        organ = replace(make_organ(), name=name, imported=replace_vertices(large, many))
        write_organ(tmp_path / name, organ)
    random.seed(7)
    moments = [str(random.uniform(0.0, 0.1)) for _ in range(50)]
    folder = tmp_path / "folder"
    folder.mkdir()

    script = TESTS / "bindings" / "save_again_and_again.py"
    command = [sys.executable, script, folder / "a.organ", tmp_path / "old", tmp_path / "new"]
    alone = {"OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run([*map(str, command), *moments], capture_output=True, text=True,
                          env=os.environ | alone)  # fmt: skip

    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert len(found) == 50
    assert {words for words, _ in found} == {"old", "new"}
    # some kills came in the middle of a file, or none of this was shown
    assert any(in_the_middle for _, in_the_middle in found)


def replace_vertices(surface, vertices):
    return replace(copy.copy(surface), vertices=vertices)
