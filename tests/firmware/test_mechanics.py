# SPDX-License-Identifier: GPL-3.0-or-later
"""The printable parts: whole, small enough to print, and clear of each other where the tip goes."""

from __future__ import annotations

import importlib.util
import itertools
import math
import shutil

import numpy as np
import palpate
import pytest
from palpate_editor import authoring

BED = 200.0
"""[mm] Sides of what the cheapest printers print."""
BOX = ((-100.0, 0.0, 100.0), (-160.0, -20.0), (70.0, 190.0))
"""[mm] The workspace: right, up and towards the user of where yaw and elevation axes meet."""


@pytest.fixture(scope="module")
def mechanics(checkout):
    path = checkout / "firmware/mechanics/build_parts.py"
    spec = importlib.util.spec_from_file_location("build_parts", path)
    module = importlib.util.module_from_spec(spec)
    # dataclasses look their module up
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(__import__("sys").modules, "build_parts", module)
        spec.loader.exec_module(module)
        yield module


@pytest.fixture(scope="module")
def solids(mechanics, checkout):
    if shutil.which("openscad") is None:
        pytest.skip("openscad is not installed; packages.txt names it")
    out = checkout / "build/mechanics"
    return {name: mechanics.read_solid(mechanics.build_part(name, out)) for name in mechanics.NAMES}


def as_mesh(solid) -> palpate.SurfaceMesh:
    return palpate.SurfaceMesh(1e-3 * solid.vertices, solid.triangles)


@pytest.mark.landing
def test_every_part_is_one_closed_shell_that_a_small_printer_prints(solids):
    for name, solid in solids.items():
        report = authoring.inspect_mesh(as_mesh(solid))

        assert report.closed and report.shells == 1 and report.outward, name
        assert report.non_manifold_edges == 0, name
        assert max(report.size_mm) <= BED, (name, report.size_mm)


def test_every_part_lies_flat_on_the_bed_it_is_printed_on(solids):
    for name, solid in solids.items():
        assert solid.vertices[:, 2].min() == pytest.approx(0.0, abs=1e-6), name


def find_joints(x: float, y: float, z: float, length: float) -> tuple[float, float, float]:
    """[degrees] of a tip [mm], by the inverse kinematics of the device for two equal links."""
    r, d = math.hypot(x, z), math.hypot(x, y, z)
    elevation = math.atan2(y, r) + math.acos(d / (2 * length))
    forearm = math.atan2(r - length * math.cos(elevation), length * math.sin(elevation) - y)
    return tuple(math.degrees(angle) for angle in (math.atan2(x, z), elevation, forearm))


def find_tip(mechanics, pose) -> np.ndarray:
    """[mm] Where the gimbal's ring has its middle."""
    _, matrix = mechanics.place_parts(*pose)["ring"]
    return (matrix @ [0.0, 0.0, 7.0, 1.0])[:3]


@pytest.mark.parametrize("place", [*itertools.product(*BOX)])
def test_the_tip_is_where_the_kinematics_says(mechanics, place):
    x, y, z = place
    size = mechanics.read_parameters()
    assert size["upper_arm"] == size["forearm"] == 150.0  # as in palpate.Arm
    pose = find_joints(x, y, z, size["upper_arm"])
    _, turret = mechanics.place_parts(0.0, 0.0, 0.0)["turret"]
    floor = turret[2, 3] + size["plate"] + size["floor_plate"]

    tip = find_tip(mechanics, pose)

    # mechanics stand with z up, x to the user; the device's frame has y up, z to the user
    axle = floor + size["axle_over_floor"]
    assert tip == pytest.approx([z, x, axle + y], abs=1e-9)


def test_turning_the_gimbal_does_not_move_the_tip(mechanics):
    straight = find_tip(mechanics, (10.0, 30.0, 30.0, (0.0, 0.0)))

    assert find_tip(mechanics, (10.0, 30.0, 30.0, (35.0, -70.0))) == pytest.approx(
        straight, abs=1e-9
    )


CORNERS = [*itertools.product(*BOX)]
MORE = [pytest.param(corner, marks=pytest.mark.verify) for corner in CORNERS[1::3] + CORNERS[2::3]]
"""Of what is left out, each corner has a neighbour that is not."""


@pytest.mark.parametrize("place", [(0.0, -55.0, 204.9), *CORNERS[::3], *MORE])
def test_no_part_meets_another_where_the_tip_goes(mechanics, solids, place):
    placed = mechanics.assemble(solids, *find_joints(*place, 150.0))

    assert find_meetings(placed) == set()


def test_the_test_above_sees_parts_that_meet(mechanics, solids):
    # the tip in the column, far out of the workspace
    placed = mechanics.assemble(solids, 0.0, -15.0, -45.0)

    assert {"ring", "column"} <= find_meetings(placed)


def find_meetings(placed) -> set[str]:
    """Places whose part is cut by another one's. What a part's own slivers do is not counted."""
    corners, faces, owners, alone = [], [], [], set()
    for place, solid in placed.items():
        first, start = sum(map(len, corners)), len(owners)
        alone |= {start + f for f in authoring.find_self_intersecting_faces(as_mesh(solid))}
        corners.append(solid.vertices)
        faces.append(solid.triangles + first)
        owners += [place] * len(solid.triangles)
    whole = palpate.SurfaceMesh(1e-3 * np.concatenate(corners), np.concatenate(faces))
    return {owners[f] for f in authoring.find_self_intersecting_faces(whole) if f not in alone}
