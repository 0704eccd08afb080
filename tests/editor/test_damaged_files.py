# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged working files are refused in a sentence, by the reader and by the schema alike."""

from __future__ import annotations

import io
import json
import random
import sys
import zipfile
from dataclasses import asdict
from pathlib import Path

import jsonschema
import numpy as np
import palpate
import pytest
from organs import APPEARANCE, make_organ
from palpate_editor.document.files import VERSION, read_organ, write_organ

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

SCHEMA = Path(palpate.__file__).parent / "schemas" / "organ.schema.json"


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
    "a newer version": (with_change("version", VERSION + 1), "a newer version|version: got"),
    "another format": (with_change("format", "palpate"), "format"),
    "no name": (lambda good: with_manifest(good, remove("content|name")), "name: got nothing"),
    "a field nobody knows": (with_change("content|colour", "red"), "colour: got an unknown"),
    "half a tetrahedron": (
        with_change("content|fill|tetrahedra", 1200.5),
        "fill.tetrahedra: got 1200.5, expected a whole number",
    ),
    "no share": (with_manifest_without_share, "fill: got no nodal_share"),
    "a number for a region": (with_change("content|fill|reach", 3), "fill.reach: got 3"),
    "text for a number": (with_change("content|model|drag", "fast"), 'model.drag: got "fast"'),
    "a constant nobody knows": (with_change("content|model|pace", 1.0), "model.pace"),
    "painted twice": (with_change("content|model|fixed", [1]), "model.fixed: got an unknown"),
    "no constant": (lambda good: with_manifest(good, remove("content|tool|radius")), "no radius"),
    "a colour that is none": (
        with_change("content|appearance", {**asdict(APPEARANCE), "colour": [2.0, 0.0, 0.0]}),
        "appearance.colour: got [2.0, 0.0, 0.0], expected three numbers of 0 to 1",
    ),
    "a list for a part": (with_change("content|hand", []), "hand: got [[]], expected an object"),
    "a number for a name": (with_change("content|name", 5), "name: got 5, expected text"),
    "a number for a source": (with_change("content|source", 5), "source: got 5"),
    "half a source": (lambda good: with_manifest(good, remove("content|source|sha256")), "no sha"),
    "text for a truth": (with_change("content|source|up_guessed", "no"), "up_guessed"),
    "a half vertex": (with_change("content|decimation|vertices", 0.5), "a whole number"),
    "NaN in an array": (changed_array("surface/vertices", at((3, 1), np.nan)), "number 10"),
    "a corner too far": (
        changed_array("surface/triangles", at((7, 2), 60)),
        "surface/triangles: got vertex numbers 0 to 60, expected 0 to 59",
    ),
    "a corner below zero": (
        changed_array("imported/triangles", at((0, 0), -1)),
        "got vertex numbers -1 to 149",
    ),
    "a vertex fixed twice": (changed_array("fixed", at((1,), 0)), "fixed: got other numbers"),
    "a fixed vertex too far": (changed_array("fixed", at((4,), 60)), "ascending ones from 0 to 59"),
    "a region twice": (with_change("content|regions", ["a", "a"]), "regions: got a name twice"),
    "a region without a name": (with_change("content|regions", ["a"]), "regions/1: got an unkn"),
    "a name without a region": (with_change("content|regions", ["a", "b", "c"]), "regions/2: got"),
    "a region beyond": (changed_array("regions/0", at((2,), 60)), "ascending ones from 0 to 59"),
    "too few factors": (changed_array("stiffness_scale", lambda v: v[:-1]), "shape (60)"),
    "whole factors": (
        changed_array("stiffness_scale", lambda v: v.astype(np.int64)),
        "got <i8 of shape",
    ),
    "flat vertices": (changed_array("surface/vertices", lambda v: v[:, :2].copy()), "shape (n, 3)"),
    "no triangles": (without_array("surface/triangles"), "surface/triangles: got no such array"),
    "no factors": (without_array("stiffness_scale"), "stiffness_scale: got no such array"),
    "an array nobody knows": (extra_array, "paint: got an unknown array"),
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
    assert ": got " in sentence and ", expected " in sentence


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
