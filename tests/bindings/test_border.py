# SPDX-License-Identifier: BSD-3-Clause
"""Kernels check nothing, so the border does: a wrong call raises and never reaches a kernel."""

from __future__ import annotations

import pickle

import numpy as np
import palpate
import pytest
from surfaces import chain, organ_scene, sheet


def test_a_refused_argument_is_a_value_error_that_says_where_what_and_expected():
    with pytest.raises(ValueError) as caught:
        palpate.validate(palpate.Material(density=-1.0))

    assert "density" in str(caught.value)
    assert "-1" in str(caught.value)


def test_a_refused_file_is_an_os_error_with_its_four_fields(tmp_path):
    path = tmp_path / "noise.prec"
    path.write_bytes(b"this is no record" * 50)

    with pytest.raises(palpate.FileError) as caught:
        palpate.read_record(path)

    error = caught.value
    assert isinstance(error, OSError)
    assert error.file == str(path)
    assert error.got and error.expected
    assert str(error).startswith(str(path))
    assert f"got {error.got}, expected {error.expected}" in str(error)


def test_a_file_error_made_in_python_is_no_other_than_one_from_cpp():
    error = palpate.FileError("liver.obj", "line 3", "two numbers", "three")

    assert str(error) == "liver.obj: line 3: got two numbers, expected three"
    assert (error.file, error.where, error.got, error.expected) == (
        "liver.obj", "line 3", "two numbers", "three")  # fmt: skip


def test_a_file_error_crosses_process_borders():
    error = pickle.loads(pickle.dumps(palpate.FileError("a.prec", "", "nothing", "a record")))

    assert type(error) is palpate.FileError
    assert str(error) == "a.prec: got nothing, expected a record"


def test_a_device_error_is_an_os_error():
    assert issubclass(palpate.DeviceError, OSError)


@pytest.mark.parametrize("shape", [(3,), (3, 2), (3, 3, 1)])
def test_points_must_be_rows_of_three(shape):
    with pytest.raises(ValueError, match=r"expected numbers of shape \(n, 3\)"):
        palpate.compute_diagonal(np.zeros(shape))


def test_indices_are_never_rounded_from_floats():
    with pytest.raises(TypeError):
        palpate.SurfaceMesh(np.zeros((3, 3)), np.array([[0.0, 1.0, 2.5]]))


@pytest.mark.parametrize("triangle", [(0, 1, 3), (0, 1, -1), (0, 1, 2**40)])
def test_an_index_out_of_range_is_refused(triangle):
    with pytest.raises(ValueError, match="triangles"):
        palpate.SurfaceMesh(np.zeros((3, 3)), [triangle])


def test_a_model_from_tables_is_validated():
    links = palpate.Links([(0, 5)], [0.01], [100.0], [0.0])

    with pytest.raises(ValueError):
        palpate.TissueModel(rest_position=np.zeros((2, 3)), mass=[1, 1], springs=links)


def test_links_must_fit_the_points_they_pull_on():
    links = palpate.Links([(0, 5)], [0.01], [100.0], [0.0])
    x = np.zeros((2, 3))

    with pytest.raises(ValueError, match="links.ends 0: got index 5, expected below 2"):
        palpate.accumulate_link_forces(links, palpate.DampingLaw.axis, x, x, np.zeros((2, 3)))


def test_links_must_have_as_many_of_everything():
    links = palpate.Links([(0, 1)], [0.01], [100.0, 2.0], [0.0])
    x = np.zeros((2, 3))

    with pytest.raises(ValueError, match="links.stiffness"):
        palpate.accumulate_link_forces(links, palpate.DampingLaw.axis, x, x, np.zeros((2, 3)))


def test_a_step_refuses_the_state_of_another_model():
    with pytest.raises(ValueError, match="state: got 4 entries, expected 3"):
        palpate.step(chain(3), palpate.Load(), 1e-4, palpate.State(chain(4)))


@pytest.mark.parametrize("dt", [0.0, -1e-3, float("nan"), float("inf")])
def test_a_step_takes_a_positive_time(dt):
    model = chain(3)

    with pytest.raises(ValueError, match="dt"):
        palpate.step(model, palpate.Load(), dt, palpate.State(model))


def test_an_implicit_integrator_is_sent_to_its_stepper():
    model = chain(3)

    with pytest.raises(ValueError, match="implicit_euler"):
        palpate.step(
            model, palpate.Load(), 1e-4, palpate.Integrator.implicit_euler, palpate.State(model)
        )


def test_a_push_on_a_triangle_that_is_not_there_is_refused():
    model = chain(3)
    load = palpate.Load(1)
    load.add(palpate.Push(0, (1, 0, 0), (0, 0, 1)))

    with pytest.raises(ValueError, match="push: got triangle 0, expected below 0"):
        palpate.step(model, load, 1e-4, palpate.State(model))


def test_a_tree_refuses_positions_it_was_not_built_over():
    mesh = sheet(3, 0.02)
    tree = palpate.AabbTree(mesh.vertices, mesh.triangles)

    with pytest.raises(ValueError):
        tree.refit(mesh.vertices[:5])
    with pytest.raises(ValueError):
        palpate.find_closest_point(tree, mesh.vertices[:5], (0, 0, 0))


def test_ticks_want_a_scene_that_has_been_built():
    raw = palpate.make_scene(organ_scene(1).bodies[0].tissue)

    with pytest.raises(ValueError, match="build_scene"):
        palpate.World(raw)
    with pytest.raises(ValueError, match="build_scene"):
        palpate.Loop(raw, palpate.PointerDevice())


def test_a_tick_refuses_the_world_of_another_scene():
    small, large = organ_scene(1), organ_scene(2)

    with pytest.raises(ValueError):
        palpate.tick(large, palpate.HapticSample(), 1e-3, palpate.World(small))


def test_python_cannot_make_a_device_of_its_own():
    class Mine(palpate.HapticDevice):
        pass

    with pytest.raises(TypeError):
        Mine()


def test_a_negative_capacity_is_refused():
    with pytest.raises(ValueError, match="capacity"):
        palpate.Load(-1)
