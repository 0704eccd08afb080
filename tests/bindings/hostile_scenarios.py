# SPDX-License-Identifier: BSD-3-Clause
"""Published files made to harm their readers, each with words of the sentence it must meet."""

from __future__ import annotations

import copy
import hashlib
import io
import json
import stat
import struct
import warnings
import zipfile
from collections.abc import Callable
from typing import Any

import numpy as np

Entries = list[tuple[zipfile.ZipInfo, bytes]]
Manifest = dict[str, Any]

BODY = "scene/bodies/0/"
MASS = BODY + "tissue/mass"
ENDS = BODY + "tissue/bonds/ends"


def entries_of(good: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(good)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def pack(entries: dict[str, bytes] | Entries, method: int = zipfile.ZIP_STORED) -> bytes:
    """An archive with sound checksums, whatever is in it."""
    if isinstance(entries, dict):
        entries = [(zipfile.ZipInfo(name), data) for name, data in entries.items()]
    file = io.BytesIO()
    with warnings.catch_warnings(), zipfile.ZipFile(file, "w") as archive:
        warnings.simplefilter("ignore", UserWarning)  # of names given twice
        for info, data in entries:
            info.compress_type = method
            archive.writestr(info, data, compresslevel=1)  # bombs are large
    return file.getvalue()


def with_manifest(good: bytes, change: Callable[[Manifest], None]) -> bytes:
    entries = entries_of(good)
    manifest = json.loads(entries["manifest.json"])
    change(manifest)
    entries["manifest.json"] = json.dumps(manifest).encode()
    return pack(entries)


def with_text(good: bytes, text: bytes, method: int = zipfile.ZIP_STORED) -> bytes:
    return pack(entries_of(good) | {"manifest.json": text}, method)


def with_array(good: bytes, name: str, values: np.ndarray, method: int = zipfile.ZIP_STORED):
    """The array replaced, its shape, type and SHA-256 made to fit."""
    entries = entries_of(good)
    manifest = json.loads(entries["manifest.json"])
    entries[name] = values.tobytes()
    manifest["arrays"][name] = {
        "dtype": values.dtype.str,
        "shape": list(values.shape),
        "sha256": hashlib.sha256(entries[name]).hexdigest(),
    }
    entries["manifest.json"] = json.dumps(manifest).encode()
    return pack(entries, method)


def array_of(good: bytes, name: str) -> np.ndarray:
    entries = entries_of(good)
    entry = json.loads(entries["manifest.json"])["arrays"][name]
    return np.frombuffer(entries[name], entry["dtype"]).reshape(entry["shape"]).copy()


def with_number(good: bytes, name: str, at: int, value: float) -> bytes:
    values = array_of(good, name)
    values.flat[at] = value
    return with_array(good, name, values)


def with_entry(good: bytes, name: str, *, mode: int = 0o100644, data: bytes = b"x") -> bytes:
    """One entry more, which the manifest does not know."""
    info = zipfile.ZipInfo(name)
    info.external_attr = mode << 16
    entries = [(zipfile.ZipInfo(n), d) for n, d in entries_of(good).items()]
    return pack([*entries, (info, data)])


def with_linked_mass(good: bytes) -> bytes:
    entries = []
    for name, data in entries_of(good).items():
        info = zipfile.ZipInfo(name)
        if name == MASS:
            info.external_attr = (stat.S_IFLNK | 0o777) << 16
        entries.append((info, data))
    return pack(entries)


def renamed(good: bytes, old: str, new: str) -> bytes:
    """The array under another name, in the manifest and in the archive."""
    entries = entries_of(good)
    manifest = json.loads(entries["manifest.json"])
    manifest["arrays"][new] = manifest["arrays"].pop(old)
    entries[new] = entries.pop(old)
    entries["manifest.json"] = json.dumps(manifest).encode()
    return pack(entries)


def flip(data: bytes, at: int) -> bytes:
    return data[:at] + bytes([data[at] ^ 0x10]) + data[at + 1 :]


def patch_headers(good: bytes, offset_local: int, offset_central: int, value: bytes) -> bytes:
    """The same field of the second entry's two headers overwritten."""
    with zipfile.ZipFile(io.BytesIO(good)) as archive:
        local = archive.infolist()[1].header_offset
        name = archive.infolist()[1].filename.encode()
    central = good.index(b"PK\1\2", good.index(b"PK\1\2") + 4)
    assert good[central + 46 :].startswith(name)
    data = bytearray(good)
    data[local + offset_local : local + offset_local + len(value)] = value
    data[central + offset_central : central + offset_central + len(value)] = value
    return bytes(data)


def lying_bomb(good: bytes) -> bytes:
    """32 MB of zeros in an array that every header says has 64 bytes."""
    entries = entries_of(with_array(good, BODY + "rest_areas", np.zeros(8)))
    entries[BODY + "rest_areas"] = bytes(1 << 25)
    packed = pack(entries, zipfile.ZIP_DEFLATED)
    return patch_headers(packed, 22, 24, struct.pack("<I", 64))


def without(good: bytes, name: str) -> bytes:
    """Neither the manifest nor the archive knows the array."""
    entries = entries_of(good)
    manifest = json.loads(entries["manifest.json"])
    del entries[name], manifest["arrays"][name]
    entries["manifest.json"] = json.dumps(manifest).encode()
    return pack(entries)


def crowd(count: int) -> bytes:
    """An archive whose directory names `count` entries, all at the same place, all of one hash.

    "Az" and "BY" are the same to a hash that goes h * 33 + letter, and so is what is made of them.
    """
    local = struct.pack("<4s5H3I2H", b"PK\3\4", 20, 0, 0, 0, 33, 0, 0, 0, 40, 0) + b"Az" * 20
    directory = []
    for i in range(count):
        name = b"".join(b"BY" if i >> bit & 1 else b"Az" for bit in range(20))
        head = struct.pack(
            "<4s6H3I5H2I", b"PK\1\2", 20, 20, 0, 0, 0, 33, 0, 0, 0, 40, 0, 0, 0, 0, 0, 0
        )
        directory.append(head + name)
    records = b"".join(directory)
    end = struct.pack("<4s4H2IH", b"PK\5\6", 0, 0, count & 0xFFFF, count & 0xFFFF, len(records),
                      len(local), 0)  # fmt: skip
    return local + records + end


def hidden_crowd(good: bytes, count: int) -> bytes:
    """The crowd, with a sound end record hidden in the comment of its own."""
    evil = crowd(count)
    comment = good[-22:]
    return evil[:-2] + struct.pack("<H", len(comment)) + comment


def find_place(manifest: Any, path: str) -> tuple[Any, Any]:
    """What holds the last of the members of `path`, joined by |, and its name or number there."""
    *parents, last = path.split("|")
    for key in parents:
        manifest = manifest[int(key) if isinstance(manifest, list) else key]
    return manifest, int(last) if isinstance(manifest, list) else last


def set_in(path: str, value: Any) -> Callable[[Manifest], None]:
    def change(manifest: Manifest) -> None:
        place, last = find_place(manifest, path)
        place[last] = value

    return change


def remove(path: str) -> Callable[[Manifest], None]:
    def change(manifest: Manifest) -> None:
        place, last = find_place(manifest, path)
        del place[last]

    return change


def many_arrays(manifest: Manifest) -> None:
    entry = manifest["arrays"][MASS]
    manifest["arrays"] |= {f"authored/a{i}": copy.deepcopy(entry) for i in range(1100)}


def expensive_json(size: int) -> bytes:
    """Text in which every three bytes are an object of their own."""
    return b'{"a":[' + b"{}," * ((size - 16) // 3) + b"{}]}"


Make = Callable[[bytes], bytes]
HOSTILE: dict[str, tuple[Make, str]] = {
    "empty": (lambda good: b"", "an empty file"),
    "text": (lambda good: b"hello " * 100, "something other than a zip archive"),
    "html": (lambda good: b"<!DOCTYPE html>" * 9, "something other than a zip archive"),
    "half": (lambda good: good[: len(good) // 2], "damaged zip archive"),
    "without its end": (lambda good: good[:-1], "damaged zip archive"),
    "an appended byte": (lambda good: good + b"\0", "damaged zip archive"),
    "a flipped bit in the manifest": (
        lambda good: flip(good, good.index(b'"arrays"') + 2),
        "manifest.json: got damaged bytes",
    ),
    "a flipped bit in an array": (
        lambda good: flip(good, good.index(entries_of(good)[MASS])),
        f"{MASS}: got damaged bytes",
    ),
    "wrong hash": (
        lambda good: with_manifest(good, set_in(f"arrays|{MASS}|sha256", "0" * 64)),
        f"{MASS}: got SHA-256",
    ),
    "hash of capitals": (
        lambda good: with_manifest(good, set_in(f"arrays|{MASS}|sha256", "A" * 64)),
        "expected 64 hexadecimal digits",
    ),
    "no manifest": (
        lambda good: pack({n: d for n, d in entries_of(good).items() if n != "manifest.json"}),
        "no manifest.json",
    ),
    "missing array": (
        lambda good: pack({n: d for n, d in entries_of(good).items() if n != MASS}),
        f"{MASS}: got no such array",
    ),
    "array the manifest does not name": (
        lambda good: with_manifest(good, remove(f"arrays|{MASS}")),
        "that the manifest does not name",
    ),
    "missing table": (lambda good: without(good, MASS), "expected one; it may be empty"),
    "extra entry": (lambda good: with_entry(good, "extra"), "that the manifest does not name"),
    "path traversal": (
        lambda good: with_entry(good, "../../etc/cron.d/evil"),
        "that the manifest does not name",
    ),
    "path traversal the manifest knows": (
        lambda good: renamed(good, MASS, "authored/../../evil"),
        "leads out of the file",
    ),
    "absolute name": (lambda good: renamed(good, MASS, "/etc/passwd"), "leads out of the file"),
    "backslashes": (lambda good: renamed(good, MASS, "authored\\..\\evil"), "other characters"),
    "a name of another alphabet": (
        lambda good: renamed(good, MASS, "authored/dalak\u0131"),
        "other characters",
    ),
    "endless name": (lambda good: renamed(good, MASS, "a" * 60000), "too long"),
    "symlink": (with_linked_mass, f"{MASS}: got a link or a folder"),
    "folder": (lambda good: with_entry(good, "folder/", mode=0o40755, data=b""), "a folder"),
    "device": (lambda good: with_entry(good, "zero", mode=stat.S_IFCHR | 0o666), "a link"),
    "one name twice": (
        lambda good: with_entry(good, MASS, data=entries_of(good)[MASS]),
        "two entries of one name",
    ),
    "two manifests": (
        lambda good: with_entry(good, "manifest.json", data=b"{}"),
        "two entries of one name",
    ),
    "encrypted": (lambda good: patch_headers(good, 6, 8, b"\1\0"), "an encrypted entry"),
    "unknown compression": (
        lambda good: patch_headers(good, 8, 10, b"\x61\0"),
        "expected stored or deflated",
    ),
    "bzip2": (
        lambda good: pack(entries_of(good), zipfile.ZIP_BZIP2),
        "expected stored or deflated",
    ),
    "bomb of one array": (
        lambda good: with_array(
            good, "authored/bomb", np.zeros(1 << 25), zipfile.ZIP_DEFLATED
        ),
        "arrays of more than",
    ),
    "a shape beyond the limit": (
        lambda good: with_manifest(good, set_in(f"arrays|{MASS}|shape", [2**24 + 1])),
        "arrays of more than",
    ),
    "bomb of a manifest": (
        lambda good: with_text(good, b"{" + b" " * (1 << 28) + b"}", zipfile.ZIP_DEFLATED),
        "manifest.json: got 268435458 bytes",
    ),
    "a bomb that lies about its size": (lying_bomb, "rest_areas: got"),
    "expensive JSON": (
        lambda good: with_text(good, expensive_json(4 << 20)),
        "manifest.json.format: got nothing",
    ),
    "deep JSON": (
        lambda good: with_text(good, b'{"a":' + b"[" * 1000000 + b"]" * 1000000 + b"}"),
        "values within more than 64 others",
    ),
    "JSON of one name twice": (
        lambda good: with_text(good, b'{"format":"palpate","format":"organ"}'),
        "two members named",
    ),
    "JSON that breaks off": (lambda good: with_text(good, b'{"format":'), "not JSON"),
    "NaN in JSON": (
        lambda good: with_manifest(good, set_in("content|scene|rate", float("nan"))),
        "not JSON",
    ),
    "a number beyond floats": (
        lambda good: with_text(good, b'{"format":1e999}'),
        "too large for a float",
    ),
    "not UTF-8": (lambda good: with_text(good, b'{"format":"\xff\xfe"}'), "not JSON"),
    "a list for a manifest": (lambda good: with_text(good, b"[1,2]"), "expected an object"),
    "another format": (
        lambda good: with_manifest(good, set_in("format", "organ")),
        'got "organ", expected "palpate"',
    ),
    "a newer version": (
        lambda good: with_manifest(good, set_in("version", 8)),
        "the file was made by a newer program",
    ),
    "version 0": (lambda good: with_manifest(good, set_in("version", 0)), "version: got 0"),
    "version 1e300": (
        lambda good: with_manifest(good, set_in("version", 1e300)),
        "version: got",
    ),
    "an unknown member": (
        lambda good: with_manifest(good, set_in("script", "rm -rf")),
        'unknown member "script"',
    ),
    "NaN": (lambda good: with_number(good, MASS, 3, np.nan), f"{MASS}: got number 3"),
    "infinity": (lambda good: with_number(good, MASS, 0, -np.inf), "infinite or not a number"),
    "index out of range": (lambda good: with_number(good, ENDS, 9, 2**31 - 1), "bonds.ends: row 4"),
    "negative index": (
        lambda good: with_number(good, BODY + "tissue/triangles", 0, -1),
        "triangles: row 0",
    ),
    "absurd shape": (
        lambda good: with_manifest(good, set_in(f"arrays|{MASS}|shape", [2**62, 2**62, 2**62])),
        "arrays of more than",
    ),
    "negative shape": (
        lambda good: with_manifest(good, set_in(f"arrays|{MASS}|shape", [-1])),
        "shape: got -1",
    ),
    "shape of many dimensions": (
        lambda good: with_manifest(good, set_in(f"arrays|{MASS}|shape", [1] * 1000)),
        "shape: got a list of 1000",
    ),
    "many arrays": (lambda good: with_manifest(good, many_arrays), "expected at most 1024"),
    "half a number": (
        lambda good: with_manifest(good, set_in(f"arrays|{MASS}|dtype", "<f2")),
        "dtype: got",
    ),
    "an array shorter than its shape": (
        lambda good: with_manifest(good, set_in(f"arrays|{MASS}|shape", [1000])),
        "which its shape needs",
    ),
    "more particles than anybody can feel": (
        lambda good: with_array(
            with_array(good, MASS, np.ones(3000000), zipfile.ZIP_DEFLATED),
            BODY + "tissue/rest_position", np.ones((3000000, 3)), zipfile.ZIP_DEFLATED,
        ),
        "3000000 rows, expected at most 20000",
    ),
    "a derived number of another tissue": (
        lambda good: with_manifest(good, set_in("content|scene|bodies|0|spectrum_stiffness", 1.0)),
        "spectrum_stiffness: got 1",
    ),
    "masses near nothing": (
        lambda good: with_array(good, MASS, array_of(good, MASS) * 1e-300),
        f"{MASS}: row 0: got ",
    ),
    "a crowd of entries": (lambda good: crowd(200000), "a directory of too many entries"),
    "a hidden crowd of entries": (
        lambda good: hidden_crowd(good, 200000),
        "a directory of too many entries",
    ),
}  # fmt: skip
