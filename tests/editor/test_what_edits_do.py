# SPDX-License-Identifier: GPL-3.0-or-later
"""What single edits make of an organ; the laws of all are in test_edits."""

from __future__ import annotations

import os
from dataclasses import replace

import numpy as np
import pytest
from organs import (
    SOURCE,
    make_organ,
    surface_of,
    two_shells,
)
from palpate.scene.scene_parts import MaterialPart, ModelPart
from palpate_editor import authoring, edits
from palpate_editor.compile import mesh_of
from palpate_editor.document import EMPTY, Decimation
from palpate_editor.document.constants import CONSTANTS
from palpate_editor.document.files import write_organ
from palpate_editor.edits import EditError
from palpate_editor.edits.configure import find_configuration
from palpate_editor.edits.orient import METRES, TURNS

SPLEEN = make_organ()
IN_PIECES = replace(make_organ().with_surface(two_shells()), imported=None)
OWN = find_configuration(SPLEEN)
DECIMATION = Decimation(150, 296, 50, 96, 30.0, 1e-4, 2e-4)
COARSE = surface_of(50)


def test_every_number_of_the_table_can_be_set_and_is_refused_beyond_its_range():
    for constant in CONSTANTS:
        allowed = constant.least + (3.0 if constant.whole else min(0.25, 0.5 * constant.most))
        allowed = allowed if np.isfinite(allowed) else -3.0
        after = edits.SetConstant(constant.part, constant.field, allowed)(SPLEEN)
        assert getattr(getattr(after, constant.part), constant.field) == allowed
        if np.isfinite(constant.least):
            with pytest.raises(EditError):
                edits.SetConstant(constant.part, constant.field, constant.least - 1.0)(SPLEEN)


def test_another_unit_scales_both_surfaces_and_the_distances_of_the_decimation():
    after = edits.SetUnit("cm")(SPLEEN)

    assert after.surface.vertices == pytest.approx(10.0 * SPLEEN.surface.vertices)
    assert after.imported.vertices == pytest.approx(10.0 * SPLEEN.imported.vertices)
    assert after.decimation.mean_distance == pytest.approx(1.25e-3)
    assert (after.source.unit, after.source.unit_guessed) == ("cm", False)


@pytest.mark.parametrize(
    ("unit", "up"), [(unit, "z") for unit in METRES] + [("m", up) for up in TURNS if up != "z"]
)
def test_unit_and_axis_set_later_are_those_of_an_import_with_them(tmp_path, unit, up):
    path = tmp_path / "organ.stl"
    authoring.write_mesh(path, mesh_of(surface_of(50)))
    plain = edits.import_file(path, unit="m", up="z")(EMPTY)

    later = edits.SetUp(up)(edits.SetUnit(unit)(plain))
    at_once = edits.import_file(path, unit=unit, up=up)(EMPTY)

    assert later.surface.triangles.tolist() == at_once.surface.triangles.tolist()
    assert later.surface.vertices == pytest.approx(at_once.surface.vertices, rel=1e-12)
    assert (later.source.unit, later.source.up) == (unit, up)


def test_the_largest_piece_is_kept_with_what_was_painted_on_it():
    painted = edits.FixVertices(np.array([50, 51]))(edits.FixVertices(np.array([0]))(IN_PIECES))

    after = edits.KeepLargestShell()(painted)

    assert len(after.surface.vertices) == 60
    assert np.flatnonzero(after.fixed).tolist() == [0, 1]
    assert after.imported is after.surface or after.imported.vertices.shape == (60, 3)


def test_decimation_carries_over_what_was_painted():
    stiff = np.flatnonzero(SPLEEN.surface.vertices[:, 0] > 0.0)
    painted = replace(SPLEEN, stiffness_scale=np.ones(60), fixed=SPLEEN.surface.vertices[:, 2] < 0)
    top = np.flatnonzero(SPLEEN.surface.vertices[:, 2] > 0)
    painted = replace(painted, regions={"top": top, "nothing": []})
    painted = edits.PaintStiffness(stiff, 4.0)(painted)

    edit = edits.decimate_organ(painted, 50)
    after = edit(painted)

    x = after.surface.vertices
    far = np.abs(x) > 0.4 * np.abs(x).max(axis=0)
    assert (after.stiffness_scale[(x[:, 0] > 0) & far[:, 0]] > 3.0).all()
    assert (after.stiffness_scale[(x[:, 0] < 0) & far[:, 0]] < 2.0).all()
    assert after.fixed[(x[:, 2] < 0) & far[:, 2]].all()
    assert not after.fixed[(x[:, 2] > 0) & far[:, 2]].any()
    held = np.zeros(50, bool)
    held[after.regions["top"]] = True
    assert held[(x[:, 2] > 0) & far[:, 2]].all() and not held[(x[:, 2] < 0) & far[:, 2]].any()
    assert "nothing" not in after.regions
    assert (after.decimation.vertices_before, after.decimation.vertices) == (150, 50)


def test_decimation_starts_from_the_imported_surface_every_time():
    once = edits.decimate_organ(SPLEEN, 50)(SPLEEN)

    again = edits.decimate_organ(once, 120)(once)

    assert again.vertex_count == 120
    assert again.imported is SPLEEN.imported


@pytest.mark.parametrize("count", [-1, 3, 151])
def test_a_count_that_cannot_be_had_is_refused(count):
    with pytest.raises(EditError, match=f"cannot be decimated to {count} vertices"):
        edits.decimate_organ(SPLEEN, count)


def test_the_lowest_part_is_fixed_beside_what_is_fixed_already():
    height = SPLEEN.surface.vertices[:, 2]

    after = edits.FixLowest(0.1)(SPLEEN)

    limit = height.min() + 0.1 * np.ptp(height)
    assert after.fixed.tolist() == ((height <= limit) | SPLEEN.fixed).tolist()


def test_a_region_is_named_in_order_and_may_be_named_again():
    after = edits.SetRegion("hilum", np.array([5, 2, 5]))(SPLEEN)

    assert after.regions["hilum"].tolist() == [2, 5]
    assert list(after.regions) == ["hilum", "alt uç"]
    assert SPLEEN.regions["hilum"].tolist() == [1, 4, 7]


def test_an_organ_has_no_more_regions_than_a_file_has_room_for():
    many = replace(SPLEEN, regions={str(i): [i % 60] for i in range(200)})

    with pytest.raises(EditError, match="at most 200 regions"):
        edits.SetRegion("one more", np.array([0]))(many)


def test_pasting_a_material_keeps_what_was_painted():
    after = edits.SetMaterial(MaterialPart(), ModelPart(fixed=(1,), stiffness_scale=(2.0,)))(SPLEEN)

    assert after.fixed is SPLEEN.fixed and after.stiffness_scale is SPLEEN.stiffness_scale
    assert (after.model.fixed, after.model.stiffness_scale) == ((), ())


def test_importing_keeps_the_name_that_was_given_and_takes_the_files_otherwise():
    edit = edits.ImportMesh("liver", SOURCE, surface_of(80))

    assert edit(SPLEEN).name == "dalak"
    assert edit(EMPTY).name == "liver"
    assert not edit(SPLEEN).fixed.any() and not edit(SPLEEN).regions


def test_work_done_beforehand_is_used_for_the_organ_it_was_done_for_and_no_other():
    prepared = edits.prepare(edits.SetName("liver"), SPLEEN)
    other = edits.SetTask(task="other")(SPLEEN)

    assert prepared(SPLEEN) is prepared.after
    assert (prepared(other).name, prepared(other).task) == ("liver", "other")


def test_an_import_knows_its_file(shared_data):
    path = shared_data("organs/VH_F_Spleen.glb")

    organ = edits.import_file(path)(EMPTY)

    source = organ.source
    assert (source.file, source.format) == ("VH_F_Spleen.glb", "GLB")
    assert source.folder == str(path.resolve().parent)
    assert len(source.parts_available) == len(source.parts) == 5
    assert source.repairs.welded_vertices == 291
    assert len(organ.surface.vertices) == 4274
    assert organ.surface is organ.imported


def test_a_file_whose_name_is_no_text_can_be_imported_and_saved(tmp_path):
    path = tmp_path / os.fsdecode(b"dala\xf0.stl")
    authoring.write_mesh(tmp_path / "plain.stl", mesh_of(surface_of(50)))
    (tmp_path / "plain.stl").rename(path)

    organ = edits.import_file(path)(EMPTY)
    write_organ(tmp_path / "a.organ", organ)

    assert (organ.name, organ.source.file) == ("dala?", "dala?.stl")


def test_a_configuration_brings_its_mesh_and_leaves_what_the_organ_is_made_of():
    configuration = replace(OWN, kind="molecular", integrator="implicit_euler", vertices=90)
    after = edits.Configure(configuration)(SPLEEN)

    assert after.vertex_count == 90
    assert after.decimation is not None and after.decimation.vertices == 90
    assert (after.model.kind, after.model.integrator) == ("molecular", "implicit_euler")
    assert find_configuration(after) == replace(configuration, vertices=0)
    for part in ("material", "fill", "tool", "hand"):
        assert getattr(after, part) is getattr(SPLEEN, part)
