# SPDX-License-Identifier: BSD-3-Clause
"""Records opened beside the scenes they were made with, and replayed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

import palpate
from palpate.assessment.verdict import describe_verdict, pick_events
from palpate.command.verb import Report
from palpate.files.refusal import Refusal
from palpate.runs.felt import read_all_rendered
from palpate.runs.run import describe_arithmetic, read_scene, split_names
from palpate.scene.scene_file import hash_file


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
    return record, where, follow_header(read_recorded_scene(path, where, record), header)


def read_recorded_scene(path: Path, where: Path, record: palpate.Record) -> palpate.Scene:
    """The scene of a file, with the inclusion that was drawn for a recorded attempt."""
    drawn = draw_recorded(path, where, record)
    if drawn is None or not drawn.inclusion:
        return read_scene(where)
    return palpate.scenario.draw_scene(palpate.scenario.read(where), drawn)


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
        "motors_off_s": float((~read_all_rendered(record)).sum()) / scene.rate,
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
