# SPDX-License-Identifier: GPL-3.0-or-later
"""The main job from end to end: mesh file, two tissues, touch, replay, pictures, publish, play."""

from __future__ import annotations

import json
import os
import subprocess
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import palpate
from palpate.command.verb import Report
from palpate.files.read_file import read_file
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole
from palpate.runs.pictures import picture_of_record, plot_runs
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.run import Run, run_script
from palpate.runs.script_file import write_script_file
from palpate.scene.scene_file import open_scene
from palpate.scene.scene_parts import MaterialPart, ModelPart
from palpate.system.isolated import build_verb

from palpate_editor.authoring import write_mesh
from palpate_editor.check import describe_model, measure_surface
from palpate_editor.compile import compile_organ, mesh_of
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.constants import SHORT_KINDS
from palpate_editor.document.defaults import CONSTANTS, TABLES
from palpate_editor.document.files import write_organ
from palpate_editor.edits import (
    Edit,
    EditError,
    FixLowest,
    SetConstant,
    SetMaterial,
    SetName,
    SetTask,
    decimate_organ,
    import_file,
)
from palpate_editor.edits.import_mesh import make_writable
from palpate_editor.publish import publish
from palpate_editor.scene_files import write_scene
from palpate_editor.shipped import find_mesh

TOUCHED = ("mss", "mms")
"""The tissues that are pressed and compared."""
SHIPPED = "spleen"
"""The organ of ours that is used where no mesh is given."""
PUBLISHED = "mss"
"""The tissue that is published: the one that fits a millisecond with the most vertices."""
TASK = "Press the organ with the tip and feel how it gives way. Take hold of it and pull gently."
Say = Callable[[str], None]


def read_constants(path: Path) -> dict[str, dict[str, float]]:
    """The tables of a constants file. Raises Refusal or OSError."""
    try:
        tables = tomllib.loads(read_file(path).decode("utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as problem:
        raise Refusal(path, "", str(problem), "TOML like the demo.toml that is installed") from None
    for table, values in TABLES.items():
        found = tables.get(table)
        if not isinstance(found, dict) or set(found) != set(values):
            raise Refusal(
                path,
                f"[{table}]",
                "no such table" if found is None else ", ".join(sorted(found)),
                ", ".join(sorted(values)),
            )
        for name, value in found.items():
            if isinstance(value, bool) or not isinstance(value, int | float):
                raise Refusal(path, f"[{table}] {name}", repr(value), "a number")
    return tables


def run_demo(
    out: Path,
    mesh: Path | None = None,
    vertices: int = 600,
    constants: Path = CONSTANTS,
    parts: tuple[str, ...] = (),
    unit: str | None = None,
    up: str | None = None,
    say: Say = lambda line: None,
) -> Report:
    """Runs the whole main job into the folder `out` and returns its summary.

    Raises FileError or Refusal where the mesh or the constants are refused, PublishError where the
    organ is not fit for a trainee, RuntimeError where the simulation failed.
    """
    values = read_constants(constants)
    out.mkdir(parents=True, exist_ok=True)
    source = mesh or find_mesh(SHIPPED)
    organ = make_organ(source, vertices, parts, unit, up, say)
    organ = SetName(make_writable(source.stem))(organ)
    assert organ.surface is not None
    write_mesh(out / "organ.obj", mesh_of(organ.surface))
    summary = begin_summary(organ)
    script = PressScript(**values["script"])
    runs: dict[str, Run] = {}
    for kind in TOUCHED:
        scene_path = out / f"{kind}.scene.json"
        write_scene(scene_path, dress(organ, kind, values), out / "organ.obj")
        runs[kind], summary[kind] = touch(kind, scene_path, script, say)
    draw(out, summary, runs, script)
    summary |= hand_over(out, dress(organ, PUBLISHED, values), script, say)
    write_whole(out / "summary.json", print_json(summary))
    say(f"wrote     {out / 'summary.json'}, {out / 'picture.png'}, {out / 'force_plot.png'}")
    return summary


def begin_summary(organ: Organ) -> Report:
    assert organ.surface is not None
    return {
        "organ": organ.name,
        "vertices": organ.vertex_count,
        "triangles": len(organ.surface.triangles),
        "border_loops": list(measure_surface(organ.surface)[1].border_loops),
        "picture": "picture.png",
        "force_plot": "force_plot.png",
        "mesh": "organ.obj",
    }


def make_organ(
    source: Path, vertices: int, parts: tuple[str, ...], unit: str | None, up: str | None, say: Say
) -> Organ:
    """A mesh file as an organ of exactly so many vertices."""
    say(f"import    {source.name}")
    organ = import_file(source, parts=parts, unit=unit, up=up)(EMPTY)
    assert organ.imported is not None and organ.source is not None
    loops = measure_surface(organ.imported)[1].border_loops
    border = f", {len(loops)} hole(s) kept open" if loops else ", closed"
    say(
        f"          {len(organ.imported.vertices)} vertices, {len(organ.imported.triangles)} "
        f"triangles{border}; unit {organ.source.unit}: {organ.source.unit_reason}"
    )
    if vertices == len(organ.imported.vertices):
        say(f"decimate  not needed: {vertices} vertices are what it has")
        return organ
    try:
        edit = decimate_organ(organ, vertices)
    except EditError as refused:
        expected = f"a number that can be had ({refused})"
        raise Refusal(source, "--vertices", str(vertices), expected) from None
    made = edit.decimation
    say(
        f"decimate  {made.vertices} vertices, {made.triangles} triangles, smallest angle "
        f"{made.smallest_angle_deg:.0f} degrees, {1e3 * made.max_distance:.2f} mm at most from "
        "the source"
    )
    return edit(organ)


def dress(organ: Organ, kind: str, constants: dict[str, Any]) -> Organ:
    """The organ with the tissue, tool and hand of a constants file, resting on a table. Raises
    Refusal for a number that is out of its range."""
    try:
        for edit in list_edits(organ, kind, constants):
            organ = edit(organ)
    except EditError as refused:
        raise Refusal(None, "--constants", str(refused), "numbers that an organ can have") from None
    return organ


def list_edits(organ: Organ, kind: str, constants: dict[str, Any]) -> Iterator[Edit]:
    assert organ.surface is not None
    material = MaterialPart(**constants["material"])
    if palpate.is_closed(organ.surface.triangles):
        material = replace(material, wall_thickness=None)
    surroundings = constants["surroundings"]
    model = ModelPart(kind=SHORT_KINDS[kind], drag=surroundings["drag"], **constants[kind])
    yield SetMaterial(material, model)
    for part in ("tool", "hand"):
        for field, value in constants[part].items():
            yield SetConstant(part, field, value)
    yield FixLowest(surroundings["fix_lowest"])


def draw(out: Path, summary: Report, runs: dict[str, Run], script: PressScript) -> None:
    """The picture of the press at its deepest, and the plot of both tissues' forces."""
    name = summary["organ"]
    title = f"{name}, {summary['vertices']} vertices: pressed {1e3 * script.depth:g} mm"
    record = out / summary["mss"]["record"]
    picture_of_record(out / summary["picture"], record, runs["mss"].times.held, {}, title)
    plotted = {"mass-spring": runs["mss"], "molecular": runs["mms"]}
    plot_runs(out / summary["force_plot"], plotted, name)


def hand_over(out: Path, organ: Organ, script: PressScript, say: Say) -> Report:
    """Publishes the organ and plays the file as a trainee's program does, in a new process."""
    organ = SetTask(f"{organ.name}: press and pull", TASK)(organ)
    working, published = out / f"{organ.name}.organ", out / f"{organ.name}.palpate"
    write_organ(working, organ)
    report = publish(organ, published)
    say(f"publish   {published.name}: {report['bytes'] / 1e3:.0f} kB, {organ.title}")

    scene = compile_organ(organ)
    hand = out / "press.script.json"
    write_script_file(
        hand, write_script(find_top(scene), scene.instruments[0].tool.radius, script)[0]
    )
    record = out / "play.prec"
    played = run_elsewhere(
        "play", published, "--headless", "--device", f"script:{hand}", "--record", record
    )
    replay = replay_elsewhere(record)
    write_whole(out / "play.replay.json", print_json(replay))
    say(
        f"play      peak {played['peak_force_N']:.2f} N, {played['missed_ticks']} ticks missed; "
        f"replay {'equal' if replay['equal'] else 'DIFFERS'}"
    )
    return {
        "working": working.name,
        "published": published.name,
        "published_sha256": report["sha256"],
        "play": {
            "script": hand.name,
            "record": record.name,
            "replay": "play.replay.json",
            "ticks": played["ticks"],
            "missed_ticks": played["missed_ticks"],
            "peak_force_N": played["peak_force_N"],
            "replay_equal": replay["equal"],
        },
    }


def touch(
    kind: str, scene_path: Path, script: PressScript, say: Callable[[str], None]
) -> tuple[Run, Report]:
    """Presses and pulls one tissue through the live loop, then replays it in a new process."""
    _, scene = open_scene(scene_path)
    say(f"{kind}       {describe_model(scene)}")
    record = scene_path.with_name(f"{kind}.prec")
    run = run_script(scene, find_top(scene), script, record, scene_path)
    replay = replay_elsewhere(record)
    write_whole(scene_path.with_name(f"{kind}.replay.json"), print_json(replay))
    report = {
        **run.report,
        "total_mass_g": 1e3 * palpate.compute_total_mass(scene.bodies[0].tissue),
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


def run_elsewhere(verb: str, *arguments: object) -> Report:
    """A verb in a new process, which shares nothing with this one but the files."""
    words = build_verb(verb, *arguments, "--json")
    done = subprocess.run(words, capture_output=True, encoding="utf-8", check=False)
    if done.returncode not in (0, 1) or not done.stdout:
        raise RuntimeError(f"`palpate {verb} {arguments[0]}` failed: {done.stderr.strip()}")
    report = json.loads(done.stdout)
    if "error" in report:
        raise Refusal(**report["error"])
    return report


def replay_elsewhere(record: Path) -> Report:
    report = run_elsewhere("replay", record)
    report["record"], report["scene"] = Path(report["record"]).name, Path(report["scene"]).name
    return report


def print_json(report: Report) -> bytes:
    return (json.dumps(report, indent=2, allow_nan=False) + "\n").encode()


def can_show_windows() -> bool:
    """Whether there is a display here."""
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def open_editor(file: Path) -> None:
    """Opens the editor on a file, and does not wait for it."""
    subprocess.Popen(
        build_verb("editor", file),
        stdin=subprocess.DEVNULL,
        start_new_session=True,
    )
