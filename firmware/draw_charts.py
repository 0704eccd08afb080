# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of firmware/README.md from what the tests left in a folder.

mkdir -p build/charts
PALPATE_CHARTS=build/charts build/release/tests/test_laws -tc="full torque*"
PALPATE_CHARTS=build/charts build/release/tests/test_arm -tc="search*"
PALPATE_CHARTS=build/charts build/release/tests/test_simavr_loops -tc="the gallbladder*"
.venv/bin/python firmware/draw_charts.py build/charts firmware/pictures
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

OURS, THEIRS, PLAIN = "#1f77b4", "#d62728", "#777777"


def read_columns(path: Path) -> dict[str, list[float]]:
    with path.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def smooth(values: list[float], ticks: int = 20) -> np.ndarray:
    """The mean over so many ticks about each."""
    return np.convolve(values, np.full(ticks, 1.0 / ticks), mode="same")


def draw_tissue_loop(folder: Path, out: Path) -> None:
    data = read_columns(folder / "tissue_loop.csv")
    figure, (top, bottom) = plt.subplots(
        2, 1, figsize=(7.2, 5.2), sharex=True, layout="constrained", height_ratios=(2, 1)
    )
    time = data["time"]
    top.plot(time, data["ideal"], color=PLAIN, lw=1.8, label="ideal device")
    for name, colour, label in (
        ("applied", THEIRS, "what the motors give"),
        ("commanded", OURS, "what the tick asks for"),
    ):
        top.plot(time, data[name], color=colour, lw=0.4, alpha=0.35)
        top.plot(time, smooth(data[name]), color=colour, lw=1.3, label=f"{label}, mean of 20 ms")
    top.set(ylabel="force [N]", xlim=(1.0, 2.7), ylim=(-0.03, 0.22))
    top.set_title("A hand presses the gallbladder 6 mm deep and rests for a second", loc="left")
    top.legend(frameon=False, loc="lower center")
    bottom.plot(time, [1e3 * z for z in data["ideal_height"]], color=PLAIN, lw=1.8)
    bottom.plot(time, [1e3 * z for z in data["height"]], color=OURS, lw=1.3)
    bottom.axhline(0.0, color=PLAIN, lw=0.6)
    bottom.set(xlabel="time [s]", ylabel="height of the tip [mm]", ylim=(-7, 10))
    figure.savefig(out / "tissue_loop.png", dpi=130)


def draw_local_law(folder: Path, out: Path) -> None:
    data = read_columns(folder / "local_law.csv")
    delay = [1e3 * value for value in data["delay"]]
    figure, axes = plt.subplots(figsize=(7.2, 3.4), layout="constrained")
    axes.plot(delay, data["law"], "o-", color=OURS, label="with the local law")
    axes.plot(delay, data["torque"], "o-", color=THEIRS, label="without")
    for x, with_law, without in zip(delay, data["law"], data["torque"], strict=True):
        axes.annotate(
            f"{with_law / without:.1f} times", (x, with_law), xytext=(0, 7),
            textcoords="offset points", ha="center", fontsize=8,
        )  # fmt: skip
    axes.set(xlabel="delay of the link, there and back [ms]", ylabel="largest stiffness [N/m]")
    axes.set_ylim(0, 1.25 * max(data["law"]))
    axes.set_title("How stiff a spring may be before the bare arm swings", loc="left")
    axes.legend(frameon=False, loc="center right")
    figure.savefig(out / "local_law.png", dpi=130)


def draw_contact(folder: Path, out: Path) -> None:
    figure, (top, bottom) = plt.subplots(
        2, 1, figsize=(7.2, 4.8), sharex=True, layout="constrained"
    )
    for name, colour, label in (
        ("full_torque", THEIRS, "full torque on contact"),
        ("tissue_force", OURS, "the tissue's force"),
    ):
        data = read_columns(folder / f"contact_{name}.csv")
        height = [1e3 * value for value in data["height"]]
        energy = 1e3 * data["energy"][-1]
        given = f"{label}: {energy:.1f} mJ given"
        top.plot(data["time"], height, color=colour, lw=0.9, label=given)
        bottom.plot(data["time"], data["force"], color=colour, lw=0.9)
    top.axhline(0.0, color=PLAIN, lw=0.6)
    top.annotate("surface", (1.98, 0.4), ha="right", fontsize=8, color=PLAIN)
    top.set(ylabel="height of the tip [mm]", xlim=(0.2, 2.0))
    top.set_title("A hand that wants to be 6 mm deep, under two rules", loc="left")
    top.legend(frameon=False, loc="upper center")
    bottom.set(xlabel="time [s]", ylabel="motors, weight included [N]")
    figure.savefig(out / "contact.png", dpi=130)


def main() -> None:
    if len(sys.argv) != 3:
        sys.exit(f"usage: {sys.argv[0]} FOLDER_OF_TABLES FOLDER_OF_PICTURES")
    folder, out = Path(sys.argv[1]), Path(sys.argv[2])
    draw_tissue_loop(folder, out)
    draw_local_law(folder, out)
    draw_contact(folder, out)


if __name__ == "__main__":
    main()
