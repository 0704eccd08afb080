# SPDX-License-Identifier: BSD-3-Clause
"""The gallbladder felt through the whole device beside the ideal one: the picture of firmware/.

.venv/bin/python tests/bench/plot_device_press.py -o firmware/pictures/press.png
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
import palpate
from matplotlib.figure import Figure

CHECKOUT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(CHECKOUT / "tests" / "bindings"))

from device_runs import DeviceRun, press_through  # noqa: E402

GALLBLADDER = CHECKOUT / "meshes" / "published" / "gallbladder.palpate"
IDEAL, ASKED, MOTOR = "#7f7f7f", "#1f77b4", "#d62728"


def size(force: np.ndarray) -> np.ndarray:
    return np.linalg.norm(force, axis=1)


def plot(path: Path, ideal: DeviceRun, arm: DeviceRun) -> None:
    figure = Figure(figsize=(9.0, 5.2), layout="constrained")
    forces, ways = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
    forces.plot(ideal.time, size(ideal.asked), color=IDEAL, lw=2.0, label="ideal device")
    forces.plot(arm.time, size(arm.asked), color=ASKED, lw=1.2, label="arm: asked of the motors")
    forces.plot(arm.time, size(arm.motor), color=MOTOR, lw=0.9, label="arm: given by the motors")
    forces.set_ylabel("force on the hand [N]")
    forces.set_ylim(bottom=0.0)
    forces.legend(frameon=False)
    start = ideal.hand[0]
    for run, color, label in ((ideal, IDEAL, "ideal device"), (arm, ASKED, "arm, by its sensors")):
        way = size(run.hand - start)
        ways.plot(run.time, 1e3 * way, color=color, lw=1.2, label=label)
    ways.set_ylabel("way of the tip [mm]")
    ways.set_xlabel("time [s]")
    ways.legend(frameon=False)
    for axes in (forces, ways):
        axes.spines[["top", "right"]].set_visible(False)
    forces.set_title("Gallbladder pressed by 6 mm: driver, firmware and simulated arm in the loop")
    figure.savefig(path, dpi=110)


def main() -> None:
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("-o", "--out", type=Path, required=True)
    scene = palpate.scenario.read(GALLBLADDER).scene
    ideal, arm = press_through(scene, "ideal"), press_through(scene, "plant")
    out = words.parse_args().out
    plot(out, ideal, arm)
    print(f"{out}: peak {size(ideal.asked).max():.3f} N ideal, {size(arm.asked).max():.3f} N asked")


if __name__ == "__main__":
    main()
