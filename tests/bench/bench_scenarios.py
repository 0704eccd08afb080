# SPDX-License-Identifier: BSD-3-Clause
"""What every tick of a scenario takes under its careful hands, from the first to the last.

    .venv/bin/python tests/bench/bench_scenarios.py [--times 3] [SCENARIO ...]

The hands do the task once; their samples are then run again. A tick is the same each time it is
run, so that the least of its times is what it takes of the processor; what else the machine does is
in the others, and in the ticks of the live loop (`palpate play --headless`).
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import palpate
import palpate_meshes
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.assessment.selfplay import attempt
from tick_times import head_row, time_least, write_row

MESHES = Path(palpate_meshes.__file__).parent
SCENES = {
    "gallbladder_grasp": "published/gallbladder.palpate",
    "stomach_two_graspers": "published/stomach.palpate",
    "spleen_probe": "published/spleen.palpate",
    "kidney_stone_removal": "scenes/kidney_stone_removal.palpate",
}


def open_scenario(name: str) -> tuple[palpate.Scene, scenario.DrawnTask]:
    path = MESHES / "scenarios" / f"{name}.json"
    made = with_assessment(path, read_assessment(path), scenario.read(MESHES / SCENES[name]))
    drawn = scenario.draw_task(made)
    return scenario.draw_scene(made, drawn), drawn


def main() -> int:
    call = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    call.add_argument("scenarios", nargs="*", default=list(SCENES))
    call.add_argument("--times", type=int, default=3)
    asked = call.parse_args()
    print(head_row(f"{'us':24}"))
    for name in asked.scenarios:
        scene, drawn = open_scenario(name)
        hands = attempt(scene, drawn, "careful").samples
        print(write_row(f"{name:24}", time_least(asked.times, scene, *hands)), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
