# SPDX-License-Identifier: BSD-3-Clause
"""Live runs and their records: what the verbs and the demo share."""

from __future__ import annotations

import os
import platform
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import palpate
from palpate.assessment.verdict import describe_attempt
from palpate.command.verb import Report, WrongCall
from palpate.files.refusal import Refusal
from palpate.runs.alarms import tell_alarm, tell_averted
from palpate.runs.coupling import describe_couplings, say_couplings
from palpate.runs.element import Element, cut_hand, find_element
from palpate.runs.live import LiveRun, find_longest
from palpate.runs.press import Place, PressScript, PressTimes, has_jaws, measure_press, write_script
from palpate.runs.stop_request import hear_stop
from palpate.scene.scene_file import hash_file, open_scene

PUBLISHED, WORKING = ".palpate", ".organ"
BETWEEN = " + "
"""What a record's header says of bodies, or devices, that differ."""
GRACE = 20.0
"""[s] A live run may take this much longer than its script before it is given up as stuck."""
PIECE = 0.1
"""[s] between two checks whether a run without an end shall stop."""


@dataclass(frozen=True)
class Run:
    """One live run of a script."""

    record: palpate.Record
    times: PressTimes
    report: Report


def describe_build(
    scene: palpate.Scene,
    scene_path: Path,
    record_path: Path,
    device: str,
    drawn: palpate.scenario.DrawnTask | None = None,
) -> dict[str, Any]:
    """The header of a record: all that must match for a replay to give the same bits, and to come
    to the same verdict.
    """
    return {
        **({} if drawn is None else {"task": describe_attempt(drawn)}),
        **describe_arithmetic(scene),
        "scene": os.path.relpath(scene_path.resolve(), record_path.resolve().parent),
        "scene_sha256": hash_file(scene_path),
        "device": device,
    }


def describe_arithmetic(scene: palpate.Scene) -> dict[str, str]:
    """What decides how a scene's ticks round here: program, kernel and vector target; of bodies
    that differ in these, one after the other, joined by BETWEEN.
    """
    kernels, vector_targets = [], []
    for body in scene.bodies:
        targets = palpate.simd_targets() if body.kernel == palpate.Kernel.packed else []
        unpacked = body.kernel == palpate.Kernel.packed and not targets
        kernels.append((palpate.Kernel.reference if unpacked else body.kernel).name)
        vector_targets.append((body.simd_target or targets[0]) if targets else platform.machine())
    return {
        "palpate": version("palpate"),
        "kernel": join_names(kernels),
        "vector_target": join_names(vector_targets),
    }


def join_names(names: Sequence[str]) -> str:
    """One name where it is that of all bodies, or devices."""
    return names[0] if len(set(names)) == 1 else BETWEEN.join(names)


def split_names(text: str, count: int) -> list[str]:
    """The name of each of `count` bodies."""
    names = text.split(BETWEEN)
    return names if len(names) == count else [text] * count


def read_scene(path: Path) -> palpate.Scene:
    """The compiled scene of a scene file or of a published one, by its ending .palpate.

    Raises FileError, Refusal or OSError.
    """
    if is_published(path):
        return palpate.scenario.read(path).scene
    if path.suffix.lower() == WORKING:
        raise Refusal(
            path, "", "a working file", f"what `palpate publish` makes of it, a {PUBLISHED} file"
        )
    return open_scene(path)[1]


def is_published(path: Path) -> bool:
    return path.suffix.lower() == PUBLISHED


def run_device(
    scene: palpate.Scene,
    device: palpate.HapticDevice | Sequence[palpate.HapticDevice],
    duration: float,
    record_path: Path,
    scene_path: Path,
    safety: palpate.SafetyLimits | None = None,
    drawn: palpate.scenario.DrawnTask | None = None,
) -> palpate.LoopReport:
    """Runs a device, or one for each instrument, for a time [s] through the live 1 kHz loop and its
    recorder; for 0 until Ctrl+C, a termination signal or the end of what a record holds.

    A device that fails ends the run, and so does a task that is decided; the report says so. Raises
    RuntimeError where the loop did not end or, without a task, the tissue raised an alarm,
    WrongCall for a time that no record holds.
    """
    require_recordable(scene, duration)
    devices = device if isinstance(device, Sequence) else [device]
    names = join_names([each.name() for each in devices])
    header = describe_build(scene, scene_path, record_path, names, drawn)
    options = palpate.LoopOptions(
        duration=duration,
        safety=safety or palpate.SafetyLimits(),
        on_fault=palpate.FaultResponse.end,
    )
    task = None if drawn is None else drawn.task
    run = LiveRun(scene, device, record=record_path, header=header, options=options, task=task)
    if duration > 0.0:
        with run:
            ended = run.wait(duration + GRACE)
    else:
        with hear_stop() as stopped, run:
            while not (stopped.is_set() or run.wait(PIECE)):
                pass
        ended = True
    costs = run.finish()
    if not ended:
        raise RuntimeError(f"the loop did not end within {duration + GRACE:.0f} s")
    # what a task comes to then is its outcome
    if drawn is None and costs.alarm.kind != palpate.AlarmKind.none:
        raise RuntimeError(
            f"the run was stopped at {costs.alarm.time:.3f} s: "
            + tell_alarm(
                costs.alarm, scene, costs.alarm_body, read_element(scene, costs, record_path)
            )
        )
    return costs


def read_element(
    scene: palpate.Scene, costs: palpate.LoopReport, record_path: Path
) -> Element | None:
    """Which element the alarm of a recorded run is of."""
    hand = None
    if costs.alarm.kind is palpate.AlarmKind.energy:
        hand = cut_hand(palpate.read_record(str(record_path)), palpate.EventKind.alarm)
    return find_element(scene, costs.alarm, costs.alarm_body, hand)


def require_one_instrument(path: Path, scene: palpate.Scene) -> None:
    """Raises Refusal for a scene of several instruments, which one device cannot drive."""
    if len(scene.instruments) != 1:
        count = str(len(scene.instruments))
        raise Refusal(path, "scene.instruments", count, "1, as there is one device to drive them")


def require_recordable(scene: palpate.Scene, duration: float) -> None:
    """Raises WrongCall for a run [s] that no record holds."""
    longest = find_longest(scene)
    if not duration <= longest:
        raise WrongCall(
            f"duration: got {duration:g} s, expected at most {longest:g} s, which a record holds "
            f"at {scene.rate:g} Hz"
        )


def describe_costs(costs: palpate.LoopReport, scene: palpate.Scene) -> Report:
    """What a run of the loop cost, as a verb reports it; and, where safeguards held it together,
    what would have ended it."""
    averted = {"averted": tell_averted(costs, scene)} if costs.averted_body >= 0 else {}
    return {
        **averted,
        "safeguarded_ticks": costs.safeguarded_ticks,
        "ticks": costs.ticks,
        "tick_median_us": 1e6 * costs.cost.median,
        "tick_p99_us": 1e6 * costs.cost.p99,
        "lateness_p99_us": 1e6 * costs.lateness.p99,
        "missed_ticks": costs.missed_ticks,
        "slow_ticks": costs.slow_ticks,
        "processor_median_us": 1e6 * costs.processor.median,
        "processor_p99_us": 1e6 * costs.processor.p99,
        "realtime": "real-time priority" if costs.realtime else costs.realtime_note,
        "passivity_interventions": costs.interventions,
        "damped_ticks": costs.damped_ticks,
        **describe_exchanges(costs),
        **describe_couplings(costs, scene),
    }


def describe_exchanges(costs: palpate.LoopReport) -> Report:
    """With a tissue that ticks in a thread of its own; nothing where it ticks with the hand."""
    if costs.exchanges == 0:
        return {}
    return {
        "exchanges": costs.exchanges,
        "late_exchanges": costs.late_exchanges,
        "exchange_median_ms": 1e3 * costs.exchange_cost.median,
        "exchange_p99_ms": 1e3 * costs.exchange_cost.p99,
    }


def say_missed(report: Report) -> str:
    """How many ticks were missed, and whether the scene is what was too slow."""
    missed, slow = report["missed_ticks"], report["slow_ticks"]
    if not missed:
        return "0 missed"
    if not slow:
        return f"{missed} missed, as the loop was kept waiting: no tick took that long by itself"
    median = 1e-3 * report["processor_median_us"]
    return (
        f"{missed} missed, and {slow} took longer by themselves than a tick may; the processor had "
        f"{median:.2f} ms for one in the median"
    )


def say_link(report: Report) -> list[str]:
    """What the link between hand and tissue needed: lines of a report, where there is any."""
    lines = []
    if report["passivity_interventions"]:
        lines.append(
            f"passivity    {report['passivity_interventions']} interventions, "
            f"{report['damped_ticks']} ticks damped: the hand was given energy"
        )
    if "exchanges" in report:
        lines.append(
            f"tissue       in a thread of its own, {report['exchanges']} exchanges, "
            f"{report['late_exchanges']} late; {report['exchange_median_ms']:.1f} ms median, "
            f"{report['exchange_p99_ms']:.1f} ms p99"
        )
    return [*lines, *say_couplings(report)]


def run_script(
    scene: palpate.Scene, place: Place, script: PressScript, record_path: Path, scene_path: Path
) -> Run:
    """Runs a press through the live 1 kHz loop and its recorder; reads the record back.

    Raises RuntimeError where the loop did not end, the tissue raised an alarm or the device failed.
    """
    frames, times = write_script(place, scene.instruments[0].tool.radius, script, has_jaws(scene))
    device = palpate.ScriptedDevice(frames)
    costs = run_device(scene, device, times.end, record_path, scene_path)
    if costs.fault != palpate.DeviceFault.none:
        raise RuntimeError(f"the device failed: {costs.fault_reason}")
    record = palpate.read_record(str(record_path))
    report = {
        **describe_costs(costs, scene),
        "substeps": scene.bodies[0].substeps,
        **measure_press(record, place, scene.instruments[0].tool.radius, times),
    }
    return Run(record, times, report)
