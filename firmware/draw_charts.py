# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of firmware/README.md from what the tests left in a folder.

mkdir -p build/charts
PALPATE_CHARTS=build/charts build/release/tests/test_laws -tc="full torque*"
PALPATE_CHARTS=build/charts build/release/tests/test_simavr_loops -tc="the gallbladder*,search*"
.venv/bin/python firmware/draw_charts.py build/charts firmware/pictures
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

OURS, THEIRS, PLAIN = "#1f77b4", "#d62728", "#777777"


def read_columns(path: Path) -> dict[str, list[float]]:
    with path.open() as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def draw_tissue_loop(folder: Path, out: Path) -> None:
    data = read_columns(folder / "tissue_loop.csv")
    figure, axes = plt.subplots(figsize=(7.2, 3.4), layout="constrained")
    axes.plot(data["time"], data["ideal"], color=PLAIN, label="ideal device")
    axes.plot(data["time"], data["applied"], color=THEIRS, lw=0.7, label="what the motors give")
    axes.plot(data["time"], data["commanded"], color=OURS, lw=0.7, label="what the tick asks for")
    axes.set(xlabel="time [s]", ylabel="force [N]", xlim=(1.0, 2.7), ylim=(-0.02, 0.2))
    axes.set_title("Pressing the gallbladder 6 mm deep", loc="left")
    axes.legend(frameon=False, loc="lower center")
    figure.savefig(out / "tissue_loop.png", dpi=130)


def draw_local_law(folder: Path, out: Path) -> None:
    data = read_columns(folder / "local_law.csv")
    delay = [1e3 * value for value in data["delay"]]
    figure, axes = plt.subplots(figsize=(7.2, 3.4), layout="constrained")
    axes.plot(delay, data["law"], "o-", color=OURS, label="as the device's local law")
    axes.plot(delay, data["torque"], "o-", color=THEIRS, label="as a torque")
    axes.set(xlabel="delay of the link, there and back [ms]", ylabel="largest stiffness [N/m]")
    axes.set_ylim(bottom=0)
    axes.set_title("How stiff a spring may be before it swings", loc="left")
    axes.legend(frameon=False)
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
        top.plot(data["time"], height, color=colour, lw=0.9, label=label)
        bottom.plot(data["time"], data["force"], color=colour, lw=0.9)
    top.axhline(0.0, color=PLAIN, lw=0.6)
    top.set(ylabel="height of the tip [mm]", xlim=(0.2, 2.0))
    top.set_title("A hand that wants to be 6 mm deep", loc="left")
    top.legend(frameon=False)
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
