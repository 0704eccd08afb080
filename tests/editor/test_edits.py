# SPDX-License-Identifier: GPL-3.0-or-later
"""Every edit, held to the same laws; what each does by itself is in test_what_edits_do."""

from __future__ import annotations

import importlib
import pkgutil
from dataclasses import fields, is_dataclass, replace

import numpy as np
import pytest
from organs import (
    SOURCE,
    TISSUES,
    fin,
    make_organ,
    moebius,
    nested,
    open_surface,
    same,
    same_value,
    surface_of,
    two_shells,
)
from palpate.scene.scene_parts import MaterialPart, ModelPart
from palpate_editor import authoring, edits
from palpate_editor.app.session import Session
from palpate_editor.compile import mesh_of
from palpate_editor.document import EMPTY, Decimation, Organ, Surface
from palpate_editor.edits import EVERY_EDIT, EditError
from palpate_editor.edits.configure import find_configuration

SPLEEN = make_organ()
IN_PIECES = replace(make_organ().with_surface(two_shells()), imported=None)
INSIDE_OUT = replace(
    SPLEEN, surface=Surface(SPLEEN.surface.vertices, SPLEEN.surface.triangles[:, ::-1])
)
OPEN = replace(
    make_organ(imported=None).with_surface(
        Surface(SPLEEN.surface.vertices, SPLEEN.surface.triangles[1:])
    ),
    imported=None,
)
NESTED = replace(make_organ().with_surface(nested()), imported=None)
WITH_A_FIN = replace(make_organ().with_surface(fin()), imported=None)
ONE_SIDED = replace(make_organ().with_surface(moebius()), imported=None)
UNWELDED = replace(
    make_organ(imported=None).with_surface(
        Surface(
            SPLEEN.surface.vertices[SPLEEN.surface.triangles].reshape(-1, 3),
            np.arange(3 * len(SPLEEN.surface.triangles)).reshape(-1, 3),
        )
    ),
    imported=None,
)


def pull_through(surface: Surface) -> Surface:
    """The first vertex that crosses something where it reaches out through the other side."""
    for i in range(len(surface.vertices)):
        x, middle = surface.vertices.copy(), surface.vertices.mean(axis=0)
        x[i] = middle - 1.2 * (x[i] - middle)
        pulled = Surface(x, surface.triangles)
        if authoring.find_self_intersecting_faces(mesh_of(pulled)):
            return pulled
    raise AssertionError("nothing crosses")


BALL = surface_of(150)
ON_A_BALL = replace(
    make_organ().with_surface(
        Surface(
            np.vstack([BALL.vertices, 1.5 * BALL.vertices[:1]]),
            np.vstack([BALL.triangles, [*BALL.triangles[0, :2], len(BALL.vertices)]]),
        )
    ),
    imported=None,
)
CROSSED = replace(make_organ().with_surface(pull_through(surface_of(150))), imported=None)
DOUBLED = replace(
    make_organ().with_surface(
        Surface(
            np.vstack([BALL.vertices, 0.5 * BALL.vertices]),
            np.vstack([BALL.triangles, BALL.triangles + len(BALL.vertices)]),
        )
    ),
    imported=None,
)
COARSE = surface_of(50)
OWN = find_configuration(SPLEEN)
DECIMATION = Decimation(150, 296, 50, 96, 30.0, 1e-4, 2e-4)

EXAMPLES = [
    (edits.ImportMesh("liver", SOURCE, surface_of(80)), SPLEEN),
    (edits.SetAssessment('{"palpate_scenario": 1}'), SPLEEN),
    (edits.SetUnit("cm"), SPLEEN),
    (edits.SetUp("y"), SPLEEN),
    (edits.KeepOuter(), NESTED),
    (edits.KeepLargestShell(), IN_PIECES),
    (edits.TurnOutward(), INSIDE_OUT),
    (edits.CutCrowdedEdges(), WITH_A_FIN),
    (edits.CutDisagreement(), ONE_SIDED),
    (edits.UniteShells(), IN_PIECES),
    (edits.FillHoles(), OPEN),
    (edits.FillHoles(even=True, bent=True), OPEN),
    (edits.CapHoles(), OPEN),
    (edits.CleanUp(), INSIDE_OUT),
    (edits.StitchBorders(), UNWELDED),
    (edits.DropFins(), ON_A_BALL),
    (edits.DropPieces(0.4), IN_PIECES),
    (edits.DropDoubled(), DOUBLED),
    (edits.RemoveCrossings(), CROSSED),
    (edits.Smooth(3), SPLEEN),
    (edits.Wrap(), SPLEEN),
    (edits.Wrap(past_holes=True), SPLEEN),
    (edits.RepairAll(), OPEN),
    (edits.Remesh(0.01), SPLEEN),
    (edits.Decimate(SPLEEN.imported, COARSE, DECIMATION), SPLEEN),
    (edits.DecimateTo(50), SPLEEN),
    (edits.UseImported(), SPLEEN),
    (edits.SetChoice("kind", "molecular"), SPLEEN),
    (edits.SetConstant("model", "stiffness", 33.0), SPLEEN),
    (edits.SetGravity((0.0, 9.81, 0.0)), SPLEEN),
    (edits.SetMaterial(MaterialPart(density=900.0), ModelPart(stiffness=10.0)), SPLEEN),
    (
        edits.Configure(replace(OWN, kind="solid", tetrahedra=900, substeps=4)),
        replace(SPLEEN, fill=replace(SPLEEN.fill, tetrahedra=900)),
    ),
    (edits.SetFarField(None), SPLEEN),
    (edits.SetReach(""), SPLEEN),
    (edits.SetFineRegion("hilum"), SPLEEN),
    (edits.SetTissue(replace(TISSUES[0], density=1040.0)), replace(SPLEEN, tissues=())),
    (edits.FixVertices(np.array([20, 30])), SPLEEN),
    (edits.FixLowest(0.3), SPLEEN),
    (edits.PaintStiffness(np.array([1, 2]), 2.5), SPLEEN),
    (edits.SetRegion("kapı", np.array([9, 3])), SPLEEN),
    (edits.RemoveRegion("hilum"), SPLEEN),
    (edits.SetName("karaciğer"), SPLEEN),
    (edits.SetTask("Title", "Task"), SPLEEN),
    (edits.SetAppearance("liver", (0.2, 0.3, 0.4)), SPLEEN),
    (edits.prepare(edits.UseImported(), SPLEEN), SPLEEN),
]
ids = [type(edit).__name__ for edit, _ in EXAMPLES]
every = pytest.mark.parametrize(("edit", "organ"), EXAMPLES, ids=ids)


def test_every_edit_has_an_example_here():
    assert {type(edit) for edit, _ in EXAMPLES} == set(EVERY_EDIT)
    offered = {getattr(edits, name) for name in edits.__all__}
    made_by_hand = {kind for kind in offered if is_dataclass(kind)}
    assert made_by_hand == set(EVERY_EDIT)


@every
def test_undo_gives_back_the_very_same_organ(edit, organ):
    session = Session(organ)

    session.apply(edit)
    after = session.organ
    session.history.undo()
    undone = session.organ
    session.history.redo()

    assert after is not organ
    assert undone is organ
    assert session.organ is after


@every
def test_an_edit_leaves_the_organ_it_was_given_as_it_was(edit, organ):
    before = replace(organ, fixed=organ.fixed.copy(), stiffness_scale=organ.stiffness_scale.copy())

    edit(organ)

    assert same(organ, before)


@every
def test_an_edit_shares_with_the_old_organ_what_it_did_not_change(edit, organ):
    after = edit(organ)

    changed = {
        f.name for f in fields(Organ) if getattr(after, f.name) is not getattr(organ, f.name)
    } - {"history"}
    assert changed
    if not {"surface", "imported"} & changed:
        assert len(changed) <= 3


@every
def test_an_edit_leaves_one_line_by_which_it_is_done_again(edit, organ):
    organ = edits.SetTask("before")(organ)

    after = edit(organ)

    assert after.history.lines[:-1] == (organ.history.lines if not begins(edit) else ())
    line = after.history.lines[-1]
    again = edits.read_line(line, edits.LINES, "a.organ", "history")
    if not isinstance(edit, edits.Decimate):  # the surface of its example is another
        assert same(again(organ), after)
    assert same_value(edits.write_line(again), line)


def begins(edit) -> bool:
    return isinstance(edit, edits.ImportMesh)


@every
def test_an_edit_is_a_frozen_value_with_a_title(edit, organ):
    assert edit.title[0].isupper()
    with pytest.raises(AttributeError):
        edit.title = "other"


@every
def test_what_an_edit_made_cannot_be_written(edit, organ):
    after = edit(organ)

    for array in (after.fixed, after.stiffness_scale, after.surface.vertices):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


NEEDS_A_SURFACE = [
    edits.SetUnit("cm"),
    edits.SetUp("y"),
    edits.KeepOuter(),
    edits.KeepLargestShell(),
    edits.TurnOutward(),
    edits.CutCrowdedEdges(),
    edits.CutDisagreement(),
    edits.UseImported(),
    edits.FixVertices(np.array([0])),
    edits.FixLowest(0.1),
    edits.PaintStiffness(np.array([0]), 2.0),
]


@pytest.mark.parametrize("edit", NEEDS_A_SURFACE, ids=lambda e: type(e).__name__)
def test_an_edit_of_a_surface_says_so_where_there_is_none(edit):
    with pytest.raises(EditError, match="import a mesh file first"):
        edit(EMPTY)


REFUSED = [
    (edits.SetUnit("parsec"), SPLEEN, "The unit must be one of m, cm"),
    (edits.SetUp("w"), SPLEEN, "The axis must be one of z, y"),
    (edits.SetUnit("mm"), replace(SPLEEN, source=None), "not read from a file"),
    (edits.KeepOuter(), SPLEEN, "No piece of the surface lies inside"),
    (edits.KeepOuter(), IN_PIECES, "No piece of the surface lies inside"),
    (edits.KeepLargestShell(), SPLEEN, "one piece already"),
    (edits.TurnOutward(), SPLEEN, "outwards already"),
    (edits.TurnOutward(), EMPTY.with_surface(open_surface()), "no outside"),
    (edits.Decimate(surface_of(150), COARSE, DECIMATION), SPLEEN, "changed since"),
    (edits.UseImported(), make_organ(imported=None), "in use already"),
    (
        edits.SetChoice("kind", "jelly"),
        SPLEEN,
        "one of mass_spring, molecular, shell, solid, linear_solid, corotated_solid, "
        "neo_hookean_solid, got jelly",
    ),
    (edits.SetChoice("colour", "red"), SPLEEN, "colour must be one of none"),
    (edits.SetConstant("model", "colour", 1.0), SPLEEN, "no number model.colour"),
    (edits.SetConstant("model", "stiffness", 0.0), SPLEEN, "more than 0 N/m, got 0 N/m"),
    (edits.SetConstant("model", "stiffness", np.nan), SPLEEN, "Stiffness must be"),
    (edits.SetConstant("model", "stiffness", None), SPLEEN, "got none"),
    (edits.SetConstant("material", "wall_thickness", -1e-3), SPLEEN, "more than 0 mm, got -1 mm"),
    (edits.SetConstant("material", "poisson_ratio", 0.6), SPLEEN, "must be 0 to 0.5"),
    (edits.SetGravity((0.0, 0.0, np.inf)), SPLEEN, "three finite numbers"),
    (edits.SetGravity((0.0, 0.0)), SPLEEN, "three finite numbers"),
    (edits.SetMaterial(MaterialPart(density=0.0), ModelPart()), SPLEEN, "Density must be"),
    (edits.SetMaterial(MaterialPart(), ModelPart(kind="jelly")), SPLEEN, "kind must be one of"),
    (edits.Configure(OWN), EMPTY, "import a mesh file first"),
    (edits.Configure(OWN), SPLEEN, "has that configuration already"),
    (edits.Configure(replace(OWN, integrator="leapfrog")), SPLEEN, "integrator must be one of"),
    (edits.Configure(replace(OWN, kind="solid")), SPLEEN, "Tetrahedra must be"),
    (edits.Configure(replace(OWN, substeps=-1)), SPLEEN, "Least substeps must be"),
    (edits.Configure(replace(OWN, stiffness=np.nan)), SPLEEN, "Stiffness must be"),
    (edits.Configure(replace(OWN, vertices=151)), SPLEEN, "cannot be decimated to 151 vertices"),
    (edits.FixVertices(np.array([], int)), SPLEEN, "No vertices are selected"),
    (edits.FixVertices(np.array([-1])), SPLEEN, "Vertex numbers: got -1 to -1"),
    (edits.FixVertices(np.array([60])), SPLEEN, "got 60 to 60, expected 0 to 59"),
    (edits.FixVertices(np.array([0.5])), SPLEEN, "whole numbers"),
    (edits.FixVertices(np.array([0, 1])), SPLEEN, "fixed already"),
    (edits.FixVertices(np.array([40]), False), SPLEEN, "None of them is fixed"),
    (edits.FixLowest(0.0), SPLEEN, "more than 0 and at most 1"),
    (edits.FixLowest(np.nan), SPLEEN, "more than 0 and at most 1"),
    (edits.PaintStiffness(np.array([0]), 0.0), SPLEEN, "between 0.05 and 20, got 0"),
    (edits.PaintStiffness(np.array([0, 1]), np.array([1.0, np.nan])), SPLEEN, "got nan"),
    (
        edits.PaintStiffness(np.array([0, 1]), np.ones(3)),
        SPLEEN,
        "got 3, expected 2, one for each vertex",
    ),
    (edits.PaintStiffness(np.arange(2), SPLEEN.stiffness_scale[:2]), SPLEEN, "already"),
    (edits.SetRegion(" ", np.array([1])), SPLEEN, "needs a name"),
    (edits.SetRegion("x" * 101, np.array([1])), SPLEEN, "101 bytes"),
    (edits.SetRegion("x", np.array([60])), SPLEEN, "got 60 to 60, expected 0 to 59"),
    (edits.RemoveRegion("kapı"), SPLEEN, "no region kapı"),
    (edits.SetName("x" * 201), SPLEEN, "got 201 bytes of text, expected at most 200"),
    (edits.SetName("\udcff"), SPLEEN, "cannot be written"),
    (edits.SetTask("x" * 201), SPLEEN, "title: got 201 bytes"),
    (edits.SetTask(task="ı" * 10001), SPLEEN, "task: got 20002 bytes"),
    (edits.DecimateTo(50, 1e-5), SPLEEN, "mm from the source, not within 0.01 mm"),
]


@pytest.mark.parametrize(
    ("edit", "organ", "sentence"), REFUSED, ids=[f"{i}-{r[2][:20]}" for i, r in enumerate(REFUSED)]
)
def test_a_refused_edit_changes_nothing_and_says_why(edit, organ, sentence):
    session = Session(organ)

    with pytest.raises(EditError) as refusal:
        session.apply(edit)

    assert sentence in str(refusal.value)
    assert refusal.value.sentence.template.format(**refusal.value.sentence.values) == str(
        refusal.value
    )
    assert session.organ is organ
    assert session.history.count() == 0


def test_every_edit_that_there_is_can_be_a_line_of_a_history():
    """One that is not listed leaves no line, and the organ cannot be made again."""
    found = set()
    for module in pkgutil.iter_modules(edits.__path__, edits.__name__ + "."):
        for kind in vars(importlib.import_module(module.name)).values():
            own = isinstance(kind, type) and kind.__module__ == module.name
            if own and isinstance(vars(kind).get("title"), str):
                found.add(kind)

    assert found and found <= set(EVERY_EDIT)
