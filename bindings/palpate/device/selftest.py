# SPDX-License-Identifier: BSD-3-Clause
"""The self-test of a device: its link, its sensors, its motors, and that silence stops them."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import palpate
from palpate.command.sentence import Sentence, sentence
from palpate.command.verb import Report
from palpate.device.link import Link
from palpate.files.whole_file import write_whole

PUSH = 0.4
"""[N] of each push, which a hand that holds the stylus hardly notices."""
LOSS = 0.01
"""Share of reports that may be missing."""
ROUND_TRIP = 20e-3
"""[s] after which the device would take the host for silent."""
PLAY = 2e-3
"""[m] that the tip may drift in a second while the motors carry the arm."""
SEEN = 0.01
"""[s] between two readings of a device."""
READINGS = 11
"""At a force."""
SILENCE = 0.03
"""[s]"""
PUSHES = (sentence("push right %1 N"), sentence("push away %1 N"), sentence("push up %1 N"))


@dataclass(frozen=True)
class Check:
    """One thing that was tested."""

    name: Sentence
    ok: bool
    detail: Sentence

    def report(self) -> Report:
        return {"name": str(self.name), "ok": self.ok, "detail": str(self.detail)}


@dataclass
class Test:
    """A list of checks as it grows."""

    tell: Callable[[Check], None] = lambda check: None
    """Hears of every check at once, in the thread that tests."""
    checks: list[Check] = field(default_factory=list)

    def note(self, name: Sentence, ok: bool, detail: Sentence) -> bool:
        check = Check(name, bool(ok), detail)
        self.checks.append(check)
        self.tell(check)
        return check.ok


def run_selftest(
    link: Link, motors: bool = True, tell: Callable[[Check], None] | None = None
) -> Report:
    """Begins a link and tests what is at its end. Raises DeviceError where nothing responds."""
    link.begin()
    try:
        return inspect_link(link, motors, tell)
    finally:
        link.end()


def inspect_link(
    link: Link, motors: bool = True, tell: Callable[[Check], None] | None = None
) -> Report:
    """Tests what is at the end of a link that has begun, and leaves its motors off.

    The stylus has to be held: the motors push it gently, in every direction.
    """
    test = Test(tell) if tell else Test()
    link.hold(palpate.Workspace().center)
    check_link(link, test)
    if check_sensors(link, test) and motors and check_motors(link, test):
        check_silence(link, test)
    link.driver.enable(False)
    status = link.status()
    return {
        "device": link.name,
        "serial_number": status.serial_number,
        "firmware": ".".join(str(part) for part in status.release),
        "latency": str(link.note),
        "checks": [check.report() for check in test.checks],
        "ok": all(check.ok for check in test.checks),
    }


def check_link(link: Link, test: Test) -> None:
    link.driver.enable(False)
    status = link.run(2.5)
    ready = status.link is palpate.LinkState.ready
    found = (
        sentence("valid, in the device's EEPROM")
        if ready
        else sentence("none that can be used: calibrate the device")
    )
    test.note(sentence("calibration"), ready, found)
    rate = status.report_rate
    found = sentence("%1 Hz, expected %2 Hz", f"{rate:.0f}", 1000)
    test.note(sentence("report rate"), abs(rate - 1000.0) < 10.0, found)
    lost = status.lost_reports / max(1, status.reports)
    found = sentence("%1 %, at most %2 %", f"{100 * lost:.2f}", f"{100 * LOSS:.0f}")
    test.note(sentence("lost reports"), lost <= LOSS, found)
    found = sentence("%1 of %2", status.damaged_frames, status.reports)
    test.note(sentence("damaged frames"), status.damaged_frames <= LOSS * status.reports, found)
    if not ready:  # it is sent no commands, so none comes back
        return
    trip = status.round_trip_p99
    found = sentence(
        "%1 ms median, %2 ms p99, less than %3 ms",
        f"{1e3 * status.round_trip_median:.1f}",
        f"{1e3 * trip:.1f}",
        f"{1e3 * ROUND_TRIP:.0f}",
    )
    test.note(sentence("round trip"), 0.0 < trip < ROUND_TRIP, found)


def check_sensors(link: Link, test: Test) -> bool:
    counts = np.array([list(link.run(SEEN).counts) for _ in range(round(0.5 / SEEN))])
    spread = int((counts.max(axis=0) - counts.min(axis=0)).max())
    found = sentence("%1 counts at most while the stylus is held, expected %2", spread, 6)
    test.note(sentence("sensor noise"), spread <= 6, found)
    status = link.status()
    if status.link is not palpate.LinkState.ready:
        return False
    arm = palpate.find_arm(link.driver.calibration())
    degrees = ", ".join(f"{angle:.0f}" for angle in np.round(np.degrees(status.joints)) + 0.0)
    within = palpate.is_within(arm, status.joints)
    return test.note(
        sentence("arm within its range"), within, sentence("joints at %1 degrees", degrees)
    )


def check_motors(link: Link, test: Test) -> bool:
    link.driver.enable(True)
    link.driver.clear_fault()
    runs = link.wait_for(palpate.DeviceMode.run, 2.0)
    if not test.note(sentence("motors on"), runs, tell_mode(link)):
        return False
    link.push()
    before = link.status().tip
    drift = float(np.linalg.norm(link.run(1.0).tip - before))
    found = sentence("%1 mm in a second without a force", f"{1e3 * drift:.1f}")
    test.note(sentence("arm carried"), drift < PLAY, found)
    for axis, push in enumerate(PUSHES):
        for sign in (1.0, -1.0):
            name = sentence(push.template, f"{sign * PUSH:+.1f}")
            check_push(link, test, sign * PUSH * np.eye(3)[axis], name)
    link.push()
    link.run(0.1)
    return True


def check_push(link: Link, test: Test, force: np.ndarray, name: Sentence) -> None:
    """What the duties stand for is what was asked, within 5 % and a step of each duty."""
    link.push(force)
    link.run(0.3)
    readings = [link.run(SEEN) for _ in range(READINGS)]
    if is_silenced(readings[-1]):  # by this computer, which is busy: no fault of the device
        link.driver.clear_fault()
        link.wait_for(palpate.DeviceMode.run, 2.0)
        readings = [link.run(SEEN) for _ in range(READINGS)]
    # the median: while a report is late the force is taken back
    status = sorted(readings, key=lambda one: np.linalg.norm(one.force_applied - force))[
        READINGS // 2
    ]
    calibration = link.driver.calibration()
    arm = palpate.find_arm(calibration)
    carried = palpate.compute_weight_torque(arm, status.joints)
    full = np.abs(calibration.torque_full)
    step = palpate.compute_tip_force(arm, status.joints, carried + full / 255.0)
    off = float(np.linalg.norm(status.force_applied - force))
    allowed = 0.05 * float(np.linalg.norm(force)) + float(np.linalg.norm(step))
    found = sentence("%1 N off, at most %2 N", f"{off:.3f}", f"{allowed:.3f}")
    test.note(name, off <= allowed, found)


def is_silenced(status: palpate.DeviceStatus) -> bool:
    """Whether the device has cut its motors as it heard nothing from here."""
    faulted = status.mode is palpate.DeviceMode.faulted
    return faulted and palpate.name_fault(status.first_fault) == "host silent"


def check_silence(link: Link, test: Test) -> None:
    """The host falls silent on purpose: the device has to cut its motors and say why."""
    link.fall_silent(SILENCE)
    # the status that is told lags by some milliseconds, and a command would change nothing any more
    status = link.run(SILENCE + 0.03)
    told = palpate.name_fault(status.first_fault)
    found = sentence("after %1 ms: %2", f"{1e3 * SILENCE:.0f}", told)
    test.note(sentence("silence stops the motors"), is_silenced(status), found)
    link.driver.clear_fault()
    runs = link.wait_for(palpate.DeviceMode.run, 2.0)
    test.note(sentence("the fault clears"), runs, tell_mode(link))
    link.driver.enable(False)
    rests = link.wait_for(palpate.DeviceMode.idle, 1.0)
    test.note(sentence("motors off"), rests, tell_mode(link))


def tell_mode(link: Link) -> Sentence:
    status = link.status()
    if status.mode is palpate.DeviceMode.run:
        return sentence("runs")
    if status.mode is palpate.DeviceMode.idle and status.link is palpate.LinkState.ready:
        return sentence("idle")
    return sentence(palpate.describe_status(status))


def describe_selftest(report: Report) -> str:
    lines = [f"{report['device']}: firmware {report['firmware']}, no. {report['serial_number']}"]
    for check in report["checks"]:
        lines.append(f"  {'ok' if check['ok'] else 'FAILED':7} {check['name']}: {check['detail']}")
    lines.append("sound" if report["ok"] else "NOT sound: do not let it push anyone")
    return "\n".join(lines)


def write_selftest(path: Path, report: Report) -> None:
    """As text, or as JSON where the name ends so. Raises OSError."""
    text = describe_selftest(report)
    if path.suffix.lower() == ".json":
        text = json.dumps({"action": "selftest", **report}, indent=2, allow_nan=False)
    write_whole(path, f"{text}\n".encode())
