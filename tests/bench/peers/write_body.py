# SPDX-License-Identifier: BSD-3-Clause
"""Writes the common work for anchor.cpp: `write_body.py N FILE [tethered]`."""

from __future__ import annotations

import sys

import numpy as np
from body import (
    CLEARANCE,
    DEPTH,
    HALF_AXES,
    PRESS_TIME,
    RADIUS,
    STIFFNESS,
    WINDOW,
    Body,
    build_body,
)


def write_body(path: str, body: Body) -> None:
    counts = (
        *(body.vertices, len(body.x), len(body.edges)),
        *(len(body.fixed), len(body.triangles)),
    )
    numbers = (
        *(body.mass, STIFFNESS, body.damping, body.home, RADIUS),
        *(HALF_AXES[2] + RADIUS + CLEARANCE, DEPTH + CLEARANCE, PRESS_TIME, WINDOW[0]),
    )
    with open(path, "w", encoding="ascii") as file:
        file.write(" ".join(map(str, counts)) + "\n")
        file.write(" ".join(f"{number:.17g}" for number in numbers) + "\n")
        np.savetxt(file, body.x, "%.17g")
        np.savetxt(file, body.edges, "%d")
        np.savetxt(file, body.fixed, "%d")
        np.savetxt(file, body.triangles, "%d")


if __name__ == "__main__":
    write_body(sys.argv[2], build_body(int(sys.argv[1]), tethered=sys.argv[3:] == ["tethered"]))
