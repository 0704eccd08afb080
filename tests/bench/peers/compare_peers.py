# SPDX-License-Identifier: BSD-3-Clause
"""Palpate beside MuJoCo, PyBullet and Newton on the common work of body.py.

    compare_peers.py --anchor ANCHOR --python PEERS_PYTHON [--quick] [--json FILE]

Every engine gets the same springs, masses and path of the ball and one thread, and is timed in CPU
time between two runs of the plain loop (anchor.cpp); anchors more than 5 % apart are thrown
away and done again. An engine's step counts only where the force on the ball, read from the
positions alone, lies within 10 % of a converged run of the very same springs: with contact of
vertices for engines that touch vertices, of faces for those that touch faces or edges. Of the steps
that pass, the one with the largest real-time factor is shown.

Fails, with a sentence, where an engine that should have run gave no row.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from quoted import QUOTED, QUOTED_LARGEST, SOURCE
from table import describe

HERE = Path(__file__).parent
SIZES, QUICK_SIZES = (600, 2000, 5400, 20_000), (600, 2000)
GATE = 0.10
"""How far a force may lie from the converged one."""
APART = 0.05
"""How far two anchors may lie apart."""
TRIES = 4
CONVERGED_STEP = 0.02
"""[ms] The force changes by less than 0.1 % when it is halved."""
TIMEOUT = 240.0
"""[s] by the clock, for one run of an engine, what it needs to load included."""


@dataclass(frozen=True)
class Peer:
    """How an engine is asked."""

    name: str
    program: str
    steps: tuple[float, ...]
    """[ms] tried, the longest first."""
    reference: str
    """What its force must agree with: vertices, faces, or faces of the tethered shell."""
    variants: tuple[tuple[str, ...], ...] = ((),)
    """Further words to the program; each is tried."""
    most: int = 1_000_000
    """Vertices above which it is not run."""
    why_not: str = ""
    ours: bool = False


PEERS = (
    Peer(
        "Palpate",
        "palpate_engine.py",
        (5.0, 2.0, 1.0, 0.5, 0.2),
        "faces",
        (("3e7", "0"), ("1e8", "0"), ("3e7", "1e-3"), ("1e8", "1e-3")),
        ours=True,
    ),
    Peer(
        "MuJoCo",
        "mujoco_engine.py",
        (1.0, 0.7, 0.5, 0.35, 0.2, 0.1, 0.05),
        "faces",
        most=5400,
        why_not="its compiler takes minutes for 20 000 vertices",
    ),
    Peer("Newton", "newton_engine.py", (2.0, 1.0, 0.7, 0.5, 0.35, 0.2, 0.1), "vertices"),
    Peer(
        "PyBullet",
        "pybullet_engine.py",
        (4.0, 2.0, 1.0, 0.5, 0.25),
        "tethered",
        most=5400,
        why_not="it takes more than 200 s to load 20 000 vertices",
    ),
)


class Failure(Exception):
    """A program that gave no answer."""


class Runner:
    """Runs programs one at a time, on one thread."""

    def __init__(self, anchor: str, python: str, folder: Path):
        # not resolved: the link itself is what makes a virtual environment
        self.anchor, self.python = os.path.abspath(anchor), os.path.abspath(python)
        self.folder = folder
        self.environment = {
            **os.environ,
            **dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1"),
        }

    def run(self, words: list[str], timeout: float = TIMEOUT) -> dict:
        try:
            done = subprocess.run(
                words,
                capture_output=True,
                encoding="utf-8",
                timeout=timeout,
                env=self.environment,
                cwd=self.folder,  # where engines leave their logs
            )
        except subprocess.TimeoutExpired:
            return {"why": f"gave up after {timeout:.0f} s"}
        lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
        if done.returncode != 0 or not lines:
            raise Failure(f"{Path(words[1]).name}: {last_line(done.stderr)}")
        return json.loads(lines[-1])

    def ask(self, peer: Peer, vertices: int, step: float, variant: tuple[str, ...]) -> dict:
        python = sys.executable if peer.ours else self.python
        return self.run([python, str(HERE / peer.program), str(vertices), str(step), *variant])

    def body(self, vertices: int, tethered: bool) -> str:
        path = self.folder / f"{vertices}{'-tethered' if tethered else ''}"
        if not path.exists():
            words = [sys.executable, str(HERE / "write_body.py"), str(vertices), str(path)]
            subprocess.run(words + ["tethered"] * tethered, check=True)
        return str(path)

    def loop(self, vertices: int, step: float, *, tethered=False, faces=False) -> dict:
        words = [self.anchor, self.body(vertices, tethered), str(step)]
        return self.run(words + ["faces"] * faces)

    def converge(self, vertices: int, reference: str) -> float:
        """[N] The force of a run with a very short step."""
        faces, tethered = reference != "vertices", reference == "tethered"
        return self.loop(vertices, CONVERGED_STEP, tethered=tethered, faces=faces)["force"]


def last_line(text: str) -> str:
    lines = text.strip().splitlines()
    return lines[-1] if lines else "no word"


def find_anchor_step(runner: Runner, vertices: int, force: float) -> float:
    """[ms] The plain loop's own longest step that passes the gate."""
    for step in (2.0, 1.4, 1.0, 0.7, 0.5, 0.35, 0.25, 0.18, 0.12, 0.08, 0.05):
        if passes(runner.loop(vertices, step), force):
            return step
    raise Failure(f"plain loop: {vertices} vertices: no step passes the gate")


def passes(row: dict, force: float) -> bool:
    return "force" in row and abs(row["force"] / force - 1.0) <= GATE


def time_between_anchors(
    runner: Runner, peer: Peer, vertices: int, step: float, variant: tuple[str, ...], anchor: float
) -> dict:
    """The row of one step, with the plain loop's cost before and after."""
    for _ in range(TRIES):
        before = runner.loop(vertices, anchor)["median_us"]
        row = runner.ask(peer, vertices, step, variant)
        after = runner.loop(vertices, anchor)["median_us"]
        apart = abs(after / before - 1.0)
        if apart <= APART or "why" in row:
            break
    return {**row, "anchor_us": (before + after) / 2.0, "anchors_apart": apart}


def measure(runner: Runner, peer: Peer, vertices: int, force: float, anchor: float) -> dict:
    """The best row of a peer that passes the gate, or why there is none."""
    best, tried = None, []
    for variant in peer.variants:
        for step in peer.steps:
            row = time_between_anchors(runner, peer, vertices, step, variant, anchor)
            tried.append(describe_try(row, step, force))
            if not passes(row, force):
                continue
            row["real_time_factor"] = 1e3 * step / row["median_us"]
            if best is None or row["real_time_factor"] > best["real_time_factor"]:
                best = row
            elif row["real_time_factor"] < 0.8 * best["real_time_factor"]:
                break  # shorter steps only cost more
    if best is None:
        return {"peer": peer.name, "vertices": vertices, "passes": False, "tried": tried}
    return {
        "peer": peer.name,
        "passes": True,
        "reference": peer.reference,
        "force_error": best["force"] / force - 1.0,
        "step_ratio": best["median_us"] / best["anchor_us"],
        "tried": tried,
        **best,
    }


def describe_try(row: dict, step: float, force: float) -> str:
    if "force" not in row:
        return f"{step:g} ms: {row['why']}"
    return f"{step:g} ms: force {row['force'] / force - 1.0:+.0%}, {row['median_us']:.0f} us"


def measure_size(runner: Runner, vertices: int, rows: list[dict], missing: list[str]) -> None:
    forces = {name: runner.converge(vertices, name) for name in ("vertices", "faces", "tethered")}
    anchor = find_anchor_step(runner, vertices, forces["vertices"])
    loop = runner.loop(vertices, anchor)
    loop_cost = loop["median_us"]
    rows.append(
        {
            "peer": "plain loop",
            "vertices": vertices,
            "passes": True,
            "dt_ms": anchor,
            "median_us": loop_cost,
            "p99_us": loop["p99_us"],
            "step_ratio": 1.0,
            "real_time_factor": 1e3 * anchor / loop_cost,
            "force_error": loop["force"] / forces["vertices"] - 1.0,
            "forces": forces,
        }
    )
    for peer in PEERS:
        print(f"{peer.name}: {vertices} vertices", file=sys.stderr, flush=True)
        if vertices > peer.most:
            rows.append({"peer": peer.name, "vertices": vertices, "not_run": peer.why_not})
            continue
        try:
            rows.append(measure(runner, peer, vertices, forces[peer.reference], anchor))
        except Failure as failure:
            missing.append(f"{peer.name}: {vertices} vertices: {failure}")
    rows += quote(vertices, loop_cost)


def quote(vertices: int, loop_cost: float) -> list[dict]:
    """Engines measured once, as ratios to the plain loop then; here times the plain loop now."""
    return [
        {
            "peer": name,
            "vertices": vertices,
            "quoted": True,
            "dt_ms": step,
            "step_ratio": ratio,
            "median_us": ratio * loop_cost,
            "real_time_factor": 1e3 * step / (ratio * loop_cost),
        }
        for name, by_size in QUOTED.items()
        for size, (step, ratio) in by_size.items()
        if size == vertices
    ]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--anchor", required=True, help="the program built from anchor.cpp")
    parser.add_argument("--python", required=True, help="Python of the peers' environment")
    parser.add_argument("--quick", action="store_true", help="600 and 2000 vertices only")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the rows")
    call = parser.parse_args()
    rows: list[dict] = []
    missing: list[str] = []
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(call.anchor, call.python, Path(folder))
        for vertices in QUICK_SIZES if call.quick else SIZES:
            measure_size(runner, vertices, rows, missing)
    report = {
        "rows": rows,
        "missing": missing,
        "gate": GATE,
        "quoted_from": SOURCE,
        "quoted_largest": QUOTED_LARGEST,
    }
    if call.json:
        call.json.write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")
    print(describe(report))
    for sentence in missing:
        print(f"compare_peers: missing: {sentence}", file=sys.stderr)
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
