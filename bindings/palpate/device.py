# SPDX-License-Identifier: BSD-3-Clause
"""The verb `device`: which there are, what one of them does, whether it is sound."""

from __future__ import annotations

import argparse
from collections.abc import Callable

import numpy as np

import palpate
from palpate.device_calibrate import describe_calibration, run_calibrate
from palpate.device_link import NAMES, Link, build_link, list_devices, to_list
from palpate.device_selftest import run_selftest
from palpate.verb import Report, Verb, WrongCall, quantity


def add_device(word: argparse.ArgumentParser) -> None:
    actions = word.add_subparsers(dest="action", metavar="ACTION", required=True)

    def add(name: str, summary: str) -> argparse.ArgumentParser:
        action = actions.add_parser(name, help=summary, description=summary)
        action.add_argument(
            "--json", action="store_true", default=argparse.SUPPRESS, help="report as JSON"
        )
        return action

    add("list", "what could be a device here")
    monitor = add("monitor", "watch a device for a while, its motors off")
    monitor.add_argument("device", metavar="DEVICE", help=NAMES)
    monitor.add_argument("--duration", type=quantity("s"), default=2.0, help="(2s)")
    selftest = add("selftest", "test a device: link, sensors, motors; hold its stylus")
    selftest.add_argument("device", metavar="DEVICE", help=NAMES)
    selftest.add_argument("--no-motors", action="store_true", help="leave the motors off")
    calibrate = add("calibrate", "find what the counts of a device mean, and write it to it")
    calibrate.add_argument("device", metavar="DEVICE", help=NAMES)
    calibrate.add_argument(
        "--dry-run", action="store_true", help="find it, but leave the device as it is"
    )


def run_device_verb(call: argparse.Namespace) -> Report:
    report = ACTIONS[call.action](call)
    return {"action": call.action, **report}


def run_list(call: argparse.Namespace) -> Report:
    del call
    return {"devices": list_devices()}


def run_monitor(call: argparse.Namespace) -> Report:
    if not 0.1 <= call.duration <= 24 * 3600.0:
        raise WrongCall(f"--duration: got {call.duration:g} s, expected 0.1 s to a day")
    link = build_link(call.device)
    link.hold(palpate.Workspace().center)
    link.open()
    link.driver.enable(False)
    tips: list[list[float]] = []
    every = max(1, round(0.1 / 1e-3))
    seen = 0

    def watch(sample: palpate.HapticSample) -> None:
        nonlocal seen
        if seen % every == 0:
            tips.append([link.time, *to_list(sample.position)])
        seen += 1

    status = link.run(call.duration, each=watch)
    return {**report_status(link, status), "tips": tips}


def report_status(link: Link, status: palpate.DeviceStatus) -> Report:
    """A status as JSON can hold it; angles in degrees for people, all else in SI units."""
    return {
        "device": link.name,
        "latency": link.note,
        "state": palpate.describe_status(status),
        "serial_number": status.serial_number,
        "firmware": ".".join(str(part) for part in status.release),
        "counts": list(status.counts),
        "joints_degree": to_list(np.degrees(status.joints)),
        "gimbal_degree": to_list(np.degrees(status.gimbal)),
        "tip_m": to_list(status.tip),
        "force_applied_N": to_list(status.force_applied),
        "faults": [palpate.name_fault(bit) for bit in range(12) if status.faults >> bit & 1],
        "report_rate_Hz": status.report_rate,
        "reports": status.reports,
        "lost_reports": status.lost_reports,
        "damaged_frames": status.damaged_frames,
        "round_trip_median_ms": 1e3 * status.round_trip_median,
        "round_trip_p99_ms": 1e3 * status.round_trip_p99,
        "jitter_p99_ms": 1e3 * status.jitter_p99,
        "clock_drift_ppm": 1e6 * status.clock_drift,
    }


def run_selftest_action(call: argparse.Namespace) -> Report:
    return run_selftest(build_link(call.device), motors=not call.no_motors)


def run_calibrate_action(call: argparse.Namespace) -> Report:
    return run_calibrate(build_link(call.device), store=not call.dry_run)


ACTIONS: dict[str, Callable[[argparse.Namespace], Report]] = {
    "list": run_list,
    "monitor": run_monitor,
    "selftest": run_selftest_action,
    "calibrate": run_calibrate_action,
}


def describe_device(report: Report) -> str:
    if report["action"] == "list":
        return "\n".join(describe_listed(row) for row in report["devices"])
    if report["action"] == "monitor":
        return describe_monitor(report)
    if report["action"] == "calibrate":
        return describe_calibration(report)
    lines = [f"{report['device']}: firmware {report['firmware']}, no. {report['serial_number']}"]
    for check in report["checks"]:
        lines.append(f"  {'ok' if check['ok'] else 'FAILED':7} {check['name']}: {check['detail']}")
    lines.append("sound" if report["ok"] else "NOT sound: do not let it push anyone")
    return "\n".join(lines)


def describe_listed(row: Report) -> str:
    notes = [row["product"]]
    if not row["permitted"]:
        notes.append("not permitted")
    if row["latency_timer_ms"] is not None:
        notes.append(f"latency timer {row['latency_timer_ms']} ms")
    return f"{row['device']:24} {', '.join(notes)}"


def describe_monitor(report: Report) -> str:
    joints = ", ".join(f"{angle:.1f}" for angle in report["joints_degree"])
    tip = ", ".join(f"{1e3 * x:.1f}" for x in report["tip_m"])
    return "\n".join(
        [
            f"{report['device']}: {report['state']}; {report['latency']}",
            f"joints       {joints} degrees",
            f"tip          {tip} mm",
            f"reports      {report['report_rate_Hz']:.0f} Hz; {report['lost_reports']} lost, "
            f"{report['damaged_frames']} damaged of {report['reports']}",
            f"round trip   {report['round_trip_median_ms']:.1f} ms median, "
            f"{report['round_trip_p99_ms']:.1f} ms p99",
            f"clock        {report['clock_drift_ppm']:+.0f} ppm, "
            f"jitter {report['jitter_p99_ms']:.2f} ms p99",
            f"faults       {', '.join(report['faults']) or 'none'}",
        ]
    )


DEVICE = Verb(
    "device",
    "list, watch, test and calibrate haptic devices",
    "palpate device selftest plant --json",
    add_device,
    run_device_verb,
    describe_device,
    failed=lambda report: report.get("ok") is False,
)
