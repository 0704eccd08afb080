# SPDX-License-Identifier: GPL-3.0-or-later
"""Any bytes as a working file: an organ that comes back when written, or a refusal.

Random bytes do not get past the checksums of a container, so an input is also the document of a
sound one and, after a zero byte, changes of its arrays of eight bytes each. Fuzzed by
tests/fuzz/run_atheris.py; what it found stands in tests/fuzz/corpus/organ.
"""

from __future__ import annotations

import json
from functools import cache

import numpy as np
from organs import APPEARANCE, SEGMENTATION, SOURCE
from palpate.error import FileError
from palpate.scenario import Container, pack_container, unpack_container
from palpate_editor.document import Decimation, FarField, Organ, Surface
from palpate_editor.document.files import FORMAT, VERSION, pack_organ, unpack_organ

Arrays = dict[str, np.ndarray]
ORDER_BYTES = 8
DTYPES = ("<f8", "<i4", "<i8", "<f4", "|u1")


CORNERS = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
FACES = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]


def make_octahedron() -> Organ:
    """An organ with every part that a file can have."""
    surface = Surface(0.02 * np.array(CORNERS, float), np.array(FACES, np.int32))
    imported = Surface(0.03 * np.array(CORNERS, float), np.array(FACES, np.int32))
    return Organ(
        name="octahedron",
        source=SOURCE,
        segmentation=SEGMENTATION,
        imported=imported,
        surface=surface,
        decimation=Decimation(6, 8, 6, 8, 60.0, 1e-3, 2e-3),
        far_field=FarField("0123abcd", 0.008, 8000, np.linspace(-1.0, 50.0, 36)),
        fixed=np.arange(6) == 5,
        stiffness_scale=np.linspace(1.0, 2.0, 6),
        regions={"top": np.array([0, 4], np.int32), "dalağın ucu": np.array([3], np.int32)},
        appearance=APPEARANCE,
        title="Press it",
        task="Find the hard part.",
    )


@cache
def kept_arrays() -> Arrays:
    return pack_organ(make_octahedron())[1]


def write_seed() -> bytes:
    """What the fuzzer begins with: a document whose arrays are as they were."""
    return json.dumps(pack_organ(make_octahedron())[0]).encode()


def change(order: bytes, arrays: Arrays) -> None:
    """One change: which array, what kind of change, where, and four bytes of what."""
    if not arrays:
        return
    name = sorted(arrays)[order[0] % len(arrays)]
    array, where = arrays[name], order[2] | order[3] << 8
    kind = order[1] % 5
    if kind == 0 and array.nbytes >= 4:
        raw = bytearray(array.tobytes())
        at = where % (len(raw) - 3)
        raw[at : at + 4] = order[4:8]
        arrays[name] = np.frombuffer(bytes(raw), array.dtype).reshape(array.shape)
    elif kind == 1:
        del arrays[name]
    elif kind == 2:
        arrays[name] = array[: where % (len(array) + 1)]
    elif kind == 3:
        arrays[name] = np.zeros((where % 9, order[4] % 4 + 1), DTYPES[order[5] % len(DTYPES)])
    else:
        arrays[f"regions/{where % 4}"] = np.frombuffer(order[4:8], "<i4")


def make_file(data: bytes) -> bytes | None:
    """The bytes of a container that the input describes; none where no container can hold it."""
    text, _, orders = data.partition(b"\0")
    arrays = dict(kept_arrays())
    for at in range(0, len(orders) - ORDER_BYTES + 1, ORDER_BYTES):
        change(orders[at : at + ORDER_BYTES], arrays)
    version = 1 + (orders[-1] % VERSION if len(orders) % ORDER_BYTES else VERSION - 1)
    try:
        content = text.decode()
        return pack_container(
            Container(format=FORMAT, version=version, content=content, arrays=arrays)
        )
    except (ValueError, FileError):
        return None


def read_bytes(data: bytes) -> Organ:
    found = unpack_container(data, "fuzzed.organ", FORMAT, VERSION)
    return unpack_organ(json.loads(found.content), found.arrays, found.version, "fuzzed.organ")


def try_organ(data: bytes) -> bool:
    """Whether the input is an organ. Raises for whatever is neither one nor refused in words."""
    file = data if data[:2] == b"PK" else make_file(data)
    if file is None:
        return False
    try:
        organ = read_bytes(file)
    except FileError as refusal:
        assert str(refusal)
        return False
    content, arrays = pack_organ(organ)
    again = Container(
        format=FORMAT, version=VERSION, content=json.dumps(content, allow_nan=False), arrays=arrays
    )
    content_again, arrays_again = pack_organ(read_bytes(pack_container(again)))
    assert content_again == content
    assert {k: a.tobytes() for k, a in arrays_again.items()} == {
        k: a.tobytes() for k, a in arrays.items()
    }
    return True
