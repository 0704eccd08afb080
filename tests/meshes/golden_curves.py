# SPDX-License-Identifier: BSD-3-Clause
"""Force against time of eleven presses of the shipped organs, kept across versions.

    .venv/bin/python tests/meshes/golden_curves.py

presses them again, writes tests/references/golden_curves.json and says how far each curve has come
from the one that stood there. Ticks run one after the other without a clock, so that the load of a
machine changes nothing; its vector target changes rounding only.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import palpate
from palpate.files.whole_file import write_whole
from palpate.runs.press import PressScript, find_place, find_top, write_script
from palpate.runs.run import read_scene

CHECKOUT = Path(__file__).resolve().parents[2]
CURVES = CHECKOUT / "tests" / "references" / "golden_curves.json"
ORGANS = CHECKOUT / "meshes" / "published"
INTERVAL = 0.01
"""[s] A point of a curve is the mean force over so long."""
DECIMALS = 5
"""Of a force [N] as it is kept."""
TOLERANCE = 0.02
"""[-] of the peak force: a change beyond it is explained in the commit that makes it."""

Curve = np.ndarray
"""[N] (k, 3) on the hand, k intervals."""


@dataclass(frozen=True)
class Press:
    """One press of a shipped organ."""

    organ: str
    script: PressScript
    at: tuple[float, float, float] | None = None
    """[m] The surface point nearest to this is pressed; None: from above."""


PRESSES = {
    "simple tissue, pressed": Press("simple_tissue", PressScript(6e-3)),
    "simple tissue, lifted": Press("simple_tissue", PressScript(3e-3, pull=10e-3)),
    "spleen, pressed": Press("spleen", PressScript(6e-3)),
    "spleen, front border": Press("spleen", PressScript(3e-3), (0.0, -0.05, 0.02)),
    "spleen, pulled": Press("spleen", PressScript(4e-3, pull=10e-3)),
    "kidney, pressed": Press("kidney", PressScript(6e-3)),
    "hollow kidney, pressed": Press("collecting_system", PressScript(6e-3)),
    "kidney stone, pressed": Press("kidney_stone", PressScript(2e-3)),
    "gallbladder, pressed": Press("gallbladder", PressScript(6e-3)),
    "liver, pressed": Press("liver", PressScript(6e-3)),
    "stomach, fast": Press("stomach", PressScript(6e-3, speed=0.2)),
}


def press(name: str) -> Curve:
    """Raises RuntimeError where the tissue raised an alarm."""
    what = PRESSES[name]
    scene = read_scene(ORGANS / f"{what.organ}.palpate")
    place = find_top(scene) if what.at is None else find_place(scene, np.array(what.at))
    frames, times = write_script(place, scene.instruments[0].tool.radius, what.script)
    device, world, dt = palpate.ScriptedDevice(frames), palpate.World(scene), 1.0 / scene.rate
    force = []
    for tick in range(round(times.end * scene.rate)):
        force.append(np.array(palpate.tick(scene, device.read(tick * dt), dt, world).force))
        if world.alarm.kind != palpate.AlarmKind.none:
            raise RuntimeError(f"{name}: {world.alarm.kind.name} at {tick * dt:.3f} s")
    group = round(INTERVAL * scene.rate)
    whole = len(force) // group * group
    return np.array(force[:whole]).reshape(-1, group, 3).mean(axis=1)


def compute_change(curve: Curve, kept: Curve) -> float:
    """[-] The largest difference at any time over the peak of the curve that is kept."""
    if curve.shape != kept.shape:
        return float("inf")
    return float(np.linalg.norm(curve - kept, axis=1).max() / find_peak(kept))


def find_peak(curve: Curve) -> float:
    return float(np.linalg.norm(curve, axis=1).max())


def read_curves() -> dict[str, Curve]:
    """The curves that are kept."""
    return {
        name: np.array(rows)
        for name, rows in json.loads(CURVES.read_text(encoding="utf-8"))["N"].items()
    }


def write_curves(curves: dict[str, Curve]) -> None:
    head = {
        "written by": "tests/meshes/golden_curves.py",
        "interval [s]": INTERVAL,
        "N": {name: np.round(curve, DECIMALS).tolist() for name, curve in curves.items()},
    }
    text = json.dumps(head, separators=(",", ":"))
    write_whole(CURVES, text.replace("]],", "]],\n").replace('{"', '{\n"').encode() + b"\n")


def main() -> None:
    kept = read_curves() if CURVES.exists() else {}
    curves = {name: press(name) for name in PRESSES}
    write_curves(curves)
    for name, curve in curves.items():
        change = f"{100 * compute_change(curve, kept[name]):.2f} %" if name in kept else "new"
        print(f"{name:24} peak {find_peak(curve):7.4f} N   {change}")


if __name__ == "__main__":
    main()
