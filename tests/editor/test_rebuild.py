# SPDX-License-Identifier: GPL-3.0-or-later
"""What was done to an organ is written down, and done again it gives the same bytes."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import palpate
import pytest
from organs import make_organ, same, surface_of
from palpate.cli.main import main
from palpate.scenario import Container, read_container, write_container
from palpate_editor import authoring, edits
from palpate_editor.compile import mesh_of
from palpate_editor.document import EMPTY, Surface
from palpate_editor.document.files import VERSION, read_organ, write_organ
from palpate_editor.shipped import list_organs
from palpate_editor.shipped import make_organ as make_shipped
from palpate_meshes.catalogue import PUBLISHED

SHIPPED = [entry.name for entry, _ in list_organs()]
CURVE = "depth [mm], force [N]\n" + "\n".join(f"{d}, {0.12 * d}" for d in (0.5, 1.0, 1.5, 2.0))


def run(capsys, *words: object) -> dict:
    code = main([*map(str, words), "--json"])
    said = capsys.readouterr()
    assert code == 0, said.out + said.err
    return json.loads(said.out)


def refuse(capsys, *words: object) -> str:
    assert main(list(map(str, words))) == 1
    return capsys.readouterr().err


def check_rebuilt(capsys, path: Path) -> dict:
    """That the verb gives the file again, byte for byte."""
    again = path.with_name("again.organ")
    report = run(capsys, "rebuild", path, "-o", again)
    assert report["same"] is True
    assert again.read_bytes() == path.read_bytes()
    return report


@pytest.fixture
def stl(tmp_path) -> Path:
    path = tmp_path / "dalak.stl"
    surface = surface_of(150)
    turned = Surface(1e3 * surface.vertices @ np.diag([1.0, -1.0, -1.0]), surface.triangles)
    authoring.write_mesh(path, mesh_of(turned))
    return path


# ---------------------------------------------------------------- every organ, every verb


@pytest.mark.parametrize("name", SHIPPED)
def test_a_shipped_organ_is_rebuilt_to_the_same_bytes(name, tmp_path, capsys):
    path = tmp_path / f"{name}.organ"
    shutil.copy(PUBLISHED / path.name, path)

    report = check_rebuilt(capsys, path)

    edits = [step["edit"] for step in report["steps"]]
    last = "SetTask" if read_organ(path).far_field is None else "SetFarField"
    assert edits[-1] == last
    assert report["begins_with"].endswith("as it was read")


def test_what_ships_is_what_its_maker_makes():
    for name in SHIPPED:
        assert same(read_organ(PUBLISHED / f"{name}.organ"), make_shipped(name)), name


def test_an_organ_made_by_every_verb_is_rebuilt_to_the_same_bytes(stl, tmp_path, capsys):
    organ = tmp_path / "a.organ"
    run(capsys, "import", stl, "--unit", "mm", "--up=-z", "--vertices", 120, "-o", organ)
    change(capsys, organ)
    (tmp_path / "curve.csv").write_text(CURVE, encoding="utf-8")

    run(capsys, "decimate", organ, "--imported", "-o", organ)
    run(capsys, "decimate", organ, "--vertices", 90, "-o", organ)
    run(capsys, "calibrate", organ, "--curve", tmp_path / "curve.csv", "-o", organ)

    report = check_rebuilt(capsys, organ)
    done = [step["edit"] for step in report["steps"]]
    assert done[:2] == ["ImportMesh", "DecimateTo"] and done[-1] == "SetConstant"
    assert {"FixLowest", "PaintStiffness", "SetRegion", "SetTissue", "SetAppearance"} < set(done)
    assert report["begins_with"] == "nothing"


def change(capsys, organ: Path) -> None:
    """By the verbs that change an organ that was imported."""
    for words in (
        ["paint", "--region", "kapı=3,5-9", "--stiffness", "3-9:2.5", "--fix", "0-2"],
        ["material", "--kind", "mss", "--stiffness", "60N/m", "--fix-lowest", "0.1"],
        ["material", "--tissue", "liver", "--gravity=0,0,-9.81", "--tool-radius", "8mm"],
        ["material", "--tissue", "kapı=fat", "--recalled"],
        ["appearance", "--style", "liver", "--colour", "#7a2d25"],
        ["text", "--name", "karaciğer", "--title", "Press it", "--task", "Bas ve bırak."],
        ["text", "--title", "Bas", "--in", "tr"],
        ["paint", "--free", "1", "--forget", "kapı"],
    ):
        run(capsys, words[0], organ, *words[1:], "-o", organ)


def test_a_repaired_organ_keeps_its_original_and_is_rebuilt(tmp_path, capsys):
    surface = surface_of(150)
    open_stl, organ = tmp_path / "open.stl", tmp_path / "open.organ"
    last = len(surface.vertices) - 1
    kept = surface.triangles[~(surface.triangles == last).any(axis=1)]
    open_mesh = palpate.SurfaceMesh(surface.vertices[:-1], kept)
    authoring.write_mesh(open_stl, open_mesh)
    run(capsys, "import", open_stl, "--unit", "m", "-o", organ)

    run(capsys, "repair", organ, "--fill-holes", 12, "-o", organ)

    report = check_rebuilt(capsys, organ)
    assert [step["edit"] for step in report["steps"]] == ["ImportMesh", "FillHoles"]
    first = tmp_path / "first.organ"
    run(capsys, "rebuild", organ, "--steps", 1, "-o", first)
    assert len(palpate.find_border_loops(read_organ(first).surface.triangles)) == 1
    assert palpate.is_closed(read_organ(organ).surface.triangles)


@pytest.mark.landing
def test_a_demo_leaves_an_organ_that_is_rebuilt(stl, tmp_path, capsys):
    run(capsys, "demo", "--mesh", stl, "--unit", "mm", "--vertices", 120, "--out", tmp_path / "o")

    report = check_rebuilt(capsys, tmp_path / "o" / "dalak.organ")

    assert {"ImportMesh", "DecimateTo", "SetMaterial"} <= {s["edit"] for s in report["steps"]}


def test_a_segmented_scan_is_rebuilt_also_from_the_scan(shared_data, tmp_path, capsys):
    scan, organ = shared_data("volumes/ts_example_seg.nii.gz"), tmp_path / "spleen.organ"
    run(capsys, "segment", scan, "--label", 1, "--vertices", 300, "-o", organ)

    check_rebuilt(capsys, organ)
    assert run(capsys, "rebuild", organ, "--original", scan)["same"] is True


def test_the_original_file_is_read_again_where_that_is_wished(stl, tmp_path, capsys):
    organ, other = tmp_path / "a.organ", tmp_path / "other.stl"
    run(capsys, "import", stl, "--up=y", "--vertices", 90, "-o", organ)
    authoring.write_mesh(other, mesh_of(surface_of(120)))

    assert run(capsys, "rebuild", organ, "--original", stl)["same"] is True
    assert "other.stl: got another file, expected the one whose SHA-256" in refuse(
        capsys, "rebuild", organ, "--original", other
    )
    assert main(["rebuild", str(organ), "--original", str(tmp_path / "gone.stl")]) == 1


def test_steps_can_be_left_out_at_the_end(stl, tmp_path, capsys):
    organ, part = tmp_path / "a.organ", tmp_path / "part.organ"
    run(capsys, "import", stl, "--vertices", 90, "-o", organ)
    run(capsys, "text", organ, "--name", "dalak 2", "-o", organ)

    report = run(capsys, "rebuild", organ, "--steps", 2, "-o", part)

    assert [step["done"] for step in report["steps"]] == [True, True, False]
    assert read_organ(part).name == "dalak" and read_organ(part).vertex_count == 90
    assert len(read_organ(part).history.lines) == 2
    assert "--steps: got 4, expected 0 to 3" in refuse(
        capsys, "rebuild", organ, "--steps", 4, "-o", part
    )
    assert main(["rebuild", str(organ), "--steps", "2"]) == 2
    assert "--steps has no effect without --out" in capsys.readouterr().err


def test_the_steps_are_listed_in_words(stl, tmp_path, capsys):
    organ = tmp_path / "a.organ"
    run(capsys, "import", stl, "--vertices", 90, "-o", organ)

    assert main(["rebuild", str(organ)]) == 0

    said = capsys.readouterr().out
    assert "begins with nothing\n    1 Import\n    2 Decimate to 90 vertices\n" in said
    assert "done again: the same organ, bit for bit" in said


# ---------------------------------------------------------------- what is damaged


def damage(path: Path, change) -> None:
    """Writes the file with another content, or other arrays, as sound as a container can be."""
    found = read_container(str(path), "organ", VERSION)
    content, arrays = json.loads(found.content), dict(found.arrays)
    change(content, arrays)
    write_container(
        str(path),
        Container(format="organ", version=VERSION, content=json.dumps(content), arrays=arrays),
    )


def put(*keys, value):
    def change(content, arrays):
        del arrays
        at = content["history"]
        for key in keys[:-1]:
            at = at[key]
        at[keys[-1]] = value

    return change


DAMAGED = [
    (put("lines", 1, "edit", value="Explode"), "history.lines[1].edit: got \"Explode\""),
    (put("lines", 1, "values", value={}), "history.lines[1]: got no vertices"),
    (put("lines", 1, "values", "vertices", value="many"), "history.lines[1].vertices: got"),
    (put("lines", 1, "values", "vertices", value=3), "history.lines[1]: got Decimate to 3"),
    (put("lines", 1, "values", "colour", value=3), "history.lines[1].colour: got an unknown value"),
    (put("lines", 1, "values", "vertices", value=80), "stiffness_scale: got shape (80,)"),
    (put("lines", 2, "values", "name", value="liver"), "name: got \"liver\" from its 4 steps"),
    (put("lines", 3, "values", "vertices", value={"integers": [0, 99]}), "[3].vertices: got [0"),
    (put("lines", 3, "values", "vertices", value={"array": "gone"}), "[3].vertices: got \"gone\""),
    (put("lines", 0, "values", "surface", value={"surface": []}), "lines[0].surface: got []"),
    (put("lines", 0, "values", "surface", value=None), "history.lines[0].surface: got null"),
    (put("lines", value=[]), "history.lines: got [], expected a list of 1 to 1000"),
    (put("lines", 1, value=7), "history.lines[1]: got 7, expected an object of edit, values"),
    (put("folded", value=-1), "history.folded: got -1"),
    (put("begin", value=None), "history.begin: got null"),
    (put("begin", "content", "name", value=3), "history.begin.name: got 3"),
]  # fmt: skip


@pytest.fixture(scope="module")
def kept(tmp_path_factory) -> Path:
    """Imported, decimated, named, painted."""
    path = tmp_path_factory.mktemp("kept") / "a.organ"
    organ = edits.ImportMesh("dalak", make_organ().source, surface_of(150))(EMPTY)
    for edit in (
        edits.DecimateTo(90),
        edits.SetName("karaciğer"),
        edits.PaintStiffness(np.array([3, 4]), np.array([2.0, 3.0])),
    ):
        organ = edit(organ)
    write_organ(path, organ)
    return path


@pytest.mark.parametrize(("change", "sentence"), DAMAGED, ids=[row[1] for row in DAMAGED])
def test_a_damaged_history_is_refused_with_its_place(kept, tmp_path, capsys, change, sentence):
    path = tmp_path / "a.organ"
    shutil.copy(kept, path)
    damage(path, change)

    assert f"a.organ: {sentence}" in refuse(capsys, "rebuild", path).replace(
        "a.organ: history.lines[3]", "a.organ: [3]"
    ).replace("a.organ: history.lines[0].surface: got []", "a.organ: lines[0].surface: got []")


def test_an_original_that_was_changed_gives_another_organ_and_the_place_is_told(
    kept, tmp_path, capsys
):
    path = tmp_path / "a.organ"
    shutil.copy(kept, path)

    def move(content, arrays):
        del content
        arrays["imported/vertices"] = arrays["imported/vertices"] * 1.01

    damage(path, move)

    assert "a.organ: surface/vertices: got row 0" in refuse(capsys, "rebuild", path)


def test_an_array_of_the_history_that_no_line_has_is_refused(kept, tmp_path, capsys):
    path = tmp_path / "a.organ"
    shutil.copy(kept, path)
    damage(path, lambda content, arrays: arrays.update({"history/9": np.zeros((2, 3))}))

    assert "history/9: got an unknown array" in refuse(capsys, "rebuild", path)


def test_a_file_without_a_history_says_so(tmp_path, capsys):
    write_organ(tmp_path / "a.organ", make_organ())

    said = refuse(capsys, "rebuild", tmp_path / "a.organ")

    assert "history: got no line" in said and "before its steps were kept" in said


# ---------------------------------------------------------------- what is kept of it


def test_the_original_is_kept_once_where_it_is_still_in_use(kept):
    found = read_container(str(kept), "organ", VERSION)

    assert not {name for name in found.arrays if name.startswith("history/")} - {
        "history/integers",
        "history/numbers",
    }
    organ = read_organ(kept)
    (line, *_) = organ.history.lines
    assert line.values["surface"].vertices is organ.imported.vertices
