# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents are values: nothing about them can be changed once they are made."""

from __future__ import annotations

import pickle
from dataclasses import FrozenInstanceError, fields, replace

import numpy as np
import pytest
from organs import SOURCE, make_organ, surface_of
from palpate.scene.scene_parts import FillPart, HandPart, MaterialPart, ModelPart, ToolPart
from palpate_editor.document import EMPTY, Organ, Surface, freeze, phrase
from palpate_editor.document.constants import CHOICES, CONSTANTS, find_constant

PARTS = {
    "material": MaterialPart,
    "model": ModelPart,
    "fill": FillPart,
    "tool": ToolPart,
    "hand": HandPart,
}


def test_the_empty_organ_has_no_surface_and_nothing_painted():
    assert EMPTY.surface is None and EMPTY.source is None
    assert EMPTY.vertex_count == 0
    assert EMPTY.fixed.shape == EMPTY.stiffness_scale.shape == (0,)


@pytest.mark.parametrize("field", [f.name for f in fields(Organ)])
def test_no_field_of_an_organ_can_be_set(field):
    with pytest.raises(FrozenInstanceError):
        setattr(make_organ(), field, None)


def test_the_arrays_of_a_surface_cannot_be_written_and_are_not_those_it_was_given():
    vertices = np.zeros((3, 3))
    triangles = np.array([[0, 1, 2]], np.int64)

    surface = Surface(vertices, triangles)
    vertices[:] = 1.0

    assert (surface.vertices == 0.0).all()
    assert surface.triangles.dtype == np.int32
    for array in (surface.vertices, surface.triangles):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


def test_freezing_what_is_frozen_gives_the_very_same_array():
    frozen = freeze([1.0, 2.0], np.float64, (None,))

    assert freeze(frozen, np.float64, (2,)) is frozen


def test_a_read_only_view_of_what_can_be_written_is_copied():
    writable = np.zeros(3)
    view = writable.view()
    view.flags.writeable = False

    frozen = freeze(view, np.float64, (None,))
    writable[0] = 1.0

    assert frozen[0] == 0.0


@pytest.mark.parametrize("values", [np.zeros(3), np.zeros((3, 2)), 1.0])
def test_an_array_of_another_shape_is_refused(values):
    with pytest.raises(ValueError, match="expected"):
        freeze(values, np.float64, (None, 3))


def test_what_is_painted_must_have_one_number_for_every_vertex():
    with pytest.raises(ValueError, match=r"shape \(59,\)"):
        replace(make_organ(), stiffness_scale=np.ones(59))


@pytest.mark.parametrize("ids", [[2, 1], [1, 1], [-1], [60]])
def test_a_region_is_vertices_of_the_surface_in_order(ids):
    with pytest.raises(ValueError, match="ascending ones from 0 to 59"):
        replace(make_organ(), regions={"hilum": ids})


def test_regions_cannot_be_written():
    organ = make_organ()

    with pytest.raises(TypeError):
        organ.regions["kapı"] = [1]
    with pytest.raises(ValueError, match="read-only"):
        organ.regions["hilum"][0] = 0
    assert replace(organ, title="x").regions is organ.regions


def test_organs_and_surfaces_are_compared_by_identity():
    organ = make_organ()

    assert organ == organ and organ != replace(organ)
    assert surface_of(60) != surface_of(60)
    assert replace(SOURCE) == SOURCE


def test_a_phrase_is_its_english_and_remembers_how_it_was_made():
    words = phrase("{count} holes of {size:.1f} mm", count=2, size=3.14)

    assert words == "2 holes of 3.1 mm"
    assert words.template == "{count} holes of {size:.1f} mm"
    assert words.values == {"count": 2, "size": 3.14}
    assert pickle.loads(pickle.dumps(words)).values == words.values


def test_the_table_of_constants_names_fields_there_are_and_allows_their_defaults():
    for constant in CONSTANTS:
        part = PARTS[constant.part]()
        value = getattr(part, constant.field)
        assert value is None if constant.optional else constant.allows(value), constant.key


def test_every_number_and_law_of_the_parts_can_be_set_by_someone():
    known = {c.key for c in CONSTANTS} | set(CHOICES)
    # painted; SetReach, SetFineRegion and SetGravity; set with the number of tetrahedra
    elsewhere = {"model.fixed", "model.stiffness_scale", "fill.reach", "hand.gravity"}
    elsewhere |= {"fill.fine_region", "fill.sizing"}

    there = {f"{name}.{f.name}" for name, part in PARTS.items() for f in fields(part)}

    assert there == known | elsewhere


def test_a_range_is_described_in_the_unit_that_is_shown():
    assert find_constant("tool", "radius").describe_range() == "more than 0 mm"
    assert find_constant("model", "drag").describe_range() == "at least 0 1/s"
    assert find_constant("model", "pressure").describe_range() == "any finite number"
    assert find_constant("material", "poisson_ratio").describe_range() == "0 to 0.5"
    assert find_constant("model", "colour") is None
