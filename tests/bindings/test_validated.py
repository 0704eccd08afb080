# SPDX-License-Identifier: BSD-3-Clause
"""To which depth a press is validated: by hand on an ellipsoid, a wall, a sheet and a block."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.runs.press import Place, PressScript, find_place, write_script
from palpate.runs.validated import find_validity, measure_script
from palpate.scene.scene_parts import VALIDATED_PART, VALIDATED_RADII, VALIDATED_TIPS, is_deeper
from palpate.study.contact_reference import list_contact_references, read_contact_reference
from palpate.study.tool import open_pressed
from palpate.study.tool_block import open_blocks
from surfaces import MEMBRANE, ellipsoid, sheet

PUBLISHED = Path(__file__).parents[2] / "meshes" / "published"
RADII = (50e-3, 35e-3, 15e-3)
"""[m] of the ellipsoid."""


def make_scene(mesh: palpate.SurfaceMesh, tip: float) -> palpate.Scene:
    scene = palpate.make_scene(palpate.build_mass_spring(mesh, MEMBRANE, 20.0))
    scene.instruments[0].tool.radius = tip
    return palpate.build_scene(scene)


def make_ellipsoid(tip: float) -> tuple[palpate.Scene, dict[str, Place]]:
    """With its places over the ends of the axes, which are vertices."""
    ends = np.diag(RADII)
    places = {
        name: Place(end, end / np.linalg.norm(end)) for name, end in zip("xyz", ends, strict=True)
    }
    return make_scene(ellipsoid(RADII, 3), tip), places


@pytest.mark.parametrize(
    ("tip", "axis", "wall", "depth", "bound"),
    [
        # a tenth of 30 mm beside one and a half of 3 mm, of 2 mm, and of 2 mm of 100 mm
        (3e-3, "z", None, 3.0e-3, "thickness"),
        (2e-3, "z", None, 3.0e-3, "radius"),
        (3e-3, "x", None, 4.5e-3, "radius"),
        (8e-3, "y", None, 7.0e-3, "thickness"),
        # a wall gives way in bending: its own thickness counts beside those of the organ
        (3e-3, "x", 2e-3, 2.0e-3, "wall"),
        (3e-3, "z", 4e-3, 3.0e-3, "thickness"),
        (2.5e-3, "y", 4e-3, 3.75e-3, "radius"),
    ],
)
def test_the_least_of_a_tenth_of_the_thickness_and_one_and_a_half_radii_and_the_wall(
    tip, axis, wall, depth, bound
):
    scene, places = make_ellipsoid(tip)

    found = find_validity(scene, places[axis], wall)

    assert found.thickness == pytest.approx(2.0 * RADII["xyz".index(axis)], rel=1e-3)
    assert found.depth == pytest.approx(depth, rel=1e-3)
    assert found.bound == bound or found.depth == pytest.approx(3.0e-3, rel=1e-3)


@pytest.mark.parametrize("tip", [1.9e-3, 8.1e-3, 12e-3])
def test_a_tip_that_no_reference_has_is_validated_to_no_depth(tip):
    scene, places = make_ellipsoid(tip)

    found = find_validity(scene, places["x"])

    assert (found.depth, found.bound) == (0.0, "tip")
    assert found.thickness == pytest.approx(0.1, rel=1e-3)


def test_a_shaft_is_validated_to_no_depth_since_all_references_have_balls():
    scene, places = make_ellipsoid(3e-3)
    scene.instruments[0].tool.capsules = [palpate.Capsule(to=[0.0, 0.0, 0.02])]

    for place in places.values():
        assert find_validity(scene, place).depth == 0.0
        assert find_validity(scene, place).bound == "tip"


def test_a_sheet_has_no_thickness_but_its_wall():
    scene = make_scene(sheet(9, 0.04), 3e-3)
    place = find_place(scene, np.zeros(3))

    one, other = (find_validity(scene, place, wall) for wall in (None, 2e-3))

    assert one.thickness is None and other.thickness is None
    assert one.depth == pytest.approx(4.5e-3) and one.bound == "radius"
    assert other.depth == pytest.approx(2e-3) and other.bound == "wall"


def test_a_hollow_body_has_its_far_wall_behind_the_place_and_a_solid_its_first_end():
    """Two balls one behind the other: the first ends where the second has not begun."""
    one, other = ellipsoid((0.02, 0.02, 0.02), 3), ellipsoid((0.01, 0.01, 0.01), 3)
    x = np.vstack([one.vertices, np.asarray(other.vertices) - [0.0, 0.0, 0.05]])
    triangles = np.vstack([one.triangles, np.asarray(other.triangles) + len(one.vertices)])
    scene = make_scene(palpate.SurfaceMesh(x, triangles), 3e-3)
    top = Place(np.array([0.0, 0.0, 0.02]), np.array([0.0, 0.0, 1.0]))

    solid, hollow = (find_validity(scene, top, wall).thickness for wall in (None, 2e-3))

    assert solid == pytest.approx(0.04, rel=1e-6)
    assert hollow == pytest.approx(0.08, rel=1e-6)


@pytest.mark.parametrize("name", list_contact_references())
def test_no_reference_goes_deeper_and_all_go_so_deep(name):
    reference = read_contact_reference(name)

    for case in reference.cases:
        spot = reference.find_place(case.place)
        bounds = (VALIDATED_PART * spot.thickness, VALIDATED_RADII * case.radius)
        assert VALIDATED_TIPS[0] <= case.radius <= VALIDATED_TIPS[1]
        if name != "layer":  # a sphere on it is a formula's as well, and shallow
            assert case.results[-1].depth == pytest.approx(min(bounds), rel=1e-4)


def test_a_place_of_a_shipped_organ_is_as_thick_as_its_reference_has_it():
    pressed = open_pressed(PUBLISHED / "spleen.palpate")
    scene = pressed.load()

    for spot in pressed.reference.places:
        found = find_validity(scene, Place(np.array(spot.point), np.array(spot.direction)))
        assert found.thickness == pytest.approx(spot.thickness, rel=1e-3)


def test_the_block_is_validated_to_a_tenth_of_its_fifty_millimetres_under_the_largest_ball():
    scene = open_blocks()[0].load()
    scene.instruments[0].tool.radius = 8e-3
    middle = Place(np.array([0.0, 0.0, 0.05]), np.array([0.0, 0.0, 1.0]))

    assert find_validity(scene, middle).depth == pytest.approx(5e-3, rel=1e-6)


@pytest.mark.parametrize(("depth", "deeper"), [(2.9e-3, False), (3.1e-3, True)])
def test_a_script_is_as_deep_as_its_hand_goes_below_the_surface(depth, deeper):
    scene, places = make_ellipsoid(3e-3)
    frames, _ = write_script(places["z"], 3e-3, PressScript(depth=depth, pull=5e-3))

    found = measure_script(scene, frames)

    # over a vertex of the mesh, whose triangles fall away from it a little
    assert found.depth == pytest.approx(depth, abs=5e-5)
    assert is_deeper(found.depth, found.validity.depth) is deeper


def test_of_a_script_the_place_counts_where_it_goes_farthest_beyond():
    """4.4 mm at the thick end are less than the 4.5 mm of there, 4 mm at the thin one too much."""
    scene, places = make_ellipsoid(3e-3)
    thick, _ = write_script(places["x"], 3e-3, PressScript(depth=4.4e-3))
    thin, times = write_script(places["z"], 3e-3, PressScript(depth=4e-3))
    around = palpate.KeyFrame(time=times.end + 1.0, position=np.array([0.1, 0.0, 0.1]))
    for frame in thick:
        frame.time += times.end + 2.0

    found = measure_script(scene, [*thin, around, *thick])

    assert found.place.point == pytest.approx(places["z"].point, abs=1e-3)
    assert found.depth == pytest.approx(4e-3, abs=5e-5)


def test_a_script_that_touches_nothing_is_no_press():
    scene, _ = make_ellipsoid(3e-3)
    far = [palpate.KeyFrame(time=t, position=np.array([0.0, 0.0, 0.1 + t])) for t in (0.0, 1e4)]

    assert measure_script(scene, far) is None and measure_script(scene, []) is None
