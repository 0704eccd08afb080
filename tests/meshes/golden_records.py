# SPDX-License-Identifier: BSD-3-Clause
"""Records of a press and a pull of every shipped organ, which later versions replay bit by bit.

    .venv/bin/python tests/meshes/golden_records.py

writes tests/references/records: one record for each organ and each form of its kernel, which is
each vector target that this machine has, and the plain code of the reference. A record that no
longer replays is written again only where a commit changes the force on purpose, and says by how
much.
"""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from pathlib import Path

import palpate
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.run import describe_arithmetic, follow_header, read_scene

CHECKOUT = Path(__file__).resolve().parents[2]
sys.path.append(str(CHECKOUT / "tests" / "bindings"))
from surfaces import run_frames  # noqa: E402

RECORDS = CHECKOUT / "tests" / "references" / "records"
ORGANS = CHECKOUT / "meshes" / "published"
HASH_INTERVAL = 50
"""[ticks] between two hashes of the whole state."""
PLAIN = "plain"

PRESSES = {
    "gallbladder": PressScript(6e-3, pull=8e-3, speed=0.1, hold=0.05),
    "kidney": PressScript(6e-3, pull=8e-3, speed=0.1, hold=0.05),
    "kidney_stone": PressScript(2e-3, pull=3e-3, speed=0.05, hold=0.05),
    "liver": PressScript(6e-3, pull=8e-3, speed=0.1, hold=0.05),
    "simple_tissue": PressScript(6e-3, pull=8e-3, speed=0.1, hold=0.05),
    "spleen": PressScript(6e-3, pull=8e-3, speed=0.1, hold=0.05),
    "stomach": PressScript(6e-3, pull=8e-3, speed=0.1, hold=0.05),
}


@dataclass(frozen=True)
class Golden:
    """A record that is kept."""

    organ: str
    target: str
    """A vector target, or PLAIN for the reference kernel."""

    @property
    def path(self) -> Path:
        return RECORDS / f"{self.organ}-{self.target}.prec"

    @property
    def can_run(self) -> bool:
        return self.target == PLAIN or self.target in palpate.simd_targets()


GOLDEN = [Golden(organ, target) for organ in PRESSES for target in ("AVX3", "AVX2", "SSE4", PLAIN)]


def open_scene(golden: Golden) -> palpate.Scene:
    plain = {"kernel": "reference"}
    packed = {"kernel": "packed", "vector_target": golden.target}
    scene = read_scene(ORGANS / f"{golden.organ}.palpate")
    return follow_header(scene, plain if golden.target == PLAIN else packed)


def make_record(golden: Golden) -> palpate.Record:
    """Raises RuntimeError for an alarm."""
    scene = open_scene(golden)
    frames, _ = write_script(
        find_top(scene), scene.instruments[0].tool.radius, PRESSES[golden.organ]
    )
    header = json.dumps(describe_arithmetic(scene) | {"scene": f"{golden.organ}.palpate"})
    return run_frames(scene, frames, header, HASH_INTERVAL)


def main() -> None:
    RECORDS.mkdir(parents=True, exist_ok=True)
    for golden in GOLDEN:
        if not golden.can_run:
            print(f"{golden.path.name}: this machine has no {golden.target}", file=sys.stderr)
            continue
        palpate.write_record(golden.path, make_record(golden))
        print(f"{golden.path.name}: {golden.path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
