# SPDX-License-Identifier: GPL-3.0-or-later
"""Each step of repair alone: what it keeps, what it changes, what it refuses, how it is ended."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import palpate
import pytest
from damaged_shapes import damage, make_sphere, make_spleen
from organs import surface_of
from palpate.cli.main import main
from palpate_editor.authoring import (
    find_self_intersecting_faces,
    inspect_mesh,
    measure_distance,
    measure_seen_distance,
    remesh_surface,
    remove_crossings,
    smooth_surface,
    stitch_borders,
    wrap_surface,
)
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_editor.document.files import write_organ
from palpate_editor.edits import (
    DropPieces,
    EditError,
    Remesh,
    RemoveCrossings,
    Smooth,
    StitchBorders,
    Wrap,
)
from palpate_editor.edits.inspected import mesh_of
from palpate_editor.edits.wrap import PAST_HOLES, measure_small_holes
from palpate_editor.guarded import Cancelled, GuardedError, run_guarded, stopping
from palpate_editor.surface_child.jobs import JOBS
from palpate_meshes.generate import ellipsoid
from small_meshes import CORNERS, CUBE, together
from small_meshes import mesh_of as build


def organ_of(x: np.ndarray, t: np.ndarray) -> Organ:
    surface = Surface(1e-3 * x, t)
    return replace(EMPTY.with_surface(surface), imported=surface)


def bare(organ: Organ) -> palpate.SurfaceMesh:
    return mesh_of(organ.surface)


SPHERE = make_sphere()
NOISY = damage("sphere", "noise", 0)


# ---------------------------------------------------------------- stitching


def test_borders_that_lie_on_each_other_become_one():
    loose = build(CORNERS[CUBE].reshape(-1, 3), np.arange(36).reshape(-1, 3))

    stitched = stitch_borders(loose, 1e-6)

    assert stitched.joined_vertices == 36 - 8
    report = inspect_mesh(stitched.mesh)
    assert (report.closed, report.shells) == (True, 1)
    assert report.volume_ml == pytest.approx(1.0)


def test_an_edge_with_a_corner_of_another_triangle_on_it_is_split_there():
    """The edge 0-1 of a cube, in whose middle vertex 8 lies: only one of two triangles knows it."""
    x = np.concatenate([CORNERS, [0.5 * (CORNERS[0] + CORNERS[1])]])
    cracked = build(x, np.concatenate([CUBE[1:], [[0, 2, 8], [8, 2, 1]]]))
    assert not inspect_mesh(cracked).closed

    stitched = stitch_borders(cracked, 1e-5)

    assert (stitched.split_edges, stitched.joined_vertices) == (1, 0)
    report = inspect_mesh(stitched.mesh)
    assert (report.closed, report.volume_ml) == (True, pytest.approx(1.0))


def test_borders_further_apart_than_the_tolerance_stay_apart():
    apart = together(build(CORNERS, CUBE[:6]), build(CORNERS + [1e-4, 0, 0], CUBE[6:]))

    assert stitch_borders(apart, 5e-5).joined_vertices == 0
    assert stitch_borders(apart, 2e-4).joined_vertices > 0
    with pytest.raises(EditError, match="more than 0 mm apart"):
        StitchBorders(0.0)(organ_of(*SPHERE))


# ---------------------------------------------------------------- pieces


def test_a_fin_beside_a_closed_surface_goes_and_half_an_organ_stays():
    x, t = SPHERE
    half = x[t].mean(axis=1)[:, 2] > 0.0
    apart = np.concatenate([t, t[half] + len(x)])
    organ = organ_of(np.concatenate([x, x + [100.0, 0, 0]]), apart)

    with pytest.raises(EditError, match="No piece of it is so small"):
        DropPieces()(organ)
    few = np.concatenate([t, t[:3] + len(x)])
    kept = DropPieces()(organ_of(np.concatenate([x, x + [100.0, 0, 0]])[: len(x) * 2], few))
    assert len(kept.surface.triangles) == len(t)


# ---------------------------------------------------------------- crossings


def test_a_vertex_pulled_through_the_other_side_is_taken_back():
    x, t = damage("sphere", "crossed", 3)
    mesh = mesh_of(organ_of(x, t).surface)
    assert len(find_self_intersecting_faces(mesh)) > 6

    found = remove_crossings(mesh, 0)

    report = inspect_mesh(found.mesh)
    assert (report.self_intersecting_faces, report.closed, report.shells) == (0, True, 1)
    assert found.replaced_triangles >= 6
    whole = inspect_mesh(mesh_of(organ_of(*SPHERE).surface)).volume_ml
    assert report.volume_ml == pytest.approx(whole, rel=0.01)


def test_two_balls_through_each_other_are_not_cut_into_pieces():
    x, t = SPHERE
    both = mesh_of(organ_of(*join_balls(x, t)).surface)

    found = remove_crossings(both, 1)

    assert found.replaced_triangles == 0
    assert len(found.mesh.triangles) == len(both.triangles)


def join_balls(x: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.concatenate([x, x + [25.0, 1.0, 2.0]]), np.concatenate([t, t + len(x)])


def test_what_cannot_be_taken_out_is_told_with_its_place():
    organ = organ_of(*join_balls(*SPHERE))

    with pytest.raises(EditError, match=r"triangles still cross others, at \(") as refused:
        RemoveCrossings()(organ)

    # both surfaces meet on a circle half way between the balls
    assert "(12." in str(refused.value)


def test_a_surface_without_crossings_is_refused():
    with pytest.raises(EditError, match="does not cross itself"):
        RemoveCrossings()(organ_of(*SPHERE))


# ---------------------------------------------------------------- smoothing


def test_smoothing_takes_noise_away_and_no_volume():
    mesh = mesh_of(organ_of(*NOISY).surface)

    smooth = smooth_surface(mesh, 10)

    assert palpate.compute_volume(smooth) == pytest.approx(palpate.compute_volume(mesh), rel=1e-6)
    radii = [np.linalg.norm(np.asarray(m.vertices), axis=1) for m in (mesh, smooth)]
    assert radii[1].std() < 0.4 * radii[0].std()


def test_smoothing_for_long_does_not_shrink_a_ball():
    mesh = mesh_of(organ_of(*SPHERE).surface)

    smooth = smooth_surface(mesh, 100)

    radii = np.linalg.norm(np.asarray(smooth.vertices), axis=1)
    assert radii.mean() == pytest.approx(0.03, rel=1e-3)
    assert radii == pytest.approx(0.03, rel=0.03)


def test_the_border_of_an_open_surface_stays_where_it_is():
    x, t = SPHERE
    mesh = mesh_of(organ_of(*NOISY).surface)
    bowl = build(mesh.vertices, t[x[t].mean(axis=1)[:, 2] < 0.0])
    used = np.unique(bowl.triangles)
    number = np.full(len(x), -1)
    number[used] = np.arange(len(used))
    bowl = build(np.asarray(bowl.vertices)[used], number[np.asarray(bowl.triangles)])
    [loop] = palpate.find_border_loops(bowl.triangles)

    smooth = smooth_surface(bowl, 5)

    before, after = np.asarray(bowl.vertices), np.asarray(smooth.vertices)
    assert np.array_equal(before[loop], after[loop])
    assert not np.array_equal(before, after)


@pytest.mark.parametrize("steps", [0, -1, 201])
def test_steps_that_make_no_sense_are_refused(steps):
    with pytest.raises(EditError, match=f"got {steps}, expected 1 to 200"):
        Smooth(steps)(organ_of(*SPHERE))


# ---------------------------------------------------------------- distance


def test_the_distance_of_two_balls_is_that_of_their_radii_and_a_bound():
    small, large = (build(r * 1e-3 * SPHERE[0], SPHERE[1]) for r in (1.0, 1.1))

    found = measure_distance(small, large)

    # 3 mm at the vertices; a facet of the larger one is nearer than its vertices
    assert found.least <= found.most <= 1.011 * found.least
    assert 0.0028 < found.mean < found.most < 0.00301


def test_no_point_is_further_away_than_the_largest_distance():
    x, t = damage("sphere", "crossed", 1)
    spiked, ball = (mesh_of(organ_of(*m).surface) for m in ((x, t), SPHERE))
    found = measure_distance(spiked, ball)

    random = np.random.default_rng(4)
    corners = 1e-3 * x[t[random.integers(len(t), size=2000)]]
    weights = random.dirichlet(np.ones(3), 2000)
    points = (weights[:, :, None] * corners).sum(axis=1)
    tree = palpate.AabbTree(ball.vertices, ball.triangles)
    away = [palpate.find_closest_point(tree, ball.vertices, p).distance for p in points]
    assert max(away) <= found.most


# ---------------------------------------------------------------- wrapping


def test_two_balls_through_each_other_are_wrapped_as_one():
    mesh = mesh_of(organ_of(*join_balls(*SPHERE)).surface)

    wrapped = wrap_surface(mesh, 0.002)

    report = inspect_mesh(wrapped.mesh)
    assert (report.closed, report.shells, report.self_intersecting_faces) == (True, 1, 0)
    # two caps of balls of 30 mm, 25.1 mm apart, that meet in a plane half way
    distance, radius = np.linalg.norm([25.0, 1.0, 2.0]), 30.0
    height = radius + 0.5 * distance
    volume = 2.0 * np.pi * height**2 * (3.0 * radius - height) / 3.0
    assert report.volume_ml == pytest.approx(1e-3 * volume, rel=0.03)
    assert wrapped.volume == pytest.approx(1e-6 * report.volume_ml)
    assert wrapped.to_source.most < 0.002
    # what lies inside is gone, and no price: the crease between the balls is bridged
    assert wrapped.from_source.least < 0.002
    assert wrapped.from_source.most == pytest.approx(
        wrapped.from_source.least + 0.01 * palpate.compute_diagonal(mesh.vertices)
    )
    assert wrapped.dropped == []


def test_what_lies_inside_a_wrap_is_listed_and_costs_nothing():
    x, t = SPHERE
    inner = [(0.4 * x, t), (0.1 * x + [16.0, 0, 0], t)]
    mesh = mesh_of(organ_of(*join_meshes((x, t), *inner)).surface)

    wrapped = wrap_surface(mesh, 0.004)

    assert [piece.triangles for piece in wrapped.dropped] == [len(t), len(t)]
    sizes = [2e-3 * np.sqrt(3.0) * radius for radius in (12.0, 3.0)]
    assert [piece.size for piece in wrapped.dropped] == pytest.approx(sizes, rel=0.02)
    assert wrapped.dropped[1].middle == pytest.approx([0.016, 0, 0], abs=1e-4)
    assert wrapped.from_source.most < 0.002
    assert measure_distance(mesh, wrapped.mesh).most > 0.017


def test_what_is_seen_of_a_surface_is_its_outside():
    x, t = SPHERE
    nested = mesh_of(organ_of(*join_meshes((x, t), (0.5 * x, t))).surface)
    small, large = (mesh_of(organ_of(r * x, t).surface) for r in (0.5, 1.1))

    seen = measure_seen_distance(nested, large)

    assert 0.0028 < seen.mean < seen.least < 0.0031
    assert measure_distance(nested, large).most > 0.015
    # nobody sees the larger one's inside from the smaller one's place
    assert measure_seen_distance(small, large).least == pytest.approx(0.018, rel=0.02)


def join_meshes(*meshes: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    first = np.cumsum([0, *(len(x) for x, _ in meshes)])
    triangles = [t + k for (_, t), k in zip(meshes, first, strict=False)]
    return np.concatenate([x for x, _ in meshes]), np.concatenate(triangles)


def test_a_wrap_takes_the_place_of_what_was_imported():
    organ = organ_of(*join_balls(*SPHERE))

    after = Wrap(0.004)(organ)

    assert after.imported is after.surface
    assert inspect_mesh(bare(after)).shells == 1
    with pytest.raises(EditError, match="thousandth of the diagonal"):
        Wrap(1e-6)(organ)


BALL = ellipsoid(3000)
"""[m]"""


def make_torn_wall() -> Organ:
    """A closed wall of two faces, 4 mm apart, with the triangles at one vertex missing."""
    x, t = 1e3 * BALL[0], BALL[1]
    inner = x - 4.0 * palpate.compute_vertex_normals(*BALL)
    torn = t[~(t == x[:, 2].argmax()).any(axis=1)]
    return organ_of(*join_meshes((x, torn), (inner, t[:, ::-1])))


def test_a_small_hole_reaches_as_far_from_its_middle_as_its_furthest_vertex():
    surface = make_torn_wall().surface
    (loop,) = palpate.find_border_loops(surface.triangles)
    rim = surface.vertices[loop]

    reach = measure_small_holes(surface)

    assert reach == pytest.approx(max(np.linalg.norm(p - rim.mean(axis=0)) for p in rim))
    assert 0.01 < reach / palpate.compute_diagonal(surface.vertices) < 0.025
    assert measure_small_holes(organ_of(*SPHERE).surface) == 0.0


@pytest.mark.landing
def test_a_ball_that_is_wrapped_around_an_organ_stays_outside_of_its_small_holes():
    organ = make_torn_wall()
    radius = measure_small_holes(organ.surface)

    outside = Wrap(past_holes=True).find(organ)

    ball = palpate.compute_volume(build(*BALL))
    assert outside.volume == pytest.approx(ball, rel=0.03) and len(outside.dropped) == 1
    again = Wrap(PAST_HOLES * radius).find(organ)
    assert np.array_equal(again.surface.vertices, outside.surface.vertices)


# ---------------------------------------------------------------- remeshing


def edges_of(surface: Surface) -> np.ndarray:
    x = surface.vertices[surface.triangles]
    return np.linalg.norm(x - np.roll(x, 1, axis=1), axis=2).ravel()


def test_edges_get_the_length_that_was_asked_for_and_the_shape_stays():
    organ = organ_of(*make_spleen())

    after = Remesh(0.004)(organ)

    assert np.median(edges_of(after.surface)) == pytest.approx(0.004, rel=0.1)
    assert after.decimation.smallest_angle_deg > 20.0
    assert after.decimation.max_distance < 0.0035
    before, now = (inspect_mesh(bare(o)) for o in (organ, after))
    assert now.volume_ml == pytest.approx(before.volume_ml, rel=0.01)
    assert after.imported is organ.imported


def test_a_region_gets_shorter_edges_and_what_is_painted_is_carried():
    x, t = make_spleen()
    organ = organ_of(x, t)
    region = np.flatnonzero(x[:, 2] > np.quantile(x[:, 2], 0.9)).astype(np.int32)
    painted = replace(
        organ, regions={"hilum": region}, stiffness_scale=np.where(x[:, 0] > 0, 2.0, 1.0)
    )

    after = Remesh(0.006, "hilum", 0.002)(painted)

    inside = np.isin(after.surface.triangles, after.regions["hilum"]).all(axis=1)
    corners = after.surface.vertices[after.surface.triangles]
    lengths = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    assert np.median(lengths[inside]) == pytest.approx(0.002, rel=0.15)
    far = corners.mean(axis=1)[:, 2] < 1e-3 * np.quantile(x[:, 2], 0.3)
    assert np.median(lengths[far]) == pytest.approx(0.006, rel=0.15)
    assert after.decimation.smallest_angle_deg > 15.0
    assert set(np.round(np.unique(after.stiffness_scale)).tolist()) == {1.0, 2.0}


def test_a_cube_keeps_its_edges():
    made = remesh_surface(build(CORNERS, CUBE), [0.002] * 8)

    report = inspect_mesh(made)
    assert report.volume_ml == pytest.approx(1.0)
    assert report.triangles > 200
    assert report.size_mm == pytest.approx([10.0, 10.0, 10.0])


@pytest.mark.parametrize(
    ("edit", "said"),
    [
        (Remesh(0.0), "longer than 0 mm"),
        (Remesh(0.004, "hilum"), "no region 'hilum'"),
        (Remesh(1e-6), "about .* triangles"),
    ],
)
def test_remeshing_that_makes_no_sense_is_refused(edit, said):
    with pytest.raises(EditError, match=said):
        edit(organ_of(*SPHERE))


def test_the_verb_remeshes(tmp_path, capsys):
    path, out = tmp_path / "a.organ", tmp_path / "b.organ"
    write_organ(path, organ_of(*SPHERE))

    words = ["remesh", str(path), "--edge-length", "4mm"]
    assert main([*words, "-o", str(out), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert out.exists() and told["smallest_angle_deg"] > 20.0
    assert main([*words, "--dry-run", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == told | {"out": None}


# ---------------------------------------------------------------- the process


def test_what_is_no_longer_wanted_ends_and_so_does_its_process():
    with stopping(lambda: True), pytest.raises(Cancelled):
        run_guarded("wrap", surface_of(600), {"alpha": 1e-4}, 600.0)


def test_work_that_is_out_of_time_gives_what_it_had_by_then():
    assert run_guarded("wrap", surface_of(600), {"alpha": 1e-4}, 0.0) is None


def test_a_job_that_breaks_down_is_told_in_a_sentence():
    with pytest.raises(GuardedError, match="KeyError"):
        run_guarded("wrap", surface_of(60), {}, 60.0)
    with pytest.raises(GuardedError, match="alpha: got"):
        run_guarded("wrap", surface_of(60), {"alpha": -1.0}, 60.0)
    assert set(JOBS) == {"remove_crossings", "wrap", "remesh"}
