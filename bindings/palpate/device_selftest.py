# SPDX-License-Identifier: BSD-3-Clause
"""The self-test of a device: its link, its sensors, its motors, and that silence stops them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import palpate
from palpate.device_link import Link
from palpate.verb import Report

PUSH = 0.4
"""[N] of each push, which a hand that holds the stylus hardly notices."""
LOSS = 0.01
"""Share of reports that may be missing."""
ROUND_TRIP = 20e-3
"""[s] after which the device would take the host for silent."""
PLAY = 2e-3
"""[m] that the tip may drift in a second while the motors carry the arm."""


@dataclass
class Test:
    """A list of checks as it grows."""

    checks: list[Report]

    def note(self, name: str, ok: bool, detail: str) -> bool:
        self.checks.append({"name": name, "ok": bool(ok), "detail": detail})
        return ok


def run_selftest(link: Link, motors: bool = True) -> Report:
    """Opens a link and tests what is at its end. Raises DeviceError where nothing answers.

    The stylus has to be held: the motors push it gently, in every direction.
    """
    test = Test([])
    link.hold(palpate.Workspace().center)
    link.open()
    check_link(link, test)
    if check_sensors(link, test) and motors and check_motors(link, test):
        check_silence(link, test)
    return {
        "device": link.name,
        "serial_number": link.status().serial_number,
        "firmware": ".".join(str(part) for part in link.status().release),
        "latency": link.note,
        "checks": test.checks,
        "ok": all(check["ok"] for check in test.checks),
    }


def check_link(link: Link, test: Test) -> None:
    link.driver.enable(False)
    status = link.run(2.5)
    test.note(
        "calibration",
        status.link == palpate.LinkState.ready,
        palpate.describe_status(status)
        if status.link != palpate.LinkState.ready
        else "valid, in the device's EEPROM",
    )
    rate = status.report_rate
    test.note("report rate", abs(rate - 1000.0) < 10.0, f"{rate:.0f} Hz, expected 1000 Hz")
    lost = status.lost_reports / max(1, status.reports)
    test.note("lost reports", lost <= LOSS, f"{100 * lost:.2f} %, at most {100 * LOSS:.0f} %")
    test.note("damaged frames", status.damaged_frames <= LOSS * status.reports,
              f"{status.damaged_frames} of {status.reports}")  # fmt: skip
    trip = status.round_trip_p99
    test.note(
        "round trip",
        0.0 < trip < ROUND_TRIP,
        f"{1e3 * status.round_trip_median:.1f} ms median, {1e3 * trip:.1f} ms p99, "
        f"less than {1e3 * ROUND_TRIP:.0f} ms",
    )


def check_sensors(link: Link, test: Test) -> bool:
    seen: list[list[int]] = []
    link.run(0.5, each=lambda sample: seen.append(list(link.status().counts)))
    counts = np.array(seen)
    spread = counts.max(axis=0) - counts.min(axis=0)
    test.note("sensor noise", bool((spread <= 6).all()),
              f"{spread.max()} counts at most while the stylus is held, expected 6")  # fmt: skip
    status = link.status()
    if status.link != palpate.LinkState.ready:
        return False
    arm = palpate.find_arm(link.driver.calibration())
    within = palpate.is_within(arm, status.joints)
    degrees = ", ".join(f"{angle:.0f}" for angle in np.degrees(status.joints))
    return test.note("arm within its range", within, f"joints at {degrees} degrees")


def check_motors(link: Link, test: Test) -> bool:
    link.driver.enable(True)
    link.driver.clear_fault()
    runs = link.wait_for(palpate.DeviceMode.run, 2.0)
    if not test.note("motors on", runs, palpate.describe_status(link.status())):
        return False
    before = link.status().tip
    drift = float(np.linalg.norm(link.run(1.0).tip - before))
    test.note("arm carried", drift < PLAY, f"{1e3 * drift:.1f} mm in a second without a force")
    for axis, name in enumerate(("right", "away", "up")):
        for sign in (1.0, -1.0):
            check_push(link, test, sign * PUSH * np.eye(3)[axis], f"{name} {sign * PUSH:+.1f} N")
    link.run(0.1)
    return True


def check_push(link: Link, test: Test, force: np.ndarray, name: str) -> None:
    """What the duties stand for is what was asked, within 5 % and a step of each duty."""
    status = link.run(0.2, force)
    calibration = link.driver.calibration()
    arm = palpate.find_arm(calibration)
    carried = palpate.compute_weight_torque(arm, status.joints)
    step = palpate.compute_tip_force(
        arm, status.joints, carried + np.abs(calibration.torque_full) / 255.0
    )
    off = float(np.linalg.norm(status.force_applied - force))
    allowed = 0.05 * float(np.linalg.norm(force)) + float(np.linalg.norm(step))
    test.note(f"push {name}", off <= allowed, f"{off:.3f} N off, at most {allowed:.3f} N")


def check_silence(link: Link, test: Test) -> None:
    """The host falls silent on purpose: the device has to cut its motors and say why."""
    silence = 0.03
    if link.core is not None:
        link.core.advance(link.time + silence)
    else:
        import time

        time.sleep(silence)
    link.time += silence
    link.driver.read(link.time)
    # the status that is told lags by some milliseconds, and a command would change nothing any more
    status = link.run(0.02)
    cut = status.mode == palpate.DeviceMode.faulted
    told = palpate.name_fault(status.first_fault)
    test.note("silence stops the motors", cut and told == "host silent", f"after 30 ms: {told}")
    link.driver.clear_fault()
    test.note("the fault clears", link.wait_for(palpate.DeviceMode.run, 2.0),
              palpate.describe_status(link.status()))  # fmt: skip
    link.driver.enable(False)
    test.note("motors off", link.wait_for(palpate.DeviceMode.idle, 1.0),
              palpate.describe_status(link.status()))  # fmt: skip
