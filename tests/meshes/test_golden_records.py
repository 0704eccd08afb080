# SPDX-License-Identifier: BSD-3-Clause
"""Records of earlier versions replay to the same bits, or the commit that changes them says why."""

from __future__ import annotations

import json

import numpy as np
import palpate
import pytest
from golden_records import GOLDEN, PLAIN, RECORDS, SCENES, SPRINGS, Golden, open_scene
from palpate_editor.shipped import list_organs
from palpate_meshes.catalogue import PUBLISHED

MEANT = (
    "the replay of {name} is {force:.2g} N and {position:.2g} m off, first at tick {tick}; if that "
    "is meant, run tests/meshes/golden_records.py and explain it in the commit (CONTRIBUTING.md)"
)


ESTIMATED = ("AVX2", "SSE4")
"""Targets whose estimates of 1/x and 1/sqrt(x) each processor tabulates for itself; those of AVX3
are the same everywhere. Seen between two makers: 3.7e-6 N and 8e-9 m; between two processors of
one: 6e-7 N."""


COSTLY = ("solid_liver", "shell_gallbladder", "shell_stomach")
"""These at a landing, as two thirds of the others: each scene and each target has one every day."""


@pytest.mark.parametrize(
    "golden",
    [
        pytest.param(
            golden,
            marks=[pytest.mark.landing] if golden.name in COSTLY or number % 3 else [],
            id=golden.path.stem,
        )
        for number, golden in enumerate(GOLDEN)
    ],
)
def test_a_record_of_an_earlier_version_replays_to_the_same_bits(golden):
    if not golden.can_run:
        pytest.skip(f"cannot be had here: the vector target {golden.target}")
    record = palpate.read_record(golden.path)

    report = palpate.replay(open_scene(golden), record)

    assert report.ticks == len(record.hand)
    same = report.equal
    if golden.target in ESTIMATED:
        same = same or (
            report.largest_force_difference <= 1e-5 and report.largest_position_difference <= 1e-7
        )
    assert same, MEANT.format(
        name=golden.path.name,
        force=report.largest_force_difference,
        position=report.largest_position_difference,
        tick=report.first_difference,
    )


@pytest.mark.parametrize("golden", GOLDEN[::4], ids=lambda golden: golden.path.stem)
def test_a_record_of_one_instrument_is_written_byte_for_byte_as_ever(golden, tmp_path):
    palpate.write_record(tmp_path / "again.prec", palpate.read_record(golden.path))

    assert (tmp_path / "again.prec").read_bytes() == golden.path.read_bytes()


def test_every_shipped_organ_is_kept_for_every_target_pressed_and_pulled():
    shipped = {PUBLISHED / f"{entry.name}.palpate" for entry, _ in list_organs()}

    assert {path.name for path in RECORDS.iterdir()} == {golden.path.name for golden in GOLDEN}
    pressed = {path.read_bytes() for path in SCENES.values()}
    assert all(path.read_bytes() in pressed for path in shipped)
    assert set(SPRINGS.glob("*.palpate")) <= set(SCENES.values())
    for golden in GOLDEN:
        record = palpate.read_record(golden.path)
        header = json.loads(record.header)
        force = np.asarray(record.felt["force"], dtype=float)
        assert header["kernel"] == ("reference" if golden.target == PLAIN else "packed")
        assert golden.target in (header["vector_target"], PLAIN)
        assert len(record.hashes) >= 8
        # up while it is pressed, down while it is pulled
        assert force[:, 2].max() > 0.02 and force[:, 2].min() < -0.02, golden.path.name


def test_the_last_bit_of_one_force_is_seen():
    golden = Golden("simple_tissue", PLAIN)
    record = palpate.read_record(golden.path)
    felt = np.array(record.felt)
    tick = int(np.linalg.norm(felt["force"], axis=1).argmax())
    felt["force"][tick, 2] = np.nextafter(felt["force"][tick, 2], np.float32(0))
    changed = palpate.Record(
        header=record.header, hand=record.hand, felt=felt, hashes=record.hashes
    )

    report = palpate.replay(open_scene(golden), changed)

    assert not report.equal
    assert report.first_difference == tick
