# SPDX-License-Identifier: BSD-3-Clause
"""Everything that `./run bench` measures, in one go: our rows, our tree and our tick beside others.

    bench_all.py --trees COMPARE_TREES --anchor ANCHOR --python PEERS_PYTHON [--quick] [--json]
                 [--chart FILE.png]

Fails, with a sentence for each, where a row is missing.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from palpate.bench.meshes import find_published
from palpate.bench.rows import describe_rows
from palpate.cli.bench import BENCH
from palpate.cli.main import build_parser
from ratio_chart import save_ratio_chart

PEERS = Path(__file__).parent / "peers"
sys.path.insert(0, str(PEERS))
import table as peers_table  # noqa: E402  (stands beside the engines' programs)

Report = dict[str, Any]
SURFACE = "gallbladder"


def measure_rows(quick: bool) -> Report:
    words = ["bench", "--quick"] if quick else ["bench"]
    return BENCH.run(build_parser({"bench": BENCH}).parse_args(words))


def measure_trees(program: str) -> Report:
    """The rows of compare_trees; `missing` where it ended in a sentence."""
    print(f"trees: {SURFACE}", file=sys.stderr, flush=True)
    surface = find_published() / f"{SURFACE}.obj"
    done = subprocess.run([program, str(surface), "--json"], capture_output=True, encoding="utf-8")
    report = json.loads(done.stdout) if done.stdout.startswith("{") else {"rows": []}
    sentence = done.stderr.strip() or f"compare_trees ended with {done.returncode}"
    return {**report, "missing": [sentence] if done.returncode != 0 else []}


def measure_peers(anchor: str, python: str, quick: bool) -> Report:
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "peers.json"
        words = ["--anchor", anchor, "--python", python, "--json", str(out)]
        done = subprocess.run(
            [sys.executable, str(PEERS / "compare_peers.py"), *words, *["--quick"] * quick],
            stdout=subprocess.DEVNULL,
        )
        if not out.exists():
            return {"rows": [], "missing": [f"compare_peers.py ended with {done.returncode}"]}
        return json.loads(out.read_text(encoding="utf-8"))


def describe_trees(report: Report) -> str:
    lines = [f"{'work':8} {'tree':12} {'median us':>10} {'x ours':>8}   on the {SURFACE}"]
    for row in report["rows"]:
        ratio = row["ratio_to_palpate"]
        head = f"{row['work']:8} {row['library']:12} {row['median_us']:10.2f} "
        if ratio is None:
            unit = "triangles" if row["work"] == "sphere" else "m"
            lines.append(
                head + f"results differ: not compared ({row['other_answers']:.1%} of them, by up "
                f"to {row['farthest_answer']:.2g} {unit})   {row['note']}"
            )
        else:
            lines.append(head + f"{ratio:8.2f}   {row['note']}")
    return "\n".join(lines)


def describe(report: Report) -> str:
    words = [describe_rows(report["rows"]), describe_trees(report["trees"])]
    if report["peers"]["rows"]:
        words.append(peers_table.describe(report["peers"]))
    return "\n\n".join(words)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trees", required=True, help="the program compare_trees")
    parser.add_argument("--anchor", required=True, help="the program anchor")
    parser.add_argument("--python", required=True, help="Python of the peers' environment")
    parser.add_argument("--quick", action="store_true", help="small meshes, little time a row")
    parser.add_argument("--json", action="store_true", help="report as JSON on standard output")
    parser.add_argument("--chart", type=Path, metavar="FILE.png", help="the ratios as a picture")
    call = parser.parse_args()
    report = {
        "rows": measure_rows(call.quick),
        "trees": measure_trees(call.trees),
        "peers": measure_peers(call.anchor, call.python, call.quick),
    }
    print(json.dumps(report, indent=2) if call.json else describe(report))
    if call.chart:
        save_ratio_chart(call.chart, report)
    missing = [sentence for part in report.values() for sentence in part["missing"]]
    for sentence in missing:
        print(f"bench: missing: {sentence}", file=sys.stderr)
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
