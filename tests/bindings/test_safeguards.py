# SPDX-License-Identifier: BSD-3-Clause
"""A run that safeguards hold together says so, and which element it began at."""

from __future__ import annotations

import json
from types import SimpleNamespace

import numpy as np
import palpate
import pytest
from palpate.runs.alarms import say_safeguard, tell_averted
from palpate.runs.element import cut_hand, find_element
from palpate.runs.live import LiveRun
from palpate.runs.run import run_device
from surfaces import organ_scene, press_frames

AlarmKind, Safeguard = palpate.AlarmKind, palpate.Safeguard


def make_coarse(times: float = 1.5) -> palpate.Scene:
    """One substep in the air, so many times as long as the tissue is stable with."""
    scene = organ_scene(2)
    limit = palpate.stable_step(scene.bodies[0].tissue) / 0.9
    scene.bodies[0].substeps, scene.bodies[0].substeps_max = 1, 32
    scene.rate = 1.0 / (times * limit)
    return scene


def run_live(scene: palpate.Scene, path) -> tuple[palpate.LoopReport, set[Safeguard]]:
    seen = set()
    options = palpate.LoopOptions(duration=1.0)
    run = LiveRun(scene, palpate.ScriptedDevice(press_frames()), record=path, options=options)
    with run:
        while run.running:
            frame = run.take_frame()
            if frame is not None:
                seen.update(frame.safeguards)
            run.wait(0.002)
    return run.finish(), seen


def test_frames_report_and_record_tell_of_a_safeguard_and_a_replay_takes_it_again(tmp_path):
    scene, path = make_coarse(), tmp_path / "held.prec"

    report, seen = run_live(scene, path)

    assert report.alarm.kind is AlarmKind.none
    assert Safeguard.half_steps in seen
    assert 0 < report.safeguarded_ticks < report.ticks
    assert report.averted.kind is not AlarmKind.none and report.averted_body == 0
    record = palpate.read_record(str(path))
    told = [row for row in record.events if row["kind"] == palpate.EventKind.safeguard]
    assert told[0]["index"] == Safeguard.half_steps
    assert palpate.replay(scene, record).equal
    said = tell_averted(report, scene)
    assert said.startswith(f"{report.safeguarded_ticks} of {report.ticks} ticks needed")
    assert "substeps" in said


def test_a_sound_run_needs_no_safeguard_and_says_nothing(tmp_path):
    scene = organ_scene(2)

    report, seen = run_live(scene, tmp_path / "sound.prec")

    assert seen == {Safeguard.none}
    assert report.safeguarded_ticks == 0 and report.averted_body == -1
    assert tell_averted(report, scene) == ""


def test_a_world_that_is_not_to_recover_raises_the_alarm():
    scene = make_coarse()
    ends = []
    for recovers in (True, False):
        world = palpate.World(scene, recovers=recovers)
        hand = palpate.ScriptedDevice(press_frames())
        for tick in range(600):
            palpate.tick(scene, hand.read(tick / scene.rate), 1.0 / scene.rate, world)
        ends.append(world.alarm.kind)

    assert ends[0] is AlarmKind.none
    assert ends[1] is not AlarmKind.none


def test_every_safeguard_has_a_sentence():
    told = [say_safeguard(each, lambda _, text: text) for each in Safeguard]

    assert told[0] == "" and len(set(told)) == len(Safeguard)


def alarm_of(kind: palpate.AlarmKind, index: int) -> palpate.Alarm:
    alarm = palpate.Alarm()
    alarm.kind, alarm.index = kind, index
    return alarm


def test_an_alarm_is_of_a_particle_or_a_link_at_its_place():
    scene = organ_scene(1)
    tissue = scene.bodies[0].tissue
    x, ends = np.asarray(tissue.rest_position), np.asarray(tissue.springs.ends)

    far = find_element(scene, alarm_of(AlarmKind.moved_far, 5), 0)
    link = find_element(scene, alarm_of(AlarmKind.collapsed, 7), 0)

    assert (far.name, link.name) == ("particle", "link")
    assert far.place == pytest.approx(x[5])
    assert link.place == pytest.approx(x[ends[7]].mean(axis=0))
    assert find_element(scene, alarm_of(AlarmKind.collapsed, 10**6), 0) is None
    assert find_element(scene, alarm_of(AlarmKind.moved_far, 5), -1) is None
    assert find_element(scene, alarm_of(AlarmKind.energy, -1), 0) is None


def test_an_alarm_of_energy_is_where_most_of_it_is(tmp_path):
    scene, path = organ_scene(2, stiffness=400.0), tmp_path / "blown.prec"
    scene.instruments[0].tool.stiffness = 3e10
    file = tmp_path / "scene"
    file.write_text("", encoding="utf-8")

    with pytest.raises(RuntimeError, match=r"It began (at the point|in the link) at") as ended:
        run_device(scene, palpate.ScriptedDevice(press_frames()), 0.4, path, file)

    record = palpate.read_record(str(path))
    hand = cut_hand(record, palpate.EventKind.alarm)
    element = find_element(scene, alarm_of(AlarmKind.energy, -1), 0, hand)
    assert element.name == "particle"
    # the tool comes from above: not on the other side
    assert element.place[2] > 0.0, ended.value
    none = SimpleNamespace(events=record.events[:0], hand=record.hand)
    assert cut_hand(none, palpate.EventKind.alarm) is None


def test_a_record_of_before_there_were_safeguards_is_read_as_it_was(tmp_path):
    scene, path = organ_scene(1), tmp_path / "old.prec"
    run_live(scene, path)
    record = palpate.read_record(str(path))

    assert not [row for row in record.events if row["kind"] == palpate.EventKind.safeguard]
    assert json.loads(record.header)["prec"]["version"] == 1
