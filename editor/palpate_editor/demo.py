# SPDX-License-Identifier: GPL-3.0-or-later
"""The main job from end to end: mesh file, two tissues, touch, record, replay, pictures."""

from __future__ import annotations

import json
import subprocess
import sys
import tomllib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import palpate
from palpate.press import PressScript, find_top
from palpate.run import Run, picture_of_record, plot_runs, run_script
from palpate.scene_file import hash_file, open_scene, write_scene_file
from palpate.scene_parts import HandPart, MaterialPart, ModelPart, OrganPart, SceneFile, ToolPart
from palpate.verb import Refusal, Report
from palpate.whole_file import write_whole

from palpate_editor.authoring import decimate, import_mesh, write_mesh
from palpate_editor.check import describe_model
from palpate_editor.edits.fix import find_lowest

CONSTANTS = Path(__file__).with_name("demo.toml")
KINDS = {"mss": "mass_spring", "mms": "molecular"}
SOURCE_VERTICES = 2400
"""Of the generated organ, so that there is something to decimate."""


def read_constants(path: Path) -> dict[str, dict[str, float]]:
    """The tables of a constants file. Raises Refusal or OSError."""
    try:
        tables = tomllib.loads(path.read_text())
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as problem:
        raise Refusal(path, "", str(problem), "TOML like the demo.toml that is installed") from None
    wanted = tomllib.loads(CONSTANTS.read_text())
    for table, values in wanted.items():
        found = tables.get(table)
        if not isinstance(found, dict) or set(found) != set(values):
            raise Refusal(
                path,
                f"[{table}]",
                "no such table" if found is None else ", ".join(sorted(found)),
                ", ".join(sorted(values)),
            )
    return tables


def describe_scene(
    organ: Path, name: str, kind: str, mesh: palpate.SurfaceMesh, constants: dict[str, Any]
) -> SceneFile:
    """The demo's scene of one kind of tissue on a mesh that lies beside the scene file."""
    closed = palpate.is_closed(np.asarray(mesh.triangles))
    material = MaterialPart(**constants["material"])
    if closed:
        material = replace(material, wall_thickness=None)
    surroundings = constants["surroundings"]
    return SceneFile(
        organ=OrganPart(name, organ.name, hash_file(organ)),
        material=material,
        model=ModelPart(
            kind=KINDS[kind],
            drag=surroundings["drag"],
            fixed=tuple(
                find_lowest(np.asarray(mesh.vertices), surroundings["fix_lowest"]).tolist()
            ),
            **constants[kind],
        ),
        tool=ToolPart(**constants["tool"]),
        hand=HandPart(**constants["hand"]),
    )


def generate_source(folder: Path) -> Path:
    """An organ of our own, written as a file so that it comes in by the same door as any other."""
    from palpate_meshes.generate import ellipsoid

    path = folder / "spleen_source.obj"
    write_mesh(path, palpate.SurfaceMesh(*ellipsoid(vertices=SOURCE_VERTICES)))
    return path


def run_demo(
    out: Path,
    mesh: Path | None = None,
    vertices: int = 600,
    constants: Path = CONSTANTS,
    parts: tuple[str, ...] = (),
    unit: str | None = None,
    up: str | None = None,
    say: Callable[[str], None] = lambda line: None,
) -> Report:
    """Runs the whole main job into the folder `out` and returns its summary.

    Raises FileError or Refusal where the mesh or the constants are refused, RuntimeError where the
    simulation failed.
    """
    values = read_constants(constants)
    out.mkdir(parents=True, exist_ok=True)
    if mesh is None:
        source, unit = generate_source(out), "m"
    else:
        source = mesh
    say(f"import    {source.name}")
    imported = import_mesh(source, parts=parts, unit=unit, up=up)
    loops = imported.report.border_loops
    border = f", {len(loops)} hole(s) kept open" if loops else ", closed"
    say(
        f"          {imported.report.vertices} vertices, {imported.report.triangles} triangles"
        f"{border}; unit {imported.joined.unit}: {imported.joined.unit_reason}"
    )
    small = decimate(imported.mesh, vertices)
    organ = out / "organ.obj"
    write_mesh(organ, small.mesh)
    say(
        f"decimate  {vertices} vertices, {len(small.mesh.triangles)} triangles, smallest angle "
        f"{small.smallest_angle_deg:.0f} degrees, {1e3 * small.max_distance:.2f} mm at most from "
        "the source"
    )

    name = mesh.stem if mesh else "spleen"
    summary: Report = {
        "organ": name,
        "vertices": len(small.mesh.vertices),
        "triangles": len(small.mesh.triangles),
        "border_loops": [
            len(loop) for loop in palpate.find_border_loops(np.asarray(small.mesh.triangles))
        ],
        "picture": "picture.png",
        "force_plot": "force_plot.png",
        "mesh": organ.name,
    }
    runs: dict[str, Run] = {}
    for kind in KINDS:
        scene_path = out / f"{kind}.scene.json"
        write_scene_file(scene_path, describe_scene(organ, name, kind, small.mesh, values))
        runs[kind], summary[kind] = touch(kind, scene_path, PressScript(**values["script"]), say)

    title = (
        f"{name}, {summary['vertices']} vertices: pressed {1e3 * values['script']['depth']:g} mm"
    )
    picture_of_record(out / "picture.png", out / "mss.prec", runs["mss"].moments.held, {}, title)
    plot_runs(out / "force_plot.png", {"mass-spring": runs["mss"], "molecular": runs["mms"]}, name)
    write_whole(
        out / "summary.json", (json.dumps(summary, indent=2, allow_nan=False) + "\n").encode()
    )
    say(f"wrote     {out / 'summary.json'}, {out / 'picture.png'}, {out / 'force_plot.png'}")
    return summary


def touch(
    kind: str, scene_path: Path, script: PressScript, say: Callable[[str], None]
) -> tuple[Run, Report]:
    """Presses and pulls one tissue through the live loop, then replays it in a new process."""
    _, scene = open_scene(scene_path)
    say(f"{kind}       {describe_model(scene)}")
    record = scene_path.with_name(f"{kind}.prec")
    run = run_script(scene, find_top(scene), script, record, scene_path)
    replay = replay_elsewhere(record)
    write_whole(
        scene_path.with_name(f"{kind}.replay.json"), (json.dumps(replay, indent=2) + "\n").encode()
    )
    report = {
        **run.report,
        "total_mass_g": 1e3 * palpate.compute_total_mass(scene.tissue),
        "scene": scene_path.name,
        "record": record.name,
        "replay": f"{kind}.replay.json",
        "replay_equal": replay["equal"],
    }
    pull = report["pull_force_N"] or 0.0
    stiffness = report["patch_stiffness_N_per_m"] or 0.0
    say(
        f"          peak {report['peak_force_N']:.2f} N, pull {pull:.2f} N, "
        f"patch {stiffness:.0f} N/m; tick {report['tick_median_us']:.0f} us, "
        f"lateness p99 {report['lateness_p99_us']:.0f} us, {report['missed_ticks']} missed; "
        f"replay {'equal' if replay['equal'] else 'DIFFERS'}"
    )
    return run, report


def replay_elsewhere(record: Path) -> Report:
    """The verb `replay` in a new process, which shares nothing with the run but the files."""
    done = subprocess.run(
        [sys.executable, "-m", "palpate.cli", "replay", str(record), "--json"],
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode not in (0, 1) or not done.stdout:
        raise RuntimeError(f"the replay of {record.name} failed: {done.stderr.strip()}")
    report = json.loads(done.stdout)
    if "error" in report:
        raise Refusal(**report["error"])
    report["record"], report["scene"] = Path(report["record"]).name, Path(report["scene"]).name
    return report
