# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that shows everything at once: demo."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from palpate.verb import Refusal, Report, Verb

from palpate_editor.demo import CONSTANTS, run_demo
from palpate_editor.verbs.mesh import add_source


def add_demo(word: argparse.ArgumentParser) -> None:
    word.add_argument("--mesh", type=Path, help="organ to use; default: a generated spleen")
    word.add_argument("--vertices", type=int, default=600, help="of the model (600)")
    word.add_argument("--out", type=Path, default=Path("demo"), help="folder (demo)")
    word.add_argument("--constants", type=Path, default=CONSTANTS, help="TOML; default: demo.toml")
    add_source(word)


def run_demo_verb(call: argparse.Namespace) -> Report:
    def say(line: str) -> None:
        print(line, file=sys.stderr, flush=True)

    try:
        return run_demo(
            call.out,
            call.mesh,
            call.vertices,
            call.constants,
            tuple(call.part),
            call.unit,
            call.up,
            say,
        )
    except ValueError as problem:
        raise Refusal(call.mesh, "", str(problem), "an organ a tissue can be built on") from None


def describe_demo(report: Report) -> str:
    def row(kind: str) -> str:
        r = report[kind]
        return (
            f"{kind}: peak {r['peak_force_N']:.2f} N, pull {r['pull_force_N']:.2f} N, patch "
            f"{r['patch_stiffness_N_per_m']:.0f} N/m, tick {r['tick_median_us']:.0f} us, "
            f"replay {'equal' if r['replay_equal'] else 'DIFFERS'}"
        )

    return "\n".join(
        [
            f"{report['organ']}: {report['vertices']} vertices, {report['triangles']} triangles",
            row("mss"),
            row("mms"),
        ]
    )


VERBS = [
    Verb(
        "demo",
        "run the main job from mesh file to felt force",
        "palpate demo --mesh VH_F_Spleen.glb --out demo",
        add_demo,
        run_demo_verb,
        describe_demo,
        failed=lambda report: not all(report[kind]["replay_equal"] for kind in ("mss", "mms")),
    ),
]
