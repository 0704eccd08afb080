# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `felt`: what a hand feels before and after the near field, as tables."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path

import palpate
from palpate import scenario
from palpate.command.verb import Report, Verb
from palpate.files.refusal import Refusal
from palpate_meshes.catalogue import PUBLISHED

PARTS = ("block", "mesh", "scenes", "cost")
SCENES = ("spleen", "kidney", "liver", "gallbladder", "stomach")
"""Of those that ship."""


def add_felt(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "scenes",
        nargs="*",
        type=Path,
        metavar="FILE.palpate",
        help="scenes whose force is taken apart; without any, organs that ship",
    )
    parser.add_argument(
        "--only",
        action="append",
        choices=PARTS,
        help="may be repeated. block: balls over theory; mesh: one body, coarse to fine; scenes: "
        "what carries them; cost: touch over air. All without it",
    )


def run_felt(call: argparse.Namespace) -> Report:
    # they load SciPy, which every other command does without
    from palpate.study.felt import press_block

    from palpate_editor.felt import measure_costs, press_meshes

    scenes = call.scenes or [PUBLISHED / f"{name}.palpate" for name in SCENES]
    parts: dict[str, Callable[[], list]] = {
        "block": press_block,
        "mesh": press_meshes,
        "scenes": lambda: list(map(measure_scene, scenes)),
        "cost": measure_costs,
    }
    wanted = call.only or PARTS
    if "scenes" in wanted:  # before the others, which take minutes
        for path in scenes:
            read_one(path)
    return {name: [asdict(row) for row in parts[name]()] for name in PARTS if name in wanted}


def measure_scene(path: Path) -> object:
    """Raises FileError or Refusal."""
    from palpate.study.felt import measure_shares

    return measure_shares(str(path), read_one(path))


def read_one(path: Path) -> palpate.Scene:
    """Raises FileError, or Refusal for a scene of several bodies or instruments."""
    scene = scenario.read(str(path)).scene
    for name, found in (("bodies", scene.bodies), ("instruments", scene.instruments)):
        if len(found) != 1:
            raise Refusal(path, f"scene.{name}", str(len(found)), "1, whose force is taken apart")
    return scene


def describe_felt(report: Report) -> str:
    from palpate_editor.felt_tables import write_felt

    return write_felt(report)


VERBS = [
    Verb(
        "felt",
        "say what a hand feels before and after the near field, on meshes, in scenes, at what cost",
        "palpate felt --only block --only mesh",
        add_felt,
        run_felt,
        describe_felt,
    )
]
