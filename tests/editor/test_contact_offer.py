# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of before play as they did, and are offered the near field with the forces of both laws."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.runs.press import Place
from palpate.runs.trial import LONG_HOLD, LONG_MEAN, SPEED, press_places, with_contact
from palpate.scene.scene_parts import FillPart
from palpate_editor.app.session import Session
from palpate_editor.check import assess
from palpate_editor.compile import compile_organ
from palpate_editor.document.files import read_organ
from palpate_editor.edits import SetChoice

KEPT = Path(__file__).parents[1] / "scenes" / "published"
OLD = read_organ(KEPT / "solid_v6.organ")
FELT = json.loads((KEPT / "solid_v6.json").read_text(encoding="utf-8"))
UPGRADE = SetChoice("contact_law", "near_field")


@pytest.fixture(scope="module")
def old():
    return assess(OLD)


def press(organ, depth: float = FELT["depth_m"]) -> list[float]:
    """[N] at the places of the file to keep."""
    places = [Place(np.array(p["point_m"]), np.array(p["outward"])) for p in FELT["places"]]
    trials = press_places(compile_organ(organ), places, LONG_HOLD, depth, LONG_MEAN)
    return [trial.force for trial in trials]


def test_an_old_solid_plays_as_before_until_the_near_field_is_chosen():
    before = [place["force_N"] for place in FELT["places"]]

    assert OLD.model.contact_law == "hard"
    assert press(OLD) == pytest.approx(before, rel=0.01)
    assert press(UPGRADE(OLD)) != pytest.approx(before, rel=0.3)


def test_the_offer_has_the_forces_of_both_laws_as_they_are_pressed_by_hand(old):
    offer = old.facts.tissue.trial.offer

    assert len(offer) == 5
    near = with_contact(old.scene, compile_organ(UPGRADE(OLD)).bodies[0].contact_modulus)
    for place, kept in zip(offer, FELT["places"], strict=True):
        assert place.point == pytest.approx(kept["point_m"], abs=1e-8)
    for scene, column in ((old.scene, 0), (near, 1)):
        by_hand = press_by_hand(scene, FELT["places"][1])
        assert offer[1].forces[column] == pytest.approx(by_hand, rel=1e-6)
    assert [place.forces[1] for place in offer] == pytest.approx(press(UPGRADE(OLD)), rel=1e-6)


def press_by_hand(scene: palpate.Scene, place: dict) -> float:
    """[N] the mean of what a hand feels along the outward direction at the end of its hold."""
    point, outward = np.array(place["point_m"]), np.array(place["outward"])
    world, sample, felt = palpate.World(scene), palpate.HapticSample(), []
    way = FELT["depth_m"] + 2e-4  # from 0.2 mm over the surface
    down = int(np.ceil(way / SPEED * scene.rate))
    for tick in range(1, down + round(LONG_HOLD * scene.rate) + 1):
        below = way * min(1.0, tick / down) - 2e-4
        sample.position = point + outward * (scene.instruments[0].tool.radius - below)
        command = palpate.tick(scene, sample, 1.0 / scene.rate, world)
        felt.append(float(np.asarray(command.force) @ outward))
    return float(np.mean(felt[-round(LONG_MEAN * scene.rate) :]))


def test_comparing_leaves_the_scene_as_it_is(old):
    assert old.scene.bodies[0].contact_modulus == 0.0 and old.scene.bodies[0].near_field is None


def test_undo_takes_the_near_field_back_with_its_forces(old):
    session = Session()
    session.restore(OLD, None)

    session.apply(UPGRADE)
    changed = session.organ
    session.history.undo()

    assert changed.model.contact_law == "near_field"
    assert assess(changed).facts.tissue.trial.offer == ()
    assert session.organ.model == OLD.model
    again = assess(session.organ).facts.tissue.trial.offer
    assert [p.forces for p in again] == [p.forces for p in old.facts.tissue.trial.offer]


def test_a_surface_has_no_other_law_to_be_offered():
    model = replace(OLD.model, kind="mass_spring", contact_law="hard")

    assert assess(replace(OLD, model=model)).facts.tissue.trial.offer == ()


def test_a_wall_with_the_hard_law_is_offered_the_near_field_too():
    model = replace(OLD.model, kind="shell", contact_law="hard", home_stiffness=None)
    organ = replace(OLD, model=model, material=replace(OLD.material, wall_thickness=3e-3))

    offer = assess(organ).facts.tissue.trial.offer
    assert offer and all(near > 0.0 and hard > 0.0 for hard, near in (p.forces for p in offer))
    assert assess(UPGRADE(organ)).facts.tissue.trial.offer == ()


def test_a_solid_whose_tick_takes_too_long_is_not_pressed_to_be_offered_anything(monkeypatch):
    monkeypatch.setattr("palpate_editor.trial.LONGEST_TICK", 1e-9)

    assert assess(replace(OLD, fill=FillPart(300))).facts.tissue.trial.offer == ()


# --- the verbs -------------------------------------------------------------------------------


def test_check_prints_the_forces_of_both_laws_place_by_place(old, capsys):
    assert main(["check", str(KEPT / "solid_v6.organ"), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert main(["check", str(KEPT / "solid_v6.organ")]) == 0
    said = capsys.readouterr().out

    assert report["contact_law"] == "hard"
    forces = [(p["hard_force_N"], p["near_field_force_N"]) for p in report["places"]]
    assert forces == [place.forces for place in old.facts.tissue.trial.offer]
    assert "pressed 3 mm a hand feels by it, and by the near field:" in said
    rows = [line.split("  ") for line in said.splitlines() if line.count(", ") == 2]
    shown = [[cell.strip() for cell in row if cell.strip()][2:4] for row in rows[:5]]
    assert shown == [[f"{1e3 * hard:.0f}", f"{1e3 * near:.0f}"] for hard, near in forces]


def test_a_repaired_file_has_the_near_field_and_check_offers_nothing_more(tmp_path, capsys):
    out = tmp_path / "new.organ"
    call = ["repair", str(KEPT / "solid_v6.organ"), "--problem", "coarse_contact", "-o", str(out)]

    assert main(call) == 0, capsys.readouterr()
    capsys.readouterr()
    assert main(["check", str(out), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)

    assert report["contact_law"] == "near_field"
    assert all(place["hard_force_N"] is None for place in report["places"])
    assert "coarse_contact" not in [problem["problem"] for problem in report["problems"]]
