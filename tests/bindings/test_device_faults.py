# SPDX-License-Identifier: BSD-3-Clause
"""A device that fails while it is played on, through the real program: what it says, and its exit
code. The device is the firmware's own code behind a pseudo terminal.
"""

from __future__ import annotations

import json
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import palpate
import pytest
from emulated_port import EmulatedPort, play_as_process
from palpate.cli.main import main
from palpate.cli.play import describe_play_report
from palpate.runs.felt import read_rendered
from palpate.runs.play import Play, open_play
from palpate.runs.play_report import DEVICE_FAULT, play_headless
from published import publish, write_press
from surfaces import press_frames

KIND = palpate.EventKind
UNHEARD, SILENT = "the device does not report any more", "host silent"
ATTEMPTS = 6
"""On a machine that is busy with other things."""


def press_late(wait: float = 0.8, hold: float = 10.0) -> list[palpate.KeyFrame]:
    """The press of press_frames() once motors that come on have their full force; it stays."""
    over, down = press_frames()[0].position, press_frames()[1].position
    return [
        palpate.KeyFrame(0.0, over),
        palpate.KeyFrame(wait, over),
        palpate.KeyFrame(wait + 0.3, down),
        palpate.KeyFrame(wait + 0.3 + hold, down),
    ]


def press_now() -> list[palpate.KeyFrame]:
    """From the surface of the organ on, at once."""
    return [palpate.KeyFrame(0.0, (0.0, 0.0, 0.0235)), palpate.KeyFrame(0.1, (0.0, 0.0, 0.017))]


def play(
    organ: Path,
    record: Path,
    *words: str,
    during: Callable[[subprocess.Popen, EmulatedPort], None] | None = None,
    disturbed: tuple[str, ...] = (UNHEARD, SILENT),
    **happens: object,
) -> tuple[int, str, str]:
    """Exit code and words of the program on a device to which so much happens; once more where the
    machine was so busy that device or program fell silent, which `disturbed` shows.
    """
    for _ in range(ATTEMPTS):
        record.unlink(missing_ok=True)
        with EmulatedPort(**happens) as port:
            child = play_as_process(organ, port, record, *words)
            if during is not None:
                during(child, port)
            out, err = child.communicate(timeout=120)
        if not any(words in out for words in disturbed):
            break
    return child.returncode, out, err


def stop_for_two_seconds(child: subprocess.Popen) -> None:
    child.send_signal(signal.SIGSTOP)
    time.sleep(2.0)
    child.send_signal(signal.SIGCONT)


def list_events(record: palpate.Record, kind: palpate.EventKind) -> np.ndarray:
    return record.events[record.events["kind"] == int(kind)]


@pytest.fixture
def organ(tmp_path) -> Path:
    return publish(tmp_path)


def open_scene(organ: Path) -> palpate.Scene:
    return palpate.scenario.read(organ).scene


def test_motors_that_are_cut_in_their_ramp_end_the_run_with_1_and_the_reason_first(organ, tmp_path):
    record = tmp_path / "cut.prec"
    happens = {"frames": press_now(), "scene": open_scene(organ), "cut_after": 0.066}
    code, out, err = play(organ, record, "--duration", "5s", **happens)

    assert code == 1 and out, err
    said = out.splitlines()
    assert said[0].startswith("device fault: motors off: stop pressed; release the emergency stop")
    assert any(line.startswith("motors off ") for line in said)
    rows = palpate.read_record(record)
    assert rows.complete
    assert 0 < len(rows.hand) < 3000
    rendered = read_rendered(rows)
    assert rendered.any() and not rendered[-1]
    assert (list_events(rows, KIND.fault)["index"] == 6).all()
    assert len(list_events(rows, KIND.fault)) == 1
    off = list_events(rows, KIND.motors_off)[-1]
    assert off["index"] == 3 and off["tick"] == len(rows.hand) - 1
    assert palpate.replay(open_scene(organ), rows).equal


def test_a_report_counts_no_force_that_was_not_given(organ, tmp_path):
    record = tmp_path / "cut.prec"
    happens = {"frames": press_late(), "scene": open_scene(organ), "cut_after": 1.5}
    code, out, err = play(organ, record, "--duration", "30s", "--json", **happens)

    assert code == 1 and out, err
    report = json.loads(out)
    assert report["outcome"] == DEVICE_FAULT
    assert list(report)[:2] == ["outcome", "reason"]
    assert report["reason"].startswith("motors off: stop pressed")
    assert report["device_state"].startswith("motors off: stop pressed")
    rows = palpate.read_record(record)
    rendered = read_rendered(rows)
    force = np.linalg.norm(rows.felt["force"].astype(float), axis=1)
    touched = (rows.felt["touched"] & 3) != 0
    assert report["ticks"] == len(rows.hand)
    assert report["motors_off_s"] == pytest.approx((~rendered).sum() * 1e-3)
    assert 0.1 < report["peak_force_N"] <= 1.01 * force[rendered].max()
    assert report["peak_computed_N"] == pytest.approx(force.max())
    assert report["time_in_touch_s"] == pytest.approx((touched & rendered).sum() * 1e-3)
    assert report["time_in_touch_computed_s"] == pytest.approx(touched.sum() * 1e-3)


def test_an_unplugged_device_ends_the_run_with_1_and_the_reason_first(organ, tmp_path):
    record = tmp_path / "gone.prec"
    happens = {"frames": press_late(), "scene": open_scene(organ), "unplug_after": 1.2}
    code, out, err = play(organ, record, "--duration", "30s", **happens)

    assert code == 1 and out, err
    assert out.startswith("device fault: lost: the cable is out")
    rows = palpate.read_record(record)
    assert rows.complete
    assert len(rows.hand) < 10_000
    faults = list_events(rows, KIND.fault)["index"]
    assert faults.tolist() == [3]  # device_failed
    assert palpate.replay(open_scene(organ), rows).equal


@pytest.mark.landing
def test_a_device_that_is_late_at_first_is_enabled_and_gives_its_force(organ, tmp_path):
    record = tmp_path / "late.prec"
    happens = {"frames": press_late(3.0, 1.0), "scene": open_scene(organ)}
    late = {"delay": 25e-3, "delayed_until": 2.5}
    code, out, err = play(organ, record, "--duration", "5s", "--json", **happens, **late)

    assert code == 0, out + err
    report = json.loads(out)
    assert report["outcome"] == "done"
    assert "motors off" not in report["device_state"]
    assert report["peak_force_N"] > 0.1
    assert report["time_in_touch_s"] > 0.1
    assert report["motors_off_s"] < 2.5


def test_a_stopped_program_reports_what_it_missed_and_the_silence_its_device_took_for_a_fault(
    organ, tmp_path
):
    record = tmp_path / "stopped.prec"

    def stop_before_a_strict_device(child, port):
        assert port.came_on.wait(60.0)
        port.patient = False
        stop_for_two_seconds(child)

    words = "--duration", "30s", "--json"
    during = stop_before_a_strict_device
    code, out, err = play(organ, record, *words, during=during, disturbed=(UNHEARD,))

    assert code == 1 and out, err
    report = json.loads(out)
    assert report["reason"].startswith("motors off: host silent")
    assert report["missed_ticks"] >= 1900
    assert report["lateness_max_us"] >= 1.9e6
    rows = palpate.read_record(record)
    missed = list_events(rows, KIND.missed_ticks)
    assert missed["index"].max() >= 1900
    assert "device fault: motors off: host silent" in describe_play_report(report)
    assert f"{report['missed_ticks']} missed" in describe_play_report(report)


def test_a_stopped_program_with_a_device_that_waits_for_it_plays_on_and_reports_what_it_missed(
    organ, tmp_path
):
    record = tmp_path / "stopped.prec"

    def stop_before_a_patient_device(child, port):
        assert port.came_on.wait(60.0)
        stop_for_two_seconds(child)

    words = "--duration", "4s", "--json"
    code, out, err = play(organ, record, *words, during=stop_before_a_patient_device)

    report = json.loads(out)
    assert code == 0, out + err
    assert report["missed_ticks"] >= 1900
    assert report["lateness_max_us"] >= 1.9e6
    assert report["ticks"] + report["missed_ticks"] == 4000


def end_normally(organ: Path, folder: Path, count: int) -> list[str]:
    """What cut the motors of a device that was played on `count` times, after each."""
    found = {}

    def ask_afterwards(child, port):
        child.wait(timeout=120)
        transport = palpate.SerialTransport(port.path)
        driver = palpate.SerialDevice(transport)
        driver.open(20.0)
        driver.take_status()
        found[record] = palpate.name_fault(driver.status().first_fault)

    for record in (folder / f"{k}.prec" for k in range(count)):
        words = "--duration", "900ms", "--json"
        code, out, err = play(organ, record, *words, during=ask_afterwards)
        assert code == 0, out + err
    return list(found.values())


@pytest.mark.landing
def test_runs_that_end_as_they_should_leave_a_device_without_a_fault(organ, tmp_path):
    assert end_normally(organ, tmp_path, 3) == ["none"] * 3


@pytest.mark.verify
def test_twelve_of_twelve_runs_that_end_as_they_should_leave_a_device_without_a_fault(
    organ, tmp_path
):
    assert end_normally(organ, tmp_path, 12) == ["none"] * 12


def test_motors_that_never_come_on_are_no_success(organ, tmp_path, monkeypatch):
    play = open_play(organ, f"plant:script:{write_press(tmp_path)}", duration=0.3)
    build = Play.build_device

    def build_switched_off(self, hand=None):
        arm = build(self, hand)
        arm.driver().enable(False)
        return arm

    monkeypatch.setattr(Play, "build_device", build_switched_off)

    report = play_headless(play)

    assert report["outcome"] == DEVICE_FAULT
    assert report["reason"] == "the motors never came on: idle"
    assert report["peak_force_N"] == report["time_in_touch_s"] == 0.0
    assert report["peak_computed_N"] > 0.05
    words = describe_play_report(report)
    assert words.startswith("device fault: the motors never came on: idle\n")
    assert "peak force   0.000 N, 0.0 s in touch" in words
    assert f"computed     {report['peak_computed_N']:.3f} N" in words


def test_the_program_ends_with_1_where_the_motors_never_come_on(organ, tmp_path, monkeypatch):
    words = ("--device", f"plant:script:{write_press(tmp_path)}", "--headless", "--json")
    build = Play.build_device

    def build_stopped(self, hand=None):
        arm = build(self, hand)
        arm.press_stop(True)
        return arm

    monkeypatch.setattr(Play, "build_device", build_stopped)

    assert main(["play", str(organ), *words, "--record", str(tmp_path / "a.prec")]) == 1


@pytest.mark.parametrize("stop", [signal.SIGINT, signal.SIGTERM])
def test_a_run_without_an_end_lasts_until_its_user_ends_it_and_says_so_first(stop, organ, tmp_path):
    record, said = tmp_path / "endless.prec", []

    def stop_once_on(child: subprocess.Popen, port: EmulatedPort) -> None:
        said.append(child.stderr.readline())
        assert port.came_on.wait(60)
        time.sleep(0.5)
        child.send_signal(stop)

    happens = {"frames": press_late(), "scene": open_scene(organ)}
    code, out, err = play(organ, record, "--json", during=stop_once_on, **happens)

    assert code == 0, err
    assert said[-1].startswith("runs until Ctrl+C or the device ends it, 2.3 h at most")
    report, rows = json.loads(out), palpate.read_record(record)
    assert report["outcome"] == "done"
    assert rows.complete and report["ticks"] == len(rows.hand) > 0


def test_a_run_without_an_end_is_not_given_up_as_stuck(organ, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("palpate.runs.run.GRACE", 0.0)
    with EmulatedPort(frames=press_now(), scene=open_scene(organ), cut_after=0.3) as port:
        words = ["--headless", "--device", f"serial:{port.path}", "--json"]
        code = main(["play", str(organ), *words, "--record", str(tmp_path / "cut.prec")])

    out, err = capsys.readouterr()
    assert code == 1, err
    assert json.loads(out)["outcome"] == DEVICE_FAULT
