# SPDX-License-Identifier: BSD-3-Clause
"""What each shape of an instrument costs over a ball at the same place of the same tissue.

    .venv/bin/python tests/bench/bench_tools.py [--rounds 3] [ORGAN ...]

Every tick is the same each time it is run: the least of its times [us], on the thread's processor,
is what it takes; all instruments have their turn in each round, and point straight down. Medians
and 99th percentiles are of the quarter of a second in which a hand holds still at the depth, jaws
closed on what they have. The shaft that lies goes along the tangent with its middle at the place.
"""

from __future__ import annotations

import argparse
import sys
from copy import copy
from pathlib import Path

import numpy as np
import palpate
from numpy.typing import NDArray
from palpate.assessment.instruments import shape_tool
from palpate.runs.press import find_top
from scipy.spatial.transform import Rotation
from tick_times import time_ticks

TOOLS: dict[str, dict[str, object]] = {
    "in the air": {"kind": "ball", "radius_m": 0.003, "friction": 0.0},
    "ball": {"kind": "ball", "radius_m": 0.003, "friction": 0.0},
    "ball, friction 0.3": {"kind": "ball", "radius_m": 0.003, "friction": 0.3},
    "probe of 20 mm": {"kind": "laparoscope", "radius_m": 0.003, "length_m": 0.02, "friction": 0.0},
    "shaft of 100 mm": {"kind": "laparoscope", "radius_m": 0.003, "length_m": 0.1, "friction": 0.0},
    "shaft that lies": {"kind": "laparoscope", "radius_m": 0.003, "length_m": 0.1, "friction": 0.0},
    "grasper": {
        **{"kind": "grasper", "radius_m": 0.0012, "length_m": 0.02},
        **{"friction": 0.5, "jaw_opening_rad": 0.52},
    },
}
FRAMES = ((0.0, 0.02, 0), (0.4, None, 0), (0.5, None, 1), (1.0, None, 1))
"""[s], [m] over the surface at rest, None at the depth, and the button."""
DEPTH, HELD = 0.005, slice(750, 1000)
"""[m], and ticks"""


def take(organ: str, said: dict[str, object]) -> palpate.Scene:
    published = Path(__file__).parents[2] / "meshes" / "published" / f"{organ}.palpate"
    scene = copy(shape_tool(said, 0, palpate.scenario.read(published).scene))
    scene.instruments[0].trocar = None
    return palpate.build_scene(scene)


def list_samples(scene: palpate.Scene, tool: str) -> list[palpate.HapticSample]:
    place = find_top(scene)
    outward = np.asarray(place.outward)
    away = 0.05 if tool == "in the air" else 0.0
    turn, middle = lay_down(outward) if tool == "shaft that lies" else ((0.0, 0.0, 0.0, 1.0), 0.0)
    frames = [
        palpate.KeyFrame(
            moment,
            place.point + middle + ((-DEPTH if height is None else height) + away) * outward,
            buttons=button if tool == "grasper" else 0,
        )
        for moment, height, button in FRAMES
    ]
    device, samples = palpate.ScriptedDevice(frames), []
    for tick in range(HELD.stop):
        samples.append(device.read(tick / scene.rate))
        samples[-1].orientation = turn
    return samples


def lay_down(outward: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """[-] (4,) A shaft's orientation across `outward`, and [m] (3,) from its middle to its tip."""
    aside = np.eye(3)[np.argmin(np.abs(outward))]
    along = np.cross(outward, aside) / np.linalg.norm(np.cross(outward, aside))
    turn, _ = Rotation.align_vectors(along[None], [[0.0, 0.0, 1.0]])
    return turn.as_quat(), -0.05 * along


def main() -> int:
    call = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    call.add_argument("organs", nargs="*", default=["gallbladder", "stomach", "spleen", "kidney"])
    call.add_argument("--rounds", type=int, default=3)
    asked = call.parse_args()
    for organ in asked.organs:
        scenes = {name: take(organ, said) for name, said in TOOLS.items()}
        scripts = {name: list_samples(scene, name) for name, scene in scenes.items()}
        runs = [
            {name: time_ticks(scene, scripts[name]) for name, scene in scenes.items()}
            for _ in range(asked.rounds)
        ]
        print(f"{organ:22} {'median':>8} {'p99':>8} {'over ball':>10}  substeps  force")
        least = {name: 1e6 * np.min([run[name][0] for run in runs], axis=0) for name in TOOLS}
        ball = np.median(least["ball"][HELD])
        for name in TOOLS:
            median, p99 = np.median(least[name][HELD]), np.quantile(least[name][HELD], 0.99)
            _, world, (command,) = runs[0][name]
            substeps, force = world.bodies[0].substeps, float(np.linalg.norm(command.force))
            print(
                f"  {name:20} {median:8.0f} {p99:8.0f} {median - ball:+10.0f}  {substeps:8d}  "
                f"{force:.3f} N",
                flush=True,
            )
    return 0


if __name__ == "__main__":
    sys.exit(main())
