# SPDX-License-Identifier: GPL-3.0-or-later
"""What the doctor says of a surface: each fault counted, placed and named with what repairs it."""

from __future__ import annotations

import json

import numpy as np
import palpate
import pytest
from foreign_files import write_obj
from palpate.cli.main import main
from palpate_editor.authoring import inspect_mesh
from palpate_editor.compile import build_organ, surface_of
from palpate_editor.doctor import find_stable_step, list_repaired, list_surface_problems
from palpate_editor.document import EMPTY
from palpate_meshes.generate import ellipsoid, tube
from small_meshes import CORNERS, CUBE, mesh_of, scaled, together

SAID = (
    *("Euler number", "1 hole of 3 edges", "mm around", "angles", "edges", "thinnest"),
    *("stable step", "there twice", "face different sides", "importing it repairs"),
)


def organ_of(mesh: palpate.SurfaceMesh):
    return EMPTY.with_surface(surface_of(mesh))


def slab(thickness: float, sides: int = 10) -> palpate.SurfaceMesh:
    """A square of 60 mm of so many sides in each direction, `thickness` [m] thick."""
    at = np.arange((sides + 1) ** 2).reshape(sides + 1, -1)
    a, b, c, d = at[:-1, :-1].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel(), at[:-1, 1:].ravel()
    top = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    xy = np.stack(np.meshgrid(*[np.linspace(0, 0.06, sides + 1)] * 2, indexing="ij"), -1)
    flat = np.concatenate([xy.reshape(-1, 2), xy.reshape(-1, 2)])
    z = np.repeat([thickness, 0.0], at.size)
    rim = np.concatenate([at[:, 0], at[-1, 1:], at[-2::-1, -1], at[0, -2:0:-1]])
    after, low = np.roll(rim, -1), rim + at.size
    side = np.concatenate(
        [np.column_stack([rim, low, after]), np.column_stack([after, low, np.roll(low, -1)])]
    )
    return mesh_of(np.column_stack([flat, z]), np.concatenate([top, top[:, ::-1] + at.size, side]))


def test_a_border_is_as_long_as_a_tape_says():
    x, triangles = tube(200)
    mesh = mesh_of(x, triangles)
    [loop] = palpate.find_border_loops(mesh.triangles)

    report = inspect_mesh(mesh)

    tape = np.linalg.norm(x[loop] - x[np.roll(loop, 1)], axis=1).sum()
    assert report.border_lengths_mm == [pytest.approx(1e3 * tape)]
    assert report.euler_number == 1


def test_lengths_stand_beside_their_borders():
    small, large = mesh_of(*tube(100)), scaled(mesh_of(*tube(400)), 2.0)

    report = inspect_mesh(together(small, large))

    both = [inspect_mesh(one) for one in (large, small)]
    wanted = sorted(((r.border_loops[0], r.border_lengths_mm[0]) for r in both), reverse=True)
    found = zip(report.border_loops, report.border_lengths_mm, strict=True)
    assert list(found) == [(n, pytest.approx(length)) for n, length in wanted]


def test_cubes_that_touch_in_a_corner_have_one_pinched_vertex():
    other = np.asarray(CUBE) + 8
    corners = np.concatenate([CORNERS, CORNERS + 0.010])
    other[other == 8] = 7
    mesh = mesh_of(corners, np.concatenate([CUBE, other]))

    report = inspect_mesh(mesh)

    assert report.pinched_vertices == [7]
    assert report.non_manifold_edges == 0 and report.genus is None


def test_cubes_that_share_an_edge_are_told_by_the_edge_and_not_by_its_ends():
    other = np.array(CUBE) + 8
    corners = np.concatenate([CORNERS, CORNERS + [0.010, 0.010, 0.0]])
    other[other == 8], other[other == 12] = 3, 7
    report = inspect_mesh(mesh_of(corners, np.concatenate([CUBE, other])))

    assert (report.non_manifold_edges, report.pinched_vertices) == (1, [])


def test_every_fault_of_a_list_of_triangles_is_counted_and_placed():
    x = np.concatenate([CORNERS, [CORNERS[0], [0.005, 0.0, 0.0]]])
    flat = [[0, 9, 1]]
    triangles = np.concatenate([CUBE, [CUBE[3][[1, 2, 0]]], flat])
    triangles[5] = triangles[5][::-1]

    report = inspect_mesh(mesh_of(x, triangles))

    assert report.duplicate_faces == [12]
    assert report.degenerate_faces == [13]
    assert report.coincident_vertices == 1
    assert report.disagreeing_edges >= 2
    repaired = {p.key: p for p in list_repaired(surface_of(mesh_of(x, triangles)), report)}
    assert {"duplicates", "flat", "winding"} <= set(repaired)
    assert list(repaired["flat"].faces) == [13]
    assert 5 in repaired["winding"].faces


@pytest.mark.parametrize("thickness", [1e-3, 4e-3, 20e-3])
def test_a_slab_is_as_thin_as_it_was_made(thickness):
    report = inspect_mesh(slab(thickness))

    assert report.thinnest_mm == pytest.approx(1e3 * thickness, rel=1e-3)
    # its squares have sides of 6 mm: half of the mean edge is 3.4 mm
    thin = len(report.thin_faces) / report.thickness_looks
    assert thin > 0.5 if thickness < 3e-3 else thin < 0.1


def test_a_thin_solid_is_told_with_its_place_and_a_thick_one_or_a_wall_is_not():
    problems = {p.key: p for p in list_surface_problems(organ_of(slab(1e-3)))}

    assert problems["thin"].severity == "note" and len(problems["thin"].faces)
    assert "1 mm" in str(problems["thin"].got)
    assert "thin" not in [p.key for p in list_surface_problems(organ_of(slab(20e-3)))]


def test_an_open_surface_is_no_error_and_its_border_has_a_place():
    problems = {p.key: p for p in list_surface_problems(organ_of(mesh_of(*tube(200))))}

    assert problems["holes"].severity == "note"
    assert len(problems["holes"].faces)
    assert not [p for p in problems.values() if p.severity == "error"]


def test_the_stable_step_is_that_of_the_tissue_a_new_organ_gets():
    organ = organ_of(mesh_of(*ellipsoid(300)))

    found = find_stable_step(organ)

    assert found.step == palpate.stable_step(build_organ(organ))
    assert found.substeps == int(np.ceil(1e-3 / found.step))
    assert find_stable_step(organ_of(mesh_of(*tube(200)))).wall is not None


def test_no_step_is_given_where_no_tissue_can_be_built():
    fin = mesh_of(
        [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1], [0, 0, -0.1]],
        [[0, 1, 2], [1, 0, 3], [0, 1, 4]],
    )

    assert "repaired" in find_stable_step(organ_of(fin)).refusal


def test_inspect_says_all_of_it_in_words_and_as_json(tmp_path, capsys):
    x, triangles = ellipsoid(300)
    broken = np.concatenate([triangles[1:], triangles[5:6]])
    broken[7] = broken[7][::-1]
    write_obj(tmp_path / "spleen.obj", 1e3 * x, broken)

    assert main(["inspect", str(tmp_path / "spleen.obj")]) == 0
    said = capsys.readouterr().out
    assert main(["inspect", str(tmp_path / "spleen.obj"), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)

    for words in SAID:
        assert words in said, words
    assert {p["problem"] for p in report["repaired_at_import"]} == {"duplicates", "winding"}
    assert all(p["place_m"] for p in report["repaired_at_import"])
    assert report["stable_step"]["substeps"] >= 1
    assert "holes" in [p["problem"] for p in report["problems"]]


def test_a_working_file_is_inspected_with_the_tissue_it_has(tmp_path, capsys):
    write_obj(tmp_path / "spleen.obj", 1e3 * ellipsoid(300)[0], ellipsoid(300)[1])
    work, stiff = tmp_path / "spleen.organ", tmp_path / "stiff.organ"
    assert main(["import", str(tmp_path / "spleen.obj"), "-o", str(work)]) == 0
    assert main(["material", str(work), "--stiffness", "3000N/m", "-o", str(stiff)]) == 0
    capsys.readouterr()

    steps = []
    for path in (work, stiff):
        assert main(["inspect", str(path), "--json"]) == 0
        steps.append(json.loads(capsys.readouterr().out)["stable_step"]["step"])

    assert steps[1] < 0.5 * steps[0]
