# SPDX-License-Identifier: BSD-3-Clause
"""Live runs, their records, replays and pictures: what the verbs and the demo share."""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

import palpate
from palpate.assessment.verdict import describe_attempt, describe_verdict, pick_events
from palpate.command.verb import Report, WrongCall
from palpate.files.refusal import Refusal
from palpate.runs.alarms import tell_alarm, tell_averted
from palpate.runs.element import Element, cut_hand, find_element, read_sample
from palpate.runs.felt import read_column, read_force, read_rendered
from palpate.runs.live import LiveRun, find_longest
from palpate.runs.press import Place, PressScript, PressTimes, measure_press, write_script
from palpate.runs.stop_request import hear_stop
from palpate.scene.scene_file import hash_file, open_scene
from palpate.scene.surfaces import join_positions, join_rest_surfaces, join_triangles

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
        "realtime": "real-time priority" if costs.realtime else costs.realtime_note,
        "passivity_interventions": costs.interventions,
        "damped_ticks": costs.damped_ticks,
        **describe_exchanges(costs),
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
    return lines


def run_script(
    scene: palpate.Scene, place: Place, script: PressScript, record_path: Path, scene_path: Path
) -> Run:
    """Runs a press through the live 1 kHz loop and its recorder; reads the record back.

    Raises RuntimeError where the loop did not end, the tissue raised an alarm or the device failed.
    """
    frames, times = write_script(place, scene.instruments[0].tool.radius, script)
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


def open_record(
    path: Path, scene_path: Path | None = None
) -> tuple[palpate.Record, Path, palpate.Scene]:
    """A record and the compiled scene it was made with.

    Raises FileError, Refusal (another scene than the record's) or OSError.
    """
    record = palpate.read_record(str(path))
    if len(record.hand) == 0:
        raise Refusal(path, "", "no ticks", "a record of at least one: there is nothing to compare")
    require_finite(path, record)
    header = json.loads(record.header)
    for key in ("scene", "scene_sha256"):
        if not isinstance(header.get(key), str):
            raise Refusal(path, f"header.{key}", repr(header.get(key)), "text")
    where = scene_path or path.parent / header["scene"]
    try:
        found = hash_file(where)
    except FileNotFoundError:
        if scene_path is not None:
            raise
        expected = f"the scene there; where it was moved to, --scene {Path(header['scene']).name}"
        raise Refusal(path, "header.scene", f"no file {where}", expected) from None
    if found != header["scene_sha256"]:
        raise Refusal(
            where,
            "",
            f"SHA-256 {found[:12]}...",
            f"{header['scene_sha256'][:12]}..., the scene of {path.name}",
        )
    return record, where, follow_header(read_scene(where), header)


def require_finite(path: Path, record: palpate.Record) -> None:
    """Raises Refusal, naming the tick, where a record has what no run can have felt."""
    for table in (record.hand, record.felt):
        for name in table.dtype.names:
            rows = np.asarray(table[name]).reshape(len(table), -1)
            wrong = np.flatnonzero(~np.isfinite(rows).all(axis=1))
            if len(wrong):
                found = str(np.asarray(table[name])[wrong[0]])
                raise Refusal(path, f"tick {wrong[0]}: {name}", found, "finite numbers")


def follow_header(scene: palpate.Scene, header: dict[str, Any]) -> palpate.Scene:
    """The scene under the kernel and vector target of a record, as far as this machine has them."""
    count = len(scene.bodies)
    kernels = split_names(str(header.get("kernel", "")), count)
    targets = split_names(str(header.get("vector_target", "")), count)
    for body, kernel, target in zip(scene.bodies, kernels, targets, strict=True):
        if kernel.startswith("reference"):
            body.kernel = palpate.Kernel.reference
        elif target in palpate.simd_targets():
            body.simd_target = target
    return scene


def run_replay(path: Path, scene_path: Path | None = None) -> Report:
    """Replays a record from a fresh world and compares force, tool and state bit by bit."""
    record, where, scene = open_record(path, scene_path)
    drawn = draw_recorded(path, where, record)
    try:
        result = palpate.replay(scene, record, None if drawn is None else drawn.task)
    except ValueError as problem:
        raise Refusal(path, "", str(problem), "a record that can be replayed") from None
    header, here = json.loads(record.header), describe_arithmetic(scene)
    changed = {
        name: {"record": header.get(name), "here": now}
        for name, now in here.items()
        if header.get(name) != now
    }
    return {
        "record": str(path),
        "scene": str(where),
        "complete": record.complete,
        "ticks": result.ticks,
        "motors_off_s": sum(
            float((~read_rendered(record, instrument)).sum()) / scene.rate
            for instrument in range(record.instruments)
        ),
        "equal": result.equal,
        "first_difference": result.first_difference if result.first_difference >= 0 else None,
        "largest_force_difference_N": result.largest_force_difference,
        "largest_position_difference_m": result.largest_position_difference,
        "changed": changed,
        **({} if drawn is None else describe_rejudged(where, drawn, result)),
    }


def draw_recorded(
    path: Path, where: Path, record: palpate.Record
) -> palpate.scenario.DrawnTask | None:
    """The task of a record, as the scene it was made with has it; None where it has none.

    Raises Refusal for a header that names a task which that scene does not have.
    """
    told = json.loads(record.header).get("task")
    if told is None:
        return None
    try:
        level, seed = str(told["level"]), int(told["seed"])
        drawn = palpate.scenario.draw_task(palpate.scenario.read(where), level, seed)
        same = drawn.sha256 == told["assessment_sha256"]
    except (ValueError, TypeError, LookupError) as problem:
        raise Refusal(path, "header.task", str(problem), f"a task of {where.name}") from None
    if not same:
        raise Refusal(path, "header.task", "another assessment", f"that of {where.name}")
    return drawn


def describe_rejudged(
    where: Path, drawn: palpate.scenario.DrawnTask, result: palpate.ReplayReport
) -> Report:
    """The verdict of a replay, and whether the record has the very same events."""
    assessment = json.loads(palpate.scenario.read(where).assessment)
    first = result.first_event_difference
    return {
        "verdict": describe_verdict(drawn, result.task, pick_events(result.events), assessment),
        "verdict_equal": result.events_equal,
        "first_event_difference": first if first >= 0 else None,
    }


def pose_at(scene: palpate.Scene, record: palpate.Record, tick: int) -> palpate.World:
    """The world after `tick` ticks of a record."""
    world = palpate.World(scene)
    hand = record.hand.reshape(len(record.hand), -1)
    for rows in hand[: tick + 1]:
        palpate.tick(scene, [read_sample(row) for row in rows], 1.0 / scene.rate, world)
    return world


def picture_of_rest(
    out: Path, organ: palpate.SurfaceMesh | palpate.Scene, title: str, options: dict[str, Any]
) -> None:
    """Draws a surface, or all bodies of a scene, at rest."""
    from palpate.render import save_picture

    if isinstance(organ, palpate.Scene):
        x, triangles = join_rest_surfaces(organ), join_triangles(organ)
    else:
        x, triangles = np.asarray(organ.vertices), np.asarray(organ.triangles)
    save_picture(out, x, triangles, title=title, **options)


def picture_of_record(
    out: Path,
    record_path: Path,
    time: float | None,
    options: dict[str, Any],
    title: str | None = None,
    scene_path: Path | None = None,
) -> float:
    """Draws the organs of a record at a time [s], or where a force was greatest, with the
    instrument that felt most then; returns when.
    """
    from palpate.render import save_picture

    record, where, scene = open_record(record_path, scene_path)
    times = read_column(record, "hand", "time").astype(float)
    forces = np.array([read_force(record, each) for each in range(record.instruments)])
    sizes = np.linalg.norm(forces, axis=2)
    if time is None:
        tick = int(sizes.max(axis=0).argmax())
    else:
        tick = int(np.searchsorted(times, time).clip(0, len(times) - 1))
    felt = int(sizes[:, tick].argmax())
    world = pose_at(scene, record, tick)
    x = join_positions([np.asarray(palpate.surface_position(body)) for body in world.bodies])
    tip = np.asarray(world.instruments[felt].tool.position), scene.instruments[felt].tool.radius
    save_picture(
        out,
        x,
        join_triangles(scene),
        values=1e3 * np.linalg.norm(x - join_rest_surfaces(scene), axis=1),
        legend="displacement [mm]",
        tool=tip,
        force=forces[felt, tick],
        title=title or name_scene(where),
        **options,
    )
    return float(times[tick])


def name_scene(path: Path) -> str:
    """What a scene is called after its file."""
    return path.name.removesuffix(".json").removesuffix(".scene").removesuffix(PUBLISHED)


def plot_runs(out: Path, runs: dict[str, Run], title: str) -> None:
    """Force against time of one or several runs of the same script, as PNG."""
    from palpate.render import save_force_plot

    save_force_plot(out, {name: run.record for name, run in runs.items()}, title=title)
