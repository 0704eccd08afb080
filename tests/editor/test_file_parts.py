# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a file: how they lie to each other, and the one surface that is made of them."""

from __future__ import annotations

import json

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate_editor.authoring import import_mesh
from palpate_editor.check import assess
from palpate_editor.document import EMPTY, Assembly
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import decimate_organ, import_file
from palpate_editor.edits.import_mesh import Assembling
from palpate_editor.edits.part_list import find_outermost, sort_rows
from palpate_editor.edits.unite import UniteShells
from palpate_editor.repair_all import repair_problems
from palpate_editor.views.command_lines import find_arguments
from part_files import Parts, ball, box, read_parts, write_parts

# ---------------------------------------------------------------- how they lie


def test_a_part_lies_inside_the_smallest_that_holds_it(tmp_path):
    balls = {
        "seed": ball(2.0),
        "skin": ball(40.0),
        "flesh": ball(20.0),
        "beside": ball(5.0, (80.0, 0.0, 0.0)),
    }
    _, parts = read_parts(tmp_path, balls)

    inside = {name: part.inside for name, part in parts.items()}
    assert inside == {"seed": "flesh", "skin": None, "flesh": "skin", "beside": None}
    assert find_outermost(tuple(parts.values())) == ("skin", "beside")
    rows = [(part.name, depth) for part, depth in sort_rows(tuple(parts.values()))]
    assert rows == [("skin", 0), ("flesh", 1), ("seed", 2), ("beside", 0)]
    assert not any(part.crosses for part in parts.values())


@pytest.mark.parametrize("turned", [False, True])
def test_nesting_does_not_depend_on_which_way_triangles_face(turned, tmp_path):
    x, triangles = ball(40.0)
    outer = (x, triangles[:, ::-1] if turned else triangles)
    _, parts = read_parts(tmp_path, {"outer": outer, "inner": ball(20.0)})

    assert parts["inner"].inside == "outer"
    assert parts["outer"].volume == pytest.approx(4 / 3 * np.pi * 0.04**3, rel=0.05)


def test_a_part_in_an_open_bowl_is_inside_and_one_before_it_is_not(tmp_path):
    x, triangles = ball(40.0, vertices=600)
    bowl = x, triangles[x[triangles].mean(axis=1)[:, 2] < 30.0]
    _, parts = read_parts(
        tmp_path, {"bowl": bowl, "deep": ball(8.0, (0.0, 0.0, -10.0)), "far": ball(8.0, (0, 0, 90))}
    )

    assert parts["deep"].inside == "bowl"
    assert parts["far"].inside is None
    assert not parts["bowl"].closed and parts["bowl"].volume is None


def test_parts_that_cross_are_told_from_those_that_touch_and_those_that_cross_themselves(tmp_path):
    x, triangles = ball(10.0)
    y, more = ball(10.0, (8.0, 0.0, 0.0))
    knot = np.concatenate([x, y]) + [60.0, 0.0, 0.0], np.concatenate([triangles, more + len(x)])
    _, parts = read_parts(
        tmp_path,
        {
            "left": ball(10.0),
            "right": ball(10.0, (15.0, 0.0, 0.0)),
            "cube": box((-40.0, 0.0, 0.0)),
            "wall": box((-30.0, 0.0, 0.0)),
            "knot": knot,
        },
    )

    crosses = {name: part.crosses for name, part in parts.items()}
    assert crosses["left"] == ("right",) and crosses["right"] == ("left",)
    assert crosses["knot"] == ()
    assert parts["knot"].crossing_faces > 0
    assert parts["left"].crossing_faces == 0


# ---------------------------------------------------------------- welding across


def halves(gap: float, vertices: int = 400) -> Parts:
    """A ball in two halves whose rims are `gap` [mm] apart."""
    x, triangles = ball(20.0, vertices=vertices)
    upper = x[triangles].mean(axis=1)[:, 2] > 0.0
    return {"upper": (x + [0.0, 0.0, gap], triangles[upper]), "lower": (x, triangles[~upper])}


def test_a_gap_is_welded_within_the_stated_tolerance_and_not_beyond(tmp_path):
    path = write_parts(tmp_path / "a.obj", halves(0.05))

    apart = import_mesh(path, unit="mm")
    welded = import_mesh(path, unit="mm", weld=0.1e-3)
    short = import_mesh(path, unit="mm", weld=0.04e-3)

    assert len(apart.report.border_loops) == 2 and apart.joined.welded_across == 0
    assert welded.report.closed and welded.report.shells == 1
    assert welded.joined.welded_across > 10
    assert welded.joined.largest_move == pytest.approx(0.05e-3, rel=1e-6)
    assert len(short.report.border_loops) == 2 and short.joined.welded_across == 0


def test_detail_within_a_part_stays_whatever_the_tolerance(tmp_path):
    fine = halves(0.05, vertices=2000)
    path = write_parts(tmp_path / "a.obj", fine)
    loose = import_mesh(path, unit="mm", weld=2e-3)  # edges are 1.5 mm long

    separate = [len(import_mesh(path, unit="mm", parts=[name]).mesh.vertices) for name in fine]
    # of two rims one goes; nothing else that is within 2 mm of its neighbours
    assert len(loose.mesh.vertices) >= sum(separate) - 2 * loose.joined.welded_across
    assert len(loose.mesh.vertices) > 0.85 * sum(separate)


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"weld": -1e-3}, "not negative"),
        ({"weld": float("nan")}, "not negative"),
        ({"weld": 1e-3, "unite": True}, "no effect"),
        ({"weld": 1e-3, "subtract": ["upper"]}, "no effect"),
    ],
)
def test_a_tolerance_that_is_none_is_refused(options, sentence, tmp_path):
    path = write_parts(tmp_path / "a.obj", halves(0.05))

    with pytest.raises(ValueError, match=sentence):
        import_mesh(path, unit="mm", **options)


def test_a_tolerance_counts_in_the_unit_that_is_guessed_by_name(tmp_path):
    parts = {name: (0.5 * x, t) for name, (x, t) in halves(0.05).items()}
    path = write_parts(tmp_path / "prostate.obj", parts)  # 35 units across: guessed as centimetres

    read = import_file(path, assembling=Assembling(weld=0.1e-3))

    assert (read.source.unit, read.source.unit_guessed) == ("mm", True)
    assert palpate.is_closed(read.surface.triangles)


# ---------------------------------------------------------------- regions


def test_each_part_is_a_region_and_every_vertex_is_of_one(tmp_path):
    path = write_parts(tmp_path / "a.obj", halves(0.0))

    organ = import_file(path, unit="mm", assembling=Assembling(regions=True))(EMPTY)

    assert set(organ.regions) == {"upper", "lower"}
    ids = np.concatenate(list(organ.regions.values()))
    assert np.array_equal(np.sort(ids), np.arange(organ.vertex_count))
    z = organ.surface.vertices[:, 2]
    assert z[organ.regions["lower"]].max() < z[organ.regions["upper"]].max()
    assert z[organ.regions["upper"]].min() > -2e-3


def test_regions_of_united_parts_are_where_the_parts_were(tmp_path):
    path = write_parts(
        tmp_path / "a.obj", {"left": ball(20.0), "right": ball(15.0, (20.0, 0.0, 0.0))}
    )

    organ = import_file(path, unit="mm", assembling=Assembling(unite=True, regions=True))(EMPTY)

    x = organ.surface.vertices
    from_left = np.abs(np.linalg.norm(x, axis=1) - 0.02)
    from_right = np.abs(np.linalg.norm(x - [0.02, 0.0, 0.0], axis=1) - 0.015)
    sag = 1e-3  # of triangles between points of a sphere
    assert from_left[organ.regions["left"]].max() < sag
    assert from_right[organ.regions["right"]].max() < sag
    assert sum(map(len, organ.regions.values())) == organ.vertex_count


def test_regions_of_parts_are_carried_to_a_coarser_surface_and_through_the_file(tmp_path):
    path = write_parts(tmp_path / "a.obj", halves(0.0, vertices=800))
    organ = import_file(path, unit="mm", assembling=Assembling(regions=True))(EMPTY)
    coarse = decimate_organ(organ, 200)(organ)

    write_organ(tmp_path / "a.organ", coarse)
    again = read_organ(tmp_path / "a.organ")

    assert again.assembly == Assembly(None, False, (), True)
    covered = np.unique(np.concatenate(list(again.regions.values())))
    assert set(again.regions) == {"upper", "lower"}
    assert len(covered) > 0.9 * again.vertex_count
    height = again.surface.vertices[:, 2]
    assert np.mean(height[again.regions["upper"]]) > 5e-3
    assert np.mean(height[again.regions["lower"]]) < -5e-3


def test_more_parts_than_there_can_be_regions_are_refused(tmp_path):
    parts = {f"p{i}": ball(1.0, (3.0 * i, 0.0, 0.0), vertices=14) for i in range(201)}
    path = write_parts(tmp_path / "a.obj", parts)

    with pytest.raises(ValueError, match="201 parts, expected at most 200"):
        import_file(path, unit="mm", assembling=Assembling(regions=True))


# ---------------------------------------------------------------- the command line


def test_inspect_lists_parts_with_size_and_nesting(tmp_path, capsys):
    path = write_parts(
        tmp_path / "a.obj",
        {"skin": ball(40.0), "flesh": ball(20.0), "stone": ball(30.0, (50.0, 0.0, 0.0))},
    )

    assert main(["inspect", str(path), "--unit", "mm", "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert main(["inspect", str(path), "--unit", "mm"]) == 0
    said = capsys.readouterr().out

    rows = {part["name"]: part for part in report["parts"]}
    assert (rows["flesh"]["inside"], rows["flesh"]["depth"]) == ("skin", 1)
    assert rows["skin"]["crosses"] == ["stone"]
    assert rows["skin"]["volume_ml"] == pytest.approx(4 / 3 * np.pi * 4.0**3, rel=0.05)
    assert "    flesh: " in said and "inside skin" in said and "crosses stone" in said


def test_import_unites_subtracts_welds_and_keeps_regions(tmp_path, capsys):
    path = write_parts(
        tmp_path / "a.obj", {"left": ball(20.0), "right": ball(15.0, (20.0, 0.0, 0.0))}
    )
    out = tmp_path / "a.organ"

    words = ["import", str(path), "--unit", "mm", "--subtract", "right", "--region-per-part"]
    assert main([*words, "-o", str(out)]) == 0
    assert "united, without right" in capsys.readouterr().out
    organ = read_organ(out)
    assert organ.assembly == Assembly(None, False, ("right",), True)
    assert organ.source.parts == ("left",)
    assert list(organ.regions) == ["left"]

    assert main(["import", str(path), "--unite", "--weld", "1mm", "-o", str(out)]) == 2
    assert "--weld has no effect" in capsys.readouterr().err


def test_an_organ_of_united_parts_with_regions_is_rebuilt_from_its_file(tmp_path, capsys):
    path = write_parts(
        tmp_path / "a.obj", {"left": ball(20.0), "right": ball(15.0, (20.0, 0.0, 0.0))}
    )
    out, again = tmp_path / "a.organ", tmp_path / "b.organ"
    words = ["import", str(path), "--unit", "mm", "--unite", "--region-per-part", "-o", str(out)]
    assert main(words) == 0

    assert main(["rebuild", str(out), "--original", str(path), "-o", str(again)]) == 0

    assert again.read_bytes() == out.read_bytes()


def test_parts_that_cross_open_are_red_and_can_be_united(tmp_path):
    path = write_parts(
        tmp_path / "liver.obj", {"left": ball(60.0), "right": ball(60.0, (50.0, 0.0, 0.0))}
    )
    organ = import_file(path, unit="mm", up="z")(EMPTY)

    assessment = assess(organ)
    crossing = next(p for p in assessment.problems if p.key == "crossing")
    assert crossing.severity == "error" and len(crossing.faces) > 20
    assert "unite them" in crossing.expected
    assert crossing.fix is not None

    whole = UniteShells()(organ)
    keys = {p.key for p in assess(whole).problems if p.severity == "error"}
    assert "crossing" not in keys and "non_manifold" not in keys
    line = find_arguments(UniteShells(), whole, "liver.organ")
    assert line[:4] == ["palpate", "repair", "liver.organ", "--problem"]


def test_pieces_whose_largest_crosses_itself_cannot_be_told_apart_by_keeping_one(tmp_path):
    parts = {f"p{i}": ball(20.0, (25.0 * i, 0.0, 0.0), vertices=120) for i in range(3)}
    # one piece that nearly all of the others lie in keeps none of them from being united
    path = write_parts(tmp_path / "spleen.obj", parts)
    organ = import_file(path, unit="mm", up="z")(EMPTY)

    repaired, done = repair_problems(organ, ["self_intersections", "crossing", "shells"])

    assert done and not {"crossing", "self_intersections"} & {p.key for p in repaired.problems}


def test_the_outer_parts_alone_are_imported_where_some_lie_inside_others(tmp_path, capsys):
    path = write_parts(
        tmp_path / "a.obj",
        {"skin": ball(40.0), "flesh": ball(20.0), "beside": ball(10.0, (90.0, 0.0, 0.0))},
    )
    out = tmp_path / "a.organ"
    words = ["import", str(path), "--unit", "mm", "-o", str(out), "--outer"]

    assert main(words) == 0
    assert read_organ(out).source.parts == ("skin", "beside")

    assert main([*words, "--part", "skin"]) == 2
    assert "both say which parts" in capsys.readouterr().err
    write_parts(path, {"skin": ball(40.0), "beside": ball(10.0, (90.0, 0.0, 0.0))})
    assert main(words) == 2
    assert "no part of the file lies inside another" in capsys.readouterr().err
