# SPDX-License-Identifier: BSD-3-Clause
"""The verb `device`: its window, and every action of the window as a word."""

from __future__ import annotations

import argparse
from collections.abc import Callable

import palpate
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall, quantity
from palpate.device.calibrate import describe_calibration, run_calibrate
from palpate.device.link import Link, build_link, list_devices, to_list
from palpate.device.names import DEVICES, require_device
from palpate.device.report import describe_feel, describe_listed, describe_monitor, report_status
from palpate.device.selftest import describe_selftest, run_selftest, write_selftest
from palpate.files.file_kind import SELFTEST
from palpate.runs.live import LONGEST
from palpate.system.display import require_display

EXTRA = 'pip install "palpate[player]"'
STIFFEST = 200.0
"""[N/m] that the usual delay of a link bears."""


def add_device(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--language", choices=("en", "tr"), help="of the window")
    parser.add_argument("--theme", choices=("dark", "light"), default="dark", help="of the window")
    parser.add_argument(
        "--connect",
        metavar="DEVICE",
        help=f"a device that the window connects to at once: {DEVICES}",
    )
    actions = parser.add_subparsers(dest="action", metavar="ACTION")

    def add(name: str, summary: str, device: bool = True) -> argparse.ArgumentParser:
        action = actions.add_parser(name, help=summary, description=summary)
        action.add_argument(
            "--json", action="store_true", default=argparse.SUPPRESS, help="report as JSON"
        )
        if device:
            action.add_argument("device", metavar="DEVICE", help=DEVICES)
        return action

    add("list", "what could be a device here", device=False)
    monitor = add("monitor", "watch a device for a while, its motors off")
    monitor.add_argument("--duration", type=quantity("s"), default=2.0, help="(2s)")
    add("clear", "let a device forget the fault that stopped its motors")
    feel = add("feel", "motors on, and a spring to where the stylus is")
    feel.add_argument("--stiffness", type=quantity("N/m"), default=80.0, help="(80N/m)")
    feel.add_argument("--duration", type=quantity("s"), default=5.0, help="(5s)")
    selftest = add("selftest", "test a device: link, sensors, motors; hold its stylus")
    selftest.add_argument("--no-motors", action="store_true", help="leave the motors off")
    add_output(
        selftest, "--report", writes=SELFTEST, metavar="FILE", help="write it, .txt or .json"
    )
    calibrate = add("calibrate", "find what the counts of a device mean, and write it to it")
    calibrate.add_argument(
        "--dry-run", action="store_true", help="find it, but leave the device as it is"
    )
    calibrate.add_argument(
        "--no-force-check", action="store_true", help="leave out the pushes against a scale"
    )


def run_device_verb(call: argparse.Namespace) -> Report:
    if call.action is None:
        return run_window(call)
    return {"action": call.action, **ACTIONS[call.action](call)}


def run_window(call: argparse.Namespace) -> Report:
    """Opens the window and comes back when it is closed."""
    if call.connect is not None:
        require_device(call.connect)
    try:
        from palpate.device_window import open_device_window
    except ImportError as problem:
        raise RuntimeError(f"the window needs PySide6 ({problem}): {EXTRA}") from None
    require_display("palpate device list, monitor, feel, selftest and calibrate need none")
    return {"action": "window", **open_device_window(call.connect, call.language, call.theme)}


def run_list(call: argparse.Namespace) -> Report:
    del call
    return {"devices": list_devices()}


def require_duration(call: argparse.Namespace) -> None:
    if not 0.1 <= call.duration <= LONGEST:
        raise WrongCall(f"--duration: got {call.duration:g} s, expected 0.1 to {LONGEST:g} s")


def run_monitor(call: argparse.Namespace) -> Report:
    require_duration(call)
    link = build_link(call.device)
    link.begin()
    tips = []
    for _ in range(round(call.duration / 0.1)):
        tip = to_list(link.run(0.1).tip)
        tips.append([link.time(), *tip])
    return {**report_and_end(link), "tips": tips}


def report_and_end(link: Link) -> Report:
    report = report_status(link, link.status())
    link.end()
    return report


def run_clear(call: argparse.Namespace) -> Report:
    link = build_link(call.device)
    link.begin()
    link.driver.clear_fault()
    link.run(0.3)
    report = report_and_end(link)
    return {**report, "ok": report["first_fault"] is None}


def run_feel(call: argparse.Namespace) -> Report:
    require_duration(call)
    if not 0.0 <= call.stiffness <= STIFFEST:
        raise WrongCall(f"--stiffness: got {call.stiffness:g} N/m, expected 0 to {STIFFEST:g} N/m")
    link = build_link(call.device)
    link.begin()
    link.driver.enable(True)
    runs = link.wait_for(palpate.DeviceMode.run, 2.0)
    rows = []
    if runs:
        link.draw(call.stiffness, link.status().tip)
        for _ in range(round(call.duration / 0.1)):
            status = link.run(0.1)
            rows.append(
                [link.time(), *to_list(status.force_commanded), *to_list(status.force_applied)]
            )
    return {**report_and_end(link), "ok": runs, "forces": rows}


def run_selftest_action(call: argparse.Namespace) -> Report:
    report = run_selftest(build_link(call.device), motors=not call.no_motors)
    if call.report is not None:
        write_selftest(call.report, report)
    return report


def run_calibrate_action(call: argparse.Namespace) -> Report:
    link = build_link(call.device)
    return run_calibrate(link, store=not call.dry_run, forces=not call.no_force_check)


ACTIONS: dict[str, Callable[[argparse.Namespace], Report]] = {
    "list": run_list,
    "monitor": run_monitor,
    "clear": run_clear,
    "feel": run_feel,
    "selftest": run_selftest_action,
    "calibrate": run_calibrate_action,
}


def describe_device(report: Report) -> str:
    if report["action"] == "list":
        return "\n".join(describe_listed(row) for row in report["devices"])
    if report["action"] == "window":
        return "closed"
    describe = {
        "monitor": describe_monitor,
        "clear": describe_monitor,
        "feel": describe_feel,
        "selftest": describe_selftest,
        "calibrate": describe_calibration,
    }
    return describe[report["action"]](report)


DEVICE = Verb(
    "device",
    "open the device window; or list, watch, feel, test and calibrate haptic devices",
    "palpate device selftest plant --json",
    add_device,
    run_device_verb,
    describe_device,
    failed=lambda report: report.get("ok") is False,
)
