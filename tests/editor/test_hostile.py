# SPDX-License-Identifier: GPL-3.0-or-later
"""Every broken file gives a report or a sentence: no crash, no hang, no flood of memory."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import palpate
import pytest
from data_folder import find_data
from foreign_files import WRITERS
from forks import End, run_in_forks
from hostile_verdicts import OPENS, REFUSED, SIMULABLE
from palpate_editor.authoring import import_mesh, inspect_mesh, join_parts, read_mesh
from palpate_editor.check import measure_surface
from palpate_editor.document import EMPTY
from palpate_editor.document.problems import Facts
from palpate_editor.document.rules import find_import_problems, find_repair_problems
from palpate_editor.edits import import_file
from palpate_editor.repair_all import repair_all
from palpate_meshes.generate import ellipsoid

LIMITS = {"memory": 2_000_000_000, "processor": 10, "wall": 120}
"""[bytes], [s], and [s] for a machine under any load; the processor's seconds are what counts."""
LARGE = [
    "VH_F_Kidney_L",
    *(pytest.param(name, marks=pytest.mark.verify) for name in ("VH_F_Liver", "VH_M_Heart")),
]
"""Organs of nested parts. Every run reads a heart in test_read_mesh.py too."""

PREPARE = """
import json
import palpate
from palpate_editor.authoring import decimate, import_mesh, inspect_mesh, join_parts, read_mesh

def read_reports(path):
    yield inspect_mesh(join_parts(read_mesh(path)).mesh).as_dict()
    organ = import_mesh(path)
    yield organ.report.as_dict()
    yield inspect_mesh(decimate(organ.mesh, min(50, len(organ.mesh.vertices))).mesh).as_dict()
"""
EACH = """
reports, refusal = [], None
try:
    for report in read_reports(file):
        reports.append(report)
except palpate.FileError as e:
    refusal = [e.file, e.where, e.got, e.expected]
except ValueError as e:
    refusal = ["", "", str(e), ""]
print(json.dumps({"reports": reports, "refusal": refusal}, allow_nan=False))
"""


@pytest.fixture(scope="module")
def ends(tmp_path_factory) -> Callable[..., dict[str, End]]:
    """ends(*files) is how a program with limits ended on each."""

    def run(*files: Path) -> dict[str, End]:
        return run_in_forks(PREPARE, EACH, files, tmp_path_factory.mktemp("ends"), LIMITS)

    return run


@pytest.fixture(scope="module")
def hostile_ends(ends) -> dict[str, End]:
    files = [find_data() / "hostile" / name for name in hostile_files()]
    return ends(*[file for file in files if file.exists()])


def read_end(end: End) -> dict:
    """What the program saw in the file."""
    code, out, err = end
    assert code == 0, err
    return json.loads(out)


def hostile_files() -> list[str]:
    manifest = find_data() / "hostile" / "MANIFEST.csv"
    if not manifest.exists():
        return ["MANIFEST.csv"]
    with manifest.open() as file:
        return [row["file"] for row in csv.DictReader(file)]


@pytest.mark.parametrize("name", hostile_files())
def test_a_hostile_file_gives_a_report_or_a_sentence(name, shared_data, hostile_ends):
    path = shared_data(f"hostile/{name}")

    seen = read_end(hostile_ends[str(path)])

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


def test_every_hostile_file_has_one_verdict(shared_data):
    shared_data("hostile/MANIFEST.csv")
    assert sorted([*OPENS, *REFUSED]) == sorted(hostile_files())


@pytest.mark.parametrize("name", OPENS)
def test_what_can_be_drawn_opens_with_its_errors(name, shared_data):
    organ = import_file(shared_data(f"hostile/{name}"))(EMPTY)

    facts = Facts(measure_surface(organ.surface)[1])
    found = [*find_import_problems(organ, facts), *find_repair_problems(organ, facts)]
    errors = tuple(problem.key for problem in found if problem.severity == "error")
    assert (len(organ.surface.triangles), errors) == OPENS[name]


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_mesh_is_refused_with_what_was_found(name, shared_data):
    with pytest.raises(palpate.FileError) as refusal:
        import_file(shared_data(f"hostile/{name}"))

    assert REFUSED[name] in refusal.value.got
    assert refusal.value.expected


QUICK = ("VH_F_Spleen", "hostile/")
SLOW = ("regr01", "VH_F_Kidney_L", "VH_F_Liver", "VH_M_Heart")
"""Shared files that are wrapped, or of a hundred thousand triangles: a quarter of a minute each."""


def list_repaired() -> list:
    def mark(name: str) -> tuple:
        if any(word in name for word in (*SLOW, "soup")):
            return (pytest.mark.verify,)
        is_quick = any(word in name for word in QUICK)
        return () if is_quick else (pytest.mark.landing,)

    return [pytest.param(name, marks=mark(name)) for name in SIMULABLE]


@pytest.mark.parametrize("name", list_repaired())
def test_repair_all_makes_of_a_shared_file_what_the_table_says(name, shared_data):
    found, _ = repair_all(import_file(shared_data(name))(EMPTY))

    stages = ("import", "repair", "decimate", "material")
    errors = tuple(p.key for p in found.errors if p.stage in stages)
    assert errors == SIMULABLE[name]
    assert errors or found.scene is not None
    # nothing that can be drawn is lost by it
    assert len(found.organ.surface.triangles) > 0


def test_every_shared_file_that_opens_is_in_the_table(shared_data):
    folder = shared_data("organs")
    organs = [f"organs/{file.name}" for file in folder.iterdir() if file.suffix != ".csv"]
    assert sorted(SIMULABLE) == sorted([*(f"hostile/{name}" for name in OPENS), *organs])


@pytest.mark.parametrize("name", LARGE)
@pytest.mark.landing
def test_a_large_organ_of_nested_parts_has_a_report_too(name, shared_data, ends):
    path = shared_data(f"organs/{name}.glb")

    seen = read_end(ends(path)[str(path)])

    read, *_ = seen["reports"]
    assert read["self_intersecting_faces"] > 1000


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
