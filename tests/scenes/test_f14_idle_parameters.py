# SPDX-License-Identifier: BSD-3-Clause
"""F14: a parameter without effect. Each constant that counts changes what is built or felt."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
import pytest
from failure_scenes import make_ball
from palpate.files.refusal import Refusal
from palpate.scene.scene_file import read_scene_file
from palpate_editor.compile import compile_organ
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_editor.document.constants import CONSTANTS, Constant
from palpate_editor.document.idle import find_idle

MESH = make_ball()
BASE = replace(
    EMPTY,
    material=replace(EMPTY.material, wall_thickness=2e-3),
    model=replace(EMPTY.model, bend_stiffness=1e-5, stretch_coupling=1e-4, pressure=20.0,
                  relaxation=0.4, home_stiffness=3e5, contact_law="hard"),
    hand=replace(EMPTY.hand, gravity=(0.0, 0.0, -1.0)),
).with_surface(Surface(np.asarray(MESH.vertices), np.asarray(MESH.triangles)))  # fmt: skip
KINDS = {
    "mass_spring": BASE,
    "molecular": replace(BASE, model=replace(BASE.model, kind="molecular")),
    "shell": replace(
        BASE,
        model=replace(BASE.model, kind="shell", home_stiffness=0.0, pressure=0.0),
        fixed=np.asarray(MESH.vertices)[:, 2] < -0.01,
    ),
}


def describe(scene: palpate.Scene) -> list[object]:
    """All numbers that a tick reads of a scene."""
    [body], [instrument] = scene.bodies, scene.instruments
    tissue = body.tissue
    tables = (tissue.springs, tissue.bonds, tissue.angles, tissue.prisms, tissue.volumes)
    numbers = [
        np.asarray(getattr(table, name), dtype=float).ravel()
        for table in tables
        for name in dir(table)
        if not name.startswith("_") and not callable(getattr(table, name))
    ]
    numbers += [np.ravel(np.asarray(each, dtype=float)) for each in (
        tissue.mass, tissue.home, tissue.pressure, tissue.drag, tissue.maxwell.ratio,
        tissue.maxwell.time, body.substeps, body.force_error, body.contact_modulus,
        body.tear_stretch,
        instrument.tool.radius, instrument.tool.stiffness, instrument.tool.friction,
        [capsule.to for capsule in instrument.tool.capsules],
        () if instrument.trocar is None else instrument.trocar,
        instrument.coupling.stiffness, instrument.coupling.force_max, instrument.hold_stiffness,
        scene.rate, scene.exchange_rate,
    )]  # fmt: skip
    return numbers


def nudge(constant: Constant, value: float | None) -> float:
    if constant.whole:
        return int(value or 0) + 40
    for other in (1.3 * (value or 0.0), 0.7 * (value or 0.0), 0.3, 0.5 * constant.most):
        if other != value and constant.allows(other):
            return other
    raise AssertionError(constant.key)


def differ(one: list[object], other: list[object]) -> bool:
    return any(
        a.shape != b.shape or not np.array_equal(a, b) for a, b in zip(one, other, strict=True)
    )


def change(organ: Organ, constant: Constant) -> Organ:
    part = getattr(organ, constant.part)
    value = nudge(constant, getattr(part, constant.field))
    return replace(organ, **{constant.part: replace(part, **{constant.field: value})})


@pytest.mark.parametrize("kind", KINDS)
def test_f14_every_constant_that_counts_changes_the_scene_or_is_known_to_be_idle(kind):
    organ = KINDS[kind]
    before = describe(compile_organ(organ))
    unsaid = []
    for constant in CONSTANTS:
        if constant.part == "fill":
            continue
        changed = change(organ, constant)
        try:
            after = describe(compile_organ(changed))
        except ValueError:  # refused, which is no silence
            continue
        if differ(after, before):
            continue
        idle = find_idle(constant, changed)
        if constant.counts(organ.model) and idle is None:
            unsaid.append(constant.key)

    assert unsaid == []


def test_f14_a_field_that_no_scene_has_is_refused_by_name(tmp_path):
    path = tmp_path / "a.scene.json"
    path.write_text(
        '{"format": "palpate scene", "version": 2, "organ": {"name": "a", "mesh": "a.obj", '
        '"sha256": "0"}, "model": {"stifness": 60.0}}',
        encoding="utf-8",
    )

    with pytest.raises(Refusal, match="stifness"):
        read_scene_file(path)
