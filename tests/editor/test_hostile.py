# SPDX-License-Identifier: GPL-3.0-or-later
"""Every broken file gives a report or a sentence: no crash, no hang, no flood of memory."""

from __future__ import annotations

import csv
import json
import os
import resource
import subprocess
import sys
from pathlib import Path

import numpy as np
import palpate
import pytest
from data_folder import find_data
from foreign_files import WRITERS
from palpate_editor.authoring import import_mesh, inspect_mesh, join_parts, read_mesh
from palpate_meshes.generate import ellipsoid

MEMORY = 2_000_000_000
PROCESSOR_SECONDS = 10
HANG = 120
"""[s] of wall clock, for a machine under any load; the processor's seconds are what counts."""

SCRIPT = """
import json, sys
import palpate
from palpate_editor.authoring import decimate, import_mesh, inspect_mesh, join_parts, read_mesh

def read_reports(path):
    yield inspect_mesh(join_parts(read_mesh(path)).mesh).as_dict()
    organ = import_mesh(path)
    yield organ.report.as_dict()
    yield inspect_mesh(decimate(organ.mesh, min(50, len(organ.mesh.vertices))).mesh).as_dict()

reports, refusal = [], None
try:
    for report in read_reports(sys.argv[1]):
        reports.append(report)
except palpate.FileError as e:
    refusal = [e.file, e.where, e.found, e.expected]
except ValueError as e:
    refusal = ["", "", str(e), ""]
print(json.dumps({"reports": reports, "refusal": refusal}, allow_nan=False))
"""


def limit() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS))


def read_with_limits(path: Path) -> dict:
    """What a program with limits sees in a file."""
    # every thread of a numerics library sets an address range aside, which is not memory used
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, path],
        capture_output=True,
        text=True,
        timeout=HANG,
        preexec_fn=limit,
        env=environment,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def hostile_files() -> list[str]:
    manifest = find_data() / "hostile" / "MANIFEST.csv"
    if not manifest.exists():
        return ["MANIFEST.csv"]
    with manifest.open() as file:
        return [row["file"] for row in csv.DictReader(file)]


@pytest.mark.parametrize("name", hostile_files())
def test_a_hostile_file_gives_a_report_or_a_sentence(name, shared_data):
    path = shared_data(f"hostile/{name}")

    seen = read_with_limits(path)

    assert seen["reports"] or seen["refusal"]
    # a reader that never ran would refuse everything
    assert "ended with code" not in json.dumps(seen)
    if seen["refusal"] and not seen["reports"]:
        file, _, found, expected = seen["refusal"]
        assert file == str(path)
        assert found
        assert expected
    for report in seen["reports"]:
        assert report["triangles"] > 0


@pytest.mark.parametrize("name", ["VH_F_Kidney_L", "VH_F_Liver", "VH_M_Heart"])
def test_a_large_organ_of_nested_parts_has_a_report_too(name, shared_data):
    seen = read_with_limits(shared_data(f"organs/{name}.glb"))

    (report,) = seen["reports"]
    assert report["self_intersecting_faces"] > 1000
    assert "--part" in seen["refusal"][3]


def spoil(content: bytes, random: np.random.Generator) -> bytes:
    """Cuts off, doubles or overwrites a piece of a file."""
    spoiled = bytearray(content)
    at = int(random.integers(len(spoiled)))
    size = int(random.integers(1, 40))
    kind = random.integers(4)
    if kind == 0:
        return bytes(spoiled[:at])
    if kind == 1:
        spoiled[at:at] = spoiled[at : at + 10 * size]
    elif kind == 2:
        del spoiled[at : at + size]
    else:
        spoiled[at : at + size] = random.bytes(len(spoiled[at : at + size]))
    return bytes(spoiled)


@pytest.mark.parametrize("count", [25, pytest.param(200, marks=pytest.mark.verify)])
@pytest.mark.parametrize("extension", WRITERS)
def test_spoiled_files_of_every_format_are_read_or_refused(extension, count, tmp_path):
    random = np.random.default_rng(sum(extension.encode()))
    path = tmp_path / f"organ.{extension}"
    WRITERS[extension](path, *ellipsoid(50))
    content = path.read_bytes()

    outcomes = []
    for _ in range(count):
        path.write_bytes(spoil(content, random))
        try:
            report = inspect_mesh(join_parts(read_mesh(path)).mesh).as_dict()
            json.dumps(report, allow_nan=False)
            import_mesh(path)
            outcomes.append("imported")
        except palpate.FileError as refusal:
            assert refusal.file == str(path)
            outcomes.append("refused")

    # were it all one of them, nothing would have been tested
    assert "refused" in outcomes
