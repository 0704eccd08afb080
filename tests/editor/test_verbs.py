# SPDX-License-Identifier: GPL-3.0-or-later
"""The designer's verbs on real organs and on files that are hostile."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path

import pytest
from forks import End, run_in_forks
from palpate.cli.main import main

INSPECTED = {
    "vertices",
    "triangles",
    "shells",
    "border_loops",
    "genus",
    "closed",
    "outward",
    "non_manifold_edges",
    "self_intersecting_faces",
    "smallest_angle_deg",
    "size_mm",
    "volume_ml",
    "unit",
    "unit_guessed",
}
TIME_LIMIT = 10.0  # [s] that the issue allows a hostile file
MEMORY_LIMIT = 2_000_000_000  # [bytes]


def report_of(capsys, *words: object) -> dict:
    assert main([*map(str, words), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


@pytest.fixture(scope="session")
def spleen(tmp_path_factory, shared_data) -> Path:
    """The real spleen at 600 vertices, as `palpate import` leaves it."""
    out = tmp_path_factory.mktemp("spleen") / "spleen.obj"
    source = shared_data("organs/VH_F_Spleen.glb")
    assert main(["import", str(source), "--vertices", "600", "-o", str(out)]) == 0
    return out


def test_a_real_spleen_of_five_open_parts_is_one_closed_organ(shared_data, capsys):
    report = report_of(capsys, "inspect", shared_data("organs/VH_F_Spleen.glb"))

    assert set(report) >= INSPECTED
    assert (report["vertices"], report["triangles"]) == (4274, 8544)
    assert (report["shells"], report["genus"], report["closed"]) == (1, 0, True)
    assert report["border_loops"] == [] and report["outward"] is True
    assert report["unit"] == "m" and report["unit_guessed"] is False
    assert len(report["parts"]) == 5
    assert report["volume_ml"] == pytest.approx(190.7, abs=0.5)


def test_one_part_alone_is_open(shared_data, capsys):
    source = shared_data("organs/VH_F_Spleen.glb")
    name = report_of(capsys, "inspect", source)["parts"][0]["name"]

    report = report_of(capsys, "inspect", source, "--part", name)

    assert report["parts_used"] == [name]
    assert report["closed"] is False and report["border_loops"]
    assert report["volume_ml"] is None and report["outward"] is None


def test_a_part_the_file_does_not_have_is_refused_with_those_it_has(shared_data, capsys):
    source = shared_data("organs/VH_F_Spleen.glb")

    assert main(["inspect", str(source), "--part", "hilum of nothing", "--json"]) == 1

    error = json.loads(capsys.readouterr().out)["error"]
    assert "hilum of nothing" in error["got"] + error["where"]


def test_the_unit_given_is_the_unit_used(shared_data, capsys):
    source = shared_data("organs/VH_F_Pancreas.glb")
    stated = report_of(capsys, "inspect", source)

    given = report_of(capsys, "inspect", source, "--unit", "mm")

    assert given["unit"] == "mm" and given["unit_guessed"] is False
    assert given["size_mm"] == pytest.approx([1e-3 * length for length in stated["size_mm"]])


@pytest.mark.usefixtures("little_sky")
def test_a_chain_of_verbs_makes_a_scene_that_can_be_pressed_replayed_and_drawn(spleen, capsys):
    folder = spleen.parent
    scene, record = folder / "spleen.scene.json", folder / "press.prec"

    made = report_of(
        capsys,
        "material",
        spleen,
        "--kind",
        "mms",
        "--stiffness",
        "60N/m",
        "--home",
        "1.5e5N/m3",
        "--fix-lowest",
        "0.1",
        "-o",
        scene,
    )
    checked = report_of(capsys, "check", scene)
    pressed = report_of(
        capsys, "press", scene, "--depth", "4mm", "--record", record, "--plot", folder / "press.png"
    )
    replayed = report_of(capsys, "replay", record)
    drawn = report_of(capsys, "render", record, "-o", folder / "picture.png", "--size", "320x180")

    assert made["particles"] == 600 and made["bonds"] == 1794 and made["total_mass_g"] > 100.0
    assert not [p for p in checked["problems"] if p["severity"] == "error"]
    assert pressed["peak_force_N"] > 0.05 and pressed["pull_force_N"] is None
    assert replayed["equal"] is True and replayed["ticks"] == pressed["ticks"]
    assert drawn["time_s"] is not None
    for name in ("press.png", "picture.png"):
        assert (folder / name).read_bytes().startswith(b"\x89PNG")


def test_decimate_reaches_the_exact_count(spleen, tmp_path, capsys):
    report = report_of(capsys, "decimate", spleen, "--vertices", "300", "-o", tmp_path / "s.obj")

    assert (report["vertices"], report["triangles"]) == (300, 596)
    assert report["smallest_angle_deg"] > 15.0


@pytest.mark.parametrize("vertices", ["3", "601", "-5"])
def test_a_count_that_cannot_be_reached_is_refused(spleen, tmp_path, capsys, vertices):
    out = tmp_path / "s.obj"

    assert main(["decimate", str(spleen), "--vertices", vertices, "-o", str(out), "--json"]) == 1

    assert "error" in json.loads(capsys.readouterr().out)
    assert not out.exists()


@pytest.mark.parametrize("name", ["spleen.txt", "spleen"])
def test_a_surface_goes_only_into_files_it_can_be_read_from(name, spleen, tmp_path, capsys):
    assert main(["decimate", str(spleen), "--vertices", "300", "-o", str(tmp_path / name)]) == 1

    assert "expected .organ, or .obj or .stl for the surface alone" in capsys.readouterr().err
    assert not (tmp_path / name).exists()


def test_check_names_every_problem_at_once(spleen, tmp_path, capsys):
    mesh = tmp_path / "spleen.obj"
    mesh.write_bytes(spleen.read_bytes())
    scene = tmp_path / "bad.scene.json"
    assert (
        main(["material", str(mesh), "--home", "0N/m3", "--tool-radius", "0.5mm", "-o", str(scene)])
        == 0
    )
    capsys.readouterr()

    assert main(["check", str(scene), "--json"]) == 0

    where = [p["where"] for p in json.loads(capsys.readouterr().out)["problems"]]
    assert where == ["fixed", "tool.radius"]


def test_check_exits_1_where_a_scene_cannot_be_built(spleen, tmp_path, capsys):
    mesh = tmp_path / "spleen.obj"
    mesh.write_bytes(spleen.read_bytes())
    scene = tmp_path / "bad.scene.json"
    assert main(["material", str(mesh), "-o", str(scene)]) == 0
    scene.write_text(
        scene.read_text(encoding="utf-8").replace('"density": 1060.0', '"density": -1.0'),
        encoding="utf-8",
    )
    capsys.readouterr()

    assert main(["check", str(scene), "--json"]) == 1

    problems = json.loads(capsys.readouterr().out)["problems"]
    assert any("density" in p["where"] and "-1" in p["got"] for p in problems)


def hostile_files() -> list[str]:
    from data_folder import find_data

    manifest = find_data() / "hostile" / "MANIFEST.csv"
    if not manifest.is_file():
        return []
    with manifest.open(newline="") as lines:
        return [row["file"] for row in csv.DictReader(lines)]


LIMITS = {"memory": MEMORY_LIMIT, "processor": 600, "wall": round(3 * TIME_LIMIT)}


@pytest.fixture(scope="module")
def inspected(shared_data, spleen, tmp_path_factory) -> dict[str, End]:
    """How `palpate inspect` ended on each hostile file, and what it wrote."""
    # all that is imported late stands before the first fork
    prepare = f"from palpate.cli.main import main, run_main; main(['inspect', {str(spleen)!r}])"
    each = "import sys; sys.argv = ['palpate', 'inspect', file, '--json']; run_main()"
    files = [shared_data(f"hostile/{name}") for name in hostile_files()]
    return run_in_forks(prepare, each, files, tmp_path_factory.mktemp("inspected"), LIMITS)


# the reader in its confined process, which all go through, is asked every time in test_hostile.py
@pytest.mark.landing
@pytest.mark.parametrize("name", hostile_files() or ["(none found)"])
def test_a_hostile_file_gives_a_report_or_a_sentence(name, shared_data, inspected):
    code, said, complained = inspected[str(shared_data(f"hostile/{name}"))]

    assert code in (0, 1), complained
    report = json.loads(said, parse_constant=lambda word: pytest.fail(f"{word} in JSON"))
    if code == 0:
        assert set(report) >= INSPECTED
        assert all(math.isfinite(length) for length in report["size_mm"])
    else:
        assert set(report["error"]) == {"file", "where", "got", "expected"}
        assert report["error"]["got"] and report["error"]["expected"]
    assert "Traceback" not in complained
