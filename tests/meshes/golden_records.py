# SPDX-License-Identifier: BSD-3-Clause
"""Records of a press and a pull of many organs, which later versions replay bit by bit.

    .venv/bin/python tests/meshes/golden_records.py [NAME ...]

writes tests/references/records: one record for each organ and each form of its kernel, which is
each vector target that this machine has, and the plain code of the reference. A record that no
longer replays is written again only where a commit changes the force on purpose, and says by how
much. Those of organs of springs (tests/scenes/springs) are of what earlier versions shipped.
"""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from pathlib import Path

import palpate
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.replay import follow_header
from palpate.runs.run import describe_arithmetic, read_scene

CHECKOUT = Path(__file__).resolve().parents[2]
sys.path.append(str(CHECKOUT / "tests" / "bindings"))
from surfaces import run_frames  # noqa: E402

RECORDS = CHECKOUT / "tests" / "references" / "records"
ORGANS = CHECKOUT / "meshes" / "published"
SPRINGS = CHECKOUT / "tests" / "scenes" / "springs"
HASH_INTERVAL = 50
"""[ticks] between two hashes of the whole state."""
PLAIN = "plain"
STONE = "kidney_stone"
"""Gives nowhere, so it is pressed and pulled less."""

SHORT, LONG = (
    PressScript(2e-3, pull=3e-3, speed=0.05, hold=0.05),
    PressScript(6e-3, pull=8e-3, speed=0.1, hold=0.05),
)
SCENES = {
    "gallbladder": SPRINGS / "gallbladder.palpate",
    "kidney": SPRINGS / "kidney.palpate",
    "kidney_stone": ORGANS / "kidney_stone.palpate",
    "liver": SPRINGS / "liver.palpate",
    "simple_tissue": SPRINGS / "simple_tissue.palpate",
    "spleen": SPRINGS / "spleen.palpate",
    "stomach": SPRINGS / "stomach.palpate",
    "shell_gallbladder": ORGANS / "gallbladder.palpate",
    "shell_simple_tissue": ORGANS / "simple_tissue.palpate",
    "shell_stomach": ORGANS / "stomach.palpate",
    "solid_collecting_system": ORGANS / "collecting_system.palpate",
    "solid_kidney": ORGANS / "kidney.palpate",
    "solid_liver": ORGANS / "liver.palpate",
    "solid_spleen": ORGANS / "spleen.palpate",
}
"""Name of a record -> what is pressed and pulled."""


@dataclass(frozen=True)
class Golden:
    """A record that is kept."""

    name: str
    target: str
    """A vector target, or PLAIN for the reference kernel."""

    @property
    def path(self) -> Path:
        return RECORDS / f"{self.name}-{self.target}.prec"

    @property
    def can_run(self) -> bool:
        return self.target == PLAIN or self.target in palpate.simd_targets()


GOLDEN = [Golden(name, target) for name in SCENES for target in ("AVX3", "AVX2", "SSE4", PLAIN)]


def open_scene(golden: Golden) -> palpate.Scene:
    plain = {"kernel": "reference"}
    packed = {"kernel": "packed", "vector_target": golden.target}
    scene = read_scene(SCENES[golden.name])
    return follow_header(scene, plain if golden.target == PLAIN else packed)


def make_record(golden: Golden) -> palpate.Record:
    """Raises RuntimeError for an alarm."""
    scene = open_scene(golden)
    script = SHORT if golden.name == STONE else LONG
    frames, _ = write_script(find_top(scene), scene.instruments[0].tool.radius, script)
    header = json.dumps(describe_arithmetic(scene) | {"scene": SCENES[golden.name].name})
    return run_frames(scene, frames, header, HASH_INTERVAL)


def main() -> None:
    """Of every scene, or of those that are named."""
    RECORDS.mkdir(parents=True, exist_ok=True)
    for golden in GOLDEN:
        if sys.argv[1:] and golden.name not in sys.argv[1:]:
            continue
        if not golden.can_run:
            print(f"{golden.path.name}: this machine has no {golden.target}", file=sys.stderr)
            continue
        palpate.write_record(golden.path, make_record(golden))
        print(f"{golden.path.name}: {golden.path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
