# SPDX-License-Identifier: BSD-3-Clause
"""What is done under the simulated disk, each promise told as it is made.

python power_work.py KIND FOLDER MATERIAL        KIND: one of SAVES, or live
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path

import palpate
from palpate import scenario
from palpate.files.whole_file import write_whole
from simulated_disk import acknowledge
from surfaces import organ_scene, press_frames, run_frames

LIVE_SECONDS = 2.6
"""Of a live run: its recorder syncs twice before the end."""


def save_twice(save: Callable[[Path, Path], None], folder: Path, material: Path) -> None:
    for version in ("one", "two"):
        save(folder / "work", material / version)
        acknowledge(version)


def save_container(path: Path, source: Path) -> None:
    scenario.write_container(path, scenario.read_container(source, "organ", 3))


def save_published(path: Path, source: Path) -> None:
    scenario.write(path, scenario.read(source))


def save_bytes(path: Path, source: Path) -> None:
    write_whole(path, source.read_bytes())


def save_record(path: Path, source: Path) -> None:
    palpate.write_record(path, palpate.read_record(source))


def record_live(folder: Path) -> None:
    recorder = palpate.Recorder(folder / "work", json.dumps({"organ": "ellipsoid"}))
    acknowledge("begun")
    device = palpate.ScriptedDevice(press_frames())
    options = palpate.LoopOptions(duration=LIVE_SECONDS)
    loop = palpate.Loop(organ_scene(1), device, options, recorder.log())
    loop.start()
    loop.wait(60.0)
    recorder.finish()
    acknowledge("finished")


def make_material(kind: str, folder: Path) -> None:
    """The files "one" and "two" that are saved."""
    folder.mkdir()
    for version, stiffness in (("one", 50.0), ("two", 60.0)):
        path = folder / version
        if kind == "container":
            content = json.dumps({"version": version})
            scenario.write_container(
                path, scenario.Container(format="organ", version=3, content=content)
            )
        elif kind == "published":
            scene = organ_scene(0, stiffness)
            scenario.write(path, scenario.Scenario(scene=scene, title=version))
        elif kind == "record":
            record = run_frames(organ_scene(0, stiffness), press_frames())
            palpate.write_record(path, record)
        else:
            path.write_bytes(version.encode() * 1000)


SAVES = {
    "container": save_container,
    "published": save_published,
    "bytes": save_bytes,
    "record": save_record,
}

if __name__ == "__main__":
    kind, folder, material = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    if kind == "live":
        record_live(folder)
    else:
        save_twice(SAVES[kind], folder, material)
