# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate material`: an option without effect is refused, with what would have one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from organs import make_organ
from palpate.cli.main import main
from palpate.scene.scene_parts import FILLED, KINDS, FillPart
from palpate_editor.compile import build_organ
from palpate_editor.document import EMPTY
from palpate_editor.document.constants import CONSTANTS, SURFACES
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.document.idle import find_idle
from palpate_editor.edits import SetConstant
from palpate_editor.views.command_lines import find_arguments

SPLEEN = replace(make_organ(), fill=FillPart(300))
WALLED = replace(SPLEEN, material=replace(SPLEEN.material, wall_thickness=2e-3))

IDLE = [
    # organ, options, the one refused, why, what has an effect
    (SPLEEN, "--young-modulus 6kPa", "--young-modulus: got 6 kPa",
     "springs and bonds take the stiffness that is chosen",
     "expected --kind solid with it, or a wall (--wall) and --constants tissue"),
    (SPLEEN, "--poisson 0.49", "--poisson: got 0.49", "take the stiffness that is chosen",
     "expected --kind solid with it"),
    (WALLED, "--young-modulus 6kPa", "--young-modulus: got 6 kPa", "and home springs take",
     "expected --constants tissue with it, or --home none"),
    (WALLED, "--home none --poisson 0.3", "--poisson: got 0.3", "take the stiffness that is chosen",
     "expected --constants tissue with it"),
    (WALLED, "--constants tissue --stiffness 5N/m", "--stiffness: got 5 N/m",
     "the tissue gives springs and bonds their constants", "--constants chosen with it"),
    (SPLEEN, "--kind solid --stiffness 400N/m", "--stiffness: got 400 N/m",
     "Young's modulus and Poisson's ratio give this model its constants",
     "expected --young-modulus and --poisson"),
    (SPLEEN, "--bend 1mJ", "--bend: got 1 mJ", "Mass–spring (MSS) makes no use of it",
     "expected a model that uses it: --kind mms"),
    (SPLEEN, "--kind solid --home 0N/m3", "--home: got 0 N/mm³", "fixed vertices hold it",
     "expected --fix-lowest"),
    (SPLEEN, "--kind linear --relaxation 0.5", "--relaxation: got 0.5",
     "Linear solid, shallow presses makes no use of it", "--kind mss, mms, shell or solid"),
    (SPLEEN, "--relaxation-time 0.2s", "--relaxation-time: got 0.2 s", "a relaxation of 0",
     "--relaxation above 0 with it"),
    (SPLEEN, "--tetrahedra 900", "--tetrahedra: got 900", "makes no use of it",
     "--kind solid, linear, corotated or neo-hookean"),
    (SPLEEN, "--angle-law eq10", "--angle-law: got eq10", "makes no use of it", "--kind mms"),
    (SPLEEN, "--spring-rule lloyd", "--spring-rule: got lloyd", "stiffness that is chosen",
     "--constants tissue with it"),
    (SPLEEN, "--kind solid --constants chosen", "--constants: got chosen", "its constants",
     "--kind mss or mms with it"),
    (SPLEEN, "--kind solid --reach hilum", "--reach: got hilum", "makes no use of it",
     "--kind linear with it"),
]  # fmt: skip


@pytest.fixture
def file(tmp_path):
    return tmp_path / "a.organ"


@pytest.mark.parametrize(("organ", "options", "what", "why", "instead"), IDLE)
def test_an_option_without_effect_is_refused_with_what_would_have_one(
    organ, options, what, why, instead, file, capsys
):
    write_organ(file, organ)
    before = file.read_bytes()

    assert main(["material", str(file), *options.split(), "-o", str(file)]) == 1

    said = capsys.readouterr().err
    assert f"{file}: {what}, which has no effect here: " in said
    assert why in said and instead in said
    assert file.read_bytes() == before


@pytest.mark.parametrize(
    ("organ", "options"),
    [
        (WALLED, "--home none --young-modulus 6kPa"),
        (WALLED, "--constants tissue --young-modulus 6kPa --poisson 0.3"),
        (SPLEEN, "--kind solid --young-modulus 6kPa --poisson 0.3 --constants tissue"),
        (SPLEEN, "--kind mms --bend 1mJ --angle-law eq10"),
        (SPLEEN, "--relaxation 0.5 --relaxation-time 0.2s"),
        (SPLEEN, "--stiffness 60N/m --drag 3/s --gravity 0,0,-9.81"),
    ],
)
def test_an_option_that_has_an_effect_is_taken(organ, options, file, capsys):
    write_organ(file, organ)

    assert main(["material", str(file), *options.split(), "-o", str(file)]) == 0
    capsys.readouterr()


@pytest.mark.parametrize("option", ["--stiffness=60N/m", "--bend=1mJ", "--kind=mms",
                                    "--constants=tissue"])  # fmt: skip
def test_where_all_kinds_are_compared_what_each_has_of_its_own_is_refused(option, file, capsys):
    write_organ(file, WALLED)

    assert main(["material", str(file), option]) == 1

    said = capsys.readouterr().err
    assert "without --out every kind is built of the tissue" in said and "expected --out" in said


BUILT = [
    (kind, origin, walled)
    for kind in KINDS
    for origin in ("chosen", "tissue")
    for walled in (False, True)
    if (kind in FILLED) != walled and (walled or origin == "chosen" or kind in FILLED)
] + [(kind, "chosen", False) for kind in SURFACES]
"""Tissues that can be built: a solid has no wall, and a wall gives its own constants."""


@pytest.mark.parametrize("home", [None, 1e6])
@pytest.mark.parametrize(("kind", "origin", "walled"), BUILT)
def test_a_number_that_is_said_to_have_no_effect_has_none(kind, origin, walled, home):
    """And one of the tissue that is not said to has one."""
    organ = WALLED if walled else SPLEEN
    organ = replace(
        organ, model=replace(organ.model, kind=kind, constants=origin, home_stiffness=home)
    )
    before = build_organ(organ)
    for constant in CONSTANTS:
        if constant.key not in CHANGED:
            continue
        value = CHANGED[constant.key]
        after = build_organ(replace(organ, **{constant.part: replace(
            getattr(organ, constant.part), **{constant.field: value})}))  # fmt: skip
        idle = find_idle(constant, organ) is not None
        assert idle == is_same(before, after), constant.key


CHANGED = {
    "material.young_modulus": 7e3,
    "model.stiffness": 77.0,
    "model.home_stiffness": 2e6,
    "model.pressure": 50.0,
    "fill.nodal_share": 0.4,
}
"""Beside Poisson's ratio, which springs by van Gelder's rule make nothing of: a check says so."""


def is_same(one, other) -> bool:
    tables = [
        (one.springs.stiffness, other.springs.stiffness),
        (one.bonds.stiffness, other.bonds.stiffness),
        (one.angles.bend_stiffness, other.angles.bend_stiffness),
        (one.prisms.shear_stiffness, other.prisms.shear_stiffness),
        (one.volumes.bulk, other.volumes.bulk),
        (one.elastic.shear, other.elastic.shear),
        (one.elastic.nodal_share, other.elastic.nodal_share),
        (one.volumes.nodal_share, other.volumes.nodal_share),
        *(
            (getattr(getattr(one, law), column), getattr(getattr(other, law), column))
            for law in ("corotated", "neo_hookean")
            for column in ("lame", "shear", "nodal_share")
        ),
        (one.home, other.home),
        (one.pressure, other.pressure),
    ]
    return all(np.array_equal(np.asarray(a), np.asarray(b)) for a, b in tables)


def test_the_line_of_an_edit_that_repairs_an_idle_number_can_be_typed(file, capsys):
    """No form shows such a number: only the repair of one that is out of its range changes it."""
    broken = replace(SPLEEN, model=replace(SPLEEN.model, bend_stiffness=-1.0))
    edit = SetConstant("model", "bend_stiffness", EMPTY.model.bend_stiffness)
    write_organ(file, broken)

    words = find_arguments(edit, edit(broken), file)

    assert main([str(word) for word in words[1:]]) == 0
    capsys.readouterr()
    assert read_organ(file).model.bend_stiffness == EMPTY.model.bend_stiffness


def test_more_tetrahedra_than_a_file_has_room_for_are_refused_when_they_are_chosen(
    file, capsys, monkeypatch
):
    """A linear solid whose reach is small was built, checked and refused by `publish` alone."""
    monkeypatch.setattr("palpate.scenario.MOST_ELASTIC", 150)
    write_organ(file, SPLEEN)
    words = ["--kind", "linear", "--reach", "hilum", "-o", str(file)]

    assert main(["material", str(file), *words]) == 1

    said = capsys.readouterr().err
    assert "fill.tetrahedra: got " in said
    assert "expected at most 150 in a solid of this kind, which a published file has room" in said
