# SPDX-License-Identifier: GPL-3.0-or-later
"""What a finished run felt, read from its record, and the record kept for a replay. Knows no Qt."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import palpate
from numpy.typing import NDArray
from palpate.runs.felt import read_column, read_force
from palpate.runs.press import Place, PressTimes, measure_press
from palpate.runs.run import describe_build

from palpate_editor.document import Organ
from palpate_editor.publish import write_scenario

SCENE_SUFFIX = ".palpate"


@dataclass(frozen=True, eq=False)
class Outcome:
    """A run that is over, with the organ it was made with."""

    name: str
    organ: Organ
    scene: palpate.Scene
    record: palpate.Record
    report: palpate.LoopReport
    device: str
    felt: dict[str, float | None]
    """As palpate.runs.press.measure_press for a scripted press; the peak force alone for a hand."""

    @property
    def time(self) -> NDArray[np.float64]:
        """[s] (n,)"""
        return np.asarray(read_column(self.record, "hand", "time"), dtype=float)

    @property
    def force(self) -> NDArray[np.float64]:
        """[N] (n, 3)"""
        return read_force(self.record)


def read_felt(
    record: palpate.Record, radius: float, script: tuple[Place, PressTimes] | None
) -> dict[str, float | None]:
    """What a record felt; with the place and times of its script where it had one."""
    if script is not None:
        place, times = script
        return measure_press(record, place, radius, times)
    force = np.linalg.norm(read_force(record), axis=1)
    return {"peak_force_N": float(force.max(initial=0.0))}


def keep_record(outcome: Outcome, path: Path) -> Path:
    """Writes a run's record and, beside it, the scene to replay it with; returns the scene's path.

    Raises FileError or OSError; each file is written whole or not at all.
    """
    scene = path.with_suffix(SCENE_SUFFIX)
    organ = outcome.organ
    title = organ.title or organ.name or path.stem
    write_scenario(replace(organ, title=title), outcome.scene, scene)
    header = describe_build(outcome.scene, scene, path, outcome.device)
    record = palpate.Record(
        header=json.dumps(header),
        hand=outcome.record.hand,
        felt=outcome.record.felt,
        events=outcome.record.events,
        hashes=outcome.record.hashes,
        complete=outcome.record.complete,
    )
    palpate.write_record(str(path), record)
    return scene
