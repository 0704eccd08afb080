# SPDX-License-Identifier: BSD-3-Clause
"""The verb `play`. The window stands in palpate.player, which is loaded only when asked for."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import palpate
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall, quantity
from palpate.device.names import HANDS, PARKED, POINTER, find_port, split_hand
from palpate.files.file_kind import RECORD
from palpate.runs.kept_play import open_keeper, play_kept
from palpate.runs.live import find_longest
from palpate.runs.play import open_play
from palpate.runs.play_report import DEVICE_FAULT, play_headless
from palpate.runs.run import PUBLISHED, say_link, say_missed
from palpate.system.display import require_display

EXTRA = 'pip install "palpate[player]"'
LONGEST_SHAFT = 2.0
"""[m] from tip to handle."""
MUCH = 0.01
"""[-] by which what was felt and what was computed have to differ before both are told."""


def add_play(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=f"published scenario, {PUBLISHED}, or a folder")
    parser.add_argument(
        "--device",
        action="append",
        metavar="DEVICE",
        help=f"{HANDS}: the mouse, a script such as `palpate press --script` writes, either hand "
        "on the simulated arm with the real firmware, or a real device. Once for each instrument, "
        "in their order; those without are the mouse as well (Tab changes hands), or, where the "
        f"first is no mouse, {PARKED}",
    )
    parser.add_argument(
        "--fulcrum",
        type=quantity("m"),
        metavar="LENGTH",
        help="from tip to handle: the arm is the handle of the instrument, which turns about its "
        "trocar, and not its tip; 0: it is the tip. Default: as the scenario says",
    )
    parser.add_argument(
        "--headless", action="store_true", help="no window; needs a script or a real device"
    )
    add_output(
        parser,
        "--record",
        writes=RECORD,
        help="write the run as this .prec; default: a name of its own in palpate/records of the "
        "user's data folder (the window names it and opens it)",
    )
    parser.add_argument(
        "--duration",
        type=quantity("s"),
        help="of a run; default: of the script, or until Ctrl+C or the device ends it",
    )
    parser.add_argument(
        "--language",
        choices=("en", "tr"),
        help="of the window, and of title and task; default: that of the system",
    )
    parser.add_argument("--level", default="", help="of a task; default: normal, or the first")
    parser.add_argument(
        "--seed", type=int, default=0, help="what the task's parameters are drawn from; default: 0"
    )
    whose = parser.add_mutually_exclusive_group()
    whose.add_argument(
        "--person", metavar="CODE", help="keep the attempt in the database, under this code"
    )
    whose.add_argument(
        "--guest", action="store_true", help="keep it under no code: it can be linked to nobody"
    )
    parser.add_argument("--theme", choices=("dark", "light"), default="dark")


def run_play(call: argparse.Namespace) -> Report:
    if call.duration is not None and not call.duration > 0.0:
        raise WrongCall(f"--duration: got {call.duration:g} s, expected more than 0")
    arm, script = split_hand((call.device or [POINTER])[0])
    if call.headless and not script and not find_port(arm):
        raise WrongCall(
            "--device: got the mouse, expected script:FILE or serial:PORT beside --headless"
        )
    if not 0 <= call.seed < 2**63:
        raise WrongCall(f"--seed: got {call.seed}, expected 0 or more")
    if call.file.is_dir():
        return show_folder(call)
    if call.fulcrum is not None and not 0.0 <= call.fulcrum <= LONGEST_SHAFT:
        raise WrongCall(f"--fulcrum: got {call.fulcrum:g} m, expected 0 to {LONGEST_SHAFT:g}")
    play = open_play(
        call.file,
        call.device or [],
        call.record,
        call.duration,
        call.level,
        call.seed,
        call.fulcrum,
    )
    play.language = call.language or ""
    if (call.person or call.guest) and call.record is not None:
        raise WrongCall("--record: a kept attempt has its trace beside the database")
    if call.headless:
        if not play.duration and play.drawn is None:
            print(say_endless(play.scenario.scene), file=sys.stderr, flush=True)
        if call.person or call.guest:
            return play_kept(play, call.person or "")
        return play_headless(play)
    try:
        from palpate.player import play_in_window
    except ImportError as problem:
        raise RuntimeError(f"the window needs PySide6 ({problem}): {EXTRA}") from None
    require_display("--headless plays a script without one")
    if not (call.person or call.guest):
        return play_in_window(play, language=call.language, theme=call.theme)
    keeper = open_keeper(play, call.person or "")
    return play_in_window(play, language=call.language, theme=call.theme, keeper=keeper)


def show_folder(call: argparse.Namespace) -> Report:
    """The cards of a folder's scenarios."""
    if call.headless or call.guest or call.record is not None:
        raise WrongCall(f"{call.file} is a folder: its scenarios are chosen in a window")
    if split_hand(call.device)[1]:
        raise WrongCall(f"--device: got a script, and {call.file} is a folder: expected a hand")
    try:
        from palpate.player.start import show_scenarios
    except ImportError as problem:
        raise RuntimeError(f"the window needs PySide6 ({problem}): {EXTRA}") from None
    require_display("--headless plays one of its scenarios")
    return show_scenarios(call.file, call.language, call.theme, call.device, call.person or "")


def say_endless(scene: palpate.Scene) -> str:
    hours = find_longest(scene) / 3600
    return f"runs until Ctrl+C or the device ends it, {hours:.1f} h at most, which a record holds"


def describe_play_report(report: Report) -> str:
    lines = [report["title"] or report["scenario"]]
    if is_device_fault(report):
        lines.insert(0, f"device fault: {report['reason']}")
    if report.get("ticks"):
        lines += [
            *describe_felt(report),
            f"ticks        {report['ticks']}; {say_missed(report)}",
            f"tick         {report['tick_median_us']:.0f} us median, "
            f"{report['tick_p99_us']:.0f} us p99",
            f"lateness     {report['lateness_p99_us']:.0f} us p99, "
            f"{1e-3 * report['lateness_max_us']:.1f} ms at most; {report['realtime']}",
            *say_link(report),
        ]
    if report.get("verdict"):
        lines += describe_verdict(report["verdict"])
    if report.get("averted"):
        lines.append(f"safeguards   {report['averted']}")
    if report.get("device_state"):
        lines.append(f"device       {report['device_state']}")
    if report.get("attempt"):
        lines.append(f"attempt      {report['attempt']}")
    lines.append(f"record       {report['record'] or 'none: nothing was played'}")
    lines.append("not validated, not a medical device")
    return "\n".join(lines)


def describe_felt(report: Report) -> list[str]:
    """What was felt and, where that is not what was computed, both."""
    felt = report["peak_force_N"], report["time_in_touch_s"]
    computed = report["peak_computed_N"], report["time_in_touch_computed_s"]
    several = report["instruments"] > 1
    whose = f", of any of {report['instruments']} instruments" if several else ""
    lines = [f"peak force   {felt[0]:.3f} N, {felt[1]:.1f} s in touch{whose}"]
    differ = any(abs(a - b) > MUCH * b for a, b in zip(felt, computed, strict=True))
    if differ:
        lines.append(f"computed     {computed[0]:.3f} N, {computed[1]:.1f} s in touch{whose}")
    if report["motors_off_s"] > 0.0:
        lines.append(f"motors off   {report['motors_off_s']:.3f} s: what was computed was not felt")
    return lines


def describe_verdict(verdict: Report) -> list[str]:
    """The outcome, then every step and limit that was opened, each on a line."""
    lines = [
        f"outcome      {verdict['outcome']} in {verdict['time_s']:.3f} s, "
        f"{verdict['errors']} errors, {verdict['warnings']} warnings"
    ]
    lines += [f"  {step['status']:8} {step['id']}" for step in verdict["steps"]]
    lines += [
        f"  {limit['count']}x over  {limit['id']}, {limit['duration_s']:.2f} s"
        for limit in verdict["limits"]
        if limit["count"]
    ]
    return lines


def is_device_fault(report: Report) -> bool:
    return bool(report.get("outcome") == DEVICE_FAULT)


PLAY = Verb(
    "play",
    "play a published scenario: feel the organ with the mouse, or run a script",
    "palpate play spleen.palpate --device script:press.json --headless",
    add_play,
    run_play,
    describe_play_report,
    is_device_fault,
)
