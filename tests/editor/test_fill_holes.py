# SPDX-License-Identifier: GPL-3.0-or-later
"""Holes are closed with patches that go on as the surface does, and never through it."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import palpate
import pytest
from organs import make_organ, surface_of
from palpate.cli.main import main
from palpate_editor import authoring
from palpate_editor.document import Organ, Surface
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import EditError, FillHoles
from palpate_editor.verbs.files import describe_loops


def ball(vertices: int = 600) -> Surface:
    return surface_of(vertices)


def cut(surface: Surface, *places: tuple[int, float]) -> Surface:
    """Without the triangles near vertices: (vertex, radius in parts of the diagonal)."""
    x, triangles = surface.vertices, surface.triangles
    diagonal = palpate.compute_diagonal(x)
    gone = np.zeros(len(x), bool)
    for vertex, share in places:
        gone |= np.linalg.norm(x - x[vertex], axis=1) < share * diagonal
    kept = triangles[~gone[triangles].any(axis=1)]
    used = np.unique(kept)
    number = np.full(len(x), -1, np.int32)
    number[used] = np.arange(len(used), dtype=np.int32)
    return Surface(x[used], number[kept])


def organ_of(surface: Surface) -> Organ:
    return replace(
        make_organ(imported=None).with_surface(surface), imported=surface, decimation=None
    )


def ends(surface: Surface) -> tuple[int, int]:
    """The vertices at the two ends of the longest axis."""
    along = np.ptp(surface.vertices, axis=0).argmax()
    return int(surface.vertices[:, along].argmax()), int(surface.vertices[:, along].argmin())


def report_of(surface: Surface) -> authoring.MeshReport:
    return authoring.inspect_mesh(palpate.SurfaceMesh(surface.vertices, surface.triangles))


def test_a_patch_goes_on_as_the_surface_does():
    whole = ball()
    open_one = cut(whole, (ends(whole)[0], 0.1))
    assert len(report_of(open_one).border_loops) == 1

    closed = FillHoles()(organ_of(open_one)).surface

    found, wanted = report_of(closed), report_of(whole)
    assert found.closed and found.outward and found.genus == 0
    assert found.self_intersecting_faces == 0
    assert found.volume_ml == pytest.approx(wanted.volume_ml, rel=0.01)
    assert found.smallest_angle_deg > 15.0
    n, t = len(open_one.vertices), len(open_one.triangles)
    assert (closed.vertices[:n] == open_one.vertices).all()
    assert (closed.triangles[:t] == open_one.triangles).all()


def test_what_is_painted_goes_on_over_the_patch():
    surface = cut(ball(), (ends(ball())[0], 0.1))
    n = len(surface.vertices)
    organ = replace(
        organ_of(surface),
        fixed=np.arange(n) < 7,
        stiffness_scale=np.full(n, 2.5),
        regions={"pole": np.array([3, 5])},
    )

    closed = FillHoles()(organ)

    assert closed.fixed.sum() == 7 and closed.fixed[:7].all()
    assert closed.stiffness_scale == pytest.approx(2.5)
    assert closed.regions["pole"].tolist() == [3, 5]
    assert closed.imported is closed.surface


def test_one_hole_of_two_can_be_chosen():
    first, second = ends(ball())
    surface = cut(ball(), (first, 0.1), (second, 0.05))
    loops = palpate.find_border_loops(surface.triangles)
    small = min(range(2), key=lambda hole: len(loops[hole]))

    closed = FillHoles((small,))(organ_of(surface)).surface

    left = report_of(closed).border_loops
    assert left == [len(loops[1 - small])]


def test_the_imported_surface_of_a_decimated_organ_is_closed_with_it():
    first, second = ends(ball(600))
    fine = cut(ball(600), (first, 0.12), (second, 0.06))
    coarse = cut(ball(300), (ends(ball(300))[0], 0.12), (ends(ball(300))[1], 0.06))
    organ = replace(
        make_organ().with_surface(coarse), imported=fine, decimation=make_organ().decimation
    )
    loops = palpate.find_border_loops(coarse.triangles)
    large = max(range(2), key=lambda hole: len(loops[hole]))

    closed = FillHoles((large,))(organ)

    assert len(report_of(closed.surface).border_loops) == 1
    assert len(report_of(closed.imported).border_loops) == 1
    before = max(report_of(fine).border_loops)
    assert max(report_of(closed.imported).border_loops) < before, "the large one is closed"
    assert closed.decimation.vertices == len(closed.surface.vertices)


def test_a_patch_that_would_cross_the_surface_is_not_made():
    """A small ball floats in the opening."""
    bowl = cut(ball(), (ends(ball())[0], 0.1))
    middle = bowl.vertices[palpate.find_border_loops(bowl.triangles)[0]].mean(axis=0)
    ball_in_the_way = ball(60)
    x = ball_in_the_way.vertices
    small = 0.08 * (x - x.mean(axis=0)) + middle
    surface = Surface(
        np.concatenate((bowl.vertices, small)),
        np.concatenate((bowl.triangles, ball_in_the_way.triangles + len(bowl.vertices))),
    )

    found = authoring.fill_holes(palpate.SurfaceMesh(surface.vertices, surface.triangles), [0])

    assert (found.filled, found.left_open) == (0, [0])
    assert len(found.mesh.triangles) == len(surface.triangles)
    with pytest.raises(EditError, match="a hole touches another one"):
        FillHoles()(organ_of(surface))


def test_holes_that_touch_each_other_stay_open():
    surface = ball(60)
    corner = 10
    around = np.flatnonzero((surface.triangles == corner).any(axis=1))
    kept = np.delete(surface.triangles, [around[0], around[-1]], axis=0)
    loops = palpate.find_border_loops(kept)
    mesh = palpate.SurfaceMesh(surface.vertices, kept)

    found = authoring.fill_holes(mesh, list(range(len(loops))))

    touching = sum(corner in loop for loop in loops) > 1
    assert found.filled == (0 if touching else len(loops))


def test_the_same_surface_is_closed_to_the_same_bits():
    surface = cut(ball(), (ends(ball())[0], 0.1))

    one, other = (FillHoles()(organ_of(surface)).surface for _ in range(2))

    assert one.vertices.tobytes() == other.vertices.tobytes()
    assert one.triangles.tobytes() == other.triangles.tobytes()


@pytest.mark.parametrize(
    ("holes", "said"),
    [((5,), "Hole: got 5, expected 0 to 0"), ((-1,), "Hole: got -1"), ((), "no hole to fill")],
)
def test_holes_that_are_not_there_are_refused(holes, said):
    surface = cut(ball(), (ends(ball())[0], 0.1))
    with pytest.raises(EditError, match=said):
        FillHoles(holes)(organ_of(surface))


def test_a_closed_surface_has_nothing_to_fill():
    with pytest.raises(EditError, match="no hole to fill"):
        FillHoles()(organ_of(ball()))


def test_the_verb_closes_holes_up_to_a_size(tmp_path, capsys):
    first, second = ends(ball())
    surface = cut(ball(), (first, 0.1), (second, 0.05))
    sizes = report_of(surface).border_loops
    path, out = tmp_path / "a.organ", tmp_path / "b.organ"
    write_organ(path, organ_of(surface))

    assert main(["repair", str(path), "--fill-holes", str(sizes[1]), "-o", str(out), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["done"] == ["Fill holes"]
    assert report_of(read_organ(out).surface).border_loops == [sizes[0]]

    assert main(["repair", str(out), "--fill-holes", "-o", str(out)]) == 0
    assert report_of(read_organ(out).surface).closed
    assert main(["repair", str(out), "--fill-holes", "-o", str(out)]) == 1
    assert "a closed surface" in capsys.readouterr().err


def test_many_holes_are_told_by_their_sizes_and_not_one_by_one():
    assert describe_loops([]) == "no hole"
    assert describe_loops([16]) == "1 hole of 16 edges"
    assert describe_loops([3] * 200 + [48] + [7] * 2) == "1 hole of 48 edges, 2 of 7, 200 of 3"
