# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a file: how they lie to each other, and the one surface that is made of them."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate_editor.authoring import import_mesh, read_mesh, unite_shells
from palpate_editor.check import assess
from palpate_editor.document import EMPTY, Assembly
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import EditError, decimate_organ, import_file
from palpate_editor.edits.import_mesh import Assembling
from palpate_editor.edits.part_list import find_outermost, list_parts, sort_rows
from palpate_editor.edits.unite import UniteShells, can_be_united
from palpate_editor.repair_all import repair_problems
from palpate_editor.views.command_lines import find_arguments
from scipy.spatial import ConvexHull
from small_meshes import CORNERS, CUBE, mesh_of, together

Parts = dict[str, tuple[np.ndarray, np.ndarray]]


def ball(radius: float, centre: tuple[float, float, float] = (0.0, 0.0, 0.0), vertices: int = 300):
    """[mm] A sphere: the hull of points on a spiral from pole to pole."""
    x, triangles = unit_ball(vertices)
    return radius * x + np.array(centre), triangles


@cache
def unit_ball(vertices: int) -> tuple[np.ndarray, np.ndarray]:
    k = np.arange(vertices) + 0.5
    height, angle = 1.0 - 2.0 * k / vertices, np.pi * (1.0 + np.sqrt(5.0)) * k
    across = np.sqrt(1.0 - height**2)
    x = np.column_stack([across * np.cos(angle), across * np.sin(angle), height])
    triangles = ConvexHull(x).simplices.copy()
    inward = np.linalg.det(x[triangles]) < 0.0
    triangles[inward] = triangles[inward][:, ::-1]
    return x, triangles


def box(low: tuple[float, float, float], size: float = 10.0):
    """[mm] A cube."""
    return 100.0 * size * CORNERS + np.array(low), CUBE


def write_parts(path: Path, parts: Parts) -> Path:
    """An OBJ in millimetres with an object for each."""
    lines, first = [], 1
    for name, (x, triangles) in parts.items():
        lines.append(f"o {name}")
        lines += [f"v {p[0]!r} {p[1]!r} {p[2]!r}" for p in x.tolist()]
        lines += [f"f {a} {b} {c}" for a, b, c in (triangles + first).tolist()]
        first += len(x)
    path.write_text("\n".join(lines) + "\n")
    return path


def read_parts(tmp_path: Path, parts: Parts):
    path = write_parts(tmp_path / "parts.obj", parts)
    return path, {part.name: part for part in list_parts(read_mesh(path), "mm", "z")}


def volume_of(path: Path, **options: object) -> float:
    """[ml] of what becomes one solid, which is clean."""
    report = import_mesh(path, unit="mm", up="z", **options).report
    assert (report.closed, report.outward) == (True, True)
    assert (report.non_manifold_edges, report.self_intersecting_faces) == (0, 0)
    return report.volume_ml


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


# ---------------------------------------------------------------- solids


@pytest.mark.parametrize("seed", range(6))
def test_the_union_and_what_is_left_add_up_to_rounding(seed, tmp_path):
    random = np.random.default_rng(seed)
    direction = random.normal(size=3)
    direction /= np.linalg.norm(direction)
    left, right = ball(20.0), ball(random.uniform(8.0, 18.0), tuple(17.0 * direction))
    path = write_parts(tmp_path / "two.obj", {"left": left, "right": right})

    alone = [volume_of(path, parts=[name]) for name in ("left", "right")]
    united = volume_of(path, unite=True)
    less = volume_of(path, subtract=["right"])

    # |A u B| = |A - B| + |B|, whatever the shapes
    assert united == pytest.approx(less + alone[1], rel=1e-9)
    assert max(alone) < united < sum(alone)
    assert less < alone[0]


def test_cubes_are_united_and_subtracted_to_the_volume_by_hand(tmp_path):
    path = write_parts(tmp_path / "a.obj", {"one": box((0, 0, 0)), "two": box((5.0, 5.0, 5.0))})

    assert volume_of(path, unite=True) == pytest.approx(1.0 + 1.0 - 0.125)
    assert volume_of(path, subtract=["two"]) == pytest.approx(1.0 - 0.125)


def test_cubes_that_share_a_face_become_one_box(tmp_path):
    path = write_parts(tmp_path / "a.obj", {"one": box((0, 0, 0)), "two": box((10.0, 0, 0))})

    organ = import_mesh(path, unit="mm", unite=True)

    assert organ.report.volume_ml == pytest.approx(2.0)
    assert (organ.report.shells, organ.report.genus) == (1, 0)


def test_a_part_inside_goes_and_one_that_is_taken_away_leaves_a_cavity(tmp_path):
    path = write_parts(tmp_path / "a.obj", {"outer": ball(20.0), "inner": ball(10.0)})
    outer, inner = (volume_of(path, parts=[name]) for name in ("outer", "inner"))

    assert volume_of(path, unite=True) == pytest.approx(outer)
    organ = import_mesh(path, unit="mm", subtract=["inner"])
    assert palpate.compute_volume(organ.mesh) * 1e6 == pytest.approx(outer - inner)
    assert organ.report.shells == 2
    assert list(organ.joined.parts) == ["outer"]
    assert list(organ.joined.subtracted) == ["inner"]


def test_parts_that_are_apart_stay_apart(tmp_path):
    path = write_parts(tmp_path / "a.obj", {"one": ball(10.0), "two": ball(10.0, (50.0, 0, 0))})

    organ = import_mesh(path, unit="mm", unite=True)

    assert organ.report.shells == 2
    assert len(organ.mesh.vertices) == 600


REFUSED = {
    "an open part": ({"whole": ball(20.0), "bowl": (ball(9.0)[0], ball(9.0)[1][20:])},
                     {"unite": True}, "part 'bowl'", "hole"),
    "nothing left": ({"small": ball(5.0), "large": ball(20.0)}, {"subtract": ["large"]}, "",
                     "nothing that is left"),
    "all taken away": ({"one": ball(5.0)}, {"subtract": ["one"]}, "", "all taken away"),
    "an unknown part": ({"one": ball(5.0)}, {"subtract": ["two"]}, "part 'two'", "no such part"),
    "an edge": ({"one": box((0, 0, 0)), "two": box((10.0, 10.0, 0.0))}, {"unite": True}, "",
                "touch along an edge"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_united_is_refused_in_a_sentence(name, tmp_path):
    parts, options, where, got = REFUSED[name]
    path = write_parts(tmp_path / "a.obj", parts)

    with pytest.raises(palpate.FileError) as refusal:
        import_mesh(path, unit="mm", **options)

    assert where in refusal.value.where and got in refusal.value.got
    assert refusal.value.expected


def test_pieces_of_one_surface_are_united_as_an_edit():
    x, triangles = (np.asarray(a) for a in ball(0.02))
    y, more = ball(0.015, (0.018, 0.0, 0.0))
    both = together(mesh_of(x, triangles), mesh_of(y, more))
    organ = EMPTY.with_surface(palpate_surface(both))
    assert can_be_united(organ.surface)

    united = UniteShells()(organ)

    mesh = palpate.SurfaceMesh(united.surface.vertices, united.surface.triangles)
    assert palpate.is_closed(united.surface.triangles)
    separate = [palpate.compute_volume(mesh_of(*piece)) for piece in ((x, triangles), (y, more))]
    assert max(separate) < palpate.compute_volume(mesh) < sum(separate)
    assert united.imported is united.surface
    with pytest.raises(EditError, match="one piece"):
        UniteShells()(united)


def palpate_surface(mesh: palpate.SurfaceMesh):
    from palpate_editor.compile import surface_of

    return surface_of(mesh)


def test_an_open_piece_cannot_be_united():
    x, triangles = ball(0.02)
    both = together(mesh_of(x, triangles[10:]), mesh_of(*ball(0.015, (0.018, 0.0, 0.0))))

    assert not can_be_united(palpate_surface(both))
    with pytest.raises(ValueError, match="hole"):
        unite_shells(both)


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
