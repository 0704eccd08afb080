# SPDX-License-Identifier: BSD-3-Clause
"""Truths: between what was solved, and as files."""

from __future__ import annotations

import io
import json
import zipfile
from dataclasses import fields, replace

import numpy as np
import pytest
from palpate.error import FileError
from palpate.files.file_kind import TRUTH, find_kind
from palpate.files.refusal import Refusal
from palpate.study.truth import Truth
from palpate.study.truth_file import ARRAYS, MANIFEST, SHAPES, compute_hash, read_truth, write_truth

DEPTH = np.array([1e-3, 2e-3])


def make_truth(**changes) -> Truth:
    """Of two stations, the second twice as stiff; a paraboloid's force, displacements as lines."""
    force = np.stack([1e3 * DEPTH**1.5, 2e3 * DEPTH**1.5])
    surface = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]) * 0.01
    push = np.array([[0.0, 0, -1], [0, 0, 0], [0, 0, -0.5]])
    moved = DEPTH[None, :, None, None] * push * np.array([1.0, 2.0])[:, None, None, None]
    up = np.tile([0.0, 0.0, 1.0], (2, 1))
    truth = Truth(
        key="abc", law="linear", radius=3e-3, point=0.01 * up, direction=up,
        touch=np.array([3e-3, 3e-3]), thickness=np.array([0.05, 0.04]), depth=DEPTH, force=force,
        force_error=np.full((2, 2), 0.01), contact_radius=np.full((2, 2), 1e-3), surface=surface,
        displacement=moved, displacement_error=np.full((2, 2), 0.002), path="drag", freedoms=12,
        tetrahedra=3, remarks=("a remark",),
    )  # fmt: skip
    return replace(truth, **changes)


@pytest.mark.parametrize("depth", [1e-4, 1e-3, 1.3e-3, 2e-3])
def test_between_depths_a_force_follows_the_power_of_hertz(depth):
    assert make_truth().find_force(0, depth) == pytest.approx(1e3 * depth**1.5)


def test_between_stations_force_and_displacement_are_lines():
    truth = make_truth()

    assert truth.find_force(0.25, 1e-3) == pytest.approx(1.25 * truth.force[0, 0])
    assert truth.find_force(1, 1e-3) == pytest.approx(truth.force[1, 0])
    assert truth.find_displacement(0.25, 1.5e-3)[2] == pytest.approx([0, 0, -1.25 * 0.75e-3])
    assert truth.find_displacement(1, 0.5e-3)[0] == pytest.approx([0, 0, -1e-3])
    assert (truth.find_displacement(0, 2e-3) == truth.displacement[0, 1]).all()


def test_a_pull_has_negative_depths():
    truth = make_truth()
    pull = replace(truth, depth=-truth.depth, force=-truth.force)

    assert pull.find_force(0, -1.5e-3) == pytest.approx(-1e3 * 1.5e-3**1.5)
    assert (pull.find_displacement(0, -1e-3) == truth.displacement[0, 0]).all()
    with pytest.raises(ValueError, match="depth: got 1 mm, expected up to -2 mm"):
        pull.find_force(0, 1e-3)


@pytest.mark.parametrize("depth", [0.0, -1e-3, 2.1e-3])
def test_beyond_what_was_solved_nothing_is_said(depth):
    with pytest.raises(ValueError, match="depth: got .* mm, expected up to 2 mm"):
        make_truth().find_displacement(0, depth)


@pytest.mark.parametrize("station", [-0.1, 1.1, float("nan")])
def test_no_force_is_found_beside_the_path(station):
    with pytest.raises(ValueError, match="station: got .*, expected 0 to 1"):
        make_truth().find_force(station, 1e-3)


def test_a_truth_of_one_station_has_no_other(tmp_path):
    truth = make_truth()
    one = replace(truth, force=truth.force[:1], displacement=truth.displacement[:1])

    assert one.find_force(0, 2e-3) == pytest.approx(truth.force[0, 1])


def test_what_was_written_is_read(tmp_path):
    truth = make_truth()
    write_truth(tmp_path / "a.truth", truth)

    found = read_truth(tmp_path / "a.truth")

    for field in fields(Truth):
        one, other = getattr(found, field.name), getattr(truth, field.name)
        assert type(one) is type(other)
        assert np.array_equal(one, other), field.name
    assert find_kind(tmp_path / "a.truth") == TRUTH


def test_every_byte_that_is_wrong_is_noticed(tmp_path):
    path = tmp_path / "a.truth"
    write_truth(path, make_truth())
    whole = path.read_bytes()
    truth = read_truth(path)

    read = 0
    for at in range(len(whole)):
        path.write_bytes(whole[:at] + bytes([whole[at] ^ 0xFF]) + whole[at + 1 :])
        try:
            found = read_truth(path)
        except Refusal:
            continue
        # of what surrounds the members, as their dates
        read += 1
        assert np.array_equal(found.force, truth.force) and found.key == truth.key
    assert read < len(whole) / 10


@pytest.mark.parametrize("length", [0, 1, 100, -1])
def test_a_file_that_ends_early_is_refused(length, tmp_path):
    path = tmp_path / "a.truth"
    write_truth(path, make_truth())
    path.write_bytes(path.read_bytes()[:length])

    with pytest.raises(Refusal, match="got a damaged file"):
        read_truth(path)


def test_a_folder_is_refused(tmp_path):
    with pytest.raises(FileError, match="something other than a file"):
        read_truth(tmp_path)


def write_members(path, manifest, data, compression=zipfile.ZIP_STORED):
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w", compression) as archive:
        archive.writestr(MANIFEST, json.dumps(manifest))
        archive.writestr(ARRAYS, data)
    path.write_bytes(whole.getvalue())


def take_apart(tmp_path, truth=None):
    path = tmp_path / "a.truth"
    write_truth(path, truth or make_truth())
    with zipfile.ZipFile(path) as archive:
        return path, json.loads(archive.read(MANIFEST)), archive.read(ARRAYS)


def sign(manifest, data):
    manifest["sha256"] = compute_hash(manifest["sizes"], manifest["parts"], data)


@pytest.mark.parametrize(
    ("where", "change"),
    [
        ("format", {"format": "another"}),
        ("format", {"version": 2}),
        ("sizes: got other ones", {"sizes": {"stations": 2}}),
        ("sizes.points", {"sizes": {"stations": 2, "depths": 2, "points": -3}}),
        ("arrays.bin", {"sizes": {"stations": 2, "depths": 2, "points": 10**9}}),
        ("parts.law", {"parts": {"law": "plastic"}}),
        ("parts.path", {"parts": {"path": "jump"}}),
        ("parts.radius", {"parts": {"radius": 0}}),
        ("parts.freedoms", {"parts": {"freedoms": 1.5}}),
        ("parts.remarks", {"parts": {"remarks": [1]}}),
        ("parts: got other ones", {"parts": {"more": 1}}),
    ],
)
def test_a_manifest_that_is_wrong_is_refused_by_its_field(where, change, tmp_path):
    path, manifest, data = take_apart(tmp_path)
    for name, value in change.items():
        manifest[name] = {**manifest[name], **value} if name == "parts" else value
    sign(manifest, data)
    write_members(path, manifest, data)

    with pytest.raises(Refusal, match=where):
        read_truth(path)


def test_numbers_that_are_none_are_refused(tmp_path):
    path, manifest, data = take_apart(tmp_path)
    data = data[:-8] + np.array([np.nan]).tobytes()
    sign(manifest, data)
    write_members(path, manifest, data)

    with pytest.raises(Refusal, match=f"{list(SHAPES)[-1]}: got numbers that are not finite"):
        read_truth(path)


def test_depths_that_do_not_rise_are_refused(tmp_path):
    path, _, _ = take_apart(tmp_path, make_truth(depth=DEPTH[::-1]))

    with pytest.raises(Refusal, match="depth: got depths that do not rise"):
        read_truth(path)


def test_members_that_could_grow_are_refused(tmp_path):
    path, manifest, data = take_apart(tmp_path)
    write_members(path, manifest, data, zipfile.ZIP_DEFLATED)

    with pytest.raises(Refusal, match="members that are compressed"):
        read_truth(path)
