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

from device_runs import DeviceRun, press_through, press_wall  # noqa: E402

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


def measure_wall(run: DeviceRun) -> tuple[float, float]:
    """What the motors gave the hand once it rested in the wall [J], and how far it swings [m]."""
    held = run.time > 1.5
    way = np.diff(run.hand[held], axis=0)
    given = float((run.motor[held][:-1] * way).sum())
    return given, float(np.ptp(run.hand[held][:, 2]))


def plot_walls(path: Path, runs: dict[str, DeviceRun]) -> None:
    figure = Figure(figsize=(9.0, 4.4), layout="constrained")
    every = figure.subplots(2, 2, sharex=True, sharey="row")
    for column, (name, run) in enumerate(runs.items()):
        given, swing = measure_wall(run)
        shown = (run.time > 0.9) & (run.time < 1.9)
        forces, ways = every[:, column]
        forces.plot(run.time[shown], run.motor[shown][:, 2], color=MOTOR, lw=0.9)
        ways.plot(run.time[shown], 1e3 * run.hand[shown][:, 2], color=ASKED, lw=0.9)
        ways.axhline(0.0, color=IDEAL, lw=0.8, ls=":")
        forces.set_title(
            f"{name}: {1e3 * given:.2f} mJ given in 1 s, swings {1e3 * swing:.2f} mm", fontsize=10
        )
        ways.set_xlabel("time [s]")
    every[0, 0].set_ylabel("force of the motors [N]")
    every[1, 0].set_ylabel("tip above the wall [mm]")
    for axes in every.flat:
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=110)


def main() -> None:
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("-o", "--out", type=Path, required=True, help="folder")
    out = words.parse_args().out
    scene = palpate.scenario.read(GALLBLADDER).scene
    ideal, arm = press_through(scene, "ideal"), press_through(scene, "plant")
    plot(out / "press.png", ideal, arm)
    print(f"press: peak {size(ideal.asked).max():.3f} N ideal, {size(arm.asked).max():.3f} N asked")
    runs = {
        "full torque on contact": press_wall(lambda depth: 1.6 if depth > 0.0 else 0.0),
        "spring of 200 N/m": press_wall(lambda depth: 200.0 * max(0.0, depth)),
    }
    plot_walls(out / "full_torque.png", runs)
    for name, run in runs.items():
        given, swing = measure_wall(run)
        print(f"{name}: {1e3 * given:.2f} mJ given in 1 s, swings {1e3 * swing:.2f} mm")


if __name__ == "__main__":
    main()
