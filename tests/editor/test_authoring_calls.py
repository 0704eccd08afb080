# SPDX-License-Identifier: GPL-3.0-or-later
"""What the compiled module of the editor does not take is refused as the library refuses it."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate_editor import _authoring, authoring
from palpate_meshes.generate import ellipsoid

MESH = palpate.SurfaceMesh(*ellipsoid(200))


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (
            lambda: authoring.decimate(MESH, "many"),
            "decimate: vertex_count: got str 'many', expected a whole number",
        ),
        (
            lambda: authoring.decimate(np.zeros((3, 3)), 100),
            "decimate: mesh: got float64 of shape (3, 3), expected SurfaceMesh",
        ),
        (
            lambda: authoring.fill_interior(MESH),
            "fill_interior: cell_size: got nothing, expected a number",
        ),
        (
            lambda: authoring.fill_holes(MESH, ["first"]),
            "fill_holes: holes: got list ['first'], expected Sequence[a whole number]",
        ),
        (
            lambda: authoring.join_parts(MESH),
            "join_parts: scene: got SurfaceMesh(200 vertices, 396 triangles), expected",
        ),
        (
            lambda: authoring.inspect_mesh(surface=MESH),
            "inspect_mesh: got an argument 'surface', expected mesh",
        ),
        (
            lambda: _authoring.MeshReport.__new__(_authoring.MeshReport).vertices,
            "MeshReport.vertices: got an object made by __new__ alone",
        ),
        (
            lambda: pickle.dumps(authoring.inspect_mesh(MESH)),
            "MeshReport: got what runs, or holds what it cannot share",
        ),
    ],
)
def test_a_call_that_cannot_be_is_refused_in_one_sentence(call, sentence):
    with pytest.raises(TypeError) as refused:
        call()

    said = str(refused.value)
    assert said.startswith(sentence) and "\n" not in said and "SupportsInt" not in said
    assert "expected" in said


def test_a_class_of_the_editor_is_known_to_a_refusal():
    with pytest.raises(TypeError, match="join_parts: scene: got None, expected ImportedScene"):
        authoring.join_parts(None)


def test_no_name_is_spelled_as_a_constant_of_cpp():
    assert [name for name in vars(_authoring) if name[0] == "k" and name[1].isupper()] == []
    assert _authoring.MOST_TETRAHEDRA > _authoring.MOST_HOLE_EDGES > 0


def test_what_is_bound_has_words_and_the_stub_has_all_of_it():
    written = Path(_authoring.__file__).with_name("_authoring.pyi").read_text(encoding="utf-8")

    names = [name for name in vars(_authoring) if not name.startswith("_")]
    assert len(names) > 15
    missing = [name for name in names if f" {name}(" not in written and f"{name}:" not in written]
    assert missing == []
    called = [name for name in names if callable(getattr(_authoring, name))]
    assert [name for name in called if not getattr(_authoring, name).__doc__] == []
