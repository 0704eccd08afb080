# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that shows everything at once: demo."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from palpate.command.output import Files, add_output_folder
from palpate.command.terminal import make_harmless
from palpate.command.verb import Report, Verb
from palpate.files.file_kind import (
    OBJ,
    ORGAN,
    PICTURE,
    PUBLISHED,
    RECORD,
    REPLAY,
    SCENE,
    SCRIPT,
    SUMMARY,
)
from palpate.files.refusal import Refusal

from palpate_editor.demo import SHIPPED, TOUCHED, can_show_windows, open_editor, run_demo
from palpate_editor.document.defaults import CONSTANTS
from palpate_editor.edits import EditError
from palpate_editor.publish import PublishError
from palpate_editor.shipped import find_mesh
from palpate_editor.verbs.source import add_source


def add_demo(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--mesh", type=Path, help="organ to use; default: the spleen that ships")
    parser.add_argument("--vertices", type=int, default=600, help="of the model (600)")
    add_output_folder(
        parser, "--out", writes=list_outputs, default=Path("demo"), help="folder (demo)"
    )
    parser.add_argument(
        "--constants", type=Path, default=CONSTANTS, help="TOML; default: demo.toml"
    )
    parser.add_argument(
        "--no-window", action="store_true", help="do not open the editor on what was made"
    )
    add_source(parser)


def list_outputs(call: argparse.Namespace) -> Files:
    """What a demo writes into its folder."""
    name = (call.mesh or find_mesh(SHIPPED)).stem
    kinds = {
        **{"organ.obj": OBJ, "picture.png": PICTURE, "force_plot.png": PICTURE},
        **{f"{name}.organ": ORGAN, f"{name}.palpate": PUBLISHED, "press.script.json": SCRIPT},
        **{f"{kind}.scene.json": SCENE for kind in TOUCHED},
        **{f"{run}.prec": RECORD for run in (*TOUCHED, "play")},
        **{f"{run}.replay.json": REPLAY for run in (*TOUCHED, "play")},
        "summary.json": SUMMARY,
    }
    return [(call.out / file, kind) for file, kind in kinds.items()]


def run_demo_verb(call: argparse.Namespace) -> Report:
    def say(line: str) -> None:
        print(make_harmless(line), file=sys.stderr, flush=True)

    try:
        report = run_demo(
            call.out,
            call.mesh,
            call.vertices,
            call.constants,
            tuple(call.part),
            call.unit,
            call.up,
            say,
        )
    except (ValueError, EditError, PublishError) as problem:
        raise Refusal(call.mesh, "", str(problem), "an organ a tissue can be built on") from None
    if not call.no_window and can_show_windows():
        open_editor(call.out / report["working"])
        say(f"editor    opens on {report['working']}; --no-window keeps it shut")
    return report


def describe_demo(report: Report) -> str:
    def row(kind: str) -> str:
        r = report[kind]
        return (
            f"{kind}: peak {r['peak_force_N']:.2f} N, pull {r['pull_force_N'] or 0.0:.2f} N, patch "
            f"{r['patch_stiffness_N_per_m'] or 0.0:.0f} N/m, tick {r['tick_median_us']:.0f} us, "
            f"replay {'equal' if r['replay_equal'] else 'DIFFERS'}"
        )

    play = report["play"]
    return "\n".join(
        [
            f"{report['organ']}: {report['vertices']} vertices, {report['triangles']} triangles",
            row("mss"),
            row("mms"),
            f"{report['published']}: played, peak {play['peak_force_N']:.2f} N, replay "
            f"{'equal' if play['replay_equal'] else 'DIFFERS'}",
        ]
    )


def differs(report: Report) -> bool:
    """Whether some replay did not give the forces that were felt."""
    return not all(report[run]["replay_equal"] for run in ("mss", "mms", "play"))


VERBS = [
    Verb(
        "demo",
        "run the main job from mesh file to a published organ that was felt",
        "palpate demo --mesh VH_F_Spleen.glb --out demo",
        add_demo,
        run_demo_verb,
        describe_demo,
        failed=differs,
    ),
]
