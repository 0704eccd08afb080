# SPDX-License-Identifier: BSD-3-Clause
"""Draws what is soldered to what: the pin map of the board, the drivers, the sensors, the stop.

python firmware/mechanics/draw_wiring.py firmware/pictures/wiring.png
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

PINS = {
    "D0": "RX from the USB bridge, 1 Mbaud",
    "D1": "TX",
    "D2": "STOP",
    "D3": "PWM 3",
    "D4": "DIR 1",
    "D5": "ENABLE",
    "D6": "nFAULT",
    "D7": "DIR 2",
    "D8": "DIR 3",
    "D9": "PWM 1",
    "D10": "PWM 2",
    "D11": "button B",
    "D12": "button A",
    "A0": "yaw",
    "A1": "elevation",
    "A2": "forearm",
    "A3": "gimbal yaw",
    "A4": "gimbal pitch",
    "A5": "gimbal roll",
}
"""Pin of the Nano -> what it is for."""

INK, SOFT = "#1f2430", "#8a93a3"
POWER, GROUND, SIGNAL, SAFETY = "#c8452f", "#3b4252", "#2d6fb4", "#d08a1d"


def box(axes, x, y, width, height, title, words=(), colour=INK):
    axes.add_patch(plt.Rectangle((x, y), width, height, fc="#f6f7f9", ec=colour, lw=1.6, zorder=2))
    axes.text(x + width / 2, y + height - 0.32, title, ha="center", va="center", weight="bold",
              size=10, color=colour, zorder=3)  # fmt: skip
    for k, word in enumerate(words):
        axes.text(x + width / 2, y + height - 0.78 - 0.4 * k, word, ha="center", va="center",
                  size=8, color=INK, zorder=3)  # fmt: skip


def wire(axes, points, colour, width=1.4, words=""):
    axes.plot(*zip(*points, strict=True), color=colour, lw=width, zorder=1, solid_capstyle="round")
    if words:
        (x, y), (x2, _) = points[0], points[1]
        axes.text((x + x2) / 2, y + 0.11, words, ha="center", size=7.5, color=colour)


def draw_sensors(axes):
    """Six sensors on the left, each to its own input."""
    for k in range(6):
        pin, y = f"A{k}", 8.7 - 1.05 * k
        box(axes, 0.3, y - 0.38, 2.9, 0.76, f"{PINS[pin]} sensor")
        wire(axes, [(3.2, y), (6.2, y)], SIGNAL, words="1 kΩ, 100 nF to GND")
        axes.text(6.32, y, pin, va="center", size=9, color=SIGNAL, weight="bold", zorder=3)
    axes.text(1.75, 2.72, "each: 5V, GND, OUT\npotentiometer 10 kΩ or AS5600 (OUT, analog)\n"
              "one 5 V for the sensors and for AREF: ratiometric",
              ha="center", va="top", size=7.5, color=SOFT)  # fmt: skip


def draw_drivers(axes):
    """Three drivers and motors on the right."""
    rows = ((1, "D9", "D4", 8.2), (2, "D10", "D7", 6.2), (3, "D3", "D8", 4.2))
    for number, pwm, direction, y in rows:
        box(axes, 12.2, y - 0.75, 2.7, 1.5, f"driver {number}", ("PH/EN, DRV8876 class",))
        wire(axes, [(9.8, y + 0.3), (12.2, y + 0.3)], SIGNAL, words=f"PWM {number}")
        wire(axes, [(9.8, y - 0.3), (12.2, y - 0.3)], SIGNAL, words=f"DIR {number}")
        for pin, offset in ((pwm, 0.3), (direction, -0.3)):
            axes.text(9.68, y + offset, pin, ha="right", va="center", size=9, color=SIGNAL,
                      weight="bold", zorder=3)  # fmt: skip
        wire(axes, [(14.9, y), (16.0, y)], POWER, 2.2)
        axes.add_patch(plt.Circle((16.6, y), 0.6, fc="#f6f7f9", ec=INK, lw=1.6, zorder=2))
        name = ("yaw", "elevation", "forearm")[number - 1]
        axes.text(16.6, y, f"M{number}", ha="center", va="center", weight="bold", zorder=3)
        axes.text(16.6, y - 0.82, name, ha="center", size=8, color=INK)


def draw_safety(axes):
    """Enable, fault and the stop button, which also cuts the motors' supply."""
    for pin, y, words in (
        ("D5", 2.85, "ENABLE, 10 kΩ to GND"),
        ("D6", 2.35, "nFAULT, 10 kΩ to 5 V"),
    ):
        wire(axes, [(9.8, y), (13.5, y)], SAFETY, words=f"{words}, to all drivers")
        axes.text(
            9.68, y, pin, ha="right", va="center", size=9, color=SAFETY, weight="bold", zorder=3
        )
    wire(axes, [(13.5, 2.85), (13.5, 3.45)], SAFETY)
    wire(axes, [(13.5, 2.35), (13.9, 2.35), (13.9, 3.45)], SAFETY)
    box(axes, 4.4, 0.1, 3.6, 1.5, "emergency stop",
        ("two contacts, normally closed", "1: D2 to GND   2: motor supply"), SAFETY)  # fmt: skip
    wire(axes, [(7.0, 1.6), (7.0, 2.0)], SAFETY)
    axes.text(7.0, 2.18, "D2", ha="center", size=9, color=SAFETY, weight="bold", zorder=3)
    box(axes, 10.4, 0.1, 3.0, 1.5, "motor supply", ("12 V, 5 A, fuse 5 A",), POWER)
    wire(axes, [(10.4, 0.85), (8.0, 0.85)], POWER, 2.2, words="+12 V")
    wire(axes, [(4.4, 0.5), (4.1, 0.5), (4.1, -0.35), (17.6, -0.35), (17.6, 9.4), (13.55, 9.4),
                (13.55, 8.95)], POWER, 2.2)  # fmt: skip
    axes.text(
        15.6, 9.52, "+12 V, cut by the stop, to all drivers", ha="center", size=7.5, color=POWER
    )
    axes.text(15.0, 0.85, "One star point joins the grounds\nof supply, drivers and board.\n"
              "470 µF at each driver.", size=7.5, color=GROUND, va="center")  # fmt: skip


def draw(path: Path) -> None:
    figure, axes = plt.subplots(figsize=(13.2, 7.6), dpi=110)
    box(axes, 6.2, 1.95, 3.6, 7.3, "Nano, ATmega328P", ("5 V, 16 MHz",))
    axes.text(
        8.0, 7.75, "USB to the host\nFT232 or CH340", ha="center", size=8, color=INK, zorder=3
    )
    for y, pin in ((3.25, "D12"), (2.85, "D11")):
        axes.text(
            8.0, y + 0.3, f"{pin}: {PINS[pin]} to GND", ha="center", size=7.5, color=INK, zorder=3
        )
    draw_sensors(axes)
    draw_drivers(axes)
    draw_safety(axes)
    axes.set_xlim(0, 18)
    axes.set_ylim(-0.7, 10)
    axes.set_aspect("equal")
    axes.axis("off")
    figure.tight_layout(pad=0.3)
    figure.savefig(path)


if __name__ == "__main__":
    draw(Path(sys.argv[1]))
