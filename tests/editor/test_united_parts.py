# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of a file, and pieces of a surface, united and subtracted as solids."""

from __future__ import annotations

import re

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate_editor.authoring import find_self_intersecting_faces, import_mesh, unite_shells
from palpate_editor.document import EMPTY
from palpate_editor.document.files import read_organ
from palpate_editor.edits import EditError, import_file
from palpate_editor.edits.unite import UniteShells, can_be_united
from part_files import ball, box, read_parts, volume_of, write_parts
from small_meshes import mesh_of, together

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


# ---------------------------------------------------------------- parts that cross themselves

RIGHT = (17.0, 0.0, 0.0)
"""[mm] The middle of the second ball."""
WAYS = {"outwards": (1.0, 0.0, 0.0), "into the other": (-1.0, 0.0, 0.0), "aside": (0.0, 1.0, 0.0)}
"""From the middle of the ball to the vertex that is pushed, away from where it comes out."""


def pushed_through(way: tuple[float, float, float], count: int = 1):
    """[mm] A ball of which the vertices that lie furthest that way stick out on the other side."""
    x, triangles = ball(15.0)
    x[np.argsort(-(x @ way))[:count]] *= -1.15
    return x + np.array(RIGHT), triangles


def balls(right) -> dict:
    return {"left": ball(20.0), "right": right}


@pytest.mark.parametrize("way", WAYS)
def test_parts_are_united_where_one_crosses_itself_a_little(way, tmp_path):
    path, parts = read_parts(tmp_path, balls(pushed_through(WAYS[way])))
    clean = write_parts(tmp_path / "clean.obj", balls(ball(15.0, RIGHT)))
    assert 6 < parts["right"].crossing_faces < 20

    organ = import_mesh(path, unit="mm", unite=True)

    [note] = organ.joined.notes
    assert "part 'right' crossed itself" in note and "were replaced" in note
    assert int(note.split(": ")[1].split()[0]) >= parts["right"].crossing_faces
    assert (organ.report.shells, organ.report.genus) == (1, 0)
    assert organ.report.closed and organ.report.self_intersecting_faces == 0
    # two patches of some triangles each in the place of a spike of 15 mm
    assert organ.report.volume_ml == pytest.approx(volume_of(clean, unite=True), rel=0.01)
    assert furthest_outside(np.asarray(organ.mesh.vertices)) < 1.0


def furthest_outside(x: np.ndarray) -> float:
    """[mm] How far the furthest of the points [m] (n, 3) is outside of both balls."""
    centres = zip((20.0, 15.0), ((0.0, 0.0, 0.0), RIGHT), strict=True)
    away = [np.linalg.norm(1e3 * x - np.array(middle), axis=1) - r for r, middle in centres]
    return float(np.minimum(*away).max())


@pytest.mark.parametrize("way", WAYS)
def test_a_part_that_crosses_itself_a_little_is_taken_away(way, tmp_path):
    path = write_parts(tmp_path / "two.obj", balls(pushed_through(WAYS[way])))
    clean = write_parts(tmp_path / "clean.obj", balls(ball(15.0, RIGHT)))

    organ = import_mesh(path, unit="mm", subtract=["right"])

    assert "part 'right' crossed itself" in organ.joined.notes[0]
    assert find_self_intersecting_faces(organ.mesh) == []
    less = volume_of(clean, subtract=["right"])
    assert 1e6 * palpate.compute_volume(organ.mesh) == pytest.approx(less, rel=0.01)


def test_nothing_is_noted_of_parts_that_only_cross_each_other(tmp_path):
    path = write_parts(tmp_path / "two.obj", balls(ball(15.0, RIGHT)))

    assert import_mesh(path, unit="mm", unite=True).joined.notes == []


def test_a_part_that_crosses_itself_all_over_is_refused_by_name(tmp_path):
    path = write_parts(tmp_path / "two.obj", balls(pushed_through(WAYS["aside"], count=40)))

    with pytest.raises(palpate.FileError, match="triangles that cross others") as refusal:
        import_mesh(path, unit="mm", unite=True)

    assert "part 'right'" in refusal.value.where


def test_an_organ_of_a_part_that_crossed_itself_says_so(tmp_path, capsys):
    path = write_parts(tmp_path / "two.obj", balls(pushed_through(WAYS["outwards"])))
    out = tmp_path / "two.organ"

    call = ["import", str(path), "--unit", "mm", "--up", "z", "--unite", "-o", str(out)]
    assert main(call) == 0

    assert "part 'right' crossed itself" in capsys.readouterr().out
    assert any("crossed itself" in note for note in read_organ(out).source.notes)


def test_a_piece_that_crosses_itself_a_little_is_united_as_an_edit():
    x, triangles = pushed_through(WAYS["aside"])
    both = together(mesh_of(*ball(0.02)), mesh_of(1e-3 * x, triangles))

    united = unite_shells(both)

    assert palpate.is_closed(united.mesh.triangles)
    assert find_self_intersecting_faces(united.mesh) == []
    assert furthest_outside(np.asarray(united.mesh.vertices)) < 1.0
    [note] = united.notes
    assert re.fullmatch(r"surface crossed itself: \d+ of its triangles were replaced", note)


def test_the_organ_tells_that_its_pieces_were_changed_to_be_united(tmp_path):
    path = write_parts(tmp_path / "two.obj", balls(pushed_through(WAYS["aside"])))
    organ = import_file(path, unit="mm", up="z")(EMPTY)

    united = UniteShells()(organ)

    assert any("surface crossed itself" in note for note in united.source.notes)
    assert organ.source.notes == united.source.notes[: len(organ.source.notes)]
